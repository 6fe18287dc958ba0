"""The linear model of a vehicle with wheels: its multibody part closed by the slopes of its tyres at the trim.

Written with the matrices of the linear kernel, reactions and their geometric stiffness included; it shares with the
nonlinear equations the wheels' rows and the tyres' laws alone.
"""

from typing import NamedTuple

import numpy as np

from eom.assembly.loads import load_sums
from eom.assembly.massless import independent_equations
from eom.assembly.vectors import Array
from eom.splice.contact import FORWARD, LATERAL
from eom.splice.laws import forces
from eom.splice.multibody import frame_motion
from eom.splice.prepare import Prepared
from eom.splice.state import Model, sizes
from eom.splice.trim import STEP, road_loads
from eom.splice.wheels import slip_speed


class Closed(NamedTuple):
    """dx/dt = A x + B u about the trim, and the motions that outputs measure, as columns over (x, u).

    Attributes
    ----------
    A, B : Array
        In the states of the nonlinear equations, speeds counted from the trim's.
    p, w, dw : Array
        Displacements, velocities and accelerations of all bodies by (x, u), (N, states + inputs).
    """

    A: Array
    B: Array
    p: Array
    w: Array
    dw: Array


def slip_speed_slope(U: float) -> tuple[float, float]:
    """The speed over which slips are formed at a forward speed, and its slope [m/s, -]."""
    at = slip_speed(U + 1j * STEP)
    return float(at.real), float(at.imag / STEP)


def slopes_at_trim(prepared: Prepared) -> Array:
    """Derivatives of the wheels' forces at the trim: (argument, component, wheels), by complex steps.

    Arguments are slip angle, longitudinal slip, load, camber and speed; components Fx, Fy, Mx, My, Mz.
    """
    trim, model = prepared.trim, prepared.model
    zero = np.zeros(len(trim.load))
    at = [zero, trim.slip, trim.load, zero, zero + trim.speed]
    result = []
    for k in range(len(at)):
        stepped = [value + (1j * STEP if j == k else 0.0) for j, value in enumerate(at)]
        result.append(forces(model.laws, model.contact.number, *stepped).imag / STEP)
    return np.array(result)


class Columns(NamedTuple):
    """Parts of the unknowns, each an array whose columns multiply states, inputs and loads of the supports."""

    q: Array
    n: Array
    spin: Array
    side: Array
    drive: Array
    brake: Array
    u: Array
    support: Array


def columns(model: Model) -> Columns:
    """The unknowns themselves; q with the place of the frame."""
    frame, q, *others = sizes(model)
    lengths = [frame + q, *others, len(model.control.demand), len(model.contact.supports)]
    return Columns(*np.split(np.eye(sum(lengths)), np.cumsum(lengths[:-1])))


class WheelColumns(NamedTuple):
    """What wheels do, by the unknowns.

    Slip angle by kinematics, whole torque on the wheel, (w, columns) each; generalised forces on the bodies,
    (N, columns).
    """

    side: Array
    torque: Array
    force: Array


def wheels(prepared: Prepared, unknown: Columns, w: Array, p: Array) -> WheelColumns:
    """Slopes of what the wheels do, with velocities w and displacements p by the unknowns."""
    model, trim = prepared.model, prepared.trim
    c, control, U = model.contact, model.control, trim.speed
    over, change = slip_speed_slope(U)
    radius, forward = c.radius[:, np.newaxis], c.rows[FORWARD] @ w
    spinning = np.zeros((len(c.number), 1))
    spinning[c.spinning] = 1.0
    steer, omega = control.steer @ unknown.u, forward / radius
    omega[c.spinning] = unknown.spin
    side = (c.rows[LATERAL] @ w - U * steer) / over
    alpha = side + 0.0
    alpha[c.relaxing] = unknown.side
    kappa = spinning * (radius * omega - (1.0 + change * trim.slip)[:, np.newaxis] * forward) / over
    load = c.share @ unknown.support + c.sprung @ p + c.damped @ (w - prepared.matrices.V @ p)
    arguments = np.array([alpha, kappa, load, c.lean @ p, forward])
    Fx, Fy, Mx, My, Mz = np.einsum("acw,aws->cws", slopes_at_trim(prepared), arguments)
    torque = np.outer(control.drive, unknown.drive[0] if len(unknown.drive) else control.demand @ unknown.u)
    torque -= unknown.brake if len(unknown.brake) else control.brake @ unknown.u
    Fx = spinning * Fx + (1.0 - spinning) * (torque + My) / radius
    Fx0, Fy0, Mx0, _, _ = trim.forces[:, :, np.newaxis]
    back = spinning * torque - (1.0 - spinning) * My
    on_body = np.array((Fx - Fy0 * steer, Fy + Fx0 * steer, Mx, Mx0 * steer - back, Mz, 0.0 * Fx))
    return WheelColumns(side, torque + My - radius * Fx, np.einsum("kwn,kws->ns", c.rows, on_body))


def close(prepared: Prepared) -> Closed:
    """The linear model about the trim."""
    model, matrices, U = prepared.model, prepared.matrices, prepared.trim.speed
    body, c, control, reduction = model.body, model.contact, model.control, matrices.reduction
    equations, unknown = independent_equations(matrices), columns(model)
    q, n, _, lagging, drive, brake, u, _ = unknown
    w, p = reduction.W @ n + reduction.Z @ q, reduction.T @ q
    wheel = wheels(prepared, unknown, w, p)
    drag = 2.0 * U * control.drags.T @ (control.drag_factor[:, np.newaxis] * (control.drags @ w))
    force = wheel.force - drag + level(prepared, p) + body.B @ u
    pushed = reduction.W.T @ force - equations.C @ n - equations.K @ q
    dn = np.zeros_like(n)
    free = slice(1, None) if body.held else slice(None)
    dn[free] = np.linalg.solve(equations.M[free, free], pushed[free])
    dq = equations.Qq @ q + equations.Qn @ n
    dw = reduction.W @ dn + reduction.Z @ dq
    carried = (body.react @ (matrices.M @ dw + matrices.C @ w + matrices.K @ p - force))[c.supports]
    reach = slip_speed_slope(U)[0] / c.relaxation
    relaxing = (wheel.side[c.relaxing] - lagging) * reach[:, np.newaxis]
    rates = [dq, dn, control.spin @ wheel.torque, relaxing]
    if len(drive):
        rates.append((control.demand @ u - drive) / control.drive_lag)
    if len(brake):
        rates.append((control.brake @ u - brake) / control.brake_lag)
    # the supports' loads are what the accelerations make them
    known = w.shape[1] - len(c.supports)
    found = np.linalg.solve(np.eye(len(c.supports)) - carried[:, known:], carried[:, :known])
    counted, moved = from_frame(prepared, known)
    rates_, p, w, dw = ((item[:, :known] + item[:, known:] @ found) @ counted for item in (np.vstack(rates), p, w, dw))
    states = len(rates_)
    A, B = np.split(moved @ rates_, [states], axis=1)
    # place and heading change nothing but that a heading leads aside
    for exact in (A, w, dw):
        exact[:, :3] = 0.0
    A[1, 2] = U
    return Closed(A, B, p, w, dw)


def level(prepared: Prepared, p: Array) -> Array:
    """Forces of wheels, air and loads that turn with a body's heading alone, by its roll and pitch in p.

    The kernel takes them for fixed in body axes; these are the differences, in body axes.
    """
    trim, system = prepared.trim, prepared.system
    acting = [*road_loads(system, trim, held=prepared.model.body.held), *system.loads]
    force = load_sums(system.bodies, [load for load in acting if load.frame == load.body])[0].reshape(-1, 6)
    result = np.zeros_like(p)
    for i, (Fx, Fy, Fz) in enumerate(force[:, :3]):
        roll, pitch = p[6 * i + 3], p[6 * i + 4]
        result[6 * i : 6 * i + 3] = -pitch * Fz, roll * Fz, pitch * Fx - roll * Fy
    return result


def from_frame(prepared: Prepared, known: int) -> tuple[Array, Array]:
    """The kernel's coordinates by the model's, over all columns, and the reverse for rates of the states."""
    independent = prepared.matrices.reduction.independent
    lead = prepared.model.body.lead
    own = np.delete(np.arange(len(independent)), lead)
    count = len(independent)
    counted = np.eye(known)
    counted[:count, :count] = 0.0
    # velocities in body axes by those of the frame's axes
    moved = (prepared.matrices.V @ prepared.model.body.T)[independent]
    counted[count : 2 * count, len(lead) + np.arange(len(own))] = moved
    counted[lead, np.arange(len(lead))] = 1.0
    counted[own[:, np.newaxis], np.arange(len(lead))] = frame_motion(prepared.system)[independent[own]]
    counted[own, len(lead) + np.arange(len(own))] = 1.0
    states = sum(sizes(prepared.model))
    return counted, np.asarray(np.linalg.inv(counted[:states, :states]), dtype=float)
