"""The choice of coordinates: which are independent, which have no mass, which motions change nothing."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.algebra import DENSE, Algebra
from eom.assembly.cyclic import CYCLIC_TOLERANCE, cyclic_motion, is_negligible, state_coordinates
from eom.assembly.massless import (
    INDEX_TOLERANCE,
    MASS_TOLERANCE,
    Equations,
    FirstOrder,
    first_order,
    independent_equations,
    null_basis,
)
from eom.assembly.matrices import Matrices, joint_rows
from eom.assembly.reduction import Pivots, Reduction, complement, full
from eom.assembly.statics import length_scales
from eom.assembly.tree import pivoted_columns, spanning_tree
from eom.assembly.vectors import Array
from eom.vehicle.elements import System

RANK_TOLERANCE = 1e-9
# how readily a column becomes dependent: the lead body's motion and rotations are the coordinates people use
LEAD_PREFERENCE, ROTATION_PREFERENCE = 0.03, 0.3
# more bodies than these are reduced along a tree, with sparse matrices
MANY_BODIES = 60


def pivoted_elimination(matrix: Array, preference: Array, sizes: Array | None = None) -> tuple[list[int], list[int]]:
    """Independent rows of *matrix* and as many columns that they determine, by complete pivoting.

    *preference* weighs the columns: a larger weight makes one dependent sooner. *sizes* are those of the terms that
    each row is a sum of, beside which rounding is zero; its largest entry by default. Written out because importing
    SciPy for its pivoted QR would make ``eom check`` take half as long again.
    """
    largest = np.max(np.abs(matrix), axis=1, initial=0.0) if sizes is None else sizes
    work = matrix / np.maximum(largest, 1e-300)[:, np.newaxis]
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


def choose_coordinates(system: System, algebra: Algebra = DENSE) -> Pivots:
    """Dependent coordinates alone."""
    preference = coordinate_preference(system)
    J, Jn = joint_rows(system, algebra)
    if len(system.bodies) > MANY_BODIES:
        kept, dependent = along_tree(system, J, preference, algebra)
    else:
        kept, dependent = pivoted_elimination(full(J), preference)
    if not system.rolling:
        return Pivots(tuple(kept), tuple(dependent))
    independent, T, _ = complement(J[kept], dependent, algebra)
    rolling = pivoted_elimination(np.asarray(Jn @ T), preference[independent], term_sizes(Jn, T))
    return Pivots(tuple(kept), tuple(dependent), tuple(rolling[0]), tuple(rolling[1]))


def along_tree(system: System, J: Array, preference: Array, algebra: Algebra) -> tuple[list[int], list[int]]:
    """Independent rows and dependent coordinates of many bodies: a tree's, then those of its loops."""
    tree = spanning_tree(system, preference, pivoted_elimination)
    if not tree.loops:
        return tree.rows, tree.dependent
    independent, T, _ = complement(J[tree.rows], tree.dependent, algebra)
    loops = J[tree.loops]
    sizes = term_sizes(loops, T)
    rows, columns = pivoted_columns(np.asarray(loops @ T), preference[independent], RANK_TOLERANCE, sizes)
    kept = sorted([*tree.rows, *(tree.loops[k] for k in rows)])
    return kept, sorted([*tree.dependent, *(int(independent[k]) for k in columns)])


def term_sizes(rows: Array, motions: Array) -> Array:
    """Largest sum of absolute terms in each row of a product."""
    return np.asarray(np.max(abs(rows) @ np.abs(motions), axis=1, initial=0.0))


def complete(system: System, matrices: Matrices, pivots: Pivots) -> tuple[Pivots, FirstOrder]:
    """The pivots with massless and cyclic motions as well, and the first-order form that they give.

    *pivots* are those that the matrices were assembled with. Raises `IndexAboveOneError` for a motion that nothing
    determines, ``ValueError`` where masses or dampers cannot be told from none.
    """
    equations = independent_equations(matrices)
    pivots = with_massless(system, matrices, equations, pivots)
    form = first_order(equations, pivots)
    return with_cyclic(system, matrices.reduction, form, pivots), form


def with_massless(system: System, matrices: Matrices, equations: Equations, pivots: Pivots) -> Pivots:
    """The pivots with the velocities that have no mass, and the coordinates that stiffness alone places.

    Raises `IndexAboveOneError` for a motion that nothing determines.
    """
    null = massless_motions(equations.M)
    if not null.shape[1]:
        return pivots
    weights = 1.0 / coordinate_preference(system)
    _, massless = pivoted_elimination(null.T, weights[matrices.reduction.independent_velocities])
    if len(massless) < null.shape[1]:
        message = "motions without mass cannot be told from those with mass"
        raise ValueError(message)
    basis = null_basis(equations.M, massless)
    damping = basis.T @ equations.C @ basis
    limit = INDEX_TOLERANCE * float(np.max(np.abs(equations.C), initial=0.0))
    _, sigma, directions = np.linalg.svd(damping)
    undamped = directions[sigma <= np.maximum(limit, MASS_TOLERANCE * sigma[0])]
    _, static = pivoted_elimination(undamped, np.ones(len(massless)))
    damped = [velocity for k, velocity in enumerate(massless) if k not in static]
    follow = [massless[k] for k in static]
    path = equations.Qn @ basis @ undamped.T
    _, positions = pivoted_elimination(path.T, np.ones(len(path)))
    return pivots._replace(damped=tuple(damped), static=tuple(follow), static_positions=tuple(positions))


def massless_motions(M: Array) -> Array:
    """Null vectors of a reduced mass matrix, shape (n, motions)."""
    size = np.diag(M)
    scale = np.sqrt(np.where(size > 1e-13 * np.max(size, initial=0.0), size, 1.0))
    scaled = M / np.outer(scale, scale)
    try:
        # regular: quick to tell
        np.linalg.cholesky(scaled - MASS_TOLERANCE * np.eye(len(M)))
    except np.linalg.LinAlgError:
        values, vectors = np.linalg.eigh(scaled)
        motions: Array = vectors[:, values <= MASS_TOLERANCE] / scale[:, np.newaxis]
        return motions
    return np.zeros((len(M), 0))


def with_cyclic(system: System, reduction: Reduction, form: FirstOrder, pivots: Pivots) -> Pivots:
    """The pivots with the motions that change nothing, and the coordinates that stand for them."""
    motions = cyclic_motions(system, reduction, form, pivots)
    at, _ = state_coordinates(reduction, pivots)
    wanted = 1.0 / coordinate_preference(system)[at]
    # the pitch of a lone disc is also its spin: one of such motions stands for both
    distinct, cyclic = pivoted_elimination(basis(system, at, motions).T, wanted)
    return pivots._replace(cyclic_motions=tuple(motions[k] for k in distinct), cyclic=tuple(cyclic))


def basis(system: System, at: Array, motions: Sequence[int]) -> Array:
    """The motions as columns over the coordinates *at*, shape (q, motions)."""
    columns = [cyclic_motion(system.bodies, motion)[at] for motion in motions]
    return np.array(columns).T.reshape(len(at), len(motions))


def cyclic_motions(system: System, reduction: Reduction, form: FirstOrder, pivots: Pivots) -> tuple[int, ...]:
    """Rigid motions of the whole, and spins of bodies, that are possible and change no force and no velocity."""
    A = form.rates[:, : len(form.rates)]
    at, _ = state_coordinates(reduction, pivots)
    if not at.size:
        return ()
    spinning = [6 + i for i, body in enumerate(system.bodies) if np.any(np.array(body.spin) != 0.0)]
    found = []
    for motion in [*range(6), *spinning]:
        p = cyclic_motion(system.bodies, motion)
        g = np.zeros((len(A), 1))
        g[: len(at), 0] = p[at]
        possible = np.allclose(
            reduction.T @ p[reduction.independent], p, rtol=0.0, atol=1e-9 * float(np.max(np.abs(p)))
        )
        if possible and is_negligible((A @ g)[len(at) :], A[len(at) :], g):
            found.append(motion)
    return closed(system, at, A[: len(at), : len(at)], found)


def closed(system: System, at: Array, drift: Array, motions: list[int]) -> tuple[int, ...]:
    """Those of the motions that only lead into one another (heading into sideways position)."""
    while motions:
        G = basis(system, at, motions)
        outside = drift @ G - G @ np.linalg.lstsq(G, drift @ G, rcond=None)[0]
        limit = CYCLIC_TOLERANCE * float(np.max(np.abs(drift))) * float(np.max(np.abs(G)))
        staying = [motion for k, motion in enumerate(motions) if np.max(np.abs(outside[:, k])) <= limit]
        if staying == motions:
            break
        motions = staying
    return tuple(motions)
