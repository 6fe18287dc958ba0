"""Transmission zeros against python-control, systems made from their zeros, and the rank of the pencil."""

import control
import numpy as np
import pytest
import scipy.signal
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.analysis import transmission_zeros
from tests.analysis.random_models import model_of, part, settled, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import vehicle

Array = np.ndarray
RANDOM = settings(max_examples=40, deadline=None, phases=PHASES)


def matched(found: Array, expected: Array, tolerance: float) -> None:
    """The same numbers in any order, each within a tolerance of its size, at least one."""
    assert len(found) == len(expected)
    rest = list(expected)
    for value in found:
        k = int(np.argmin(np.abs(np.array(rest) - value)))
        assert abs(rest[k] - value) <= tolerance * max(abs(value), 1.0)
        del rest[k]


@pytest.mark.parametrize(
    ("name", "source", "output"),
    [
        ("b_train_yaw_roll", "axle_1.steer", "tractor.ay"),
        ("b_train_yaw_roll", "axle_1.steer", "semitrailer_2.ay"),
        ("b_train_yaw_plane", "axle_1.steer", "semitrailer_1.yaw_rate"),
        ("quarter_car", "road", "sprung_acceleration"),
        ("full_car", "front_left_road", "pitch"),
        ("articulated_bus", "axle_1.steer", "axle_1.ay"),
        ("bicycle", "steer_torque", "lean"),
    ],
)
def test_zeros_of_shipped_vehicles_are_those_of_python_control(name: str, source: str, output: str) -> None:
    model = eom.linearise(vehicle(name))
    A, B, C, D = part(model.without_cyclic(), source, output)
    found = transmission_zeros(model, [source], [output]).values
    expected = control.zeros(control.ss(A, B, C, D))
    # infinite zeros come out of a generalised eigenvalue problem as huge numbers: those of the pencil are below
    expected = expected[np.abs(expected) < 1e3 * np.max(np.abs(np.linalg.eigvals(A)))]
    matched(found, expected, 1e-6)


@RANDOM
@given(st.integers(0, 3), st.integers(0, 2), st.integers(1, 3), st.integers(0, 2**32 - 1))
def test_zeros_are_those_that_a_transfer_function_was_made_from(real: int, pairs: int, more: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    swing = rng.uniform(-2.0, 2.0, pairs) + 1j * rng.uniform(0.5, 3.0, pairs)
    zeros = np.concatenate([rng.uniform(-3.0, 3.0, real), swing, swing.conj()])
    poles = -rng.uniform(0.5, 4.0, len(zeros) + more)
    A, B, C, D = scipy.signal.zpk2ss(zeros, poles, 2.5)
    T = np.linalg.qr(rng.normal(size=A.shape))[0]
    found = transmission_zeros(model_of(T @ A @ T.T, T @ B, C @ T.T, D), ["u0"], ["y0"]).values
    # controller form of up to ten poles: zeros to the root of its condition
    matched(found, zeros, 1e-4)


@RANDOM
@given(stable_models(largest=6))
def test_the_pencil_loses_rank_at_every_zero(model: eom.LinearModel) -> None:
    zeros = transmission_zeros(model, model.inputs, model.outputs).values
    n = len(model.A)
    for zero in zeros:
        pencil = np.block([[model.A - zero * np.eye(n), model.B], [model.C, model.D]])
        values = np.linalg.svd(pencil, compute_uv=False)
        assert values[-1] <= 1e-8 * values[0]


@RANDOM
@given(st.integers(1, 5), st.integers(1, 3), st.integers(0, 2**32 - 1))
def test_a_square_system_with_a_regular_d_has_a_zero_for_each_state(n: int, m: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    A, B, C = settled(rng, n), rng.normal(size=(n, m)), rng.normal(size=(m, n))
    D = rng.normal(size=(m, m)) + 3.0 * np.eye(m)
    model = model_of(A, B, C, D)
    # the roots of the inverse system
    matched(
        transmission_zeros(model, model.inputs, model.outputs).values,
        np.linalg.eigvals(A - B @ np.linalg.solve(D, C)),
        1e-8,
    )


@RANDOM
@given(st.floats(-3.0, 3.0), st.integers(2, 4), st.integers(0, 2**32 - 1))
def test_two_outputs_of_one_input_have_the_zero_that_both_have_and_no_other(zero: float, n: int, seed: int) -> None:
    """An input through (s - z)/(s + 5) into a generic system of two outputs."""
    rng = np.random.default_rng(seed)
    A, b, C = settled(rng, n), rng.normal(size=(n, 1)), rng.normal(size=(2, n))
    # v = u - (5 + z) w, dw/dt = -5 w + u
    whole = np.block([[A, -(5.0 + zero) * b], [np.zeros((1, n)), np.array([[-5.0]])]])
    model = model_of(whole, np.vstack([b, [[1.0]]]), np.hstack([C, np.zeros((2, 1))]))
    found = transmission_zeros(model, ["u0"], ["y0", "y1"])
    assert found.outputs == ("y0", "y1")
    matched(found.values, np.array([zero]), 1e-7)
    transposed = model_of(model.A.T, model.C.T, model.B.T)
    matched(transmission_zeros(transposed, ["u0", "u1"], ["y0"]).values, np.array([zero]), 1e-7)


def test_units_of_the_signals_do_not_matter() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    A, B, C, D = part(model.without_cyclic(), "axle_1.steer", "tractor.ay")
    one = transmission_zeros(model_of(A, B, C, D), ["u0"], ["y0"]).values
    two = transmission_zeros(model_of(A, B * 1e9, C * 1e-7, D * 1e2), ["u0"], ["y0"]).values
    matched(two, one, 1e-9)


def test_an_output_that_an_input_does_not_move_has_no_zeros() -> None:
    model = model_of(np.diag([-1.0, -2.0]), np.array([[1.0], [0.0]]), np.array([[0.0, 1.0]]))
    with pytest.raises(eom.AnalysisError, match="the inputs do not move the outputs"):
        transmission_zeros(model, ["u0"], ["y0"])
