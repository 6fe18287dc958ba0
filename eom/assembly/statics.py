"""Equilibrium of the trim: constraint reactions and preloads, by statics alone or with the help of stiffness."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.vehicle.elements import Body, Elastic

RANK_TOLERANCE = 1e-10
BALANCE_TOLERANCE = 1e-9


class Statics(NamedTuple):
    """The solved equilibrium.

    Attributes
    ----------
    reactions : Array
        One per constraint row, positive along its direction on the first body [N, N m].
    tensions : Array
        One per elastic row, zero where the row has no stiffness [N, N m].
    residual : Array
        What remains unbalanced on each coordinate, shape (6 n,) [N, N m].
    limit : float
        The largest residual that rounding explains [N, N m].
    determinate : bool
        True if statics alone gives every reaction.
    deflection : Array
        Small displacement that the loads cause from the unloaded state, shape (6 n,), zero if determinate.
    """

    reactions: Array
    tensions: Array
    residual: Array
    limit: float
    determinate: bool
    deflection: Array


def elastic_coefficients(elastic: Sequence[Elastic], which: str) -> Array:
    """Stiffness or damping of each elastic row, in the order of `stack`."""
    values = [np.zeros(0)]
    for item in elastic:
        forces = 1 if item.connection.line else item.connection.forces
        linear, angular = item.stiffness if which == "stiffness" else item.damping
        values.append(np.concatenate([np.full(forces, linear), np.full(item.connection.moments, angular)]))
    return np.concatenate(values).astype(np.float64)


def length_scales(bodies: Sequence[Body]) -> Array:
    """Divisors, shape (6 n,), that make moments comparable with forces: 1 and the vehicle's size [m]."""
    centres = np.array([body.centre for body in bodies], dtype=float)
    size = max(1.0, float(np.max(np.ptp(centres, axis=0))))
    return np.tile([1.0, 1.0, 1.0, size, size, size], len(bodies))


def equilibrium(bodies: Sequence[Body], J: Array, H: Array, stiffness: Array, loads: Array) -> Statics:
    """Solve f + J' reactions + H' tensions = 0 for rows that can carry load, f the sum of the rows of *loads*.

    Where statics leaves them open, the elastic rows share the load as their stiffness demands, from a state
    without preload; what is still open then takes the smallest reactions.
    """
    scale, f = length_scales(bodies), np.sum(loads, axis=0)
    carrying = stiffness != 0.0
    Hc, k = H[carrying], stiffness[carrying]
    T = np.hstack([J.T, Hc.T]) / scale[:, np.newaxis]
    found = np.linalg.lstsq(T, -f / scale, rcond=RANK_TOLERANCE)
    solution: Array = np.asarray(found[0], dtype=np.float64)
    rank = found[2]
    determinate = int(rank) == T.shape[1]
    deflection = np.zeros(len(f))
    if not determinate:
        solution, deflection = share_by_stiffness(J / scale, Hc / scale, k, f / scale)
        deflection /= scale
    reactions, tensions = solution[: len(J)], np.zeros(len(H))
    tensions[carrying] = solution[len(J) :]
    residual = f + J.T @ reactions + H.T @ tensions
    # rounding is measured by what is added up, not by the sum
    acting = np.sum(np.abs(loads), axis=0) + np.abs(J.T) @ np.abs(reactions) + np.abs(H.T) @ np.abs(tensions)
    limit = BALANCE_TOLERANCE * float(np.max(acting / scale, initial=0.0))
    return Statics(reactions, tensions, residual, limit, determinate, deflection)


def share_by_stiffness(J: Array, H: Array, k: Array, f: Array) -> tuple[Array, Array]:
    """Reactions with tensions, and deflection, of an elastic structure under the loads *f*."""
    n, q = J.shape[1], len(J)
    # in units of the stiffest spring, so that the rows of constraints and springs are comparable
    unit_stiffness = float(np.max(k, initial=0.0)) or 1.0
    system = np.zeros((q + n, q + n))
    system[:q, q:] = J
    system[q:, :q] = J.T
    system[q:, q:] = -(H.T * (k / unit_stiffness)) @ H
    right = np.concatenate([np.zeros(q), -f])
    solution = np.linalg.lstsq(system, right, rcond=RANK_TOLERANCE)[0]
    motion = solution[q:]
    tensions = -(k / unit_stiffness) * (H @ motion)
    return np.concatenate([solution[:q], tensions]), motion / unit_stiffness


def unbalanced(bodies: Sequence[Body], statics: Statics) -> NDArray[np.intp]:
    """Indices of the coordinates whose residual is more than rounding, the largest first."""
    size = np.abs(statics.residual) / length_scales(bodies)
    order = np.argsort(-size, kind="stable")
    return order[size[order] > statics.limit]
