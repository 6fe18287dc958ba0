"""Entries of a .tir file to a tyre, with every mistake and everything worth knowing at its place."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from eom.errors import DescriptionError, Mistake
from eom.tyre.tir.directions import missing_direction
from eom.tyre.tir.keys import ALIASES, HEADERS, SECTION_OF, SECTIONS, Tyre, fields_of, is_coefficient, unit_of
from eom.tyre.tir.leftovers import listed, read_leftovers, read_rows
from eom.tyre.tir.model import KEYS, model_entries, read_model, read_version
from eom.tyre.tir.numbers import Place, check_missing, check_ranges, note_pressure, read_number
from eom.tyre.tir.text import Entry, TirText
from eom.tyre.tir.units import factor_of, read_units

MAX_MISTAKES = 100


@dataclass(frozen=True)
class Reading:
    """What a text was read as.

    Attributes
    ----------
    tyre : MagicFormula61 or MagicFormula52
        The tyre.
    notes : tuple of Mistake
        What is worth knowing and no mistake, in reading order.
    places : dict of str to Place
        Per coefficient where the text says it.
    """

    tyre: Tyre
    notes: tuple[Mistake, ...]
    places: Mapping[str, Place]


def read_tyre(text: TirText) -> Reading:
    """The tyre that the entries say; raises `DescriptionError` with every mistake."""
    said_of_model, units = model_entries(text), read_units(text)
    version = read_version(text, said_of_model)
    read_rows(text)
    if version is None:
        raise DescriptionError(first_of(text))
    model = read_model(text, said_of_model, version)
    said, leftovers = split(text, version)
    neutral, use = missing_direction(text, said, model.get("use", "combined"))
    if use is not None:
        model["use"] = use
    fields = fields_of(version)
    places = {
        name: (tuple(entries), factor_of(unit_of(fields[name]), units))
        for name, entries in said.items()
        if name not in neutral
    }
    found = {name: read_number(text, version, name, place) for name, place in places.items()}
    numbers: dict[str, Any] = neutral | {name: value for name, value in found.items() if value is not None}
    meant = read_leftovers(text, version, leftovers, said)
    check_missing(text, version, meant.union(said, neutral))
    check_ranges(text, version, numbers, places)
    note_pressure(text, version, numbers, places)
    note_book(text, numbers, places)
    if text.mistakes:
        raise DescriptionError(first_of(text))
    return Reading(version(**numbers, **model), tuple(sorted(set(text.notes))), places)


def split(text: TirText, version: type[Tyre]) -> tuple[dict[str, list[Entry]], list[Entry]]:
    """The entries of each coefficient, and all others that may bear on the tyre."""
    fields = fields_of(version)
    said: dict[str, list[Entry]] = {}
    leftovers, elsewhere, empty = [], [], []
    for entry in text.entries:
        name = ALIASES.get(entry.key, entry.key)
        if entry.section in HEADERS or entry.key in KEYS or entry.section == "UNITS":
            continue
        if name not in fields:
            leftovers.append(entry)
        elif not entry.value and not entry.quoted:
            empty.append(entry)
        elif entry.section in SECTIONS or name != entry.key:
            said.setdefault(name, []).append(entry)
            if name != entry.key:
                text.note_key(entry, f"read as {name}")
            elif entry.section != SECTION_OF[name]:
                elsewhere.append(entry)
        elif is_coefficient(name):
            what = f"stands in a section that is not known, expected in [{SECTION_OF[name]}]"
            text.report_key(entry, what)
            said.setdefault(name, []).append(entry)
        else:
            leftovers.append(entry)
    note_each_section(text, elsewhere, "read, though most files have it in another section")
    note_each_section(text, empty, "without a value, taken as not given")
    return said, leftovers


def note_each_section(text: TirText, entries: list[Entry], what: str) -> None:
    """One note in each section for entries with something in common."""
    for section in dict.fromkeys(entry.section for entry in entries):
        own = [entry for entry in entries if entry.section == section]
        text.note((own[0].line, own[0].column), section, f"{what}: {listed(entry.key for entry in own)}")


def note_book(text: TirText, numbers: Mapping[str, float], places: Mapping[str, Place]) -> None:
    """Note coefficients that act in the book's form of the equations alone."""
    for name in ("QBZ6", "LMUV"):
        if numbers.get(name):
            text.note_key(places[name][0][0], "acts only in the book's form of the equations")


def first_of(text: TirText) -> list[Mistake]:
    """The mistakes in reading order; of very many the first, with their number."""
    every = sorted(set(text.mistakes))
    if len(every) <= MAX_MISTAKES:
        return every
    rest = replace(every[MAX_MISTAKES], what=f"and {len(every) - MAX_MISTAKES} more mistakes from here on")
    return [*every[:MAX_MISTAKES], rest]
