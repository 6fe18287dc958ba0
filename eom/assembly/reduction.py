"""From full coordinates to the minimal state space, with pivots chosen beforehand.

Displacements p = T q follow independent ones, velocities w = W n + Z q independent velocities n, where T and W
are identities on the chosen coordinates. Motions that change nothing (position and heading on a plane, the
angle of a wheel) have columns of exact zeros: the other coordinates are then counted from them.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.matrices import Matrices
from eom.assembly.rows import rows, six
from eom.assembly.vectors import Array, skew, unit
from eom.vehicle.elements import Body, System

CYCLIC_TOLERANCE = 1e-11
ROUNDING = 1e-11
# below this the reduced equations would lose more than half of their digits
PIVOT_TOLERANCE = 1e-6
MASS_TOLERANCE = 1e-10


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
    cyclic_motions : tuple of int
        Motions that change nothing: 0 to 5 of the whole system, 6 + i the spin of body i.
    cyclic : tuple of int
        Independent coordinate that stands for each of them.
    """

    rows: tuple[int, ...]
    dependent: tuple[int, ...]
    rolling_rows: tuple[int, ...] = ()
    rolling_dependent: tuple[int, ...] = ()
    cyclic_motions: tuple[int, ...] = ()
    cyclic: tuple[int, ...] = ()


class Reduction(NamedTuple):
    """p = T q, w = W n + Z q; ``independent`` coordinates q, ``independent_velocities`` n (indices of w)."""

    T: Array
    W: Array
    Z: Array
    independent: Array
    independent_velocities: Array


class RateError(ValueError):
    """An acceleration that would need the rate of an input."""

    def __init__(self, output: str, name: str) -> None:
        self.output = output
        what = "measure a body that the moving damper does not act on"
        super().__init__(f"output {output} would follow the rate of input {name}: {what}")


class StateSpace(NamedTuple):
    """dx/dt = A x + B u, y = C x + D u, with x = (q, n)."""

    A: Array
    B: Array
    C: Array
    D: Array


def complement(J: Array, dependent: Sequence[int]) -> tuple[Array, Array]:
    """Independent columns of J, and T of p = T q with J T = 0, an identity on them.

    Raises ``ValueError`` if the dependent coordinates no longer follow from the rows.
    """
    n = J.shape[1]
    chosen = list(dependent)
    independent = np.setdiff1d(np.arange(n), chosen)
    T = np.zeros((n, len(independent)))
    T[independent, np.arange(len(independent))] = 1.0
    if chosen:
        Jd = J[:, chosen]
        smallest = float(np.linalg.svd(Jd, compute_uv=False)[-1])
        if smallest <= PIVOT_TOLERANCE * float(np.max(np.abs(J))):
            message = "the constraints no longer determine the chosen dependent coordinates: choose them anew"
            raise ValueError(message)
        T[chosen] = -np.linalg.solve(Jd, J[:, independent])
    return independent, T


def reduce_coordinates(matrices: Matrices, pivots: Pivots) -> Reduction:
    """Solve the constraints for the dependent coordinates and velocities."""
    J = matrices.J[list(pivots.rows)]
    independent, T = complement(J, pivots.dependent)
    Z = np.zeros_like(T)
    if pivots.dependent:
        chosen = list(pivots.dependent)
        Z[chosen] = np.linalg.solve(J[:, chosen], J @ matrices.V @ T)
    Jn = matrices.Jn[list(pivots.rolling_rows)]
    kept, Tn = complement(Jn @ T, pivots.rolling_dependent)
    if pivots.rolling_dependent:
        lost = list(pivots.rolling_dependent)
        Z -= T[:, lost] @ np.linalg.solve((Jn @ T)[:, lost], Jn @ Z)
    W = T @ Tn
    # a rolling row that depends on the joints is left out above: it must hold by itself
    if np.any(np.abs(matrices.Jn @ Z) > ROUNDING * (np.abs(matrices.Jn) @ np.abs(Z) + np.max(np.abs(Z), initial=0.0))):
        message = "a rolling condition contradicts the joints: they let it hold only at one displacement"
        raise ValueError(message)
    return Reduction(T, W, Z, independent, independent[kept])


def massless_motion(matrices: Matrices, reduction: Reduction) -> int | None:
    """Coordinate that moves most in a motion without mass, or None if every motion has mass."""
    mass = reduction.W.T @ matrices.M @ reduction.W
    scale = np.sqrt(np.maximum(np.diag(mass), 1e-300))
    values, vectors = np.linalg.eigh(mass / np.outer(scale, scale))
    weightless = np.flatnonzero(np.diag(mass) <= 0.0)
    if weightless.size:
        return int(reduction.independent_velocities[weightless[0]])
    if values.size == 0 or values[0] > MASS_TOLERANCE:
        return None
    motion = reduction.W @ (vectors[:, 0] / scale)
    return int(np.argmax(np.abs(motion)))


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


def state_matrix(matrices: Matrices, reduction: Reduction) -> tuple[Array, Array]:
    """A of the states (q, n), and the reduced mass matrix W' M W."""
    T, W, Z, at = reduction.T, reduction.W, reduction.Z, reduction.independent
    q_q = (Z - matrices.V @ T)[at]
    q_n = W[at]
    mass = W.T @ matrices.M @ W
    n_q = W.T @ (matrices.M @ Z @ q_q + matrices.C @ Z + matrices.K @ T)
    n_n = W.T @ (matrices.M @ Z @ q_n + matrices.C @ W)
    accelerations = np.linalg.solve(mass, np.hstack([n_q, n_n]))
    return np.vstack([np.hstack([q_q, q_n]), -accelerations]), mass


def cyclic_basis(bodies: Sequence[Body], reduction: Reduction, pivots: Pivots) -> Array:
    """Cyclic motions in q, shape (q, cyclic), each one moving its own cyclic coordinate by one."""
    basis = np.zeros((len(reduction.independent), len(pivots.cyclic)))
    for k, (motion, coordinate) in enumerate(zip(pivots.cyclic_motions, pivots.cyclic, strict=True)):
        if motion >= 6 and not np.any(bodies[motion - 6].spin):
            # a wheel at rest has no spin to tell its axis: its coordinate does
            basis[coordinate, k] = 1.0
        else:
            basis[:, k] = cyclic_motion(bodies, motion)[reduction.independent]
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
    n_q, cyclic = len(reduction.independent), list(pivots.cyclic)
    basis = np.zeros((len(A), len(cyclic)))
    basis[:n_q] = cyclic_basis(bodies, reduction, pivots)
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


def output_matrices(
    system: System, V: Array, positions: Array, velocities: Array, rates: tuple[Array, Array]
) -> tuple[Array, Array]:
    """C and D of the outputs; p and w per state, and dw/dt per state and per input."""
    acceleration, direct = rates
    moving = velocities - V @ positions
    per_state = {
        ("position", "inertial"): positions,
        ("velocity", "body"): velocities,
        ("velocity", "inertial"): moving,
        ("acceleration", "body"): acceleration,
        ("acceleration", "inertial"): acceleration - V @ moving,
    }
    names = [item.name for item in system.inputs]
    C = np.zeros((len(system.outputs), positions.shape[1]))
    D = np.zeros((len(system.outputs), len(names)))
    for k, output in enumerate(system.outputs):
        row = output_row(system, k)
        C[k] = row @ per_state[output.quantity, output.frame]
        if output.quantity == "acceleration":
            D[k] = row @ direct
        for name, gain in output.feedthrough:
            D[k, names.index(name)] += gain
    return C, D


def output_row(system: System, index: int) -> Array:
    """Row of output *index* on the motion of all bodies, shape (6 n,)."""
    row = np.zeros(6 * len(system.bodies))
    for weight, connection in system.outputs[index].terms:
        row += weight * rows(system.bodies, connection)[0]
    return row


def state_space(system: System, matrices: Matrices, pivots: Pivots) -> StateSpace:
    """Minimal state space with accelerations that include the constraint reactions.

    Where an input acts through its rate (a damper moved at its far end), the velocities n are counted less the
    jump that the input gives them, so that only u itself remains. Raises `RateError` for an acceleration
    that would need the rate of an input, ``ValueError`` for a motion without mass.
    """
    reduction = reduce_coordinates(matrices, pivots)
    if massless_motion(matrices, reduction) is not None:
        message = "a motion has no mass: give its bodies mass or inertia"
        raise ValueError(message)
    A, mass = state_matrix(matrices, reduction)
    W, n_q = reduction.W, len(reduction.independent)
    B = np.zeros((len(A), len(system.inputs)))
    B[n_q:] = np.linalg.solve(mass, W.T @ matrices.F)
    jump = np.zeros_like(B)
    jump[n_q:] = np.linalg.solve(mass, W.T @ matrices.G)
    positions = np.hstack([reduction.T, np.zeros_like(W)])
    velocities = np.hstack([reduction.Z, W])
    for k, output in enumerate(system.outputs):
        row = output_row(system, k) @ velocities
        needed = np.abs(row @ jump) > ROUNDING * (np.abs(row) @ np.abs(jump))
        if output.quantity == "acceleration" and np.any(needed):
            raise RateError(output.name, system.inputs[int(np.argmax(needed))].name)
    C, D = output_matrices(system, matrices.V, positions, velocities, (velocities @ A, velocities @ B))
    B, D = B + A @ jump, D + C @ jump
    A, X, X_inverse = count_from_cyclic(A, system.bodies, reduction, pivots)
    C = C @ X
    cyclic = list(pivots.cyclic)
    size = np.max(np.abs(C), axis=1, initial=0.0)[:, np.newaxis]
    C[:, cyclic] = np.where(np.abs(C[:, cyclic]) <= CYCLIC_TOLERANCE * size, 0.0, C[:, cyclic])
    return StateSpace(A, X_inverse @ B, C, D)
