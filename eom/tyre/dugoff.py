"""Dugoff's tyre: two stiffnesses and a friction circle.

Dugoff, Fancher, Segel: An Analysis of Tire Traction Properties and Their Influence on Vehicle Dynamic Performance,
SAE paper 700377, 1970; here with friction that does not fall with speed.
"""

from dataclasses import dataclass
from typing import Any

from eom.tyre.contact import contact, rolling_sense, rolling_speed
from eom.tyre.elementary import maximum, minimum, sqrt, tan
from eom.tyre.interface import REFERENCE_SPEED, Forces, Formula, evaluate
from eom.tyre.linear import LOW_SPEED
from eom.tyre.parameters import Values, check_bounds, coefficient

LOCKING = 0.1
"""Width in slip of the passage from a braked wheel, 1 + kappa > 0, to one that turns backwards."""


@dataclass(frozen=True, kw_only=True)
class Dugoff:
    """Dugoff's tyre. Raises `TyreError` for numbers that cannot be."""

    nominal_load: float = coefficient("load at which the stiffnesses hold", "N", above=0.0)
    cornering: float = coefficient("side force per slip angle", "N/rad", above=0.0)
    longitudinal: float = coefficient("longitudinal force per slip", "N", above=0.0)
    friction: float = coefficient("friction coefficient of tyre and road", above=0.0)
    trail: float = coefficient("pneumatic trail at small slip", "m", default=0.0)
    rolling_resistance: float = coefficient("rolling resistance per load", default=0.0, at_least=0.0)
    radius: float = coefficient("rolling radius", "m", default=0.0, at_least=0.0)

    def __post_init__(self) -> None:
        check_bounds(self)

    @property
    def formula(self) -> Formula:
        """The equations."""
        return dugoff_forces

    def forces(
        self, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
    ) -> Forces:
        """Forces and moments, see `eom.tyre.Tyre.forces`; camber has no effect."""
        return evaluate(self, alpha, kappa, Fz, gamma, speed)


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
    ratio = 1.0 + kappa * rolling_sense(speed, LOW_SPEED)
    near = minimum(maximum(ratio, -LOCKING), LOCKING) + LOCKING
    roll = maximum(ratio - LOCKING, 0.0) + near * near / (4.0 * LOCKING)
    limit = maximum(grip * roll, 2.0 * sqrt(drive * drive + side * side))
    m = grip * roll / limit
    per_stiffness = share * grip * (2.0 - m) / limit
    Fx, Fy = per_stiffness * drive, -per_stiffness * side
    My = -p.rolling_resistance * p.radius * share * load * rolling_sense(rolling_speed(kappa, speed), LOW_SPEED)
    return Fx, Fy, 0.0 * Fy, My, -p.trail * m * (2.0 - m) * Fy
