"""Numbers of a .tir file: each coefficient once, finite, within its bounds, in SI units."""

from collections.abc import Collection, Mapping
from dataclasses import MISSING
from fractions import Fraction

from eom.tyre.mf.coefficients import MagicFormula61
from eom.tyre.mf.relations import relation_problems
from eom.tyre.parameters import problem_of
from eom.tyre.tir.keys import SECTION_OF, Tyre, fields_of
from eom.tyre.tir.leftovers import listed
from eom.tyre.tir.text import Entry, TirText, number, shown

Place = tuple[tuple[Entry, ...], Fraction]
"""The entries that say a coefficient, and the factor from their unit to SI."""

LEAST_PRESSURE = 1e4


def read_number(text: TirText, version: type[Tyre], name: str, place: Place) -> float | None:
    """The value of a coefficient in SI units; None without a value, and with a mistake for what is no such number."""
    entries, factor = tuple(entry for entry in place[0] if not entry.blank), place[1]
    if not entries:
        return None
    first = entries[0]
    values = [read_plain(text, entry) for entry in entries]
    for entry, value in zip(entries[1:], values[1:], strict=True):
        if value is not None and value != values[0]:
            text.report_value(entry, f"is {entry.value} here and {first.value} in line {first.line}: keep one")
        elif value is not None:
            text.note_key(entry, f"stands in line {first.line} as well, with the same value")
    if values[0] is None:
        return None
    try:
        scaled = float(values[0] * factor)
    except OverflowError:
        text.report_value(first, f"expected a finite number in SI units, got {shown(first.value)}")
        return None
    item = fields_of(version)[name]
    problem = problem_of(item, scaled) if "above" in item.metadata else ""
    if problem and scaled == 0.0 and item.default is not MISSING and SECTION_OF[name] != "SCALING_COEFFICIENTS":
        text.note_key(first, "is 0, which it cannot be: taken as not given")
        return None
    if problem:
        text.report_value(first, f"{problem}, got {first.value}")
        return None
    return scaled


def read_plain(text: TirText, entry: Entry) -> Fraction | None:
    """The number of an entry as it stands; None with a mistake if it is none."""
    value = None if entry.quoted else number(entry.value)
    if value is None:
        hint = ""
        if entry.quoted:
            hint = " without quotes"
        elif number(entry.value.replace(",", ".")) is not None:
            hint = " with a decimal point"
        text.report_value(entry, f"expected a finite number{hint}, got {shown(entry.value)}")
    return value


def check_missing(text: TirText, version: type[Tyre], places: Mapping[str, Place], known: Collection[str]) -> None:
    """Report the coefficients that have to be given and are not, section by section; *known* need not be."""
    missing: dict[str, list[str]] = {}
    for name, item in fields_of(version).items():
        if item.default is not MISSING or name in known:
            continue
        if name not in places:
            missing.setdefault(SECTION_OF[name], []).append(name)
        elif all(entry.blank for entry in places[name][0]):
            text.report_value(places[name][0][0], "expected a finite number, got nothing")
    for section, names in missing.items():
        text.report((text.sections.get(section, 1), 1), section, f"needs {listed(names)}")


def check_relations(
    text: TirText, version: type[Tyre], numbers: Mapping[str, float], places: Mapping[str, Place]
) -> None:
    """Report numbers that others forbid, such as ends of ranges that no value is in."""
    for name, what in relation_problems(version, numbers):
        text.report_value(places[name][0][0], what)


def note_pressure(
    text: TirText, version: type[Tyre], numbers: Mapping[str, float], places: Mapping[str, Place]
) -> None:
    """Note a pressure that is taken for want of one, and one that is probably not in pascal."""
    if version is not MagicFormula61:
        return
    line = text.sections.get("OPERATING_CONDITIONS", 1)
    nominal = fields_of(version)["NOMPRES"].default
    if "NOMPRES" not in numbers:
        text.note((line, 1), "OPERATING_CONDITIONS", f"NOMPRES is not given: {nominal:g} Pa is taken")
    if "INFLPRES" not in numbers:
        text.note((line, 1), "OPERATING_CONDITIONS", "INFLPRES is not given: NOMPRES is taken")
    for name in ("INFLPRES", "NOMPRES"):
        if numbers.get(name, LEAST_PRESSURE) < LEAST_PRESSURE:
            what = f"is {numbers[name]:g} Pa, which is little: [UNITS] says by PRESSURE what it is in"
            text.note_key(places[name][0][0], what)
