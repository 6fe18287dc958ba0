"""The ends of a tyre's range: lift-off, standstill, reversal; once continuously differentiable at each."""

from typing import Any

import numpy as np

from eom.tyre.elementary import maximum, minimum
from eom.tyre.parameters import Values

LIFT = 0.01
"""Share of the nominal load below which contact fades; no tyre is measured there."""


def kept_above(value: Values, low: Values) -> Any:
    """A value above a low one; below, down to zero, a parabola from half of that, once continuously differentiable."""
    x = minimum(value / low, 1.0)
    return maximum(value, 0.5 * low * (1.0 + x * x))


def contact(Fz: Values, nominal: Values) -> tuple[Any, Any]:
    """Load at which to evaluate a formula, and the share of its result that acts.

    Above `LIFT` of the nominal load [N] the load is Fz and the share one. Below, the load goes to half of that
    bound, so that ratios of stiffness and friction stay defined, and the share to zero at lift-off; their product
    stays below Fz. Both have continuous first derivatives in Fz.
    """
    low = LIFT * nominal
    x = minimum(maximum(Fz / low, 0.0), 1.0)
    square = x * x
    return maximum(Fz, 0.5 * low * (1.0 + square)), square * (3.0 - 2.0 * x)


def rolling_sense(v: Values, low_speed: Values) -> Any:
    """Direction of rolling: the sign of a speed v, by a cubic through zero below the low speed [both m/s]."""
    x = minimum(maximum(v / low_speed, -1.0), 1.0)
    return x * (1.5 - 0.5 * x * x)


def rolling_speed(kappa: Values, speed: Values, low_speed: Values) -> Any:
    """Speed of the tread omega R_e [m/s] that belongs to a slip at a forward speed, as `eom.tyre.slips` defines it."""
    return speed + kappa * kept_above(np.abs(speed), low_speed)
