"""Where a tyre is looked at: the range of its measurement, or what is usual."""

from typing import Any, NamedTuple

import numpy as np

Interval = tuple[float, float]

USUAL_LOAD = (0.25, 2.0)
"""Load over nominal load, where a tyre names no range."""
USUAL_ALPHA = 0.35
"""Slip angle [rad], 20 degrees: peaks of most tyres lie well inside."""
USUAL_KAPPA = 0.5
USUAL_GAMMA = 0.1
"""Camber angle [rad] of cars."""


class Range(NamedTuple):
    """Nominal load [N], and intervals of load [N], slip angle [rad], longitudinal slip and camber [rad]."""

    nominal: float
    Fz: Interval
    alpha: Interval
    kappa: Interval
    gamma: Interval


def range_of(tyre: Any) -> Range:
    """The range of a tyre of any model: that of its measurement as far as it is usual, else the usual one."""
    nominal = float(tyre.FNOMIN if hasattr(tyre, "FNOMIN") else tyre.nominal_load)
    load = (USUAL_LOAD[0] * nominal, USUAL_LOAD[1] * nominal)
    if not hasattr(tyre, "FNOMIN"):
        return Range(nominal, load, both(USUAL_ALPHA), both(USUAL_KAPPA), both(USUAL_GAMMA))
    return Range(
        nominal,
        within(load, (tyre.FZMIN, tyre.FZMAX)),
        within(both(USUAL_ALPHA), (tyre.ALPMIN, tyre.ALPMAX)),
        within(both(USUAL_KAPPA), (tyre.KPUMIN, tyre.KPUMAX)),
        within(both(USUAL_GAMMA), (tyre.CAMMIN, tyre.CAMMAX)),
    )


def both(end: float) -> Interval:
    """From -end to end."""
    return -end, end


def within(usual: Interval, measured: Interval) -> Interval:
    """What two intervals share; the measured one if they share nothing."""
    low, high = max(usual[0], measured[0]), min(usual[1], measured[1])
    return (float(low), float(high)) if low < high else (float(measured[0]), float(measured[1]))


def inside(values: "np.ndarray[Any, Any]", ends: Interval) -> "np.ndarray[Any, Any]":
    """The values within a range, or its ends if there are none."""
    found = values[(values >= ends[0]) & (values <= ends[1])]
    return found if found.size else np.array(ends)
