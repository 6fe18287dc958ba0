"""Tyres with relaxation, longitudinal slip and vertical stiffness, from the file, against closed forms."""

import numpy as np
import pytest

import eom
from tests.model.test_checks import CAR

m, I_zz, a, b, C, U = 1500.0, 2200.0, 1.2, 1.4, 80e3, 20.0
SENSORS = """sensors:
  v: {body: frame, along: [0, 1, 0], measure: velocity, frame: body}
  r: {body: frame, about: [0, 0, 1], measure: velocity}
  ay: {body: frame, along: [0, 1, 0], measure: acceleration}
"""


def car(tyre: str) -> str:
    """The car that holds its speed, on tyres with these further keys."""
    file = CAR.replace("trim: {speed: U}", "trim: {speed: U, hold: true}") + SENSORS
    return file.replace("cornering: 80 kN/rad", f"cornering: 80 kN/rad, {tyre}")


def lagged(sigma: float, trail: float, s: complex) -> np.ndarray:
    """Answer of v, r and lateral acceleration to steer at *s*.

    The side force of each axle obeys (sigma/U) dF/dt + F = -C (slip angle - steer), so each C becomes
    C/(1 + s sigma/U); it acts *trail* behind the axle.
    """
    C_s = C / (1.0 + s * sigma / U)
    slips = np.array([[1.0, a], [1.0, -b]]) / U
    arms = np.array([a - trail, -(b + trail)])
    mass = s * np.diag([m, I_zz]) + np.array([[0.0, m * U], [0.0, 0.0]])
    v, r = np.linalg.solve(mass + C_s * np.array([slips.sum(axis=0), arms @ slips]), C_s * np.array([1.0, arms[0]]))
    return np.array([v, r, s * v + U * r])


@pytest.mark.parametrize("trail", [0.0, 0.05])
@pytest.mark.parametrize("sigma", [0.1, 0.7, 3.0])
@pytest.mark.parametrize("frequency", [0.0, 0.3, 2.0, 12.0])
def test_side_force_lags_by_the_relaxation_length(frequency: float, sigma: float, trail: float) -> None:
    file = car(f"relaxation: {sigma}" + (f", trail: {trail}" if trail else ""))
    model = eom.linearise(eom.loads(file)).without_cyclic()
    assert len(model.A) == 4
    found = model.frequency_response(frequency)[0, :, 0]
    np.testing.assert_allclose(found, lagged(sigma, trail, 2j * np.pi * frequency), rtol=1e-9, atol=1e-12)


def test_relaxation_leaves_the_steady_turn_as_it_is() -> None:
    steady = [
        eom.linearise(eom.loads(file)).without_cyclic().frequency_response(0.0)[0, :, 0]
        for file in (car("trail: 0.05"), car("trail: 0.05, relaxation: 0.6"))
    ]
    np.testing.assert_allclose(steady[0], steady[1], rtol=1e-10)


def test_relaxation_length_of_almost_nothing_is_none() -> None:
    """An error of sigma/U times the fastest motion that is looked at: 1e-6/20 m/s * 6 rad/s."""
    quick, plain = (
        eom.linearise(eom.loads(car(tyre))).without_cyclic().frequency_response(1.0)[0, :, 0]
        for tyre in ("relaxation: 1e-6", "trail: 0")
    )
    np.testing.assert_allclose(quick, plain, rtol=1e-6)


WHEELED = """
name: car on one axle
trim: {speed: 20}
tyres:
  rubber: {per: axle, cornering: 80 kN/rad, longitudinal: 30 kN}
bodies:
  frame: {mass: 900, at: [0, 0, 0.5], inertia: {xx: 300, yy: 900, zz: 900}}
  wheel: {mass: 40, at: [0, 0, 0.3], inertia: {xx: 1.5, yy: 2.5, zz: 1.5}, spin: [0, 20/0.3, 0]}
connectors:
  plane: {type: support, body: frame, at: [0, 0, 0], carries: [z, roll, pitch]}
  straight: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], forces: 1, moments: 0, axis: [0, 1, 0]}
  heading: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], moments: 1, axis: [0, 0, 1]}
  bearing: {type: rigid_point, between: [wheel, frame], at: [0, 0, 0.3], forces: 3, moments: 2, axis: [0, 1, 0]}
  tyre: {type: tyre, body: wheel, at: [0, 0, 0], tyre: rubber}
actuators:
  push: {body: frame, along: [1, 0, 0]}
  brake: {body: wheel, about: [0, 1, 0], reaction_on: frame}
sensors:
  speed: {body: frame, along: [1, 0, 0], measure: velocity}
  spin: {body: wheel, about: [0, 1, 0], measure: velocity}
"""


@pytest.mark.parametrize("frequency", [0.1, 1.0, 20.0])
def test_longitudinal_slip_couples_speed_and_spin(frequency: float) -> None:
    """Force -C_x/U (v - r w) on the contact point; it drives the car by itself and the wheel by -r times it."""
    per_slip, r, mass, spin_inertia = 30e3 / 20.0, 0.3, 940.0, 2.5
    s = 2j * np.pi * frequency
    row = np.array([1.0, -r])
    dynamic = s * np.diag([mass, spin_inertia]) + per_slip * np.outer(row, row)
    model = eom.linearise(eom.loads(WHEELED)).without_cyclic()
    assert len(model.A) == 2
    np.testing.assert_allclose(model.frequency_response(frequency)[0], np.linalg.inv(dynamic), rtol=1e-10)
    roots = np.sort(np.linalg.eigvals(model.A).real)
    np.testing.assert_allclose(roots, [-per_slip * (1 / mass + r**2 / spin_inertia), 0.0], atol=1e-10)


def test_longitudinal_slip_without_a_spinning_wheel_is_refused() -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.loads(CAR.replace("cornering: 80 kN/rad", "cornering: 80 kN/rad, longitudinal: 5 kN"), "car.yaml")
    message = str(caught.value)
    assert "car.yaml:12:" in message
    assert "has longitudinal slip, which needs a wheel: give its body a 'spin'" in message


VERTICAL = """
name: wheel on its tyre
gravity: 10
trim: {speed: 20, hold: true}
tyres:
  rubber: {per: wheel, cornering: 40 kN/rad, vertical_stiffness: 200 kN/m, vertical_damping: 300}
bodies:
  fork: {mass: 10, at: [0, 0, 0.3], inertia: {xx: 1, yy: 1, zz: 1}}
  wheel: {mass: 50, at: [0, 0, 0.3], inertia: {xx: 1, yy: 2, zz: 1}, spin: [0, 20/0.3, 0]}
connectors:
  bearing: {type: rigid_point, between: [wheel, fork], at: [0, 0, 0.3], forces: 3, moments: 2, axis: [0, 1, 0]}
  upright: {type: rigid_point, between: [fork, ground], at: [0, 0, 0.3], moments: 3}
  tyre: {type: tyre, body: wheel, at: [0, 0, 0], tyre: rubber, wheels: 1}
sensors:
  heave: {body: fork, along: [0, 0, 1], measure: position}
actuators:
  lift: {body: fork, along: [0, 0, 1]}
"""


def test_the_preload_of_a_spinning_wheels_tyre_does_not_hold_its_spin() -> None:
    """Heave by itself; the spin is cyclic, its root exactly zero, though the tyre carries 600 N at an arm of 0.3 m."""
    assembly = eom.assemble(eom.loads(VERTICAL))
    assert pytest.approx(np.max(np.abs(assembly.matrices.statics.tensions))) == 600.0
    pitch = assembly.coordinates.index("wheel.pitch")
    for K in (assembly.matrices.K_tangent + assembly.matrices.K_load, assembly.matrices.K_elastic):
        np.testing.assert_array_equal(K[:, pitch], 0.0)
        np.testing.assert_array_equal(K[pitch], 0.0)
    model = eom.linearise(assembly)
    assert "wheel.pitch" in {model.states[k] for k in model.cyclic}
    s = 2j * np.pi * 3.0
    heave = model.without_cyclic().frequency_response(3.0)[0, 0, 0]
    assert heave == pytest.approx(1.0 / (60.0 * s**2 + 300.0 * s + 200e3), rel=1e-10)


def test_vertical_springs_and_dampers_feel_displacement_at_speed() -> None:
    """Heave and pitch of a car on front and rear tyres do not know the speed."""
    file = """
name: ride
trim: {speed: 25, hold: true}
tyres:
  rubber: {per: axle, cornering: 80 kN/rad, vertical_stiffness: 400 kN/m, vertical_damping: 3 kN*s/m}
bodies:
  frame: {mass: 900, at: [0, 0, 0.5], inertia: {xx: 300, yy: 1100, zz: 900}}
connectors:
  plane: {type: rigid_point, between: [frame, ground], at: [0, 0, 0.5], moments: 2, axis: [0, 1, 0]}
  track: {type: rigid_point, between: [frame, ground], at: [0, 0, 0.5], forces: 1, axis: [0, 1, 0]}
  front: {type: tyre, body: frame, at: [1.2, 0, 0.5], tyre: rubber}
  rear: {type: tyre, body: frame, at: [-1.5, 0, 0.5], tyre: rubber, wheels: 1}
"""
    rows = np.array([[1.0, -1.2], [1.0, 1.5]])
    share = np.diag([1.0, 0.5])
    M, k, c = np.diag([900.0, 1100.0]), 400e3 * rows.T @ share @ rows, 3e3 * rows.T @ share @ rows
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, k), -np.linalg.solve(M, c)]])
    model = eom.linearise(eom.loads(file)).without_cyclic()
    found = np.sort_complex(np.linalg.eigvals(model.A))
    np.testing.assert_allclose(found, np.sort_complex(np.linalg.eigvals(A)), rtol=1e-9)
