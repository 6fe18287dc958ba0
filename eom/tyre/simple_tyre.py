"""What the simple tyre models share: the load that they are for, trail, and rolling resistance."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.errors import TyreError
from eom.tyre.contact import rolling_sense, rolling_speed
from eom.tyre.interface import Tyre
from eom.tyre.parameters import Values, bound_problems, coefficient

LOW_TREAD_SPEED = 1.0
"""Speed of the tread [m/s] below which rolling resistance fades to zero at standstill."""


@dataclass(frozen=True, kw_only=True)
class SimpleTyre(Tyre):
    """Coefficients of a wheel with any simple tyre. Raises `TyreError` for numbers that cannot be."""

    nominal_load: Values = coefficient("load that the coefficients are for", "N", above=0.0)
    trail: Values = coefficient("pneumatic trail at small slip", "m", default=0.0)
    rolling_resistance: Values = coefficient("rolling resistance per load", default=0.0, at_least=0.0)
    radius: Values = coefficient("rolling radius", "m", default=0.0, at_least=0.0)

    def __post_init__(self) -> None:
        wrong = bound_problems(self)
        if not wrong and np.any((np.asarray(self.rolling_resistance) > 0.0) & (np.asarray(self.radius) == 0.0)):
            wrong.append(f"{type(self).__name__}: rolling_resistance without a radius: expected a rolling radius too")
        if wrong:
            raise TyreError("\n".join(wrong))


def resistance_moment(p: SimpleTyre, load: Values, kappa: Values, speed: Values) -> Any:
    """My [N m] of rolling resistance at a load [N]: against the wheel's rotation, through zero at standstill."""
    sense = rolling_sense(rolling_speed(kappa, speed, LOW_TREAD_SPEED), LOW_TREAD_SPEED)
    return -p.rolling_resistance * p.radius * load * sense


def trail_of(p: SimpleTyre, speed: Values) -> Any:
    """Pneumatic trail [m] at small slip: behind the wheel's centre, in reverse in front of it, none at standstill."""
    return p.trail * rolling_sense(speed, LOW_TREAD_SPEED)
