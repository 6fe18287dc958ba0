"""Inputs of a run file: constants, sines, tables, steps, columns of files."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.inputs import Constant, Sine, Steps, Table
from eom.simulation.run_form import InputForm, SineForm, TableForm
from eom.simulation.run_reading import number, positive, read
from eom.simulation.signal_file import SUFFIX, Column, read_column
from eom.vehicle.quantity import Quantity, parse_quantity
from eom.vehicle.source import Data, Path, Source
from eom.vehicle.units import Dimension

Input = Constant | Sine | Table | Steps
WAYS = ("sine", "table", "steps", "file")


class Stated(NamedTuple):
    """A number that must be in the unit of a signal: where it stands, that signal, the dimension it is given in.

    Without a dimension: the name of a signal itself.
    """

    path: Path
    signal: str
    dimension: Dimension | None


@dataclass(frozen=True)
class Reading:
    """A run file while it is read: its source, which collects mistakes, the folder of files, and what is stated."""

    source: Source
    folder: FilePath
    stated: list[Stated] = field(default_factory=list)

    def number(self, quantity: Quantity, path: Path, signal: str) -> float | None:
        """The value of a number in the unit of a signal, None with a mistake."""
        if quantity.dimension is not None:
            self.stated.append(Stated(path, signal, quantity.dimension))
        return number(quantity, path, self.source)


def read_input(name: str, data: Data, reading: Reading) -> Input | None:
    """The input at ``inputs.NAME``, None with mistakes."""
    path: Path = ("inputs", name)
    source = reading.source
    if not isinstance(data, dict):
        return read_constant(name, data, reading)
    values = read(InputForm, data, path, source)
    ways = [way for way in WAYS if way in data]
    if len(ways) > 1:
        source.report(path, f"gives {' and '.join(ways)}: keep one")
        return None
    if "column" in data and ways and ways != ["file"]:
        source.report_key((*path, "column"), "goes with 'file'")
    if not ways:
        # a key that is unknown is reported, with what may be meant
        if not set(data) - {"column"}:
            source.report(path, f"needs one of {', '.join(WAYS)}")
        return None
    (way,) = ways
    if way not in values:
        return None
    if way == "file":
        return read_file(name, values, reading, told="column" in data)
    if way == "sine":
        return read_sine(name, values[way], reading)
    found = read_table(name, way, values[way], reading)
    return found if found is None or way == "table" else Steps(found.time, found.value)


def read_constant(name: str, data: Data, reading: Reading) -> Constant | None:
    """An input that does not change."""
    path: Path = ("inputs", name)
    try:
        value = None if data is None else reading.number(parse_quantity(data, "*"), path, name)
    except ValueError as error:
        reading.source.report(path, str(error))
        return None
    return None if value is None else Constant(value)


def read_sine(name: str, data: Data, reading: Reading) -> Sine | None:
    """Cycles of a sine."""
    path, source = ("inputs", name, "sine"), reading.source
    values = read(SineForm, data, path, source)
    amplitude = reading.number(values["amplitude"], (*path, "amplitude"), name) if "amplitude" in values else None
    frequency = positive(values, "frequency", path, source)
    start = number(values["start"], (*path, "start"), source) if "start" in values else 0.0
    cycles = positive(values, "cycles", path, source) if "cycles" in values else 1.0
    if amplitude is None or frequency is None or start is None or cycles is None:
        return None
    return Sine(amplitude, frequency, start, cycles)


def read_table(name: str, way: str, data: Data, reading: Reading) -> Table | None:
    """Values at times that increase."""
    path, source = ("inputs", name, way), reading.source
    values = read(TableForm, data, path, source)
    times = numbers(number(item, (*path, "time", k), source) for k, item in enumerate(values.get("time", ())))
    found = numbers(reading.number(item, (*path, "value", k), name) for k, item in enumerate(values.get("value", ())))
    if times is not None:
        for k in np.flatnonzero(np.diff(times) <= 0.0) + 1:
            source.report((*path, "time", int(k)), f"{times[k]:g} s comes after {times[k - 1]:g} s")
    if not {"time", "value"} <= set(values):
        return None
    if len(values["time"]) != len(values["value"]):
        source.report(path, f"has {len(values['time'])} times, but {len(values['value'])} values")
    elif not values["time"]:
        source.report(path, "has no values")
    return None if times is None or found is None else Table(times, found)


def numbers(values: Iterable[float | None]) -> Array | None:
    """All values, None if one is missing."""
    found = list(values)
    return None if None in found else np.array(found, dtype=float)


def read_file(name: str, values: dict[str, Any], reading: Reading, *, told: bool) -> Table | None:
    """A column of a CSV file beside the run file; *told* whether the column is, rightly or not."""
    path, source = ("inputs", name), reading.source
    if not values["file"].lower().endswith(SUFFIX):
        source.report((*path, "file"), f"expected the name of a {SUFFIX} file, got '{values['file']}'")
        return None
    file = reading.folder / values["file"]
    try:
        there = file.is_file()
    except ValueError:
        # a name that no file can have
        there = False
    if not there:
        source.report(
            (*path, "file"), f"there is no file '{values['file']}' beside the run file: its path starts there"
        )
    if "column" not in values:
        if not told:
            source.report(path, "needs 'column', the name in the file's first line")
        return None
    found = read_column(file, values["column"]) if there else []
    if not isinstance(found, Column):
        source.mistakes += found
        return None
    if found.dimension is not None:
        reading.stated.append(Stated((*path, "column"), name, found.dimension))
    return Table(found.time, found.value)
