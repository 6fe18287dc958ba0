"""Torsion springs and torsion links, from the file, against closed forms."""

import numpy as np
import pytest

import eom

SHAFT = """
name: shaft under torque
parameters: {T: 40}
bodies:
  a: {mass: 2, at: [1, 0, 0], inertia: {xx: 0.5, yy: 0.3, zz: 0.3}}
  b: {mass: 2, at: [2, 0, 0], inertia: {xx: 0.5, yy: 0.3, zz: 0.3}}
connectors:
  ball_a: {type: rigid_point, between: [a, ground], at: [1, 0, 0], forces: 3}
  ball_b: {type: rigid_point, between: [b, ground], at: [2, 0, 0], forces: 3}
  tilt_a: {type: flex_point, between: [a, ground], at: [1, 0, 0], moments: 2, axis: [1, 0, 0], angular_stiffness: 90}
  tilt_b: {type: flex_point, between: [b, ground], at: [2, 0, 0], moments: 2, axis: [1, 0, 0], angular_stiffness: 90}
  first: {type: torsion_spring, between: [ground, a], ends: [[0, 0, 0], [1, 0, 0]], stiffness: 70, preload: T}
  second: {type: torsion_spring, between: [a, b], ends: [[1, 0, 0], [2, 0, 0]], stiffness: 50, preload: T}
  third: {type: torsion_spring, between: [b, ground], ends: [[2, 0, 0], [3, 0, 0]], stiffness: 20, preload: T}
"""


def test_torque_couples_the_tilts_of_two_bodies_by_half_of_it() -> None:
    """The relative rotation of two small rotations has a second order of half their cross product.

    So the potential -T a . phi gives T/2 (y_a z_b - z_a y_b) and the tilts' stiffness 90 -+ T/2, each twice.
    Twisting: 70 + 50 and 50 + 20 on the diagonal, -50 beside it.
    """
    assembly = eom.assemble(eom.loads(SHAFT))
    found = np.sort(eom.linearise(assembly).modes().eigenvalues.imag ** 2)[::2]
    tilts = (90.0 + np.array([-20.0, -20.0, 20.0, 20.0])) / 0.3
    twists = np.linalg.eigvalsh(np.array([[120.0, -50.0], [-50.0, 70.0]]) / 0.5)
    np.testing.assert_allclose(found, np.sort([*tilts, *twists]), rtol=1e-9)
    T, K = assembly.reduction.T, assembly.K
    stiffness = T.T @ K @ T
    np.testing.assert_allclose(stiffness, stiffness.T, atol=1e-12 * np.max(stiffness))


def test_a_given_torque_is_handed_on_and_one_that_contradicts_is_refused() -> None:
    open_end = SHAFT.replace("stiffness: 20, preload: T", "stiffness: 20")
    tensions = eom.assemble(eom.loads(open_end)).matrices.statics.tensions
    np.testing.assert_allclose(tensions[-3:], 40.0, rtol=1e-12)
    wrong = SHAFT.replace("stiffness: 20, preload: T", "stiffness: 20, preload: -T")
    with pytest.raises(eom.EquilibriumError, match=r"a moment about x of .*80 N m remains on b"):
        eom.assemble(eom.loads(wrong))


def test_twisting_springs_dampers_and_inerters_act_on_relative_rotation() -> None:
    """Two flywheels of 3 and 4 kg m^2: k + c s + b s^2 between them."""
    file = """
name: flywheels
bodies:
  left: {mass: 1, at: [0, 0, 0], inertia: {xx: 3, yy: 2, zz: 2}}
  right: {mass: 1, at: [0, 1, 0], inertia: {xx: 4, yy: 3, zz: 3}}
connectors:
  bearing_left: {type: rigid_point, between: [left, ground], at: [0, 0, 0], forces: 3, moments: 2, axis: [1, 0, 0]}
  bearing_right: {type: rigid_point, between: [right, ground], at: [0, 1, 0], forces: 3, moments: 2, axis: [1, 0, 0]}
  shaft:
    type: torsion_spring
    between: [left, right]
    ends: [[0, 0.5, 0], [2, 0.5, 0]]
    stiffness: 5
    damping: 0.4
    inertance: 0.7
actuators: {twist: {body: right, about: [1, 0, 0]}}
sensors: {angle: {body: left, about: [1, 0, 0], measure: position}}
"""
    s = 2j * np.pi * 0.3
    pair = np.array([[1.0, -1.0], [-1.0, 1.0]])
    dynamic = s**2 * np.diag([3.0, 4.0]) + (0.7 * s**2 + 0.4 * s + 5.0) * pair
    found = eom.linearise(eom.loads(file)).frequency_response(0.3)[0, 0, 0]
    assert found == pytest.approx(np.linalg.inv(dynamic)[0, 1], rel=1e-10)


def test_a_torsion_link_hands_on_moment_and_turns_both_alike() -> None:
    file = """
name: shaft
bodies:
  wheel: {mass: 1, at: [0, 0, 0], inertia: {xx: 3, yy: 2, zz: 2}}
  crank: {mass: 1, at: [1, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}
connectors:
  b_wheel: {type: rigid_point, between: [wheel, ground], at: [0, 0, 0], forces: 3, moments: 2, axis: [1, 0, 0]}
  b_crank: {type: rigid_point, between: [crank, ground], at: [1, 0, 0], forces: 3, moments: 2, axis: [1, 0, 0]}
  shaft: {type: torsion_link, between: [crank, wheel], ends: [[1, 0, 0], [0, 0, 0]]}
  hold: {type: torsion_spring, between: [wheel, ground], ends: [[0, 0, 0], [-1, 0, 0]], stiffness: 64}
loads:
  torque: {body: crank, moment: [6, 0, 0]}
sensors:
  angle: {body: crank, relative_to: wheel, about: [1, 0, 0], measure: position}
"""
    assembly = eom.assemble(eom.loads(file))
    # about the line from crank to wheel, along -x: the link holds the crank back by +6 about it
    assert assembly.matrices.statics.reactions[-1] == pytest.approx(6.0, rel=1e-12)
    model = eom.linearise(assembly)
    np.testing.assert_allclose(model.C, 0.0, atol=1e-15)
    assert np.max(model.modes().eigenvalues.imag) == pytest.approx(np.sqrt(64.0 / 4.0), rel=1e-12)
