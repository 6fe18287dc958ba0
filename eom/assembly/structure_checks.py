"""Checks on the numbers of beams, membranes and bushings, and on what is strained by the trim."""

from collections.abc import Iterator

import numpy as np

from eom.assembly.algebra import moving_columns
from eom.assembly.elastic import elastic_items
from eom.assembly.vectors import Array
from eom.vehicle.elements import Beam, Bushing, Elastic, Slip, System, Triangle

RELATIVE = 1e-9
Finding = tuple[str, str]


def structure_findings(system: System) -> list[Finding]:
    """What no beam, membrane, bushing or inerter may be."""
    findings = [finding for beam in system.beams for finding in check_beam(beam)]
    findings += [finding for triangle in system.triangles for finding in check_triangle(triangle)]
    findings += [finding for bushing in system.bushings for finding in check_bushing(bushing)]
    findings += [finding for item in system.slip for finding in check_added_mass(item)]
    return findings + [finding for item in system.elastic for finding in check_inertance(item)]


def check_beam(beam: Beam) -> Iterator[Finding]:
    """A length, a normal that leans away from the line, stiffness and mass that are not negative."""
    span, normal = np.subtract(beam.places[1], beam.places[0]), np.array(beam.normal, dtype=float)
    if not np.any(span):
        yield beam.name, "its two ends are at the same place: a beam needs a length"
    elif parallel(span, normal):
        yield beam.name, "its normal does not point away from its line: give an axis across the beam"
    if min(beam.bending) < 0.0:
        yield beam.name, f"its bending stiffness is {min(beam.bending):g} N m^2: it is not negative"
    if beam.mass_per_length < 0.0:
        yield beam.name, f"its mass per length is {beam.mass_per_length:g} kg/m: a mass is not negative"


def check_triangle(triangle: Triangle) -> Iterator[Finding]:
    """An area, and a material that resists strain."""
    a, b, c = (np.array(place, dtype=float) for place in triangle.places)
    if parallel(b - a, c - a) or not np.any(c - b):
        yield triangle.name, "its corners are on one line: a triangle needs an area"
    for what, value, unit in (
        ("thickness", triangle.thickness, "m"),
        ("modulus", triangle.modulus, "Pa"),
    ):
        if value <= 0.0:
            yield triangle.name, f"its {what} is {value:g} {unit}: it must be positive"
    if not -1.0 < triangle.poisson <= 0.5:
        yield triangle.name, f"its Poisson's ratio is {triangle.poisson:g}: it lies above -1 and is at most 0.5"


def check_bushing(bushing: Bushing) -> Iterator[Finding]:
    """Two axes that span a plane, matrices of a potential."""
    first, second = (np.array(axis, dtype=float) for axis in bushing.axes)
    if parallel(first, second):
        yield bushing.connection.name, "its two axes do not span a plane: give two that are normal to each other"
    for name in ("stiffness", "damping"):
        matrix = np.array(getattr(bushing, name), dtype=float)
        if np.max(np.abs(matrix - matrix.T)) > RELATIVE * np.max(np.abs(matrix)):
            r, c = (int(k) + 1 for k in np.unravel_index(int(np.argmax(np.abs(matrix - matrix.T))), matrix.shape))
            yield bushing.connection.name, f"its {name} is not symmetric: rows {r} and {c} differ"


def check_inertance(item: Elastic) -> Iterator[Finding]:
    """An inertance that is not negative."""
    if min(item.inertance) < 0.0:
        yield item.connection.name, f"its inertance is {min(item.inertance):g}: it is not negative"


def check_added_mass(item: Slip) -> Iterator[Finding]:
    """An added mass whose energy is not negative."""
    mass = np.array(item.added_mass, dtype=float)
    if mass.size:
        energies = np.linalg.eigvalsh(mass + mass.T) / 2.0
        if energies[0] < -RELATIVE * np.max(np.abs(energies)):
            yield item.connection.name, f"its added mass has a principal value of {energies[0]:.6g}: none is negative"


def parallel(a: Array, b: Array) -> bool:
    """Whether two vectors span no plane."""
    return float(np.linalg.norm(np.cross(a, b))) <= RELATIVE * float(np.linalg.norm(a) * np.linalg.norm(b))


def strained_by(system: System, w: Array) -> Iterator[tuple[str, float]]:
    """Elastic items that a steady motion, shape (6 n,), strains, with the largest rate."""
    size = float(np.max(np.abs(w), initial=0.0))
    for item in elastic_items(system):
        columns, local = moving_columns(item.bodies)
        rows = item.rows[:, local]
        rate = rows @ w[columns]
        limit = RELATIVE * size * np.max(np.abs(rows), axis=1, initial=0.0)
        if np.any(np.abs(rate) > limit):
            yield item.name, float(rate[np.argmax(np.abs(rate))])
