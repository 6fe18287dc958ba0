"""Tangency: the slopes of the nonlinear equations at the trim are the linear model that the kernel's matrices give.

Both are exact derivatives, so what separates them is rounding: of matrices of some tens of states whose entries span
stiffnesses of 1e6 and rates of 1. Seen are 5e-13 of the largest entry of a row; 1e-9 is asked.
"""

import numpy as np
import pytest

import eom
from eom.model.tyre import TyreModel, build_tyre_model, tyre_slopes
from eom.splice.closure import Closed, close
from tests.splice.shared import SIMPLE, STEP, Array, model, places
from tests.vehicles.shipped import NAMES, WHEELED, vehicle

SPEEDS = (5, 60, 88, 110, 120)
RELATIVE = 1e-9


def same_slopes(found: TyreModel, speed: float, closed: Closed) -> None:
    """Slopes of a model in its straight run at a speed [m/s] are those of a closure for that speed."""
    own = np.hstack(tyre_slopes(found, *found.trim(speed)))
    expected = np.hstack((closed.A, closed.B))
    rows = np.max(np.abs(expected), axis=1, keepdims=True)
    scale = np.maximum(rows, RELATIVE * np.max(rows))
    assert own.shape == expected.shape
    np.testing.assert_array_less(np.abs(own - expected) / scale, RELATIVE)


def test_every_shipped_vehicle_with_axles_has_the_model() -> None:
    with_axles = [name for name in NAMES if vehicle(name).system.wheels]
    assert with_axles == sorted(SIMPLE + WHEELED)


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("name", SIMPLE + WHEELED)
def test_slopes_at_the_trim_are_the_closed_linear_model(name: str, speed: int) -> None:
    own = build_tyre_model(vehicle(name, U=f"{speed} km/h"))
    closed = close(own.prepared)
    same_slopes(own, speed / 3.6, closed)
    if name != "car":
        # no air resistance presses on springs: one build serves every speed
        same_slopes(model(name), speed / 3.6, closed)


@pytest.mark.parametrize("speed", [1, 2, 3])
@pytest.mark.parametrize("name", [name for name in SIMPLE + WHEELED if name != "car"])
def test_slopes_are_the_closed_linear_model_where_slips_are_bent(name: str, speed: int) -> None:
    """Below 3.6 km/h. Rolling resistance fades there, so that another trim's tyres are fitted at other loads."""
    own = build_tyre_model(vehicle(name, U=f"{speed} km/h"))
    same_slopes(own, speed / 3.6, close(own.prepared))


@pytest.mark.parametrize("name", SIMPLE + WHEELED)
def test_a_straight_run_at_another_speed_moves_springs_only_under_drag(name: str) -> None:
    """Rates that vanish to 1e-12 of gravity leave displacements of that size times m/k; drag of a car moves it 1e-4."""
    q = model(name).trim(80.0 / 3.6).x[places(model(name))["q"]]
    assert (np.max(np.abs(q)) > 1e-6) == (name == "car")


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("name", SIMPLE)
def test_linear_tyres_give_the_model_of_the_linear_kernel(name: str, speed: int) -> None:
    """Eigenvalues but those of place, heading and the held speed, and every response that both models have."""
    plain = vehicle(name, U=f"{speed} km/h")
    found, linear = build_tyre_model(plain), eom.linearise(plain)
    x, u = found.trim()
    A, B = tyre_slopes(found, x, u)
    at = places(found)
    kept = np.delete(np.arange(len(A)), [*range(at["frame"].stop), at["n"].start])
    roots = np.linalg.eigvals(A[np.ix_(kept, kept)])
    expected = np.linalg.eigvals(linear.without_cyclic().A)
    far = np.abs(roots[:, np.newaxis] - expected)
    assert len(roots) == len(expected)
    # simple roots: rounding times their condition; seen are 1e-12 of the largest
    assert max(far.min(axis=0).max(), far.min(axis=1).max()) < RELATIVE * np.max(np.abs(expected))

    C, D = output_slopes(found, x, u)
    shared = [name for name in linear.outputs if name in found.outputs]
    assert len(shared) >= 8
    mine = [found.outputs.index(name) for name in shared]
    theirs = [linear.outputs.index(name) for name in shared]
    order = [found.inputs.index(name) for name in linear.inputs]
    for frequency in (0.1, 0.7, 3.0):
        s = 2j * np.pi * frequency
        response = (C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D)[np.ix_(mine, order)]
        wanted = linear.frequency_response(frequency)[0, theirs]
        scale = np.max(np.abs(wanted), axis=1, keepdims=True)
        # seen are 8e-11, of solves at 5 km/h, where roots of tyres are far
        assert np.max(np.abs(response - wanted) / scale) < RELATIVE


def output_slopes(found: TyreModel, x: Array, u: Array) -> tuple[Array, Array]:
    """Exact derivatives of the outputs by states and inputs, by complex steps."""
    both = np.concatenate((x, u)).astype(complex)
    n = len(x)
    columns = []
    for k in range(len(both)):
        moved = both + 1j * STEP * (np.arange(len(both)) == k)
        columns.append(found.output(0.0, moved[:n], moved[n:]).imag / STEP)
    result = np.array(columns).T
    return result[:, :n], result[:, n:]
