"""Half car and yaw-plane car against the closed forms of the textbooks (quarter car: tests/assembly).

Tolerance: 1e-9, rounding of small linear systems.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

import eom

HALF_CAR = """
name: Half car
bodies:
  body: {mass: 600, at: [0, 0, 0.5], inertia: {xx: 300, yy: 950, zz: 1000}}
  front: {mass: 40, at: [1.2, 0, 0.5]}
  rear: {mass: 50, at: [-1.5, 0, 0.5]}
connectors:
  body_guide: {type: rigid_point, between: [body, ground], at: [0, 0, 0.5], forces: 2, axis: [0, 0, 1]}
  body_turns: {type: rigid_point, between: [body, ground], at: [0, 0, 0.5], moments: 2, axis: [0, 1, 0]}
  front_guide: {type: rigid_point, between: [front, ground], at: [1.2, 0, 0.5], forces: 2, moments: 3, axis: [0, 0, 1]}
  rear_guide: {type: rigid_point, between: [rear, ground], at: [-1.5, 0, 0.5], forces: 2, moments: 3, axis: [0, 0, 1]}
  front_spring:
    {type: flex_point, between: [front, body], at: [1.2, 0, 0.5], forces: 1, axis: [0, 0, 1],
    stiffness: 18e3, damping: 1500}
  rear_spring:
    {type: flex_point, between: [rear, body], at: [-1.5, 0, 0.5], forces: 1, axis: [0, 0, 1],
    stiffness: 21e3, damping: 2000}
  front_tyre:
    {type: flex_point, between: [front, ground], at: [1.2, 0, 0], forces: 1, axis: [0, 0, 1], stiffness: 19e4}
  rear_tyre:
    {type: flex_point, between: [rear, ground], at: [-1.5, 0, 0], forces: 1, axis: [0, 0, 1], stiffness: 2e5}
actuators:
  front_road: {body: front, along: [0, 0, 1], gain: 19e4, unit: m}
  rear_road: {body: rear, along: [0, 0, 1], gain: 2e5, unit: m}
sensors:
  heave: {body: body, along: [0, 0, 1], measure: position}
  pitch: {body: body, about: [0, 1, 0], measure: position}
  front_hop: {body: front, along: [0, 0, 1], measure: position}
  rear_hop: {body: rear, along: [0, 0, 1], measure: position}
"""


@pytest.mark.parametrize("frequency", [0.3, 1.1, 4.0, 11.0])
def test_half_car_has_the_transfer_functions_of_the_textbooks(frequency: float) -> None:
    """Heave z, pitch theta (nose down) and two wheels; the body's ends move by z - x theta."""
    s = 2j * np.pi * frequency
    dynamic = np.diag([600.0, 950.0, 40.0, 50.0]) * s**2
    road = np.zeros((4, 2), dtype=complex)
    for column, (x, k, c, k_t) in enumerate(((1.2, 18e3, 1500.0, 19e4), (-1.5, 21e3, 2000.0, 2e5))):
        stretch = np.array([1.0, -x, 0.0, 0.0])
        stretch[2 + column] = -1.0
        dynamic = dynamic + (k + c * s) * np.outer(stretch, stretch)
        dynamic[2 + column, 2 + column] += k_t
        road[2 + column, column] = k_t
    found = eom.linearise(eom.loads(HALF_CAR)).frequency_response(frequency)[0]
    np.testing.assert_allclose(found, np.linalg.solve(dynamic, road), rtol=1e-9)


CAR = """
name: Car in the yaw plane
gravity: 9.81
trim: {speed: U, hold: true}
parameters: {U: 20 m/s, C_f: 120e3, C_r: 140e3}
tyres:
  front_tyre: {per: axle, cornering: C_f}
  rear_tyre: {per: axle, cornering: C_r}
units:
  car:
    bodies:
      body: {mass: 1500, at: [-1.1, 0, 0.5], inertia: {xx: 500, yy: 2400, zz: 2500}}
    connectors:
      road: {type: support, body: body, at: [-1.1, 0, 0], carries: [z, roll, pitch]}
    axle_groups:
      all: {body: body}
    axles:
      front: {group: all, x: 0, tyre: front_tyre, steered: true}
      rear: {group: all, x: -2.7, tyre: rear_tyre}
"""
m, I_z, a, b, L = 1500.0, 2500.0, 1.1, 1.6, 2.7
UNDER, OVER = {"C_f": 120e3, "C_r": 140e3}, {"C_f": 160e3, "C_r": 90e3}


def gradient(tyres: dict[str, float]) -> float:
    """Understeer gradient K [s^2/m]: the steer angle of a steady turn of radius R is (L + K U^2) / R."""
    return m / L * (b / tyres["C_f"] - a / tyres["C_r"])


def steady(U: float, tyres: dict[str, float]) -> dict[str, float]:
    """Steady gains per steer angle."""
    model = eom.linearise(eom.loads(CAR, U=U, **tyres)).without_cyclic()
    gains = (model.D - model.C @ np.linalg.solve(model.A, model.B))[:, model.inputs.index("axle_1.steer")]
    return dict(zip(model.outputs, gains, strict=True))


@pytest.mark.parametrize("U", [3.0, 20.0, 50.0])
def test_steady_turn_follows_the_understeer_gradient(U: float) -> None:
    K = gradient(UNDER)
    gains = steady(U, UNDER)
    assert gains["car.yaw_rate"] == pytest.approx(U / (L + K * U**2), rel=1e-9)
    assert gains["car.ay"] == pytest.approx(U**2 / (L + K * U**2), rel=1e-9)
    # from the geometry of the rear axle, whose slip angle carries its share of the centripetal force
    assert gains["car.sideslip"] == pytest.approx((b - a * m * U**2 / (L * UNDER["C_r"])) / (L + K * U**2), rel=1e-9)


def test_yaw_gain_has_its_maximum_at_the_characteristic_speed() -> None:
    """U = sqrt(L / K); there it is half of what the wheelbase alone would give."""
    characteristic = float(np.sqrt(L / gradient(UNDER)))
    half = brentq(lambda U: steady(U, UNDER)["car.yaw_rate"] / (U / L) - 0.5, 5.0, 80.0, xtol=1e-11)
    assert half == pytest.approx(characteristic, rel=1e-9)
    peak = steady(characteristic, UNDER)["car.yaw_rate"]
    assert all(peak > steady(factor * characteristic, UNDER)["car.yaw_rate"] for factor in (0.99, 1.01))


def test_an_oversteering_car_becomes_unstable_at_its_critical_speed() -> None:
    """U = sqrt(-L / K): a root passes zero, and with it the determinant."""
    critical = float(np.sqrt(-L / gradient(OVER)))

    def determinant(U: float) -> float:
        return float(np.linalg.det(eom.linearise(eom.loads(CAR, U=U, **OVER)).without_cyclic().A))

    assert brentq(determinant, 5.0, 60.0, xtol=1e-12) == pytest.approx(critical, rel=1e-9)
    for factor, stable in ((0.95, True), (1.05, False)):
        roots = eom.linearise(eom.loads(CAR, U=factor * critical, **OVER)).without_cyclic().modes().eigenvalues
        assert (np.max(roots.real) < 0.0) == stable


@pytest.mark.parametrize("U", [8.0, 20.0, 40.0])
def test_yaw_plane_roots_are_those_of_the_quadratic(U: float) -> None:
    """Sum: -(damping of sideslip and of yaw); product: C_f C_r L^2 / (m I_z U^2) (1 + K U^2 / L)."""
    C_f, C_r = UNDER["C_f"], UNDER["C_r"]
    total = (C_f + C_r) / (m * U) + (a**2 * C_f + b**2 * C_r) / (I_z * U)
    product = C_f * C_r * L**2 / (m * I_z * U**2) * (1.0 + gradient(UNDER) * U**2 / L)
    found = eom.linearise(eom.loads(CAR, U=U, **UNDER)).without_cyclic().modes().eigenvalues
    np.testing.assert_allclose(np.sort_complex(found), np.sort_complex(np.roots([1.0, total, product])), rtol=1e-9)
