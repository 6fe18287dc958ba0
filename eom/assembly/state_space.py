"""The minimal state space, with accelerations that include the constraint reactions."""

from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import row_entry
from eom.assembly.cyclic import CYCLIC_TOLERANCE, count_from_cyclic
from eom.assembly.massless import first_order, independent_equations, rate_of
from eom.assembly.matrices import Matrices
from eom.assembly.reduction import ROUNDING, Pivots
from eom.assembly.rows import local_rows
from eom.assembly.vectors import Array
from eom.vehicle.elements import Output, System


class RateError(ValueError):
    """An output that would need the rate of an input."""

    def __init__(self, output: str, name: str) -> None:
        self.output = output
        what = "measure a body that the moving damper does not act on"
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


def output_signals(system: System, matrices: Matrices, rates: Array, p: Array, w: Array) -> Array:
    """The outputs as signals of the states, the inputs and their rates (see `eom.assembly.massless`).

    Raises `RateError` for one that would follow an input's rate.
    """
    states, n_u = len(rates), len(system.inputs)
    names = [item.name for item in system.inputs]
    result = np.zeros((len(system.outputs), rates.shape[1]))
    moving = w - matrices.V @ p
    for k, output in enumerate(system.outputs):
        row = output_row(system, output)
        size = np.abs(row) @ np.abs(w)
        if output.quantity == "position":
            signal = row @ p
        else:
            signal = row @ (moving if output.frame == "inertial" else w)
            refuse_rates(output, names, signal, size)
        if output.quantity == "acceleration":
            signal = rate_of(signal[np.newaxis], rates, n_u)[0]
            size = np.abs(size[:states]) @ np.abs(rates) + np.concatenate(
                [np.zeros(states + n_u), size[states : states + n_u]]
            )
            refuse_rates(output, names, signal, size)
        result[k] = signal
        for name, gain in output.feedthrough:
            result[k, states + names.index(name)] += gain
    return result


def refuse_rates(output: Output, names: list[str], signal: Array, size: Array) -> None:
    """Raise `RateError` if the signal holds an input's rate; *size* is what its columns are sums of."""
    first = len(signal) - len(names)
    needed = np.abs(signal[first:]) > ROUNDING * size[first:]
    if np.any(needed):
        raise RateError(output.name, names[int(np.argmax(needed))])


def state_space(system: System, matrices: Matrices, pivots: Pivots) -> StateSpace:
    """Minimal state space about the trim.

    Where an input acts through its rate (a damper moved at its far end), the states are counted less the jump
    that the input gives them, so that only u itself remains. Raises `RateError` for an output that would still need
    the rate of an input, `IndexAboveOneError` for a motion that nothing determines, ``ValueError`` where the
    pivots do not fit.
    """
    reduction, n_u = matrices.reduction, len(system.inputs)
    rates, q, n = first_order(independent_equations(matrices), pivots)
    p, w = reduction.T @ q, reduction.W @ n + reduction.Z @ q
    states = len(rates)
    A, B, jump = np.split(rates, [states, states + n_u], axis=1)
    C, D, _ = np.split(output_signals(system, matrices, rates, p, w), [states, states + n_u], axis=1)
    B, D = B + A @ jump, D + C @ jump
    A, X, X_inverse = count_from_cyclic(A, system.bodies, reduction, pivots)
    C = C @ X
    cyclic = list(pivots.cyclic)
    largest = np.max(np.abs(C), axis=1, initial=0.0)[:, np.newaxis]
    C[:, cyclic] = np.where(np.abs(C[:, cyclic]) <= CYCLIC_TOLERANCE * largest, 0.0, C[:, cyclic])
    return StateSpace(A, X_inverse @ B, C, D)
