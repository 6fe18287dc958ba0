"""What cornering does to the speed of the B-train, complete to second order: the terms that thesis (3.34a) drops.

Along the tractor's axis the acceleration of the train's common mass centre needs only forces from outside: no coupling
force enters. With Gamma_i = psi_i - psi_1, exact for any angle,

    sum_i m_i a_i . x_1 = sum F_x cos - F_y1 sin(delta_11) - sum_{4..6} F_y sin(Gamma_2) - sum_{7..9} F_y sin(Gamma_3)

and, unit by unit along the chain,

    a_1 . x_1 = dU/dt - V_1 psi_dot_1
    a_2 . x_1 = a_1 . x_1 + l_c1 psi_dot_1^2 + l_c21 (psi_dot_2^2 cos(Gamma_2) + psi_ddot_2 sin(Gamma_2))
    a_3 . x_1 = a_2 . x_1 + l_c22 (the same as l_c21 has) + l_c3 (psi_dot_3^2 cos(Gamma_3) + psi_ddot_3 sin(Gamma_3)).

To second order sin(Gamma) = Gamma and cos(Gamma) = 1.
"""

import numpy as np

from eom.closed_form.arrays import Array
from eom.closed_form.b_train_parameters import BTrainYawPlane


def articulations(p: BTrainYawPlane, U: float, x_p: Array) -> Array:
    """Headings (2,) [rad] of both semitrailers less the tractor's, Gamma_2 and Gamma_3, to first order.

    The couplings give them from *x_p* (6,), that is beta_i and psi_dot_i: at the first one
    U beta_1 - l_c1 psi_dot_1 = U beta_2 + l_c21 psi_dot_2 + U Gamma_2.
    """
    beta, psi_dot = x_p[0::2], x_p[1::2]
    first = beta[0] - beta[1] - (p.l_c1 * psi_dot[0] + p.l_c21 * psi_dot[1]) / U
    return np.array([first, first + beta[1] - beta[2] - (p.l_c22 * psi_dot[1] + p.l_c3 * psi_dot[2]) / U])


def force_along_tractor(p: BTrainYawPlane, U: float, x_p: Array, x_p_dot: Array, F_y: Array, delta_11: float) -> float:
    """The force [N], forward along the tractor, that adds to the longitudinal ones to give m dU/dt.

    Parameters
    ----------
    x_p, x_p_dot : Array
        beta_i [rad] and psi_dot_i [rad/s] of the units, (6,), and their rates.
    F_y : Array
        Side forces of the axles, (9,) [N], to the right.
    delta_11 : float
        Front steer angle [rad].
    """
    psi_dot, psi_ddot = x_p[1::2], x_p_dot[1::2]
    Gamma_2, Gamma_3 = articulations(p, U, x_p)
    tyres = -delta_11 * F_y[0] - Gamma_2 * np.sum(F_y[3:6]) - Gamma_3 * np.sum(F_y[6:9])
    inertia = (
        -(p.m1 + p.m2 + p.m3) * U * x_p[0] * psi_dot[0]
        + (p.m2 + p.m3) * p.l_c1 * psi_dot[0] ** 2
        + (p.m2 * p.l_c21 + p.m3 * (p.l_c21 + p.l_c22)) * (psi_dot[1] ** 2 + Gamma_2 * psi_ddot[1])
        + p.m3 * p.l_c3 * (psi_dot[2] ** 2 + Gamma_3 * psi_ddot[2])
    )
    force: float = tyres - inertia
    return force
