"""What is different in a case of a batch, and what is wrong with it."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from eom.errors import SimulationError
from eom.model.tyre import TyreModel
from eom.simulation.equations import Model
from eom.simulation.functions import Broken
from eom.simulation.inputs import Input
from eom.simulation.request import Request


@dataclass(frozen=True)
class Case:
    """What is different in a case: inputs, states at the start, speed [m/s], parameters of the vehicle, by name."""

    inputs: Mapping[str, Input] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    speed: float | None = None
    parameters: Mapping[str, str | float] = field(default_factory=dict)


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
