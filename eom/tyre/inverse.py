"""The slip angle that gives a lateral force."""

from typing import NamedTuple

import numpy as np

from eom.errors import TyreError
from eom.tyre.branch import Array, branch, root
from eom.tyre.interface import REFERENCE_SPEED, Tyre, as_numbers
from eom.tyre.parameters import Values
from eom.tyre.slopes import slopes


class SlipAngle(NamedTuple):
    """Slip angle [rad] of a demanded lateral force, and whether the demand exceeds what the tyre has."""

    alpha: Array
    saturated: Array


def slip_angle_for(
    tyre: Tyre, Fy: Values, Fz: Values, kappa: Values = 0.0, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
) -> SlipAngle:
    """Slip angle at which a tyre gives a lateral force, on the branch between its two peaks.

    A demand beyond a peak gets the slip angle of that peak, whose force is the nearest possible, and is marked as
    saturated. A tyre whose force has no peak is followed up to a slip angle of 90 degrees. Where longitudinal slip is
    so large that the force grows with the slip angle, the result is zero, marked as saturated. All arguments are
    broadcast; the force of the result is the demand to within rounding.

    Parameters
    ----------
    tyre : Tyre
        One tyre, or a `eom.tyre.stack` of them.
    Fy : float or array
        Demanded lateral force [N].
    Fz, kappa, gamma, speed : float or array
        As of `Tyre.forces`.

    Raises
    ------
    TyreError
        If arguments are no finite numbers, do not fit together, or if the lateral force of the freely rolling tyre
        grows with the slip angle.

    Examples
    --------
    >>> from eom.tyre import Dugoff, slip_angle_for
    >>> tyre = Dugoff(nominal_load=4000.0, cornering=80e3, longitudinal=90e3, friction=0.9)
    >>> slip_angle_for(tyre, Fy=[-1500.0, 5000.0], Fz=4000.0)
    SlipAngle(alpha=array([ 0.0187478 , -1.57079633]), saturated=array([False,  True]))
    """
    demand = as_numbers("Fy", Fy)
    start = tyre.forces(0.0, kappa, Fz, gamma, speed).Fy
    try:
        shape = np.broadcast_shapes(demand.shape, np.shape(start))
    except ValueError:
        raise TyreError(f"Fy of shape {demand.shape}: expected one that fits {np.shape(start)}") from None

    def lateral(alpha: Array) -> Array:
        return np.asarray(tyre.forces(alpha, kappa, Fz, gamma, speed).Fy)

    if np.any(slopes(tyre, 0.0, 0.0, Fz, gamma, speed).alpha.Fy > 0.0):
        raise TyreError(
            "the lateral force grows with the slip angle: expected coefficients for ISO axes, in which it falls; "
            "turn the signs of coefficients that are for other axes"
        )
    way = branch(lateral, 0.5 * np.pi, np.shape(start))
    # a wheel that spins or locks may have no branch on which its lateral force resists the slip angle
    ends = [np.broadcast_to(np.where(way.rises, 0.0, end), shape) for end in way.ends]
    most, least = (lateral(end) for end in ends)
    saturated = (demand < least) | (demand > most) | way.rises
    inside = root(lambda alpha: lateral(alpha) - demand, ends[0], ends[1])
    nearest = np.where(most - demand < demand - least, *ends)
    # within rounding of a peak the search may see no change of sign
    return SlipAngle(np.where(saturated | np.isnan(inside), nearest, inside), saturated)
