"""Rates of the states: the nonlinear equations of a vehicle with wheels."""

from typing import Any

import numpy as np

from eom.splice.balance import balance
from eom.splice.lanes import over_lanes
from eom.splice.motion import motion
from eom.splice.state import Evaluation, Model, split_state
from eom.splice.wheels import rolling, slip_speed


def evaluate(x: Any, u: Any, p: Model) -> Evaluation:
    """What a state and inputs mean."""
    state = split_state(x, p)
    at = motion(state, p)
    slip = rolling(state, u, at, p)
    return Evaluation(state, at, slip, balance(state, u, at, slip, p))


def rates(x: Any, u: Any, p: Model) -> Any:
    """dx/dt at a state x under inputs u."""
    return rates_of(evaluate(x, u, p), u, p)


def spun(torque: Any, My: Any, Fx: Any, radius: Any) -> tuple[Any]:
    """Sum of the torques about the axle of a wheel [N m]."""
    return (torque + My - radius * Fx,)


def rates_of(every: Evaluation, u: Any, p: Model) -> Any:
    """dx/dt of what a state and inputs mean."""
    state, at, slip, found = every.state, every.motion, every.rolling, every.balance
    c, control = p.contact, p.control
    yaw = state.frame[2]
    v_x, v_y, yaw_rate = state.n[p.body.lead[0]], state.n[p.body.lead[1]], state.n[p.body.lead[2]]
    frame = np.array([np.cos(yaw) * v_x - np.sin(yaw) * v_y, np.sin(yaw) * v_x + np.cos(yaw) * v_y, yaw_rate])
    (turning,) = over_lanes(spun, None, [found.torque, found.forces[3], found.forces[0], c.radius])
    spin = control.spin @ turning
    reach = slip_speed(slip.forward[c.relaxing]) / c.relaxation
    side = reach * (slip.side[c.relaxing] - state.side)
    # without a lag there is no state, and nothing that would be divided
    drive = (control.demand @ u - state.drive) / control.drive_lag
    brake = ((control.brake @ u)[: len(state.brake)] - state.brake) / control.brake_lag
    return np.concatenate((frame, at.dq, found.dn, spin, side, drive, brake))
