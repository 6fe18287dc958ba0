"""Inerters and given preloads, from the file, against closed forms."""

import numpy as np
import pytest

import eom
from eom.vehicle.elements import GROUND, Constraint, Elastic
from tests.assembly.systems import EMPTY, Complex, Y, Z, body, diagonal, linear, measure, point, push, transfer

QUARTER = """
name: quarter car with an inerter
bodies:
  sprung: {mass: 300, at: [0, 0, 1]}
  unsprung: {mass: 40, at: [0, 0, 0.4]}
connectors:
  guide: {type: rigid_point, between: [sprung, ground], at: [0, 0, 1], forces: 2, moments: 3, axis: [0, 0, 1]}
  slide: {type: rigid_point, between: [unsprung, ground], at: [0, 0, 0.4], forces: 2, moments: 3, axis: [0, 0, 1]}
  strut:
    type: spring
    between: [sprung, unsprung]
    ends: [[0, 0, 1], [0, 0, 0.4]]
    stiffness: 20 kN/m
    damping: 1200
    inertance: 60
  tyre: {type: spring, between: [unsprung, ground], ends: [[0, 0, 0.4], [0, 0, 0]], stiffness: 180 kN/m}
actuators:
  body_push: {body: sprung, along: [0, 0, 1]}
  wheel_push: {body: unsprung, along: [0, 0, 1]}
sensors:
  body: {body: sprung, along: [0, 0, 1], measure: position}
  wheel: {body: unsprung, along: [0, 0, 1], measure: position}
"""


def response(model: eom.LinearModel, frequency: float) -> Complex:
    """Frequency response at one frequency [Hz]."""
    found: Complex = model.frequency_response(frequency)[0]
    return found


@pytest.mark.parametrize("frequency", [0.1, 1.3, 11.0])
def test_a_quarter_car_with_an_inerter_has_the_closed_forms_response(frequency: float) -> None:
    """Mass, damping and stiffness matrices of two masses; b stands in the first as c in the second."""
    s = 2j * np.pi * frequency
    strut = np.array([[1.0, -1.0], [-1.0, 1.0]])
    dynamic = s**2 * (np.diag([300.0, 40.0]) + 60.0 * strut) + s * 1200.0 * strut + 20e3 * strut + np.diag([0.0, 180e3])
    found = response(eom.linearise(eom.loads(QUARTER)), frequency)
    # the same two equations
    np.testing.assert_allclose(found, np.linalg.inv(dynamic), rtol=1e-11)


@pytest.mark.parametrize("U", [0.0, 35.0])
@pytest.mark.parametrize("s", [0.0, 3.0j, 1.0 + 9.0j])
def test_an_inerter_feels_the_second_rate_of_displacement_at_any_speed(s: complex, U: float) -> None:
    """Heave and pitch on an inerter, spring and damper at x = a: the speed along x changes nothing.

    On the rate of the velocity in body axes instead it would make a term b U q.
    """
    m, inertia, a, k, c, b = 12.0, 5.0, 0.8, 900.0, 30.0, 7.0
    place = (a, 0.0, 0.0)
    moving = body("car", mass=m, inertia=diagonal(1.0, inertia, 1.0), velocity=(U, 0.0, 0.0))
    leg = point((0, GROUND), place, forces=1, axis=Z)
    centre = point((0, GROUND), (0.0, 0.0, 0.0), forces=1, moments=1, axis=Z, name="stand")._replace(moment_axis=Y)
    guides = (
        Constraint(point((0, GROUND), (0.0, 0.0, 0.0), forces=2, axis=Z), moving=True),
        Constraint(point((0, GROUND), (0.0, 0.0, 0.0), moments=2, axis=Y)),
    )
    system = EMPTY._replace(
        bodies=(moving,),
        constraints=guides,
        elastic=(Elastic(leg, (k, 0.0), (c, 0.0), (b, 0.0)), Elastic(centre, (50.0, 20.0), (0.0, 0.0))),
        inputs=(push(0, place, Z),),
        outputs=(measure(0, place, Z), measure(0, (0.0, 0.0, 0.0), Z, "acceleration")),
    )
    row = np.array([1.0, -a])
    dynamic = s**2 * np.diag([m, inertia]) + np.diag([50.0, 20.0]) + (b * s**2 + c * s + k) * np.outer(row, row)
    motion = np.linalg.solve(dynamic, row)
    found = transfer(linear(system).model, s)[:, 0]
    np.testing.assert_allclose(found, [row @ motion, s**2 * motion[0]], rtol=1e-10, atol=1e-14)


STRING = """
name: bead on a string
bodies:
  bead: {mass: 0.02, at: [0, 0, 0]}
connectors:
  upright: {type: rigid_point, between: [bead, ground], at: [0, 0, 0], moments: 3}
  left: {type: spring, between: [bead, ground], ends: [[0, 0, 0], [-0.5, 0, 0]], stiffness: 4 kN/m, preload: 30}
  right: {type: spring, between: [ground, bead], ends: [[0.3, 0, 0], [0, 0, 0]], stiffness: 1 kN/m}
"""


def frequencies(text: str) -> np.ndarray:
    """Natural frequencies [rad/s], sorted."""
    found = eom.linearise(eom.loads(text)).modes().eigenvalues
    return np.sort(found.imag[found.imag > 0.0])


def test_a_given_tension_makes_a_string() -> None:
    """Sideways stiffness T/L of each side; along it the springs. The other side's tension follows by statics."""
    sideways = np.sqrt(30.0 * (1 / 0.5 + 1 / 0.3) / 0.02)
    np.testing.assert_allclose(frequencies(STRING), [sideways, sideways, np.sqrt(5000.0 / 0.02)], rtol=1e-12)


def test_both_tensions_given_alike_change_nothing() -> None:
    both = STRING.replace("stiffness: 1 kN/m}", "stiffness: 1 kN/m, preload: 30}")
    assert both != STRING
    np.testing.assert_allclose(frequencies(both), frequencies(STRING), rtol=1e-14)


def test_a_preload_without_stiffness_is_a_constant_tension() -> None:
    """Weight over a pulley: only the other spring acts along the string."""
    constant = STRING.replace("stiffness: 4 kN/m, ", "")
    assert frequencies(constant)[-1] == pytest.approx(np.sqrt(1000.0 / 0.02), rel=1e-12)


@pytest.mark.parametrize("other", [29.9, -30.0])
def test_preloads_that_contradict_are_not_in_equilibrium(other: float) -> None:
    wrong = STRING.replace("stiffness: 1 kN/m}", f"stiffness: 1 kN/m, preload: {other}}}")
    with pytest.raises(eom.EquilibriumError) as caught:
        eom.assemble(eom.loads(wrong, "string.yaml"))
    remains = f"{other - 30:.6g} N remains on bead"
    assert f"string.yaml:4:3: bodies.bead: not in equilibrium: a force along x of {remains}" in str(caught.value)


def test_in_an_indeterminate_structure_the_given_one_keeps_its_load_and_the_others_share_the_rest() -> None:
    """A weight of 100 N on three upright springs, one given: the two others by their stiffness."""
    file = """
name: three springs
gravity: 10
bodies: {load: {mass: 10, at: [0, 0, 0]}}
connectors:
  guide: {type: rigid_point, between: [load, ground], at: [0, 0, 0], forces: 2, moments: 3, axis: [0, 0, 1]}
  a: {type: spring, between: [load, ground], ends: [[0, 0, 0], [0, 0, 1]], stiffness: 500, preload: 40}
  b: {type: spring, between: [load, ground], ends: [[0.1, 0, 0], [0.1, 0, 1]], stiffness: 100}
  c: {type: spring, between: [load, ground], ends: [[-0.1, 0, 0], [-0.1, 0, 1]], stiffness: 500}
"""
    found = eom.assemble(eom.loads(file)).matrices.statics
    np.testing.assert_allclose(found.tensions, [40.0, 10.0, 50.0], rtol=1e-12)
    assert not found.determinate
