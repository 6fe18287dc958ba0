"""Suspicions about the shape of the Magic Formula's curves: factors B, C and E."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from eom.tyre.branch import Array
from eom.tyre.suspicion.words import Rule, told
from eom.tyre.usual_range import range_of

PLAUSIBLE_SHAPE = (0.5, 2.5)
"""C: below one a force has no peak, near two it falls to nothing at large slip."""

Curvature = Callable[[Any, Array, Array, float], Any]
"""Tyre, relative change of load, camber and sign of slip to a factor E."""


def of_Fx(p: Any, f: Array, gamma: Array, sign: float) -> Any:
    """E_x."""
    del gamma
    return (p.PEX1 + f * (p.PEX2 + p.PEX3 * f)) * (1.0 - p.PEX4 * sign) * p.LEX


def of_Fy(p: Any, f: Array, gamma: Array, sign: float) -> Any:
    """E_y; version 5.2 scales camber and has no term with its square."""
    lean = getattr(p, "LGAY", 1.0) * gamma
    even = 1.0 + getattr(p, "PEY5", 0.0) * lean**2
    return (p.PEY1 + p.PEY2 * f) * (even - (p.PEY3 + p.PEY4 * lean) * sign) * p.LEY


def of_trail(p: Any, f: Array, gamma: Array, sign: float) -> Any:
    """E_t at large slip, where its arctangent is at its end."""
    lean = getattr(p, "LGAZ", 1.0) * gamma
    return (p.QEZ1 + f * (p.QEZ2 + p.QEZ3 * f)) * (1.0 + (p.QEZ4 + p.QEZ5 * lean) * sign)


def of_x_weight(p: Any, f: Array, gamma: Array, sign: float) -> Any:
    """E of the weighting of the longitudinal force."""
    return p.REX1 + p.REX2 * f + 0.0 * gamma * sign


def of_y_weight(p: Any, f: Array, gamma: Array, sign: float) -> Any:
    """E of the weighting of the lateral force."""
    return p.REY1 + p.REY2 * f + 0.0 * gamma * sign


MAGIC: tuple[tuple[str, Curvature, tuple[str, ...]], ...] = (
    ("longitudinal force", of_Fx, ("PEX1", "PEX2", "PEX3", "PEX4", "LEX")),
    ("lateral force", of_Fy, ("PEY1", "PEY2", "PEY3", "PEY4", "PEY5", "LEY")),
    ("pneumatic trail", of_trail, ("QEZ1", "QEZ2", "QEZ3", "QEZ4", "QEZ5")),
    ("weighting of the longitudinal force", of_x_weight, ("REX1", "REX2")),
    ("weighting of the lateral force", of_y_weight, ("REY1", "REY2")),
)
THESIS: tuple[tuple[str, Curvature, tuple[str, ...]], ...] = (
    ("longitudinal force", lambda p, f, *_: p.E_x + p.E_x_load * f, ("E_x", "E_x_load")),
    ("lateral force", lambda p, f, *_: p.E_y + p.E_y_load * f, ("E_y", "E_y_load")),
)


def curvature(tyre: Any) -> Iterator[str]:
    """E above one anywhere in the range of load and camber."""
    where = range_of(tyre)
    loads, lean = np.meshgrid(np.linspace(*where.Fz, 61), np.linspace(*where.gamma, 21), indexing="ij")
    f = loads / (where.nominal * getattr(tyre, "LFZO", 1.0)) - 1.0
    for name, factor, names in MAGIC if hasattr(tyre, "FNOMIN") else THESIS:
        E = np.maximum(*(np.broadcast_to(factor(tyre, f, lean, sign), f.shape) for sign in (1.0, -1.0)))
        over = loads[E > 1.0]
        if over.size:
            yield (
                f"{told(tyre, *names)}: the curvature factor E of the {name} is above 1 at loads from {over.min():.0f} "
                f"to {over.max():.0f} N, up to {E.max():.3g}; the curve turns over at large slip"
            )


def shape(tyre: Any) -> Iterator[str]:
    """C that no tyre has."""
    low, high = PLAUSIBLE_SHAPE
    for name, factor in (("PCX1", "LCX"), ("PCY1", "LCY")):
        C = getattr(tyre, name) * getattr(tyre, factor)
        if not low <= C <= high:
            yield f"{told(tyre, name, factor)}: shape factor C is {C:.3g}; expected {low:g} to {high:g}"
    if tyre.QDZ1 != 0.0 and not low <= tyre.QCZ1 <= high:
        yield f"{told(tyre, 'QCZ1')}: shape factor C of the pneumatic trail; expected {low:g} to {high:g}"


def thesis_shape(tyre: Any) -> Iterator[str]:
    """C that no tyre has, at any load of the range."""
    low, high = PLAUSIBLE_SHAPE
    where = range_of(tyre)
    f = np.linspace(*where.Fz, 61) / where.nominal - 1.0
    for name in ("C_x", "C_y"):
        C = getattr(tyre, name) + getattr(tyre, f"{name}_load") * f
        if C.min() < low or C.max() > high:
            yield (
                f"{told(tyre, name, f'{name}_load')}: shape factor C runs from {C.min():.3g} to {C.max():.3g} over the "
                f"range of load; expected {low:g} to {high:g}"
            )


def trail_slope(tyre: Any) -> Iterator[str]:
    """B of the trail of the wrong sign: the trail grows with load where it has to fall with slip."""
    where = range_of(tyre)
    loads = np.linspace(*where.Fz, 61)
    f = loads / (where.nominal * tyre.LFZO) - 1.0
    B = tyre.QBZ1 + f * (tyre.QBZ2 + tyre.QBZ3 * f)
    if tyre.QBZ1 > 0.0 and np.any(B <= 0.0):
        first, last = loads[B <= 0.0][[0, -1]]
        yield (
            f"{told(tyre, 'QBZ1', 'QBZ2', 'QBZ3')}: stiffness factor B of the pneumatic trail is not positive at loads "
            f"from {first:.0f} to {last:.0f} N"
        )


MAGIC_CURVES: tuple[Rule, ...] = (curvature, shape, trail_slope)
THESIS_CURVES: tuple[Rule, ...] = (curvature, thesis_shape)
