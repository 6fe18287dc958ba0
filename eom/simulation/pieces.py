"""Inputs as polynomials piece by piece: one form of every input, which compiled loops evaluate."""

from typing import Any

from eom.simulation.memory import U

DEGREE = 7
"""Of the polynomials. A row of *pieces* holds the instant [s] where one begins and its coefficients, lowest power
first, by the time since then; the first piece of a signal also stands for the time before."""
INPUT, FIRST, LAST, CURSOR = range(4)
"""Columns of *signals*: the input that one sets, its first and last piece, the one that was used last."""


def fill_inputs(t: float, before: bool, at: Any, work: Any, pieces: Any, signals: Any) -> None:
    """Set the inputs at an instant; at a joint to what they are *before* it, or after it."""
    for k in range(len(signals)):
        piece, first, last = signals[k, CURSOR], signals[k, FIRST], signals[k, LAST]
        while piece < last and (pieces[piece + 1, 0] < t or (pieces[piece + 1, 0] == t and not before)):
            piece += 1
        while piece > first and (pieces[piece, 0] > t or (pieces[piece, 0] == t and before)):
            piece -= 1
        signals[k, CURSOR] = piece
        since, value = t - pieces[piece, 0], 0.0
        for power in range(DEGREE, -1, -1):
            value = value * since + pieces[piece, 1 + power]
        work[at[U] + signals[k, INPUT]] = value
