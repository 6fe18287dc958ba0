"""The B-train double as driver models see it, with its lateral positions: thesis (5.2), (5.3), Appendix G. SAE axes."""

from typing import NamedTuple

import numpy as np

from eom.closed_form import b_train_yaw_plane
from eom.closed_form.arrays import Array
from eom.closed_form.b_train_parameters import BTrainYawPlane

STATES = tuple(f"{name}_{unit}" for unit in (1, 2, 3) for name in ("Y", "psi", "v", "psi_dot"))
INPUTS = ("delta_11",)
OUTPUTS = ("Y_1", "Y_2", "Y_3")


class System(NamedTuple):
    """dx/dt = A_d x + B_d delta_11, y = C_d x, (5.2); shapes (12, 12), (12, 1), (3, 12)."""

    A_d: Array
    B_d: Array
    C_d: Array


def system(p: BTrainYawPlane, U: float) -> System:
    """A_d, B_d and C_d of the driver's vehicle at forward speed U [m/s].

    The states of each unit are Y [m], psi [rad], v = U beta [m/s] and psi_dot [rad/s], in SAE axes. Y_1 is the lateral
    position of the tractor's front axle, Y_2 and Y_3 those of the semitrailers' whole-mass centres, from the straight
    line Y = 0. v is the lateral velocity of the whole-mass centre in the unit's own axes.

    Rows of v and psi_dot are (3.29) with beta = v / U. Those of Y are (5.3), dY_1/dt = U psi_1 + v_1 + a11 psi_dot_1.
    The states hold the couplings twice: a start with `hitch_gaps` other than zero is a train torn apart.

    Raises
    ------
    EomError
        As `eom.closed_form.b_train_yaw_plane.system`.
    """
    A_p, _, C_p, _ = b_train_yaw_plane.system(p, U)
    scale = np.array([U, 1.0] * 3)
    moving = np.array([2, 3, 6, 7, 10, 11])
    A_d, B_d = np.zeros((12, 12)), np.zeros((12, 1))
    A_d[np.ix_(moving, moving)] = scale[:, np.newaxis] * A_p / scale
    B_d[moving] = scale[:, np.newaxis] * C_p
    for first in (0, 4, 8):
        A_d[first, first + 1 : first + 3] = U, 1.0
        A_d[first + 1, first + 3] = 1.0
    A_d[0, 3] = p.a11
    return System(A_d, B_d, np.eye(12)[[0, 4, 8]])


def hitch_gaps(p: BTrainYawPlane, U: float) -> Array:
    """Rows (4, 12) that give, from the states, by how much the units miss each other at the couplings.

    Two lateral distances [m] and two lateral velocities [m/s] of the unit ahead less the one behind. A train has zeros.
    `system` keeps the velocities as they are, and so the distances too if those are zero.
    """
    l_c1, l_c21, l_c22, l_c3 = p.l_c1, p.l_c21, p.l_c22, p.l_c3
    return np.array(
        [
            [1, -(p.a11 + l_c1), 0, 0, -1, -l_c21, 0, 0, 0, 0, 0, 0],
            [0, 0, 0, 0, 1, -l_c22, 0, 0, -1, -l_c3, 0, 0],
            [0, U, 1, -l_c1, 0, -U, -1, -l_c21, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, U, 1, -l_c22, 0, -U, -1, -l_c3],
        ]
    )
