"""Units of measure of a .tir file: spellings in its [UNITS] to exact factors."""

import math
from collections.abc import Mapping
from fractions import Fraction

from eom.tyre.tir.keys import HEADERS
from eom.tyre.tir.text import Entry, TirText, shown

FOOT, POUND = Fraction(3048, 10000), Fraction(45359237, 10**8)
POUND_FORCE = POUND * Fraction(980665, 100000)

# per quantity: the factor to SI, and the spellings in lower case without a plural s, the usual one last
UNITS: Mapping[str, Mapping[Fraction, str]] = {
    "LENGTH": {
        Fraction(1): "m metre meter",
        Fraction(1, 1000): "mm millimetre millimeter",
        Fraction(1, 100): "cm centimetre centimeter",
        Fraction(1000): "km kilometre kilometer",
        FOOT / 12: "in inche inch",
        FOOT: "ft feet foot",
    },
    "FORCE": {
        Fraction(1): "n newton",
        Fraction(1000): "kn knewton kilonewton",
        POUND_FORCE: "lbf pound-force poundforce pound_force",
        Fraction(980665, 100000): "kgf kg_force kilogram_force",
    },
    "ANGLE": {Fraction(1): "rad radian", Fraction(math.pi) / 180: "deg degree"},
    "MASS": {
        Fraction(1): "kilogram kg",
        Fraction(1, 1000): "g gram",
        Fraction(1000): "t mg megagram tonne",
        POUND: "lb lbm pound_mass pound",
        POUND_FORCE / FOOT: "slug",
    },
    "TIME": {
        Fraction(1): "s sec second",
        Fraction(1, 1000): "ms millisecond",
        Fraction(60): "min minute",
        Fraction(3600): "h hour",
    },
    "PRESSURE": {
        Fraction(1): "pa pascal",
        Fraction(1000): "kpa kilopascal",
        Fraction(10**6): "mpa megapascal",
        Fraction(10**5): "bar",
        POUND_FORCE / (FOOT / 12) ** 2: "psi",
    },
}
QUANTITY = {"m": "LENGTH", "N": "FORCE", "rad": "ANGLE", "s": "TIME", "Pa": "PRESSURE"}
SI: Mapping[str, Fraction] = dict.fromkeys(UNITS, Fraction(1))


def unit_factor(quantity: str, spelling: str) -> Fraction | None:
    """The SI factor of a unit of LENGTH, FORCE ...; None for a spelling that is not known.

    >>> unit_factor("LENGTH", "Millimeters")
    Fraction(1, 1000)
    """
    name = spelling.strip().lower()
    for factor, names in UNITS[quantity].items():
        if {name, name.removesuffix("s")}.intersection(names.split()):
            return factor
    return None


def factor_of(unit: str, units: Mapping[str, Fraction]) -> Fraction:
    """The SI factor of a product of units such as ``N*s/m``, for the units of a file.

    >>> factor_of("N/m", {**SI, "LENGTH": Fraction(1, 1000)})
    Fraction(1000, 1)
    """
    above, _, below = unit.partition("/")
    factor = Fraction(1)
    for name in filter(None, above.split("*")):
        factor *= units[QUANTITY[name]]
    return factor / units[QUANTITY[below]] if below else factor


def read_units(text: TirText) -> dict[str, Fraction]:
    """The factors of [UNITS], or of the header, where some files have them; SI for what is not said.

    Mistakes are added to the text.
    """
    units, said = dict(SI), dict[str, Entry]()
    for entry in (entry for entry in text.entries if entry.section == "UNITS" or entry.section in HEADERS):
        if entry.blank and entry.key in UNITS:
            continue
        if entry.key not in UNITS:
            if entry.section in HEADERS:
                continue
            text.report_key(entry, f"unknown quantity, expected one of {', '.join(UNITS)}")
            continue
        factor = unit_factor(entry.key, entry.value)
        if factor is None:
            known = ", ".join(names.split()[-1] for names in UNITS[entry.key].values())
            text.report_value(
                entry, f"unknown unit of {entry.key.lower()} {shown(entry.value)}, expected one of {known}"
            )
        elif entry.key in said and factor != units[entry.key]:
            first = said[entry.key]
            text.report_value(entry, f"is {shown(entry.value)} here and {shown(first.value)} in line {first.line}")
        else:
            said[entry.key], units[entry.key] = entry, factor
    return units
