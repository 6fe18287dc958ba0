"""A tyre as tables and a file of numbers."""

import csv
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from eom.report.table import table
from eom.tyre.carpet import Carpet
from eom.tyre.characteristics import Characteristics
from eom.tyre.interface import Forces
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.parameters import Values
from eom.tyre.suspicion.rules import suspicions
from eom.tyre.tir.file import TirFile

WIDTH = 100
"""Columns of a screen that sentences are wrapped to."""

VERSIONS = {MagicFormula61: "Magic Formula 6.1", MagicFormula52: "Magic Formula 5.2"}


def tyre_summary(file: TirFile) -> str:
    """What a file describes, a line for each property."""
    tyre = file.tyre
    size = f"{tyre.FNOMIN:g} N, free radius {1e3 * tyre.UNLOADED_RADIUS:g} mm"
    if isinstance(tyre, MagicFormula61):
        size += f", {1e-3 * tyre.NOMPRES:g} kPa"
        pressure = [("inflation", f"{1e-3 * tyre.INFLPRES:g} kPa")]
    else:
        pressure = []
    lines = [
        ("tyre", file.file),
        ("model", VERSIONS[type(tyre)]),
        ("side", f"{tyre.side or 'either, or not known'}{', mirrored' if tyre.mirror else ''}"),
        ("forces", tyre.use),
        ("nominal", size),
        *pressure,
        ("load", interval(tyre.FZMIN, tyre.FZMAX, " N")),
        ("slip angle", interval(np.rad2deg(tyre.ALPMIN), np.rad2deg(tyre.ALPMAX), " deg")),
        ("slip", interval(tyre.KPUMIN, tyre.KPUMAX)),
        ("camber", interval(np.rad2deg(tyre.CAMMIN), np.rad2deg(tyre.CAMMAX), " deg")),
    ]
    width = max(len(name) for name, _ in lines)
    return "\n".join(f"{name.ljust(width)}  {text}" for name, text in lines)


def interval(low: Values, high: Values, unit: str = "") -> str:
    """Both ends of a range of measurement."""
    first, last = (f"{round(float(end), 2):.9g}{unit}" for end in (low, high))
    if np.isinf(high):
        return "no range given" if low == 0.0 or np.isinf(low) else f"from {first}"
    return f"up to {last}" if np.isinf(low) else f"{first.removesuffix(unit)} to {last}"


def stiffness_tables(figures: Characteristics) -> str:
    """Figures over load: one table of the lateral direction, one of the longitudinal one, those that have forces."""
    per_degree = np.deg2rad(figures.cornering)
    lateral = {
        ("load", "[N]"): column(figures.Fz, 0),
        ("cornering", "[N/rad]"): column(figures.cornering, 0),
        ("stiffness", "[N/deg]"): column(per_degree, 1),
        ("over load", "[1/rad]"): column(figures.cornering / figures.Fz, 2),
        ("camber st.", "[N/rad]"): column(figures.camber, 0),
        ("peak", "Fy/Fz"): column(figures.side.friction, 3),
        ("at", "[deg]"): column(np.rad2deg(figures.side.slip), 2),
        ("trail", "[mm]"): column(1e3 * figures.trail, 1),
        ("relaxation", "[m]"): column(np.asarray(figures.relaxation.alpha), 3),
    }
    longitudinal = {
        ("load", "[N]"): column(figures.Fz, 0),
        ("slip stiffness", "[N]"): column(figures.longitudinal, 0),
        ("over load", ""): column(figures.longitudinal / figures.Fz, 2),
        ("peak", "Fx/Fz"): column(figures.drive.friction, 3),
        ("at", "slip"): column(figures.drive.slip, 4),
        ("relaxation", "[m]"): column(np.asarray(figures.relaxation.kappa), 3),
    }
    return "\n\n".join(
        f"{title}\n{table([name for name, _ in columns], [[unit for _, unit in columns], *rows_of(columns)], 0)}"
        for title, columns, stiffness in (
            ("lateral", lateral, figures.cornering),
            ("longitudinal", longitudinal, figures.longitudinal),
        )
        if np.any(stiffness != 0.0)
    )


def rows_of(columns: Mapping[tuple[str, str], list[str]]) -> list[tuple[str, ...]]:
    """The lines below the names and units of columns."""
    return list(zip(*columns.values(), strict=True))


def column(values: "np.ndarray[Any, Any]", digits: int) -> list[str]:
    """Numbers for people; a dash where there is none."""
    # + 0.0 so that rounding leaves no negative zero
    return [f"{round(value, digits) + 0.0:.{digits}f}" if np.isfinite(value) else "-" for value in values.tolist()]


def remarks(file: TirFile) -> str:
    """Notes on a file with their lines, then what is suspicious about its tyre and not noted."""
    told = [f"line {note.line}: {note.where}: {note.what}" for note in file.notes]
    odd = [text for text in suspicions(file.tyre) if not any(text in note.what for note in file.notes)]
    return f"{sentences('notes', told)}\n{sentences('suspicious', odd)}"


def sentences(title: str, texts: Sequence[str]) -> str:
    """A title with a paragraph for each text; or that there is none."""
    if not texts:
        return f"{title}: none"
    return "\n".join(
        [title, *(textwrap.fill(text, WIDTH, initial_indent="  ", subsequent_indent="    ") for text in texts)]
    )


def write_carpet(path: Path, curves: Carpet) -> None:
    """All points of a carpet as CSV in SI units at full precision, a line for each."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        units = dict(zip(Forces._fields, ("N", "N", "N m", "N m", "N m"), strict=True))
        writer.writerow(
            ["curves", "alpha [rad]", "kappa", "Fz [N]", *(f"{name} [{unit}]" for name, unit in units.items())]
        )
        for name, sweep in (("side", curves.side), ("drive", curves.drive), ("ellipse", curves.ellipse)):
            columns = (sweep.alpha, sweep.kappa, sweep.Fz, *sweep.forces)
            rows: Iterable[tuple[float, ...]] = zip(*(np.ravel(values).tolist() for values in columns), strict=True)
            writer.writerows([name, *map(repr, row)] for row in rows)
