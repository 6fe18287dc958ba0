"""A linear model with names, in the axes that its maker states."""

from dataclasses import dataclass

from eom.closed_form.arrays import Array


@dataclass(frozen=True)
class StateSpace:
    """dx/dt = A x + B u, y = C x + D u, everything named.

    Attributes
    ----------
    A, B, C, D : Array
        Shapes (n, n), (n, m), (k, n), (k, m); SI units and radians.
    states, inputs, outputs : tuple of str
        The thesis's symbols, with the number of the unit or axle last: ``beta_1``, ``delta_4``.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
