"""The nonlinear yaw-plane models: linear at the straight run, exact to their order in motion; brakes and tyres."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from eom.closed_form import (
    BTrainBraked,
    BTrainYawPlane,
    TractorSemitrailer,
    b_train_nonlinear,
    b_train_yaw_plane,
    brakes,
    magic_formula,
    tractor_semitrailer,
    tractor_semitrailer_nonlinear,
)
from eom.closed_form.b_train_nonlinear import Controls
from tests.closed_form.planar_kane import b_train_by_kane, tractor_semitrailer_by_kane
from tests.closed_form.varied import in_floats, varied

Array = np.ndarray
FLOATS = st.floats(-1.0, 1.0)
MOMENTS = st.floats(-1e5, 1e5)


def complex_step(function: Callable[[Array], Array], at: Array) -> Array:
    """The Jacobian of a function, exact to rounding: the imaginary part of a tiny imaginary step."""
    columns = [function(at + 1e-30j * row).imag / 1e-30 for row in np.eye(len(at))]
    return np.array(columns).T


# At the straight run


@settings(max_examples=20, deadline=None)
@given(varied(TractorSemitrailer), st.floats(0.5, 2.5), st.floats(-5.0, 0.9), st.integers(5, 40))
def test_the_tractor_semitrailers_tangent_at_the_straight_run_is_the_linear_model(
    p: TractorSemitrailer, shape: float, curvature: float, speed: int
) -> None:
    p, U = in_floats(p), float(speed)
    C = np.array([p.C_f11, p.C_r12, p.C_r23])
    peak = np.array([5e4, 9e4, 8e4])

    def tyres(alpha: Array) -> Array:
        return magic_formula(alpha, C / (shape * peak), shape, peak, curvature)

    def at(z: Array) -> Array:
        rates = tractor_semitrailer_nonlinear.right_hand_side(p, U, z[:4], z[4:], tyres)
        return np.concatenate([rates, tractor_semitrailer_nonlinear.outputs(p, U, z[:4], z[4:], tyres)])

    linear = tractor_semitrailer.state_space(p, U)
    expected = np.block([[linear.A, linear.B], [linear.C, linear.D]])
    # exact derivatives; rounding of solves with the same mass matrix, its rows in another order
    np.testing.assert_allclose(complex_step(at, np.zeros(7)), expected, rtol=1e-11, atol=1e-11 * np.max(abs(expected)))


@settings(max_examples=20, deadline=None)
@given(varied(BTrainBraked), st.booleans(), st.integers(5, 40))
def test_the_b_trains_tangent_at_the_straight_run_is_the_linear_model(p: BTrainBraked, drag: bool, speed: int) -> None:
    p, U = in_floats(p), float(speed)
    C = np.array([axle.C for axles in p.axles for axle in axles])

    def at(z: Array) -> Array:
        controls = Controls(delta_11=z[7])
        return b_train_nonlinear.right_hand_side(p, z[:7], controls, lambda alpha: C * alpha, cornering_drag=drag)

    linear = b_train_yaw_plane.system(p, U)
    expected = np.zeros((7, 8))
    expected[1:, 1:7], expected[1:, 7:] = linear.A_p, linear.C_p
    # as above; the speed changes nothing in a straight run, and nothing changes the speed to first order
    jacobian = complex_step(at, np.array([U, *np.zeros(7)]))
    np.testing.assert_allclose(jacobian, expected, rtol=1e-11, atol=1e-11 * np.max(abs(expected)))


def test_trailer_moments_act_as_in_the_linear_model() -> None:
    p, U = BTrainYawPlane(), 25.0
    # the same J, and unit columns for both
    np.testing.assert_allclose(b_train_nonlinear.system(p, U).B_M, b_train_yaw_plane.system(p, U).B_m, rtol=1e-13)


def test_the_train_coasts_and_is_driven_by_newtons_law() -> None:
    p = BTrainBraked()
    straight = np.array([20.0, 0, 0, 0, 0, 0, 0])
    pressures = np.full((6, 2), 2e5)
    rates = b_train_nonlinear.rates(p, straight, np.zeros(9), Controls(0.0, 8e3, pressures), cornering_drag=True)
    # drive torque less twelve brake torques at one radius, less the rolling resistance of all weight
    expected = (8e3 - 12 * p.K_b * 2e5) / p.r_w / (p.m1 + p.m2 + p.m3) - p.f_r * p.g
    np.testing.assert_allclose(rates, [expected, 0, 0, 0, 0, 0, 0], rtol=1e-13)


# In motion, against the exact planar equations


def exact_rates(train: Any) -> Callable[..., tuple[Array, Array]]:
    """Kane's exact equations as functions of parameters, speeds, articulations and forces: rates, accelerations."""
    names = sorted((train.mass_matrix.free_symbols | train.forcing.free_symbols) & set(sp.symbols(PARAMETERS)), key=str)
    rates = [speed.diff(sp.Symbol("t")) for speed in train.speeds]
    motion = [*train.speeds, *train.articulations]
    plain = {quantity: sp.Dummy() for quantity in [*rates, *motion]}
    forces = [*train.F_x, *train.F_y, *train.delta, *train.M_z]
    arguments = [names, [plain[z] for z in motion], forces]
    equations = sp.lambdify(arguments, [train.mass_matrix.xreplace(plain), train.forcing.xreplace(plain)], cse=True)
    sideways = sp.lambdify(arguments, [row.xreplace(plain) for row in train.sideways], cse=True)

    def of(p: Any, z: Array, acting: Array) -> tuple[Array, Array]:
        values = [getattr(p, symbol.name) for symbol in names]
        mass, forcing = equations(values, z, acting)
        return np.linalg.solve(mass, np.ravel(forcing)), np.array(sideways(values, z, acting), dtype=float)

    return of


PARAMETERS = [name for kind in (BTrainYawPlane, TractorSemitrailer) for name in vars(kind())]


def b_train_errors(e: float) -> tuple[float, float, float]:
    """Norms of the errors of dU/dt with and without cornering drag, and of the rates of beta_1 and psi_dot_i.

    Over twenty random motions whose lateral quantities are of order e and longitudinal accelerations of order e^2.
    """
    exact = exact_rates(b_train_by_kane())
    random = np.random.default_rng(5)
    errors = []
    for _ in range(20):
        p = replace(BTrainBraked(), f_r=0.5 * e**2, m1=random.uniform(6e3, 1e4), l_c22=random.uniform(3.0, 7.0))
        U, Gamma, v, delta = 25.0, e * random.uniform(-1, 1, 2), 10.0 * e * random.uniform(-1, 1), e * random.uniform()
        r = e * random.uniform(-1, 1, 3)
        F_y = e * random.uniform(-2e5, 2e5, 9)
        controls = Controls(delta, e**2 * random.uniform(0, 3e4), e**2 * random.uniform(0, 2e6, (6, 2)))
        rolling = np.zeros(9)
        rolling[[1, 4, 7]] = p.f_r * p.g * np.array([p.m1, p.m2, p.m3])
        F_x = np.sum(brakes.longitudinal_forces(p, controls.T_d, controls.pressures), axis=1) - rolling
        acting = np.array([*F_x, *F_y, delta, *np.zeros(8), 0.0, *brakes.brake_moments(p, controls.pressures)])
        expected, sideways = exact(p, np.array([U, v, *r, *Gamma]), acting)
        x = np.array([U, *(value for i in range(3) for value in (sideways[i] / U, r[i]))])
        full, thesis = (b_train_nonlinear.rates(p, x, F_y, controls, cornering_drag=drag) for drag in (True, False))
        lateral = [(full[1] + x[1] * full[0] / U) * U - expected[1], *(full[2::2] - expected[2:])]
        errors.append([full[0] - expected[0], thesis[0] - expected[0], np.linalg.norm(lateral)])
    norms = np.linalg.norm(errors, axis=0)
    return float(norms[0]), float(norms[1]), float(norms[2])


def test_the_cornering_drag_is_complete_to_third_order_and_the_side_balances_to_second() -> None:
    coarse, fine = np.array(b_train_errors(0.02)), np.array(b_train_errors(0.01))
    # halving a motion divides errors of order e^4, e^2 and e^3 by 16, 4 and 8, up to the next order, e^2 = 4e-4 less
    np.testing.assert_allclose(coarse / fine, [16.0, 4.0, 8.0], rtol=0.01)
    # what (3.34a) drops is not small: of the size of what it keeps
    assert fine[1] > 1e3 * fine[0]


def test_the_tractor_semitrailers_side_balances_are_exact_to_second_order() -> None:
    exact = exact_rates(tractor_semitrailer_by_kane())

    def error(e: float) -> float:
        random, p, U = np.random.default_rng(6), TractorSemitrailer(), 25.0
        errors = []
        for _ in range(20):
            v, Gamma, r = 10.0 * e * random.uniform(-1, 1), e * random.uniform(-1, 1), e * random.uniform(-1, 1, 2)
            F = e * random.uniform(-2e5, 2e5, 3)
            z, acting = np.array([U, v, *r, Gamma]), np.array([0, 0, 0, *F, 0, 0, 0, 0, 0])
            rates, _ = exact(p, z, acting)
            A_nl, B_nl, _, _ = tractor_semitrailer_nonlinear.system(p, U)
            own = A_nl @ [r[0], r[1] - r[0], v / U, Gamma] + B_nl @ F
            errors.append([own[0] - rates[2], own[0] + own[1] - rates[3], U * own[2] - rates[1]])
        return float(np.linalg.norm(errors))

    # errors of order e^3
    assert error(0.02) / error(0.01) == pytest.approx(8.0, rel=0.01)


# Brakes and tyres


@given(varied(BTrainBraked), MOMENTS, MOMENTS)
@settings(max_examples=30, deadline=None)
def test_pressures_from_moments_give_these_moments(p: BTrainBraked, M_2: float, M_3: float) -> None:
    p = in_floats(p)
    P = brakes.brake_pressures(p, M_2, M_3)
    # three products there and three back
    np.testing.assert_allclose(brakes.brake_moments(p, P), [M_2, M_3], rtol=1e-14, atol=1e-300)
    # three wheels of one side for each moment
    assert np.count_nonzero(P) == 3 * sum(abs(M) > 0 for M in (M_2, M_3))


@given(st.lists(st.floats(0.0, 1e6), min_size=12, max_size=12))
@settings(max_examples=30, deadline=None)
def test_brake_moments_are_those_of_the_wheel_forces(pressures: list[float]) -> None:
    p, P = BTrainBraked(), np.reshape(pressures, (6, 2))
    F = brakes.longitudinal_forces(p, 0.0, P)
    # (3.31c), (3.32c): the sum of d/2 (F_xl - F_xr) over the axles of a semitrailer
    expected = [p.d2 / 2 * np.sum(F[3:6, 0] - F[3:6, 1]), p.d3 / 2 * np.sum(F[6:9, 0] - F[6:9, 1])]
    # rounding of sums that may cancel
    np.testing.assert_allclose(brakes.brake_moments(p, P), expected, rtol=1e-12, atol=1e-9)


def test_wheels_share_the_drive_torque_and_brakes_pull_back() -> None:
    p = BTrainBraked()
    F = brakes.longitudinal_forces(p, 1000.0, np.full((6, 2), 7e5))
    assert np.sum(F[:3]) == pytest.approx(1000.0 / p.r_w, rel=1e-14)
    assert not np.any(F[0])
    # 10 kN m at 0.7 MPa and a wheel of 0.51 m: K_b is printed with five digits
    assert F[3, 0] == pytest.approx(-10e3 / 0.51, rel=5e-5)


@given(st.floats(-1.5, 1.5), st.floats(1.0, 20.0), st.floats(1.0, 1.9), st.floats(1e3, 1e5), st.floats(-5.0, 0.99))
def test_the_magic_formula_is_odd_bounded_by_its_peak_and_has_the_slope_bcd(
    alpha: float, B: float, C: float, D: float, E: float
) -> None:
    force = magic_formula(alpha, B, C, D, E)
    # rounding
    assert force == pytest.approx(-float(magic_formula(-alpha, B, C, D, E)), rel=1e-12, abs=1e-9)
    assert abs(force) <= D * (1.0 + 1e-15)
    slope = complex_step(lambda a: magic_formula(a, B, C, D, E), np.zeros(1))[0, 0]
    assert slope == pytest.approx(B * C * D, rel=1e-14)


def test_the_magic_formula_reaches_its_peak_where_its_sine_does() -> None:
    # E = 0 and C arctan(B alpha) = pi/2
    B, C, D = 10.0, 1.3, 5e4
    assert float(magic_formula(np.tan(np.pi / 2 / C) / B, B, C, D, 0.0)) == pytest.approx(D, rel=1e-14)
