"""The towed wheel against its closed form.

The king pin of mass M moves sideways by y against a spring k and a damper d; the fork of mass m and inertia I_z about
its centre of mass, b behind the pin, is turned by psi; the wheel touches the road a behind the pin. With the side force
F on the wheel

    (M + m) y'' - m b psi'' + d y' + k y = F
    -m b y'' + (I_z + m b^2) psi'' = -a F

and without slip y' - a psi' = U psi. a times the first plus the second, with y' put in, is

    a3 psi''' + a2 psi'' + a1 psi' + a0 psi = 0

    a3 = M a^2 + m (a - b)^2 + I_z ,  a2 = ((M + m) a - m b) U + a^2 d ,  a1 = a (d U + a k) ,  a0 = a k U

By Hurwitz it is stable where a2 a1 > a3 a0: a quadratic in U.

Tolerance: 1e-9. The closed form has no other rounding than that of a few products.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

import eom
from tests.vehicles.shipped import text, vehicle

M, m, I_z, a, b, k, d = 2.0, 6.0, 0.05, 0.12, 0.08, 20e3, 60.0
A3 = M * a**2 + m * (a - b) ** 2 + I_z
LEVER = (M + m) * a - m * b


def rightmost(U: float, **changes: float) -> float:
    """Largest real part of the model's roots."""
    return float(np.max(eom.linearise(vehicle("shimmy", U=U, **changes)).modes().eigenvalues.real))


@pytest.mark.parametrize("U", [0.5, 3.0, 8.0, 30.0])
def test_the_rigid_wheel_has_the_roots_of_its_third_order_polynomial(U: float) -> None:
    found = np.sort_complex(eom.linearise(vehicle("shimmy", U=U)).modes().eigenvalues)
    polynomial = [A3, LEVER * U + a**2 * d, a * (d * U + a * k), a * k * U]
    np.testing.assert_allclose(found, np.sort_complex(np.roots(polynomial)), rtol=1e-9)


def test_the_wheel_shimmies_between_the_two_speeds_of_the_hurwitz_quadratic() -> None:
    quadratic = [LEVER * d, LEVER * a * k + a**2 * d**2 - A3 * k, a**3 * k * d]
    slow, fast = np.sort(np.roots(quadratic).real)
    middle = np.sqrt(slow * fast)
    assert brentq(rightmost, 0.5 * slow, middle, xtol=1e-12) == pytest.approx(slow, rel=1e-9)
    assert brentq(rightmost, middle, 2.0 * fast, xtol=1e-12) == pytest.approx(fast, rel=1e-9)
    assert rightmost(middle) > 0.0


@pytest.mark.parametrize("U", [1.0, 8.0, 40.0])
def test_without_damping_a_contact_behind_the_centre_of_percussion_is_stable_at_any_speed(U: float) -> None:
    """The centre of percussion of the fork is b + I_z / (m b) behind the pin; the mass of the pin does not matter."""

    def margin(trail: float) -> float:
        return rightmost(U, a=trail, d=0.0)

    percussion = b + I_z / (m * b)
    assert brentq(margin, 0.9 * percussion, 1.1 * percussion, xtol=1e-13) == pytest.approx(percussion, rel=1e-9)
    assert margin(0.9 * percussion) > 0.0 > margin(1.1 * percussion)


@pytest.mark.parametrize("U", [0.5, 8.0, 30.0])
@pytest.mark.parametrize("c", [50.0, 2e3])
def test_a_wheel_that_slips_against_a_damper_has_the_roots_of_its_two_equations(U: float, c: float) -> None:
    """F = -c (y' - a psi' - U psi) instead of no slip: a polynomial of fourth order."""
    file = (
        text("shimmy")
        .replace("type: nh_point", "type: slip_damper")
        .replace("between: [fork, ground], at: [-a, 0, 0], forces: 1", f"body: fork, at: [-a, 0, 0], damping: {c}")
    )
    found = np.sort_complex(eom.linearise(eom.loads(file, U=U)).modes().eigenvalues)
    mass = np.array([[M + m, -m * b], [-m * b, I_z + m * b**2]])
    damping = np.array([[d + c, -a * c], [-a * c, a**2 * c]])
    stiffness = np.array([[k, -c * U], [0.0, a * c * U]])
    lower = -np.linalg.solve(mass, np.hstack([stiffness, damping]))
    expected = np.linalg.eigvals(np.vstack([np.eye(2, 4, 2), lower]))
    np.testing.assert_allclose(found, np.sort_complex(expected), rtol=1e-9)
