"""Slip of a wheel: the definitions, in one place."""

from typing import Any

import numpy as np

from eom.errors import TyreError
from eom.tyre.contact import kept_above
from eom.tyre.parameters import Values


def slips(
    v_x: Values, v_y: Values, omega: Values, radius: Values, low_speed: float = 1.0
) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Slip angle and longitudinal slip of a wheel, ISO 8855.

    tan(alpha) = v_y / |v_x| and kappa = (omega R - v_x) / |v_x|. Below the low speed |v_x| is replaced by
    (v_x^2 / low + low) / 2, which has the same value and slope there, so that slips stay finite and once
    continuously differentiable through standstill and reversal: a standing tyre resists like a damper.

    Parameters
    ----------
    v_x, v_y : float or array
        Velocity of the wheel at the contact [m/s], along the wheel plane and to the left.
    omega : float or array
        Speed of rotation [rad/s], positive when rolling forward.
    radius : float or array
        Effective rolling radius [m].
    low_speed : float
        Speed [m/s] below which the definition is bent: the VXLOW of a Magic Formula tyre, 1 m/s for the others.

    Returns
    -------
    alpha, kappa : array
        Slip angle [rad] and longitudinal slip.

    Raises
    ------
    TyreError
        If the low speed is not larger than zero.

    Examples
    --------
    >>> alpha, kappa = slips(v_x=20.0, v_y=1.0, omega=66.0, radius=0.3)
    >>> print(f"{alpha:.4f} rad, {kappa:.4f}")
    0.0500 rad, -0.0100
    """
    if not low_speed > 0.0:
        raise TyreError(f"low_speed = {low_speed}: expected more than 0 m/s")
    forward = np.asarray(v_x, dtype=float)
    speed = kept_above(np.abs(forward), low_speed)
    return np.arctan(np.asarray(v_y) / speed), (np.asarray(omega) * radius - forward) / speed


def thesis_slip(kappa: Values) -> np.ndarray[Any, Any]:
    """The slip of Zhu's thesis (3.44) in forward travel: relative to omega R when driving, to U when braking."""
    slip = np.asarray(kappa)
    return np.where(slip > 0.0, slip / np.maximum(1.0 + slip, 1.0), slip)


def slip_of_thesis(sigma: Values) -> np.ndarray[Any, Any]:
    """Longitudinal slip kappa of a slip by (3.44) of Zhu's thesis; raises `TyreError` for one that reaches 1.

    >>> slip_of_thesis(thesis_slip([0.25, -0.25]))
    array([ 0.25, -0.25])
    """
    slip = np.asarray(sigma, dtype=float)
    if np.any(slip >= 1.0):
        raise TyreError(
            f"sigma = {np.max(slip):g}: expected less than 1, which stands for a wheel that spins on the spot"
        )
    return np.where(slip > 0.0, slip / (1.0 - slip), slip)
