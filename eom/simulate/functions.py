"""Any function of time as polynomials piece by piece, as exact as its numbers."""

import itertools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.simulate.pieces import DEGREE

LONGEST = 0.125
"""Piece [s] to begin with: what happens in a shorter time, from nothing to nothing, may be overlooked."""
SHORTEST = 1e-9
"""Piece [s] that is not divided any more: there the function or its slope jumps."""
SMOOTH = 1e-7
"""Jump of value and slope between pieces over the largest value, below which there is none."""
ACCURATE = 1e-12
"""Error of a piece over the largest value of the function."""
NODES = 0.5 - 0.5 * np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
"""Instants of a piece of length one at which a polynomial takes the function's values: Chebyshev's, ends included."""
BETWEEN = np.array([0.021, 0.217, 0.483, 0.741, 0.967])
"""Instants at which it is compared with the function."""
TO_POWERS = np.linalg.inv(np.vander(NODES, increasing=True))
CHECK = np.vander(BETWEEN, DEGREE + 1, increasing=True) @ TO_POWERS


class Broken(NamedTuple):
    """Pieces, rows as in `eom.simulate.pieces`, the jumps between them [s], until when they hold [s], and why."""

    rows: Array
    stops: Array
    until: float
    why: str


def pieces_of(function: Callable[[float], float], name: str, duration: float) -> Broken:
    """The pieces of a function from 0 to a duration; where it gives no finite number they end.

    Raises `SimulationError` naming the input and the time if the function raises an exception.
    """
    rows: list[Array] = []
    stops: list[float] = []
    largest = 0.0

    def at(t: float) -> float:
        """The function at an instant."""
        try:
            return float(function(t))
        except Exception as error:
            message = f"input {name} at {t:g} s: its function raised {type(error).__name__}: {error}"
            raise SimulationError(message) from error

    waiting = [(k * LONGEST, min((k + 1) * LONGEST, duration)) for k in range(int(np.ceil(duration / LONGEST)))][::-1]
    while waiting:
        begin, end = waiting.pop()
        length = end - begin
        values = np.array([at(begin + length * node) for node in NODES])
        if not np.all(np.isfinite(values)):
            if length > SHORTEST:
                waiting += [(begin + 0.5 * length, end), (begin, begin + 0.5 * length)]
                continue
            return finished(rows, stops, largest, begin, f"input {name} is not finite from {begin:.9g} s on")
        largest = max(largest, float(np.max(np.abs(values))))
        between = np.array([at(begin + length * node) for node in BETWEEN])
        error = np.abs(CHECK @ values - between)
        if length > SHORTEST and not np.all(error <= ACCURATE * largest):
            waiting += [(begin + 0.5 * length, end), (begin, begin + 0.5 * length)]
        elif length > SHORTEST:
            rows.append(row(begin, length, values))
        else:
            # the jump is at the end of what cannot be divided
            rows.append(row(begin, length, np.full(DEGREE + 1, values[0])))
            stops.append(end)
    return finished(rows, stops, largest, np.inf, "")


def row(begin: float, length: float, values: Array) -> Array:
    """A piece by its values at `NODES`."""
    return np.concatenate(([begin], TO_POWERS @ values / length ** np.arange(DEGREE + 1)))


def finished(rows: list[Array], stops: list[float], largest: float, until: float, why: str) -> Broken:
    """The pieces found; where one does not go on as the one before ends there is a stop."""
    found = np.array(rows).reshape(-1, DEGREE + 2)
    for before, after in itertools.pairwise(found):
        length = after[0] - before[0]
        powers = length ** np.arange(DEGREE + 1)
        end = before[1:] @ powers
        slope = before[2:] @ (np.arange(1, DEGREE + 1) * powers[:-1])
        if abs(after[1] - end) + length * abs(after[2] - slope) > SMOOTH * largest:
            stops.append(after[0])
    return Broken(found, np.unique(stops), until, why)
