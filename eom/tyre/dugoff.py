"""Dugoff's tyre: two stiffnesses and a friction circle.

Dugoff, Fancher, Segel: An Analysis of Tire Traction Properties and Their Influence on Vehicle Dynamic Performance,
SAE paper 700377, 1970; here with friction that does not fall with speed.
"""

from dataclasses import dataclass
from typing import Any

from eom.tyre.contact import contact, rolling_sense
from eom.tyre.elementary import maximum, minimum, sqrt, tan
from eom.tyre.interface import Formula
from eom.tyre.parameters import Values, coefficient
from eom.tyre.simple_tyre import LOW_TREAD_SPEED, SimpleTyre, resistance_moment, trail_of

LOCKING = 0.1
"""Width in slip of the passage from a braked wheel, 1 + kappa > 0, to one that turns backwards."""


@dataclass(frozen=True, kw_only=True)
class Dugoff(SimpleTyre):
    """Dugoff's tyre. Raises `TyreError` for numbers that cannot be."""

    cornering: Values = coefficient("side force per slip angle", "N/rad", above=0.0)
    longitudinal: Values = coefficient("longitudinal force per slip", "N", above=0.0)
    friction: Values = coefficient("friction coefficient of tyre and road", above=0.0)

    @property
    def formula(self) -> Formula:
        """The equations."""
        return dugoff_forces


def dugoff_forces(
    p: Dugoff,
    alpha: Values,
    kappa: Values,
    Fz: Values,
    gamma: Values,  # noqa: ARG001  no effect in this model
    speed: Values,
) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of Dugoff's tyre.

    Written for forward travel: with lambda = mu Fz (1 + kappa) / (2 R), R the resultant of the two linear forces, and
    m = min(lambda, 1), the forces are C kappa/(1 + kappa) and -C tan(alpha)/(1 + kappa), each times m (2 - m). The
    factor 1 + kappa is cancelled, so that a locked wheel is no special case. The trail falls with the share m (2 - m)
    that adheres.
    """
    load, share = contact(Fz, p.nominal_load)
    grip = p.friction * load
    drive, side = p.longitudinal * kappa, p.cornering * tan(alpha)
    # speed of the tread over speed of travel, or zero for a wheel that turns backwards: by a parabola between
    ratio = 1.0 + kappa * rolling_sense(speed, LOW_TREAD_SPEED)
    near = minimum(maximum(ratio, -LOCKING), LOCKING) + LOCKING
    roll = maximum(ratio - LOCKING, 0.0) + near * near / (4.0 * LOCKING)
    limit = maximum(grip * roll, 2.0 * sqrt(drive * drive + side * side))
    m = grip * roll / limit
    per_stiffness = share * grip * (2.0 - m) / limit
    Fx, Fy = per_stiffness * drive, -per_stiffness * side
    My = resistance_moment(p, share * load, kappa, speed)
    return Fx, Fy, 0.0 * Fy, My, -trail_of(p, speed) * m * (2.0 - m) * Fy
