"""Forces proportional to slip, whatever the load: the tyre of the linear vehicle models."""

from dataclasses import dataclass
from typing import Any

from eom.tyre.contact import contact, rolling_sense, rolling_speed
from eom.tyre.interface import REFERENCE_SPEED, Forces, Formula, evaluate
from eom.tyre.parameters import Values, check_bounds, coefficient

LOW_SPEED = 1.0
"""Speed of the tread [m/s] below which rolling resistance fades to zero at standstill."""


@dataclass(frozen=True, kw_only=True)
class Linear:
    """A linear tyre; its forces have no limit by friction. Raises `TyreError` for numbers that cannot be."""

    nominal_load: float = coefficient("load at which the stiffnesses hold", "N", above=0.0)
    cornering: float = coefficient("side force per slip angle", "N/rad", at_least=0.0)
    longitudinal: float = coefficient("longitudinal force per slip", "N", default=0.0, at_least=0.0)
    camber: float = coefficient("side force per camber angle", "N/rad", default=0.0, at_least=0.0)
    trail: float = coefficient("pneumatic trail", "m", default=0.0)
    rolling_resistance: float = coefficient("rolling resistance per load", default=0.0, at_least=0.0)
    radius: float = coefficient("rolling radius", "m", default=0.0, at_least=0.0)

    def __post_init__(self) -> None:
        check_bounds(self)

    @property
    def formula(self) -> Formula:
        """The equations."""
        return linear_forces

    def forces(
        self, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
    ) -> Forces:
        """Forces and moments, see `eom.tyre.Tyre.forces`."""
        return evaluate(self, alpha, kappa, Fz, gamma, speed)


def linear_forces(p: Linear, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of a linear tyre; camber thrust has no trail."""
    load, share = contact(Fz, p.nominal_load)
    slip_force = -share * p.cornering * alpha
    Fx = share * p.longitudinal * kappa
    Fy = slip_force - share * p.camber * gamma
    My = -p.rolling_resistance * p.radius * share * load * rolling_sense(rolling_speed(kappa, speed), LOW_SPEED)
    return Fx, Fy, 0.0 * Fy, My, -p.trail * slip_force
