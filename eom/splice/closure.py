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
from eom.splice.state import sizes
from eom.splice.trim import road_loads

STEP = 1e-30
ALPHA, KAPPA, LOAD, CAMBER, SPEED = range(5)


class Closed(NamedTuple):
    """dx/dt = A x + B u about the trim, and the motions that outputs measure, as columns over (x, u).

    Attributes
    ----------
    A, B : Array
        In the states of the nonlinear equations, speeds counted from the trim's.
    p, w, dw : Array
        Displacements, velocities and accelerations of all bodies by (x, u), (N, states + inputs).
    load : Array
        Loads of the wheels by (x, u).
    """

    A: Array
    B: Array
    p: Array
    w: Array
    dw: Array
    load: Array


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


def close(prepared: Prepared) -> Closed:
    """The linear model about the trim."""
    model, trim, matrices = prepared.model, prepared.trim, prepared.matrices
    body, c, control = model.body, model.contact, model.control
    U, reduction = trim.speed, matrices.reduction
    equations = independent_equations(matrices)
    frame, q, n, spin, side, drive, brake = sizes(model)
    states, inputs, supports = frame + q + n + spin + side + drive + brake, len(control.demand), len(c.supports)
    every = np.eye(states + inputs + supports)
    parts = np.split(every, np.cumsum([frame + q, n, spin, side, drive, brake, inputs]))
    q_, n_, spin_, side_, drive_, brake_, u_, support_ = parts
    w, p = reduction.W @ n_ + reduction.Z @ q_, reduction.T @ q_
    dp = w - matrices.V @ p
    steer, omega = control.steer @ u_, (c.rows[FORWARD] @ w) / c.radius[:, np.newaxis]
    omega[c.spinning] = spin_
    kinematic = (c.rows[LATERAL] @ w) / U - steer
    alpha = kinematic + 0.0
    alpha[c.relaxing] = side_
    turned = (1.0 + trim.slip)[:, np.newaxis]
    spinning = np.zeros((len(c.number), 1))
    spinning[c.spinning] = 1.0
    kappa = spinning * (c.radius[:, np.newaxis] * omega - turned * (c.rows[FORWARD] @ w)) / U
    load = c.share @ support_ + (c.rolled + c.sprung) @ p + c.damped @ dp
    arguments = np.array([alpha, kappa, load, c.lean @ p, c.rows[FORWARD] @ w])
    Fx, Fy, Mx, My, Mz = np.einsum("acw,aws->cws", slopes_at_trim(prepared), arguments)
    torque = np.outer(control.drive, drive_[0] if drive else control.demand @ u_)
    torque -= brake_ if brake else control.brake @ u_
    Fx = spinning * Fx + (1.0 - spinning) * (torque + My) / c.radius[:, np.newaxis]
    Fx0, Fy0, Mx0, _, _ = trim.forces[:, :, np.newaxis]
    on_body = np.array(
        [
            Fx - Fy0 * steer,
            Fy + Fx0 * steer,
            Mx + c.lever[:, np.newaxis] * load,
            Mx0 * steer - spinning * torque,
            Mz,
            0.0 * Fx,
        ]
    )
    drag = 2.0 * U * control.drags.T @ (control.drag_factor[:, np.newaxis] * (control.drags @ w))
    force = np.einsum("kwn,kws->ns", c.rows, on_body) - drag + level(prepared, p)
    pushed = reduction.W.T @ (force + body.B @ u_) - equations.C @ n_ - equations.K @ q_
    dn = np.zeros_like(n_)
    free = slice(1, None) if body.held else slice(None)
    dn[free] = np.linalg.solve(equations.M[free, free], pushed[free])
    dq = equations.Qq @ q_ + equations.Qn @ n_
    dw = reduction.W @ dn + reduction.Z @ dq
    lacking = matrices.M @ dw + matrices.C @ w + matrices.K @ p - body.B @ u_ - force
    carried = (body.react @ lacking)[c.supports]
    rates = [dq, dn, control.spin @ (torque + My - c.radius[:, np.newaxis] * Fx)]
    rates.append((kinematic[c.relaxing] - side_) * (U / c.relaxation)[:, np.newaxis])
    if drive:
        rates.append((control.demand @ u_ - drive_) / control.drive_lag)
    if brake:
        rates.append((control.brake @ u_ - brake_) / control.brake_lag)
    known = states + inputs
    found = np.linalg.solve(np.eye(supports) - carried[:, known:], carried[:, :known])
    counted, moved = from_frame(prepared, states + inputs)
    rates_, p, w, dw, load = (
        (item[:, :known] + item[:, known:] @ found) @ counted for item in (np.vstack(rates), p, w, dw, load)
    )
    rates_ = moved @ rates_
    A, B = rates_[:, :states], rates_[:, states:]
    # place and heading change nothing but that a heading leads aside
    A[:, :frame] = 0.0
    A[1, 2] = U
    return Closed(A, B, p, w, dw, load)


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
