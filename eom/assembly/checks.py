"""Checks on the numbers of a system, before any algebra: each failure names its object.

A check returns (object, sentence) pairs, so that all of them can be reported at once.
"""

from collections.abc import Iterator

import numpy as np

from eom.assembly.algebra import row_entry
from eom.assembly.elastic import elastic_items
from eom.assembly.inertia import trim_velocity
from eom.assembly.rows import local_rows
from eom.assembly.structure_checks import RELATIVE, TINY, Finding, structure_findings
from eom.assembly.vectors import Array, unit
from eom.vehicle.elements import Body, Connection, Slip, System, Vector

# tables round the moments of thin discs
PUBLISHED = 5e-3
# products of a few numbers beyond this have no value
HUGE = 1e50


def check_system(system: System) -> list[Finding]:
    """Everything that no system may have."""
    if huge := list(check_size(system)):
        return huge
    findings = [finding for body in system.bodies for finding in check_body(body)]
    findings += [finding for item in system.slip for finding in check_slip(item)]
    findings += structure_findings(system)
    geometry = [finding for connection in connections(system) for finding in check_geometry(connection)]
    findings += dict.fromkeys(geometry)
    return findings or list(check_trim(system))


def check_size(system: System) -> Iterator[Finding]:
    """Numbers that can be computed with."""
    joining = (system.constraints, system.elastic, system.slip, system.bushings)
    joined = [(item.connection.name, item) for group in joining for item in group]
    alone = (system.bodies, system.rolling, system.loads, system.inputs, system.outputs, system.beams, system.triangles)
    for name, item in (("gravity", system.gravity), *joined, *((item.name, item) for group in alone for item in group)):
        if (worst := largest(item)) > HUGE:
            yield name, f"one of its numbers is {worst:.3g} in SI units: that is too large to compute with"


def largest(item: object) -> float:
    """The largest absolute number anywhere inside an element."""
    if isinstance(item, float):
        return abs(item)
    worst = 0.0
    if isinstance(item, tuple):
        for part in item:
            worst = max(worst, largest(part))
    return worst


def has_direction(axis: Vector) -> bool:
    """Whether an axis has a length, small numbers squared."""
    return float(np.dot(axis, axis)) > 0.0


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
    if worst < 0.0 and not item.moving:
        yield item.connection.name, f"its coefficient is {worst:g} N s/m: it would push along with the slip"


def check_spin(body: Body, inertia: Array) -> Iterator[Finding]:
    """Only a body that looks the same at every angle about its spin axis moves steadily."""
    spin = np.array(body.spin, dtype=float)
    if not np.any(spin):
        return
    a = unit(spin)
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
        if np.linalg.norm(np.subtract(*connection.places)) < TINY:
            yield connection.name, "its two ends are at the same place: a line needs a length"
        return
    for count, axis in (
        (connection.forces, connection.force_axis),
        (connection.moments, connection.moment_axis),
        (1, connection.rolling_axis or (1.0, 0.0, 0.0)),
    ):
        if count in {1, 2} and not has_direction(axis):
            yield (
                connection.name,
                "its axis has no direction: all of its components are zero, or its ends are at one place",
            )

    rolling, normal = connection.rolling_axis, connection.force_axis
    if rolling is not None and connection.forces == 1 and has_direction(rolling) and has_direction(normal):
        across = np.cross(rolling, normal)
        if np.linalg.norm(across) <= RELATIVE * np.linalg.norm(rolling) * np.linalg.norm(normal):
            yield connection.name, "its rolling axis points along its force: a wheel turns about an axis across that"


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
        ("beam", measured([Connection(item.name, item.bodies, item.places, 1, line=True) for item in system.beams])),
        ("tyre or slip damper", measured([item.connection for item in system.slip if not item.moving])),
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
