"""Branches of a root locus against systems whose branches are known by construction."""

from collections.abc import Callable, Sequence

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.analysis.family import nodes_at
from eom.analysis.locus import RootLocus, locus_of, root_locus
from tests.analysis.families import Array, hidden, model_of, oscillator
from tests.vehicles.shipped import vehicle


def locus(family: Callable[[float], eom.LinearModel], values: Sequence[float]) -> RootLocus:
    return locus_of(family, nodes_at(family, values))


def upper(item: RootLocus) -> Array:
    """Branches that start in the upper half plane."""
    result: Array = item.branches[:, item.branches[0].imag > 0.0]
    return result


def turned(size: int, seed: int) -> Array:
    """A regular matrix with a condition number of at most about 10."""
    rng = np.random.default_rng(seed)
    left, right = (np.linalg.qr(rng.normal(size=(size, size)))[0] for _ in range(2))
    result: Array = left @ np.diag(rng.uniform(0.3, 3.0, size)) @ right
    return result


@pytest.mark.parametrize("steps", [3, 4, 8, 40])
def test_oscillators_that_know_nothing_of_each_other_cross_without_changing_branches(steps: int) -> None:
    """The curves bend, so that neither roots nor rates tell them apart over a long step."""

    def sizes(p: Array) -> list[Array]:
        return [1.0 + p**2, 3.2 - p, 2.0 + np.sin(3.0 * p)]

    family = hidden(lambda p: [oscillator(float(size), 0.1) for size in sizes(np.array(p))], turned(6, 1))
    values = np.linspace(0.0, 2.0, steps)
    found = upper(locus(family, values.tolist()))
    shape = complex(-0.1, np.sqrt(1.0 - 0.1**2))
    order = np.argsort(np.abs(found[0]))
    expected = np.column_stack(sizes(values))[:, np.argsort([1.0, 3.2, 2.0])] * shape
    # eigenvalues of a matrix in coordinates of condition 10
    np.testing.assert_allclose(found[:, order], expected, rtol=1e-11)


@pytest.mark.parametrize("seed", [0, 1, 13, 71])
def test_a_value_at_which_both_frequencies_are_equal_swaps_nothing(seed: int) -> None:
    """There every mixture of both is an eigenvector."""
    family = hidden(lambda p: [oscillator(1.0 + p, 0.1), oscillator(2.0 - p, 0.1)], turned(4, seed))
    values = np.array([0.0, 0.25, 0.5, 0.75, 1.0])
    found = upper(locus(family, values.tolist()))
    # two equal roots with their own eigenvectors feel rounding as any others do
    np.testing.assert_allclose(np.abs(found), np.column_stack([1.0 + values, 2.0 - values]), rtol=1e-12)


def test_a_pair_that_becomes_real_and_a_pair_again_keeps_its_branches() -> None:
    """The upper root of the pair is the larger real one, by convention."""

    def family(p: float) -> eom.LinearModel:
        return model_of(np.array([[0.0, 1.0], [-1.0, -2.0 * (1.5 - p**2)]]))

    values = np.linspace(-1.4, 1.4, 29)
    c = 1.5 - values**2
    root = np.emath.sqrt(c**2 - 1.0)
    expected = np.column_stack([-c + root, -c - root])
    found = locus(family, values.tolist()).branches
    # roots near a meeting feel rounding by its square root, which 1e-9 leaves room for at the values here
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-9)


def test_two_pairs_that_meet_and_part_are_a_continuous_set() -> None:
    """Ziegler's column flutters: branches beyond are a convention, but none jumps."""
    found = root_locus(vehicle("ziegler_column"), "P", np.linspace(150.0, 260.0, 111).tolist())
    jumps = np.max(np.abs(np.diff(found.branches, axis=0)))
    # near the meeting roots move by the square root of the step: sqrt(sqrt(2) 1 N/100 N) in units of 10 1/s, halved
    assert jumps < 10.0 * np.sqrt(np.sqrt(2.0) * 0.01)


BLOCK = st.tuples(st.floats(0.5, 5.0), st.floats(0.5, 5.0), st.floats(0.02, 0.9), st.floats(0.02, 0.9), st.booleans())


def blocks_at(specifications: Sequence[tuple[float, float, float, float, bool]], p: float) -> list[Array]:
    """Oscillators and single real roots whose sizes move from one value to another and half the way back."""
    result = []
    for start, end, first, last, real in specifications:
        size, damping = start + (end - start) * np.sin(2.0 * p), first + (last - first) * p
        result.append(np.array([[-size]]) if real else oscillator(size, damping))
    return result


@settings(max_examples=60, deadline=None)
@given(st.lists(BLOCK, min_size=1, max_size=4), st.integers(0, 10_000), st.integers(2, 12))
def test_blocks_hidden_by_a_similarity_transform_keep_their_branches(
    specifications: list[tuple[float, float, float, float, bool]], seed: int, steps: int
) -> None:
    """Whatever crosses: each block's roots stay the same column."""
    size = sum(len(block) for block in blocks_at(specifications, 0.0))
    family = hidden(lambda p: blocks_at(specifications, p), turned(size, seed))
    values = np.linspace(0.0, 1.0, steps)
    found = locus(family, values.tolist()).branches
    expected = np.array(
        [np.concatenate([np.linalg.eigvals(block) for block in blocks_at(specifications, p)]) for p in values]
    )
    expected = ordered_in_blocks(expected, specifications)
    # pairwise: every branch is one of the expected curves over its whole length, and no curve is missing. Equal or
    # nearly equal roots of two blocks are all that rounding can move, by its square root
    distance = np.max(np.abs(found[:, :, np.newaxis] - expected[:, np.newaxis, :]), axis=0)
    assert np.max(np.min(distance, axis=0)) < 1e-6
    assert np.max(np.min(distance, axis=1)) < 1e-6


def ordered_in_blocks(roots: Array, specifications: Sequence[tuple[float, float, float, float, bool]]) -> Array:
    """The upper root of each oscillator first, at every value."""
    result, at = roots.copy(), 0
    for *_, real in specifications:
        if not real:
            pair = roots[:, at : at + 2]
            order = np.argsort(-pair.imag, axis=1)
            result[:, at : at + 2] = np.take_along_axis(pair, order, axis=1)
        at += 1 if real else 2
    return result


@pytest.mark.parametrize(("name", "low", "high"), [("b_train_yaw_roll", 5.0, 40.0), ("motorcycle", 2.0, 60.0)])
def test_the_roots_at_each_value_are_those_of_python_control(name: str, low: float, high: float) -> None:
    values = np.linspace(low, high, 7)
    found = root_locus(vehicle(name), "U", values.tolist())
    for value, roots, node in zip(values, found.branches, found.nodes, strict=True):
        poles = control.poles(eom.linearise(vehicle(name, U=float(value))).to_control())
        cyclic = len(node.model.cyclic)
        np.testing.assert_array_equal(roots[:cyclic], 0.0)
        moving = np.sort_complex(poles[np.argsort(np.abs(poles))[cyclic:]])
        own = np.sort_complex(roots[cyclic:])
        # the double zeros of free motions are good to the square root of rounding
        np.testing.assert_allclose(np.sort(np.abs(own)), np.sort(np.abs(moving)), rtol=1e-8, atol=1e-6)


def test_a_finer_sweep_passes_through_the_same_branches() -> None:
    coarse = root_locus(vehicle("b_train_yaw_roll"), "U", np.linspace(20.0, 150.0, 14).tolist(), "km/h")
    fine = root_locus(vehicle("b_train_yaw_roll"), "U", np.linspace(20.0, 150.0, 53).tolist(), "km/h")
    assert coarse.unclear == fine.unclear == ()
    # the same matrices at the same values
    np.testing.assert_allclose(fine.branches[::4], coarse.branches, rtol=0.0, atol=1e-9)


def test_falling_values_give_the_branches_of_rising_ones() -> None:
    rising = root_locus(vehicle("bicycle"), "U", np.linspace(1.0, 8.0, 15).tolist())
    falling = root_locus(vehicle("bicycle"), "U", np.linspace(8.0, 1.0, 15).tolist())
    reverse = falling.branches[::-1]
    for column in rising.branches.T:
        # 1e-7: two of the roots are zeros but for the square root of rounding
        assert np.min(np.max(np.abs(reverse - column[:, np.newaxis]), axis=0)) < 1e-7


def test_a_change_of_the_number_of_states_is_refused_with_a_sentence() -> None:
    def family(p: float) -> eom.LinearModel:
        return model_of(-np.eye(2 if p < 0.5 else 3))

    with pytest.raises(eom.AnalysisError, match="has 2 states at 0 and 3 at 1"):
        locus(family, [0.0, 1.0])


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ([], "expected finite values, at least one"),
        ([1.0, np.nan], "expected finite values"),
        ([1.0, 1.0], "rise, or fall"),
        ([1.0, 3.0, 2.0], "rise, or fall"),
    ],
)
def test_values_that_go_no_way_are_refused(values: list[float], sentence: str) -> None:
    with pytest.raises(eom.AnalysisError, match=sentence):
        root_locus(vehicle("bicycle"), "U", values)


def test_a_sweep_from_rest_passes_a_change_of_the_cyclic_states() -> None:
    """At rest the wheels of the bicycle have other cyclic motions than on the way; all roots are still followed."""
    values = np.linspace(0.0, 3.0, 13)
    found = root_locus(vehicle("bicycle"), "U", values.tolist())
    for node, roots in zip(found.nodes, found.branches, strict=True):
        np.testing.assert_array_equal(np.sort_complex(roots), np.sort_complex(node.modes.eigenvalues))
    # the four roots of the benchmark at rest: two pairs of equal size, published to these digits
    still = np.sort(found.branches[0].real)
    np.testing.assert_allclose(
        still[[0, 1, -2, -1]], [-5.53094371765393, -3.13164324790656, 3.13164324790656, 5.53094371765393], atol=1e-11
    )


def test_a_picture_of_a_locus_has_a_line_for_each_root_that_is_not_cyclic() -> None:
    found = root_locus(vehicle("car_trailer"), "U", [20.0, 25.0, 30.0])
    plane = found.plot().axes[0]
    lines = [line for line in plane.lines if np.shape(line.get_xdata()) == (3,)]
    assert len(lines) == found.branches.shape[1] - 2
