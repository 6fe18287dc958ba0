"""From full coordinates to independent ones, chosen beforehand.

Displacements p = T q follow independent ones, velocities w = W n + Z q independent velocities n, where T and W
are identities on the chosen coordinates.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import DENSE, Algebra, Factor
from eom.assembly.vectors import Array, zeros

ROUNDING = 1e-11
# below this the reduced equations would lose more than half of their digits
PIVOT_TOLERANCE = 1e-6


class Pivots(NamedTuple):
    """The choice of coordinates, made once for a system's structure.

    Attributes
    ----------
    rows : tuple of int
        Rows of J that are independent.
    dependent : tuple of int
        Coordinates of p that these rows determine, as many.
    rolling_rows : tuple of int
        Rows of Jn that are independent of J and of each other.
    rolling_dependent : tuple of int
        Which of the independent coordinates lose their velocity to them.
    damped, static : tuple of int
        Which of the independent velocities have no mass and follow from dampers, and which not even those.
    static_positions : tuple of int
        Which of the independent coordinates follow from stiffness alone, as many as ``static``.
    cyclic_motions : tuple of int
        Motions that change nothing: 0 to 5 of the whole system, 6 + i the spin of body i.
    cyclic : tuple of int
        State that stands for each of them.
    """

    rows: tuple[int, ...] = ()
    dependent: tuple[int, ...] = ()
    rolling_rows: tuple[int, ...] = ()
    rolling_dependent: tuple[int, ...] = ()
    damped: tuple[int, ...] = ()
    static: tuple[int, ...] = ()
    static_positions: tuple[int, ...] = ()
    cyclic_motions: tuple[int, ...] = ()
    cyclic: tuple[int, ...] = ()


class Reduction(NamedTuple):
    """p = T q, w = W n + Z q; ``independent`` coordinates q, ``independent_velocities`` n (indices of w).

    ``factor`` solves with the constraint rows' dependent columns, None without any.
    """

    T: Array
    W: Array
    Z: Array
    independent: Array
    independent_velocities: Array
    factor: Factor | None


def full(matrix: Array) -> Array:
    """The matrix itself, or a sparse one as a dense one."""
    return matrix.toarray() if hasattr(matrix, "toarray") else matrix


def complement(J: Array, dependent: Sequence[int], algebra: Algebra = DENSE) -> tuple[Array, Array, Factor | None]:
    """Independent columns of J, T of p = T q with J T = 0, an identity on them, and what solves for the others.

    Raises ``ValueError`` if the dependent coordinates no longer follow from the rows.
    """
    n = J.shape[1]
    chosen = list(dependent)
    independent = np.setdiff1d(np.arange(n), chosen)
    identity = np.arange(len(independent))
    if not chosen:
        T = zeros((n, n), full(J))
        T[independent, identity] = 1.0
        return independent, T, None
    factor = algebra.factor(J[:, chosen])
    if factor.smallest() <= PIVOT_TOLERANCE * abs(J).max():
        message = "the constraints no longer determine the chosen dependent coordinates: choose them anew"
        raise ValueError(message)
    followed = -factor.solve(full(J[:, independent]))
    T = zeros((n, len(independent)), followed)
    T[independent, identity], T[chosen] = 1.0, followed
    return independent, T, factor


def reduce_coordinates(J: Array, Jn: Array, V: Array, pivots: Pivots, algebra: Algebra = DENSE) -> Reduction:
    """Solve the constraints for the dependent coordinates and velocities.

    Raises ``ValueError`` where the pivots do not fit the rows any more.
    """
    kept, chosen = J[list(pivots.rows)], list(pivots.dependent)
    independent, T, factor = complement(kept, chosen, algebra)
    if not holds(J[np.setdiff1d(np.arange(J.shape[0]), list(pivots.rows))], T):
        message = "a joint that repeated others no longer does: choose the coordinates anew"
        raise ValueError(message)
    Z = np.zeros_like(T)
    if factor is not None and np.any(V.data):
        Z[chosen] = factor.solve(np.asarray(kept @ (V @ T)))
    rolling = full(Jn)[list(pivots.rolling_rows)] @ T
    remaining, Tn, rolled = complement(rolling, pivots.rolling_dependent, algebra)
    if rolled is not None:
        lost = list(pivots.rolling_dependent)
        Z = Z - T[:, lost] @ rolled.solve(full(Jn)[list(pivots.rolling_rows)] @ Z)
    W = T @ Tn if pivots.rolling_dependent else T
    # a rolling row that depends on the joints is left out above: it must hold by itself
    if not holds(Jn, Z):
        message = "a rolling condition contradicts the joints: they let it hold only at one displacement"
        raise ValueError(message)
    return Reduction(T, W, Z, independent, independent[remaining], factor)


def holds(rows: Array, motion: Array) -> bool:
    """Whether constraint rows let a motion be, but for rounding."""
    if not (rows.shape[0] and np.any(motion)):
        return True
    size = abs(rows) @ np.abs(motion) + np.max(np.abs(motion), initial=0.0)
    return not np.any(np.abs(rows @ motion) > ROUNDING * size)
