"""What a vehicle tells of itself at a state: measured motions, paths, slips, forces, loads, what couplings carry."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.matrices import DISPLACEMENTS, VELOCITIES
from eom.assembly.vectors import Array
from eom.splice.motion import body_velocity, headed
from eom.splice.state import Balance, Evaluation, Model, Motion, State

POSITION, VELOCITY, ACCELERATION = range(3)


class Signals(NamedTuple):
    """What outputs are made of; k measured outputs, m units, c couplings, w wheels, N = 6 bodies.

    Attributes
    ----------
    rows, quantity, inertial, feedthrough : Array
        Rows of the measured motions, (k, N), what of them is measured, whether in inertial axes, and direct gains of
        the inputs, (k, u).
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
    ahead = turned_by(np.concatenate((yaw[:1], yaw[:-1])), s.ahead)
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

    Velocities are whole ones. Accelerations are resolved along each body's own heading; those in body axes are rates
    of change of the components.
    """
    state, at, _, balance = found
    velocity, acceleration = body_rates(found), local_acceleration(state, at, balance, p)
    changing = acceleration.reshape(-1, 6) + 0.0
    by_body = velocity.reshape(-1, 6)
    changing[:, :3] -= np.cross(by_body[:, 3:], by_body[:, :3])
    inertial = headed(at.w, state.frame[2] + 0.0 * at.displaced[5::6])
    kinds = np.stack(
        (
            s.rows @ placed(found, s),
            np.where(s.inertial, s.rows @ inertial, s.rows @ velocity),
            np.where(s.inertial, s.rows @ acceleration, s.rows @ changing.ravel()),
        )
    )
    result = kinds[s.quantity, np.arange(len(s.quantity))] + s.feedthrough @ u
    slipping = s.slipping >= 0
    forward = (s.weights @ at.local[0::6])[s.slipping[slipping]]
    result[slipping] = np.arctan(result[slipping] * s.trim_speed / forward)
    return result


def transfer(load: Any, belonging: Any, side: Any) -> Any:
    """Load transfer ratio of axles or units: left less right load over both, 0 without load."""
    both = belonging @ load
    some = both != 0.0
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
