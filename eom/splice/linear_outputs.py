"""Outputs of the linear model of a vehicle with wheels, from the motions of its closed equations."""

import numpy as np

from eom.assembly.state_space import output_row
from eom.assembly.vectors import Array
from eom.splice.closure import Closed
from eom.splice.prepare import Prepared, input_names


def linear_outputs(prepared: Prepared, closed: Closed) -> tuple[Array, Array]:
    """C and D of y = C x + D u for the outputs that the file or its train measures, speeds counted from the trim's.

    Velocities and accelerations of frame ``inertial`` are rates of inertial displacements, dp/dt = w - V p; those of
    frame ``body`` are rates of components in body axes. A sideslip is the lateral velocity over the trim speed.
    """
    system, V = prepared.system, prepared.matrices.V
    names = [name for name, _ in input_names(system)]
    states = len(closed.A)
    result = np.zeros((len(system.outputs), closed.p.shape[1]))
    for k, output in enumerate(system.outputs):
        row = output_row(system, output)
        turning = row @ V if output.frame == "inertial" else 0.0 * row
        match output.quantity:
            case "position":
                result[k] = row @ closed.p
            case "velocity":
                result[k] = row @ closed.w - turning @ closed.p
            case _:
                result[k] = row @ closed.dw - turning @ closed.w
        for name, gain in output.feedthrough:
            result[k, states + names.index(name)] += gain
    return result[:, :states], result[:, states:]
