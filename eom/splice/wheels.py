"""Wheels at a state: slips, loads, torques, and the forces of the road on them and by them on their bodies.

What is done for each wheel alone is a function of numbers, which `over_lanes` applies to all of them.
"""

from typing import Any

import numpy as np

from eom.splice.contact import FORWARD, LATERAL
from eom.splice.lanes import over_lanes
from eom.splice.laws import forces
from eom.splice.state import Model, Motion, Rolling, State
from eom.tyre.contact import kept_above, rolling_sense
from eom.tyre.elementary import arctan, magnitude, maximum, minimum

LOW_SPEED = 1.0
"""Forward speed [m/s] below which slips are bent, as in `eom.tyre.slips`."""
CREEP = 0.1
"""Speed of the tread [m/s] below which a brake's torque fades: dry friction made smooth."""
LIFTED = 1e-100
"""Load [N] that changes no other one, and keeps the ratio of no force to no load zero."""


def slip_speed(v_x: Any) -> Any:
    """Speed [m/s] over which slips are formed: that of the wheel, bent below `LOW_SPEED` so that it does not vanish."""
    return kept_above(magnitude(v_x), LOW_SPEED)


def course(v_x: Any, v_y: Any, steer: Any, spin: Any, radius: Any, spins: Any) -> tuple[Any, ...]:
    """Forward speed, slip angle, longitudinal slip, and cosine and sine of the steer angle of a wheel."""
    cos, sin = np.cos(steer), np.sin(steer)
    forward, sideward = cos * v_x + sin * v_y, cos * v_y - sin * v_x
    speed = slip_speed(forward)
    return forward, arctan(sideward / speed), spins * (spin * radius - forward) / speed, cos, sin


def rolling(state: State, u: Any, at: Motion, p: Model) -> Rolling:
    """Slips of all wheels."""
    c = p.contact
    v_x, v_y = c.rows[FORWARD] @ at.local, c.rows[LATERAL] @ at.local
    spin = 0.0 * v_x
    spin[c.spinning] = state.spin
    forward, side, kappa, cos, sin = over_lanes(
        course, None, [v_x, v_y, p.control.steer @ u, spin, c.radius, spinning(p)]
    )
    omega, alpha = forward / c.radius, side + 0.0
    omega[c.spinning] = state.spin
    alpha[c.relaxing] = state.side
    return Rolling(forward, side, alpha, kappa, c.lean @ at.displaced, cos, sin, omega)


def spinning(p: Model) -> Any:
    """One for each wheel whose spin is a state, zero for the others, (w,)."""
    result = np.zeros(len(p.contact.number))
    result[p.contact.spinning] = 1.0
    return result


def free_loads(at: Motion, supports: Any, p: Model) -> Any:
    """Loads [N] that springs and supports would put on wheels that cannot lift; negative for those that do."""
    c = p.contact
    return c.base + c.share @ supports + c.sprung @ at.displaced + c.damped @ (p.body.T @ at.dq)


def pressing(free: Any, whole: Any, alone: Any) -> tuple[Any, Any]:
    """Load of a wheel, and what it is beyond the one that it would have if it could not lift.

    A wheel that lifts pulls nothing, and its partner carries the *whole* axle.
    """
    load = minimum(maximum(free, 0.0), maximum(whole, 0.0) + alone)
    return load, load - free


def wheel_loads(at: Motion, supports: Any, p: Model) -> tuple[Any, Any]:
    """Normal loads [N] by the supports' loads, and what they are beyond what supports and springs carry, (w,)."""
    c = p.contact
    load, excess = over_lanes(pressing, None, [free_loads(at, supports, p), c.most @ supports, c.alone])
    return load, excess


def wheel_torque(share: Any, drive: Any, pressed: Any, omega: Any, radius: Any) -> tuple[Any]:
    """Torque on a wheel [N m]: its share of the drive's, less a brake's, which resists rotation and pulls at none."""
    return (share * drive - maximum(pressed, 0.0) * rolling_sense(omega * radius, CREEP),)


def torques(state: State, u: Any, slip: Rolling, p: Model) -> Any:
    """Torque of drive and brakes on each wheel [N m]."""
    control, omega = p.control, slip.omega
    drive = state.drive[0] if control.drive_lag > 0.0 else control.demand @ u
    pressed = state.brake if control.brake_lag > 0.0 else control.brake @ u
    (found,) = over_lanes(wheel_torque, None, [control.drive, drive + 0.0 * omega, pressed, omega, p.contact.radius])
    return found


def road_forces(slip: Rolling, load: Any, torque: Any, p: Model) -> Any:
    """Fx, Fy, Mx, My, Mz of the road on the wheels in their axes, (5, w).

    A wheel whose spin is no state passes its torque on to the road at once.
    """
    c = p.contact
    found = forces(p.laws, c.number, slip.alpha, slip.kappa, load, slip.camber, slip.forward)
    passed = (torque + found[3]) / c.radius
    passed[c.spinning] = found[0][c.spinning]
    return np.concatenate((passed[np.newaxis], found[1:]))


def pushed(
    Fx: Any, Fy: Any, Mx: Any, back: Any, Mz: Any, cos: Any, sin: Any, excess: Any, lever: Any, heave: Any
) -> tuple[Any, ...]:
    """Forces of a wheel on its body along the rows of `Contact`.

    *back* is the torque on it in pitch; the *excess* of its load acts beside what supports and springs carry.
    """
    roll = cos * Mx + lever * excess
    return cos * Fx - sin * Fy, sin * Fx + cos * Fy, roll, sin * Mx - back, Mz, heave * excess


def on_bodies(found: Any, excess: Any, slip: Rolling, torque: Any, p: Model) -> Any:
    """Forces of road forces (5, w), torques and loads in excess on the bodies, along the rows of `Contact`, (6, w)."""
    c = p.contact
    # a spin that is no state passes on all torques but that of rolling resistance, which the road takes with the force
    back = -found[3]
    back[c.spinning] = torque[c.spinning]
    Fx, Fy, Mx, _, Mz = found
    return np.stack(over_lanes(pushed, None, [Fx, Fy, Mx, back, Mz, slip.cos, slip.sin, excess, c.lever, c.heave]))


def following_load(
    Fx: Any,
    Fy: Any,
    Mx: Any,
    My: Any,
    Mz: Any,
    load: Any,
    bend_x: Any,
    bend_y: Any,
    bend_roll: Any,
    bend_pitch: Any,
    bend_yaw: Any,
    cos: Any,
    sin: Any,
    spins: Any,
    radius: Any,
    lever: Any,
    share: Any,
    whole: Any,
    limit: Any,
) -> tuple[Any, ...]:
    """How the forces of a wheel on its body follow the load of its support.

    They follow its own load in proportion, and as *bend* says beside; that follows its share of the support's load,
    with its partner lifted the *whole* axle's, and lifted nothing.
    """
    by_load = 1.0 / (load + LIFTED)
    pitch = My * by_load + bend_pitch
    along = spins * (Fx * by_load + bend_x) + (1.0 - spins) * pitch / radius
    none = 0.0 * load
    across, roll, yaw = Fy * by_load + bend_y, Mx * by_load + bend_roll, Mz * by_load + bend_yaw
    own = np.where(load > 0.0, np.where(load < limit, share, whole), none)
    x, y, roll, pitch, yaw, z = pushed(along, across, roll, (spins - 1.0) * pitch, yaw, cos, sin, none, none, none)
    return own * x, own * y, own * roll + lever * (own - share), own * pitch, own * yaw, own * z


def load_slopes(found: Any, load: Any, slip: Rolling, p: Model) -> Any:
    """How the forces on the bodies follow the loads of the supports, (6, w, s); exact at the trim.

    *found* are the road's forces at *load*, with the supports' loads of the trim.
    """
    c = p.contact
    limit = maximum(c.most @ c.carried, 0.0) + c.alone
    rows = [*found, load, *p.bend, slip.cos, slip.sin, spinning(p), c.radius, c.lever]
    by_own = over_lanes(following_load, None, [*rows, np.sum(c.share, axis=1), np.sum(c.most, axis=1), limit])
    standing_on = np.where(c.support[:, np.newaxis] == np.arange(len(c.carried)), 1.0, 0.0)
    return np.stack(by_own)[:, :, np.newaxis] * standing_on
