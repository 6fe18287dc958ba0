"""A signal over time from a CSV file: names in the first line, time in the first column."""

import csv
import io
import math
import re
from collections.abc import Iterator
from pathlib import Path as FilePath
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import Mistake
from eom.vehicle.expression import shorten
from eom.vehicle.source import NUMBER
from eom.vehicle.units import DIMENSIONLESS, Dimension, parse_unit, stated_in
from eom.vehicle.validate import did_you_mean

SUFFIX = ".csv"
MAX_BYTES = 100_000_000
SHOWN = 20
Placed = tuple[int, int, str]
"""A mistake after its line and column, 0 for the whole file."""
HEADING = re.compile(r"\s*([^\[\]]*?)\s*(?:\[([^\[\]]*)\]\s*)?")


class Column(NamedTuple):
    """A signal: times [s] and values in SI units, (n,) each, and the dimension its heading tells, None without one."""

    time: Array
    value: Array
    dimension: Dimension | None


class Unread(NamedTuple):
    """Which cell of a row is no value, and why."""

    cell: int
    what: str


def read_column(file: FilePath, name: str) -> Column | list[Mistake]:
    """The named column of a CSV file, or every mistake in it.

    Headings are names, or names with a unit such as ``steer [deg]``; without one values are in SI units. Times
    increase.
    """

    def mistakes(*found: Placed) -> list[Mistake]:
        """Mistakes; after some of them only their number."""
        shown = [*found[:SHOWN], *([(0, 0, f"and {len(found) - SHOWN} more mistakes")] if len(found) > SHOWN else [])]
        return [Mistake(str(file), line, column, "", what) for line, column, what in shown]

    try:
        with file.open("rb") as opened:
            raw = opened.read(MAX_BYTES + 1)
        text = raw.decode("utf-8-sig")
        lines = list(numbered(text))
    except OSError as error:
        return mistakes((0, 0, f"cannot be read: {error.strerror or error}"))
    except UnicodeDecodeError as error:
        return mistakes((0, 0, f"not readable as UTF-8 text: {error.reason} at {error.start}"))
    except csv.Error as error:
        return mistakes((0, 0, f"not readable as CSV: {error}"))
    if len(raw) > MAX_BYTES:
        return mistakes((0, 0, f"has more than {MAX_BYTES} bytes"))
    if not lines:
        return mistakes((0, 0, "is empty: expected names in the first line, 'time' first"))
    headings = lines[0][1]
    try:
        index, factors, dimension = chosen(headings, name)
    except ValueError as error:
        return mistakes((lines[0][0], 1, str(error)))
    rows = [row_values(row, index, len(headings)) for _, row in lines[1:]]
    wrong = unread_cells(text, lines[1:], rows)
    if wrong or not rows:
        return mistakes(*wrong) or mistakes((lines[0][0], 1, "has no values below the names"))
    time, value = factors[0] * np.array(rows)[:, 0], factors[1] * np.array(rows)[:, 1]
    back = np.flatnonzero(np.diff(time) <= 0.0) + 1
    if len(back):
        return mistakes(*((lines[k + 1][0], 1, f"time {time[k]:g} s comes after {time[k - 1]:g} s") for k in back))
    return Column(time, value, dimension)


def numbered(text: str) -> Iterator[tuple[int, list[str]]]:
    """The rows of a CSV text that hold anything, with the number of the line in which they end."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    for row in reader:
        if any(cell.strip() for cell in row):
            yield reader.line_num, row


def chosen(headings: list[str], name: str) -> tuple[int, tuple[float, float], Dimension | None]:
    """Number of the named column, factors of times and values to SI units, dimension of the values.

    ``ValueError`` with a sentence if the columns are not as expected.
    """
    split = [HEADING.fullmatch(cell) for cell in headings]
    names = ["" if match is None else match[1] for match in split]
    units = [None if match is None else match[2] for match in split]
    if names[0] != "time":
        message = f"expected 'time' as the first name, got '{shorten(headings[0])}'"
        raise ValueError(message)
    if name not in names[1:]:
        message = f"there is no column '{shorten(name)}'{did_you_mean(name, names[1:])}"
        raise ValueError(message)
    if names.count(name) > 1:
        message = f"has the column '{name}' twice"
        raise ValueError(message)
    index = names.index(name)
    seconds, dimension = parse_unit(units[0] or "s")
    if dimension != parse_unit("s")[1]:
        message = f"time is {stated_in(dimension)}, expected s"
        raise ValueError(message)
    unit = units[index]
    factor, told = parse_unit(unit or "")
    return index, (seconds, factor), None if unit is None else (told if unit.strip() else DIMENSIONLESS)


def row_values(row: list[str], index: int, count: int) -> tuple[float, float] | Unread:
    """Time and value of a row, or what is wrong with it."""
    if len(row) != count:
        return Unread(0, f"has {len(row)} values, expected {count} as in the first line")
    found = []
    for k in (0, index):
        value = float(row[k]) if NUMBER.fullmatch(row[k].strip()) else math.nan
        if not math.isfinite(value):
            return Unread(k, f"'{shorten(row[k])}' is no number")
        found.append(value)
    return found[0], found[1]


def unread_cells(
    text: str, lines: list[tuple[int, list[str]]], rows: list[tuple[float, float] | Unread]
) -> list[Placed]:
    """The mistakes of rows, each at its line and column."""
    unread = [(*place, found) for place, found in zip(lines, rows, strict=True) if isinstance(found, Unread)]
    written = text.splitlines() if unread else []
    return [(k, column_of(written[k - 1], row, found.cell), found.what) for k, row, found in unread]


def column_of(line: str, row: list[str], cell: int) -> int:
    """Where a cell begins in a line, from 1; 1 if the line has quotes."""
    return 1 + sum(len(before) + 1 for before in row[:cell]) if line == ",".join(row) else 1
