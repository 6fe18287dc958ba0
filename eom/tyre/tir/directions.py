"""Files of tyres that were measured in one direction of slip alone."""

from collections.abc import Mapping
from typing import NamedTuple

from eom.tyre.mf.coefficients import Use
from eom.tyre.tir.text import Entry, TirText, number


class Direction(NamedTuple):
    """What a direction of slip cannot do without.

    Attributes
    ----------
    neutral : Mapping
        Those coefficients, with values for a tyre that has no forces in it.
    section : str
        Where they stand.
    other : Use
        The use that remains without them.
    alone : Use
        The use that needs them alone.
    """

    neutral: Mapping[str, float]
    section: str
    other: Use
    alone: Use


DIRECTIONS = (
    Direction({"PCX1": 1.0, "PDX1": 1.0, "PKX1": 1.0}, "LONGITUDINAL_COEFFICIENTS", "lateral", "longitudinal"),
    Direction({"PCY1": 1.0, "PDY1": 1.0, "PKY1": -1.0, "PKY2": 1.0}, "LATERAL_COEFFICIENTS", "longitudinal", "lateral"),
)


def missing_direction(text: TirText, said: Mapping[str, list[Entry]], use: str) -> tuple[dict[str, float], Use | None]:
    """Neutral coefficients of the one direction that a file has none of, with a note, and the use that remains.

    Nothing and None for a file that has both directions, or neither, or is for the use of the missing one.
    """
    empty = [item for item in DIRECTIONS if all(is_empty(said.get(name, [])) for name in item.neutral)]
    if len(empty) != 1 or use == empty[0].alone:
        return {}, None
    (direction,) = empty
    line = text.sections.get(direction.section, text.sections.get("MODEL", 1))
    names = ", ".join(direction.neutral)
    what = f"{names} are not given or 0: there are no {direction.alone} forces, read for {direction.other} use"
    text.note((line, 1), direction.section, what)
    return dict(direction.neutral), direction.other


def is_empty(entries: list[Entry]) -> bool:
    """Whether a coefficient is not in the file, or zero."""
    return all(number(entry.value) == 0 for entry in entries)
