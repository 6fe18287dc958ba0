"""Steady-state gains: where the outputs settle under constant inputs."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from eom.analysis.roots import is_stable, moving_roots
from eom.assembly.vectors import Array
from eom.errors import SingularError
from eom.model.linear import LinearModel

# of the sum of its terms' sizes: what rounding leaves of a coefficient that is zero
ROUNDING = 1e-11
# of the largest root: a root that is zero but for rounding
ZERO = 1e-14


class Parts(NamedTuple):
    """A model cut into its cyclic states c and the others r, whose motion does not depend on c.

    dc/dt = N c + E r + F u,  dr/dt = A r + B u,  y = P c + C r + D u,  N nilpotent.
    """

    N: Array
    E: Array
    F: Array
    A: Array
    B: Array
    P: Array
    C: Array
    D: Array


@dataclass(frozen=True)
class SteadyGains:
    """Steady output per constant input.

    Attributes
    ----------
    values : Array
        Shape (outputs, inputs), output's unit per input's. Infinite, with its sign, where a constant input drives an
        output without end, as steer does with the heading.
    inputs, outputs, input_units, output_units : tuple of str
    stable : bool
        False: the vehicle does not settle and the gains are formal, the limit of the transfer function at s = 0.
    """

    values: Array
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    input_units: tuple[str, ...]
    output_units: tuple[str, ...]
    stable: bool

    def of(self, output: str, source: str) -> float:
        """The gain of one output by one input."""
        return float(self.values[self.outputs.index(output), self.inputs.index(source)])


def parts_of(model: LinearModel) -> Parts:
    """A model's matrices, cyclic states apart."""
    c = np.array(model.cyclic, dtype=int)
    r = np.setdiff1d(np.arange(len(model.A)), c)
    A, B, C = model.A, model.B, model.C
    return Parts(A[np.ix_(c, c)], A[np.ix_(c, r)], B[c], A[np.ix_(r, r)], B[r], C[:, c], C[:, r], model.D)


def steady_gains(model: LinearModel) -> SteadyGains:
    """Limit of C (s I - A)^-1 B + D at s = 0, through the integrators of cyclic states.

    Raises
    ------
    SingularError
        If a root is zero that no cyclic coordinate explains: the vehicle is on the limit of stability.
    """
    parts = parts_of(model)
    sizes = np.abs(moving_roots(model))
    if np.any(sizes <= ZERO * np.max(sizes, initial=0.0)):
        message = f"{model.name}: has a zero root besides those of its cyclic coordinates: steady gains have no value"
        raise SingularError(message)
    inverse = np.asarray(np.linalg.inv(parts.A), dtype=float)
    constant, *poles = (
        np.where(np.abs(value) > ROUNDING * size, value, 0.0) for value, size in expansion(parts, inverse)
    )
    values = constant
    for pole in poles:
        values = np.where(pole != 0.0, np.copysign(np.inf, pole), values)
    names = (model.inputs, model.outputs, model.input_units, model.output_units)
    return SteadyGains(np.asarray(values), *names, is_stable(model))


def expansion(parts: Parts, inverse: Array) -> list[tuple[Array, Array]]:
    """Coefficients of s^0, s^-1, s^-2, ... of the transfer functions about s = 0, each with its terms' summed sizes.

    The others' motion is r = (R_0 + s R_1 + ...) u with R_k = -A^-(k+1) B, and the cyclic states integrate it by
    (s I - N)^-1 = I/s + N/s^2 + ...
    """
    orders = range(len(parts.N) + 1)
    motions, bounds = [-inverse @ parts.B], [np.abs(inverse) @ np.abs(parts.B)]
    for _ in orders[1:]:
        motions.append(inverse @ motions[-1])
        bounds.append(np.abs(inverse) @ bounds[-1])
    drives, sizes = [parts.E @ motion for motion in motions], [np.abs(parts.E) @ bound for bound in bounds]
    drives[0], sizes[0] = drives[0] + parts.F, sizes[0] + np.abs(parts.F)
    result = [(np.zeros_like(parts.D), np.zeros_like(parts.D)) for _ in orders]
    result[0] = parts.D + parts.C @ motions[0], np.abs(parts.D) + np.abs(parts.C) @ bounds[0]
    reach = parts.P
    for integrals in orders[1:]:
        for k in range(integrals + 1):
            value, size = result[integrals - k]
            result[integrals - k] = value + reach @ drives[k], size + np.abs(reach) @ sizes[k]
        reach = reach @ parts.N
    return result
