"""Numbers that no beam, membrane, bushing or inerter can have are refused by name."""

import pytest

import eom

FILE = """\
name: parts
trim: {speed: 10}
bodies:
  a: {mass: 1, at: [0, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
  b: {mass: 1, at: [1, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
  c: {mass: 1, at: [0, 1, 1], inertia: {xx: 1, yy: 1, zz: 1}}
connectors:
  part: {PART}
"""
BEAM = "type: beam, between: [a, b], ends: [[0,0,0],[1,0,0]], bending: [1,1], normal: [0,1,0]"
SKIN = "type: triangle, between: [a,b,c], corners: [[0,0,0],[1,0,0],[0,1,0]], thickness: 1, modulus: 1, poisson: 0.3"
UNIT = "[[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]"
BUSH = f"type: bushing, between: [a, b], at: [0,0,0], axes: [[1,0,0],[0,1,0]], stiffness: {UNIT}"
FLUID = f"type: aero, body: a, at: [0,0,0], added_mass: {UNIT}"
SPRING = "type: spring, between: [a, b], ends: [[0,0,0],[0,1,0]], stiffness: 3, inertance: 2"


def test_the_parts_themselves_are_accepted() -> None:
    for part in (BEAM, SKIN, BUSH, FLUID, SPRING):
        eom.linearise(eom.loads(FILE.replace("PART", part)))


@pytest.mark.parametrize(
    ("part", "old", "new", "sentence"),
    [
        (BEAM, "[1,0,0]]", "[0,0,0]]", "its two ends are at the same place: a beam needs a length"),
        (BEAM, "[0,1,0]", "[2,0,0]", "its normal points along the beam: give one across it"),
        (BEAM, "[1,1]", "[-1,1]", "its bending stiffness is -1 N m^2: it is not negative"),
        (BEAM, "[1,1]", "[1,1], mass_per_length: -3", "its mass per length is -3 kg/m: it is not negative"),
        (SKIN, "[0,1,0]]", "[2,0,0]]", "its corners lie on one line: a triangle needs an area"),
        (SKIN, "thickness: 1", "thickness: 0", "its thickness is 0 m: it is more than zero"),
        (SKIN, "modulus: 1", "modulus: -1", "its modulus is -1 Pa: it is more than zero"),
        (SKIN, "0.3", "1", "its Poisson's ratio is 1: that of a material lies between -1 and 0.5"),
        (SKIN, "[a,b,c]", "[a,b,ground]", "the trim motion violates this spring or damper: its ends move"),
        (BUSH, "[0,1,0]]", "[3,0,0]]", "its two axes make an angle of 0 deg: give perpendicular ones"),
        (BUSH, "[[1,0,0,0,0,0]", "[[1,0,4,0,0,0]", "its stiffness is not symmetric: row 1, column 3 is 4"),
        (BUSH, "[a, b]", "[a, ground]", "the trim motion violates this spring or damper: its ends move"),
        (FLUID, "[[1,", "[[-9,", "its added mass has a principal value of -9: none is negative"),
        (SPRING, "inertance: 2", "inertance: -2", "its inertance is -2: an inertance is not negative"),
    ],
)
def test_impossible_parts_are_named_with_their_place(part: str, old: str, new: str, sentence: str) -> None:
    assert old in part
    with pytest.raises(eom.DescriptionError) as caught:
        eom.assemble(eom.loads(FILE.replace("PART", part.replace(old, new)), "parts.yaml"))
    assert f"parts.yaml:8:3: connectors.part: {sentence}" in str(caught.value)


def test_air_may_push_along_and_a_tyre_may_not() -> None:
    """A derivative of either sign is a fact of the air; a negative slip damper is a mistake."""
    along = FLUID.replace("added_mass", "damping").replace("[[1,", "[[-9,")
    eom.linearise(eom.loads(FILE.replace("PART", along)))
