"""Jacobian rows: the motion that a connection measures, linear in the coordinates of its two bodies."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.algebra import moving_columns
from eom.assembly.vectors import Array, array, directions, skew, zeros
from eom.vehicle.elements import GROUND, Body, Connection


def six(index: int) -> slice:
    """Columns of body *index*: three translations, three rotations."""
    return slice(6 * index, 6 * index + 6)


def arm_of(bodies: Sequence[Body], index: int, place: Sequence[float]) -> Array:
    """Vector from a body's centre to a place [m]; from the origin for ground."""
    where = array(place)
    return where if index == GROUND else where - array(bodies[index].centre)


def arm(bodies: Sequence[Body], connection: Connection, end: int) -> Array:
    """Vector from the centre of the body at *end* (0 or 1) to its place [m]; from the origin for ground."""
    return arm_of(bodies, connection.bodies[end], connection.places[end])


def force_directions(connection: Connection) -> Array:
    """Directions of force, shape (forces, 3); for a line the unit vector from its first to its second place."""
    if connection.line:
        first, second = (array(place) for place in connection.places)
        return directions(1, second - first)
    return directions(connection.forces, connection.force_axis)


def row_count(connection: Connection) -> int:
    """Number of the connection's rows."""
    return (1 if connection.line else connection.forces) + connection.moments


def local_rows(bodies: Sequence[Body], connection: Connection) -> Array:
    """Rows of the connection, shape (forces + moments, 12), over the coordinates of its first and second body.

    The motion of the first body minus that of the second one.
    """
    along = force_directions(connection)
    about = directions(connection.moments, connection.moment_axis)
    first, second = along @ skew(arm(bodies, connection, 0)), along @ skew(arm(bodies, connection, 1))
    n = len(along)
    result = zeros((n + len(about), 12), first, second, about)
    result[:n, :3], result[:n, 6:9] = along, -along
    result[:n, 3:6], result[:n, 9:] = -first, second
    result[n:, 3:6], result[n:, 9:] = about, -about
    return result


def rows(bodies: Sequence[Body], connection: Connection) -> Array:
    """The connection's rows over all coordinates, shape (forces + moments, 6 n)."""
    columns, local = moving_columns(connection.bodies)
    own = local_rows(bodies, connection)
    result = np.zeros((len(own), 6 * len(bodies)))
    result[:, columns] = own[:, local]
    return result
