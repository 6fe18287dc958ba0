"""Motions that change nothing: position and heading on a plane, the angle of a wheel.

They have columns of exact zeros; the other coordinates are counted from them.
"""

from collections.abc import Sequence

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
    size = np.outer(np.max(np.abs(A), axis=1), np.max(np.abs(basis), axis=0))
    return bool(np.all(np.abs(change) <= CYCLIC_TOLERANCE * size))


def count_from_cyclic(
    A: Array, bodies: Sequence[Body], reduction: Reduction, pivots: Pivots
) -> tuple[Array, Array, Array]:
    """Count coordinates from the cyclic ones: A with exact zeros, and x = X x_new with the inverse of X.

    Raises ``ValueError`` if a motion that changed nothing now does.
    """
    X, X_inverse = np.eye(len(A)), np.eye(len(A))
    if not pivots.cyclic:
        return A, X, X_inverse
    cyclic = list(pivots.cyclic)
    own = cyclic_basis(bodies, reduction, pivots)
    basis = np.zeros((len(A), len(cyclic)))
    basis[: len(own)] = own
    X[:, cyclic] = basis
    X_inverse[:, cyclic] -= basis
    X_inverse[cyclic, cyclic] = 1.0
    result = X_inverse @ A @ X
    inner = result[np.ix_(cyclic, cyclic)]
    if not is_negligible(A @ basis - basis @ inner, A, basis):
        message = "a motion that left every force unchanged no longer does: choose the coordinates anew"
        raise ValueError(message)
    inner = np.where(np.abs(inner) <= CYCLIC_TOLERANCE * np.max(np.abs(inner), initial=0.0), 0.0, inner)
    result[:, cyclic] = 0.0
    result[np.ix_(cyclic, cyclic)] = inner
    return result, X, X_inverse
