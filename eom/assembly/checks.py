"""Checks on the numbers of a system, before any algebra: each failure names its object.

A check returns (object, sentence) pairs, so that all of them can be reported at once.
"""

from collections.abc import Iterator

import numpy as np

from eom.assembly.algebra import row_entry
from eom.assembly.inertia import trim_velocity
from eom.assembly.rows import local_rows
from eom.assembly.structure_checks import RELATIVE, Finding, strained_by, structure_findings
from eom.assembly.vectors import Array
from eom.vehicle.elements import Body, Connection, Slip, System


def check_system(system: System) -> list[Finding]:
    """Everything that no system may have."""
    findings = [finding for body in system.bodies for finding in check_body(body)]
    findings += [finding for item in system.slip for finding in check_slip(item)]
    findings += structure_findings(system)
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
    if first < -RELATIVE * size or third > (first + second) * (1.0 + RELATIVE) + RELATIVE * size:
        moments = f"{first:.6g}, {second:.6g} and {third:.6g} kg m^2"
        yield body.name, f"no body has principal moments of inertia {moments}: each is at most the sum of the others"
    yield from check_spin(body, inertia)


def check_slip(item: Slip) -> Iterator[Finding]:
    """A tyre or slip damper must oppose sliding; air need not."""
    worst = item.coefficients[0][0]
    if worst < 0.0 and not item.moving:
        yield item.connection.name, f"its coefficient is {worst:g} N s/m: it would push along with the slip"


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
    for group in (system.constraints, system.elastic, system.bushings, system.slip, system.inputs):
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
            yield connection.name, "its axis has no direction: all of its components are zero"


def check_trim(system: System) -> Iterator[Finding]:
    """No joint, spring or tyre may be strained by the steady motion itself."""
    w = trim_velocity(system.bodies)
    size = float(np.max(np.abs(w), initial=0.0))
    for kind, group in (
        ("joint", [item.connection for item in system.constraints if not item.moving]),
        ("joint", list(system.rolling)),
        ("tyre or slip damper", [item.connection for item in system.slip if not item.moving]),
    ):
        for connection in group:
            _, columns, jacobian = row_entry(0, connection.bodies, local_rows(system.bodies, connection))
            rate = jacobian @ w[columns]
            limit = RELATIVE * size * float(np.max(np.abs(jacobian), initial=1.0))
            if np.any(np.abs(rate) > limit):
                yield connection.name, violation(kind, float(rate[np.argmax(np.abs(rate))]))
    for name, worst in strained_by(system, w):
        yield name, violation("spring or damper", worst)


def violation(kind: str, rate: float) -> str:
    """The sentence for a connection that the trim motion strains at a rate."""
    motion = f"its ends move relative to each other at {rate:.6g} (m/s or rad/s) where it acts"
    return f"the trim motion violates this {kind}: {motion}"
