"""What is different in a case of a batch, and what is wrong with it."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from eom.errors import DescriptionError, SimulationError
from eom.model.tyre import TyreModel
from eom.simulation.equations import Model
from eom.simulation.functions import Broken
from eom.simulation.inputs import Input
from eom.simulation.kinds import is_number, kind, list_kinds, mapping_kinds
from eom.simulation.request import Request
from eom.vehicle.load import Vehicle

Parameters = Mapping[str, str | float]
Key = tuple[tuple[str, str | float], ...]
Vehicles = dict[Key, Vehicle | DescriptionError]
"""Vehicles with parameters of cases, or why there is none."""


@dataclass(frozen=True)
class Case:
    """What is different in a case: inputs, states at the start, speed [m/s], parameters of the vehicle, by name."""

    inputs: Mapping[str, Input] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    speed: float | None = None
    parameters: Parameters = field(default_factory=dict)


def key_of(parameters: Parameters) -> Key:
    """The same for the same parameters."""
    return tuple(sorted(parameters.items()))


def requests(
    model: Model,
    cases: Sequence[Case],
    mistakes: list[str],
    request: Callable[[Case], Request],
    vehicles: Vehicles,
) -> list[Request]:
    """What is asked in each case; *vehicles* gets those with parameters of their own.

    Raises `SimulationError` with all mistakes, of some cases with their numbers.
    """
    found: list[Request] = []
    wrong: dict[str, list[int]] = {}
    for k, case in enumerate(cases):
        lines = list(case_mistakes(model, case, vehicles))
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


def own_mistakes(cases: Sequence[Case], keep: Sequence[str] | None, threads: int | None) -> Iterator[str]:
    """Sentences for what a batch takes as no run does, where it is of another kind than expected."""
    wrong = list(list_kinds("cases", cases, "Case"))
    yield from wrong
    if not wrong and not len(cases):
        yield "cases: expected one or more"
    if not wrong:
        for k, case in enumerate(cases):
            if not isinstance(case, Case):
                yield f"case {k}: expected a Case, got {kind(case)}"
    yield from () if keep is None else list_kinds("keep", keep, "names")
    if threads is not None and not (isinstance(threads, (int, np.integer)) and threads >= 1):
        yield f"threads = {threads!r}: expected a whole number, one or more"


def case_mistakes(model: Model, case: Case, vehicles: Vehicles) -> Iterator[str]:
    """Sentences for parameters that cannot be, and for what a case asks of a linear model that it does not have."""
    wrong = list(mapping_kinds({"parameters": case.parameters}))
    yield from wrong
    if isinstance(model, TyreModel):
        if not wrong:
            yield from parameter_mistakes(model, case.parameters, vehicles)
        return
    if case.parameters:
        yield "a linear model has no parameters: give models with tyres, or linearise each case"
    if case.speed is not None and is_number(case.speed):
        yield f"speed = {case.speed:g} m/s: a linear model has that of its trim, {model.speed:g} m/s"


def parameter_mistakes(model: TyreModel, parameters: Parameters, vehicles: Vehicles) -> Iterator[str]:
    """Sentences for parameters of which no vehicle can be made; *vehicles* gets the one that can."""
    kinds = [
        f"parameter {name} = {value!r}: expected a number or a text such as '80 km/h'"
        for name, value in parameters.items()
        if not (isinstance(value, str) or is_number(value))
    ]
    if kinds or not parameters:
        yield from kinds
        return
    key = key_of(parameters)
    if key not in vehicles:
        try:
            vehicles[key] = model.vehicle.with_values(**parameters)
        except DescriptionError as error:
            vehicles[key] = error
    made = vehicles[key]
    if isinstance(made, DescriptionError):
        yield from str(made).splitlines()


def ended_at_once(asked: Request) -> list[Broken]:
    """Inputs that end where the run begins."""
    return [item for item in asked.inputs.values() if isinstance(item, Broken) and item.until <= 0.0]
