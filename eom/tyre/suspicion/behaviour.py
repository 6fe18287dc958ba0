"""Suspicions about what any tyre does: directions, stiffnesses, friction, trail, rolling resistance."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from eom.tyre.branch import Array, Curve, branch
from eom.tyre.characteristics import characteristics
from eom.tyre.interface import Tyre
from eom.tyre.linear import Linear
from eom.tyre.slopes import slopes
from eom.tyre.suspicion.words import Rule, corners, drives, told
from eom.tyre.usual_range import range_of

CORNERING = ("PKY1", "PKY2", "LKY", "k_y", "cornering")
LONGITUDINAL = ("PKX1", "PKX2", "PKX3", "LKX", "k_x", "longitudinal")
SIDE = ("PDY1", "PDY2", "LMUY", "mu_y", "mu_y_load", "friction")
DRIVE = ("PDX1", "PDX2", "LMUX", "mu_x", "mu_x_load", "friction")

PLAUSIBLE_CORNERING = (3.0, 40.0)
"""Cornering stiffness over load [1/rad]: heavy truck tyres have 5, racing tyres 35."""
PLAUSIBLE_LONGITUDINAL = (3.0, 80.0)
PLAUSIBLE_FRICTION = (0.2, 2.0)
"""From ice to racing slicks on dry asphalt."""


def cornering_stiffness(tyre: Tyre) -> Iterator[str]:
    """Of the wrong sign, or far from that of any tyre."""
    nominal = range_of(tyre).nominal
    share = -float(np.asarray(slopes(tyre, 0.0, 0.0, nominal).alpha.Fy)) / nominal
    # shifts can put zero slip beyond a peak: the direction of the whole branch tells
    way = branch(lambda alpha: np.asarray(tyre.forces(alpha, 0.0, nominal).Fy), 0.5 * np.pi, ())
    if bool(way.rises) and corners(tyre):
        yield (
            f"{told(tyre, *CORNERING)}: the lateral force grows with the slip angle; ISO files have a negative PKY1, "
            "this one seems to be for other axes"
        )
    elif corners(tyre):
        yield from outside(
            share + 0.0, PLAUSIBLE_CORNERING, f"{told(tyre, *CORNERING)}: cornering stiffness over load", "1/rad"
        )


def slip_stiffness(tyre: Tyre) -> Iterator[str]:
    """Of the wrong sign, or far from that of any tyre."""
    nominal = range_of(tyre).nominal
    share = float(np.asarray(slopes(tyre, 0.0, 0.0, nominal).kappa.Fx)) / nominal
    if drives(tyre):
        yield from outside(share, PLAUSIBLE_LONGITUDINAL, f"{told(tyre, *LONGITUDINAL)}: slip stiffness over load")


def outside(value: float, plausible: tuple[float, float], what: str, unit: str = "") -> Iterator[str]:
    """A sentence for a value at nominal load that is not plausible."""
    low, high = plausible
    if not low <= value <= high:
        yield f"{what} is {value:.3g}{f' {unit}' if unit else ''} at nominal load; expected {low:g} to {high:g}"


def stiffness_over_load(tyre: Tyre) -> Iterator[str]:
    """One that changes its sign within the range of load."""
    where = range_of(tyre)
    loads = np.linspace(*where.Fz, 61)
    slope = slopes(tyre, 0.0, 0.0, loads)
    for acts, name, coefficient, stiffness in (
        (
            corners(tyre),
            "cornering stiffness",
            ("PKY1", "PKY2", "PKY4", "k_y", "k_y_load", "k_y_load2"),
            slope.alpha.Fy,
        ),
        (drives(tyre), "slip stiffness", ("PKX1", "PKX2", "k_x", "k_x_load", "k_x_load2"), slope.kappa.Fx),
    ):
        sign = np.sign(np.asarray(stiffness))
        if acts and np.any(turned := sign != sign[np.argmin(np.abs(loads - where.nominal))]):
            first, last = loads[turned][[0, -1]]
            yield f"{told(tyre, *coefficient)}: the {name} has another sign at loads from {first:.0f} to {last:.0f} N"


def friction(tyre: Tyre) -> Iterator[str]:
    """Outside what roads and rubber have, anywhere in the range of load."""
    if isinstance(tyre, Linear):
        return
    where = range_of(tyre)
    loads = np.linspace(*where.Fz, 13)
    curves: tuple[tuple[bool, str, tuple[str, ...], Curve, float], ...] = (
        (drives(tyre), "longitudinal", DRIVE, lambda kappa: np.asarray(tyre.forces(0.0, kappa, loads).Fx), 1.0),
        (corners(tyre), "lateral", SIDE, lambda alpha: np.asarray(tyre.forces(alpha, 0.0, loads).Fy), 0.5 * np.pi),
    )
    for acts, name, coefficient, curve, end in curves:
        reach = reach_of(curve, end, loads)
        odd = (reach < PLAUSIBLE_FRICTION[0]) | (reach > PLAUSIBLE_FRICTION[1])
        if acts and np.any(odd):
            k = int(np.argmax(np.where(odd, np.abs(np.log(np.maximum(reach, 1e-9))), -1.0)))
            yield (
                f"{told(tyre, *coefficient)}: the {name} force reaches {reach[k]:.3g} of the load at {loads[k]:.0f} N; "
                f"expected {PLAUSIBLE_FRICTION[0]:g} to {PLAUSIBLE_FRICTION[1]:g}"
            )


def reach_of(curve: Curve, end: float, loads: Array) -> Array:
    """Largest force over load on the branch around straight running."""
    return np.asarray(np.max(np.abs(curve(branch(curve, end, loads.shape).ends)), axis=0) / loads)


def trail(tyre: Tyre) -> Iterator[str]:
    """One that lies in front of the contact: the aligning moment steers away."""
    found = float(characteristics(tyre, range_of(tyre).nominal).trail[0])
    if found < 0.0 and corners(tyre):
        yield (
            f"{told(tyre, 'QDZ1', 'LTR', 'trail')}: the pneumatic trail is {1e3 * found:.3g} mm at nominal load; "
            "expected a positive one, by which the wheel aligns itself"
        )


def rolling(tyre: Any) -> Iterator[str]:
    """Resistance that drives a wheel which rolls freely and straight."""
    My = float(tyre.forces(0.0, 0.0, range_of(tyre).nominal).My)
    if My > 0.0:
        yield (
            f"{told(tyre, 'QSY1', 'QSY3', 'QSY4', 'LMY')}: the rolling resistance moment is {My:.3g} N m at nominal "
            "load and drives the wheel; expected a positive QSY1"
        )


BEHAVIOUR: tuple[Rule, ...] = (cornering_stiffness, slip_stiffness, stiffness_over_load, friction, trail, rolling)
