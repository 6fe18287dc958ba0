"""Partial derivatives of forces and moments, exact to rounding."""

from typing import Any, NamedTuple

import numpy as np

from eom.tyre.interface import REFERENCE_SPEED, Forces, Tyre, as_numbers
from eom.tyre.parameters import Values

STEP = 1e-30
"""Imaginary step: its square vanishes beside one, so that nothing is cancelled and nothing is left out."""


class Slopes(NamedTuple):
    """Derivatives of all forces and moments by one argument each: ``slopes.alpha.Fy`` is dFy/dalpha [N/rad]."""

    alpha: Forces
    kappa: Forces
    Fz: Forces
    gamma: Forces


def slopes(
    tyre: Tyre, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
) -> Slopes:
    """Slopes of a tyre's forces and moments at any working point, by complex steps.

    Arguments and errors as of `Tyre.forces`. Where a model has a kink (its description says where), the slope is
    that of the side on which the argument lies; camber exactly zero counts as positive.

    References
    ----------
    Squire, Trapp: Using Complex Variables to Estimate Derivatives of Real Functions, SIAM Review 40, 1998.
    """
    point = [as_numbers(name, value) for name, value in zip(Slopes._fields, (alpha, kappa, Fz, gamma), strict=True)]

    def slope(k: int) -> Forces:
        a, b, c, d = (value + 1j * STEP if i == k else value for i, value in enumerate(point))
        return Forces(*(derivative(value) for value in tyre.forces(a, b, c, d, speed)))

    return Slopes(*(slope(k) for k in range(len(point))))


def derivative(value: Any) -> "np.ndarray[Any, Any]":
    """The derivative that a complex number carries."""
    return np.asarray(np.imag(value)) / STEP
