"""Suspicions about sizes: what is out of all proportion for a tyre, mostly by wrong units or signs."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from eom.errors import TyreError
from eom.tyre.characteristics import characteristics
from eom.tyre.interface import Tyre
from eom.tyre.mf.coefficients import MagicFormula61
from eom.tyre.mf.relaxation import relaxation_lengths
from eom.tyre.slopes import slopes
from eom.tyre.suspicion.words import Rule, corners, drives, told
from eom.tyre.usual_range import range_of

STRAIGHT = 0.15
"""Force over load of a tyre that runs straight and upright; ply-steer and conicity give some hundredths."""
LOADS = (200.0, 200e3)
RADII = (0.1, 2.0)
RESISTANCE = 0.1
"""Rolling resistance over load; that of a tyre on a road is below 0.02."""
TRAIL = 0.5
"""Pneumatic trail over radius."""
CAMBER = 5.0
"""Camber stiffness over load [1/rad]; that of a motorcycle tyre is one, of a car's below two."""
OVERTURNING, ALIGNING = 0.5, 0.3
"""Moments over load and radius, at a slip angle and camber of 0.1 rad."""
CAMBER_LOSS = 0.5
RELAXATION = (0.01, 5.0)
BRAKING = np.linspace(-0.2, 0.0, 21)


def straight(tyre: Tyre) -> Iterator[str]:
    """Forces without slip."""
    nominal = range_of(tyre).nominal
    found = tyre.forces(0.0, 0.0, nominal)
    for name, force, names in (
        ("lateral", found.Fy, ("PHY1", "PVY1")),
        ("longitudinal", found.Fx, ("PHX1", "PVX1")),
    ):
        share = float(force) / nominal
        if abs(share) > STRAIGHT:
            yield (
                f"{told(tyre, *names)}: the {name} force is {share:.2g} of the load without any slip; expected less "
                f"than {STRAIGHT:g}"
            )


def size(tyre: Any) -> Iterator[str]:
    """Nominal load and radius of no wheel, as wrong units give them."""
    for name, value, (least, most), unit in (
        ("FNOMIN", tyre.FNOMIN, LOADS, "N"),
        ("UNLOADED_RADIUS", tyre.UNLOADED_RADIUS, RADII, "m"),
    ):
        if not least <= value <= most:
            yield f"{name} = {value:g} {unit}: expected {least:g} to {most:g} {unit}; do [UNITS] say what it is in?"


def rolling_share(tyre: Any) -> Iterator[str]:
    """Rolling resistance that would stop any vehicle, or that turns into drive under braking."""
    nominal = range_of(tyre).nominal
    share = -float(tyre.forces(0.0, 0.0, nominal).My) / (nominal * tyre.UNLOADED_RADIUS)
    if drives(tyre) and share > RESISTANCE:
        yield (
            f"{told(tyre, 'QSY1', 'QSY3', 'QSY4', 'LMY')}: rolling resistance is {share:.2g} of the load; expected "
            f"less than {RESISTANCE:g}"
        )
    elif share > 0.0 and np.any(np.asarray(tyre.forces(0.0, BRAKING, nominal).My) > 0.0):
        yield f"{told(tyre, 'QSY1', 'QSY2')}: the rolling resistance moment drives a braked wheel"


def trail_size(tyre: Any) -> Iterator[str]:
    """A trail that reaches far out of the contact."""
    found = float(characteristics(tyre, range_of(tyre).nominal).trail[0])
    if corners(tyre) and abs(found) > TRAIL * tyre.UNLOADED_RADIUS:
        yield (
            f"{told(tyre, 'QDZ1', 'QHZ1', 'LTR')}: the pneumatic trail is {found:.2g} m at nominal load; expected less "
            f"than {TRAIL:g} of the radius"
        )


def camber(tyre: Any) -> Iterator[str]:
    """Camber thrust of the wrong sign or size, or camber that takes the friction away."""
    where = range_of(tyre)
    share = -float(np.asarray(slopes(tyre, 0.0, 0.0, where.nominal).gamma.Fy)) / where.nominal
    names = ("PKY6", "PKY7", "LKYC") if isinstance(tyre, MagicFormula61) else ("PHY3", "PVY3", "LGAY")
    if corners(tyre) and not 0.0 <= share <= CAMBER:
        yield (
            f"{told(tyre, *names)}: camber stiffness over load is {share:.2g} 1/rad at nominal load; expected 0 to "
            f"{CAMBER:g}, by which a wheel is pushed where its top leans"
        )
    for name in ("PDY3", "PDX3"):
        loss = getattr(tyre, name) * where.gamma[1] ** 2
        if loss > CAMBER_LOSS:
            yield (
                f"{name} = {getattr(tyre, name):g}: camber of {where.gamma[1]:.2g} rad takes {loss:.0%} of the "
                f"friction; expected less than {CAMBER_LOSS:.0%}"
            )


def moments(tyre: Any) -> Iterator[str]:
    """Overturning and aligning moments with an arm of the size of the wheel."""
    nominal = range_of(tyre).nominal
    slips = np.array([-0.1, 0.0, 0.1])
    found = tyre.forces(slips[:, np.newaxis], 0.05, nominal, slips)
    for name, moment, most, names in (
        ("overturning", found.Mx, OVERTURNING, [f"QSX{k}" for k in range(1, 15)]),
        ("aligning", found.Mz, ALIGNING, ["QDZ1", "QDZ6", "QDZ8", "SSZ1", "SSZ2", "SSZ3"]),
    ):
        share = float(np.max(np.abs(moment))) / (nominal * tyre.UNLOADED_RADIUS)
        if share > most:
            told_ones = told(tyre, *(one for one in names if getattr(tyre, one, 0.0) != 0.0))
            yield (
                f"{told_ones}: the {name} moment reaches {share:.2g} of load times radius at slip angles and camber of "
                f"0.1 rad; expected less than {most:g}"
            )


def relaxation(tyre: Any) -> Iterator[str]:
    """Relaxation lengths that are not there, or not of a tyre."""
    try:
        lengths = relaxation_lengths(tyre, range_of(tyre).nominal)
    except TyreError as error:
        yield str(error)
        return
    for name, value, acts in (("longitudinal", lengths.kappa, drives(tyre)), ("lateral", lengths.alpha, corners(tyre))):
        if acts and not RELAXATION[0] <= float(value) <= RELAXATION[1]:
            yield (
                f"the {name} relaxation length is {float(value):.2g} m at nominal load; expected {RELAXATION[0]:g} to "
                f"{RELAXATION[1]:g} m"
            )


PROPORTIONS: tuple[Rule, ...] = (straight, size, rolling_share, trail_size, camber, moments, relaxation)
