"""Brake pressures, wheel forces and yaw moments of the B-train: thesis (3.33), (3.36) and (3.37). SAE axes.

Pressures [Pa] are those of the semitrailers' wheels, (6, 2): axles 4 to 9, left and right.
"""

import numpy as np

from eom.closed_form.arrays import Array
from eom.closed_form.b_train_parameters import BTrainBraked
from eom.errors import EomError

NO_BRAKES = np.zeros((6, 2))
NO_BRAKES.setflags(write=False)


def checked_pressures(pressures: Array) -> Array:
    """The pressures as an array (6, 2) of numbers that are finite and not negative, else `EomError`."""
    P = np.asarray(pressures, dtype=float)
    if P.shape != (6, 2):
        raise EomError(f"brake pressures: expected shape (6, 2), axles 4 to 9 by left and right, got {P.shape}")
    possible = np.isfinite(P) & (P >= 0.0)
    bad = [f"axle {k + 4} {('left', 'right')[side]}: {P[k, side]:g} Pa" for k, side in np.argwhere(~possible)]
    if bad:
        raise EomError(f"brake pressures: expected finite numbers from zero on, got {', '.join(bad)}")
    return P


def longitudinal_forces(p: BTrainBraked, T_d: float, pressures: Array) -> Array:
    """Longitudinal force [N] of each wheel, (9, 2): axles 1 to 9, left and right; thesis (3.33).

    The drive torque *T_d* [N m] is shared by the four wheels of axles 2 and 3. (3.33a) prints half of it for each
    wheel, a quarter is what (3.34a) contains. Wheels have no inertia.

    Raises
    ------
    EomError
        If a pressure is negative or not finite, or there are not six by two.
    """
    torque = np.zeros((9, 2))
    torque[1:3] = T_d / 4.0
    torque[3:] -= p.K_b * checked_pressures(pressures)
    return np.asarray(torque / p.r_w)


def brake_moments(p: BTrainBraked, pressures: Array) -> Array:
    """Yaw moments (2,) [N m] of the brakes on the first and second semitrailer, clockwise from above: thesis (3.36).

    Raises
    ------
    EomError
        As `longitudinal_forces`.
    """
    P = checked_pressures(pressures)
    right_less_left = np.array([np.sum(P[:3, 1] - P[:3, 0]), np.sum(P[3:, 1] - P[3:, 0])])
    return np.asarray(np.array([p.d2, p.d3]) * p.K_b / (2.0 * p.r_w) * right_less_left)


def brake_pressures(p: BTrainBraked, M_z_2: float, M_z_3: float) -> Array:
    """Pressures (6, 2) that give the yaw moments [N m], alike on the three wheels of one side: thesis (3.37).

    A positive moment, clockwise from above, takes the right side, a negative one the left. Raises `EomError` for
    moments that are not finite.
    """
    if not np.all(np.isfinite([M_z_2, M_z_3])):
        raise EomError(f"yaw moments: expected finite numbers of N m, got {M_z_2:g} and {M_z_3:g}")
    P = np.zeros((6, 2))
    for group, moment, track in ((slice(0, 3), M_z_2, p.d2), (slice(3, 6), M_z_3, p.d3)):
        P[group, int(moment > 0.0)] = 2.0 * p.r_w * abs(moment) / (3.0 * track * p.K_b)
    return P
