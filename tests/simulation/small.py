"""Small problems for the loops of the integrators, compiled or in plain Python."""

import hashlib
import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from eom.program.compiled import without_compiler
from eom.program.make import ready
from eom.simulation import memory as of
from eom.simulation.engine import Engine, engine
from eom.simulation.equations import Equations
from eom.simulation.inputs import Input
from eom.simulation.signal_pieces import Driven, driven, told
from eom.splice.limits import Limit

Array = NDArray[np.float64]
Equation = Callable[[Any, Any, Any], tuple[Any, Any, Any]]
"""Rates, margins and outputs of states, inputs and numbers; for numbers as for nodes of a tape."""


def python_program(equation: Equation) -> Callable[..., None]:
    """What `eom.simulation.steps.evaluate` calls."""

    def call(at: Any, v: Any, row: int, work: Any, _level: int) -> None:
        begin, u = int(at[of.RESULTS]), int(at[of.U])
        found = np.concatenate(equation(v[row], work[u : u + int(at[of.INPUTS])], None))
        work[begin : begin + len(found)] = found

    return call


def named_for_its_text(equation: Equation) -> Equation:
    """The same under a name that changes with its text: the cache knows what is outside the package by name only."""

    def same(x: Any, u: Any, numbers: Any) -> tuple[Any, Any, Any]:
        return equation(x, u, numbers)

    same.__qualname__ = hashlib.sha256(inspect.getsource(equation).encode()).hexdigest()
    return same


def problem(
    equation: Equation,
    x: Sequence[float],
    inputs: Mapping[str, Input],
    times: Sequence[float] | Array,
    settings: tuple[int, float, float],
    ends: Sequence[bool] = (),
    *,
    names: tuple[str, ...] = ("u",),
    compiled: bool = False,
) -> Engine:
    """A run of states of size one; limit k is named ``limit_k``, and *ends* says which end the run."""
    start = np.array(x, dtype=float)
    limits = tuple(Limit("limit", f"limit_{k}", "it is crossed", ends=own) for k, own in enumerate(ends))
    size = np.ones(len(start))
    # no number of these is used, but programs are made for some
    made = ready(named_for_its_text(equation), (np.array([2.0]),), len(start), len(names))
    equations = Equations(made, limits, size, size)
    signals = driven(
        {name: told(item, name, float(times[-1])) for name, item in inputs.items()}, names, np.zeros(len(names))
    )
    if compiled:
        return engine(equations, start, signals, np.array(times, dtype=float), settings)
    with without_compiler():
        found = engine(equations, start, signals, np.array(times, dtype=float), settings)
    found.calls.set("program", python_program(equation))
    return found


def states(found: Engine) -> Array:
    """The states at the samples that were taken."""
    return np.asarray(found.rows[: int(found.counts[of.SAMPLES]), : len(found.state)])


def events(found: Engine) -> Array:
    """Time, limit and whether it was reached, a row an event."""
    rows = [part[:, : of.EVENT_STATE] for part in found.events]
    return np.concatenate([np.empty((0, of.EVENT_STATE)), *rows])


class Memory:
    """The arrays that a step needs, filled for a state at an instant."""

    def __init__(self, equation: Equation, x: Sequence[float], signals: Driven) -> None:
        n, inputs = len(x), len(signals.base)
        self.program = python_program(equation)
        self.at = np.array([n, 0, inputs, 0, 0, inputs, inputs, inputs])
        self.v = np.zeros((of.VECTORS, n))
        self.v[of.X], self.v[of.SIZE], self.v[of.GROWING] = x, 1.0, 1.0
        self.work = np.zeros(inputs + n)
        self.signals = signals

    @property
    def rest(self) -> tuple[Any, ...]:
        """The last arguments of all loops."""
        return self.at, self.v, self.work, self.signals.pieces, self.signals.signals
