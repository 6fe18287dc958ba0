"""Tractor and semitrailer with nonlinear tyres, in the yaw plane: thesis (3.9), (3.10) and Appendix A. SAE axes."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from eom.closed_form.arrays import Array, matrix, solve
from eom.closed_form.parameters import check_speed
from eom.closed_form.tractor_semitrailer import accelerations
from eom.closed_form.tractor_semitrailer_parameters import TractorSemitrailer

TyreForces = Callable[[Array], Array]
"""Side forces of the axles [N], to the right, by their slip angles [rad]: (axles,) from (axles,)."""


class Matrices(NamedTuple):
    """M_nl dx/dt = P_nl x + H_nl F, with the side forces F of the three axles; (4, 4), (4, 4), (4, 3).

    Rows: articulation, lateral balance of both units, yaw of the tractor, yaw of the semitrailer. The states are those
    of (3.6). Appendix A prints P_nl and H_nl for two other orders than M_nl's.
    """

    M_nl: Array
    P_nl: Array
    H_nl: Array


class System(NamedTuple):
    """dx/dt = A_nl x + B_nl F, y = C_nl x + D_nl F, (3.9): matrices (4, 4), (4, 3), (2, 4), (2, 3)."""

    A_nl: Array
    B_nl: Array
    C_nl: Array
    D_nl: Array


def matrices(p: TractorSemitrailer, U: float) -> Matrices:
    """M_nl, P_nl and H_nl at forward speed U [m/s]; numbers or symbols.

    Raises
    ------
    EomError
        If U is a number that is not positive.
    """
    check_speed(U)
    m1, m2, l_c1, l_c21 = p.m1, p.m2, p.l_c1, p.l_c21
    M_nl = [
        [0, 0, 0, 1],
        [-(l_c1 + l_c21) * m2, -l_c21 * m2, (m1 + m2) * U, 0],
        [p.I_zz1 + l_c1 * (l_c1 + l_c21) * m2, l_c1 * l_c21 * m2, -l_c1 * m2 * U, 0],
        [p.I_zz2 + l_c21 * (l_c1 + l_c21) * m2, p.I_zz2 + l_c21**2 * m2, -l_c21 * m2 * U, 0],
    ]
    P_nl = [[0, 1, 0, 0], [-(m1 + m2) * U, 0, 0, 0], [l_c1 * m2 * U, 0, 0, 0], [l_c21 * m2 * U, 0, 0, 0]]
    H_nl = [[0, 0, 0], [1, 1, 1], [p.a11, -p.b12, -l_c1], [0, 0, -(p.b23 + l_c21)]]
    return Matrices(matrix(M_nl), matrix(P_nl), matrix(H_nl))


def system(p: TractorSemitrailer, U: float) -> System:
    """A_nl, B_nl, C_nl and D_nl of thesis (3.9), in numbers; errors as `eom.closed_form.tractor_semitrailer.system`."""
    M_nl, P_nl, H_nl = matrices(p, U)
    A_nl, B_nl = solve(M_nl, P_nl, "M_nl"), solve(M_nl, H_nl, "M_nl")
    C_nl = accelerations(p, U, A_nl) + np.array([U, 0.0, 0.0, 0.0])
    return System(A_nl, B_nl, C_nl, accelerations(p, U, B_nl))


def slip_angles(p: TractorSemitrailer, U: float, x: Array, delta: Array) -> Array:
    """Slip angles (3,) [rad] of the axles, steer less direction of travel: the negative of thesis (3.3).

    *x* (4,) are the states psi_dot_1, Delta_psi_dot, beta_1, Delta_psi; *delta* (3,) the steer angles [rad].
    """
    psi_dot_1, Delta_psi_dot, beta_1, Delta_psi = x
    rear = p.l_c21 + p.b23
    travel = [
        beta_1 + p.a11 / U * psi_dot_1,
        beta_1 - p.b12 / U * psi_dot_1,
        beta_1 - Delta_psi - (p.l_c1 + rear) / U * psi_dot_1 - rear / U * Delta_psi_dot,
    ]
    return np.asarray(delta) - matrix(travel)


def right_hand_side(p: TractorSemitrailer, U: float, x: Array, delta: Array, tyres: TyreForces) -> Array:
    """dx/dt (4,) at the states *x* (4,) and steer angles *delta* (3,) [rad], thesis (3.9).

    *tyres* gives the side forces by slip angle, such as `magic_formula` with its parameters filled in.
    """
    A_nl, B_nl, _, _ = system(p, U)
    return np.asarray(A_nl @ x + B_nl @ tyres(slip_angles(p, U, x, delta)))


def outputs(p: TractorSemitrailer, U: float, x: Array, delta: Array, tyres: TyreForces) -> Array:
    """Lateral accelerations (2,) [m/s^2] of both mass centres, to the right, (3.9); arguments as `right_hand_side`."""
    _, _, C_nl, D_nl = system(p, U)
    return np.asarray(C_nl @ x + D_nl @ tyres(slip_angles(p, U, x, delta)))
