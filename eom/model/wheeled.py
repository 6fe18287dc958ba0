"""The linear model of a vehicle with wheels."""

import numpy as np

from eom.model.assembly import Assembly
from eom.model.linear import LinearModel
from eom.splice.closure import close
from eom.splice.linear_outputs import linear_outputs
from eom.splice.prepare import Prepared, input_names
from eom.splice.signals import spliced_states


def with_wheels(assembly: Assembly, prepared: Prepared) -> LinearModel:
    """Linear model of a vehicle with wheels: spins are states, loads and torques act.

    States are as in `eom.build`, less the lead's place along the road and its speed where that is held.
    """
    closed = close(prepared)
    C, D = linear_outputs(prepared, closed)
    states, inputs = spliced_states(prepared), input_names(prepared.system)
    kept = list(range(len(states)))
    if prepared.model.body.held:
        # a held speed is no state, nor is the way that follows from it
        speed = 3 + prepared.model.body.T.shape[1] + int(prepared.model.body.lead[0])
        kept = [k for k in kept if k not in {0, speed}]
    states = [states[k] for k in kept]
    outputs = assembly.system.outputs
    return LinearModel(
        closed.A[np.ix_(kept, kept)],
        closed.B[kept],
        C[:, kept],
        D,
        states=tuple(name for name, _ in states),
        inputs=tuple(name for name, _ in inputs),
        outputs=tuple(item.name for item in outputs),
        state_units=tuple(unit for _, unit in states),
        input_units=tuple(unit for _, unit in inputs),
        output_units=tuple(item.unit for item in outputs),
        cyclic=tuple(k for k, at in enumerate(kept) if at < 3),
        name=assembly.vehicle.name,
        speed=assembly.vehicle.speed,
        bodies=tuple(body.name for body in prepared.system.bodies),
        centres=np.array([body.centre for body in prepared.system.bodies]),
        motion=closed.p[:, kept],
    )
