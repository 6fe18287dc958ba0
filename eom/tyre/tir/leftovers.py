"""Keys of a .tir file that are no numbers of its tyre: left out with a note, or a mistake."""

import difflib
from collections.abc import Collection, Iterable
from dataclasses import Field
from itertools import groupby
from typing import Any

from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.tir.keys import (
    ALIASES,
    HEADERS,
    OTHER_SECTIONS,
    SECTION_OF,
    SECTIONS,
    SUBJECT_OF,
    WITHOUT_MEANING,
    Tyre,
    fields_of,
    is_coefficient,
    unit_of,
)
from eom.tyre.tir.text import Entry, TirText, number, shown

MAX_GUESSES, MAX_KEY, MAX_LISTED = 50, 40, 30
NAMES: dict[type[Tyre], str] = {MagicFormula61: "the Magic Formula 6.1", MagicFormula52: "the Magic Formula 5.2"}
WORDS_FOR_NONE = frozenset({"", "NO", "FALSE", "DEFAULT", "NONE"})


def read_leftovers(text: TirText, version: type[Tyre], entries: list[Entry], said: Collection[str]) -> frozenset[str]:
    """Report and note what is no number of the version; give the names that mistyped keys probably mean.

    *said* are the names of the numbers that are in the file.
    """
    other = MagicFormula52 if version is MagicFormula61 else MagicFormula61
    fields = fields_of(version)
    foreign = {name: item for name, item in fields_of(other).items() if name not in fields}
    noted: list[tuple[str, Entry]] = []
    strange: list[Entry] = []
    for entry in entries:
        name = ALIASES.get(entry.key, entry.key)
        if name in foreign:
            default: Any = foreign[name].default
            if not says_nothing(entry, default):
                noted.append((reason_of(name, foreign[name], version, other), entry))
        elif entry.key in SUBJECT_OF:
            if not says_nothing(entry, float(entry.key.startswith("L"))):
                noted.append((f"not modelled: {SUBJECT_OF[entry.key]}", entry))
        elif entry.section in OTHER_SECTIONS:
            noted.append(("unknown, not read", entry))
        elif entry.section not in SECTIONS:
            noted.append(("unknown section, not read", entry))
        elif entry.key not in WITHOUT_MEANING:
            strange.append(entry)
    # a mistyped key means a name that is not there
    names = sorted(fields.keys() - set(said))
    meant, unknown = report_strange(text, strange, names)
    add_notes(text, noted + [("unknown, not read", entry) for entry in unknown])
    return meant


def reason_of(name: str, item: "Field[Any]", version: type[Tyre], other: type[Tyre]) -> str:
    """Why a number of the other version is left out."""
    if is_coefficient(name):
        return f"no effect in {NAMES[version]}; change FITTYP if fitted for {NAMES[other]}"
    return f"{NAMES[version]} has no pressure" if unit_of(item) == "Pa" else f"not part of {NAMES[version]}"


def report_strange(text: TirText, strange: list[Entry], names: list[str]) -> tuple[frozenset[str], list[Entry]]:
    """Report unknown keys among coefficients, and elsewhere those that resemble a name that is not in the file.

    The names that they resemble are given back, and the keys that are not reported.
    """
    meant: set[str] = set()
    unknown = []
    for count, entry in enumerate(strange):
        among_coefficients = entry.section.endswith("COEFFICIENTS")
        # comparing is slow, and a file of unknown keys needs no help with each
        guess = closest(entry.key, names, 0.6 if among_coefficients else 0.85) if count < MAX_GUESSES else ""
        if guess or among_coefficients:
            text.report_key(entry, f"unknown key{f'; did you mean {guess}?' if guess else ''}")
            meant.add(guess)
        else:
            unknown.append(entry)
    return frozenset(meant), unknown


def closest(key: str, names: list[str], least: float) -> str:
    """The first of the names that are most like a key, empty if none is like it."""
    if not names or len(key) > MAX_KEY:
        return ""
    likeness = {name: difflib.SequenceMatcher(None, key, name).ratio() for name in names}
    best = max(names, key=likeness.__getitem__)
    return best if likeness[best] >= least else ""


def says_nothing(entry: Entry, neutral: float) -> bool:
    """Whether a key has the value that it would have if it were not there."""
    value = number(entry.value)
    if value is None:
        return entry.value.upper() in WORDS_FOR_NONE
    return value == neutral or (value == 0 and not entry.key.startswith("L"))


def add_notes(text: TirText, noted: list[tuple[str, Entry]]) -> None:
    """One note for the keys of each section that are left out for the same reason."""
    ordered = sorted(noted, key=lambda item: (item[1].section, item[0], item[1].line))
    for (section, reason), items in groupby(ordered, key=lambda item: (item[1].section, item[0])):
        entries = [entry for _, entry in items]
        names = listed(told(entry) for entry in entries)
        text.note((entries[0].line, entries[0].column), section, f"{reason} ({names})")


def told(entry: Entry) -> str:
    """A key, with its value if that is a coefficient that forces would need."""
    name = ALIASES.get(entry.key, entry.key)
    acts = entry.key.startswith(("LKG", "LIP", "QP")) or (name in SECTION_OF and is_coefficient(name))
    return f"{entry.key} = {entry.value}" if acts else entry.key


def read_rows(text: TirText) -> None:
    """Report lines that are neither section nor key in sections of keys; note tables of the others."""
    for section, rows in text.rows.items():
        line, column, _ = rows[0]
        if section in SECTIONS or section == "UNITS":
            for *place, content in rows:
                hint = "; a comment that goes on? start it with $" if content[0].isalpha() else ""
                text.report((place[0], place[1]), section, f"expected KEY = value, got {shown(content)}{hint}")
        elif section not in HEADERS:
            text.note((line, column), section, f"not modelled: a table of {len(rows)} lines")


def listed(names: Iterable[str]) -> str:
    """Names with commas, the first ones of many."""
    every = [shown(name).strip("'") for name in names]
    more = f" and {len(every) - MAX_LISTED} more" if len(every) > MAX_LISTED else ""
    return ", ".join(every[:MAX_LISTED]) + more
