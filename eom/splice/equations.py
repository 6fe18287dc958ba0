"""The nonlinear equations: the multibody part in its moving frame, with tyres, wheels, drive and brakes.

Every velocity is W(q) n, with W to first order in the displacements q; Kane's equations with these very velocities
keep the balance of power, and turn every force by articulation and roll. What joints carry follows from it.
"""

from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.splice.contact import FORWARD, LATERAL, Contact
from eom.splice.laws import LawGroup, forces
from eom.splice.multibody import Multibody
from eom.tyre.contact import kept_above, rolling_sense
from eom.tyre.elementary import arctan, magnitude, maximum, minimum

LOW_SPEED = 1.0
"""Forward speed [m/s] below which slips are bent, as in `eom.tyre.slips`."""
CREEP = 0.1
"""Speed of the tread [m/s] below which a brake's torque fades: dry friction made smooth."""
LOAD_STEP = 1e-6
"""Relative step of load by which its effect on tyre forces is found."""


class Control(NamedTuple):
    """What inputs do to wheels, and how late; u inputs, w wheels.

    Attributes
    ----------
    steer, brake : Array
        Steer angle and brake torque of each wheel by the inputs, (w, u).
    demand, drive : Array
        Drive torque by the inputs, (u,), and each wheel's share of it, (w,).
    drive_lag, brake_lag : float
        Time constants [s], zero for none.
    spin : Array
        Rates of the spins that are states by torques on the wheels, (spins, w) [1/(kg m^2)].
    drags : Array
        Rows of velocity along each drag's place, (drags, N), and their ``drag_factor`` [N s^2/m^2].
    """

    steer: Array
    brake: Array
    demand: Array
    drive: Array
    drive_lag: float
    brake_lag: float
    spin: Array
    drags: Array
    drag_factor: Array


class Model(NamedTuple):
    """Everything that the equations need, in numbers; ``load_gain`` is of supports' loads by forces on w, (s, N)."""

    body: Multibody
    contact: Contact
    control: Control
    laws: tuple[LawGroup, ...]
    load_gain: Array


class State(NamedTuple):
    """Parts of the state.

    Place of the frame (x, y, yaw), displacements, velocities, spins, and what lags: slip angles, drive torque, brake
    torques.
    """

    frame: Any
    q: Any
    n: Any
    spin: Any
    side: Any
    drive: Any
    brake: Any


class Motion(NamedTuple):
    """Velocities at a state: W(q), w = W n, dq/dt, and the part of dw/dt that does not follow from dn/dt.

    ``displaced`` are the displacements of all bodies, ``local`` the velocities w with translations along each body's
    own heading.
    """

    W: Any
    w: Any
    dq: Any
    drift: Any
    displaced: Any
    local: Any


class Rolling(NamedTuple):
    """Slips of the wheels and what else their tyres need; arrays over the wheels.

    ``side`` is the slip angle by kinematics, ``alpha`` the one that acts; ``steer`` the steer angle.
    """

    forward: Any
    side: Any
    alpha: Any
    kappa: Any
    camber: Any
    steer: Any
    omega: Any


class Balance(NamedTuple):
    """Accelerations and forces.

    dn/dt, dw/dt, reactions of the independent constraint rows, forces of the wheels on their bodies (6, w) and in wheel
    axes (5, w), loads, torques of drive and brakes on the wheels, loads of the supports for which the tyres were
    evaluated.
    """

    dn: Any
    dw: Any
    reactions: Any
    body_forces: Any
    forces: Any
    load: Any
    torque: Any
    assumed: Any


class Evaluation(NamedTuple):
    """All that a state and inputs mean."""

    state: State
    motion: Motion
    rolling: Rolling
    balance: Balance


def sizes(p: Model) -> tuple[int, ...]:
    """Lengths of the parts of the state."""
    wheels = len(p.contact.number)
    return (
        3,
        p.body.T.shape[1],
        p.body.W.shape[1],
        len(p.contact.spinning),
        len(p.contact.relaxing),
        int(p.control.drive_lag > 0.0),
        wheels if p.control.brake_lag > 0.0 else 0,
    )


def split(x: Any, p: Model) -> State:
    """The parts of a state."""
    ends = np.cumsum(np.array(sizes(p)))
    return State(*np.split(x, ends[:-1]))


def headed(vectors: Any, yaw: Any) -> Any:
    """Translational parts, (N,), turned about z by an angle per body, (bodies,)."""
    result = vectors.reshape(-1, 6) + 0.0 * yaw[:, np.newaxis]
    x, y = vectors[0::6], vectors[1::6]
    cos, sin = np.cos(yaw), np.sin(yaw)
    result[:, 0], result[:, 1] = cos * x - sin * y, sin * x + cos * y
    return result.ravel()


def motion(state: State, p: Model) -> Motion:
    """Velocities of all bodies."""
    body = p.body
    shape = body.W.shape
    W = body.W + (state.q @ body.W_turn).reshape(shape)
    w, dq, displaced = W @ state.n, body.rate @ state.n, body.T @ state.q
    drift = (dq @ body.W_turn).reshape(shape) @ state.n
    return Motion(W, w, dq, drift, displaced, headed(w, -displaced[5::6]))


def rolling(state: State, u: Any, at: Motion, p: Model) -> Rolling:
    """Slips of all wheels."""
    c = p.contact
    v_x, v_y = c.rows[FORWARD] @ at.local, c.rows[LATERAL] @ at.local
    steer = p.control.steer @ u
    cos, sin = np.cos(steer), np.sin(steer)
    forward, sideward = cos * v_x + sin * v_y, cos * v_y - sin * v_x
    speed = kept_above(magnitude(forward), LOW_SPEED)
    side = arctan(sideward / speed)
    omega, alpha = forward / c.radius, side + 0.0
    omega[c.spinning] = state.spin
    alpha[c.relaxing] = state.side
    kappa = (omega * c.radius - forward) / speed
    return Rolling(forward, side, alpha, kappa, c.lean @ at.displaced, steer, omega)


def free_loads(at: Motion, supports: Any, p: Model) -> Any:
    """Loads [N] that springs and supports would put on wheels that cannot lift; negative for those that do."""
    c = p.contact
    return c.base + c.share @ supports + (c.rolled + c.sprung) @ at.displaced + c.damped @ (p.body.T @ at.dq)


def wheel_loads(at: Motion, supports: Any, p: Model) -> Any:
    """Normal loads [N] by the supports' loads; a wheel that lifts pulls nothing, and its partner carries the axle."""
    c = p.contact
    limit = maximum(c.most @ supports, 0.0) + c.alone
    return minimum(maximum(free_loads(at, supports, p), 0.0), limit)


def torques(state: State, u: Any, slip: Rolling, p: Model) -> Any:
    """Torque of drive and brakes on each wheel [N m]; a brake resists rotation whichever way it goes."""
    control = p.control
    drive = state.drive[0] if control.drive_lag > 0.0 else control.demand @ u
    brake = state.brake if control.brake_lag > 0.0 else control.brake @ u
    return control.drive * drive - brake * rolling_sense(slip.omega * p.contact.radius, CREEP)


def road_forces(slip: Rolling, load: Any, torque: Any, p: Model) -> Any:
    """Fx, Fy, Mx, My, Mz of the road on the wheels in their axes, (5, w).

    A wheel whose spin is no state passes its torque on to the road at once.
    """
    c = p.contact
    found = forces(p.laws, c.number, slip.alpha, slip.kappa, load, slip.camber, slip.forward)
    passed = (torque + found[3]) / c.radius
    passed[c.spinning] = found[0, c.spinning]
    found[0] = passed
    return found


def on_bodies(found: Any, slip: Rolling, load: Any, torque: Any, p: Model) -> Any:
    """Forces of road forces (5, w) and loads on the bodies, along the rows of `Contact`, (6, w)."""
    c = p.contact
    cos, sin = np.cos(slip.steer), np.sin(slip.steer)
    Fx, Fy, Mx, _, Mz = found
    back = np.zeros_like(Fx)
    back[c.spinning] = torque[c.spinning]
    # what presses beyond the springs that are part of the multibody's stiffness comes from `lifted`
    return np.stack(
        (cos * Fx - sin * Fy, sin * Fx + cos * Fy, cos * Mx + c.lever * load, sin * Mx - back, Mz, 0.0 * Fx)
    )


def lifted(at: Motion, load: Any, p: Model) -> Any:
    """What a wheel's own spring, which is part of the multibody's stiffness, must not pull when it lifts [N]."""
    c = p.contact
    free = c.base + c.sprung @ at.displaced + c.damped @ (p.body.T @ at.dq)
    return np.where(c.alone > 0.0, load - free, 0.0)


def passive_forces(state: State, u: Any, at: Motion, p: Model) -> Any:
    """Generalised forces on w of all but wheels and joints, gyroscopic and centripetal terms included, (N,)."""
    body, drags = p.body, p.control.drags
    v_x, yaw_rate = state.n[body.lead[0]], state.n[body.lead[2]]
    along = drags @ at.local
    planar = body.planar - drags.T @ (p.control.drag_factor * along * magnitude(along))
    drifting = body_velocity(at, v_x)
    drifting[0::6] -= v_x
    planar = planar - body.C_slip @ drifting
    w = at.w.reshape(-1, 6)
    momentum = (body.inertia @ w[:, 3:, np.newaxis])[:, :, 0]
    turning = np.zeros_like(w)
    turning[:, 0], turning[:, 1] = -body.mass * yaw_rate * w[:, 1], body.mass * yaw_rate * w[:, 0]
    turning[:, 3:] = np.cross(w[:, 3:], momentum)
    elastic = body.K @ at.displaced + body.C @ at.w
    return body.f + body.B @ u + headed(planar, at.displaced[5::6]) - elastic - turning.ravel()


def body_velocity(at: Motion, v_x: Any) -> Any:
    """Velocities in body axes, (N,), of a vehicle that runs at v_x: a pitched body moves along its z too."""
    result = at.local + 0.0
    result[2::6] += v_x * at.displaced[4::6]
    return result


def generalised(found: Any, at: Motion, p: Model) -> Any:
    """Generalised forces on w of wheels' forces along the rows of `Contact`, (6, w), turned by each body's heading."""
    rows = p.contact.rows
    return headed(rows.reshape(-1, rows.shape[2]).T @ found.ravel(), at.displaced[5::6])


def accelerations(at: Motion, applied: Any, p: Model) -> tuple[Any, Any, Any]:
    """dn/dt, dw/dt and the reactions of the joints under generalised forces on w, (N,)."""
    body = p.body
    mass = at.W.T @ (body.M @ at.W)
    force = at.W.T @ (applied - body.M @ at.drift)
    if body.held:
        dn = np.concatenate((np.zeros(1), np.linalg.solve(mass[1:, 1:], force[1:])))
    else:
        dn = np.linalg.solve(mass, force)
    dw = at.W @ dn + at.drift
    return dn, dw, body.M @ dw - applied


def reactions(state: State, lacking: Any, p: Model) -> Any:
    """Reactions of the independent constraint rows that supply the *lacking* generalised forces, (rows,)."""
    body = p.body
    straight = body.react @ lacking
    return straight + (state.q @ body.react_turn).reshape(len(straight), len(straight)) @ straight


def balance(state: State, u: Any, at: Motion, slip: Rolling, p: Model) -> Balance:
    """Accelerations and forces at a state.

    Supports' loads follow from accelerations, those from tyre forces, and these from the loads. One step of Newton
    from the loads at the trim closes this loop: exact to first order about the trim, and else to the second order of
    the change of load, which `Balance.assumed` lets check against the reactions.
    """
    c = p.contact
    torque = torques(state, u, slip, p)
    passive = passive_forces(state, u, at, p)
    rows = c.rows.reshape(-1, c.rows.shape[2])
    assumed = c.carried
    if len(assumed):
        first = wheel_loads(at, assumed, p)
        found = on_bodies(road_forces(slip, first, torque, p), slip, first, torque, p)
        found[5] = lifted(at, first, p)
        step = LOAD_STEP * c.nominal
        second = first + step
        slope = (on_bodies(road_forces(slip, second, torque, p), slip, second, torque, p) - found) / step
        slope[5] = 0.0
        _, _, lacking = accelerations(at, passive + generalised(found, at, p), p)
        off = reactions(state, lacking, p)[c.supports] - assumed
        limit = (maximum(c.most @ assumed, 0.0) + c.alone)[:, np.newaxis]
        loaded, resting = (first > 0.0)[:, np.newaxis], first[:, np.newaxis] < limit
        acting = np.where(loaded, np.where(resting, c.share, c.most), 0.0)
        gain = p.load_gain @ (rows.T @ (slope[:, :, np.newaxis] * acting).reshape(-1, len(assumed)))
        assumed = assumed + np.linalg.solve(np.eye(len(assumed)) - gain, off)
    load = wheel_loads(at, assumed, p)
    found = road_forces(slip, load, torque, p)
    on_body = on_bodies(found, slip, load, torque, p)
    on_body[5] = lifted(at, load, p)
    dn, dw, lacking = accelerations(at, passive + generalised(on_body, at, p), p)
    return Balance(dn, dw, reactions(state, lacking, p), on_body, found, load, torque, assumed)


def evaluate(x: Any, u: Any, p: Model) -> Evaluation:
    """What a state and inputs mean."""
    state = split(x, p)
    at = motion(state, p)
    slip = rolling(state, u, at, p)
    return Evaluation(state, at, slip, balance(state, u, at, slip, p))


def rates(x: Any, u: Any, p: Model) -> Any:
    """dx/dt at a state x under inputs u."""
    state, at, slip, found = evaluate(x, u, p)
    c, control = p.contact, p.control
    yaw = state.frame[2]
    v_x, v_y, yaw_rate = state.n[p.body.lead]
    frame = np.stack((np.cos(yaw) * v_x - np.sin(yaw) * v_y, np.sin(yaw) * v_x + np.cos(yaw) * v_y, yaw_rate))
    spin = control.spin @ (found.torque + found.forces[3] - c.radius * found.forces[0])
    reach = kept_above(magnitude(slip.forward[c.relaxing]), LOW_SPEED) / c.relaxation
    parts = [frame, at.dq, found.dn, spin, reach * (slip.side[c.relaxing] - state.side)]
    if control.drive_lag > 0.0:
        parts.append((control.demand @ u - state.drive) / control.drive_lag)
    if control.brake_lag > 0.0:
        parts.append((control.brake @ u - state.brake) / control.brake_lag)
    return np.concatenate(parts)
