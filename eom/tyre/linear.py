"""Forces proportional to slip, whatever the load: the tyre of the linear vehicle models."""

from dataclasses import dataclass
from typing import Any

from eom.tyre.contact import contact
from eom.tyre.interface import Formula
from eom.tyre.parameters import Values, coefficient
from eom.tyre.simple_tyre import SimpleTyre, resistance_moment, trail_of


@dataclass(frozen=True, kw_only=True)
class Linear(SimpleTyre):
    """A linear tyre; its forces have no limit by friction. Raises `TyreError` for numbers that cannot be."""

    cornering: Values = coefficient("side force per slip angle", "N/rad", at_least=0.0)
    longitudinal: Values = coefficient("longitudinal force per slip", "N", default=0.0, at_least=0.0)
    camber: Values = coefficient("side force per camber angle", "N/rad", default=0.0, at_least=0.0)

    @property
    def formula(self) -> Formula:
        """The equations."""
        return linear_forces


def linear_forces(p: Linear, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of a linear tyre; camber thrust has no trail."""
    load, share = contact(Fz, p.nominal_load)
    slip_force = -share * p.cornering * alpha
    Fx = share * p.longitudinal * kappa
    Fy = slip_force - share * p.camber * gamma
    return Fx, Fy, 0.0 * Fy, resistance_moment(p, share * load, kappa, speed), -trail_of(p, speed) * slip_force
