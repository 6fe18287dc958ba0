"""Exact motion in the plane of a train of rigid units: any heading and articulation, nonlinear tyres, wheels that spin.

Units are joined by pins without friction. Newton and Euler are written for every unit in inertial axes, with the forces
in the pins as unknowns beside the accelerations, and solved as they stand: no angle is small, nothing is eliminated
by hand. Nothing tilts, so loads of wheels are constant. Only the tyre's own forces and its slips come from `eom`.

Axes are those of ISO 8855: x forward, y left, yaw and steer positive to the left. Places of a unit are measured from
its centre of mass. SI units and radians.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from eom.tyre import slips
from tests.referees.planar_parts import Array, Contacts, Motion, PlanarTrain, PlanarWheel, State, split


def rhs(train: PlanarTrain, state: ArrayLike, steer: Sequence[float] | Array, torque: Sequence[float] | Array) -> Array:
    """Derivative of the state over time; arguments as in `accelerations`."""
    now, motion = split(train, state), accelerations(train, state, steer, torque)
    turning = -now.yaw_rate[0] * left_of(now.velocity)
    parts = (
        axes(now.yaw[0]) @ now.velocity,
        now.yaw_rate,
        motion.acceleration[0] + turning,
        motion.yaw_acceleration,
        motion.spin_acceleration,
    )
    return np.concatenate(parts)


def accelerations(
    train: PlanarTrain, state: ArrayLike, steer: Sequence[float] | Array, torque: Sequence[float] | Array
) -> Motion:
    """Accelerations, pin forces and contacts of a train.

    Parameters
    ----------
    train : PlanarTrain
    state : array
        As in `State`.
    steer : array
        Steer angles that wheels refer to, rad; any number of them.
    torque : array
        Torque on each wheel about its axle, N m, shape (wheels,): drive less brake, positive turns it forward.
    """
    now, units, pins = split(train, state), train.units, train.pins
    n, turned = len(units), [axes(yaw) for yaw in now.yaw]
    velocity = [turned[0] @ now.velocity]
    for k, (rear, front) in enumerate(pins):
        at_pin = velocity[k] + now.yaw_rate[k] * left_of(turned[k] @ [rear, 0.0])
        velocity.append(at_pin - now.yaw_rate[k + 1] * left_of(turned[k + 1] @ [front, 0.0]))
    own = np.array([turned[k].T @ velocity[k] for k in range(n)])

    contacts = roll(train, own, now, steer, torque)
    load = np.zeros((n, 3))  # force in the unit's axes, moment about its centre
    for j, (k, wheel) in enumerate(train.placed):
        forward, left = axes(angle_of(wheel, steer)) @ [contacts.Fx[j], contacts.Fy[j]]
        load[k] += wheel.count * np.array([forward, left, wheel.x * left - wheel.y * forward + contacts.Mz[j]])
    load[:, 0] -= [unit.drag(own[k, 0]) for k, unit in enumerate(units)]

    # Unknowns: acceleration of each centre and yaw acceleration, then each pin's force on the unit behind over the mass
    # of the train, which keeps all entries of one size. Rows: Newton and Euler per unit; equal acceleration at pins.
    total = sum(unit.mass for unit in units)
    matrix, right = np.eye(3 * n + 2 * len(pins)), np.zeros(3 * n + 2 * len(pins))
    for k, unit in enumerate(units):
        right[3 * k : 3 * k + 3] = [*(turned[k] @ load[k, :2] / unit.mass), load[k, 2] / unit.yaw_inertia]
    for j, ends in enumerate(pins):
        rows = slice(3 * n + 2 * j, 3 * n + 2 * j + 2)
        matrix[rows, rows] = 0.0
        for k, x, sign in ((j, ends[0], -1.0), (j + 1, ends[1], 1.0)):
            arm = turned[k] @ [x, 0.0]
            matrix[3 * k : 3 * k + 2, rows] -= sign * total / units[k].mass * np.eye(2)
            matrix[3 * k + 2, rows] += sign * total / units[k].yaw_inertia * np.array([arm[1], -arm[0]])
            matrix[rows, 3 * k : 3 * k + 2] = sign * np.eye(2)
            matrix[rows, 3 * k + 2] = sign * left_of(arm)
            right[rows] += sign * now.yaw_rate[k] ** 2 * arm
    solved = np.linalg.solve(matrix, right)
    moving, force = solved[: 3 * n].reshape(n, 3), total * solved[3 * n :].reshape(-1, 2)

    spinning = [
        (applied - wheel.radius * Fx + My) / wheel.spin_inertia
        for (_, wheel), applied, Fx, My in zip(train.placed, torque, contacts.Fx, contacts.My, strict=True)
        if wheel.spin_inertia
    ]
    return Motion(
        velocity=own,
        acceleration=np.array([turned[k].T @ moving[k, :2] for k in range(n)]),
        yaw_acceleration=np.array(moving[:, 2]),
        spin_acceleration=np.array(spinning),
        pin_force=np.array([turned[k].T @ each for k, each in enumerate(force)]).reshape(-1, 2),
        contacts=contacts,
    )


def roll(
    train: PlanarTrain, velocity: Array, now: State, steer: Sequence[float] | Array, torque: Sequence[float] | Array
) -> Contacts:
    """Slips of all wheels and the road's forces on them, by the velocities of the units' centres in their own axes."""
    found, spins = [], iter(now.spin)
    for (k, wheel), applied in zip(train.placed, torque, strict=True):
        here = velocity[k] + now.yaw_rate[k] * left_of([wheel.x, wheel.y])
        v_x, v_y = axes(angle_of(wheel, steer)).T @ here
        spin = next(spins) if wheel.spin_inertia else v_x / wheel.radius
        alpha, kappa = (float(slip) for slip in slips(v_x, v_y, spin, wheel.radius))
        force = wheel.tyre(alpha, kappa, wheel.load, 0.0, v_x)
        Fx = force.Fx if wheel.spin_inertia else (applied + force.My) / wheel.radius
        found.append([alpha, kappa, v_x, v_y, Fx, force.Fy, force.My, force.Mz])
    return Contacts(*np.array(found, dtype=float).reshape(-1, len(Contacts._fields)).T)


def angle_of(wheel: PlanarWheel, steer: Sequence[float] | Array) -> float:
    """Steer angle of a wheel, rad."""
    return 0.0 if wheel.steer_index is None else float(steer[wheel.steer_index])


def axes(angle: float) -> Array:
    """Columns: the axes of something turned to the left by an angle."""
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def left_of(arm: ArrayLike) -> Array:
    """An arm turned by a right angle to the left: the velocity of its end at 1 rad/s."""
    x, y = np.asarray(arm, dtype=float)
    return np.array([-y, x])
