"""Inputs over time, as a run is told them."""

from collections.abc import Callable
from dataclasses import dataclass

from eom.assembly.vectors import Array


@dataclass(frozen=True)
class Constant:
    """One value throughout."""

    value: float


@dataclass(frozen=True)
class Sine:
    """Cycles of a sine from a start on, zero before and after; amplitude in the input's unit, frequency in Hz, s."""

    amplitude: float
    frequency: float
    start: float = 0.0
    cycles: float = 1.0


@dataclass(frozen=True)
class Table:
    """Values at instants [s], straight lines between; both (n,). It holds between the first and the last one."""

    time: Array
    value: Array


@dataclass(frozen=True)
class Steps:
    """Values from instants [s] on, each held until the next, zero before the first; both (n,)."""

    time: Array
    value: Array


Input = Constant | Sine | Table | Steps | Callable[[float], float] | float
"""How an input changes over time: one of the above, a function of time [s], or a constant."""
