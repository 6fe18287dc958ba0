"""Entries of a .tir file to a tyre, with every mistake and everything worth knowing at its place."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from eom.errors import DescriptionError, Mistake
from eom.tyre.suspicion.combined import no_weight
from eom.tyre.tir.directions import absent_direction, acts, note_absent
from eom.tyre.tir.keys import ALIASES, HEADERS, SECTION_OF, SECTIONS, Tyre, fields_of, is_coefficient, unit_of
from eom.tyre.tir.leftovers import listed, read_leftovers, read_rows
from eom.tyre.tir.model import KEYS, model_entries, read_model, read_version
from eom.tyre.tir.numbers import Place, check_missing, check_relations, note_pressure, read_number, read_plain
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
    model = read_model(text, said_of_model, version)
    if version is None:
        check_plain(text)
        raise DescriptionError(first_of(text))
    note_blanks(text, version)
    said, leftovers = split(text, version)
    fields = fields_of(version)
    places = {name: (tuple(entries), factor_of(unit_of(fields[name]), units)) for name, entries in said.items()}
    meant = read_leftovers(text, version, leftovers, said)
    absent = absent_direction(places, model.get("use", "combined"))
    neutral: dict[str, float] = {}
    if absent and not meant.intersection(absent.neutral):
        neutral = {name: value for name, value in absent.neutral.items() if not (name in places and acts(places[name]))}
        places = {name: place for name, place in places.items() if name not in neutral}
        model["use"] = absent.other
        note_absent(text, absent, list(neutral))
    found = {name: read_number(text, version, name, place) for name, place in places.items()}
    numbers: dict[str, Any] = neutral | {name: value for name, value in found.items() if value is not None}
    check_missing(text, version, places, meant.union(neutral))
    check_relations(text, version, numbers, places)
    note_pressure(text, version, numbers, places)
    note_book(text, numbers, places)
    if text.mistakes:
        raise DescriptionError(first_of(text))
    tyre = version(**numbers, **model)
    note_combined(text, tyre)
    return Reading(tyre, tuple(sorted(set(text.notes))), places)


def check_plain(text: TirText) -> None:
    """Report what is no number where every version has one."""
    for entry in text.entries:
        if ALIASES.get(entry.key, entry.key) in SECTION_OF and entry.section in SECTIONS and not entry.blank:
            read_plain(text, entry)


def note_blanks(text: TirText, version: type[Tyre]) -> None:
    """Note known keys without a value, section by section."""
    known = KEYS.union(fields_of(version), ALIASES)
    blank = [entry for entry in text.entries if entry.blank and (entry.key in known or entry.section == "UNITS")]
    for section in dict.fromkeys(entry.section for entry in blank):
        entries = [entry for entry in blank if entry.section == section]
        what = f"without a value, taken as not given: {listed(entry.key for entry in entries)}"
        text.note((entries[0].line, entries[0].column), section, what)


def note_combined(text: TirText, tyre: Tyre) -> None:
    """Note forces that know nothing of each other, for want of coefficients."""
    for sentence in no_weight(tyre):
        section = "LATERAL_COEFFICIENTS" if sentence[2] == "Y" else "LONGITUDINAL_COEFFICIENTS"
        text.note((text.sections.get(section, 1), 1), section, sentence)


def split(text: TirText, version: type[Tyre]) -> tuple[dict[str, list[Entry]], list[Entry]]:
    """The entries of each coefficient, and all others that may bear on the tyre."""
    fields = fields_of(version)
    said: dict[str, list[Entry]] = {}
    leftovers, elsewhere = [], []
    for entry in text.entries:
        name = ALIASES.get(entry.key, entry.key)
        if entry.section in HEADERS or entry.key in KEYS or entry.section == "UNITS":
            continue
        if name not in fields:
            leftovers.append(entry)
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
    for section in dict.fromkeys(entry.section for entry in elsewhere):
        entries = [entry for entry in elsewhere if entry.section == section]
        what = f"read, though most files have it in another section: {listed(entry.key for entry in entries)}"
        text.note((entries[0].line, entries[0].column), section, what)
    return said, leftovers


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
