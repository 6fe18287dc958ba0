"""Tangent stiffness: what preloads do when the geometry that carries them turns.

Each connection follows one law for finite motion, of which this is the exact first order. The force f acts on
the first body at its place and, reversed, on the second body at that same spot:

* a line pulls along the line between its ends;
* a point's force keeps its direction in the axes of the second body (plane, road, bushing), and its moment
  turns half with each body, as that of an elastic potential of the relative rotation vector does;
* with an `upright` axis z, fixed on the second body, the moment is u x z with u fixed on the first body;
* the contact point of a rolling body stays where the second body's plane touches: turning about the rolling axis
  relative to that plane does not carry it along.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from eom.assembly.algebra import Entry, square_entry
from eom.assembly.rows import arm, force_directions
from eom.assembly.vectors import Array, directions, skew, unit, zeros
from eom.vehicle.elements import Body, Connection

X1, THETA1, X2, THETA2 = (slice(3 * k, 3 * k + 3) for k in range(4))


def preload(connection: Connection, reactions: Array) -> tuple[Array, Array]:
    """Force [N] and moment [N m] on the first body, from one reaction per direction."""
    along = force_directions(connection)
    about = directions(connection.moments, connection.moment_axis)
    return along.T @ reactions[: len(along)], about.T @ reactions[len(along) :]


def force_change(connection: Connection, f: Array, arm_1: Array, arm_2: Array) -> Array:
    """Change of the force f on the first body, shape (3, 12), per motion (x1, theta1, x2, theta2)."""
    if connection.line:
        span = np.subtract(connection.places[1], connection.places[0])
        n = unit(span)
        turn = (np.eye(3) - np.outer(n, n)) * ((f @ n) / (span @ n))
        change = zeros((3, 12), turn, arm_1, arm_2)
        change[:, X1], change[:, THETA1] = -turn, turn @ skew(arm_1)
        change[:, X2], change[:, THETA2] = turn, -turn @ skew(arm_2)
    else:
        change = zeros((3, 12), f)
        change[:, THETA2] = -skew(f)
    return change


def moment_change(connection: Connection, m: Array) -> Array:
    """Change of the moment m on the first body, shape (3, 12)."""
    if connection.upright is None:
        change = zeros((3, 12), m)
        change[:, THETA1] = change[:, THETA2] = -0.5 * skew(m)
    else:
        z = unit(connection.upright)
        Sz = skew(z)
        Su = skew(Sz @ m)
        change = zeros((3, 12), Su, Sz)
        change[:, THETA1] = Sz @ Su
        change[:, THETA2] = -Su @ Sz
    return change


def arm_changes(connection: Connection, arm_1: Array, arm_2: Array) -> tuple[Array, Array]:
    """Changes of the arms from both centres to where the force acts, each of shape (3, 12)."""
    carried = np.eye(3)
    if connection.rolling_axis is not None:
        rho = unit(connection.rolling_axis)
        # of a cambered wheel the part of its axis along the road's normal still carries the contact point
        n = unit(connection.force_axis) if connection.forces == 1 else np.zeros(3)
        k = rho - n * (n @ rho)
        carried = carried - np.outer(rho, k) / (k @ rho)
    first, second = (zeros((3, 12), carried, arm_1, arm_2) for _ in range(2))
    first[:, THETA1] = -skew(arm_1) @ carried
    if connection.line:
        second[:, THETA2] = -skew(arm_2)
        return first, second
    # what the first body's turning about its rolling axis does not do, the second one's does
    first[:, THETA2] = -skew(arm_1) @ (np.eye(3) - carried)
    second += first
    second[:, X1] += np.eye(3)
    second[:, X2] -= np.eye(3)
    return first, second


def connection_tangent(bodies: Sequence[Body], connection: Connection, reactions: Array) -> Array:
    """Tangent stiffness of one connection, shape (12, 12), on (x1, theta1, x2, theta2) in body axes."""
    f, m = preload(connection, reactions)
    c1, c2 = arm(bodies, connection, 0), arm(bodies, connection, 1)
    df, dm = force_change(connection, f, c1, c2), moment_change(connection, m)
    dc1, dc2 = arm_changes(connection, c1, c2)
    Sf, S1, S2 = skew(f), skew(c1), skew(c2)
    wrench = zeros((12, 12), df, dm, dc1, dc2, Sf, S1, S2)
    wrench[X1], wrench[X2] = df, -df
    wrench[THETA1] = S1 @ df - Sf @ dc1 + dm
    wrench[THETA2] = Sf @ dc2 - S2 @ df - dm
    # resolved in axes that turn with each body
    wrench[X1, THETA1] += Sf
    wrench[THETA1, THETA1] += skew(S1 @ f + m)
    wrench[X2, THETA2] -= Sf
    wrench[THETA2, THETA2] -= skew(S2 @ f + m)
    return -wrench


def tangent_entries(bodies: Sequence[Body], carried: Sequence[tuple[Connection, Array]]) -> Iterator[Entry]:
    """Tangent stiffness of connections, each given with its reactions, over all coordinates."""
    for connection, reactions in carried:
        if np.any(reactions):
            yield square_entry(connection.bodies, connection_tangent(bodies, connection, reactions))
