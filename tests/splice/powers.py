"""Energy and powers of a vehicle with wheels, from its velocities and the forces that the model reports.

Contact velocities are found here by plain kinematics of points, not by the rows of the model.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.model.tyre import TyreModel
from eom.splice.contact import elastic_tensions
from eom.splice.motion import motion
from eom.splice.state import Evaluation, Motion, split_state
from tests.splice.shared import Array


class Powers(NamedTuple):
    """Powers into the vehicle [W].

    Attributes
    ----------
    road : float
        Of forces and moments of the road, slip and rolling resistance.
    loads : float
        Of the wheels' loads about their supports beyond the springs of rolling tyres, and of springs that let go.
    drive, brakes : float
        Of torques between bodies and wheels.
    air : float
    dead, springs, dampers, inputs : float
        Of weight and preloads, of springs, of dampers, and of other inputs.
    """

    road: float
    loads: float
    drive: float
    brakes: float
    air: float
    dead: float
    springs: float
    dampers: float
    inputs: float


def kinetic_energy(found: TyreModel, x: Array) -> complex:
    """Of bodies and spinning wheels [J]; *x* may be complex, to carry a derivative."""
    p = found.numbers
    state = split_state(x, p)
    w = motion(state, p).w
    inertia = np.array([wheel.spin_inertia for wheel in found.prepared.system.wheels])[p.contact.spinning]
    return complex(0.5 * w @ p.body.M @ w + 0.5 * inertia @ state.spin**2)


def point_velocities(at: Motion, bodies: Sequence[int], arms: Array) -> Array:
    """Velocities of points of bodies [m/s], (points, 3), along the heading of each body."""
    own = at.local.reshape(-1, 6)[list(bodies)]
    return np.asarray(own[:, :3] + np.cross(own[:, 3:], arms))


def powers(found: TyreModel, now: Evaluation, u: Array) -> Powers:
    """Powers at a state, see `Powers`."""
    system, p = found.prepared.system, found.numbers
    at, balance, body = now.motion, now.balance, p.body
    wheels, bodies = system.wheels, [wheel.body for wheel in system.wheels]
    centres = np.array([item.centre for item in system.bodies])
    supports = {item.connection.name: item.connection.places[0] for item in system.constraints}
    names = [item.connection.name for item in system.elastic]
    preloads = dict(zip(names, elastic_tensions(system, found.prepared.matrices), strict=True))
    radius = np.array([wheel.radius for wheel in wheels])
    spinning = np.array([wheel.spin_inertia > 0.0 for wheel in wheels])
    omega = np.zeros(len(wheels))
    omega[spinning] = now.state.spin
    arms = np.array([wheel.place for wheel in wheels]) - centres[bodies]
    hubs = arms + np.outer(np.where(spinning, radius, 0.0), [0.0, 0.0, 1.0])
    levers = np.array([w.place[1] - supports[w.support][1] if w.support else 0.0 for w in wheels])
    roll, pitch, yaw = at.w.reshape(-1, 6)[bodies, 3:].T
    forward = point_velocities(at, bodies, hubs)[:, 0]
    _, left, up = point_velocities(at, bodies, arms).T
    cos, sin = now.rolling.cos, now.rolling.sin
    Fx, Fy, Mx, My, Mz = balance.forces
    road = (cos * Fx - sin * Fy) * forward + (sin * Fx + cos * Fy) * left + Mx * (cos * roll + sin * pitch) + Mz * yaw
    road += omega * np.where(spinning, My - radius * Fx, 0.0)
    sprung = 0.0
    for spring in system.elastic:
        carried = [k for k, wheel in enumerate(wheels) if wheel.support and wheel.spring == spring.connection.name]
        if carried:
            tilt = at.displaced[6 * bodies[carried[0]] + 3]
            sprung += (preloads[spring.connection.name] - spring.stiffness[1] * tilt) * roll[carried[0]]
    drive = p.control.drive * (now.state.drive[0] if len(now.state.drive) else p.control.demand @ u)
    turning = np.where(spinning, omega - pitch, 0.0)
    air = 0.0
    for item in system.drags:
        v = point_velocities(at, [item.body], np.subtract(item.place, centres[item.body]))[0, 0]
        air -= item.factor * v * abs(v) * v
    return Powers(
        road=float(np.sum(road)),
        loads=float(balance.load @ (levers * roll) - sprung + balance.body_forces[5] @ up),
        drive=float(drive @ turning),
        brakes=float((balance.torque - drive) @ turning),
        air=float(air),
        dead=float(body.f @ at.w),
        springs=-float(at.w @ body.K @ at.displaced),
        dampers=-float(at.w @ body.C @ at.w),
        inputs=float(at.w @ body.B @ u),
    )
