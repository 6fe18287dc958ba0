"""Tractor and semitrailer, linear in the yaw plane: thesis (3.1) to (3.8) and Appendix A. SAE axes."""

from typing import NamedTuple

import numpy as np

from eom.closed_form.arrays import Array, matrix, solve
from eom.closed_form.parameters import check_speed
from eom.closed_form.state_space import StateSpace
from eom.closed_form.tractor_semitrailer_parameters import TractorSemitrailer

STATES = ("psi_dot_1", "Delta_psi_dot", "beta_1", "Delta_psi")
INPUTS = ("delta_1f", "delta_2", "delta_3")
OUTPUTS = ("a_y_1", "a_y_2")


class Matrices(NamedTuple):
    """M dx/dt = P x + H1 delta_1f + H2 delta_2 + H3 delta_3, (3.5); M and P (4, 4), H1 to H3 (4,).

    Rows: lateral balance of both units, yaw of the tractor, yaw of the semitrailer, articulation.
    """

    M: Array
    P: Array
    H1: Array
    H2: Array
    H3: Array


class System(NamedTuple):
    """dx/dt = A x + B1 delta_1f + B2 delta_2 + B3 delta_3, (3.7), and y = C x + D1 delta_1f + ..., (3.8)."""

    A: Array
    B1: Array
    B2: Array
    B3: Array
    C: Array
    D1: Array
    D2: Array
    D3: Array


def matrices(p: TractorSemitrailer, U: float) -> Matrices:
    """M, P, H1, H2 and H3 of thesis Appendix A.

    Parameters
    ----------
    p : TractorSemitrailer
        Numbers or symbols.
    U : float
        Forward speed [m/s], or a symbol.

    Returns
    -------
    Matrices
        For the states psi_dot_1 [rad/s], Delta_psi_dot [rad/s], beta_1 [rad], Delta_psi [rad] of (3.6), with the
        articulation Delta_psi = psi_2 - psi_1; SAE axes.

    Raises
    ------
    EomError
        If U is a number that is not positive.
    """
    check_speed(U)
    m1, m2, a11, b12, l_c1, l_c21 = p.m1, p.m2, p.a11, p.b12, p.l_c1, p.l_c21
    C1, C2, C3 = p.C_f11, p.C_r12, p.C_r23
    rear = l_c21 + p.b23  # from the fifth wheel back to the semitrailer's axle
    M = [
        [-m2 * (l_c1 + l_c21), -m2 * l_c21, (m1 + m2) * U, 0],
        [p.I_zz1 + m2 * l_c1 * (l_c1 + l_c21), m2 * l_c1 * l_c21, -m2 * l_c1 * U, 0],
        [p.I_zz2 + m2 * l_c21 * (l_c1 + l_c21), p.I_zz2 + m2 * l_c21**2, -m2 * l_c21 * U, 0],
        [0, 0, 0, 1],
    ]
    # slip of the semitrailer's axle by the states, (3.3b)
    slip = [-(l_c1 + rear) / U, -rear / U, 1, -1]
    P = [
        [(C2 * b12 - C1 * a11) / U - (m1 + m2) * U, 0, -(C1 + C2), 0],
        [m2 * l_c1 * U - (C1 * a11**2 + C2 * b12**2) / U, 0, C2 * b12 - C1 * a11, 0],
        [m2 * l_c21 * U, 0, 0, 0],
        [0, 1, 0, 0],
    ]
    acts = [-C3, C3 * l_c1, C3 * rear, 0]
    return Matrices(
        M=matrix(M),
        P=matrix(P) + np.outer(matrix(acts), matrix(slip)),
        H1=matrix([C1, C1 * a11, 0, 0]),
        H2=matrix([C2, -C2 * b12, 0, 0]),
        H3=-matrix(acts),
    )


def accelerations(p: TractorSemitrailer, U: float, rates: Array) -> Array:
    """Rows that give the lateral accelerations of both mass centres less U psi_dot_1, from the rates of the states.

    (2, n) from *rates* (4, n): how Appendix A makes D from B and C from A.
    """
    tractor = U * rates[2]
    return np.array([tractor, tractor - (p.l_c21 + p.l_c1) * rates[0] - p.l_c21 * rates[1]])


def system(p: TractorSemitrailer, U: float) -> System:
    """A, B1 to B3, C and D1 to D3 of thesis (3.7), (3.8), in numbers.

    Outputs are the lateral accelerations of both mass centres [m/s^2], to the right.

    Raises
    ------
    EomError
        If U is not positive, a value is a symbol, or M is singular.
    """
    M, P, H1, H2, H3 = matrices(p, U)
    A, B = solve(M, P, "M"), solve(M, np.column_stack([H1, H2, H3]), "M")
    C, D = accelerations(p, U, A) + np.array([U, 0.0, 0.0, 0.0]), accelerations(p, U, B)
    return System(A, B[:, 0], B[:, 1], B[:, 2], C, D[:, 0], D[:, 1], D[:, 2])


def state_space(p: TractorSemitrailer, U: float) -> StateSpace:
    """The same as one named state space: B = [B1 B2 B3], D = [D1 D2 D3]."""
    A, B1, B2, B3, C, D1, D2, D3 = system(p, U)
    B, D = np.column_stack([B1, B2, B3]), np.column_stack([D1, D2, D3])
    return StateSpace(A, B, C, D, STATES, INPUTS, OUTPUTS)
