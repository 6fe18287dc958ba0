"""B-train double, linear with yaw and roll: thesis (3.21) to (3.25) and Appendix C. SAE axes.

Two variants. ``thesis`` is Appendix C with its misprints corrected: the matrices to test code against the thesis with.
``full`` keeps three kinds of terms that the thesis drops: the matrices to judge a multibody model with. They are

(i) the unsprung mass's roll acceleration in the lateral balance, m_u (h_u - h_r) phi_t_ddot;
(ii) the products of inertia of mass centres that are not at the whole-mass centre, m_s (a - a_s) (h_s - h_r) and the
unsprung counterpart, with I_uxz in the yaw balance;
(iii) the slip of the tyres' contact points as they swing about the roll axis, -h_r phi_t_dot / U.

In both, each unit carries its own weight and the couplings transmit horizontal force and roll moment only. A train
whose couplings carry weight has one more term in roll, the load of the coupling times its height, and is another model.
"""

from typing import Literal, NamedTuple

import numpy as np

from eom.closed_form.arrays import Array, matrix, solve
from eom.closed_form.b_train_roll_balance import INPUTS, STATES, balances, coupling_twist, row, units
from eom.closed_form.b_train_roll_parameters import BTrainYawRoll
from eom.closed_form.parameters import check_speed
from eom.closed_form.state_space import StateSpace
from eom.errors import EomError

Variant = Literal["thesis", "full"]
OUTPUTS = ("a_y_1", "a_y_2", "a_y_3", "phi_1", "phi_t_1", "phi_2", "phi_t_2", "phi_3", "phi_t_3")
YAW_RATES = ("psi_dot_1", "psi_dot_2", "psi_dot_3")
OUTPUTS_CG = ("a_y_cg_1", "a_y_cg_2", "a_y_cg_3")


class Matrices(NamedTuple):
    """M dx/dt + N x + Q delta_11 + R M_x + W M_z = 0; shapes (18, 18), (18, 18), (18, 1), (18, 4), (18, 2).

    M_x are the roll moments M_x1f, M_x1r, M_x2, M_x3, on the sprung masses and reversed on the unsprung ones; M_z the
    yaw moments M_z2, M_z3. Damping stands in M, as it multiplies the rates of the roll angles.
    """

    M: Array
    N: Array
    Q: Array
    R: Array
    W: Array


class System(NamedTuple):
    """dx/dt = A x + B_dd delta_11 + B u, y = C x + D_dd delta_11 + D u, (3.25), with u = M_z2, M_z3 and the four M_x.

    A (18, 18), B (18, 6), B_dd (18, 1), C (9, 18), D (9, 6), D_dd (9, 1). The accelerations in C are those of the
    points of the roll axes below the whole-mass centres, as in the thesis; C_cg (3, 18), D_cg (3, 6) and D_dd_cg (3, 1)
    give those of the whole-mass centres themselves.
    """

    A: Array
    B: Array
    B_dd: Array
    C: Array
    D: Array
    D_dd: Array
    C_cg: Array
    D_cg: Array
    D_dd_cg: Array


def matrices(p: BTrainYawRoll, U: float, variant: Variant = "full") -> Matrices:
    """M, N, Q, R and W of thesis Appendix C.

    Parameters
    ----------
    p : BTrainYawRoll
        Numbers or symbols.
    U : float
        Forward speed [m/s], or a symbol.
    variant : {"full", "thesis"}
        With or without the terms that the thesis drops.

    Returns
    -------
    Matrices
        For the states of (3.12): phi, phi_dot, beta, psi_dot of each unit, then phi_t, phi_t_dot of each; radians and
        seconds, SAE axes. beta_i is V_i / U at the point of the roll axis below the whole-mass centre.

    Raises
    ------
    EomError
        If U is a number that is not positive, or the variant is unknown.
    """
    check_speed(U)
    if variant not in ("thesis", "full"):
        raise EomError(f"variant: expected 'thesis' or 'full', got {variant!r}")
    one, two, three = (balances(unit, i, U, p.g, full=variant == "full") for i, unit in enumerate(units(p, U), start=1))
    roll_1 = one.roll + coupling_twist(1, 2, p.K_12)
    roll_2 = two.roll + coupling_twist(2, 1, p.K_12) + coupling_twist(2, 3, p.K_23)
    roll_3 = three.roll + coupling_twist(3, 2, p.K_23)
    # The coupling forces F_cy1 and F_cy2 are the lateral balances of the first and, reversed, of the last unit.
    rows = [
        -(one.yaw + p.l_c1 * one.lateral),
        roll_1 - p.h_cr1 * one.lateral,
        -one.tyre_roll,
        one.lateral + two.lateral + three.lateral,
        two.yaw + p.l_c21 * one.lateral - p.l_c22 * three.lateral,
        roll_2 + p.h_cr2 * (one.lateral + three.lateral),
        -two.tyre_roll,
        -(three.yaw - p.l_c3 * three.lateral),
        roll_3 - p.h_cr3 * three.lateral,
        three.tyre_roll,
        *couplings(p, U),
        *(row({f"d {roll}_{i}": 1, f"{roll}_dot_{i}": -1}) for roll in ("phi", "phi_t") for i in (1, 2, 3)),
    ]
    M, N, Q, W, R = np.split(matrix(rows), np.cumsum([len(STATES), len(STATES), 1, 2]), axis=1)
    return Matrices(M, N, Q, R, W)


def couplings(p: BTrainYawRoll, U: float) -> tuple[Array, Array]:
    """Equal lateral accelerations of both units at each coupling, (3.18a) and (3.18b) times U."""
    ahead = ((1, p.h_cr1, p.l_c1), (2, p.h_cr2, p.l_c22))
    behind = ((2, p.h_cr2, p.l_c21), (3, p.h_cr3, p.l_c3))
    first, second = (
        row({f"d phi_dot_{i}": h, f"d beta_{i}": U, f"d psi_dot_{i}": -back, f"psi_dot_{i}": U})
        - row({f"d phi_dot_{j}": k, f"d beta_{j}": U, f"d psi_dot_{j}": forward, f"psi_dot_{j}": U})
        for (i, h, back), (j, k, forward) in zip(ahead, behind, strict=True)
    )
    return first, second


def system(p: BTrainYawRoll, U: float, variant: Variant = "full") -> System:
    """A, B, B_dd and the output matrices of thesis (3.25), in numbers.

    Raises
    ------
    EomError
        If U is not positive, the variant unknown, a value a symbol, or M singular.
    """
    M, N, Q, R, W = matrices(p, U, variant)
    A = -solve(M, N, "M")
    B_dd, B = -solve(M, Q, "M"), -solve(M, np.hstack([W, R]), "M")
    S, P = (np.eye(len(STATES))[[STATES.index(name) for name in names]] for names in (YAW_RATES, OUTPUTS[3:]))
    G, H = acceleration_rows(p, U, centre=False), acceleration_rows(p, U, centre=True)
    return System(
        A=A,
        B=B,
        B_dd=B_dd,
        C=np.vstack([G @ A + U * S, P]),
        D=np.vstack([G @ B, np.zeros((6, B.shape[1]))]),
        D_dd=np.vstack([G @ B_dd, np.zeros((6, 1))]),
        C_cg=H @ A + U * S,
        D_cg=H @ B,
        D_dd_cg=H @ B_dd,
    )


def acceleration_rows(p: BTrainYawRoll, U: float, *, centre: bool) -> Array:
    """Rows (3, 18) that give, from dx/dt, each unit's lateral acceleration [m/s^2] less U psi_dot.

    Of the roll axis below the whole-mass centre, or of the *centre* itself, which the sprung and unsprung masses carry
    along as they roll: [m_s (h_s - h_r) phi_ddot + m_u (h_u - h_r) phi_t_ddot] / m more.
    """
    rows = np.zeros((3, len(STATES)))
    for i, unit in enumerate(units(p, U), start=1):
        rows[i - 1, STATES.index(f"beta_{i}")] = U
        if centre:
            rows[i - 1, STATES.index(f"phi_dot_{i}")] = unit.m_s * unit.e_s / unit.m
            rows[i - 1, STATES.index(f"phi_t_dot_{i}")] = unit.m_u * unit.e_u / unit.m
    return rows


def state_space(p: BTrainYawRoll, U: float, variant: Variant = "full") -> StateSpace:
    """The same as one named state space: B = [B_dd B], the outputs of (3.25) and then the accelerations of the centres.

    Accelerations [m/s^2] are to the right, roll angles [rad] right side down. Errors as `system`.
    """
    s = system(p, U, variant)
    return StateSpace(
        A=s.A,
        B=np.hstack([s.B_dd, s.B]),
        C=np.vstack([s.C, s.C_cg]),
        D=np.block([[s.D_dd, s.D], [s.D_dd_cg, s.D_cg]]),
        states=STATES,
        inputs=INPUTS,
        outputs=(*OUTPUTS, *OUTPUTS_CG),
    )
