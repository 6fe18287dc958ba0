"""Stability maps as tables and a file of numbers."""

import csv
from pathlib import Path

import numpy as np

from eom.analysis.maps import StabilityMap
from eom.report.modes import blank
from eom.report.table import table


def map_table(result: StabilityMap) -> str:
    """Rightmost real part over both parameters; a dash where it was not computed."""
    corner = f"{result.first.label} \\ {result.second.label}"
    lines = [
        (f"{value:g}", *(blank(item, bool(np.isfinite(item))) for item in row.tolist()))
        for value, row in zip(result.first.values, result.rightmost, strict=True)
    ]
    return f"largest real part [1/s]\n{table((corner, *(f'{value:g}' for value in result.second.values)), lines, 0)}"


def write_map(path: Path, result: StabilityMap) -> None:
    """Both figures as CSV at full precision, a line per point that was computed."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        labels = [f"{axis.parameter} [{axis.unit}]" for axis in (result.first, result.second)]
        writer.writerow([*labels, "rightmost real part [1/s]", "least damping ratio"])
        for i, first in enumerate(result.first.values):
            for k, second in enumerate(result.second.values):
                figures = float(result.rightmost[i, k]), float(result.damping[i, k])
                if not np.all(np.isnan(figures)):
                    writer.writerow(map(repr, (first, second, *figures)))
