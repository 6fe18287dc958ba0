"""A car and a caravan against Lagrange's equations of three coordinates, and against balances of the steady turn."""

import numpy as np
import pytest
import sympy
from scipy.optimize import brentq

import eom
from tests.vehicles.shipped import vehicle

M_CAR, I_CAR, A, WHEELBASE, HITCH = "1600", "2800", "1.25", "2.7", "3.7"
M_TRAILER, I_TRAILER, DRAWBAR, AHEAD = "1300", "2600", "4", "0.1"
CORNERING = ("110000", "130000", "80000")  # front, rear, caravan


def exact(*values: str) -> list[sympy.Rational]:
    return [sympy.Rational(value) for value in values]


def lagrange() -> tuple[sympy.Matrix, sympy.Matrix, sympy.Matrix]:
    """M, L, K of M q'' + L/U q' + K q = 0 in axes that travel ahead at speed U.

    q = (lateral place of the car's centre of mass, heading of the car, heading of the caravan).
    """
    m1, i1, a, wheelbase, hitch = exact(M_CAR, I_CAR, A, WHEELBASE, HITCH)
    m2, i2, drawbar, ahead = exact(M_TRAILER, I_TRAILER, DRAWBAR, AHEAD)
    car = sympy.Matrix([[1, 0, 0]])
    yaw_1, yaw_2 = sympy.Matrix([[0, 1, 0]]), sympy.Matrix([[0, 0, 1]])
    ball = car - (hitch - a) * yaw_1
    caravan = ball - (drawbar - ahead) * yaw_2
    M = m1 * car.T * car + m2 * caravan.T * caravan + i1 * yaw_1.T * yaw_1 + i2 * yaw_2.T * yaw_2
    L, K = sympy.zeros(3, 3), sympy.zeros(3, 3)
    contacts = ((car + a * yaw_1, yaw_1), (car - (wheelbase - a) * yaw_1, yaw_1), (ball - drawbar * yaw_2, yaw_2))
    for (contact, yaw), stiffness in zip(contacts, exact(*CORNERING), strict=True):
        # side force: stiffness times (heading - direction of travel of the contact)
        L += stiffness * contact.T * contact
        K -= stiffness * contact.T * yaw
    return M, L, K


def quartic(U: sympy.Symbol) -> list[sympy.Expr]:
    """Coefficients (a0, .., a4) of the characteristic polynomial, its double zero (place, heading) left out."""
    s = sympy.Symbol("s")
    M, L, K = lagrange()
    polynomial = sympy.Poly(sympy.expand((M * s**2 + L * s / U + K).det()), s)
    coefficients: list[sympy.Expr] = polynomial.all_coeffs()[::-1]
    assert coefficients[:2] == [0, 0]
    return coefficients[2:]


def snaking() -> tuple[float, float]:
    """Critical speed [m/s], where Hurwitz's last determinant is zero, and circular frequency there [1/s]."""
    U = sympy.Symbol("U", positive=True)
    a0, a1, a2, a3, a4 = quartic(U)
    determinant = sympy.numer(sympy.together(a1 * a2 * a3 - a1**2 * a4 - a3**2 * a0))
    roots = [root for root in sympy.Poly(determinant, U).nroots(n=20) if root.is_real and root > 0]
    # one crossing: from stable to snaking
    (critical,) = roots
    return float(critical), float(sympy.sqrt((a1 / a3).subs(U, critical)))


def rightmost(speed: float) -> complex:
    roots = np.linalg.eigvals(eom.linearise(vehicle("car_trailer", U=speed)).without_cyclic().A)
    return complex(max(roots, key=lambda root: (root.real, root.imag)))


def test_the_caravan_begins_to_snake_at_hurwitzs_critical_speed() -> None:
    critical, frequency = snaking()
    own = brentq(lambda speed: rightmost(speed).real, 0.5 * critical, 1.5 * critical, xtol=1e-12)
    # the root crosses at 0.01 1/s per m/s; its rounding of 1e-14 1/s is 1e-12 m/s
    assert own == pytest.approx(critical, rel=1e-10)
    assert rightmost(critical).imag == pytest.approx(frequency, rel=1e-10)
    assert rightmost(0.99 * critical).real < 0.0 < rightmost(1.01 * critical).real


@pytest.mark.parametrize("speed", [5.0, 22.0, 40.0])
def test_roots_are_those_of_lagranges_equations(speed: float) -> None:
    U = sympy.Symbol("U", positive=True)
    expected = np.roots([float(item.subs(U, sympy.Rational(str(speed)))) for item in quartic(U)[::-1]])
    own = np.linalg.eigvals(eom.linearise(vehicle("car_trailer", U=speed)).without_cyclic().A)
    # roots of a polynomial lose some digits against eigenvalues of matrices
    np.testing.assert_allclose(np.sort_complex(own), np.sort_complex(expected), rtol=1e-9)


@pytest.mark.parametrize(("parameter", "change"), [("ahead", 0.3), ("I_caravan", 1500.0), ("drawbar", 5.0)])
def test_weight_on_the_ball_a_compact_load_and_a_long_drawbar_calm_the_caravan(parameter: str, change: float) -> None:
    speed, _ = snaking()
    changed = eom.linearise(vehicle("car_trailer", U=speed, **{parameter: change})).without_cyclic()
    assert np.max(np.linalg.eigvals(changed.A).real) < 0.0


@pytest.mark.parametrize("speed", [5.0, 22.0, 30.0])
def test_the_steady_turn_obeys_the_balances_of_forces_and_levers(speed: float) -> None:
    m1, a, wheelbase, hitch = (float(text) for text in (M_CAR, A, WHEELBASE, HITCH))
    m2, drawbar, ahead = (float(text) for text in (M_TRAILER, DRAWBAR, AHEAD))
    front, rear, trailer = (float(text) for text in CORNERING)
    # per unit of lateral acceleration: the ball pulls the car outwards, moments about rear axle and front axle
    ball = m2 * ahead / drawbar
    on_front = (m1 * (wheelbase - a) - ball * (hitch - wheelbase)) / wheelbase
    on_rear = (m1 * a + ball * hitch) / wheelbase
    yaw_gain = speed / (wheelbase + (on_front / front - on_rear / rear) * speed**2)

    model = eom.linearise(vehicle("car_trailer", U=speed)).without_cyclic()
    gain = (model.D - model.C @ np.linalg.solve(model.A, model.B))[:, model.inputs.index("axle_1.steer")]
    own = dict(zip(model.outputs, gain, strict=True))
    # rounding of one linear solve
    for unit in ("car", "caravan"):
        assert own[f"{unit}.yaw_rate"] == pytest.approx(yaw_gain, rel=1e-11)
        assert own[f"{unit}.ay"] == pytest.approx(speed * yaw_gain, rel=1e-11)
    # the caravan's heading less the car's: lever arms on the circle, and both rear slip angles
    curvature, acceleration = yaw_gain / speed, speed * yaw_gain
    slip = ((m2 - ball) / trailer - on_rear / rear) * acceleration
    offset = (hitch - wheelbase + drawbar) * curvature
    assert own["caravan.articulation"] == pytest.approx(slip - offset, rel=1e-11)


def test_axles_and_ball_carry_the_weight_by_the_levers() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(vehicle("car_trailer")))
    ball = 1300.0 * 9.81 * 0.1 / 4.0
    rear = (1600.0 * 9.81 * 1.25 + ball * 3.7) / 2.7
    expected = {"axle_1": 1600.0 * 9.81 + ball - rear, "axle_2": rear, "axle_3": 1300.0 * 9.81 - ball}
    assert loads.axles == pytest.approx(expected, rel=1e-12)
    assert loads.couplings["ball"][0][2] == pytest.approx(ball, rel=1e-12)
