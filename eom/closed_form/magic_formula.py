"""The magic formula: thesis (3.10)."""

import numpy as np

from eom.closed_form.arrays import Array


def magic_formula(
    alpha: Array | float, B: Array | float, C: Array | float, D: Array | float, E: Array | float
) -> Array:
    """Side force D sin(C arctan(B alpha - E (B alpha - arctan(B alpha)))), thesis (3.10), after Pacejka.

    Parameters
    ----------
    alpha : Array or float
        Slip angle [rad], steer less direction of travel: alpha of (3.35), the negative of (3.3).
    B, C, D, E : Array or float
        Stiffness factor [1/rad], shape factor, peak force [N] and curvature factor, alike for all axles or one each.
        The slope at zero slip is B C D.

    Returns
    -------
    Array
        Side force, in the unit of D and of its sign: positive D pushes towards where the wheel points.
    """
    slip = np.asarray(B) * alpha
    return np.asarray(D * np.sin(C * np.arctan(slip - E * (slip - np.arctan(slip)))))
