"""What a vehicle tells of itself at a state: measured motions, paths, slips, forces, loads, what couplings carry."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.matrices import DISPLACEMENTS, VELOCITIES
from eom.assembly.vectors import Array
from eom.splice.motion import body_velocity, headed
from eom.splice.state import Balance, Evaluation, Model, Motion, State
from eom.splice.wheels import slip_speed

POSITION, VELOCITY, ACCELERATION = range(3)


class Signals(NamedTuple):
    """What outputs are made of; k measured outputs, m units, c couplings, w wheels, N = 6 bodies.

    Attributes
    ----------
    rows, quantity, inertial, feedthrough : Array
        Rows of the measured motions, (k, N), what of them is measured, whether in inertial axes, and direct gains of
        the inputs, (k, u).
    points, point_at, axis, whole : Array
        Of translations against the ground: rows of the point's translation along x, y, z, (3, k, N), its place counted
        from the first body, (k, 2) [m], its direction, (k, 3), and the sum of the weights; zero for others.
    trim_speed : float
        By which the rows of sideslips are divided [m/s].
    slipping : NDArray
        Unit whose sideslip a measured output is, -1 for others, (k,).
    centres : Array
        Places of the bodies at the trim, counted from the first one, (bodies, 2) [m].
    weights : Array
        Shares of the bodies in their unit's mass, (m, bodies).
    leads : NDArray
        First bodies of the units.
    ahead, own, centre : Array
        From the lead body of the unit ahead to the coupling, from there to the own lead body, and from that to the
        whole-mass centre, each along the heading of what it belongs to, (m, 2) [m].
    axles, units : Array
        One where a wheel belongs to an axle, or to a unit, (axles, w) and (m, w).
    side : Array
        1 for left wheels, -1 for right ones, 0 for axles taken as one, (w,).
    carried : Array
        Forces of couplings on the towed unit, along the axes of the towing one, by reactions, (3 c, rows).
    """

    rows: Array
    quantity: NDArray[np.intp]
    inertial: NDArray[np.bool_]
    feedthrough: Array
    points: Array
    point_at: Array
    axis: Array
    whole: Array
    trim_speed: float
    slipping: NDArray[np.intp]
    centres: Array
    weights: Array
    leads: NDArray[np.intp]
    ahead: Array
    own: Array
    centre: Array
    axles: Array
    units: Array
    side: Array
    carried: Array


def placed(found: Evaluation, s: Signals) -> Any:
    """Displacements of all bodies from the drawing, (N,): the moving frame's exactly, small ones in its axes."""
    at = found.motion
    x, y, yaw = found.state.frame
    result = at.displaced + 0.0
    X, Y = s.centres[:, 0] + at.displaced[0::6], s.centres[:, 1] + at.displaced[1::6]
    cos, sin = np.cos(yaw), np.sin(yaw)
    result[0::6] = x + cos * X - sin * Y - s.centres[:, 0]
    result[1::6] = y + sin * X + cos * Y - s.centres[:, 1]
    result[5::6] += yaw
    return result


def body_rates(found: Evaluation) -> Any:
    """Velocities of all bodies in their own axes, (N,)."""
    return body_velocity(found.motion, found.motion.w[0])


def body_coordinates(found: Evaluation, bodies: Sequence[str], s: Signals) -> dict[str, float]:
    """Displacements from the drawing and velocities in their own axes of all bodies, by name."""
    names = [f"{body}.{name}" for kind in (DISPLACEMENTS, VELOCITIES) for body in bodies for name in kind]
    values = np.concatenate((placed(found, s), body_rates(found)))
    return dict(zip(names, map(float, values), strict=True))


def turned_by(yaw: Any, offsets: Any) -> Any:
    """Planar offsets, (m, 2), turned by an angle each."""
    cos, sin = np.cos(yaw), np.sin(yaw)
    x, y = offsets[:, 0], offsets[:, 1]
    return np.stack((cos * x - sin * y, sin * x + cos * y), axis=1)


def paths(state: State, at: Motion, s: Signals) -> Any:
    """Place of each unit's whole-mass centre [m] and its heading [rad] in the plane, (m, 3); exact at any angle."""
    yaw = state.frame[2] + at.displaced[5::6][s.leads]
    ahead = turned_by(np.concatenate((state.frame[2:3], yaw[:-1])), s.ahead)
    lead = state.frame[:2] + np.cumsum(ahead + turned_by(yaw, s.own), axis=0)
    return np.concatenate((lead + turned_by(yaw, s.centre), yaw[:, np.newaxis]), axis=1)


def local_acceleration(state: State, at: Motion, found: Balance, p: Model) -> Any:
    """Accelerations of all bodies along their own headings, angular ones in body axes, (N,)."""
    yaw_rate = state.n[p.body.lead[2]]
    acceleration = found.dw + 0.0
    acceleration[0::6] -= yaw_rate * at.w[1::6]
    acceleration[1::6] += yaw_rate * at.w[0::6]
    return headed(acceleration, -at.displaced[5::6])


def measured(found: Evaluation, u: Any, p: Model, s: Signals) -> Any:
    """The measured motions, (k,).

    Velocities are whole ones. Translations against the ground are those of the point, at any heading. Accelerations
    are resolved along each body's own heading; those in body axes are rates of change of the components.
    """
    state, at, _, balance = found
    velocity, acceleration = body_rates(found), local_acceleration(state, at, balance, p)
    changing = acceleration.reshape(-1, 6) + 0.0
    by_body = velocity.reshape(-1, 6)
    changing[:, :3] -= np.cross(by_body[:, 3:], by_body[:, :3])
    grounded = s.whole != 0.0
    heading, centripetal = state.frame[2], at.w[5::6] * at.w[5::6]
    # an arm (a, b) of a point turns it by yaw into (-b, a), and pulls it in by -(a, b) times the rate squared
    inward = s.axis[:, 1] * (s.points[0][:, 5::6] @ centripetal) - s.axis[:, 0] * (s.points[1][:, 5::6] @ centripetal)
    kinds = np.stack(
        (
            np.where(grounded, point_displacement(found, s), s.rows @ at.displaced + whole_turn(heading, s)),
            np.where(s.inertial, point_velocity(at, heading, grounded, s), s.rows @ velocity),
            np.where(s.inertial, s.rows @ acceleration + inward, s.rows @ changing.ravel()),
        )
    )
    result = kinds[s.quantity, np.arange(len(s.quantity))] + s.feedthrough @ u
    slipping = s.slipping >= 0
    forward = (s.weights @ at.local[0::6])[s.slipping[slipping]]
    result[slipping] = np.arctan(result[slipping] * s.trim_speed / slip_speed(forward))
    return result


def whole_turn(heading: Any, s: Signals) -> Any:
    """What the heading of the whole adds to measured rotations, (k,)."""
    return heading * np.sum(s.rows[:, 5::6], axis=1) * (1.0 - (s.whole != 0.0))


def point_displacement(found: Evaluation, s: Signals) -> Any:
    """Displacements of measured points from the drawing, along their directions, (k,)."""
    x, y, yaw = found.state.frame
    dx, dy, dz = (rows @ found.motion.displaced for rows in s.points)
    X, Y = s.point_at[:, 0] + dx, s.point_at[:, 1] + dy
    cos, sin = np.cos(yaw), np.sin(yaw)
    along = (
        s.whole * x + cos * X - sin * Y - s.point_at[:, 0],
        s.whole * y + sin * X + cos * Y - s.point_at[:, 1],
        dz,
    )
    return s.axis[:, 0] * along[0] + s.axis[:, 1] * along[1] + s.axis[:, 2] * along[2]


def point_velocity(at: Motion, heading: Any, grounded: Any, s: Signals) -> Any:
    """Velocities of measured points along their directions in inertial axes, (k,); other motions as they are."""
    v_x, v_y, v_z = (rows @ at.w for rows in s.points)
    cos, sin = np.cos(heading), np.sin(heading)
    along = s.axis[:, 0] * (cos * v_x - sin * v_y) + s.axis[:, 1] * (sin * v_x + cos * v_y) + s.axis[:, 2] * v_z
    return np.where(grounded, along, s.rows @ at.w)


def transfer(load: Any, belonging: Any, side: Any) -> Any:
    """Load transfer ratio of axles or units: left less right load over both, 0 without load."""
    both = (belonging * np.abs(side)) @ load
    some = both > 0.0
    return np.where(some, (belonging @ (side * load)) / np.where(some, both, 1.0), 0.0)


def all_outputs(found: Evaluation, u: Any, p: Model, s: Signals) -> Any:
    """All outputs, in the order of `eom.splice.signals.output_names`."""
    state, at, slip, balance = found
    acceleration = local_acceleration(state, at, balance, p)
    Fx, Fy, _, _, Mz = balance.forces
    wheels = np.stack((slip.alpha, slip.kappa, Fx, Fy, balance.load, Mz), axis=1)
    forward = s.weights @ at.local[0::6]
    unit = np.concatenate((np.stack((s.weights @ acceleration[0::6], forward), axis=1), paths(state, at, s)), axis=1)
    return np.concatenate(
        (
            measured(found, u, p, s),
            unit.ravel(),
            wheels.ravel(),
            transfer(balance.load, s.axles, s.side),
            transfer(balance.load, s.units, s.side),
            s.carried @ balance.reactions,
        )
    )
