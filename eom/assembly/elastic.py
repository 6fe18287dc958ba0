"""Everything elastic in one form: independent strains with stiffness, damping and inertance."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import Entry, square_entry
from eom.assembly.beam import beam_mass, beam_rows
from eom.assembly.rows import local_rows
from eom.assembly.triangle import triangle_rows
from eom.assembly.vectors import Array, array, skew, unit
from eom.vehicle.elements import Body, Bushing, Connection, Elastic, System


class Strained(NamedTuple):
    """An elastic item: its force on its bodies is minus rows' (stiffness e + damping de/dt), e = rows p.

    Attributes
    ----------
    name : str
    bodies : tuple of int
    rows : Array
        Strains over the coordinates of its bodies, shape (m, 6 bodies).
    stiffness, damping : Array
        Shape (m, m).
    mass : Array
        Inertance or distributed mass over the bodies' coordinates, square, or of no size.
    preload : float or None
        Given tension.
    connection : Connection or None
        What turns its preload along; None for beams and membranes, whose own modules tell.
    """

    name: str
    bodies: tuple[int, ...]
    rows: Array
    stiffness: Array
    damping: Array
    mass: Array
    preload: float | None
    connection: Connection | None


def elastic_items(system: System) -> list[Strained]:
    """Springs and flexible points, bushings, beams, membranes, in this order."""
    bodies, none = system.bodies, np.zeros((0, 0))
    items = [from_elastic(bodies, item) for item in system.elastic]
    items += [from_bushing(bodies, item) for item in system.bushings]
    for beam in system.beams:
        rows, stiffness = beam_rows(bodies, beam)
        mass = beam_mass(bodies, beam) if beam.mass_per_length else none
        items.append(Strained(beam.name, beam.bodies, rows, stiffness, 0.0 * stiffness, mass, None, None))
    for triangle in system.triangles:
        rows, stiffness = triangle_rows(bodies, triangle)
        items.append(Strained(triangle.name, triangle.bodies, rows, stiffness, 0.0 * stiffness, none, None, None))
    return items


def from_elastic(bodies: Sequence[Body], item: Elastic) -> Strained:
    """A spring, damper and inerter along each direction of its connection."""
    connection = item.connection
    counts = (1 if connection.line else connection.forces, connection.moments)
    stiffness, damping, inertance = (
        np.diag(np.repeat(array(pair), counts)) for pair in (item.stiffness, item.damping, item.inertance)
    )
    rows = local_rows(bodies, connection)
    mass = rows.T @ inertance @ rows if np.any(inertance) else np.zeros((0, 0))
    return Strained(connection.name, connection.bodies, rows, stiffness, damping, mass, item.preload, connection)


def bushing_axes(item: Bushing) -> Array:
    """The axes that a bushing's matrices refer to, shape (3, 3), a row each."""
    first = unit(item.axes[0])
    second = array(item.axes[1])
    second = unit(second - first * (first @ second))
    return np.array([first, second, skew(first) @ second])


def from_bushing(bodies: Sequence[Body], item: Bushing) -> Strained:
    """A bushing, its matrices turned from its own axes into the inertial ones."""
    turn = np.kron(np.eye(2), bushing_axes(item))
    stiffness, damping = (turn.T @ array(matrix) @ turn for matrix in (item.stiffness, item.damping))
    connection = item.connection
    rows = local_rows(bodies, connection)
    none = np.zeros((0, 0))
    return Strained(connection.name, connection.bodies, rows, stiffness, damping, none, None, connection)


def carrying_modes(item: Strained) -> tuple[Array, Array]:
    """Combinations of an item's strains that carry load, shape (m, modes), with their stiffness, (modes,).

    Strains without stiffness (dampers) carry none; a given preload is no unknown.
    """
    k = np.diag(item.stiffness)
    if item.preload is not None:
        return np.zeros((len(k), 0)), np.zeros(0)
    if np.array_equal(item.stiffness, np.diag(k)):
        return np.eye(len(k))[:, k != 0.0], k[k != 0.0]
    values, modes = np.linalg.eigh(item.stiffness)
    kept = np.abs(values) > 1e-12 * np.max(np.abs(values))
    return modes[:, kept], values[kept]


def stiffness_entries(items: Sequence[Strained]) -> Iterator[Entry]:
    """Elastic stiffness over all coordinates."""
    for item in items:
        if np.any(item.stiffness):
            yield square_entry(item.bodies, item.rows.T @ item.stiffness @ item.rows)


def damping_entries(items: Sequence[Strained]) -> Iterator[Entry]:
    """Damping over all coordinates, which multiplies dp/dt."""
    for item in items:
        if np.any(item.damping):
            yield square_entry(item.bodies, item.rows.T @ item.damping @ item.rows)


def inertance_entries(items: Sequence[Strained]) -> Iterator[Entry]:
    """Inertance and the mass of beams over all coordinates, which multiply the second rate of p."""
    for item in items:
        if item.mass.size:
            yield square_entry(item.bodies, item.mass)
