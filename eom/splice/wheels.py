"""Wheels at a state: slips, loads, torques, and the forces of the road on them and by them on their bodies."""

from typing import Any

import numpy as np

from eom.splice.contact import FORWARD, LATERAL
from eom.splice.laws import forces
from eom.splice.state import Model, Motion, Rolling, State
from eom.tyre.contact import kept_above, rolling_sense
from eom.tyre.elementary import arctan, magnitude, maximum, minimum

LOW_SPEED = 1.0
"""Forward speed [m/s] below which slips are bent, as in `eom.tyre.slips`."""
CREEP = 0.1
"""Speed of the tread [m/s] below which a brake's torque fades: dry friction made smooth."""


def slip_speed(v_x: Any) -> Any:
    """Speed [m/s] over which slips are formed: that of the wheel, bent below `LOW_SPEED` so that it does not vanish."""
    return kept_above(magnitude(v_x), LOW_SPEED)


def rolling(state: State, u: Any, at: Motion, p: Model) -> Rolling:
    """Slips of all wheels."""
    c = p.contact
    v_x, v_y = c.rows[FORWARD] @ at.local, c.rows[LATERAL] @ at.local
    steer = p.control.steer @ u
    cos, sin = np.cos(steer), np.sin(steer)
    forward, sideward = cos * v_x + sin * v_y, cos * v_y - sin * v_x
    speed = slip_speed(forward)
    side = arctan(sideward / speed)
    omega, alpha = forward / c.radius, side + 0.0
    omega[c.spinning] = state.spin
    alpha[c.relaxing] = state.side
    kappa = (omega * c.radius - forward) / speed
    return Rolling(forward, side, alpha, kappa, c.lean @ at.displaced, steer, omega)


def free_loads(at: Motion, supports: Any, p: Model) -> Any:
    """Loads [N] that springs and supports would put on wheels that cannot lift; negative for those that do."""
    c = p.contact
    return c.base + c.share @ supports + c.sprung @ at.displaced + c.damped @ (p.body.T @ at.dq)


def wheel_loads(at: Motion, supports: Any, p: Model) -> Any:
    """Normal loads [N] by the supports' loads; a wheel that lifts pulls nothing, and its partner carries the axle."""
    c = p.contact
    limit = maximum(c.most @ supports, 0.0) + c.alone
    return minimum(maximum(free_loads(at, supports, p), 0.0), limit)


def torques(state: State, u: Any, slip: Rolling, p: Model) -> Any:
    """Torque of drive and brakes on each wheel [N m]; a brake resists rotation either way, and pulls at none."""
    control = p.control
    drive = state.drive[0] if control.drive_lag > 0.0 else control.demand @ u
    brake = maximum(state.brake if control.brake_lag > 0.0 else control.brake @ u, 0.0)
    return control.drive * drive - brake * rolling_sense(slip.omega * p.contact.radius, CREEP)


def road_forces(slip: Rolling, load: Any, torque: Any, p: Model) -> Any:
    """Fx, Fy, Mx, My, Mz of the road on the wheels in their axes, (5, w).

    A wheel whose spin is no state passes its torque on to the road at once.
    """
    c = p.contact
    found = forces(p.laws, c.number, slip.alpha, slip.kappa, load, slip.camber, slip.forward)
    passed = (torque + found[3]) / c.radius
    passed[c.spinning] = found[0][c.spinning]
    found[0] = passed
    return found


def on_bodies(found: Any, slip: Rolling, torque: Any, p: Model) -> Any:
    """Forces of road forces (5, w) and torques on the bodies, along the rows of `Contact`, (6, w)."""
    c = p.contact
    cos, sin = np.cos(slip.steer), np.sin(slip.steer)
    Fx, Fy, Mx, Mz = found[0], found[1], found[2], found[4]
    # a spin that is no state passes on all torques but that of rolling resistance, which the road takes with the force
    back = -found[3]
    back[c.spinning] = torque[c.spinning]
    return np.stack((cos * Fx - sin * Fy, sin * Fx + cos * Fy, cos * Mx, sin * Mx - back, Mz, 0.0 * Fx))


def lifted(at: Motion, load: Any, supports: Any, p: Model) -> Any:
    """What loads are beyond what supports and springs of the multibody part carry, along the rows of `Contact`, (6, w).

    Nothing while all wheels stand: a wheel that lifts must not pull, and its partner carries what it left.
    """
    c = p.contact
    excess = load - free_loads(at, supports, p)
    none = 0.0 * excess
    return np.stack((none, none, c.lever * excess, none, none, c.heave * excess))
