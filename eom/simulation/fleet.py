"""Many runs in numbers: the memory of all cases, and how they go on, compiled in threads, or in NumPy all at once."""

import functools
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.program.calls import Calls, Each
from eom.program.compiled import installed
from eom.program.make import Program, Ready
from eom.program.plain import OverCases
from eom.simulation import memory as of
from eom.simulation.channels import Event
from eom.simulation.divergence import DIVERGING, divergence
from eom.simulation.lanes import Lanes
from eom.simulation.report import sentence
from eom.simulation.signal_pieces import Driven
from eom.splice.limits import Limit

PARTS = 8
"""Parts for each thread, so that one that has long cases does not keep the others waiting for all of them."""


@dataclass
class Fleet:
    """Runs that go on together, each for itself; arrays as in `eom.simulation.advance`, cases first."""

    program: Program
    parameters: Array
    settings: Array
    clock: Array
    counts: Any
    margins: Array
    times: Array
    columns: Any
    rows: Array
    events: list[list[Array]]
    terminal: Any
    at: Any
    v: Array
    work: Array
    pieces: Array
    signals: Any
    stops: Array
    stops_first: Any
    status: Any
    room: Array
    calls: Calls
    inputs: Sequence[Driven]
    threads: int

    @property
    def until(self) -> Array:
        """Until when the inputs of each case hold [s]."""
        return np.array([item.until for item in self.inputs])

    @property
    def time(self) -> float:
        """The instant that the slowest case that goes on has reached [s]; the last one if none does."""
        reached, going = self.clock[:, of.TIME], self.going(np.inf)
        return float(np.min(reached[going]) if np.any(going) else np.max(reached))

    def going(self, instant: float) -> Any:
        """Which cases have not ended and are before an instant [s], (cases,)."""
        return (self.status == of.DONE) & (self.clock[:, of.TIME] < np.minimum(instant, self.until))

    def go_on(self, instant: float, pause: float, *, closed: bool) -> None:
        """Go on with all cases that have not ended, until an instant [s] or the end of a case's inputs, or a pause."""
        until = np.minimum(instant, self.until)
        ends = closed | (self.until <= instant)
        for name, value in {"looking": False, "until": Each(until), "pause": pause, "closed": Each(ends)}.items():
            self.calls.set(name, value)
        while True:
            self.counts[:, of.EVENTS] = 0
            try:
                self.some(functools.partial(self.advance, until=until, pause=pause, closed=ends))
            finally:
                # also of what is interrupted
                for c in np.flatnonzero(self.counts[:, of.EVENTS]):
                    self.events[c].append(self.room[c, : self.counts[c, of.EVENTS]].copy())
            full = self.status == of.FULL
            if not np.any(full):
                return
            self.status[full] = of.DONE

    def advance(self, cases: Any, until: Array, pause: float, closed: Any) -> None:
        """Go on with some cases."""
        if self.in_lanes:
            with np.errstate(all="ignore"):
                Lanes(self).go_on(until, pause, closed)
            return
        going = cases[(self.status[cases] == of.DONE) & (self.clock[cases, of.TIME] < until[cases])]
        with np.errstate(all="ignore"):
            self.calls(going)
        self.status[going] = self.calls.results[going]

    def observe(self) -> Array:
        """Outputs, inputs and states of all cases at their instants, (signals, cases)."""
        if not installed():
            with np.errstate(all="ignore"):
                return Lanes(self).observe()
        n, limits, inputs, outputs, first, _, _, results = map(int, self.at)
        self.calls.set("looking", value=True)
        self.some(self.calls)
        begin = results + n + limits
        every = self.work[:, begin : begin + outputs], self.work[:, first : first + inputs], self.v[:, of.X]
        return np.concatenate(every, axis=1).T

    def diverging(self, case: int, states: Sequence[str]) -> tuple[Event, ...]:
        """The event of a case whose motion cannot be followed any more."""
        if self.status[case] not in DIVERGING:
            return ()
        ready = Ready(self.program, np.ascontiguousarray(self.parameters[:, case]))
        memory = self.at, self.v[case], self.work[case], self.pieces, self.signals[case]
        return (divergence(ready, states, float(self.clock[case, of.TIME]), *memory),)

    def ended(self, case: int, duration: float, limits: tuple[Limit, ...], diverging: tuple[Event, ...]) -> str:
        """Why a case ended before a duration [s], a sentence; empty if it did not."""
        status, at = int(self.status[case]), self.clock[case, of.TIME]
        if status != of.DONE:
            return sentence(status, self.clock[case], self.settings, self.events[case], limits, diverging)
        until = self.inputs[case].until
        return self.inputs[case].why if until <= at and until < duration else ""

    @functools.cached_property
    def over_cases(self) -> OverCases:
        """The program for all cases at once in NumPy."""
        return self.program.of_arrays(self.parameters)

    @property
    def in_lanes(self) -> bool:
        """Whether all cases go on side by side in NumPy."""
        return not installed() and int(self.settings[of.METHOD]) == of.RUNGE_KUTTA

    def some(self, task: Callable[[Any], None]) -> None:
        """Do a task with all cases, some at a time in threads; how many makes no difference to any case."""
        cases = np.arange(len(self.clock))
        if not installed() or self.threads == 1:
            task(cases)
            return
        try:
            list(self.pool.map(task, np.array_split(cases, min(PARTS * self.threads, len(cases)))))
        except BaseException:
            # nothing may go on while it is told what there is
            self.close()
            raise

    @functools.cached_property
    def pool(self) -> ThreadPoolExecutor:
        """The threads, which start when there is something to do."""
        return ThreadPoolExecutor(self.threads)

    def close(self) -> None:
        """Wait for what threads do, and end them."""
        self.pool.shutdown(cancel_futures=True)
