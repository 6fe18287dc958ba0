"""Which equations a .tir file is for, and how: FITTYP, USE_MODE, TYRESIDE of its section [MODEL]."""

from collections.abc import Mapping
from typing import Any, get_args

from eom.tyre.mf.coefficients import Form, MagicFormula52, MagicFormula61, Use
from eom.tyre.tir.keys import Tyre
from eom.tyre.tir.text import Entry, TirText, number, shown

KEYS = frozenset({"PROPERTY_FILE_FORMAT", "FITTYP", "USE_MODE", "TYRESIDE", "FORM"})
VERSIONS: dict[int, type[Tyre]] = {
    5: MagicFormula52,
    6: MagicFormula52,
    52: MagicFormula52,
    60: MagicFormula61,
    61: MagicFormula61,
    62: MagicFormula61,
}
REMARKS = {
    5: "read by the equations of the Magic Formula 5.2; 5.0 and 5.1 have a part of its coefficients",
    52: "read as the Magic Formula 5.2, which FITTYP = 6 says; FITTYP = 52 is also a motorcycle tyre (MF-MCTyre 1.1)",
    60: "read by the equations of the Magic Formula 6.1, which contain those of 6.0",
    62: "read by the equations of the Magic Formula 6.1, which have the same forces; the loaded radius of 6.2 is not "
    "modelled",
}
OTHERS = {
    21: "an early Magic Formula",
    51: "a motorcycle tyre, MF-MCTyre 1.0",
    53: "a motorcycle tyre of MF-MCTyre",
}
USES: dict[int, Use] = {1: "longitudinal", 2: "lateral", 3: "uncombined", 4: "combined", 5: "combined"}
SIDES = {"LEFT": "left", "RIGHT": "right", "UNKNOWN": None, "SYMMETRIC": None, "": None}
UNREADABLE = 10**6
READS = "this reads FITTYP 61 (Magic Formula 6.1), also 60 and 62, and 6 (5.2, PAC2002), also 5 and 52"


def model_entries(text: TirText) -> dict[str, Entry]:
    """The entries of `KEYS`, each once; one that is there again with another value is reported."""
    said: dict[str, Entry] = {}
    for entry in (entry for entry in text.entries if entry.key in KEYS and not entry.blank):
        first = said.setdefault(entry.key, entry)
        if entry.value != first.value:
            text.report_value(entry, f"is {entry.value} here and {first.value} in line {first.line}: keep one")
        elif entry is not first:
            text.note_key(entry, f"stands in line {first.line} as well, with the same value")
    return said


def read_version(text: TirText, said: Mapping[str, Entry]) -> type[Tyre] | None:
    """The class of the tyre that FITTYP names, or the file's format; None with a mistake if it is none of ours."""
    fittyp, file_format = said.get("FITTYP"), said.get("PROPERTY_FILE_FORMAT")
    name = file_format.value.upper() if file_format else ""
    if fittyp is None:
        if file_format and name in {"PAC2002", "MF_05"}:
            if name == "MF_05":
                text.note_key(file_format, REMARKS[5])
            return MagicFormula52
        if file_format is None:
            place = (text.sections.get("MODEL", 1), 1)
            text.report(place, "MODEL", f"needs FITTYP, which says the version of the Magic Formula; {READS}")
        else:
            text.report_value(
                file_format, f"{shown(file_format.value)} does not say the version, and there is no FITTYP; {READS}"
            )
        return None
    kind = whole(fittyp)
    version = VERSIONS.get(kind)
    if version is None:
        known = OTHERS.get(kind)
        text.report_value(fittyp, f"{f'is {known}' if known else f'got {shown(fittyp.value)}'}; {READS}")
    elif name == "PAC2002" and version is MagicFormula61:
        what = f"FITTYP = {fittyp.value} contradicts PROPERTY_FILE_FORMAT = 'PAC2002', which is the Magic Formula 5.2"
        text.report_value(fittyp, f"{what}: drop one")
    elif kind in REMARKS:
        text.note_key(fittyp, REMARKS[kind])
    return version


def read_model(text: TirText, said: Mapping[str, Entry], version: type[Tyre] | None) -> dict[str, Any]:
    """The fields `side`, `use`, `mirror` and `form` of the tyre, as far as the file says them."""
    fields: dict[str, Any] = {}
    if "TYRESIDE" in said:
        side = said["TYRESIDE"].value.upper()
        if side in SIDES:
            fields["side"] = SIDES[side]
        else:
            what = f"expected 'LEFT', 'RIGHT', 'SYMMETRIC' or 'UNKNOWN', got {shown(side)}"
            text.report_value(said["TYRESIDE"], what)
    if "USE_MODE" in said:
        fields |= read_use(text, said["USE_MODE"])
    if "FORM" in said and version is not None:
        form = said["FORM"].value.lower()
        if version is MagicFormula61 and form in get_args(Form):
            fields["form"] = form
        else:
            choice = "'tool' or 'book'" if version is MagicFormula61 else "no FORM, which only FITTYP 61 has"
            text.report_value(said["FORM"], f"expected {choice}, got {shown(form)}")
    return fields


def read_use(text: TirText, entry: Entry) -> dict[str, Any]:
    """The fields `use` and `mirror`: the last digit of USE_MODE, and its sign."""
    mode = whole(entry)
    dynamics, forces = divmod(abs(mode), 10)
    if forces not in USES or abs(mode) > 999:
        none = "asks for no forces in the plane of the road; " if forces == 0 and mode != UNREADABLE else ""
        what = "expected a whole number that ends in 1 (Fx, My), 2 (Fy, Mx, Mz), 3 (all, uncombined) or 4 (combined)"
        text.report_value(entry, f"{none}{what}, got {shown(entry.value)}")
        return {}
    if forces == 5:
        text.note_key(entry, "turn slip is not modelled: read as combined slip without it")
    if dynamics % 10 > 2:
        text.note_key(entry, "the belt as a body is not modelled")
    return {"use": USES[forces], "mirror": mode < 0}


def whole(entry: Entry) -> int:
    """The whole number that a value says, or `UNREADABLE`."""
    value = number(entry.value)
    return int(value) if value is not None and value.denominator == 1 else UNREADABLE
