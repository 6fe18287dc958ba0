"""``eom.simulate_many``: many cases of one model at once; parameters, inputs, starts and speeds differ."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import EquilibriumError, SimulationError
from eom.model.tyre import TyreModel, build_tyre_model
from eom.program.make import Program, program
from eom.program.numbers import gathered
from eom.simulation import memory as of
from eom.simulation.blocks import Block
from eom.simulation.channels import STATE
from eom.simulation.equations import Equations, Model, at_start, check_kind, equations_of
from eom.simulation.fleet import Fleet, fleet
from eom.simulation.functions import Broken
from eom.simulation.inputs import Input
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.progress import Progress
from eom.simulation.report import events
from eom.simulation.request import Request, checked
from eom.simulation.runs import Runs
from eom.simulation.sampling import begun, sample_times, updated
from eom.simulation.signal_pieces import driven
from eom.splice.equations import spliced
from eom.vehicle.validate import did_you_mean

SLICE = 0.5
"""Time [s] of the clock on the wall after which long runs let themselves be seen and interrupted."""
LARGEST = 4e9
"""Bytes that results of a batch may take."""


@dataclass(frozen=True)
class Case:
    """What is different in a case: inputs, states at the start, speed [m/s], parameters of the vehicle, by name."""

    inputs: Mapping[str, Input] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    speed: float | None = None
    parameters: Mapping[str, str | float] = field(default_factory=dict)


def simulate_many(
    model: Model,
    cases: Sequence[Case],
    duration: float,
    *,
    keep: Sequence[str] | None = None,
    blocks: Sequence[Block] = (),
    wires: Mapping[str, str] | None = None,
    sample: float = 0.01,
    method: str = "automatic",
    step: float | None = None,
    tolerance: float = 1e-6,
    threads: int | None = None,
) -> Runs:
    """Simulate many cases of one model; what a case gives depends on no other.

    With numba cases run in threads. Without it method ``rk4`` runs all of them at once in NumPy, others one by one.

    Parameters
    ----------
    model : TyreModel or LinearModel
    cases : sequence of Case
    duration, sample, method, step, tolerance
        As of `simulate`.
    keep : sequence of str, optional
        Signals to keep: outputs, inputs, ``state:NAME``; all of them if none are named.
    blocks, wires
        As of `simulate`; every block serves all cases: it gets and gives arrays (signals, cases), and its parameters
        may be arrays over the cases.
    threads : int, optional
        As many as there are cores if not given.

    Raises
    ------
    SimulationError
        For every mistake in what is asked, with the number of the case, and for a block that fails; ``partial`` is what
        was computed until then.
    RunInterrupted
        A KeyboardInterrupt; ``partial`` alike.
    DescriptionError, EquilibriumError
        If the parameters of a case make no vehicle, or one without straight run.
    """
    check_kind(model)
    names = every_name(model)
    mistakes = [
        f"keep {name}: there is no such signal{did_you_mean(name, names)}" for name in keep or () if name not in names
    ]
    if threads is not None and threads < 1:
        mistakes.append(f"threads = {threads}: expected one or more")
    asked = requests(
        model,
        cases,
        mistakes,
        lambda own: checked(
            model, own.inputs, duration, own.start, blocks, wires or {}, sample, method, step, tolerance
        ),
    )
    one = asked[0]
    columns = range(len(names)) if keep is None else [names.index(name) for name in keep]
    size = 8.0 * len(cases) * len(one.times) * len(columns)
    if size > LARGEST:
        raise SimulationError(
            f"results of {size / 1e9:.3g} GB, expected at most {LARGEST / 1e9:g}: name the signals to keep, take fewer "
            "samples, or fewer cases at a time"
        )
    with Progress(f"preparing {len(cases)} cases"):
        ready = prepared(model, cases, asked, columns, threads)
    kept = [(k, names[k]) for k in columns]
    held: list[tuple[float, Array]] = []
    try:
        go_through(ready, one, held)
    except KeyboardInterrupt:
        raise RunInterrupted(told(model, one, ready, kept, held), f"interrupted at {ready.time:.6g} s") from None
    except SimulationError as error:
        raise SimulationError(str(error), told(model, one, ready, kept, held)) from error.__cause__
    finally:
        ready.close()
    return told(model, one, ready, kept, held)


def requests(
    model: Model, cases: Sequence[Case], mistakes: list[str], request: Callable[[Case], Request]
) -> list[Request]:
    """What is asked in each case; raises `SimulationError` with all mistakes, of some cases with their numbers."""
    found: list[Request] = []
    wrong: dict[str, list[int]] = {}
    if not cases:
        mistakes.append("cases: expected one or more")
    for k, case in enumerate(cases):
        lines = list(case_mistakes(model, case))
        try:
            found.append(request(case))
            lines += [f"{item.why}: nothing can be simulated" for item in ended_at_once(found[-1])]
        except SimulationError as error:
            lines += str(error).splitlines()
        for line in lines:
            wrong.setdefault(line, []).append(k)
    for line, where in wrong.items():
        mistakes += [line] if len(where) == len(cases) > 1 else [f"case {k}: {line}" for k in where]
    if mistakes:
        raise SimulationError("\n".join(mistakes))
    return found


def case_mistakes(model: Model, case: Case) -> Iterator[str]:
    """What a case asks of a linear model that it does not have."""
    if isinstance(model, TyreModel):
        return
    if case.parameters:
        yield "a linear model has no parameters: give models with tyres, or linearise each case"
    if case.speed is not None:
        yield f"speed = {case.speed:g} m/s: a linear model has that of its trim, {model.speed:g} m/s"


def ended_at_once(asked: Request) -> list[Broken]:
    """Inputs that end where the run begins."""
    return [item for item in asked.inputs.values() if isinstance(item, Broken) and item.until <= 0.0]


def every_name(model: Model) -> list[str]:
    """What can be kept, in the order of the columns: states, inputs, outputs."""
    return [*(STATE + name for name in model.states), *model.inputs, *model.outputs]


def prepared(
    model: Model, cases: Sequence[Case], asked: Sequence[Request], columns: Sequence[int], threads: int | None
) -> Fleet:
    """All cases before their first step."""
    models = models_of(model, cases)
    for k, own in enumerate(models):
        if own.states != model.states or own.inputs != model.inputs or own.outputs != model.outputs:
            what = (
                "its parameters change the structure, so that states, inputs or outputs are others: simulate it apart"
            )
            raise SimulationError(f"case {k}: {what}")
    equations = equations_of(model)
    made, parameters = parameters_of(model, models, equations)
    starts, inputs = [], []
    for k, (own, case) in enumerate(zip(models, asked, strict=True)):
        try:
            x, u = at_start(own, cases[k].speed)
        except EquilibriumError as error:
            raise EquilibriumError(f"case {k}: {error}") from None
        inputs.append(driven(case.inputs, model.inputs, u))
        for name, value in case.start.items():
            x[model.states.index(name)] = value
        starts.append(x)
    ready = equations._replace(ready=equations.ready._replace(program=made))
    return fleet(
        ready, parameters, starts, inputs, asked[0].times, np.array(columns, dtype=np.int64), asked[0].settings, threads
    )


def models_of(model: Model, cases: Sequence[Case]) -> list[Model]:
    """The model of each case; those with the same parameters share it."""
    made: dict[tuple[tuple[str, str | float], ...], Model] = {(): model}
    for case in cases:
        key = tuple(sorted(case.parameters.items()))
        if key not in made and isinstance(model, TyreModel):
            made[key] = build_tyre_model(model.vehicle.with_values(**case.parameters))
    return [made[tuple(sorted(case.parameters.items()))] for case in cases]


def parameters_of(model: Model, models: Sequence[Model], equations: Equations) -> tuple[Program, Array]:
    """The program of all cases, and the parameters of each, (parameters, cases).

    Raises `SimulationError` if parameters change the structure of the equations, such as a body that loses its mass.
    """
    if all(own is model for own in models):
        return equations.ready.program, np.repeat(equations.ready.parameters[:, np.newaxis], len(models), axis=1)
    try:
        numbers = gathered([(own.numbers, own.signals) for own in models if isinstance(own, TyreModel)])
    except ValueError as error:
        raise SimulationError(f"{error}: simulate them apart") from None
    made = program(spliced, numbers, len(model.states), len(model.inputs))
    try:
        return made, made.plan.parameter_values(numbers)
    except ValueError as error:
        raise SimulationError(f"{error}: simulate them apart") from None


def go_through(own: Fleet, asked: Request, held: list[tuple[float, Array]]) -> None:
    """Go on with all cases to their ends; *held* gets instants with what the ports of blocks hold from then on."""
    wiring = asked.wiring
    with Progress(f"simulating {len(own.clock)} cases", asked.duration) as progress:
        if not wiring.blocks:
            while own.going(asked.duration):
                own.go_on(asked.duration, progress.next_stop(own.time, SLICE), closed=True)
                progress.reached(own.time)
            return
        ports = begun(wiring, len(own.clock))
        for time, due in sample_times(wiring):
            own.go_on(min(time, asked.duration), np.inf, closed=time >= asked.duration)
            progress.reached(min(time, asked.duration))
            if time >= asked.duration:
                break
            ports = updated(wiring, due, time, own.observe(), ports)
            held.append((time, ports.acting))
            own.work[:, wiring.inputs] = ports.acting[wiring.sources].T


def told(
    model: Model, asked: Request, own: Fleet, kept: Sequence[tuple[int, str]], held: Sequence[tuple[float, Array]]
) -> Runs:
    """The results of all cases."""
    wiring, limits = asked.wiring, model.limits if isinstance(model, TyreModel) else ()
    units = [*model.state_units, *model.input_units, *model.output_units]
    values = own.rows
    if wiring.signals and not held:
        values = np.concatenate((values, np.full((*values.shape[:2], len(wiring.signals)), np.nan)), axis=2)
    elif wiring.signals:
        instants, ports = zip(*held, strict=True)
        at = np.array(ports)[np.searchsorted(instants, own.times, side="right") - 1]
        for k, until in enumerate(own.until):
            # where a case ends its blocks are not asked any more
            at[own.times == until, :, k] = ports[max(int(np.searchsorted(instants, until)) - 1, 0)][:, k]
        taken = np.arange(len(own.times)) < own.counts[:, of.SAMPLES, np.newaxis]
        values = np.concatenate((values, np.where(taken[:, :, np.newaxis], at.transpose(2, 0, 1), np.nan)), axis=2)
    diverging = [own.diverging(k, model.states) for k in range(len(own.clock))]
    return Runs(
        name=model.vehicle.name if isinstance(model, TyreModel) else model.name,
        time=own.times,
        signals=(*(name for _, name in kept), *wiring.signals),
        units=(*(units[k] for k, _ in kept), *wiring.units),
        values=values,
        events=tuple((*events(parts, limits), *more) for parts, more in zip(own.events, diverging, strict=True)),
        ended=tuple(own.ended(k, limits, more) for k, more in enumerate(diverging)),
    )
