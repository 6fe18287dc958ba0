"""Normal loads of the B-train's wheels by the thesis's formula (3.42), corrected. SAE axes.

The tandem and the tridems count as single axles at their middle. Corrections: the unsprung mass of the tractor lies
where its axles' masses put it (a_11u = 3.988 m, not the places of the sprung one), and the torque in a suspension
follows the roll of the sprung mass on the unsprung one, not on the ground.
"""

from typing import Literal, NamedTuple

import numpy as np

from eom.closed_form.arrays import Array
from eom.closed_form.b_train_roll_parameters import BTrainYawRoll

TRACKS = (1.98, 1.65, 1.65, 1.65)
"""Of the front axle, the tandem and both tridems [m]; Appendix B."""
A_11U = 3.98845
"""From the tractor's front axle back to its unsprung mass centre [m]."""


class Motion(NamedTuple):
    """What the loads follow, one entry per unit: accelerations [m/s^2], rolls [rad] and their rates [rad/s].

    Accelerations are of the whole-mass centres, to the right; rolls of sprung and unsprung masses, right side down.
    """

    a_x: Array = np.zeros(3)
    a_y: Array = np.zeros(3)
    phi: Array = np.zeros(3)
    phi_t: Array = np.zeros(3)
    dphi: Array = np.zeros(3)
    dphi_t: Array = np.zeros(3)


def wheel_loads(
    p: BTrainYawRoll, motion: Motion, *, lever: bool = False, transfer: Literal["thesis", "tyres"] = "thesis"
) -> Array:
    """Loads [N] of axles 1 to 9, left and right, (9, 2).

    With *lever* the second hitch's load acts where the hitch is, 1.07 m behind the middle of the tridem ahead; (3.42)
    puts all of it on that tridem. The *transfer* from left to right is that of (3.42), of lateral accelerations and the
    torques in the suspensions, or of the tyres' springs, K_t phi_t, which is what carries it.
    """
    front, groups, hitches = longitudinal(p, motion, lever=lever)
    del hitches
    totals = np.array([front, *groups])
    moments = moments_of_tyres(p, motion) if transfer == "tyres" else moments_of_thesis(p, motion)
    left_less_right = 2.0 * moments / np.array(TRACKS)
    sides = 0.5 * np.stack((totals + left_less_right, totals - left_less_right), axis=1)
    wheels = np.array([1, 2, 3, 3])
    return np.repeat(sides / wheels[:, np.newaxis], wheels, axis=0)


def longitudinal(p: BTrainYawRoll, motion: Motion, *, lever: bool) -> tuple[float, Array, Array]:
    """Loads [N] of the front axle, of tandem and tridems, and of the hitches on the units ahead."""
    a_x, g = motion.a_x, p.g
    h_1 = (p.m_s1 * p.h_s1 + p.m_u1 * p.h_u1) / p.m1
    h_2, h_3 = ((m_s * h_s + m_u * h_u) / m for m_s, h_s, m_u, h_u, m in trailers(p))
    b_1 = (p.b12 + p.b13) / 2.0
    L_1, L_2, L_3 = p.a11 + b_1, p.l_c21 + p.b25, p.l_c3 + p.b38
    W_2 = p.m3 * (p.b38 * g - h_3 * a_x[2]) / L_3
    share = (p.l_c21 + p.l_c22) / L_2 if lever else 1.0
    W_1 = p.m2 * (p.b25 * g - h_2 * a_x[1]) / L_2 + (1.0 - share) * W_2
    front = p.m1 * (b_1 * g - h_1 * a_x[0]) / L_1
    tandem = p.m1 * (p.a11 * g + h_1 * a_x[0]) / L_1 + W_1
    tridem_1 = p.m2 * (p.l_c21 * g + h_2 * a_x[1]) / L_2 + share * W_2
    tridem_2 = p.m3 * (p.l_c3 * g + h_3 * a_x[2]) / L_3
    return front, np.array([tandem, tridem_1, tridem_2]), np.array([W_1, W_2])


def trailers(p: BTrainYawRoll) -> tuple[tuple[float, float, float, float, float], ...]:
    """Sprung mass and its height, unsprung mass and its height, whole mass of both semitrailers."""
    return (p.m_s2, p.h_s2, p.m_u2, p.h_u2, p.m2), (p.m_s3, p.h_s3, p.m_u3, p.h_u3, p.m3)


def moments_of_thesis(p: BTrainYawRoll, motion: Motion) -> Array:
    """Moments [N m] that (3.42) gives to front axle, tandem and tridems, positive on the left wheels."""
    roll, rate = motion.phi - motion.phi_t, motion.dphi - motion.dphi_t
    b_1 = (p.b12 + p.b13) / 2.0
    L = p.a11 + b_1
    sprung, unsprung = p.m_s1 * p.h_r1 / L, p.m_u1 * p.h_u1 / L
    lateral = (
        sprung * (L - p.a11s) + unsprung * (L - A_11U),
        sprung * p.a11s + unsprung * A_11U,
        p.m_s2 * p.h_r2 + p.m_u2 * p.h_u2,
        p.m_s3 * p.h_r3 + p.m_u3 * p.h_u3,
    )
    stiffness, damping = (p.K_r1f, p.K_r1r, p.K_r2, p.K_r3), (p.L_r1f, p.L_r1r, p.L_r2, p.L_r3)
    unit = np.array([0, 0, 1, 2])
    torque = np.array(stiffness) * roll[unit] + np.array(damping) * rate[unit]
    return np.asarray(np.array(lateral) * motion.a_y[unit] - torque)


def moments_of_tyres(p: BTrainYawRoll, motion: Motion) -> Array:
    """Moments [N m] of the tyres' springs of front axle, tandem and tridems, positive on the left wheels."""
    stiffness = np.array((p.K_t1f, p.K_t1r, p.K_t2, p.K_t3))
    return np.asarray(-stiffness * motion.phi_t[[0, 0, 1, 2]])
