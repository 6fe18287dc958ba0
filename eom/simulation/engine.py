"""One run in numbers: memory, inputs, and the loops that go on in it, compiled where there is a compiler."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.program.calls import Calls
from eom.program.compiled import installed
from eom.program.make import Program
from eom.simulation import memory as of
from eom.simulation.advance import KEPT, advance
from eom.simulation.equations import Equations
from eom.simulation.signal_pieces import Driven
from eom.simulation.stiffness import NUDGE

ROOTS: dict[bytes, tuple[float, Array]] = {}
"""Fastest roots of starts that were searched."""
REMEMBERED = 1024
FIRST_STEP = 1e-3
"""Step [s] with which adaptive methods begin."""
ROOM = 64
"""Events for which there is room besides one of each limit, before the loops stop to make more."""


@dataclass
class Engine:
    """A run that goes on; arrays as in `eom.simulation.memory` and `eom.simulation.advance`."""

    calls: Calls
    settings: Array
    clock: Array
    counts: Any
    times: Array
    rows: Array
    room: Array
    events: list[Array]
    at: Any
    v: Array
    work: Array
    driven: Driven

    @property
    def time(self) -> float:
        """The instant that was reached [s]."""
        return float(self.clock[of.TIME])

    @property
    def outputs(self) -> Array:
        """Outputs at the last `observe`."""
        begin = int(self.at[of.RESULTS] + self.at[of.STATES] + self.at[of.LIMITS])
        return self.work[begin : begin + int(self.at[of.OUTPUTS])]

    @property
    def inputs(self) -> Array:
        """Inputs, which may be set where no signal sets them."""
        return self.work[int(self.at[of.U]) : int(self.at[of.U] + self.at[of.INPUTS])]

    @property
    def state(self) -> Array:
        """The state."""
        state: Array = self.v[of.X]
        return state

    def observe(self) -> None:
        """Set inputs and outputs to those at the instant, after jumps of the signals."""
        self.called(looking=True)

    def go_on(self, until: float, pause: float, *, closed: bool) -> int:
        """Go on to an instant, or past a pause; says how it ended. A sample there is left for later if not *closed*."""
        while True:
            self.counts[of.EVENTS] = 0
            status = self.called(looking=False, until=until, pause=pause, closed=closed)
            if self.counts[of.EVENTS]:
                self.events.append(self.room[: self.counts[of.EVENTS]].copy())
            if status != of.FULL:
                return status

    def called(self, **arguments: float) -> int:
        """Call the loops with other arguments."""
        for name, value in arguments.items():
            self.calls.set(name, value)
        with np.errstate(all="ignore"):
            self.calls((0,))
        return int(self.calls.results[0])


def engine(
    equations: Equations,
    x: Array,
    driven: Driven,
    times: Array,
    settings: tuple[int, float, float],
) -> Engine:
    """A run that is about to start at zero in a state, with samples at some *times* [s]."""
    program, parameters = equations.ready
    inputs = len(driven.base)
    at, size = places(program, inputs)
    n, limits, outputs = (int(at[k]) for k in (of.STATES, of.LIMITS, of.OUTPUTS))
    work = np.ones(size)
    work[:inputs] = driven.base
    work[inputs : inputs + len(parameters)] = parameters
    clock, v = beginning(equations, x, driven, settings[1])
    own = {
        "settings": np.array(settings, dtype=float),
        "clock": clock,
        "counts": np.zeros(of.COUNTS, dtype=np.int64),
        "times": times,
        "rows": np.zeros((len(times), n + inputs + outputs)),
        "at": at,
        "v": v,
        "work": work,
    }
    room = np.zeros((room_of(limits), of.EVENT_STATE + n))
    rest = {
        "looking": False,
        "program": program.address if installed() else python_call(program, parameters),
        "until": 0.0,
        "pause": 0.0,
        "closed": False,
        "margins": np.zeros((3, limits)),
        "columns": np.arange(n + inputs + outputs),
        "events": room,
        "terminal": np.array([limit.ends for limit in equations.limits], dtype=bool),
        "pieces": driven.pieces,
        "signals": driven.signals,
        "stops": driven.stops,
        "jacobian": np.zeros((n, n)),
        "factors": np.zeros((n, n)),
        "pivots": np.zeros(n, dtype=np.int64),
    }
    return Engine(calls=Calls(advance, 1, {**own, **rest}), room=room, events=[], driven=driven, **own)


def places(program: Program, inputs: int) -> tuple[Any, int]:
    """Numbers of states, limits, inputs, outputs and where what stands in the program's memory; its size."""
    n, limits, outputs = (len(group) for group in program.plan.roots)
    begins = np.cumsum([0, inputs, len(program.plan.parameters), program.plan.scratch])
    at = np.array([n, limits, inputs, outputs, *begins], dtype=np.int64)
    return at, int(begins[-1]) + n + limits + outputs


def room_of(limits: int) -> int:
    """Events for which there is room: of every limit one may happen at once."""
    return 2 * limits + ROOM


def beginning(equations: Equations, x: Array, driven: Driven, largest: float) -> tuple[Array, Array]:
    """Clock and vectors over the states of a run that starts in a state, with steps up to a largest one [s]."""
    v = np.zeros((of.VECTORS, len(x)))
    v[of.X], v[of.SIZE], v[of.GROWING] = x, equations.size, equations.growing
    clock = np.zeros(of.CLOCK)
    clock[of.STEP], clock[of.AGE], clock[of.METHOD_NOW] = min(FIRST_STEP, largest), KEPT, of.DORMAND_PRINCE
    clock[of.ROOT], v[of.DIRECTION] = fastest_root(equations, x, driven.base)
    return clock, v


def fastest_root(equations: Equations, x: Array, u: Array) -> tuple[float, Array]:
    """Magnitude of the fastest root at a state [1/s], and its direction, (n,); runs from the same start share it."""
    program, parameters = equations.ready
    key = hashlib.sha256(
        b"".join((program.signature.encode(), parameters.tobytes(), x.tobytes(), u.tobytes()))
    ).digest()
    if key not in ROOTS:
        if len(ROOTS) >= REMEMBERED:
            ROOTS.clear()
        ROOTS[key] = searched_root(equations, x, u)
    return ROOTS[key]


def searched_root(equations: Equations, x: Array, u: Array) -> tuple[float, Array]:
    """The same by the eigenvalues of the Jacobian, which differences give."""
    steps = NUDGE * (equations.size + equations.growing * np.abs(x))
    at = equations.ready.results(x, u, 0)
    moved = [equations.ready.results(x + step * row, u, 0) for step, row in zip(steps, np.eye(len(x)), strict=True)]
    slopes = (np.array(moved) - at).T / steps
    if not np.all(np.isfinite(slopes)):
        return 0.0, equations.size.copy()
    values, vectors = np.linalg.eig(slopes)
    fastest = int(np.argmax(np.abs(values)))
    # of a pair any combination, here one with a share of both parts
    own = vectors[:, fastest].real + vectors[:, fastest].imag
    return float(np.abs(values[fastest])), np.asarray(own)


def python_call(program: Program, parameters: Array) -> Callable[..., None]:
    """What `eom.simulation.steps.evaluate` calls where there is no compiler."""
    plain = program.of_numbers(parameters)

    def call(at: Any, v: Array, row: int, work: Array, level: int) -> None:
        """Fill the results."""
        begin = int(at[of.RESULTS])
        try:
            with np.errstate(all="ignore"):
                found = plain(v[row].tolist(), work[int(at[of.U]) : int(at[of.U] + at[of.INPUTS])].tolist(), level)
        except (ValueError, OverflowError, ZeroDivisionError):
            # what NumPy and compiled code answer with numbers that are none
            work[begin:] = np.nan
            return
        work[begin : begin + len(found)] = found

    return call
