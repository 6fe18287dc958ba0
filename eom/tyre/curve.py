"""The Magic Formula's two curves: Pacejka, Tire and Vehicle Dynamics, 2012, (4.49) and (4.59)."""

from typing import Any

from eom.tyre.elementary import arctan, cos, sin
from eom.tyre.parameters import Values

VANISHING = 1e-100
"""Beside a number that is not zero it vanishes; a friction that vanishes at some load gives no force, and not none."""


def bend(x: Values, E: Values) -> Any:
    """The argument x = B times slip, bent by the curvature factor E: x - E (x - arctan x)."""
    return x - E * (x - arctan(x))


def sine(x: Values, C: Values, E: Values) -> Any:
    """Force over peak force: slope C at x = 0, largest value one if C >= 1."""
    return sin(C * arctan(bend(x, E)))


def cosine(x: Values, C: Values, E: Values) -> Any:
    """A hill: one at x = 0."""
    return cos(C * arctan(bend(x, E)))
