"""A train in the plane by Kane's method of sympy: exact for any angle and any force, and linear about straight running.

SAE axes: x forward, y right, z down, so that yaw is positive to the right.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import sympy as sp
import sympy.physics.mechanics as me

from eom.closed_form import BTrainYawPlane, TractorSemitrailer
from tests.closed_form.symbols import symbolic


class Unit(NamedTuple):
    """A unit: mass, yaw inertia, (C, x) of its axles, distances from its mass centre to the hitch ahead and behind."""

    m: Any
    I_zz: Any
    axles: Sequence[tuple[Any, Any]]
    ahead: Any
    behind: Any


class PlanarKane(NamedTuple):
    """mass_matrix d(speeds)/dt = forcing, with what is needed to compare it.

    Attributes
    ----------
    speeds : list
        U, V of the first unit's mass centre in its own axes, then the yaw rate of each unit.
    articulations : list
        Heading of each unit but the first, less the first unit's.
    F_x, F_y, delta : list
        Forces of each axle in the axes of its wheels, and its steer angle.
    M_z : list
        Yaw moment on each unit.
    travel : list
        Direction of travel of each axle, by the speeds, from its unit's x axis.
    sideways, acceleration : list
        Velocity and acceleration of each unit's mass centre along its own y axis.
    """

    mass_matrix: sp.Matrix
    forcing: sp.Matrix
    speeds: list[Any]
    articulations: list[Any]
    F_x: list[Any]
    F_y: list[Any]
    delta: list[Any]
    M_z: list[Any]
    travel: list[Any]
    sideways: list[Any]
    acceleration: list[Any]


def planar_train(units: Sequence[Unit]) -> PlanarKane:
    """The equations of a train of units joined by pins."""
    count, axles = len(units), sum(len(unit.axles) for unit in units)
    U, V, *r = speeds = me.dynamicsymbols(f"u_U u_V r1:{count + 1}")
    psi, *Gamma = angles = me.dynamicsymbols(f"psi Gamma2:{count + 1}")
    F_x, F_y, delta = (list(sp.symbols(f"{name}1:{axles + 1}")) for name in ("Fx_", "Fy_", "delta_"))
    M_z = list(sp.symbols(f"Mz_1:{count + 1}"))
    N, t = me.ReferenceFrame("N"), sp.Symbol("t")
    first = N.orientnew("F1", "Axis", (psi, N.z))
    first.set_ang_vel(N, r[0] * N.z)
    frames = [first]
    for k, angle in enumerate(Gamma, start=1):
        frame = first.orientnew(f"F{k + 1}", "Axis", (angle, N.z))
        frame.set_ang_vel(N, r[k] * N.z)
        frames.append(frame)
    bodies: list[Any] = []
    loads: list[Any] = []
    centres: list[Any] = []
    contacts: list[Any] = []
    for k, (unit, frame) in enumerate(zip(units, frames, strict=True)):
        centre = me.Point(f"G{k + 1}")
        if k == 0:
            centre.set_vel(N, U * frame.x + V * frame.y)
        else:
            hitch = centres[-1].locatenew(f"H{k}", -units[k - 1].behind * frames[k - 1].x)
            hitch.v2pt_theory(centres[-1], N, frames[k - 1])
            centre = hitch.locatenew(f"G{k + 1}", -unit.ahead * frame.x)
            centre.v2pt_theory(hitch, N, frame)
        centres.append(centre)
        inertia = me.inertia(frame, 0, 0, unit.I_zz)
        bodies.append(me.RigidBody(f"B{k + 1}", centre, frame, unit.m, (inertia, centre)))
        loads.append((frame, M_z[k] * N.z))
        for _, x in unit.axles:
            contact = centre.locatenew(f"P{len(contacts) + 1}", x * frame.x)
            contact.v2pt_theory(centre, N, frame)
            wheel = frame.orientnew(f"W{len(contacts) + 1}", "Axis", (delta[len(contacts)], N.z))
            loads.append((contact, F_x[len(contacts)] * wheel.x + F_y[len(contacts)] * wheel.y))
            velocity = contact.vel(N)
            contacts.append(sp.atan(velocity.dot(frame.y) / velocity.dot(frame.x)))
    kinematics = [r[0] - psi.diff(t)] + [r[k] - r[0] - angle.diff(t) for k, angle in enumerate(Gamma, start=1)]
    method = me.KanesMethod(N, q_ind=angles, u_ind=speeds, kd_eqs=kinematics)
    method.kanes_equations(bodies, loads)
    turning = {angle.diff(t): r[k] - r[0] for k, angle in enumerate(Gamma, start=1)} | {psi.diff(t): r[0]}
    return PlanarKane(
        method.mass_matrix,
        method.forcing,
        speeds,
        Gamma,
        F_x,
        F_y,
        delta,
        M_z,
        contacts,
        [point.vel(N).dot(frame.y) for point, frame in zip(centres, frames, strict=True)],
        [point.acc(N).dot(frame.y).subs(turning) for point, frame in zip(centres, frames, strict=True)],
    )


class LinearTrain(NamedTuple):
    """mass dz/dt = state z + control u about straight running at constant U, with z = V, r_1 .., Gamma_2 ..

    u are the steer angles of all axles and the yaw moments on all units. The rows of *sideslip* give beta_i by z; the
    accelerations along y are *by_rate* dz/dt + *by_state* z. The forward equation drops out: it has no first order.
    """

    mass: sp.Matrix
    state: sp.Matrix
    control: sp.Matrix
    sideslip: sp.Matrix
    by_rate: sp.Matrix
    by_state: sp.Matrix


def linear(train: PlanarKane, units: Sequence[Unit], speed: Any) -> LinearTrain:
    """A train's equations to first order, its tyres giving C (delta - direction of travel)."""
    U, *lateral = train.speeds
    t = sp.Symbol("t")
    stiffness = sp.diag(*(C for unit in units for C, _ in unit.axles))
    alpha = [steer - travel for steer, travel in zip(train.delta, train.travel, strict=True)]
    z, u = [*lateral, *train.articulations], [*train.delta, *train.M_z]
    # no force acts at straight running: forces count by their own first order alone
    without = dict.fromkeys([*train.F_x, *train.F_y], 0)
    straight: dict[Any, Any] = {U.diff(t): 0} | dict.fromkeys([*z, *u, *train.F_x, *train.F_y], 0) | {U: speed}

    def derivative(expressions: Any, by: Sequence[Any]) -> sp.Matrix:
        return sp.Matrix(expressions).jacobian(by).subs(straight)

    n, k = len(lateral), len(train.articulations)
    forcing = train.forcing[1:, :]
    tyres = derivative(forcing, train.F_y) * stiffness
    mass = sp.diag(train.mass_matrix[1:, 1:].subs(straight), sp.eye(k))
    turning = sp.zeros(k, n + k)  # dGamma/dt = r - r_1
    for i in range(k):
        turning[i, 1], turning[i, 2 + i] = -1, 1
    rates = [symbol.diff(t) for symbol in lateral]
    still = dict.fromkeys(rates, 0)
    accelerations = sp.Matrix(train.acceleration)
    return LinearTrain(
        mass=mass,
        state=(derivative(forcing.subs(without), z) + tyres * derivative(alpha, z)).col_join(turning),
        control=(derivative(forcing.subs(without), u) + tyres * derivative(alpha, u)).col_join(sp.zeros(k, len(u))),
        sideslip=derivative(train.sideways, z) / speed,
        by_rate=derivative(accelerations, rates).row_join(sp.zeros(len(units), k)),
        by_state=derivative(accelerations.subs(still), z),
    )


def tractor_semitrailer_units(p: TractorSemitrailer) -> list[Unit]:
    """The two units of thesis Figure 3.1."""
    return [
        Unit(p.m1, p.I_zz1, [(p.C_f11, p.a11), (p.C_r12, -p.b12)], None, p.l_c1),
        Unit(p.m2, p.I_zz2, [(p.C_r23, -p.b23)], p.l_c21, None),
    ]


def b_train_units(p: BTrainYawPlane) -> list[Unit]:
    """The three units of the B-train."""
    one, two, three = p.axles
    return [
        Unit(p.m1, p.I_zz1, one, None, p.l_c1),
        Unit(p.m2, p.I_zz2, two, p.l_c21, p.l_c22),
        Unit(p.m3, p.I_zz3, three, p.l_c3, None),
    ]


@cache
def tractor_semitrailer_by_kane() -> PlanarKane:
    """The tractor and semitrailer, in symbols."""
    return planar_train(tractor_semitrailer_units(symbolic(TractorSemitrailer)))


@cache
def b_train_by_kane() -> PlanarKane:
    """The B-train, in symbols."""
    return planar_train(b_train_units(symbolic(BTrainYawPlane)))
