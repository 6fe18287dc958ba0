"""Checks on the numbers of a system, before any algebra: each failure names its object.

A check returns (object, sentence) pairs, so that all of them can be reported at once.
"""

from collections.abc import Iterator

import numpy as np

from eom.assembly.algebra import row_entry
from eom.assembly.elastic import elastic_items
from eom.assembly.inertia import trim_velocity
from eom.assembly.rows import local_rows
from eom.assembly.vectors import Array
from eom.vehicle.elements import Beam, Body, Bushing, Connection, Elastic, Slip, System, Triangle

RELATIVE = 1e-9
# tables round the moments of thin discs
PUBLISHED = 5e-3
# axes in a file have some six digits
PERPENDICULAR = 1e-6
Finding = tuple[str, str]


def check_system(system: System) -> list[Finding]:
    """Everything that no system may have."""
    findings = [finding for body in system.bodies for finding in check_body(body)]
    findings += [finding for item in system.slip for finding in check_slip(item)]
    findings += [finding for spring in system.elastic for finding in check_inertance(spring)]
    findings += [finding for bushing in system.bushings for finding in check_bushing(bushing)]
    findings += [finding for beam in system.beams for finding in check_beam(beam)]
    findings += [finding for triangle in system.triangles for finding in check_triangle(triangle)]
    geometry = [finding for connection in connections(system) for finding in check_geometry(connection)]
    findings += dict.fromkeys(geometry)
    return findings or list(check_trim(system))


def check_body(body: Body) -> Iterator[Finding]:
    """A mass that is not negative, an inertia that some distribution of mass has, a spin about its symmetry axis."""
    if body.mass < 0.0:
        yield body.name, f"its mass is {body.mass:g} kg: a mass is not negative"
    inertia = np.array(body.inertia, dtype=float)
    size = float(np.max(np.abs(inertia)))
    if not np.allclose(inertia, inertia.T, rtol=0.0, atol=RELATIVE * size):
        yield body.name, "its inertia tensor is not symmetric"
        return
    # a moment of zero is left out: its rotation is locked, or has no inertia
    present = np.flatnonzero(np.diag(inertia))
    if present.size < 3 and not np.any(np.delete(inertia, present, axis=0)):
        yield from check_spin(body, inertia)
        return
    first, second, third = np.linalg.eigvalsh(inertia)
    if first < -RELATIVE * size or third > (first + second) * (1.0 + PUBLISHED):
        moments = f"{first:.6g}, {second:.6g} and {third:.6g} kg m^2"
        yield body.name, f"no body has principal moments of inertia {moments}: each is at most the sum of the others"
    yield from check_spin(body, inertia)


def check_slip(item: Slip) -> Iterator[Finding]:
    """A tyre or slip damper must oppose sliding; derivatives of a flow have any sign."""
    worst = item.coefficients[0][0]
    if worst < 0.0 and not is_flow(item):
        yield item.connection.name, f"its coefficient is {worst:g} N s/m: it would push along with the slip"


def is_flow(item: Slip) -> bool:
    """Whether a slip element is a flow's derivatives, which count from the trim, and no contact with the ground."""
    return item.connection.forces == 3


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
    if length == 0.0:
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


def check_spin(body: Body, inertia: Array) -> Iterator[Finding]:
    """Only a body that looks the same at every angle about its spin axis moves steadily."""
    spin = np.array(body.spin, dtype=float)
    rate = float(np.linalg.norm(spin))
    if rate == 0.0:
        return
    a = spin / rate
    across = (np.eye(3) - np.outer(a, a)) @ inertia @ (np.eye(3) - np.outer(a, a))
    mean = float(np.trace(across)) / 2.0
    rest = inertia - (a @ inertia @ a) * np.outer(a, a) - mean * (np.eye(3) - np.outer(a, a))
    if np.max(np.abs(rest)) > RELATIVE * float(np.max(np.abs(inertia))):
        yield body.name, "it spins about an axis that is no axis of symmetry of its inertia"


def connections(system: System) -> Iterator[Connection]:
    """Every connection of the system."""
    for group in (system.constraints, system.elastic, system.slip, system.inputs):
        for item in group:
            yield item.connection
    yield from system.rolling
    for output in system.outputs:
        for _, connection in output.terms:
            yield connection._replace(name=connection.name or output.name)


def check_geometry(connection: Connection) -> Iterator[Finding]:
    """Axes with a direction, lines with a length."""
    if connection.line:
        if not np.any(np.subtract(*connection.places)):
            yield connection.name, "its two ends are at the same place: a line needs a length"
        return
    for count, axis in (
        (connection.forces, connection.force_axis),
        (connection.moments, connection.moment_axis),
        (1, connection.rolling_axis or (1.0, 0.0, 0.0)),
    ):
        if count in {1, 2} and not np.any(axis):
            yield (
                connection.name,
                "its axis has no direction: all of its components are zero, or its ends are at one place",
            )


def check_trim(system: System) -> Iterator[Finding]:
    """No joint, spring or tyre may be strained by the steady motion itself."""
    w = trim_velocity(system.bodies)
    size = float(np.max(np.abs(w), initial=0.0))

    def measured(group: list[Connection]) -> list[tuple[str, tuple[int, ...], Array]]:
        return [(item.name, item.bodies, local_rows(system.bodies, item)) for item in group]

    joints = [item.connection for item in system.constraints if not item.moving]
    for kind, items in (
        ("joint", measured([*joints, *system.rolling])),
        ("spring or damper", [(item.name, item.bodies, item.rows) for item in elastic_items(system)]),
        ("tyre or slip damper", measured([item.connection for item in system.slip if not is_flow(item)])),
    ):
        for name, bodies, own in items:
            _, columns, jacobian = row_entry(0, bodies, own)
            rate = jacobian @ w[columns]
            limit = RELATIVE * size * float(np.max(np.abs(jacobian), initial=1.0))
            if np.any(np.abs(rate) > limit):
                worst = float(rate[np.argmax(np.abs(rate))])
                motion = f"its ends move relative to each other at {worst:.6g} (m/s or rad/s) where it acts"
                hint = "; if it shall travel along with the trim, say 'moving: true'" if kind == "joint" else ""
                yield name, f"the trim motion violates this {kind}: {motion}{hint}"
