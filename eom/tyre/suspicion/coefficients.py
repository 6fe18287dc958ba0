"""Suspicions about single coefficients of the Magic Formula 6.1 and 5.2."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from eom.tyre.mf.coefficients import MagicFormula61
from eom.tyre.mf.scaling import Scaling52, Scaling61
from eom.tyre.parameters import coefficients
from eom.tyre.suspicion.words import Rule, corners, drives, told
from eom.tyre.usual_range import range_of

PRESSURE = 0.3
"""Relative distance from the nominal pressure over which pressure terms are measured."""
USEFUL_LOAD, USEFUL_ALPHA, USEFUL_KAPPA = 1.5, 0.1, 0.1
"""Least upper ends of a range: load over nominal load, slip angle [rad] and slip, where peaks begin."""


def kink(tyre: Any) -> Iterator[str]:
    """Terms with the absolute value of camber."""
    names = ["PKY3", "QBZ5", "QSX14"]
    if getattr(tyre, "form", "tool") == "book":
        names.append("QDZ3")
    if told_ones := [name for name in names if getattr(tyre, name, 0.0) != 0.0]:
        yield (
            f"{told(tyre, *told_ones)}: multiplies the absolute value of camber, so that slopes jump where camber is "
            "zero"
        )


def one_direction(tyre: Any) -> Iterator[str]:
    """A tyre in use for forces of one direction."""
    if tyre.use in {"longitudinal", "lateral"}:
        missing = "lateral" if tyre.use == "longitudinal" else "longitudinal"
        yield f"use = {tyre.use!r}: the tyre has no {missing} force"


def scaling(tyre: Any) -> Iterator[str]:
    """Factors by which the tyre is not the measured one."""
    kind = Scaling61 if isinstance(tyre, MagicFormula61) else Scaling52
    names = [item.name for item in coefficients(kind) if getattr(tyre, item.name) != item.default]
    if names:
        yield f"{told(tyre, *names)}: scaling factors make this another tyre than the measured one"


def pressure(tyre: Any) -> Iterator[str]:
    """Inflation beyond what was measured."""
    if not isinstance(tyre, MagicFormula61):
        return
    share = np.asarray(tyre.INFLPRES / tyre.NOMPRES)
    if abs(share - 1.0) > PRESSURE:
        yield (
            f"INFLPRES = {tyre.INFLPRES:g} Pa is {share:.2f} of NOMPRES = {tyre.NOMPRES:g} Pa; "
            f"expected {1.0 - PRESSURE:g} to {1.0 + PRESSURE:g}"
        )
    elif not tyre.PRESMIN <= tyre.INFLPRES <= tyre.PRESMAX:
        yield (
            f"INFLPRES = {tyre.INFLPRES:g} Pa is outside the range of measurement, {tyre.PRESMIN:g} to "
            f"{tyre.PRESMAX:g} Pa"
        )


def rolling_load(tyre: Any) -> Iterator[str]:
    """Rolling resistance that does not know the load."""
    if isinstance(tyre, MagicFormula61) and tyre.form == "tool" and tyre.QSY7 == 0.0 and tyre.QSY1 != 0.0:
        yield "QSY7 = 0: the rolling resistance moment is the same at every load; most tyres have 0.8 to 1"


def absent(tyre: Any) -> Iterator[str]:
    """Parts of the model without coefficients."""
    if drives(tyre) and not any(getattr(tyre, f"QSY{k}", 0.0) for k in range(1, 7)):
        yield "QSY1 = 0: the tyre has no rolling resistance"
    if corners(tyre) and tyre.QDZ1 == 0.0:
        yield "QDZ1 = 0: the tyre has no pneumatic trail and does not align itself"


def ranges(tyre: Any) -> Iterator[str]:
    """Ranges of measurement that end before the peaks."""
    nominal = range_of(tyre).nominal
    if USEFUL_LOAD * nominal > tyre.FZMAX:
        yield f"FZMAX = {tyre.FZMAX:g} N is {tyre.FZMAX / nominal:.2f} of FNOMIN; expected {USEFUL_LOAD:g} or more"
    if 0.5 * nominal < tyre.FZMIN:
        yield f"FZMIN = {tyre.FZMIN:g} N is {tyre.FZMIN / nominal:.2f} of FNOMIN; expected 0.5 or less"
    for name, least, unit, acts in (
        ("ALP", USEFUL_ALPHA, " rad", corners(tyre)),
        ("KPU", USEFUL_KAPPA, "", drives(tyre)),
    ):
        if acts and getattr(tyre, f"{name}MAX") < least:
            end = f"{name}MAX = {getattr(tyre, f'{name}MAX'):g}{unit}"
            yield f"{end} ends before the peak of the force; expected {least:g}{unit} or more"
        if acts and getattr(tyre, f"{name}MIN") > -least:
            end = f"{name}MIN = {getattr(tyre, f'{name}MIN'):g}{unit}"
            yield f"{end} ends before the peak of the force; expected {-least:g}{unit} or less"


COEFFICIENTS: tuple[Rule, ...] = (kink, one_direction, scaling, pressure, rolling_load, absent, ranges)
