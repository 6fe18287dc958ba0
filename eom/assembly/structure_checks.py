"""Checks on the numbers of inerters, bushings, beams, membranes and added mass."""

from collections.abc import Iterator

import numpy as np

from eom.vehicle.elements import Beam, Bushing, Elastic, Slip, System, Triangle

RELATIVE = 1e-9
# axes in a file have some six digits
PERPENDICULAR = 1e-6
# a line below this has no direction [m]
TINY = 1e-9
Finding = tuple[str, str]


def structure_findings(system: System) -> list[Finding]:
    """What no inerter, bushing, beam, membrane or added mass may be."""
    findings = [finding for spring in system.elastic for finding in check_inertance(spring)]
    findings += [finding for bushing in system.bushings for finding in check_bushing(bushing)]
    findings += [finding for beam in system.beams for finding in check_beam(beam)]
    findings += [finding for triangle in system.triangles for finding in check_triangle(triangle)]
    return findings + [finding for item in system.slip for finding in check_added_mass(item)]


def check_inertance(item: Elastic) -> Iterator[Finding]:
    """An inerter that is a mass."""
    if min(item.inertance) < 0.0:
        yield item.connection.name, f"its inertance is {min(item.inertance):g}: an inertance is not negative"


def check_bushing(item: Bushing) -> Iterator[Finding]:
    """Two perpendicular axes, and matrices that a potential and a rate of loss have."""
    name, (first, second) = item.connection.name, np.array(item.axes, dtype=float)
    lengths = float(np.linalg.norm(first)), float(np.linalg.norm(second))
    if min(lengths) == 0.0:
        yield name, "one of its axes has no direction: all of its components are zero"
    elif abs(first @ second) > PERPENDICULAR * lengths[0] * lengths[1]:
        angle = np.degrees(np.arccos(np.clip(first @ second / (lengths[0] * lengths[1]), -1.0, 1.0)))
        yield name, f"its two axes make an angle of {angle:.6g} deg: give perpendicular ones"
    for word, values in (("stiffness", item.stiffness), ("damping", item.damping)):
        matrix = np.array(values, dtype=float)
        wrong = np.abs(matrix - matrix.T) > RELATIVE * np.max(np.abs(matrix))
        if np.any(wrong):
            r, c = (int(k) for k in np.argwhere(wrong)[0])
            entries = f"row {r + 1}, column {c + 1} is {matrix[r, c]:g}, row {c + 1}, column {r + 1} {matrix[c, r]:g}"
            yield name, f"its {word} is not symmetric: {entries}"


def check_beam(item: Beam) -> Iterator[Finding]:
    """A line with a length, a normal across it, a section that resists and weighs something or nothing."""
    span, normal = np.subtract(item.places[1], item.places[0]), np.array(item.normal, dtype=float)
    length, size = float(np.linalg.norm(span)), float(np.linalg.norm(normal))
    if length < TINY:
        yield item.name, "its two ends are at the same place: a beam needs a length"
    elif size == 0.0:
        yield item.name, "its normal has no direction: all of its components are zero"
    elif float(np.linalg.norm(np.cross(span, normal))) <= RELATIVE * length * size:
        yield item.name, "its normal points along the beam: give one across it"
    for word, value, unit in (
        ("bending stiffness", min(item.bending), "N m^2"),
        ("mass per length", item.mass_per_length, "kg/m"),
    ):
        if value < 0.0:
            yield item.name, f"its {word} is {value:g} {unit}: it is not negative"


def check_triangle(item: Triangle) -> Iterator[Finding]:
    """Corners that span a plane, a sheet that is there, a material that exists."""
    first, second = np.subtract(item.places[1:], item.places[0])
    size = float(np.linalg.norm(first) * np.linalg.norm(second))
    if float(np.linalg.norm(np.cross(first, second))) <= RELATIVE * size:
        yield item.name, "its corners lie on one line: a triangle needs an area"
    for word, value, unit in (("thickness", item.thickness, "m"), ("modulus", item.modulus, "Pa")):
        if value <= 0.0:
            yield item.name, f"its {word} is {value:g} {unit}: it is more than zero"
    if not -1.0 < item.poisson <= 0.5:
        yield item.name, f"its Poisson's ratio is {item.poisson:g}: that of a material lies between -1 and 0.5"


def check_added_mass(item: Slip) -> Iterator[Finding]:
    """An added mass whose energy is not negative."""
    mass = np.array(item.added_mass, dtype=float)
    if mass.size:
        energies = np.linalg.eigvalsh(mass + mass.T) / 2.0
        if energies[0] < -RELATIVE * np.max(np.abs(energies)):
            yield item.connection.name, f"its added mass has a principal value of {energies[0]:.6g}: none is negative"
