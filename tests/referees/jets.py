"""Exact second derivatives: numbers that carry their gradient and Hessian through every operation."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Jets = NDArray[np.object_]
"""Arrays of jets and plain numbers; NumPy adds, multiplies and contracts them element by element."""

Number = (int, float)


class Jet:
    """A number as the second-order Taylor polynomial of variables.

    Attributes
    ----------
    value : float
    gradient : Array
        Shape (n,).
    hessian : Array
        Shape (n, n), symmetric.
    """

    __slots__ = ("gradient", "hessian", "value")

    def __init__(self, value: float, gradient: Array, hessian: Array) -> None:
        self.value, self.gradient, self.hessian = value, gradient, hessian

    def of(self, value: float, slope: float, curvature: float) -> "Jet":
        """A function of this number, by its value, first and second derivative there."""
        gradient = self.gradient
        return Jet(value, slope * gradient, slope * self.hessian + curvature * np.outer(gradient, gradient))

    def __add__(self, other: "Jet | float") -> "Jet":
        if isinstance(other, Jet):
            return Jet(self.value + other.value, self.gradient + other.gradient, self.hessian + other.hessian)
        return Jet(self.value + other, self.gradient, self.hessian) if isinstance(other, Number) else NotImplemented

    def __mul__(self, other: "Jet | float") -> "Jet":
        if isinstance(other, Jet):
            mixed = np.outer(self.gradient, other.gradient)
            return Jet(
                self.value * other.value,
                self.value * other.gradient + other.value * self.gradient,
                self.value * other.hessian + other.value * self.hessian + mixed + mixed.T,
            )
        if isinstance(other, Number):
            return Jet(self.value * other, other * self.gradient, other * self.hessian)
        return NotImplemented

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> "Jet":
        return self * -1.0

    def __sub__(self, other: "Jet | float") -> "Jet":
        return self + -1.0 * other

    def __rsub__(self, other: float) -> "Jet":
        return -self + other


def variables(count: int) -> list[Jet]:
    """That many variables, all at zero."""
    return [Jet(0.0, row, np.zeros((count, count))) for row in np.eye(count)]


def sqrt(a: Jet) -> Jet:
    """Square root of a positive number."""
    root = float(np.sqrt(a.value))
    return a.of(root, 0.5 / root, -0.25 / root**3)


def reciprocal(a: Jet) -> Jet:
    """One over a number that is not zero."""
    return a.of(1.0 / a.value, -1.0 / a.value**2, 2.0 / a.value**3)


def cross(a: Jets | Array | Sequence[float], b: Jets | Array | Sequence[float]) -> Jets:
    """Cross product of two vectors of jets or numbers."""
    (ax, ay, az), (bx, by, bz) = a, b
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], dtype=object)


def skew(a: Jets) -> Jets:
    """Matrix of the cross product."""
    x, y, z = a
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]], dtype=object)


def rotation(theta: Jets) -> tuple[Jets, Jets]:
    """Rotation matrix of a rotation vector at zero, and the matrix from its rate to body-axis angular velocity.

    The three coefficients are sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3 as functions of a^2, by their series.
    """
    square: Jet = theta @ theta
    S = skew(theta)
    SS = S @ S
    sine, cosine = square.of(1.0, -1.0 / 6.0, 1.0 / 60.0), square.of(0.5, -1.0 / 24.0, 1.0 / 360.0)
    third = square.of(1.0 / 6.0, -1.0 / 120.0, 1.0 / 2520.0)
    return np.eye(3) + S * sine + SS * cosine, np.eye(3) - S * cosine + SS * third
