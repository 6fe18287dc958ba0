"""Traced numbers: what they compute is what floats compute, and their expressions say how."""

import math
from typing import Any, cast

import numpy as np
import pytest
import sympy
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from eom.assembly.algebra import Algebra, DenseFactor
from eom.assembly.matrices import assemble_matrices
from eom.assembly.pivots import choose_coordinates
from eom.assembly.vectors import Array
from eom.model.field import EXACT, canonical, shaped
from eom.model.traced import Traced, exact, expression_of, function, traced, value_of, values
from tests.assembly.random_systems import Recipe, build, recipes

X, Y = Traced(1.5, sympy.Symbol("x")), Traced(-0.25, sympy.Symbol("y"))
AT = {sympy.Symbol("x"): sympy.Rational(3, 2), sympy.Symbol("y"): sympy.Rational(-1, 4)}


@st.composite
def computed(draw: st.DrawFn, depth: int = 4) -> Any:
    """A number computed from x, y and floats by random operations."""
    if depth == 0 or draw(st.booleans()):
        return draw(st.sampled_from([X, Y, 2.0, -0.5, 1.0, np.float64(3.0)]))
    left, right = draw(computed(depth - 1)), draw(computed(depth - 1))
    match draw(st.sampled_from("+-*/~a")):
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            assume(value_of(right) != 0.0)
            return left / right
        case "~":
            return -left
        case _:
            return abs(left)


@given(computed())
def test_the_value_of_a_computed_number_is_that_of_its_expression(number: Any) -> None:
    # some ten operations in double precision against exact ones
    assert value_of(number) == pytest.approx(float(expression_of(number).xreplace(AT)), rel=1e-12, abs=1e-12)


def test_comparisons_go_by_the_value() -> None:
    assert X > Y
    assert Y < 0.0 < X
    assert X >= 1.5
    assert X <= 1.5
    assert X == 1.5
    assert abs(Y) == 0.25
    assert traced(0.0, sympy.Symbol("z"))
    assert not traced(0.0, sympy.S.Zero)
    assert np.argmax(np.array([Y, X])) == 1


def test_what_is_exactly_zero_is_no_symbol() -> None:
    assert type(X - X) is float
    assert type(X * 0.0) is float
    # it is not known to be zero before it is expanded
    x, y = cast("tuple[Any, Any]", (X, Y))
    hidden = (x + y) * x - x * x - y * x
    assert canonical(shaped([hidden], (1,)))[0] == 0


def test_floats_stand_for_their_decimals() -> None:
    assert expression_of(0.705) == sympy.Rational(705, 1000)
    assert expression_of(exact(-1.999)) == sympy.Rational(-1999, 1000)


@pytest.mark.parametrize("name", ["sqrt", "sin", "cos", "tan", "asin", "acos", "atan"])
def test_functions_keep_their_name(name: str) -> None:
    x = Traced(0.5, sympy.Symbol("x"))
    result = function(name)(x)
    assert value_of(result) == getattr(math, name)(0.5)
    assert expression_of(result) == getattr(sympy, name)(sympy.Symbol("x"))


def traced_system(item: Any) -> Any:
    """The same elements with traced numbers for floats."""
    if isinstance(item, tuple):
        parts = [traced_system(part) for part in item]
        return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
    return exact(item) if isinstance(item, float) else item


class Solved:
    """A factor that solves in floats: exact solutions of skew random systems have no end."""

    def __init__(self, A: Array) -> None:
        self.plain = DenseFactor(values(A))

    def solve(self, right: Array) -> Array:
        return cast("Array", np.vectorize(exact, otypes=[object])(self.plain.solve(values(right))))

    def solve_transposed(self, right: Array) -> Array:
        return cast("Array", np.vectorize(exact, otypes=[object])(self.plain.solve_transposed(values(right))))

    def smallest(self) -> float:
        return self.plain.smallest()


MATRICES = ("M", "C", "K", "V", "J", "Jn", "H", "H_slip", "D_slip", "F", "G", "f")


@settings(max_examples=40, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(recipes())
def test_assembly_of_traced_numbers_has_the_values_of_assembly_of_floats(recipe: Recipe) -> None:
    system = build(recipe)
    # membranes have no symbolic form
    assume(not system.triangles)
    pivots = choose_coordinates(system)
    plain = assemble_matrices(system, pivots)
    algebra = Algebra(EXACT.build, Solved)
    own = assemble_matrices(traced_system(system), pivots, algebra, lambda *_, **__: plain.statics)
    for name in MATRICES:
        expected, got = getattr(plain, name), values(getattr(own, name))
        # the same sums, some of them in another order
        np.testing.assert_allclose(got, expected, rtol=0.0, atol=1e-12 * np.max(np.abs(expected), initial=1.0))
    for name in ("T", "W", "Z"):
        expected = getattr(plain.reduction, name)
        # the solved coordinates feel the condition of the joints' rows
        got = values(getattr(own.reduction, name))
        np.testing.assert_allclose(got, expected, rtol=0.0, atol=1e-9 * np.max(np.abs(expected), initial=1.0))
