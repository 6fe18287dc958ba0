"""``eom.simulate_many``: many cases of one model at once; parameters, inputs, starts and speeds differ."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.model.tyre import TyreModel, build_tyre_model
from eom.program.make import Program, program
from eom.program.numbers import gathered
from eom.simulation.blocks import Block
from eom.simulation.channels import STATE
from eom.simulation.equations import Equations, Model, at_start, check_kind, equations_of
from eom.simulation.fleet import Fleet, fleet
from eom.simulation.inputs import Input
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
        For every mistake in what is asked, with the number of the case.
    DescriptionError, EquilibriumError
        If the parameters of a case make no vehicle, or one without straight run.
    """
    check_kind(model)
    asked = requests(model, cases, duration, blocks, wires or {}, (sample, method, step, tolerance))
    one, names = asked[0], every_name(model)
    columns = chosen(keep, names)
    size = 8.0 * len(cases) * len(one.times) * len(columns)
    if size > LARGEST:
        raise SimulationError(
            f"results of {size / 1e9:.3g} GB, expected at most {LARGEST / 1e9:g}: name the signals to keep, take fewer "
            "samples, or fewer cases at a time"
        )
    with Progress(f"preparing {len(cases)} cases"):
        ready = prepared(model, cases, asked, columns, threads)
    held = gone_through(ready, one)
    kept = [(k, names[k]) for k in columns]
    return told(model, one, ready, kept, held)


def requests(
    model: Model,
    cases: Sequence[Case],
    duration: float,
    blocks: Sequence[Block],
    wires: Mapping[str, str],
    how: tuple[float, str, float | None, float],
) -> list[Request]:
    """What is asked in each case; raises `SimulationError` with all mistakes, those of a case with its number."""
    found, mistakes = [], dict[str, None]()
    if not cases:
        mistakes["cases: expected one or more"] = None
    for k, case in enumerate(cases):
        try:
            found.append(checked(model, case.inputs, duration, case.start, blocks, wires, *how))
        except SimulationError as error:
            mistakes.update({f"case {k}: {line}": None for line in str(error).splitlines()})
        if case.parameters and not isinstance(model, TyreModel):
            mistakes[f"case {k}: a linear model has no parameters: give models with tyres, or linearise each case"] = (
                None
            )
    if mistakes:
        raise SimulationError("\n".join(mistakes))
    return found


def every_name(model: Model) -> list[str]:
    """What can be kept, in the order of the columns: states, inputs, outputs."""
    return [*(STATE + name for name in model.states), *model.inputs, *model.outputs]


def chosen(keep: Sequence[str] | None, names: Sequence[str]) -> list[int]:
    """Columns of the names to keep; raises `SimulationError` for unknown ones."""
    if keep is None:
        return list(range(len(names)))
    wrong = [name for name in keep if name not in names]
    if wrong:
        message = "\n".join(f"keep {name}: there is no such signal{did_you_mean(name, names)}" for name in wrong)
        raise SimulationError(message)
    return [names.index(name) for name in keep]


def prepared(
    model: Model, cases: Sequence[Case], asked: Sequence[Request], columns: Sequence[int], threads: int | None
) -> Fleet:
    """All cases before their first step."""
    models = models_of(model, cases)
    equations = equations_of(model)
    made, parameters = parameters_of(models, equations)
    starts, inputs = [], []
    for k, (own, case) in enumerate(zip(models, asked, strict=True)):
        x, u = at_start(own, cases[k].speed)
        inputs.append(driven(case.inputs, model.inputs, u))
        if inputs[-1].until <= 0.0:
            raise SimulationError(f"case {k}: {inputs[-1].why}: nothing can be simulated") from inputs[-1].cause
        for name, value in case.start.items():
            x[model.states.index(name)] = value
        starts.append(x)
    ready = equations._replace(ready=equations.ready._replace(program=made))
    return fleet(ready, parameters, starts, inputs, asked[0].times, np.array(columns), asked[0].settings, threads)


def models_of(model: Model, cases: Sequence[Case]) -> list[Model]:
    """The model of each case; those with the same parameters share it."""
    made: dict[tuple[tuple[str, str | float], ...], Model] = {(): model}
    for case in cases:
        key = tuple(sorted(case.parameters.items()))
        if key not in made and isinstance(model, TyreModel):
            made[key] = build_tyre_model(model.vehicle.with_values(**case.parameters))
    return [made[tuple(sorted(case.parameters.items()))] for case in cases]


def parameters_of(models: Sequence[Model], equations: Equations) -> tuple[Program, Array]:
    """The program of all cases, and the parameters of each, (parameters, cases).

    Raises `SimulationError` if parameters change the structure of the equations, such as a body that loses its mass.
    """
    first = models[0]
    if all(own is first for own in models):
        return equations.ready.program, np.repeat(equations.ready.parameters[:, np.newaxis], len(models), axis=1)
    try:
        numbers = gathered([(own.numbers, own.signals) for own in models if isinstance(own, TyreModel)])
    except ValueError as error:
        raise SimulationError(f"{error}: simulate them apart") from None
    made = program(spliced, numbers, len(first.states), len(first.inputs))
    return made, made.plan.parameter_values(numbers)


def gone_through(own: Fleet, asked: Request) -> list[tuple[float, Array]]:
    """Go on with all cases to their ends; instants with what the ports of blocks held from then on."""
    held: list[tuple[float, Array]] = []
    wiring = asked.wiring
    with Progress(f"simulating {len(own.clock)} cases", asked.duration) as progress:
        if not wiring.blocks:
            while own.going(asked.duration):
                own.go_on(asked.duration, progress.next_stop(own.time, SLICE), closed=True)
                progress.reached(own.time)
            return held
        ports = begun(wiring, len(own.clock))
        for time, due in sample_times(wiring):
            own.go_on(min(time, asked.duration), np.inf, closed=time >= asked.duration)
            progress.reached(min(time, asked.duration))
            if time >= asked.duration:
                break
            ports = updated(wiring, due, time, own.observe(), ports)
            held.append((time, ports.acting))
            own.work[:, wiring.inputs] = ports.acting[wiring.sources].T
    return held


def told(
    model: Model, asked: Request, own: Fleet, kept: Sequence[tuple[int, str]], held: Sequence[tuple[float, Array]]
) -> Runs:
    """The results of all cases."""
    wiring, limits = asked.wiring, model.limits if isinstance(model, TyreModel) else ()
    units = [*model.state_units, *model.input_units, *model.output_units]
    values = own.rows
    if wiring.signals:
        instants, ports = zip(*held, strict=True)
        at = np.array(ports)[np.searchsorted(instants, own.times, side="right") - 1]
        lost = (
            np.isnan(values[:, :, :1]) if values.shape[2] else np.zeros((len(own.clock), len(own.times), 1), dtype=bool)
        )
        values = np.concatenate((values, np.where(lost, np.nan, at.transpose(2, 0, 1))), axis=2)
    return Runs(
        name=model.vehicle.name if isinstance(model, TyreModel) else model.name,
        time=own.times,
        signals=(*(name for _, name in kept), *wiring.signals),
        units=(*(units[k] for k, _ in kept), *wiring.units),
        values=values,
        events=tuple(events(parts, limits) for parts in own.events),
        ended=tuple(own.ended(k, limits) for k in range(len(own.clock))),
    )
