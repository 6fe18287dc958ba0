"""A tractor with semitrailer, small motion and steady turns: textbook equations, held to the referee `planar_train`."""

from functools import cache

import numpy as np
import sympy as sp
from scipy.optimize import fsolve

from eom.tyre import Linear
from tests.referees.planar_parts import Array, PlanarTrain, PlanarUnit, PlanarWheel, straight_state
from tests.referees.planar_train import accelerations, rhs

M1, I1, A1, B1, C1, M2, I2, A2, B2 = 6525.0, 20616.0, 1.115, 2.585, 1.959, 11665.0, 113580.0, 5.493, 4.507
"""Mass, inertia; distances from the centre to front axle, rear axle and pin; the same of the second: pin, axle."""
STIFFNESS = (242.6e3, 578.8e3, 554.5e3)
"""Cornering stiffness of the three axles, N/rad."""
SPEED = 22.0


def axle(x: float, cornering: float, steer_index: int | None = None) -> PlanarWheel:
    """An axle with one linear tyre that drags nothing."""
    tyre = Linear(nominal_load=30e3, cornering=cornering)
    return PlanarWheel(x=x, radius=0.5, load=30e3, tyre=tyre.forces, steer_index=steer_index)


SEMITRAILER = PlanarTrain(
    (
        PlanarUnit(mass=M1, yaw_inertia=I1, rear=-C1, wheels=(axle(A1, STIFFNESS[0], 0), axle(-B1, STIFFNESS[1]))),
        PlanarUnit(mass=M2, yaw_inertia=I2, front=A2, wheels=(axle(-B2, STIFFNESS[2]),)),
    )
)


@cache
def lagrange() -> tuple[Array, Array]:
    """Derivative of (yaws, v_y, yaw rates) by (yaws, v_y, yaw rates), (5, 5), and by steer, (5,), at straight running.

    Lagrange's equations in the tractor's place y, its yaw and the articulation, of motion at constant x speed.
    """
    t, delta = sp.symbols("t delta")
    m1, i1, a1, b1, c1, m2, i2, a2, b2, *C, U = (
        sp.Float(value, 30) for value in (M1, I1, A1, B1, C1, M2, I2, A2, B2, *STIFFNESS, SPEED)
    )
    q = [sp.Function(name)(t) for name in ("y", "psi", "theta")]
    y, psi, theta = q
    behind = psi + theta

    def point(along: sp.Expr, trailing: sp.Expr) -> sp.Matrix:
        """So far ahead of the tractor's centre on its axis, then so far on the semitrailer's."""
        return sp.Matrix(
            [
                U * t + along * sp.cos(psi) + trailing * sp.cos(behind),
                y + along * sp.sin(psi) + trailing * sp.sin(behind),
            ]
        )

    trailer = point(-c1, -a2)
    T = m1 * point(0, 0).diff(t).dot(point(0, 0).diff(t)) / 2 + m2 * trailer.diff(t).dot(trailer.diff(t)) / 2
    T += i1 * psi.diff(t) ** 2 / 2 + i2 * behind.diff(t) ** 2 / 2
    Q = sp.zeros(3, 1)
    places = ((point(a1, 0), psi + delta), (point(-b1, 0), psi), (point(-c1, -a2 - b2), behind))
    for stiffness, (place, heading) in zip(C, places, strict=True):
        v = place.diff(t)
        forward = v[0] * sp.cos(heading) + v[1] * sp.sin(heading)
        left = -v[0] * sp.sin(heading) + v[1] * sp.cos(heading)
        force = -stiffness * sp.atan(left / forward) * sp.Matrix([-sp.sin(heading), sp.cos(heading)])
        Q += place.jacobian(q).T * force
    law = sp.Matrix([T.diff(each.diff(t)).diff(t) - T.diff(each) for each in q]) - Q
    plain = sp.symbols("q:9")  # places, rates, accelerations
    moving = [each.diff(t, order) if order else each for order in (2, 1, 0) for each in q]
    names = dict(zip(moving, (*plain[6:], *plain[3:6], *plain[:3]), strict=True))
    law = law.doit().subs(names)
    rest = dict.fromkeys((*plain, delta), 0)
    K, D, M, S = (
        np.array(law.jacobian(part).subs(rest), dtype=float) for part in (plain[:3], plain[3:6], plain[6:], [delta])
    )
    # (yaws, v_y, yaw rates) to q and q': y' = v_y + U psi, theta = yaw_2 - yaw_1; y itself is in no equation
    place = np.array([[0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [-1, 1, 0, 0, 0]], dtype=float)
    rate = np.array([[SPEED, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, -1, 1]], dtype=float)
    growth = rate[:, 2:]
    by_state = np.linalg.solve(M @ growth, -(K @ place + D @ rate) - M @ rate[:, :2] @ np.eye(5)[3:])
    A = np.vstack([np.eye(5)[3:], by_state])
    B = np.concatenate([np.zeros(2), np.linalg.solve(M @ growth, -S)[:, 0]])
    return A, B


def test_small_motion_is_that_of_lagranges_equations() -> None:
    """Central differences, extrapolated once from 1e-3: fourth-order error 1e-12 and rounding 1e-13, of the largest."""
    straight, kept = straight_state(SEMITRAILER, SPEED), [2, 3, 5, 6, 7]

    def difference(direction: Array, steer: float, step: float) -> Array:
        ends = [rhs(SEMITRAILER, straight + s * direction, [s * steer], np.zeros(3)) for s in (step, -step)]
        return (ends[0] - ends[1]) / (2.0 * step)

    def slope(direction: Array, steer: float) -> Array:
        both = difference(direction, steer, 1e-3), difference(direction, steer, 2e-3)
        return np.asarray((4.0 * both[0] - both[1]) / 3.0)[kept]

    A, B = lagrange()
    scale = 1e-8 * float(np.max(np.abs(A)))
    directions = np.eye(len(straight))
    np.testing.assert_allclose(np.column_stack([slope(directions[k], 0.0) for k in kept]), A, atol=scale)
    np.testing.assert_allclose(slope(np.zeros(len(straight)), 1.0), B, atol=scale)


def turn(steer: float) -> Array:
    """The state in which a train without drive turns and only its speed changes, by v_x = 22 m/s."""

    def state(free: Array) -> Array:
        v_y, r, theta = free
        return np.array([0.0, 0.0, 0.0, theta, SPEED, v_y, r, r])

    def unsteady(free: Array) -> Array:
        return rhs(SEMITRAILER, state(free), [steer], np.zeros(3))[5:]

    return state(fsolve(unsteady, np.zeros(3), xtol=1e-13))


def excess(steer: float) -> tuple[float, float]:
    """Deceleration of the turn over that by loss of slip, and over that by shares of load, each less one."""
    state = turn(steer)
    on = accelerations(SEMITRAILER, state, [steer], np.zeros(3)).contacts
    slowing, mass = -rhs(SEMITRAILER, state, [steer], np.zeros(3))[4], M1 + M2
    loss = -float(np.sum(on.Fx * on.v_x + on.Fy * on.v_y))
    # each axle holds its share of the mass on the circle: by levers, as in statics
    last = M2 * A2 / (A2 + B2)
    pin = M2 - last
    front = (M1 * B1 + pin * (B1 - C1)) / (A1 + B1)
    shares = np.array([front, M1 + pin - front, last])
    by_shares = np.sum((shares * SPEED * state[6]) ** 2 / STIFFNESS) / mass
    return slowing * mass * SPEED / loss - 1.0, slowing / by_shares - 1.0


def test_a_turn_without_drive_slows_down_by_the_loss_of_slip() -> None:
    """Both hold to the second order of the angles: a quarter is left at half the steer, nothing at none.

    What is left of the extrapolation is of the fourth order: the square of 2e-4.
    """
    coarse, fine = np.array(excess(0.02)), np.array(excess(0.01))
    assert np.all(np.abs(coarse) < 1e-3)
    np.testing.assert_allclose(coarse / fine, 4.0, rtol=1e-3)
    np.testing.assert_allclose((4.0 * fine - coarse) / 3.0, 0.0, atol=1e-7)
