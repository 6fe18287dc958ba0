"""Hankel singular values against a published example, Lyapunov equations and known bounds."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_lyapunov

import eom
from eom.analysis import frequency_response, hankel_values
from tests.analysis.random_models import model_of, part, settled, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import vehicle

Array = np.ndarray
RANDOM = settings(max_examples=40, deadline=None, phases=PHASES)


def products(A: Array, B: Array, C: Array) -> Array:
    """Square roots of the eigenvalues of the Gramians' product."""
    reached = solve_continuous_lyapunov(A, -B @ B.T)
    seen = solve_continuous_lyapunov(A.T, -C.T @ C)
    return np.asarray(np.sqrt(np.maximum(np.sort(np.linalg.eigvals(reached @ seen).real)[::-1], 0.0)))


def test_the_example_of_moore() -> None:
    """B. C. Moore, Principal component analysis in linear systems, IEEE Trans. Automatic Control 26 (1981)."""
    A = np.diag([1.0, 1.0, 1.0], -1)
    A[:, 3] = [-150.0, -245.0, -113.0, -19.0]
    model = model_of(A, np.array([[4.0], [1.0], [0.0], [0.0]]), np.array([[0.0, 0.0, 0.0, 1.0]]))
    found = hankel_values(model, ["u0"], ["y0"]).values
    # printed to three or four digits
    assert found == pytest.approx([0.1594e-1, 0.2724e-2, 0.1272e-3, 0.8006e-5], rel=1e-3)


@RANDOM
@given(stable_models())
def test_values_are_those_of_the_gramians_product(model: eom.LinearModel) -> None:
    found = hankel_values(model, model.inputs, model.outputs).values
    # the product squares them: below 1e-8 of the largest one it shows rounding alone
    assert found == pytest.approx(products(model.A, model.B, model.C), rel=1e-6, abs=1e-6 * found[0])


@RANDOM
@given(stable_models(), stable_models(), st.integers(0, 2**32 - 1))
def test_what_does_not_decay_is_left_out_by_name_and_changes_nothing(
    stable: eom.LinearModel, other: eom.LinearModel, seed: int
) -> None:
    """A sum of a stable and an unstable system in mixed coordinates, behind a drift of both."""
    rng = np.random.default_rng(seed)
    m, k = min(stable.B.shape[1], other.B.shape[1]), min(len(stable.C), len(other.C))
    n = len(stable.A) + len(other.A)
    A = np.zeros((n, n))
    A[: len(stable.A), : len(stable.A)], A[len(stable.A) :, len(stable.A) :] = stable.A, -other.A
    T = np.linalg.qr(rng.normal(size=(n, n)))[0]
    B, C = np.vstack([stable.B[:, :m], other.B[:, :m]]), np.hstack([stable.C[:k], other.C[:k]])
    # a cyclic state that integrates the stable part, and that every output sees
    drive = T @ np.concatenate([stable.A[0], np.zeros(len(other.A))])
    A = np.block([[np.zeros((1, 1)), drive[np.newaxis]], [np.zeros((n, 1)), T @ A @ T.T]])
    B, C = np.vstack([stable.B[:1, :m], T @ B]), np.hstack([np.ones((k, 1)), C @ T.T])
    found = hankel_values(model_of(A, B, C, cyclic=(0,)), [f"u{j}" for j in range(m)], [f"y{j}" for j in range(k)])
    # the cyclic state is the integral of dx_0/dt: it adds x_0 itself to every output
    seen = stable.C[:k].copy()
    seen[:, 0] += 1.0
    expected = products(stable.A, stable.B[:, :m], seen)
    assert found.values == pytest.approx(expected, rel=1e-5, abs=1e-5 * expected[0])
    assert len(found.left_out) == 1 + len(other.A) == len(found.left_out_states)
    assert found.left_out_states[0] == "x0"


@RANDOM
@given(st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_coordinates_of_the_state_do_not_matter(n: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    A, B, C = settled(rng, n), rng.normal(size=(n, 2)), rng.normal(size=(2, n))
    T = np.linalg.qr(rng.normal(size=(n, n)))[0] * rng.uniform(0.3, 3.0, n)
    one = hankel_values(model_of(A, B, C), ["u0", "u1"], ["y0", "y1"]).values
    two = hankel_values(model_of(np.linalg.solve(T, A @ T), np.linalg.solve(T, B), C @ T), ["u0", "u1"], ["y0", "y1"])
    assert two.values == pytest.approx(one, rel=1e-7, abs=1e-8 * one[0])


@pytest.mark.parametrize(
    ("name", "source", "output"),
    [
        ("b_train_yaw_roll", "axle_1.steer", "semitrailer_2.articulation"),
        ("quarter_car", "road", "suspension_travel"),
        ("articulated_bus", "axle_1.steer", "rear.yaw_rate"),
    ],
)
def test_the_peak_of_the_response_lies_between_glovers_bounds(name: str, source: str, output: str) -> None:
    """The largest value is at most the peak of the frequency response, which is at most twice the sum."""
    model = eom.linearise(vehicle(name))
    values = hankel_values(model, [source], [output]).values
    D = part(model, source, output)[3]
    peak = frequency_response(model, source, [output]).peaks()[0].value
    through = abs(D[0, 0])
    assert values[0] * (1.0 - 1e-9) <= peak + through
    assert peak <= through + 2.0 * np.sum(values) * (1.0 + 1e-9)


def test_unknown_names_get_their_sentences() -> None:
    with pytest.raises(eom.AnalysisError) as error:
        hankel_values(eom.linearise(vehicle("quarter_car")), ["rod"], ["travel"])
    assert str(error.value).splitlines()[0] == "input rod: there is no such input; did you mean 'road'?"
    assert len(str(error.value).splitlines()) == 2


@pytest.mark.parametrize("EI_z", [1.7e3, 2.3e4, 9.1e5])
def test_an_undamped_structure_has_no_stable_part_whatever_rounding_says(EI_z: float) -> None:
    beam = eom.linearise(vehicle("cantilever", EI_z=EI_z))
    found = hankel_values(beam, beam.inputs, beam.outputs)
    assert len(found.values) == 0
    assert len(found.left_out) == len(beam.A)
