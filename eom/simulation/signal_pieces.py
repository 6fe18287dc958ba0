"""Each way to tell an input as pieces of polynomials."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.simulation.functions import NODES as INNER
from eom.simulation.functions import SHORTEST, Broken, pieces_of, rows_of
from eom.simulation.inputs import Constant, Input, Sine, Steps, Table
from eom.simulation.kinds import are_numbers, is_number
from eom.simulation.pieces import DEGREE

PER_CYCLE = 24
"""Pieces of a cycle of a sine: its polynomials are as exact as their coefficients are rounded, 7e-12 of it."""
MOST = 2_400_000
"""Pieces of a sine."""
AFTER = np.inf
"""Until when an input holds that never ends."""


class Driven(NamedTuple):
    """Inputs of a run.

    Attributes
    ----------
    base : Array
        What is constant, (inputs,).
    pieces, signals, stops : Array
        Of what is not, see `eom.simulation.pieces`; instants at which a value or a slope jumps [s].
    until : float
        Until when all of them hold [s].
    why : str
        Which ends there, and why; ``cause`` is the exception that did it, if one did.
    """

    base: Array
    pieces: Array
    signals: NDArray[np.int64]
    stops: Array
    until: float
    why: str
    cause: Exception | None


def driven(inputs: Mapping[str, float | Broken], names: tuple[str, ...], base: Array) -> Driven:
    """Inputs by name, constants or pieces, together; *base* are those of the start."""
    base, begin, signals = base.copy(), 0, []
    changing = {name: item for name, item in inputs.items() if isinstance(item, Broken)}
    for name, value in inputs.items():
        if not isinstance(value, Broken):
            base[names.index(name)] = value
    for name, own in changing.items():
        signals.append((names.index(name), begin, begin + len(own.rows) - 1, begin))
        begin += len(own.rows)
    last = min(changing.values(), key=lambda own: own.until, default=None)
    return Driven(
        base,
        np.concatenate([np.empty((0, DEGREE + 2)), *(own.rows for own in changing.values())]),
        np.array(signals, dtype=np.int64).reshape(-1, 4),
        np.unique(np.concatenate([np.empty(0), *(own.stops for own in changing.values())])),
        AFTER if last is None else last.until,
        "" if last is None else last.why,
        None if last is None else last.cause,
    )


def told(item: Input, name: str, duration: float) -> float | Broken:
    """An input as a constant or as pieces; raises `SimulationError` for one that cannot be."""
    match item:
        case Sine():
            return sine(item, name, duration)
        case Table():
            return table(item, name)
        case Steps():
            return steps(item, name)
        case Constant():
            return constant(item.value, name)
        case _ if callable(item):
            return pieces_of(item, name, duration)
        case _ if is_number(item):
            return constant(item, name)
    expected = "a number, a function of time, or one of Constant, Sine, Table, Steps"
    raise SimulationError(f"input {name} is of type {type(item).__name__}: expected {expected}")


def constant(item: Any, name: str) -> float:
    """The value of what does not change."""
    if not (is_number(item) and np.isfinite(item)):
        raise SimulationError(f"input {name} is {item!r}, expected a finite number")
    return float(item)


def sine(item: Sine, name: str, duration: float) -> Broken:
    """A sine: nothing, pieces of its cycles, nothing; pieces that begin after the duration are left out."""
    finite = all(is_number(value) and np.isfinite(value) for value in vars(item).values())
    if not (finite and item.frequency > 0.0 and item.cycles > 0.0):
        raise SimulationError(f"input {name}: expected a sine of finite numbers, frequency and cycles above zero")
    count = int(np.ceil(item.cycles * PER_CYCLE))
    length = item.cycles / item.frequency / count
    needed = max(min((duration - item.start) / max(length, SHORTEST), float(count)), 0.0)
    if needed > MOST:
        told = f"{needed / PER_CYCLE:.3g} cycles until {duration:g} s, expected at most {MOST // PER_CYCLE}"
        raise SimulationError(f"input {name}: {told}")
    k = np.arange(np.ceil(needed))
    values = item.amplitude * np.sin(2.0 * np.pi * item.cycles * (k[:, np.newaxis] + INNER) / count)
    end = item.start + item.cycles / item.frequency
    rows = np.zeros((len(k) + 2, DEGREE + 2))
    rows[0, 0], rows[-1, 0] = item.start - 1.0, end
    rows[1:-1] = rows_of(item.start + k * length, length, values)
    return Broken(rows if len(k) == count else rows[:-1], np.array([item.start, end]), AFTER, "")


def checked(item: Table | Steps, name: str) -> tuple[Array, Array]:
    """Instants and values as arrays of the same length, the instants growing."""
    if not (are_numbers(item.time) and are_numbers(item.value)):
        raise SimulationError(f"input {name}: expected rows of numbers as times and values")
    time, value = np.asarray(item.time, dtype=float), np.asarray(item.value, dtype=float)
    if time.ndim != 1 or time.shape != value.shape or not time.size:
        raise SimulationError(f"input {name}: expected as many times as values, got {time.shape} and {value.shape}")
    wrong = np.flatnonzero(~(np.diff(time) > 0.0))
    if not np.all(np.isfinite(time)) or wrong.size:
        at = int(wrong[0]) + 1 if wrong.size else int(np.flatnonzero(~np.isfinite(time))[0])
        raise SimulationError(f"input {name}: expected times that grow, got {time[at]} at place {at}")
    return time, value


def finite_part(time: Array, value: Array, name: str) -> tuple[Array, Array, float, str]:
    """What comes before the first value that is no finite number, when it ends, and the sentence about it."""
    wrong = np.flatnonzero(~np.isfinite(value))
    if not wrong.size:
        return time, value, AFTER, ""
    first = int(wrong[0])
    until = float(time[first - 1]) if first else -AFTER
    return time[:first], value[:first], until, f"input {name} is {value[first]} at {time[first]:.9g} s"


def table(item: Table, name: str) -> Broken:
    """Straight lines, from the first instant to the last."""
    time, value = checked(item, name)
    if time[0] > 0.0:
        raise SimulationError(f"input {name} begins at {time[0]:g} s: expected a table from 0 s on")
    time, value, until, why = finite_part(time, value, name)
    if not why:
        until, why = float(time[-1]), f"input {name} ends at {time[-1]:.9g} s"
    rows = np.zeros((max(len(time) - 1, 1), DEGREE + 2))
    if len(time) > 1:
        rows[:, 0], rows[:, 1], rows[:, 2] = time[:-1], value[:-1], np.diff(value) / np.diff(time)
    return Broken(rows, time[1:-1], until, why)


def steps(item: Steps, name: str) -> Broken:
    """Values that are held."""
    every, _ = checked(item, name)
    time, value, until, why = finite_part(*checked(item, name), name)
    if why:
        # what is there before is held up to the wrong value
        until = float(every[len(time)])
    rows = np.zeros((len(time) + 1, DEGREE + 2))
    rows[0, 0] = (time[0] if len(time) else 0.0) - 1.0
    rows[1:, 0], rows[1:, 1] = time, value
    return Broken(rows, time, until, why)
