"""Compiled formulas against NumPy."""

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from eom.errors import TyreError
from eom.program.compiled import without_compiler
from eom.tyre import (
    Dugoff,
    Linear,
    MagicFormula,
    MagicFormula52,
    MagicFormula61,
    Tyre,
    compile_forces,
    stack,
)
from tests.tyre.random_sets import random_set_52, random_set_61

LOAD = 4000.0


def varied(make: Callable[..., Tyre], count: int, **numbers: float) -> list[Tyre]:
    """Tyres whose numbers differ by some percent."""
    rng = np.random.default_rng(5)
    return [make(**{name: value * rng.uniform(0.9, 1.1) for name, value in numbers.items()}) for _ in range(count)]


def magic(**numbers: Any) -> MagicFormula:
    return MagicFormula(nominal_load=LOAD, trail=0.04, rolling_resistance=0.01, radius=0.3, E_y=-0.7, **numbers)


def sets(count: int) -> dict[str, list[Tyre]]:
    """Tyres of every formula."""
    rows = {"mu_x": 1.0, "mu_y": 0.9, "k_x": 20.0, "k_y": 15.0, "k_gamma": 0.7}
    full: dict[str, Callable[[int], Tyre]] = {
        "tool": lambda seed: MagicFormula61(mirror=seed % 2 == 1, **random_set_61(seed)),  # type: ignore[arg-type]
        "book": lambda seed: MagicFormula61(form="book", **random_set_61(seed)),  # type: ignore[arg-type]
        "uncombined": lambda seed: MagicFormula61(use="uncombined", **random_set_61(seed)),  # type: ignore[arg-type]
        "5.2": lambda seed: MagicFormula52(**random_set_52(seed)),  # type: ignore[arg-type]
    }
    return {
        "linear": varied(Linear, count, nominal_load=LOAD, cornering=6e4, longitudinal=8e4, camber=2e3, trail=0.03),
        "dugoff": varied(Dugoff, count, nominal_load=LOAD, cornering=6e4, longitudinal=8e4, friction=0.9, trail=0.03),
        "ellipse": varied(magic, count, **rows),
        "cosine": varied(lambda **k: magic(combined="cosine", **k), count, **rows),
        **{name: [make(seed) for seed in range(count)] for name, make in full.items()},
    }


def states(count: int) -> tuple[np.ndarray, ...]:
    """Slips, loads, camber and speeds with lifted, overloaded, locked, reversed and standing wheels among them."""
    rng = np.random.default_rng(6)
    return (
        rng.uniform(-1.2, 1.2, count),
        rng.choice([-1.5, -1.0, 0.0, 0.7], count) + rng.uniform(-0.2, 0.2, count),
        rng.choice([-100.0, 0.0, 0.003 * LOAD, LOAD, 2.0 * LOAD], count) * rng.uniform(0.9, 1.1, count),
        rng.uniform(-0.2, 0.2, count),
        rng.choice([-20.0, 0.0, 0.5, 20.0], count) * rng.uniform(0.9, 1.1, count),
    )


@pytest.mark.parametrize("formula", sets(1))
def test_the_compiled_formula_gives_what_numpy_gives(formula: str) -> None:
    rounds = 40
    tyres = sets(18)[formula]
    joined = stack(tyres)
    compiled = compile_forces(joined)
    every = [values.reshape(rounds, 18) for values in states(18 * rounds)]
    for k in range(rounds):
        arguments = [values[k] for values in every]
        found, expected = compiled.forces(*arguments), joined.forces(*arguments)
        # of the load, and of load times 1 m: elementary functions differ by some units in the last place
        np.testing.assert_allclose(np.array(found), np.array([*expected]), rtol=0.0, atol=1e-12 * LOAD)


@pytest.mark.parametrize("count", [1, 7, 8, 32, 33, 70])
def test_the_result_does_not_depend_on_the_number_of_tyres_or_their_place(count: int) -> None:
    tyres = sets(count)["ellipse"]
    arguments = states(count)
    found = np.array(compile_forces(stack(tyres)).forces(*arguments))
    for k, tyre in enumerate(tyres):
        alone = np.array(compile_forces(tyre).forces(*(values[k] for values in arguments)))
        assert np.array_equal(found[:, k], alone[:, 0])


def test_stacked_tyres_give_the_forces_of_each() -> None:
    for name, tyres in sets(5).items():
        arguments = states(5)
        together = stack(tyres).forces(*arguments)
        for k, tyre in enumerate(tyres):
            one = tyre.forces(*(float(values[k]) for values in arguments))
            # array and scalar loops of NumPy may round differently
            assert [float(v[k]) for v in together] == pytest.approx(list(one), rel=1e-13, abs=1e-13 * LOAD), name  # type: ignore[index]


def test_a_stack_gives_one_number_for_each_tyre_also_of_plain_numbers() -> None:
    for name, tyres in sets(3).items():
        together = stack(tyres).forces(0.02, 0.0, LOAD)
        assert {np.shape(value) for value in together} == {(3,)}, name
        assert together.Fy == pytest.approx([float(one.forces(0.02, 0.0, LOAD).Fy) for one in tyres], rel=1e-12)
    with pytest.raises(TyreError, match=r"or not the number of tyres: alpha \(2,\)"):
        stack(sets(3)["tool"]).forces([0.0, 0.1], 0.0, LOAD)  # type: ignore[arg-type]


def test_tyres_that_do_not_fit_together_are_refused() -> None:
    one, other = sets(1)["linear"][0], sets(1)["dugoff"][0]
    with pytest.raises(TyreError, match="tyre 1 and tyre 2 are Linear and Dugoff: expected tyres of one model"):
        stack([one, other])
    first, second = sets(1)["ellipse"][0], sets(1)["cosine"][0]
    with pytest.raises(TyreError, match="have combined = 'ellipse' and 'cosine': expected one and the same"):
        stack([first, second])
    with pytest.raises(TyreError, match="expected at least one tyre"):
        stack([])
    compiled = compile_forces(stack([one, one]))
    with pytest.raises(TyreError, match="alpha: expected a real number or 2 of them"):
        compiled.forces(np.zeros(3), 0.0, LOAD, 0.0, 20.0)
    with pytest.raises(TyreError, match="kappa: expected a real number or 2 of them"):
        compiled.forces(0.0, 1j, LOAD)  # type: ignore[arg-type]


def test_what_is_no_finite_number_is_refused_before_it_is_compiled_away() -> None:
    compiled = compile_forces(sets(1)["ellipse"][0])
    for bad in (np.nan, np.inf):
        with pytest.raises(TyreError, match="Fz: expected finite numbers"):
            compiled.forces(0.02, 0.0, bad, 0.0, 20.0)
    found = compiled.ready.results(np.array([0.02, 0.0, np.nan, 0.0, 20.0]), np.empty(0), 0)
    # this formula has no Mx at all
    assert np.all(np.isnan(found[[0, 1, 3, 4]]))
    assert found[2] == 0.0


def test_tyres_of_both_sides_and_any_range_make_a_stack() -> None:
    left, right = (
        MagicFormula61(side=side, FZMAX=limit, **random_set_61(0))  # type: ignore[arg-type]
        for side, limit in (("left", 8e3), ("right", 9e3))
    )
    both = stack([left, dataclasses.replace(right, mirror=True)]).forces(0.02, 0.0, LOAD)
    assert both.Fy == pytest.approx([left.forces(0.02, 0.0, LOAD).Fy, -right.forces(-0.02, 0.0, LOAD).Fy], rel=1e-12)


def test_without_numba_the_extra_is_named() -> None:
    with without_compiler(), pytest.raises(TyreError, match=r"compiled tyres need numba: install eom-vehicle\[fast\]"):
        compile_forces(sets(1)["linear"][0])


def test_a_changed_coefficient_reaches_the_compiled_formula() -> None:
    tyre = sets(1)["tool"][0]
    softer = dataclasses.replace(tyre, PKY1=0.5 * tyre.PKY1)  # type: ignore[attr-defined, type-var]
    before, after = (
        float(np.max(np.abs(compile_forces(item).forces(0.02, 0.0, LOAD, 0.0, 20.0).Fy))) for item in (tyre, softer)
    )
    assert after < 0.8 * before
