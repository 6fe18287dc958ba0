"""The minimal state space, with accelerations that include the constraint reactions."""

from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import row_entry
from eom.assembly.cyclic import count_from_cyclic
from eom.assembly.massless import FirstOrder, rate_of
from eom.assembly.matrices import Matrices
from eom.assembly.reduction import ROUNDING, Pivots
from eom.assembly.rows import local_rows
from eom.assembly.vectors import Array
from eom.vehicle.elements import Output, System

JUMP_TOLERANCE = 1e-9


class RateError(ValueError):
    """An output that would need the rate of an input."""

    def __init__(self, output: str, name: str) -> None:
        self.output = output
        what = "measure a motion that has mass and that no damper moved by the input acts on"
        super().__init__(f"output {output} would follow the rate of input {name}: {what}")


class StateSpace(NamedTuple):
    """dx/dt = A x + B u, y = C x + D u, with x = (q, n)."""

    A: Array
    B: Array
    C: Array
    D: Array


def output_row(system: System, output: Output) -> Array:
    """Row of an output on the motion of all bodies, shape (6 n,)."""
    row = np.zeros(6 * len(system.bodies))
    for weight, connection in output.terms:
        _, where, values = row_entry(0, connection.bodies, local_rows(system.bodies, connection))
        row[where] += weight * values[0]
    return row


def output_signals(system: System, matrices: Matrices, form: FirstOrder) -> Array:
    """The outputs as signals of the states, the inputs and their rates (see `eom.assembly.massless`).

    Raises `RateError` for one that would follow an input's rate.
    """
    rates, q, n, _ = form
    T, W, Z = matrices.reduction.T, matrices.reduction.W, matrices.reduction.Z
    states, n_u = len(rates), len(system.inputs)
    names = [item.name for item in system.inputs]
    result = np.zeros((len(system.outputs), rates.shape[1]))
    for k, output in enumerate(system.outputs):
        row = output_row(system, output)
        if output.quantity == "position":
            signal = (row @ T) @ q
        else:
            # inertial: dp/dt = w - V p
            turning = row @ matrices.V @ T if output.frame == "inertial" else 0.0
            signal = (row @ W) @ n + (row @ Z - turning) @ q
            size = (np.abs(row) @ np.abs(W)) @ np.abs(n) + (np.abs(row) @ np.abs(Z)) @ np.abs(q)
            refuse_rates(output, names, signal[states + n_u :], ROUNDING * size[states + n_u :])
        if output.quantity == "acceleration":
            limit = jump_limit(form, signal[:states]) + ROUNDING * size[states : states + n_u]
            signal = rate_of(signal[np.newaxis], rates, n_u)[0]
            refuse_rates(output, names, signal[states + n_u :], limit)
        result[k] = signal
        for name, gain in output.feedthrough:
            result[k, states + names.index(name)] += gain
    return result


def jump_limit(form: FirstOrder, velocity: Array) -> Array:
    """The largest jump of a velocity, per rate of each input, that is rounding: small beside that of the whole.

    Jumps are compared by kinetic energy, which no choice of coordinates changes.
    """
    states, moving = len(form.rates), len(form.mass)
    jump = form.rates[states - moving :, (form.rates.shape[1] + states) // 2 :]
    if not np.any(jump):
        return np.zeros(jump.shape[1])
    own = velocity[states - moving :]
    energy = np.sum(jump * (form.mass @ jump), axis=0)
    return np.asarray(JUMP_TOLERANCE * np.sqrt(own @ np.linalg.solve(form.mass, own) * energy))


def refuse_rates(output: Output, names: list[str], rates: Array, limit: Array) -> None:
    """Raise `RateError` if an output follows the rate of an input by more than a limit."""
    needed = np.abs(rates) > limit
    if np.any(needed):
        raise RateError(output.name, names[int(np.argmax(needed))])


def state_space(system: System, matrices: Matrices, pivots: Pivots, form: FirstOrder) -> StateSpace:
    """Minimal state space about the trim, from the first-order form of the same matrices and pivots.

    Where an input acts through its rate (a damper moved at its far end), the states are counted less the jump
    that the input gives them, so that only u itself remains. Raises `RateError` for an output that would still need
    the rate of an input, ``ValueError`` where the pivots do not fit or numbers have no value.
    """
    n_u = len(system.inputs)
    rates = form.rates
    states = len(rates)
    A, B, jump = np.split(rates, [states, states + n_u], axis=1)
    C, D, _ = np.split(output_signals(system, matrices, form), [states, states + n_u], axis=1)
    B, D = B + A @ jump, D + C @ jump
    model = StateSpace(*count_from_cyclic(A, B, C, system.bodies, matrices.reduction, pivots), D)
    if not all(np.all(np.isfinite(matrix)) for matrix in model):
        message = "its numbers differ too much in size to compute with"
        raise ValueError(message)
    return model
