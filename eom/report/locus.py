"""Root loci and critical values as tables and a file of numbers."""

import csv
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from eom.analysis.critical import CriticalValue, unexplained
from eom.analysis.locus import RootLocus
from eom.analysis.stability import rightmost, sides
from eom.report.modes import blank, root
from eom.report.table import table

STABLE = {-1: "yes", 0: "neutral", 1: "no"}

MEETINGS = 3
"""How many meetings of roots a reader wants to see; wheels of a kind have roots that meet everywhere."""


def locus_table(locus: RootLocus) -> str:
    """Per value of the parameter: stability, and the root with the largest real part."""
    lines = []
    for value, modes in zip(locus.values, locus.modes, strict=True):
        worst = rightmost(modes)
        if worst is None:
            lines.append((f"{value:g}", "neutral", "-", "-"))
            continue
        own, damping = modes.eigenvalues[worst], float(modes.damping_ratio[worst])
        shown = complex(own.real, abs(own.imag))
        lines.append(
            (f"{value:g}", STABLE[int(sides(modes)[worst])], root(shown), blank(damping, bool(np.isfinite(damping))))
        )
    return table((label(locus), "stable", "rightmost root [1/s]", "damping ratio"), lines)


def label(locus: RootLocus) -> str:
    """The parameter with its unit, alone where the values are in SI units."""
    return f"{locus.parameter} [{locus.unit}]" if locus.unit else locus.parameter


def critical_table(locus: RootLocus, found: Sequence[CriticalValue]) -> str:
    """The critical values, where branches could not be told apart, and what these values do not explain."""
    between = f"between {min(locus.values):g} and {max(locus.values):g}"
    if found:
        header = (f"critical {label(locus)}", "kind", "frequency [Hz]", "becomes", "bodies")
        lines = [
            (
                f"{item.value:.7g}",
                item.kind,
                blank(item.frequency, item.kind == "flutter"),
                item.becomes,
                ", ".join(item.bodies),
            )
            for item in found
        ]
        text = table(header, lines, len(header))
    else:
        text = f"no critical value of {locus.parameter} {between}"
    notes = [
        f"roots meet between {a:.6g} and {b:.6g}: which branch is which beyond is a guess"
        for a, b in locus.unclear[:MEETINGS]
    ]
    if len(locus.unclear) > MEETINGS:
        notes.append(f"{len(locus.unclear) - MEETINGS} more such meetings")
    notes += [
        f"between {a:g} and {b:g} the number of unstable roots changes otherwise than these say: take smaller steps"
        for a, b in unexplained(locus, found)
    ]
    return "\n".join([text, *notes])


def write_locus(path: Path, locus: RootLocus) -> None:
    """All roots as CSV at full precision: value, branch, root, frequency, damping ratio, wavelength."""
    header = ["real [1/s]", "imaginary [1/s]", "frequency [Hz]", "damping ratio", "wavelength [m]"]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([label(locus), "branch", *header])
        for value, modes, order in zip(locus.values.tolist(), locus.modes, locus.order, strict=True):
            roots = modes.eigenvalues[order]
            columns = [roots.real, roots.imag]
            columns += [item[order] for item in (modes.natural_frequency, modes.damping_ratio, modes.wavelength)]
            for branch, line in enumerate(np.column_stack(columns).tolist(), start=1):
                writer.writerow([repr(value), branch, *map(repr, line)])
