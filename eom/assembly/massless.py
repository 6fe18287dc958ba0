"""First-order equations of the independent coordinates, motions without mass eliminated.

A motion without mass moves as its dampers demand; one that has not even a damper stands where its stiffness
demands. Signals are arrays whose columns multiply, in this order, the states z, the inputs u and their rates.
"""

from typing import NamedTuple

import numpy as np

from eom.assembly.matrices import Matrices
from eom.assembly.reduction import ROUNDING, Pivots
from eom.assembly.vectors import Array

INDEX_TOLERANCE = 1e-12
MASS_TOLERANCE = 1e-10


class Equations(NamedTuple):
    """dq/dt = Qq q + Qn n,  M dn/dt + C n + K q = F u + G du/dt, in independent coordinates and velocities."""

    Qq: Array
    Qn: Array
    M: Array
    C: Array
    K: Array
    F: Array
    G: Array


class FirstOrder(NamedTuple):
    """Rates of the states, coordinates q and velocities n, as signals; ``mass`` of the velocities that are states."""

    rates: Array
    q: Array
    n: Array
    mass: Array


class IndexAboveOneError(ValueError):
    """A motion that neither mass nor damper nor stiffness determines; ``velocity`` is its place in n."""

    def __init__(self, velocity: int) -> None:
        self.velocity = velocity
        super().__init__("a motion has neither mass nor damping nor stiffness that determine it")


def independent_equations(matrices: Matrices) -> Equations:
    """The equations without constraint reactions."""
    M, C, K = matrices.M, matrices.C, matrices.K
    T, W, Z, at = matrices.reduction.T, matrices.reduction.W, matrices.reduction.Z, matrices.reduction.independent
    Qq, Qn = (Z - matrices.V @ T)[at], W[at]
    on_q, on_n = K @ T, C @ W
    if np.any(Z):
        MZ = M @ Z
        on_q, on_n = on_q + MZ @ Qq + C @ Z, on_n + MZ @ Qn
    F, G = along(W, matrices.F), along(W, matrices.G)
    damping = projected(W, on_n)
    if np.max(np.abs(damping), initial=0.0) <= ROUNDING * float(abs(C).max()) * np.max(np.abs(W), initial=0.0):
        # dampers between bodies that joints hold together
        damping = np.zeros_like(damping)
    return Equations(Qq, Qn, W.T @ (M @ W), damping, projected(W, on_q), F, G)


def projected(W: Array, forces: Array) -> Array:
    """Forces on the velocities n; for many bodies the product is worth sparing where there are none."""
    return W.T @ forces if np.any(forces) else np.zeros((W.shape[1], forces.shape[1]))


def null_basis(A: Array, dependent: list[int], terms: float = 0.0) -> Array:
    """Null vectors of a square matrix, made of *terms* of that size or its own, an identity on the *dependent* rows.

    Raises ``ValueError`` if they are none.
    """
    kept = np.setdiff1d(np.arange(len(A)), dependent)
    N = np.zeros((len(A), len(dependent)))
    N[dependent, np.arange(len(dependent))] = 1.0
    if dependent and kept.size:
        N[kept] = -np.linalg.solve(A[kept][:, kept], A[kept][:, dependent])
    size = max(np.max(np.abs(A), initial=0.0), terms) * np.max(np.abs(N), initial=0.0)
    if np.any(np.abs(A @ N) > MASS_TOLERANCE * size):
        message = "a motion that had no mass or no damping now has: choose the coordinates anew"
        raise ValueError(message)
    return N


def first_order(equations: Equations, pivots: Pivots) -> FirstOrder:
    """Solve for the rates of the states.

    Raises `IndexAboveOneError` for a motion without mass that nothing determines, ``ValueError`` if mass or damping
    are not as the pivots say.
    """
    n_q, n_n, n_u = len(equations.Qq), len(equations.M), equations.F.shape[1]
    massless = [*pivots.damped, *pivots.static]
    kept = np.setdiff1d(np.arange(n_n), massless)
    followed = list(pivots.static_positions)
    kept_q = np.setdiff1d(np.arange(n_q), followed)
    columns = len(kept_q) + len(kept) + 2 * n_u
    z_q = np.eye(len(kept_q), columns)
    n = np.zeros((n_n, columns))
    n[kept, len(kept_q) + np.arange(len(kept))] = 1.0
    q = np.zeros((n_q, columns))
    q[kept_q] = z_q
    force = np.hstack([np.zeros((n_n, len(kept_q) + len(kept))), equations.F, equations.G])
    if not massless:
        rates = dynamics(equations, q, n, force, kept)
        return FirstOrder(np.vstack([equations.Qq @ q + equations.Qn @ n, rates]), q, n, equations.M)
    null = null_basis(equations.M, massless)
    damping = null.T @ equations.C @ null
    first, last = list(range(len(pivots.damped))), list(range(len(pivots.damped), len(massless)))
    # where nothing is damped, damping is but rounding
    terms = float(np.max(np.abs(equations.C), initial=0.0) * np.max(np.abs(null)) ** 2)
    right, left = null_basis(damping, last, terms), null_basis(damping.T, last, terms)
    path = equations.Qn @ null @ right
    path_inverse = np.linalg.inv(path[followed])
    stretch = path @ path_inverse
    check_decoupled(equations, null, right, left)
    if followed:
        stiffness = left.T @ null.T @ equations.K
        check_regular(stiffness @ stretch, stiffness, massless[len(first) :])
        q += stretch @ np.linalg.solve(stiffness @ stretch, along(null @ left, force - equations.C @ n) - stiffness @ q)
    if first:
        own = null[:, first]
        damper = damping[np.ix_(first, first)]
        check_regular(damper, damping, massless[: len(first)])
        n = n + own @ np.linalg.solve(damper, along(own, force) - own.T @ (equations.K @ q + equations.C @ n))
    drift = equations.Qq @ q + equations.Qn @ n
    rates_q = drift[kept_q] - stretch[kept_q] @ drift[followed]
    rates_n = dynamics(equations, q, n, force, kept)
    rates = np.vstack([rates_q, rates_n])
    if followed:
        moved = rate_of(q, rates, n_u)[followed] - drift[followed]
        n = n + null @ right @ path_inverse @ moved
    return FirstOrder(rates, q, n, equations.M[np.ix_(kept, kept)])


def along(motions: Array, force: Array) -> Array:
    """Forces along motions, exactly zero where they are rounding: a rate of it would pass for an input's."""
    product = motions.T @ force
    size = np.outer(np.max(np.abs(motions), axis=0), np.max(np.abs(force), axis=0, initial=0.0))
    return np.where(np.abs(product) <= ROUNDING * size, 0.0, product)


def dynamics(equations: Equations, q: Array, n: Array, force: Array, kept: Array) -> Array:
    """Rates of the velocities that have mass."""
    rest = force - equations.K @ q - equations.C @ n
    return np.asarray(np.linalg.solve(equations.M[np.ix_(kept, kept)], rest[kept]))


def check_decoupled(equations: Equations, null: Array, right: Array, left: Array) -> None:
    """Raise unless motions that stiffness alone places feel no damper and no rate of an input."""
    static = null @ right
    for coupling, size in (
        (equations.C @ static, equations.C),
        ((left.T @ null.T @ equations.G).T, equations.G),
    ):
        worst = np.max(np.abs(coupling), axis=0, initial=0.0)
        if np.any(worst > INDEX_TOLERANCE * np.max(np.abs(size), initial=0.0)):
            raise IndexAboveOneError(int(np.argmax(np.abs(static[:, int(np.argmax(worst))]))))


def check_regular(matrix: Array, terms: Array, velocities: list[int]) -> None:
    """Raise unless a matrix, made of larger terms, is regular."""
    _, sigma, directions = np.linalg.svd(matrix)
    if sigma[-1] <= INDEX_TOLERANCE * np.max(np.abs(terms), initial=0.0) or sigma[-1] == 0.0:
        raise IndexAboveOneError(velocities[int(np.argmax(np.abs(directions[-1])))])


def rate_of(signal: Array, rates: Array, n_u: int) -> Array:
    """Rate of a signal that holds no rate of an input; an input's rate takes the place of the input."""
    states = len(rates)
    result = signal[:, :states] @ rates
    result[:, states + n_u :] += signal[:, states : states + n_u]
    return np.asarray(result)
