"""Steady-state gains against python-control and exact limits of rational functions."""

import control
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.analysis import steady_gains, step_response
from tests.analysis.random_models import drifting_models, model_of, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import NAMES, WHEELED, text, vehicle

FREE_SPEED = [name for name in WHEELED if name != "car"]
"""Rolling resistance that is the same at any speed holds none: their gains are those of an integrator."""
SETTLED = [name for name in NAMES if name not in {"disc", "spinning_top", *FREE_SPEED}]


@pytest.mark.parametrize("name", SETTLED)
def test_steady_gains_of_shipped_vehicles_are_those_of_python_control(name: str) -> None:
    model = eom.linearise(vehicle(name))
    reduced = model.without_cyclic()
    expected = np.reshape(control.ss(reduced.A, reduced.B, reduced.C, reduced.D).dcgain(), reduced.D.shape)
    gains = steady_gains(model)
    found = np.array([[gains.of(output, source) for source in model.inputs] for output in reduced.outputs])
    # two factorisations of the same matrix: rounding, relative to the sum of all terms
    inverse = np.abs(np.linalg.inv(reduced.A))
    size = np.abs(reduced.D) + np.abs(reduced.C) @ inverse @ np.abs(reduced.B)
    # entries of A that symmetry makes zero are rounding of their rows' largest ones
    rows = np.broadcast_to(np.max(np.abs(reduced.A), axis=1, keepdims=True), reduced.A.shape)
    rounding = np.abs(reduced.C) @ inverse @ rows @ inverse @ np.abs(reduced.B)
    assert np.all(np.abs(found - expected) <= 1e-11 * size + 1e-16 * rounding)


@settings(max_examples=60, deadline=None, phases=PHASES)
@given(stable_models())
def test_a_step_settles_at_the_steady_gain(model: eom.LinearModel) -> None:
    gains = steady_gains(model)
    assert gains.stable
    for source in model.inputs:
        # roots decay as exp(-0.2 t) or faster: e^-100 is left
        late = step_response(model, source, [500.0]).outputs[0]
        assert late == pytest.approx(gains.values[:, model.inputs.index(source)], rel=1e-9, abs=1e-9)


small = st.integers(-3, 3)


def exact_gain(A: sympy.Matrix, B: sympy.Matrix, C: sympy.Matrix) -> sympy.Expr:
    """The limit of the rational transfer function at s = 0 from above."""
    s = sympy.Symbol("s", positive=True)
    transfer = sympy.cancel((C * (s * sympy.eye(A.rows) - A).inv() * B)[0])
    return sympy.limit(transfer, s, 0, "+")


@settings(max_examples=40, deadline=None, phases=PHASES)
@given(st.lists(small, min_size=8, max_size=8), st.lists(small, min_size=8, max_size=8), small)
def test_gains_through_integrators_are_the_limits_of_rational_functions(
    numbers: list[int], more: list[int], drift: int
) -> None:
    """Two cyclic states, the first drifting by the second, over two others; integers, so that zeros are exact."""
    inner = [[-3, numbers[0]], [0, -2]]
    A = [[0, drift, *numbers[1:3]], [0, 0, *numbers[3:5]], [0, 0, *inner[0]], [0, 0, *inner[1]]]
    B, C = [[value] for value in more[:4]], [more[4:]]
    expected = exact_gain(sympy.Matrix(A), sympy.Matrix(B), sympy.Matrix(C))
    found = steady_gains(model_of(np.array(A), np.array(B), np.array(C), cyclic=(0, 1))).values[0, 0]
    assert found == pytest.approx(float(expected), rel=1e-12, abs=1e-12)


@settings(max_examples=40, deadline=None, phases=PHASES)
@given(drifting_models())
def test_a_gain_is_infinite_where_the_response_grows_without_end(model: eom.LinearModel) -> None:
    gains = steady_gains(model).values
    slow = np.abs(model.frequency_response([1e-7, 1e-6]))
    # an integrator multiplies by ten from one frequency to the next; a finite gain does not change by 1 %
    assert np.array_equal(np.isinf(gains), slow[0] > 5.0 * slow[1])


def test_a_zero_root_that_is_not_cyclic_is_refused() -> None:
    with pytest.raises(eom.SingularError, match="has a zero root besides"):
        steady_gains(model_of(np.diag([0.0, -1.0]), np.ones((2, 1)), np.ones((1, 2))))


def test_gains_of_an_unstable_vehicle_are_formal() -> None:
    assert not steady_gains(eom.linearise(vehicle("pendulum_cart"))).stable
    assert steady_gains(eom.linearise(vehicle("b_train_yaw_roll"))).stable


def test_steer_turns_the_heading_and_carries_the_vehicle_away_without_end() -> None:
    sensors = "sensors:\n  heading: {body: tractor_frame, about: [0, 0, 1], measure: position}\n"
    model = eom.linearise(eom.loads(text("tractor_semitrailer_yaw_plane") + sensors))
    gains = steady_gains(model)
    # a positive steer angle turns left, the way that yaw is positive
    assert gains.of("heading", "axle_1.steer") == np.inf
    assert np.isfinite(gains.of("semitrailer.articulation", "axle_1.steer"))
