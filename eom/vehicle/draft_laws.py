"""Tyre laws into a draft: the numbers of one wheel."""

from typing import cast

from eom.vehicle.draft import ONE, ZERO, Draft
from eom.vehicle.draft_tyres import HALF, tyre_numbers
from eom.vehicle.elements import TyreLaw
from eom.vehicle.expression import Number
from eom.vehicle.tyres import SUFFIX, DugoffLaw, FileLaw, MagicFormulaLaw, Tyre

COMBINED = ("ellipse", "cosine")
POSITIVE = frozenset({"friction", "mu_x", "mu_y", "C_x", "C_y"})


def draft_law(draft: Draft, name: str, tyre: Tyre) -> None:
    """Add a tyre's law; stiffnesses per axle are halved."""
    numbers, law = tyre_numbers(draft, name, tyre), tyre.nonlinear
    if isinstance(law, MagicFormulaLaw | DugoffLaw):
        # a curve has a slope
        for key, value in (("cornering", numbers.cornering), ("longitudinal", numbers.longitudinal)):
            if value is not None:
                draft.registry.not_negative(value, ("tyres", name, key), zero=False)
    share = ONE if tyre.per == "wheel" else HALF
    cornering, longitudinal, camber = (
        ZERO if value is None else share * value for value in (numbers.cornering, numbers.longitudinal, numbers.camber)
    )
    trail, relaxation, resistance = (
        ZERO if value is None else value for value in (numbers.trail, numbers.relaxation, numbers.rolling_resistance)
    )
    draft.laws[name] = TyreLaw(
        name,
        "linear" if law is None else law.kind,
        cornering,
        longitudinal,
        camber,
        trail,
        relaxation,
        resistance,
        () if law is None or isinstance(law, FileLaw) else coefficients(draft, name, law),
        coefficient_file(draft, name, law) if isinstance(law, FileLaw) else "",
    )


def coefficients(draft: Draft, name: str, law: MagicFormulaLaw | DugoffLaw) -> tuple[tuple[str, float], ...]:
    """The further coefficients of a law; the friction of a Magic Formula counts along and across."""
    found: dict[str, float] = {}
    for key in type(law).model_fields:
        if key in {"kind", "combined"} or (value := getattr(law, key)) is None:
            continue
        path = ("tyres", name, "nonlinear", key)
        found[key] = draft.registry.number(value, f"{name}.nonlinear.{key}", path)
        if key in POSITIVE:
            draft.registry.not_negative(found[key], path, zero=False)
    if isinstance(law, MagicFormulaLaw):
        if (friction := found.pop("friction", None)) is not None:
            found = {"mu_x": friction, "mu_y": friction} | found
        found["combined"] = cast("float", Number(float(COMBINED.index(law.combined))))
    return tuple(found.items())


def coefficient_file(draft: Draft, name: str, law: FileLaw) -> str:
    """The whole path of a file of coefficients; reported if there is none."""
    file = draft.folder / law.file
    try:
        there = file.is_file()
    except ValueError:
        # a name that no file can have
        there = False
    if not there:
        what = f"there is no file '{law.file}' beside the vehicle file: a path of a {SUFFIX} file starts from there"
        draft.registry.report(("tyres", name, "nonlinear", "file"), what)
        return ""
    return str(file.resolve())
