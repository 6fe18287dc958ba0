"""B-train double, linear in the yaw plane: thesis (3.26) to (3.29) and Appendix D. SAE axes."""

from typing import NamedTuple

import numpy as np

from eom.closed_form.arrays import Array, matrix, solve
from eom.closed_form.b_train_parameters import BTrainYawPlane
from eom.closed_form.parameters import check_speed
from eom.closed_form.state_space import StateSpace
from eom.closed_form.tyre_derivatives import tyre_derivatives

STATES = ("beta_1", "psi_dot_1", "beta_2", "psi_dot_2", "beta_3", "psi_dot_3")
INPUTS = ("delta_11", "delta_4", "delta_5", "delta_6", "delta_7", "delta_8", "delta_9", "M_z_2", "M_z_3")
OUTPUTS = ("a_y_1", "a_y_2", "a_y_3")


class Matrices(NamedTuple):
    """J dx/dt + K x + L delta_11 + T u_s + V u_M = 0; shapes (6, 6), (6, 6), (6, 1), (6, 6), (6, 2).

    Rows: the tractor's yaw about the first coupling, lateral balance of the train, yaw of the semitrailers with the
    coupling forces eliminated, and the two couplings, (3.18c) and (3.18d). u_s are the steer angles of axles 4 to 9,
    u_M the yaw moments on the semitrailers.
    """

    J: Array
    K: Array
    L: Array
    T: Array
    V: Array


class System(NamedTuple):
    """dx/dt = A_p x + C_p delta_11 + B_p u_s + B_m u_M, (3.29); shapes (6, 6), (6, 6), (6, 1), (6, 2)."""

    A_p: Array
    B_p: Array
    C_p: Array
    B_m: Array


def matrices(p: BTrainYawPlane, U: float) -> Matrices:
    """J, K, L, T and V of thesis Appendix D.

    V(4, 2) is -1. It is printed as +1, with which the moment on the second semitrailer would act backwards.

    Parameters
    ----------
    p : BTrainYawPlane
        Numbers or symbols.
    U : float
        Forward speed [m/s], or a symbol.

    Returns
    -------
    Matrices
        For the states beta_i [rad], psi_dot_i [rad/s] of the three units, SAE axes.

    Raises
    ------
    EomError
        If U is a number that is not positive.
    """
    check_speed(U)
    m1, m2, m3 = p.m1, p.m2, p.m3
    l_c1, l_c21, l_c22, l_c3 = p.l_c1, p.l_c21, p.l_c22, p.l_c3
    one, two, three = (tyre_derivatives(axles, U) for axles in p.axles)
    side_1, side_3 = m1 * U - one.Y_psi_dot, m3 * U - three.Y_psi_dot
    Y1, N1 = one.Y_delta[0], one.N_delta[0]  # only the front axle of the tractor is steered
    K = [
        [-(one.N_beta + l_c1 * one.Y_beta), l_c1 * m1 * U - one.N_psi_dot - l_c1 * one.Y_psi_dot, 0, 0, 0, 0],
        [-one.Y_beta, side_1, -two.Y_beta, m2 * U - two.Y_psi_dot, -three.Y_beta, side_3],
        [-l_c21 * one.Y_beta, l_c21 * side_1, -two.N_beta, -two.N_psi_dot, l_c22 * three.Y_beta, -l_c22 * side_3],
        [0, 0, 0, 0, l_c3 * three.Y_beta - three.N_beta, -l_c3 * side_3 - three.N_psi_dot],
        [0, 1, 0, -1, 0, 0],
        [0, 0, 0, 1, 0, -1],
    ]
    last = [l_c3 * Y - N for Y, N in zip(three.Y_delta, three.N_delta, strict=True)]
    T = [
        [0] * 6,
        [-Y for Y in (*two.Y_delta, *three.Y_delta)],
        [-N for N in two.N_delta] + [l_c22 * Y for Y in three.Y_delta],
        [0, 0, 0, *last],
        [0] * 6,
        [0] * 6,
    ]
    return Matrices(
        J=inertia(p, U),
        K=matrix(K),
        L=matrix([[-(N1 + l_c1 * Y1)], [-Y1], [-l_c21 * Y1], [0], [0], [0]]),
        T=matrix(T),
        V=matrix([[0, 0], [0, 0], [-1, 0], [0, -1], [0, 0], [0, 0]]),
    )


def inertia(p: BTrainYawPlane, U: float) -> Array:
    """J (6, 6) of thesis Appendix D, for numbers or symbols."""
    m1, m2, m3 = p.m1, p.m2, p.m3
    J = [
        [p.l_c1 * m1 * U, p.I_zz1, 0, 0, 0, 0],
        [m1 * U, 0, m2 * U, 0, m3 * U, 0],
        [p.l_c21 * m1 * U, 0, 0, p.I_zz2, -p.l_c22 * m3 * U, 0],
        [0, 0, 0, 0, -p.l_c3 * m3 * U, p.I_zz3],
        [1, -p.l_c1 / U, -1, -p.l_c21 / U, 0, 0],
        [0, 0, 1, -p.l_c22 / U, -1, -p.l_c3 / U],
    ]
    return matrix(J)


def system(p: BTrainYawPlane, U: float) -> System:
    """A_p, B_p, C_p and B_m of thesis (3.29), in numbers.

    Raises
    ------
    EomError
        If U is not positive, a value is a symbol, or J is singular.
    """
    J, K, L, T, V = matrices(p, U)
    return System(A_p=-solve(J, K, "J"), B_p=-solve(J, T, "J"), C_p=-solve(J, L, "J"), B_m=-solve(J, V, "J"))


def state_space(p: BTrainYawPlane, U: float) -> StateSpace:
    """The same as one named state space: B = [C_p B_p B_m].

    The thesis gives (3.29) no outputs. These are the lateral accelerations U (d beta/dt + psi_dot) [m/s^2] of the three
    mass centres, to the right, as in (3.25). Errors as `system`.
    """
    A, B_p, C_p, B_m = system(p, U)
    B = np.column_stack([C_p, B_p, B_m])
    return StateSpace(A, B, U * (A[0::2] + np.eye(6)[1::2]), U * B[0::2], STATES, INPUTS, OUTPUTS)
