"""Equilibrium of the trim: constraint reactions and preloads, by statics alone or with the help of stiffness."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from eom.assembly.algebra import Algebra, block_diagonal
from eom.assembly.elastic import Strained, carrying_modes
from eom.assembly.reduction import ROUNDING, Pivots, Reduction, full
from eom.assembly.vectors import Array, zeros
from eom.vehicle.elements import Body

RANK_TOLERANCE = 1e-10
# loads in a file have some six digits
BALANCE_TOLERANCE = 1e-6
# beyond this many numbers a rank decision takes too long, and stiffness is asked at once
LARGE = 500_000


class Statics(NamedTuple):
    """The solved equilibrium.

    Attributes
    ----------
    reactions : Array
        One per constraint row, positive along its direction on the first body [N, N m].
    tensions : Array
        One per elastic row, zero where the row has no stiffness and no given preload [N, N m].
    residual : Array
        What remains unbalanced on each coordinate, shape (6 n,) [N, N m].
    limit : float
        The largest residual that counts as balanced [N, N m].
    determinate : bool
        True if statics alone gives every tension and reaction.
    indefinite : Array
        Per constraint row, whether its reaction is not unique: redundant joints share a load in any proportion, and
        the smallest reactions are taken.
    deflection : Array
        Small displacement that the loads cause from the state without preload, shape (6 n,); the smallest one
        where a motion is free.
    """

    reactions: Array
    tensions: Array
    residual: Array
    limit: float
    determinate: bool
    indefinite: NDArray[np.bool_]
    deflection: Array


class Balancing(Protocol):
    """What solves an equilibrium; see `equilibrium` for the arguments."""

    def __call__(
        self,
        bodies: Sequence[Body],
        elastic: tuple[Sequence[Strained], Array],
        constraints: tuple[Array, Pivots, Reduction],
        loads: tuple[Array, Array],
        algebra: Algebra,
    ) -> Statics:
        """The solved equilibrium."""
        ...


def length_scales(bodies: Sequence[Body]) -> Array:
    """Divisors, shape (6 n,), that make moments comparable with forces: 1 and the vehicle's size [m]."""
    centres = np.array([body.centre for body in bodies], dtype=float)
    size = max(1.0, float(np.max(np.ptp(centres, axis=0))))
    return np.tile([1.0, 1.0, 1.0, size, size, size], len(bodies))


def equilibrium(
    bodies: Sequence[Body],
    elastic: tuple[Sequence[Strained], Array],
    constraints: tuple[Array, Pivots, Reduction],
    loads: tuple[Array, Array],
    algebra: Algebra,
) -> Statics:
    """Solve f + J' reactions + H' tensions = 0 for joints and for elastic rows that can carry load.

    *elastic* are the items and their rows H, *constraints* J, its pivots and its reduction, *loads* f and the sum of
    the sizes that it is made of. Where statics leaves tensions open, the elastic rows share the load as their
    stiffness demands, from a state without preload; what redundant joints leave open then takes the smallest
    reactions.
    """
    (items, H), (J, pivots, reduction), (f, acting) = elastic, constraints, loads
    found = [carrying_modes(item) for item in items]
    modes = block_diagonal([combined for combined, _ in found], algebra)
    k = np.concatenate([np.zeros(0), *(own for _, own in found)])
    given = np.concatenate([np.zeros(0), *(np.full(len(item.rows), item.preload or 0.0) for item in items)])
    free = free_motions(reduction, len(k))
    applied = f + H.T @ given
    shared, determinate, motion = share(without_rounding(modes.T @ H, free), k, np.asarray(free.T @ applied))
    tensions = given + modes @ shared
    reactions, indefinite = joint_reactions(J, pivots, reduction, -(f + H.T @ tensions))
    residual = f + J.T @ reactions + H.T @ tensions
    # rounding is measured by what is added up, not by the sum
    size = acting + abs(J.T) @ np.abs(reactions) + abs(H.T) @ np.abs(tensions)
    limit = BALANCE_TOLERANCE * float(np.max(size / length_scales(bodies), initial=0.0))
    determinate = determinate and not np.any(indefinite)
    return Statics(reactions, tensions, residual, limit, determinate, indefinite, free @ motion)


def free_motions(reduction: Reduction, springs: int) -> Array:
    """Basis of the displacements that the joints allow, orthonormal where elastic rows have to share a load."""
    T = reduction.T
    if reduction.factor is None or not springs or T.size > LARGE:
        return T
    Q: Array = np.linalg.qr(T)[0]
    return Q


def without_rounding(rows: Array, motions: Array) -> Array:
    """The product of *rows* and *motions*, exactly zero where their terms cancel but for rounding."""
    product = np.asarray(rows @ motions)
    size = np.max(abs(rows) @ np.abs(motions), axis=1, initial=0.0)[:, np.newaxis]
    return np.where(np.abs(product) <= ROUNDING * size, 0.0, product)


def share(H: Array, k: Array, f: Array) -> tuple[Array, bool, Array]:
    """Tensions with f + H' tensions = 0, whether statics alone tells them, and the deflection H e = -tensions / k."""
    if H.size > LARGE and (found_quickly := share_quickly(H, k, f)) is not None:
        return found_quickly
    found = np.linalg.lstsq(H.T, -f, rcond=RANK_TOLERANCE)
    tensions: Array = np.asarray(found[0])
    determinate = int(found[2]) == len(k)
    if not determinate and np.all(k > 0.0):
        # least complementary energy
        root = np.sqrt(k)
        tensions = root * np.linalg.lstsq(H.T * root, -f, rcond=RANK_TOLERANCE)[0]
    elif not determinate:
        motion = np.asarray(np.linalg.lstsq((H.T * k) @ H, f, rcond=RANK_TOLERANCE)[0])
        return -k * (H @ motion), False, motion
    motion = np.asarray(np.linalg.lstsq(H, -tensions / k, rcond=RANK_TOLERANCE)[0])
    return tensions, determinate, motion


def share_quickly(H: Array, k: Array, f: Array) -> tuple[Array, bool, Array] | None:
    """As `share`, by factors that many rows afford; None where neither rows nor stiffness are regular."""
    try:
        gram = regular(H @ H.T)
        tensions = -np.linalg.solve(gram, H @ f)
        return np.asarray(tensions), True, np.asarray(-H.T @ np.linalg.solve(gram, tensions / k))
    except np.linalg.LinAlgError:
        pass
    try:
        motion = np.asarray(np.linalg.solve(regular((H.T * k) @ H), f), dtype=np.float64)
        return -k * (H @ motion), False, motion
    except np.linalg.LinAlgError:
        return None


def regular(matrix: Array) -> Array:
    """The symmetric matrix itself; raises ``LinAlgError`` unless it is clearly positive definite."""
    np.linalg.cholesky(matrix - RANK_TOLERANCE * np.max(np.abs(matrix), initial=0.0) * np.eye(len(matrix)))
    return matrix


def self_stresses(J: Array, pivots: Pivots, reduction: Reduction) -> Array:
    """Reactions of the joints against each other, which no load needs, shape (rows, redundancy).

    One for each row that is not among the pivots, where it is 1.
    """
    repeated = np.setdiff1d(np.arange(J.shape[0]), list(pivots.rows))
    identity = np.arange(len(repeated))
    if not (repeated.size and reduction.factor is not None):
        null = np.zeros((J.shape[0], len(repeated)))
    else:
        balancing = -reduction.factor.solve_transposed(full(J[repeated][:, list(pivots.dependent)]).T)
        null = zeros((J.shape[0], len(repeated)), balancing)
        null[list(pivots.rows)] = balancing
    null[repeated, identity] = 1.0
    return null


def joint_reactions(J: Array, pivots: Pivots, reduction: Reduction, wanted: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The smallest reactions with J' reactions = *wanted*, and which of them are not unique."""
    reactions = np.zeros(J.shape[0])
    if reduction.factor is not None:
        reactions[list(pivots.rows)] = reduction.factor.solve_transposed(wanted[list(pivots.dependent)])
    null = self_stresses(J, pivots, reduction)
    if null.shape[1]:
        reactions -= null @ np.linalg.lstsq(null, reactions, rcond=None)[0]
    largest = np.max(np.abs(null), axis=1, initial=0.0)
    return reactions, largest > RANK_TOLERANCE * np.max(largest, initial=0.0)


def unbalanced(bodies: Sequence[Body], statics: Statics) -> NDArray[np.intp]:
    """Indices of the coordinates whose residual is more than rounding, the largest first."""
    size = np.abs(statics.residual) / length_scales(bodies)
    order = np.argsort(-size, kind="stable")
    return order[size[order] > statics.limit]
