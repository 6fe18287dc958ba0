"""A run as text: what ran, why it ended, which limits were reached, and its signals in a table."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.report.table import table
from eom.simulation.channels import Channels, owner_and_quantity
from eom.simulation.run import Run
from eom.simulation.run_panels import units_in

DEGREE = {"rad": "deg", "rad/s": "deg/s", "rad/s^2": "deg/s^2"}
DIGITS = 4
"""Of the largest value: between two samples a peak is missed by little less."""
NOTHING = 1e-9
"""Values in SI units that are below the error of an integration by far."""
OF_UNITS = ("ay", "yaw_rate", "articulation", "roll", "ltr", "speed")
"""Quantities that are told, in this order."""
SENSOR = "sensor"
"""Stands for outputs of no object: only the vehicle's author knows what they are for."""


class Line(NamedTuple):
    """A signal of the table: its name, unit, values (n,), and which sample is told of it."""

    name: str
    unit: str
    values: Array
    told: int


def report(run: Run, speed: float) -> str:
    """What a run did, with the speed [m/s] it started from; 0 for a vehicle without."""
    at = f" at {speed * 3.6:.5g} km/h" if speed else ""
    head = [f"{run.name}{at}: {run.time[-1]:.6g} s", run.method]
    if run.ended:
        head.append(f"ended early: {run.ended}")
    blocks = ["\n".join(head)]
    if run.events:
        blocks.append("\n".join(["events", *map(str, run.events)]))
    moving, still = motions(run.outputs)
    shown = [*acting(run.inputs), *moving, *lightest(run.outputs)]
    shown += [largest(run.blocks, k) for k in range(len(run.blocks.names))]
    blocks.append(signal_table(run, shown))
    if still:
        blocks.append(f"zero throughout: {', '.join(still)}")
    return "\n\n".join(blocks)


def signal_table(run: Run, lines: Iterable[Line]) -> str:
    """Largest value of signals with its sign and time, and the last value; angles in degrees."""
    header = ("signal", "unit", "largest", "at [s]", f"at {run.time[-1]:.6g} s")
    rows = []
    for line in lines:
        factor = float(np.degrees(1.0)) if line.unit in DEGREE else 1.0
        values = factor * line.values
        places = decimals(np.nanmax(np.abs(values), initial=0.0))
        told, last = (fixed(float(value), places) for value in (values[line.told], values[-1]))
        moves = bool(np.any(line.values != line.values[0]))
        time = f"{run.time[line.told]:.6g}" if moves else "-"
        rows.append((line.name, DEGREE.get(line.unit, line.unit) or "-", told, time, last))
    return table(header, rows, 2)


def largest(group: Channels, k: int, name: str = "") -> Line:
    """A signal with the sample at which it is largest; what is below any error counts as zero."""
    values = np.where(np.abs(group.values[:, k]) < NOTHING, 0.0, group.values[:, k])
    return Line(name or group.names[k], group.units[k], values, int(np.argmax(np.nan_to_num(np.abs(values), nan=-1.0))))


def acting(inputs: Channels) -> Iterator[Line]:
    """Inputs that are not zero throughout; those that are the same, such as pressures of brakes, on one line."""
    alike: dict[tuple[str, bytes], list[int]] = {}
    for k in np.flatnonzero(np.any(inputs.values != 0.0, axis=0)):
        alike.setdefault((inputs.units[k], inputs.values[:, k].tobytes()), []).append(int(k))
    for first, *others in alike.values():
        more = f" and {len(others)} alike" if others else ""
        yield largest(inputs, first, inputs.names[first] + more)


def motions(outputs: Channels) -> tuple[list[Line], list[str]]:
    """Of a vehicle with units what its units do and its sensors show, of others all; and which quantities do not move.

    On a straight run most do not.
    """
    units = units_in(outputs)
    if not units:
        return [largest(outputs, k) for k in range(len(outputs.names))], []
    found: dict[str, list[Line]] = {quantity: [] for quantity in (*OF_UNITS, SENSOR)}
    for k, name in enumerate(outputs.names):
        owner, quantity = owner_and_quantity(name)
        if not owner:
            found[SENSOR].append(largest(outputs, k))
        elif quantity in OF_UNITS and (owner in units or quantity == "roll"):
            found[quantity].append(largest(outputs, k))
    still = [
        quantity for quantity in OF_UNITS if found[quantity] and not any(np.any(a.values) for a in found[quantity])
    ]
    return [line for quantity, group in found.items() if quantity not in still for line in group], still


def lightest(outputs: Channels) -> Iterator[Line]:
    """The wheel, or axle without a track, whose load becomes smallest, where there is one."""
    owners = [name.removesuffix(".alpha") for name in outputs.names if name.endswith(".alpha")]
    loads = [outputs.names.index(f"{owner}.Fz") for owner in owners if f"{owner}.Fz" in outputs.names]
    if loads:
        values = outputs.values[:, loads]
        told, wheel = np.unravel_index(int(np.argmin(np.nan_to_num(values, nan=np.inf))), values.shape)
        k = loads[int(wheel)]
        yield Line(f"smallest load, {outputs.names[k]}", outputs.units[k], outputs.values[:, k], int(told))


def decimals(size: float) -> int:
    """Decimals with which a number of a size has `DIGITS` digits at least."""
    return max(0, DIGITS - 1 - int(np.floor(np.log10(size)))) if size > 0.0 and np.isfinite(size) else 0


def fixed(value: float, places: int) -> str:
    """A number with some decimals; ``-`` where there is none."""
    return "-" if np.isnan(value) else f"{round(value, places) + 0.0:.{places}f}"
