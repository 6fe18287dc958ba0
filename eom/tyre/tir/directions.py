"""Files of tyres that were measured in one direction: the other one has no coefficients."""

from collections.abc import Mapping
from typing import NamedTuple

from eom.tyre.mf.coefficients import Use
from eom.tyre.tir.leftovers import listed
from eom.tyre.tir.numbers import Place
from eom.tyre.tir.text import TirText, number


class Direction(NamedTuple):
    """The coefficients without which a direction has no force, and values with which the equations can be evaluated."""

    neutral: Mapping[str, float]
    force: tuple[str, str]
    other: Use


LONGITUDINAL = Direction({"PCX1": 1.0, "PDX1": 1.0, "PKX1": 1.0}, ("PDX1", "PKX1"), "lateral")
LATERAL = Direction({"PCY1": 1.0, "PDY1": 1.0, "PKY1": -1.0, "PKY2": 1.0}, ("PDY1", "PKY1"), "longitudinal")


def absent_direction(places: Mapping[str, Place], use: str) -> Direction | None:
    """The direction that a file has no coefficients for; None if it has both or none, or if USE_MODE needs it."""
    absent = [direction for direction in (LONGITUDINAL, LATERAL) if is_absent(direction, places)]
    return absent[0] if len(absent) == 1 and use in {absent[0].other, "uncombined", "combined"} else None


def is_absent(direction: Direction, places: Mapping[str, Place]) -> bool:
    """Whether no coefficient acts; a shape without a force does not if the force is said to be zero."""
    acting = {name for name in direction.neutral if name in places and acts(places[name])}
    return not acting.intersection(direction.force) and (not acting or places.keys() >= set(direction.force))


def acts(place: Place) -> bool:
    """Whether any entry says something other than zero."""
    return any(not entry.blank and number(entry.value) != 0 for entry in place[0])


def note_absent(text: TirText, direction: Direction, names: list[str]) -> None:
    """Note that a tyre has forces of one direction only, as *names* say nothing."""
    section = "LATERAL_COEFFICIENTS" if direction is LATERAL else "LONGITUDINAL_COEFFICIENTS"
    missing = "longitudinal" if direction is LONGITUDINAL else "lateral"
    values = listed(f"{name} = {direction.neutral[name]:g}" for name in names)
    what = f"use = {direction.other!r}: the tyre has no {missing} force, as {listed(names)} are missing or zero"
    text.note((text.sections.get(section, 1), 1), section, f"{what}; taken in the equations: {values}")
