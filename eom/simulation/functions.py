"""Any function of time as polynomials piece by piece, as exact as its numbers."""

import itertools
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError, raised
from eom.simulation.pieces import DEGREE

LONGEST = 0.125
"""Piece [s] to begin with: what happens in a shorter time, from nothing to nothing, may be overlooked."""
SHORTEST = 1e-9
"""Piece [s] that is not divided any more: there the function or its slope jumps."""
SMOOTH = 1e-7
"""Jump of value and slope between pieces over the largest value, below which there is none."""
NOISE = 1e-5
"""Largest rounding of a function over its largest value; a smaller jump is none."""
MOST = 1000
"""Pieces per longest piece."""
ACCURATE = 1e-12
"""Error of a piece over the largest value of the function."""
NODES = 0.5 - 0.5 * np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
"""Instants of a piece of length one at which a polynomial takes the function's values: Chebyshev's, ends included."""
BETWEEN = np.array([0.021, 0.217, 0.483, 0.741, 0.967])
"""Instants at which it is compared with the function."""
TO_POWERS = np.linalg.inv(np.vander(NODES, increasing=True))
CHECK = np.vander(BETWEEN, DEGREE + 1, increasing=True) @ TO_POWERS


class Broken(NamedTuple):
    """Pieces of an input.

    Rows as in `eom.simulation.pieces`, the jumps between them [s], until when they hold [s], why not longer, and the
    exception that ended them, if one did.
    """

    rows: Array
    stops: Array
    until: float
    why: str
    cause: Exception | None = None


class Piece(NamedTuple):
    """A piece as tried: where it begins and how long it is [s], the function at `NODES`, its largest error between."""

    begin: float
    length: float
    values: Array
    error: float

    @property
    def finite(self) -> bool:
        """Whether the function gave numbers."""
        return bool(np.isfinite(self.error))


class Watched:
    """A function of time that is not a number where it has none; ``raised`` is the last exception that it raised."""

    def __init__(self, function: Callable[[float], float]) -> None:
        self.function = function
        self.raised: Exception | None = None

    def __call__(self, t: float) -> float:
        """Its value."""
        try:
            return float(self.function(t))
        except Exception as error:  # noqa: BLE001  whatever it is, a sentence tells it
            self.raised = error
            return float("nan")

    def tried(self, begin: float, end: float) -> Piece:
        """A piece of it."""
        length = end - begin
        values = np.array([self(begin + length * node) for node in NODES])
        between = np.array([self(begin + length * node) for node in BETWEEN])
        return Piece(begin, length, values, float(np.max(np.abs(CHECK @ values - between))))

    def halves(self, item: Piece) -> tuple[Piece, Piece]:
        """Both halves of a piece."""
        middle = item.begin + 0.5 * item.length
        return self.tried(item.begin, middle), self.tried(middle, item.begin + item.length)

    def why(self, name: str, t: float) -> str:
        """Why the input is none from an instant on."""
        if self.raised is None:
            return f"input {name} is not finite from {t:.9g} s on"
        return f"input {name} at {t:.9g} s: its function {raised(self.raised)}"


def pieces_of(function: Callable[[float], float], name: str, duration: float) -> Broken:
    """The pieces of a function from 0 to a duration; they end where it gives no finite number, or raises an exception.

    Raises `SimulationError` for a function that jumps too often.
    """
    watched = Watched(function)
    edges = np.append(np.arange(0.0, duration, LONGEST), duration)
    waiting = [watched.tried(begin, end) for begin, end in itertools.pairwise(edges)][::-1]
    largest = max((float(np.max(np.abs(item.values))) for item in waiting if item.finite), default=0.0)
    rows, stops, most = list[Array](), list[float](), MOST * len(waiting)
    while waiting:
        item = waiting.pop()
        if item.error <= ACCURATE * largest:
            rows.append(row(item))
        elif item.length > SHORTEST:
            halves = watched.halves(item)
            # what does not fall on either side is rounding of the function itself
            noise = item.error <= NOISE * largest and min(half.error for half in halves) > 0.5 * item.error
            rows += [row(item)] if noise else []
            waiting += [] if noise else halves[::-1]
        elif item.finite:
            # the jump is at the end of what cannot be divided
            rows.append(row(item._replace(values=np.full(DEGREE + 1, item.values[0]))))
            stops.append(item.begin + item.length)
        else:
            return joined(rows, stops, largest, item.begin, watched.why(name, item.begin), watched.raised)
        if len(rows) + len(waiting) > most:
            told = f"input {name}: its function jumps too often about {item.begin:.6g} s: give it as Steps or as Table"
            raise SimulationError(told)
    return joined(rows, stops, largest, np.inf, "", None)


def row(item: Piece) -> Array:
    """The coefficients of a piece."""
    (found,) = rows_of(np.array([item.begin]), item.length, item.values[np.newaxis])
    return np.asarray(found)


def rows_of(begin: Any, length: float, values: Any) -> Array:
    """Pieces of a length [s] by where they begin [s] and their values at `NODES`, a row a piece."""
    # one by one: a product of all would round a piece as their number has it
    powers = np.matmul(TO_POWERS, values[..., np.newaxis])[..., 0] / length ** np.arange(DEGREE + 1)
    return np.concatenate((begin[:, np.newaxis], powers), axis=1)


def joined(
    rows: list[Array], stops: list[float], largest: float, until: float, why: str, cause: Exception | None
) -> Broken:
    """The pieces found; where one does not go on as the one before ends there is a stop."""
    found = np.array(rows).reshape(-1, DEGREE + 2)
    for before, after in itertools.pairwise(found):
        length = after[0] - before[0]
        powers = length ** np.arange(DEGREE + 1)
        end = before[1:] @ powers
        slope = before[2:] @ (np.arange(1, DEGREE + 1) * powers[:-1])
        if abs(after[1] - end) + length * abs(after[2] - slope) > SMOOTH * largest:
            stops.append(after[0])
    return Broken(found, np.unique(stops), until, why, cause)
