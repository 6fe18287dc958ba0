"""The linear model of a vehicle with wheels."""

import numpy as np

from eom.model.assembly import Assembly
from eom.model.linear import LinearModel
from eom.splice.closure import close
from eom.splice.linear_outputs import linear_outputs
from eom.splice.prepare import Prepared, input_names
from eom.splice.signals import spliced_states


def with_wheels(assembly: Assembly, prepared: Prepared) -> LinearModel:
    """Linear model of a vehicle with wheels: spins are states, loads and torques act; states as in `eom.build`."""
    closed = close(prepared)
    C, D = linear_outputs(prepared, closed)
    states, inputs = spliced_states(prepared), input_names(prepared.system)
    outputs = assembly.system.outputs
    return LinearModel(
        closed.A,
        closed.B,
        C,
        D,
        states=tuple(name for name, _ in states),
        inputs=tuple(name for name, _ in inputs),
        outputs=tuple(item.name for item in outputs),
        state_units=tuple(unit for _, unit in states),
        input_units=tuple(unit for _, unit in inputs),
        output_units=tuple(item.unit for item in outputs),
        cyclic=(0, 1, 2),
        name=assembly.vehicle.name,
        speed=assembly.vehicle.speed,
        bodies=tuple(body.name for body in prepared.system.bodies),
        centres=np.array([body.centre for body in prepared.system.bodies]),
        motion=closed.p[:, : len(states)],
    )
