"""The choice of coordinates: which are independent, which motions change nothing."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.matrices import Matrices
from eom.assembly.reduction import (
    CYCLIC_TOLERANCE,
    Pivots,
    Reduction,
    complement,
    cyclic_motion,
    is_negligible,
    reduce_coordinates,
    state_matrix,
)
from eom.assembly.statics import length_scales
from eom.assembly.vectors import Array
from eom.vehicle.elements import System

RANK_TOLERANCE = 1e-9
# how readily a column becomes dependent: the lead body's motion and rotations are the coordinates people use
LEAD_PREFERENCE, ROTATION_PREFERENCE = 0.03, 0.3


def pivoted_elimination(matrix: Array, preference: Array) -> tuple[list[int], list[int]]:
    """Independent rows of *matrix* and as many columns that they determine, by complete pivoting.

    *preference* weighs the columns: a larger weight makes one dependent sooner. Written out because importing
    SciPy for its pivoted QR would make ``eom check`` take half as long again.
    """
    work = matrix / np.maximum(np.max(np.abs(matrix), axis=1, initial=0.0), 1e-300)[:, np.newaxis]
    size = np.abs(work) * preference
    kept: list[int] = []
    chosen: list[int] = []
    while len(kept) < min(work.shape):
        row, column = (int(k) for k in np.unravel_index(int(np.argmax(size)), work.shape))
        if np.abs(work[row, column]) <= RANK_TOLERANCE:
            break
        kept.append(row)
        chosen.append(column)
        # joints touch two bodies: few rows share a column
        touched = np.flatnonzero(work[:, column])
        work[touched] -= np.outer(work[touched, column] / work[row, column], work[row])
        work[row] = 0.0
        work[:, column] = 0.0
        size[touched] = np.abs(work[touched]) * preference
        size[row] = 0.0
    return sorted(kept), sorted(chosen)


def coordinate_preference(system: System) -> Array:
    """Weights per coordinate for `pivoted_elimination`."""
    weights = np.tile([1.0] * 3 + [ROTATION_PREFERENCE] * 3, len(system.bodies))
    weights /= length_scales(system.bodies)
    # of equal bodies the one described first keeps its coordinates
    weights *= np.repeat(1.0 + 0.001 * np.arange(len(system.bodies)), 6)
    weights[:6] *= LEAD_PREFERENCE
    return weights


def choose_pivots(system: System, matrices: Matrices) -> Pivots:
    """Dependent coordinates and cyclic motions of a system at its present numbers; every motion must have mass."""
    return with_cyclic(system, matrices, choose_coordinates(system, matrices))


def choose_coordinates(system: System, matrices: Matrices) -> Pivots:
    """Dependent coordinates alone."""
    preference = coordinate_preference(system)
    kept, dependent = pivoted_elimination(matrices.J, preference)
    independent, T = complement(matrices.J[kept], dependent)
    rolling = pivoted_elimination(matrices.Jn @ T, preference[independent])
    return Pivots(tuple(kept), tuple(dependent), tuple(rolling[0]), tuple(rolling[1]))


def with_cyclic(system: System, matrices: Matrices, pivots: Pivots) -> Pivots:
    """The pivots with the motions that change nothing, and the coordinates that stand for them."""
    reduction = reduce_coordinates(matrices, pivots)
    motions = cyclic_motions(system, matrices, reduction)
    wanted = 1.0 / coordinate_preference(system)[reduction.independent]
    # the pitch of a lone disc is also its spin: one of such motions stands for both
    distinct, cyclic = pivoted_elimination(basis(system, reduction, motions).T, wanted)
    return pivots._replace(cyclic_motions=tuple(motions[k] for k in distinct), cyclic=tuple(cyclic))


def basis(system: System, reduction: Reduction, motions: Sequence[int]) -> Array:
    """The motions as columns over the independent coordinates, shape (q, motions)."""
    columns = [cyclic_motion(system.bodies, motion)[reduction.independent] for motion in motions]
    return np.array(columns).T.reshape(len(reduction.independent), len(motions))


def cyclic_motions(system: System, matrices: Matrices, reduction: Reduction) -> tuple[int, ...]:
    """Rigid motions of the whole, and spins of bodies, that are possible and change no force and no velocity."""
    A, _ = state_matrix(matrices, reduction)
    n_q = len(reduction.independent)
    spinning = [6 + i for i, body in enumerate(system.bodies) if np.any(np.array(body.spin) != 0.0)]
    found = []
    for motion in [*range(6), *spinning]:
        p = cyclic_motion(system.bodies, motion)
        g = np.zeros((len(A), 1))
        g[:n_q, 0] = p[reduction.independent]
        possible = np.allclose(reduction.T @ g[:n_q, 0], p, rtol=0.0, atol=1e-9 * float(np.max(np.abs(p))))
        if possible and is_negligible((A @ g)[n_q:], A[n_q:], g):
            found.append(motion)
    return closed(system, reduction, A[:n_q, :n_q], found)


def closed(system: System, reduction: Reduction, drift: Array, motions: list[int]) -> tuple[int, ...]:
    """Those of the motions that only lead into one another (heading into sideways position)."""
    while motions:
        G = basis(system, reduction, motions)
        outside = drift @ G - G @ np.linalg.lstsq(G, drift @ G, rcond=None)[0]
        limit = CYCLIC_TOLERANCE * float(np.max(np.abs(drift))) * float(np.max(np.abs(G)))
        staying = [motion for k, motion in enumerate(motions) if np.max(np.abs(outside[:, k])) <= limit]
        if staying == motions:
            break
        motions = staying
    return tuple(motions)
