"""C and D of the linear model of a vehicle with wheels are the derivatives of what the nonlinear one measures."""

from itertools import product

import numpy as np
import pytest

from eom.splice.closure import close
from eom.splice.linear_outputs import linear_outputs
from eom.splice.outputs import all_outputs
from eom.splice.prepare import Prepared, input_names, prepare
from eom.splice.rates import evaluate
from eom.splice.signals import signals
from eom.splice.steady import steady
from eom.vehicle.elements import GROUND, Connection, Output
from tests.vehicles.shipped import vehicle

STEP = 1e-30
# complex steps are exact; the closed equations solve for reactions and accelerations in another order
EXACT = 1e-9
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def with_more_outputs(prepared: Prepared) -> Prepared:
    """The same with every measure of every body in every direction besides its own outputs."""
    more = []
    for k, body in enumerate(prepared.system.bodies):
        off = (body.centre[0] + 0.7, body.centre[1] - 0.4, body.centre[2] + 0.3)
        for axis, turns, quantity, frame in product(
            AXES, (0, 1), ("position", "velocity", "acceleration"), ("body", "inertial")
        ):
            item = Connection("", (k, GROUND), (off, off), 1 - turns, axis, turns, axis)
            name, _ = input_names(prepared.system)[0]
            more.append(Output("", "", quantity, frame, ((1.5, item),), ((name, 0.25),)))
    return prepared._replace(system=prepared.system._replace(outputs=(*prepared.system.outputs, *more)))


def slopes(prepared: Prepared, speed: float) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives of the measured outputs at the trim by states and inputs."""
    system, p = prepared.system, prepared.model
    own = signals(system, prepared.pivots, [name for name, _ in input_names(system)], speed)
    x, u = steady(p, prepared.trim.speed, prepared.trim.slip, prepared.trim.torque)
    at, n = np.concatenate((x, u)), len(x)
    columns = []
    for unit in np.eye(len(at)):
        moved = at + 1j * STEP * unit
        found = evaluate(moved[:n], moved[n:], p)
        columns.append(all_outputs(found, moved[n:], p, own)[: len(system.outputs)].imag / STEP)
    both = np.array(columns).T
    return both[:, :n], both[:, n:]


@pytest.mark.parametrize("name", ["b_train", "car"])
def test_linear_outputs_are_the_derivatives_of_the_measured_ones_at_the_trim(name: str) -> None:
    own = vehicle(name)
    prepared = with_more_outputs(prepare(own.system, own.speed))
    found = linear_outputs(prepared, close(prepared))
    for one, other in zip(found, slopes(prepared, own.speed), strict=True):
        scale = np.maximum(1.0, np.max(np.abs(other), axis=1))[:, np.newaxis]
        np.testing.assert_array_less(np.abs(one - other) / scale, EXACT)
