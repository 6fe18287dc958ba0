"""Jacobian rows: the motion that a connection measures, linear in the coordinates of all bodies."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.vectors import Array, directions, skew
from eom.vehicle.elements import GROUND, Body, Connection


def six(index: int) -> slice:
    """Columns of body *index*: three translations, three rotations."""
    return slice(6 * index, 6 * index + 6)


def arm(bodies: Sequence[Body], connection: Connection, end: int) -> Array:
    """Vector from the centre of the body at *end* (0 or 1) to its place [m]; from the origin for ground."""
    index = connection.bodies[end]
    place = np.asarray(connection.places[end], dtype=float)
    return place if index == GROUND else place - np.asarray(bodies[index].centre, dtype=float)


def force_directions(connection: Connection) -> Array:
    """Directions of force, shape (forces, 3); for a line the unit vector from its first to its second place."""
    if connection.line:
        first, second = (np.asarray(place, dtype=float) for place in connection.places)
        return directions(1, second - first)
    return directions(connection.forces, connection.force_axis)


def rows(bodies: Sequence[Body], connection: Connection) -> Array:
    """Rows of the connection, shape (forces + moments, 6 n): motion of its first body minus its second one's."""
    along = force_directions(connection)
    about = directions(connection.moments, connection.moment_axis)
    result = np.zeros((len(along) + len(about), 6 * len(bodies)))
    for end, sign in ((0, 1.0), (1, -1.0)):
        index = connection.bodies[end]
        if index != GROUND:
            block = result[:, six(index)]
            block[: len(along), :3] = sign * along
            block[: len(along), 3:] = -sign * along @ skew(arm(bodies, connection, end))
            block[len(along) :, 3:] = sign * about
    return result


def stack(bodies: Sequence[Body], connections: Sequence[Connection]) -> Array:
    """Rows of several connections, one below the other."""
    return np.vstack([np.zeros((0, 6 * len(bodies))), *(rows(bodies, item) for item in connections)])
