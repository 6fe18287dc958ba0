"""Balance of forces at a state: accelerations, reactions of joints, and the loads that close their loop."""

from typing import Any

import numpy as np

from eom.splice.lanes import solve_positive
from eom.splice.motion import body_velocity, generalised, headed
from eom.splice.state import Balance, Model, Motion, Rolling, State
from eom.splice.wheels import load_slopes, on_bodies, road_forces, torques, wheel_loads
from eom.tyre.elementary import magnitude


def passive_forces(state: State, u: Any, at: Motion, p: Model) -> Any:
    """Generalised forces on w of all but wheels and joints, gyroscopic and centripetal terms included, (N,)."""
    body, drags = p.body, p.control.drags
    v_x, yaw_rate = state.n[body.lead[0]], state.n[body.lead[2]]
    along = drags @ at.local
    planar = body.planar - drags.T @ (p.control.drag_factor * along * magnitude(along))
    drifting = body_velocity(at, v_x)
    drifting[0::6] -= body.speed
    planar = planar - body.C_slip @ drifting
    w = at.w.reshape(-1, 6)
    momentum = np.sum(body.inertia * w[:, np.newaxis, 3:], axis=2)
    turning = np.zeros_like(w)
    turning[:, 0], turning[:, 1] = -body.mass * yaw_rate * w[:, 1], body.mass * yaw_rate * w[:, 0]
    turning[:, 3:] = np.cross(w[:, 3:], momentum)
    elastic = body.K @ at.displaced + body.C @ at.w
    return body.f + input_forces(u, at, p) + headed(planar, at.displaced[5::6]) - elastic - turning.ravel()


def input_forces(u: Any, at: Motion, p: Model) -> Any:
    """Generalised forces of the multibody part's inputs, (N,); both ends turn with the heading of the first body."""
    body = p.body
    result = body.B @ u + 0.0 * at.displaced
    yaw = at.displaced[5::6][body.steering]
    x, y = body.B[0::6] * u, body.B[1::6] * u
    result[0::6] = np.sum(np.cos(yaw) * x - np.sin(yaw) * y, axis=1)
    result[1::6] = np.sum(np.sin(yaw) * x + np.cos(yaw) * y, axis=1)
    return result


def accelerations(at: Motion, applied: Any, p: Model) -> tuple[Any, Any, Any]:
    """dn/dt, dw/dt and the reactions of the joints under generalised forces on w, (N,)."""
    body = p.body
    mass = at.mass
    force = at.W.T @ (applied - body.M @ at.drift)
    if body.held:
        dn = np.concatenate((np.zeros(1), solve_positive(mass[1:, 1:], force[1:])))
    else:
        dn = solve_positive(mass, force)
    dw = at.W @ dn + at.drift
    return dn, dw, body.M @ dw - applied


def reactions(state: State, lacking: Any, p: Model) -> Any:
    """Reactions of the independent constraint rows that supply the *lacking* generalised forces, (rows,)."""
    body = p.body
    straight = body.react @ lacking
    return straight + (state.q @ body.react_turn).reshape(len(straight), len(straight)) @ straight


def support_loads(state: State, passive: Any, torque: Any, at: Motion, slip: Rolling, p: Model) -> Any:
    """Loads of the supports [N], by one step of Newton from those at the trim.

    They follow from accelerations, these from tyre forces, and these from the loads: nearly in proportion, with the
    slopes of the trim at the trim. So the step is exact to first order about it; `Balance.assumed` lets check it
    against the reactions.
    """
    c = p.contact
    at_trim = c.carried
    load, excess = wheel_loads(at, at_trim, p)
    found = road_forces(slip, load, torque, p)
    slope = load_slopes(found, load, slip, p)
    on_body = on_bodies(found, excess, slip, torque, p)
    _, _, lacking = accelerations(at, passive + generalised(on_body, at, p), p)
    off = reactions(state, lacking, p)[c.supports] - at_trim
    rows = c.rows.reshape(-1, c.rows.shape[2])
    gain = (p.load_gain @ rows.T) @ slope.reshape(-1, len(at_trim))
    return at_trim + np.linalg.solve(np.eye(len(at_trim)) - gain, off)


def balance(state: State, u: Any, at: Motion, slip: Rolling, p: Model) -> Balance:
    """Accelerations and forces at a state."""
    torque = torques(state, u, slip, p)
    passive = passive_forces(state, u, at, p)
    assumed = p.contact.carried
    if len(assumed):
        assumed = support_loads(state, passive, torque, at, slip, p)
    load, excess = wheel_loads(at, assumed, p)
    found = road_forces(slip, load, torque, p)
    on_body = on_bodies(found, excess, slip, torque, p)
    dn, dw, lacking = accelerations(at, passive + generalised(on_body, at, p), p)
    return Balance(dn, dw, reactions(state, lacking, p), on_body, found, load, torque, assumed)
