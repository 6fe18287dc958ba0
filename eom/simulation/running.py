"""``eom.simulate``: one run of a model, open loop or with sampled blocks."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.model.tyre import TyreModel
from eom.simulation import memory as of
from eom.simulation.blocks import Block
from eom.simulation.channels import Event
from eom.simulation.divergence import DIVERGING, divergence
from eom.simulation.engine import Engine, engine
from eom.simulation.equations import Equations, Model, at_start, check_kind, equations_of, every_name
from eom.simulation.inputs import Input
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.progress import Progress
from eom.simulation.report import Told, run_of, sentence
from eom.simulation.request import Request, check_size, checked
from eom.simulation.run import Run
from eom.simulation.sampling import Held, begun, sample_times, updated
from eom.simulation.signal_pieces import driven
from eom.simulation.wiring import Wiring

SLICE = 0.25
"""Time [s] of the clock on the wall after which a long run lets itself be seen and interrupted."""


def simulate(
    model: Model,
    inputs: Mapping[str, Input],
    duration: float,
    *,
    speed: float | None = None,
    start: Mapping[str, float] | None = None,
    blocks: Sequence[Block] = (),
    wires: Mapping[str, str] | None = None,
    sample: float = 0.01,
    method: str = "automatic",
    step: float | None = None,
    tolerance: float = 1e-6,
) -> Run:
    """Simulate a model from its straight run on.

    Parameters
    ----------
    model : TyreModel or LinearModel
    inputs : Mapping
        Input by name: a number, a function of time [s], or a `Sine`, `Table`, `Steps` or `Constant` of
        `eom.simulation`. Others keep the value of the straight run.
    duration : float
        [s]
    speed : float, optional
        Of the straight run from which to start [m/s]; the vehicle's own by default.
    start : Mapping, optional
        States by name whose values at the start are not those of the straight run.
    blocks : sequence of Block, optional
        Drivers, controllers, sensors: each is called at its own sample times, its ports hold in between.
    wires : Mapping, optional
        Input of the model to the port ``BLOCK.PORT`` that drives it.
    sample : float
        Time between samples of the result [s].
    method : str
        ``automatic``: Dormand and Prince's method, or a Rosenbrock method where the fastest root is stiff; or
        ``dormand_prince``, ``rosenbrock``, ``rk4``.
    step : float, optional
        Fixed step of ``rk4`` [s], largest one of the others.
    tolerance : float
        Error of a step over the size of the states; sizes are 1 m, 0.1 rad, 1 m/s, 0.1 rad/s, 1 kN m, and more
        with the value.

    Returns
    -------
    Run
        Signals with names and units, events, which method ran, and why it ended if before its duration: a roll beyond
        30 deg or an articulation beyond 60 deg.

    Raises
    ------
    SimulationError
        For mistakes in what is asked, all at once, and for a run that cannot go on; ``partial`` is the run until then.
    RunInterrupted
        A KeyboardInterrupt; ``partial`` alike.
    EquilibriumError
        If there is no straight run at the speed.
    """
    check_kind(model)
    asked = checked(model, inputs, duration, speed, start, blocks, wires or {}, sample, method, step, tolerance)
    check_size(1, len(asked.times), len(every_name(model)) + len(asked.wiring.signals), "take fewer samples")
    x, u = at_start(model, speed)
    for name, value in asked.start.items():
        x[model.states.index(name)] = value
    with Progress(f"preparing {name_of(model)}"):
        equations = equations_of(model)
    own = Running(model, equations, asked, begin(model, equations, asked, x, u))
    return own.finished()


def begin(model: Model, equations: Equations, asked: Request, x: Array, u: Array) -> Engine:
    """The run before its first step."""
    signals = driven(asked.inputs, model.inputs, u)
    if signals.until <= 0.0:
        raise SimulationError(f"{signals.why}: nothing can be simulated") from signals.cause
    with Progress(f"compiling {name_of(model)}"):
        return engine(equations, x, signals, asked.times, asked.settings)


class Running(NamedTuple):
    """A run, with what was asked of it."""

    model: Model
    equations: Equations
    asked: Request
    engine: Engine

    def finished(self) -> Run:
        """The run to its end."""
        asked, own = self.asked, self.engine
        held: list[tuple[float, Array]] = []
        until = min(asked.duration, own.driven.until)
        status, why = of.DONE, ""
        diverging: tuple[Event, ...] = ()
        try:
            with Progress(f"simulating {name_of(self.model)}", until) as progress:
                for instant in self.instants(until, held):
                    status = self.to(instant, until, progress)
                    if status != of.DONE:
                        break
        except KeyboardInterrupt:
            self.take_last_sample()
            what = f"interrupted at {own.time:.6g} s"
            raise RunInterrupted(self.run(held, what), what) from None
        except SimulationError as error:
            self.take_last_sample()
            raise SimulationError(str(error), self.run(held, str(error))) from error.__cause__
        if status == of.DONE and until < asked.duration:
            why = own.driven.why
        elif status != of.DONE:
            diverging = self.diverging(status)
            why = sentence(status, own.clock, own.settings, own.events, self.equations.limits, diverging)
        run = self.run(held, why, diverging)
        if why and status != of.TERMINAL:
            raise SimulationError(why, run) from own.driven.cause
        return run

    def take_last_sample(self) -> None:
        """Take the sample at the instant of a mistake, with the inputs as they were before."""
        self.engine.go_on(self.engine.time, self.engine.time, closed=True)

    def to(self, instant: float, until: float, progress: Progress) -> int:
        """Go on to an instant, in slices that let progress be seen; says how it ended."""
        status, closed = of.DONE, instant == until
        while self.engine.time < instant and status == of.DONE:
            status = self.engine.go_on(instant, progress.next_stop(self.engine.time, SLICE), closed=closed)
            progress.reached(self.engine.time)
        return status

    def instants(self, until: float, held: list[tuple[float, Array]]) -> Iterator[float]:
        """The instants to go to: samples of blocks, which are evaluated when they are reached, and the end."""
        wiring, own = self.asked.wiring, self.engine
        if not wiring.blocks:
            yield until
            return
        ports = begun(wiring)
        for time, due in sample_times(wiring):
            if time > 0.0:
                yield min(time, until)
            if time >= until:
                return
            ports = self.sampled(wiring, due, time, ports)
            held.append((time, ports.acting))
            own.inputs[wiring.inputs] = ports.acting[wiring.sources]

    def sampled(self, wiring: Wiring, due: Sequence[int], time: float, ports: Held) -> Held:
        """What the blocks' ports hold after a sample."""
        own = self.engine
        own.observe()
        return updated(wiring, due, time, np.concatenate((own.outputs, own.inputs, own.state)), ports)

    def diverging(self, status: int) -> tuple[Event, ...]:
        """The event of a motion that cannot be followed any more."""
        own = self.engine
        if status not in DIVERGING:
            return ()
        memory = own.time, own.at, own.v, own.work, own.driven.pieces, own.driven.signals
        return (divergence(self.equations.ready, self.model.states, *memory),)

    def run(self, held: list[tuple[float, Array]], ended: str, diverging: tuple[Event, ...] = ()) -> Run:
        """What was computed until now."""
        told = Told(self.model, self.equations.limits, self.asked, self.engine, held, diverging)
        return run_of(told, ended)


def name_of(model: Model) -> str:
    """The name of the vehicle."""
    return model.vehicle.name if isinstance(model, TyreModel) else model.name
