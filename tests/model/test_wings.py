"""Wings, added mass and control surfaces, from the file, against closed forms."""

import numpy as np
import pytest

import eom

m, I_yy, I_xx, U, S, c, b, rho, x = 800.0, 1200.0, 900.0, 50.0, 16.0, 1.6, 10.0, 1.1, -0.4
PLANE = """
name: aeroplane
trim: {speed: 50}
bodies:
  frame: {mass: 800, at: [0, 0, 0], inertia: {xx: 900, yy: 1200, zz: 1900}}
connectors:
  hold: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], forces: 1, axis: [1, 0, 0], moving: true}
  side: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], forces: 1, axis: [0, 1, 0]}
  heading: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], moments: 1, axis: [0, 0, 1]}
  wing:
    type: wing
    body: frame
    at: [-0.4, 0, 0]
    area: 16
    span: 10
    chord: 1.6
    density: 1.1
    derivatives: {z_w: -5.1, z_q: 7.0, m_w: 0.3, m_q: -12.0, l_p: -0.5}
  elevator:
    type: control_surface
    body: frame
    at: [-4, 0, 0]
    area: 3
    span: 4
    chord: 0.8
    density: 1.1
    derivatives: {z: -2.0, m: 0.4, l: 0.1}
ADDED
sensors:
  w: {body: frame, along: [0, 0, 1], measure: velocity, frame: body}
  q: {body: frame, about: [0, 1, 0], measure: velocity, frame: body}
  p: {body: frame, about: [1, 0, 0], measure: velocity, frame: body}
"""


def matrices(added: float, at: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M, minus the derivatives, and the elevator's column for (w, q), z up and pitch positive nose down.

    m (dw/dt - U q) = Z and I dq/dt = M - x Z, with the wing's w - x q at its place; added mass meets d(w - a q)/dt.
    """
    Q = 0.5 * rho * U**2 * S
    local = Q * np.array([[-5.1 / U, 7.0 * c / (2 * U)], [c * 0.3 / U, -12.0 * c**2 / (2 * U)]])
    to_place = np.array([[1.0, -x], [0.0, 1.0]])
    derivatives = to_place.T @ local @ to_place
    row = np.array([1.0, -at])
    M = np.diag([m, I_yy]) + added * np.outer(row, row)
    elevator = 0.5 * rho * U**2 * 3.0
    force, moment = -2.0 * elevator, 0.4 * 0.8 * elevator
    return M, derivatives + np.array([[0.0, m * U], [0.0, 0.0]]), np.array([force, moment + 4.0 * force])


@pytest.mark.parametrize(("added", "at"), [(0.0, 0.0), (90.0, 0.7)])
@pytest.mark.parametrize("frequency", [0.02, 0.4, 3.0])
def test_heave_and_pitch_follow_the_derivatives(frequency: float, added: float, at: float) -> None:
    """No term of the added mass with speed: it is on the rate of the velocity in body axes, as the file says."""
    rows = [[0.0] * 6 for _ in range(6)]
    rows[2][2] = added
    extra = f"  fluid: {{type: aero, body: frame, at: [{at}, 0, 0], added_mass: {rows}}}" if added else ""
    model = eom.linearise(eom.loads(PLANE.replace("ADDED", extra))).without_cyclic()
    M, A, elevator = matrices(added, at)
    expected = np.linalg.solve(2j * np.pi * frequency * M - A, elevator)
    found = model.frequency_response(frequency)[0, :2, 0]
    np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_roll_subsides_by_the_wings_damping() -> None:
    """I dp/dt = q S b (l_p p b/(2 U) + l deflection), with the elevator's own area and span."""
    model = eom.linearise(eom.loads(PLANE.replace("ADDED", ""))).without_cyclic()
    rate = 0.5 * rho * U**2 * S * b * -0.5 * b / (2 * U) / I_xx
    gain = 0.5 * rho * U**2 * 3.0 * 4.0 * 0.1 / I_xx
    found = model.frequency_response(0.3)[0, 2, 0]
    assert found == pytest.approx(gain / (2j * np.pi * 0.3 - rate), rel=1e-9)


def test_an_airspeed_of_its_own_stands_for_the_trims() -> None:
    """Wind against a car: the derivatives count by the speed of the air, the rest by that of the body."""
    own = PLANE.replace("ADDED", "").replace("    density: 1.1\n", "    density: 1.1\n    speed: 70\n")
    one, other = (eom.assemble(eom.loads(file)) for file in (own, PLANE.replace("ADDED", "")))
    # half rho U S per velocity, half rho U^2 S per radian
    np.testing.assert_allclose(one.matrices.D_slip, other.matrices.D_slip * 70 / 50, rtol=1e-13)
    np.testing.assert_allclose(one.matrices.F, other.matrices.F * (70 / 50) ** 2, rtol=1e-13)


def test_a_full_matrix_is_the_wing_written_out() -> None:
    """The wing's table as an `aero` of 6 by 6: rows X to N, columns u to r, with the sign of damping."""
    q = 0.5 * rho * U * S
    rows = [[0.0] * 6 for _ in range(6)]
    rows[2][2], rows[2][4] = 5.1 * q, -7.0 * q * c / 2
    rows[4][2], rows[4][4] = -0.3 * q * c, 12.0 * q * c * c / 2
    rows[3][3] = 0.5 * q * b * b / 2
    start, end = PLANE.index("  wing:"), PLANE.index("  elevator:")
    full = PLANE[:start] + f"  wing: {{type: aero, body: frame, at: [-0.4, 0, 0], damping: {rows}}}\n" + PLANE[end:]
    one, other = (eom.assemble(eom.loads(file.replace("ADDED", ""))).C for file in (PLANE, full))
    np.testing.assert_allclose(one, other, rtol=1e-13, atol=1e-9)
