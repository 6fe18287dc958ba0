"""Inputs as polynomials piece by piece: one form for every input, that compiled loops evaluate.

Joints where an input or its slope jumps are stops, at which steps end.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array

DEGREE = 7
"""Of the polynomials."""


class Pieces(NamedTuple):
    """Inputs over time.

    Attributes
    ----------
    base : Array
        What every input is where nothing else is said, (inputs,).
    index : NDArray
        Which input each signal sets, (signals,).
    first : NDArray
        Where the pieces of each signal begin, and the last one's end, (signals + 1,).
    knots : Array
        Where each piece begins [s]; the first one of a signal also stands for the time before.
    coefficients : Array
        By powers of the time since then, (pieces, DEGREE + 1).
    stops : Array
        Instants [s] at which an input or its slope jumps, in order.
    """

    base: Array
    index: NDArray[np.int64]
    first: NDArray[np.int64]
    knots: Array
    coefficients: Array
    stops: Array


def fill_inputs(t: float, before: bool, pieces: Pieces, cursor: Any, u: Any) -> None:
    """Set the inputs at an instant; at a joint to what they are *before* it, or after it."""
    for k in range(len(pieces.index)):
        at, first, last = cursor[k], pieces.first[k], pieces.first[k + 1] - 1
        while at < last and (pieces.knots[at + 1] < t or (pieces.knots[at + 1] == t and not before)):
            at += 1
        while at > first and (pieces.knots[at] > t or (pieces.knots[at] == t and before)):
            at -= 1
        cursor[k] = at
        since, value = t - pieces.knots[at], 0.0
        for power in range(DEGREE, -1, -1):
            value = value * since + pieces.coefficients[at, power]
        u[pieces.index[k]] = value
