"""What a connection demands of the places and rotations of its two bodies, however far they have moved.

Every equation vanishes at the drawing, and its derivative there is the connection's row of the linear model:

* a force direction, fixed on the second body: the places' distance along it keeps its value;
* a line: the places keep their distance;
* one moment: the relative rotation, split into a turn about the axis and a tilt across it, has no turn (a
  constant-velocity joint);
* two moments: the axis stays the same line in both bodies; with an `upright` axis, the first body's directions
  stay normal to it;
* three moments: no relative rotation.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.analysis.rotation import IDENTITY, conjugate, exponential, matrix, product
from eom.assembly.rows import arm, six
from eom.assembly.vectors import Array, directions, skew, unit
from eom.vehicle.elements import GROUND, Body, Connection

X1, THETA1, X2, THETA2 = (slice(3 * k, 3 * k + 3) for k in range(4))


class Posture(NamedTuple):
    """Where all bodies are.

    Attributes
    ----------
    offsets : Array
        Displacements of the centres of mass from the drawing, inertial axes, shape (bodies, 3) [m].
    turns : Array
        Unit quaternions (w, x, y, z) of the rotations from the drawing, shape (bodies, 4).
    """

    offsets: Array
    turns: Array

    @classmethod
    def drawn(cls, bodies: int) -> "Posture":
        """The drawing."""
        return cls(np.zeros((bodies, 3)), np.tile(IDENTITY, (bodies, 1)))

    def moved(self, motion: Array) -> "Posture":
        """The posture after a motion: displacement and rotation vector of each body, inertial axes, (6 bodies,)."""
        steps = motion.reshape(-1, 6)
        turns = np.array([product(exponential(step[3:]), q) for step, q in zip(steps, self.turns, strict=True)])
        return Posture(self.offsets + steps[:, :3], turns / np.linalg.norm(turns, axis=1, keepdims=True))


class End(NamedTuple):
    """One end of a connection: its place [m], the arm from the body's centre to it, the body's rotation."""

    place: Array
    arm: Array
    R: Array
    turn: Array


def end(bodies: Sequence[Body], posture: Posture, connection: Connection, which: int) -> End:
    """The end of a connection on its first (0) or second (1) body."""
    index, drawn = connection.bodies[which], arm(bodies, connection, which)
    if index == GROUND:
        return End(drawn, drawn, np.eye(3), IDENTITY)
    R = matrix(posture.turns[index])
    moved = R @ drawn
    return End(np.asarray(bodies[index].centre) + posture.offsets[index] + moved, moved, R, posture.turns[index])


def force_equations(connection: Connection, first: End, second: End, value: float) -> tuple[Array, Array]:
    """Residuals [m] and derivatives, shape (forces, 12), on (x1, theta1, x2, theta2)."""
    d = first.place - second.place
    if connection.line:
        drawn = float(np.linalg.norm(np.subtract(*connection.places)))
        along = unit(-d)[np.newaxis]
        residual, turned = np.array([drawn - np.linalg.norm(d) - value]), np.zeros((1, 3))
    else:
        along = directions(connection.forces, connection.force_axis) @ second.R.T
        residual, turned = along @ d - value, along @ skew(d)
    derivative = np.zeros((len(along), 12))
    derivative[:, X1], derivative[:, THETA1] = along, -along @ skew(first.arm)
    derivative[:, X2], derivative[:, THETA2] = -along, turned + along @ skew(second.arm)
    return residual, derivative


def relative(first: End, second: End) -> Array:
    """Quaternion of the first body's rotation as seen from the second one, in the second one's axes."""
    return product(conjugate(second.turn), first.turn)


def moment_equations(connection: Connection, first: End, second: End, value: float) -> tuple[Array, Array]:
    """Residuals [rad] and derivatives, shape (moments, 12)."""
    about = directions(connection.moments, connection.moment_axis)
    if connection.upright is not None or connection.moments == 2:
        z = unit(connection.moment_axis if connection.upright is None else connection.upright)
        across, axis = -about @ skew(z) @ first.R.T, second.R @ z
        residual, turn = across @ axis, across @ skew(axis)
    else:
        q = relative(first, second)
        own = q[0] * about - about @ skew(q[1:])
        c, s = np.cos(0.5 * value), np.sin(0.5 * value)
        residual = 2.0 * (c * about @ q[1:] - s * q[0])
        turn = (c * own + s * q[1:]) @ second.R.T
    derivative = np.zeros((len(about), 12))
    derivative[:, THETA1], derivative[:, THETA2] = turn, -turn
    return residual, derivative


def equations(
    bodies: Sequence[Body], connection: Connection, posture: Posture, value: float = 0.0
) -> tuple[Array, Array]:
    """Residuals of a connection [m, then rad] and their derivatives on the motion of all bodies.

    *value* is what a one-directional connection is to measure: a displacement [m], or a turn about its axis [rad].
    The derivatives, shape (forces + moments, 6 bodies), are on displacements and rotation vectors in inertial axes.
    """
    first, second = end(bodies, posture, connection, 0), end(bodies, posture, connection, 1)
    pairs = [
        build(connection, first, second, value)
        for count, build in ((connection.forces, force_equations), (connection.moments, moment_equations))
        if count
    ]
    local = np.vstack([derivative for _, derivative in pairs])
    result = np.zeros((len(local), 6 * len(bodies)))
    for k, index in enumerate(connection.bodies):
        if index != GROUND:
            result[:, six(index)] = local[:, 6 * k : 6 * k + 6]
    return np.concatenate([residual for residual, _ in pairs]), result


def measured(bodies: Sequence[Body], connection: Connection, posture: Posture) -> float:
    """What a one-directional connection measures: displacement along [m] or turn about its axis [rad].

    The axis is fixed on the second body. A turn is told up to whole double turns, between -2 pi and 2 pi.
    """
    first, second = end(bodies, posture, connection, 0), end(bodies, posture, connection, 1)
    if connection.forces:
        return float(force_equations(connection, first, second, 0.0)[0][0])
    q = relative(first, second)
    return 2.0 * float(np.arctan2(unit(connection.moment_axis) @ q[1:], q[0]))


def scaled(derivative: Array, connection: Connection, length: float) -> Array:
    """Derivatives with rotations counted as *length* [m] times their angle, in rows and columns."""
    result = derivative.copy()
    columns = result.reshape(len(result), -1, 2, 3)
    columns[:, :, 1] /= length
    result[connection.forces :] *= length
    return result
