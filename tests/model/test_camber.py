"""Camber thrust: minus its stiffness times the lean of the wheel, by closed forms and laws."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import eom
from eom.assembly.matrices import assemble_matrices
from eom.vehicle.elements import GROUND, Slip
from tests.assembly.systems import EMPTY, X, Y, body, linear, moved, pivots_of, point, tensor

m, C, camber, sigma, U, r = 12.0, 900.0, 150.0, 0.3, 7.0, 0.35
WHEEL = f"""
name: a wheel that slides sideways and leans about its contact point
trim: {{speed: U, hold: true}}
parameters: {{U: {U}}}
bodies:
  wheel: {{mass: {m}, at: [0, 0, 0], inertia: {{xx: 1, yy: 1, zz: 1}}}}
connectors:
  road: {{type: support, body: wheel, at: [0, 0, 0], carries: [z, pitch]}}
  heading: {{type: rigid_point, between: [wheel, ground], at: [0, 0, 0], moments: 1, axis: [0, 0, 1]}}
  contact: {{type: tyre, body: wheel, at: [0, 0, 0], tyre: tyre, wheels: 1}}
tyres:
  tyre: {{per: wheel, cornering: {C}, camber: {camber}}}
actuators:
  moment: {{body: wheel, about: [1, 0, 0]}}
sensors:
  side: {{body: wheel, along: [0, 1, 0], measure: position}}
  lean: {{body: wheel, about: [1, 0, 0], measure: position}}
"""


@pytest.mark.parametrize("length", [0.0, sigma])
@pytest.mark.parametrize("s", [0.4j, 6.0j, 2.0 + 30.0j])
def test_a_wheel_that_leans_to_the_right_is_pushed_to_the_right_with_the_tyres_lag(length: float, s: complex) -> None:
    """Newton: m y'' = F with F + (sigma/U) F' = -C y'/U - camber lean: the lag is that of the side force of slip."""
    file = WHEEL.replace(f"camber: {camber}", f"camber: {camber}, relaxation: {length}") if length else WHEEL
    model = eom.linearise(eom.loads(file))
    # place and heading are cyclic, but not where the frequency is not zero
    answer = model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B) + model.D
    side, lean = answer[:, 0]
    lag = 1.0 + s * length / U
    expected = -camber / lag / (m * s**2 + C * s / U / lag)
    # one linear solve of four or five unknowns
    assert side / lean == pytest.approx(expected, rel=1e-12)


def test_camber_stiffness_per_axle_and_per_wheel_count_the_wheels() -> None:
    def stiffness(tyre: str, wheels: int) -> float:
        file = WHEEL.replace(f"per: wheel, cornering: {C}, camber: {camber}", tyre)
        return float(eom.assemble(eom.loads(file.replace("wheels: 1", f"wheels: {wheels}"))).matrices.K_camber[1, 3])

    assert stiffness("per: wheel, cornering: 1, camber: 150", 1) == 150.0
    assert stiffness("per: wheel, cornering: 1, camber: 150", 2) == 300.0
    assert stiffness("per: axle, cornering: 1, camber: 150", 2) == 150.0
    assert stiffness("per: axle, cornering: 1, camber: 150", 1) == 75.0


def test_camber_thrust_acts_at_the_contact_point_and_has_no_aligning_moment() -> None:
    """At an arm r below the centre the force to the right turns the wheel over to the left: K[roll, roll] = C r."""
    file = WHEEL.replace("at: [0, 0, 0], inertia", f"at: [0, 0, {r}], inertia").replace(
        "per: wheel", "per: wheel, trail: 0.05"
    )
    K = eom.assemble(eom.loads(file)).matrices.K_camber
    expected = np.zeros((6, 6))
    expected[1, 3], expected[3, 3] = camber, camber * r
    np.testing.assert_allclose(K, expected, rtol=1e-15)


def test_a_file_without_camber_has_the_stiffness_that_it_had() -> None:
    assembly = eom.assemble(eom.loads(WHEEL.replace(f", camber: {camber}", "")))
    assert not np.any(assembly.matrices.K_camber)


def leaning() -> tuple[Slip, Slip]:
    """Camber thrust between two bodies, about an axis of its own, and on the ground."""
    return (
        Slip(
            point((0, 1), (0.2, 0.1, -0.3), 1, 1, X, "pair"), ((3.0, 0.0), (0.0, 5.0)), (), (2.0, -1.5), (0.8, 0.1, 0.6)
        ),
        Slip(point((1, GROUND), (0.0, 0.4, -0.2), 1, 0, Y, "road"), ((4.0,),), (), (7.0,)),
    )


def test_camber_between_two_bodies_is_by_their_relative_turn_and_acts_on_both() -> None:
    """A turn of both about the axis changes nothing, and the forces on the two add up to nothing."""
    system = EMPTY._replace(bodies=(body("one"), body("two", (0.3, 0.2, 0.1))), slip=leaning()[:1])
    K = assemble_matrices(system, pivots_of(system)).K_camber
    together = np.tile(np.eye(6)[:, 3:], (2, 1))
    assert np.any(K)
    np.testing.assert_allclose(K @ together, 0.0, atol=1e-15)
    np.testing.assert_allclose(K[:3] + K[6:9], 0.0, atol=1e-15)


@pytest.mark.parametrize("hand", [1.0, -1.0])
def test_turning_or_mirroring_the_drawing_with_its_camber_axes_changes_no_root(hand: float) -> None:
    """The axis of lean is an axial vector: a mirror turns it round once more, as it does the force."""
    inertia = tensor(np.diag([1.0, 1.4, 1.7]))
    system = EMPTY._replace(
        bodies=(body("one", inertia=inertia), body("two", (0.3, 0.2, 0.1), 2.0, inertia)),
        slip=leaning(),
    )
    rotation = Rotation.from_euler("zyx", [37.0, 20.0, -11.0], degrees=True).as_matrix() @ np.diag([1.0, hand, 1.0])
    s = 0.7 + 1.3j
    sizes = []
    for item in (system, moved(system, rotation, np.array([1.0, -2.0, 3.0]))):
        A = linear(item).model.A
        sizes.append(np.linalg.det(s * np.eye(len(A)) - A))
    # two determinants of 24 rows
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-11)
