"""Numbers that remember how they came about: a value to decide with, and its expression in named symbols.

Assembly computes with arrays of them as with arrays of floats. What branches on a number (the direction of an
axis, a load that is zero) branches on its value at the trim; what is returned carries the symbols.
"""

import math
from collections.abc import Callable

import numpy as np
import sympy

from eom.assembly.vectors import Array

Number = "Traced | float"


class Traced:
    """A number with its expression; an expression of exactly zero is the float 0.0 instead.

    Attributes
    ----------
    value : float
    expression : sympy.Expr
        Exact: floats in it are the fractions that their shortest decimals stand for.
    """

    __slots__ = ("expression", "value")

    def __init__(self, value: float, expression: sympy.Expr) -> None:
        self.value, self.expression = float(value), expression

    def __repr__(self) -> str:
        return f"Traced({self.value!r}, {self.expression})"

    def __add__(self, other: object) -> object:
        return combine(self, other, lambda a, b: a + b)

    def __radd__(self, other: object) -> object:
        return self + other

    def __sub__(self, other: object) -> object:
        return combine(self, other, lambda a, b: a - b)

    def __rsub__(self, other: object) -> object:
        return -self + other

    def __mul__(self, other: object) -> object:
        return combine(self, other, lambda a, b: a * b)

    def __rmul__(self, other: object) -> object:
        return self * other

    def __truediv__(self, other: object) -> object:
        return combine(self, other, lambda a, b: a / b)

    def __rtruediv__(self, other: object) -> object:
        return combine(other, self, lambda a, b: a / b)

    def __pow__(self, other: object) -> object:
        return combine(self, other, lambda a, b: a**b)

    def __rpow__(self, other: object) -> object:
        return combine(other, self, lambda a, b: a**b)

    def __neg__(self) -> "Traced":
        return Traced(-self.value, -self.expression)

    def __abs__(self) -> "Traced":
        return self if self.value >= 0.0 else -self

    def __bool__(self) -> bool:
        # an expression of exactly zero is a float: this one is something, also where its value is zero
        return True

    def __eq__(self, other: object) -> bool:
        return self.value == value_of(other)

    def __lt__(self, other: object) -> bool:
        return self.value < value_of(other)

    def __le__(self, other: object) -> bool:
        return self.value <= value_of(other)

    def __gt__(self, other: object) -> bool:
        return self.value > value_of(other)

    def __ge__(self, other: object) -> bool:
        return self.value >= value_of(other)

    def __hash__(self) -> int:
        return hash(self.value)

    def sqrt(self) -> object:
        """The square root, which NumPy asks for by this name."""
        return traced(math.sqrt(self.value), sympy.sqrt(self.expression))


def combine(left: object, right: object, operation: Callable[..., object]) -> object:
    """An operation on values and expressions alike; arrays are left to NumPy."""
    if isinstance(left, np.ndarray) or isinstance(right, np.ndarray):
        return NotImplemented
    return traced(operation(value_of(left), value_of(right)), operation(expression_of(left), expression_of(right)))


def traced(value: object, expression: object) -> object:
    """A traced number, or zero."""
    return 0.0 if expression == 0 else Traced(value_of(value), sympy.sympify(expression))


def value_of(number: object) -> float:
    """The float of a number, traced or not."""
    return number.value if isinstance(number, Traced) else float(number)  # type: ignore[arg-type]


def expression_of(number: object) -> sympy.Expr:
    """The exact expression of a number, traced or not."""
    if isinstance(number, Traced):
        return number.expression
    plain = value_of(number)
    return sympy.Integer(int(plain)) if plain.is_integer() else sympy.Rational(repr(plain))


def exact(number: object) -> object:
    """A float as a traced number; zero and one, of which axes are made, stay floats."""
    plain = isinstance(number, Traced) or value_of(number) in {-1.0, 0.0, 1.0}
    return number if plain else Traced(value_of(number), expression_of(number))


def function(name: str) -> Callable[[object], object]:
    """A function of the vehicle file's expressions, for numbers traced or not."""
    on_value, on_expression = getattr(math, name), getattr(sympy, name)
    return lambda number: traced(on_value(value_of(number)), on_expression(expression_of(number)))


def values(array: Array) -> Array:
    """The values of an array of numbers, traced or not."""
    return np.array([value_of(number) for number in array.flat], dtype=float).reshape(array.shape)
