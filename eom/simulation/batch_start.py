"""From the cases of a batch to a fleet."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import DescriptionError, EquilibriumError, SimulationError, SingularError
from eom.model.tyre import TyreModel, build_tyre_model
from eom.program.make import Program, program
from eom.program.numbers import gathered
from eom.simulation.case import Case, Key, Vehicles, key_of
from eom.simulation.equations import Equations, Model, at_start, equations_of
from eom.simulation.fleet import Fleet
from eom.simulation.fleet_start import fleet
from eom.simulation.request import Request
from eom.simulation.signal_pieces import driven
from eom.splice.equations import spliced
from eom.vehicle.load import Vehicle


def prepared(
    model: Model,
    cases: Sequence[Case],
    asked: Sequence[Request],
    vehicles: Vehicles,
    columns: Sequence[int],
    threads: int | None,
) -> Fleet:
    """All cases before their first step; *vehicles* are those with parameters of their own."""
    models = models_of(model, cases, vehicles)
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


def models_of(model: Model, cases: Sequence[Case], vehicles: Vehicles) -> list[Model]:
    """The model of each case; those with the same parameters share it."""
    made: dict[Key, Model] = {(): model}
    for k, case in enumerate(cases):
        key = key_of(case.parameters)
        vehicle = vehicles.get(key)
        if key not in made and isinstance(vehicle, Vehicle):
            try:
                made[key] = build_tyre_model(vehicle)
            except DescriptionError as error:
                raise SimulationError("\n".join(f"case {k}: {line}" for line in str(error).splitlines())) from None
            except (EquilibriumError, SingularError) as error:
                raise type(error)(f"case {k}: {error}") from None
    return [made[key_of(case.parameters)] for case in cases]


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
