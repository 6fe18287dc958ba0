"""The driver's vehicle: the same motion as the yaw-plane model, its positions the integrals of the velocities."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from eom.closed_form import BTrainYawPlane, b_train_yaw_plane, driver
from tests.closed_form.varied import in_floats, varied

Array = np.ndarray


@given(varied(BTrainYawPlane), st.integers(5, 40))
@settings(max_examples=20, deadline=None)
def test_the_couplings_stay_closed(p: BTrainYawPlane, U: int) -> None:
    p = in_floats(p)
    A_d, B_d, _ = driver.system(p, float(U))
    gaps = driver.hitch_gaps(p, float(U))
    size = np.max(np.abs(A_d)) * np.max(np.abs(gaps))
    # the velocities that units miss each other by stay as they are, the distances change by them; rounding of one solve
    np.testing.assert_allclose(gaps @ A_d, np.vstack([gaps[2:], np.zeros((2, 12))]), atol=1e-13 * size)
    np.testing.assert_allclose(gaps @ B_d, 0.0, atol=1e-13 * size * np.max(np.abs(B_d)))


@given(varied(BTrainYawPlane), st.integers(5, 40))
@settings(max_examples=20, deadline=None)
def test_its_characteristic_polynomial_is_that_of_the_yaw_plane_and_six_roots_of_zero(
    p: BTrainYawPlane, U: int
) -> None:
    p = in_floats(p)
    whole = np.poly(driver.system(p, float(U)).A_d)
    plane = np.poly(b_train_yaw_plane.system(p, float(U)).A_p)
    # the coefficients of a polynomial have no repeated root's sensitivity; relative to the largest one
    np.testing.assert_allclose(whole, [*plane, *np.zeros(6)], atol=1e-9 * np.max(np.abs(plane)))


def kinematics(p: BTrainYawPlane, x: Array) -> Array:
    """Lateral places of the tractor's front axle and the semitrailers' centres, from place and headings of the train.

    (Y_1, psi_1, psi_2, psi_3) are enough: the couplings place the rest.
    """
    Y_1, psi = x[0], x[1::4]
    Y_2 = Y_1 - (p.a11 + p.l_c1) * psi[0] - p.l_c21 * psi[1]
    return np.array([Y_1, Y_2, Y_2 - p.l_c22 * psi[1] - p.l_c3 * psi[2]])


def test_a_train_that_starts_straight_and_is_steered_stays_one_train() -> None:
    p, U = BTrainYawPlane(), 25.0
    A_d, B_d, C_d = driver.system(p, U)

    def run(t: float, x: Array) -> Array:
        return np.asarray(A_d @ x + B_d[:, 0] * 0.02 * np.sin(2.5 * t))

    end = solve_ivp(run, (0.0, 5.0), np.zeros(12), rtol=1e-10, atol=1e-12).y[:, -1]
    # the integration's tolerance, over places of some metres
    np.testing.assert_allclose(C_d @ end, kinematics(p, end), atol=1e-7)
    assert abs(end[0]) > 0.1


def test_on_a_circle_positions_grow_as_the_circles() -> None:
    p, U, delta = BTrainYawPlane(), 20.0, 0.01
    plane = b_train_yaw_plane.system(p, U)
    steady = -np.linalg.solve(plane.A_p, plane.C_p[:, 0]) * delta
    rate = steady[1]
    # a start on the circle: the couplings give headings behind the tractor's
    psi_2 = steady[0] - steady[2] - (p.l_c1 + p.l_c21) * rate / U
    psi_3 = psi_2 + steady[2] - steady[4] - (p.l_c22 + p.l_c3) * rate / U
    psi = np.array([0.0, psi_2, psi_3])
    A_d, B_d, _ = driver.system(p, U)
    x = np.zeros(12)
    x[1::4], x[2::4], x[3::4] = psi, U * steady[0::2], rate
    x_dot = A_d @ x + B_d[:, 0] * delta
    # rounding; accelerations across the road are those of the circle, d(U psi + v + ..)/dt = U rate for every unit
    np.testing.assert_allclose(x_dot[2::4], 0.0, atol=1e-12)
    np.testing.assert_allclose(x_dot[3::4], 0.0, atol=1e-12)
    np.testing.assert_allclose(x_dot[1::4], rate, rtol=1e-14)
    second = A_d @ x_dot
    assert second[[0, 4, 8]] == pytest.approx([U * rate] * 3, rel=1e-11)
