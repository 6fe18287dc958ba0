"""B-train double with nonlinear tyres and changing speed, yaw plane: thesis (3.30) to (3.35), Appendix E. SAE axes.

The states are U [m/s] and those of the linear model, beta_i [rad] and psi_dot_i [rad/s] of the three units.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from eom.closed_form import b_train_yaw_plane
from eom.closed_form.arrays import Array, matrix, solve
from eom.closed_form.b_train_parameters import BTrainBraked, BTrainYawPlane
from eom.closed_form.brakes import NO_BRAKES, brake_moments, longitudinal_forces
from eom.closed_form.cornering_drag import force_along_tractor
from eom.closed_form.parameters import check_speed

STATES = ("U", *b_train_yaw_plane.STATES)
TyreForces = Callable[[Array], Array]
"""Side forces of the axles [N], to the right, by their slip angles [rad]: (9,) from (9,)."""


class Matrices(NamedTuple):
    """J dx_p/dt = K_n x_p + L_n F_y + R_n M_z at speed U; shapes (6, 6), (6, 6), (6, 9), (6, 2).

    x_p are the states but U; F_y the side forces of axles 1 to 9, M_z the yaw moments on both semitrailers.
    """

    J: Array
    K_n: Array
    L_n: Array
    R_n: Array


class System(NamedTuple):
    """dx_p/dt = A_n x_p + B_F F_y + B_M M_z at speed U, (3.34b); shapes (6, 6), (6, 9), (6, 2)."""

    A_n: Array
    B_F: Array
    B_M: Array


class Controls(NamedTuple):
    """What acts on the train: front steer angle [rad], drive torque [N m], brake pressures [Pa] as in `brakes`."""

    delta_11: float = 0.0
    T_d: float = 0.0
    pressures: Array = NO_BRAKES


def matrices(p: BTrainYawPlane, U: float) -> Matrices:
    """J of thesis Appendix D and K_n, L_n, R_n of Appendix E; numbers or symbols.

    Raises
    ------
    EomError
        If U is a number that is not positive.
    """
    check_speed(U)
    m1, m2, m3 = p.m1, p.m2, p.m3
    l_c1, l_c21, l_c22, l_c3 = p.l_c1, p.l_c21, p.l_c22, p.l_c3
    one, two, three = ([axle.x for axle in axles] for axles in p.axles)
    K_n = [
        [0, -l_c1 * m1 * U, 0, 0, 0, 0],
        [0, -m1 * U, 0, -m2 * U, 0, -m3 * U],
        [0, -l_c21 * m1 * U, 0, 0, 0, l_c22 * m3 * U],
        [0, 0, 0, 0, 0, l_c3 * m3 * U],
        [0, -1, 0, 1, 0, 0],
        [0, 0, 0, -1, 0, 1],
    ]
    L_n = [
        [*(x + l_c1 for x in one), 0, 0, 0, 0, 0, 0],
        [1] * 9,
        [l_c21] * 3 + two + [-l_c22] * 3,
        [0, 0, 0, 0, 0, 0, *(x - l_c3 for x in three)],
        [0] * 9,
        [0] * 9,
    ]
    R_n = [[0, 0], [0, 0], [1, 0], [0, 1], [0, 0], [0, 0]]
    return Matrices(b_train_yaw_plane.inertia(p, U), matrix(K_n), matrix(L_n), matrix(R_n))


def system(p: BTrainYawPlane, U: float) -> System:
    """A_n, B_F and B_M of thesis (3.34b), in numbers; errors as `eom.closed_form.b_train_yaw_plane.system`."""
    J, K_n, L_n, R_n = matrices(p, U)
    return System(solve(J, K_n, "J"), solve(J, L_n, "J"), solve(J, R_n, "J"))


def slip_angles(p: BTrainYawPlane, x: Array, delta_11: float) -> Array:
    """Slip angles (9,) [rad] of the axles, steer less direction of travel: thesis (3.35).

    *x* (7,) are the states; only the front axle is steered, by *delta_11* [rad]. The force C alpha pushes to where the
    wheel points.
    """
    U = x[0]
    travel = [
        beta + axle.x / U * psi_dot
        for axles, beta, psi_dot in zip(p.axles, x[1::2], x[2::2], strict=True)
        for axle in axles
    ]
    return np.asarray(np.array([delta_11, *[0.0] * 8]) - np.array(travel))


def rates(p: BTrainBraked, x: Array, F_y: Array, controls: Controls, *, cornering_drag: bool) -> Array:
    """dx/dt (7,) at the states *x* (7,) from the side forces *F_y* (9,) [N] of the axles, to the right: thesis (3.34).

    Parameters
    ----------
    cornering_drag : bool
        If false, dU/dt is (3.34a), which of all that cornering does to the speed has only m_i U beta_i psi_dot_i. If
        true, all terms of second order are in it, see `eom.closed_form.cornering_drag`.

    Notes
    -----
    (3.34) holds for small angles and small longitudinal forces. If slip, steer, articulation and yaw are of order e and
    the longitudinal accelerations of order e^2, beta and psi_dot are right to e^2 (their error is of order e^3). So is
    dU/dt with the cornering drag, to e^3 (error e^4); without it the error is of order e^2, as dU/dt itself. At hard
    braking the side balances lack terms of first order, dU/dt beta_i and F_cx Gamma.

    Raises
    ------
    EomError
        If U is not positive, or a brake pressure cannot be.
    """
    U, x_p = x[0], x[1:]
    A_n, B_F, B_M = system(p, U)
    x_p_dot = A_n @ x_p + B_F @ F_y + B_M @ brake_moments(p, controls.pressures)
    m = p.m1 + p.m2 + p.m3
    drive = np.sum(longitudinal_forces(p, controls.T_d, controls.pressures)) - p.f_r * m * p.g
    if cornering_drag:
        turning = force_along_tractor(p, U, x_p, x_p_dot, F_y, controls.delta_11)
    else:
        turning = U * (p.m1 * x_p[0] * x_p[1] + p.m2 * x_p[2] * x_p[3] + p.m3 * x_p[4] * x_p[5])
    return np.array([(drive + turning) / m, *x_p_dot])


def right_hand_side(p: BTrainBraked, x: Array, controls: Controls, tyres: TyreForces, *, cornering_drag: bool) -> Array:
    """The same with the side forces that *tyres* gives at the slip angles of (3.35)."""
    F_y = tyres(slip_angles(p, x, controls.delta_11))
    return rates(p, x, F_y, controls, cornering_drag=cornering_drag)
