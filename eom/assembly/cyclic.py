"""Motions that change nothing: position and heading on a plane, the angle of a wheel.

They have columns of exact zeros; the other coordinates are counted from them.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.reduction import Pivots, Reduction
from eom.assembly.rows import six
from eom.assembly.vectors import Array, skew, unit
from eom.vehicle.elements import Body

CYCLIC_TOLERANCE = 1e-11


def cyclic_motion(bodies: Sequence[Body], motion: int) -> Array:
    """Displacement, shape (6 n,), of a rigid motion of the whole (0 to 5) or of the spin of body ``motion - 6``.

    Rotations are about the first body's centre.
    """
    p = np.zeros(6 * len(bodies))
    if motion >= 6:
        p[six(motion - 6)][3:] = unit(bodies[motion - 6].spin)
        return p
    direction = np.eye(3)[motion % 3]
    for i, body in enumerate(bodies):
        if motion < 3:
            p[six(i)][:3] = direction
        else:
            p[six(i)][:3] = skew(direction) @ np.subtract(body.centre, bodies[0].centre)
            p[six(i)][3:] = direction
    return p


def state_coordinates(reduction: Reduction, pivots: Pivots) -> tuple[Array, Array]:
    """Coordinates of p and velocities of w that are states, as indices."""
    return (
        np.delete(reduction.independent, list(pivots.static_positions)),
        np.delete(reduction.independent_velocities, [*pivots.damped, *pivots.static]),
    )


def cyclic_basis(bodies: Sequence[Body], reduction: Reduction, pivots: Pivots) -> Array:
    """Cyclic motions in the states' coordinates, shape (q, cyclic), each moving its own cyclic coordinate by one."""
    at, _ = state_coordinates(reduction, pivots)
    basis = np.zeros((len(at), len(pivots.cyclic)))
    for k, (motion, coordinate) in enumerate(zip(pivots.cyclic_motions, pivots.cyclic, strict=True)):
        if motion >= 6 and not np.any(bodies[motion - 6].spin):
            # a wheel at rest has no spin to tell its axis: its coordinate does
            basis[coordinate, k] = 1.0
        else:
            basis[:, k] = cyclic_motion(bodies, motion)[at]
    return basis @ np.linalg.inv(basis[list(pivots.cyclic)])


def is_negligible(change: Array, A: Array, basis: Array) -> bool:
    """Whether *change*, made of A times *basis*, is zero but for rounding, judged by the rows' largest entries."""
    size = np.outer(np.max(np.abs(A), axis=1, initial=0.0), np.max(np.abs(basis), axis=0, initial=0.0))
    return bool(np.all(np.abs(change) <= CYCLIC_TOLERANCE * size))


class Counted(NamedTuple):
    """State matrices with the other coordinates counted from the cyclic ones."""

    A: Array
    B: Array
    C: Array


def count_from_cyclic(
    A: Array, B: Array, C: Array, bodies: Sequence[Body], reduction: Reduction, pivots: Pivots
) -> Counted:
    """Change to states of which the cyclic ones move the whole; their columns of A become exact zeros.

    Raises ``ValueError`` if a motion that changed nothing now does.
    """
    if not pivots.cyclic:
        return Counted(A, B, C)
    cyclic = list(pivots.cyclic)
    own = cyclic_basis(bodies, reduction, pivots)
    basis = np.zeros((len(A), len(cyclic)))
    basis[: len(own)] = own
    others = basis.copy()
    others[cyclic] = 0.0
    drift = A @ basis
    inner = drift[cyclic]
    if not is_negligible(drift - basis @ inner, A, basis):
        message = "a motion that left every force unchanged no longer does: choose the coordinates anew"
        raise ValueError(message)
    result = A - others @ A[cyclic]
    result[:, cyclic] = 0.0
    result[np.ix_(cyclic, cyclic)] = without_rounding_of(inner, np.max(np.abs(inner), initial=0.0))
    measured = C.copy()
    largest = np.max(np.abs(C), axis=1, initial=0.0)[:, np.newaxis]
    measured[:, cyclic] = without_rounding_of(C @ basis, largest)
    return Counted(result, B - others @ B[cyclic], measured)


def without_rounding_of(values: Array, size: Array | float) -> Array:
    """The values, exactly zero where they are nothing beside *size*."""
    return np.where(np.abs(values) <= CYCLIC_TOLERANCE * size, 0.0, values)
