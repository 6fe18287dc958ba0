"""Exact algebra of traced matrices: rational functions of symbols in one canonical form.

Roots and trigonometric functions stand as symbols of their own while equations are solved.
"""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple, cast

import numpy as np
import sympy
from sympy.polys.domains import FractionField
from sympy.polys.fields import FracElement
from sympy.polys.matrices import DomainMatrix

from eom.assembly.algebra import Algebra, DenseFactor, Entry
from eom.assembly.vectors import Array
from eom.model.traced import expression_of, traced, values


class Rational(NamedTuple):
    """The rational functions of some symbols; ``names`` are the symbols that stand for other functions."""

    domain: FractionField
    names: dict[sympy.Expr, sympy.Symbol]

    def elements(self, array: Array) -> Array:
        """An array of traced numbers as elements of the field."""
        entries = (self.domain.from_sympy(expression_of(entry).xreplace(self.names)) for entry in array.flat)
        return shaped(entries, array.shape)

    def expressions(self, array: Array) -> Array:
        """An array of the field's elements, zeros and ones as expressions, in canonical form."""
        functions = {symbol: function for function, symbol in self.names.items()}
        entries = (self.expression(entry).xreplace(functions) for entry in array.flat)
        return shaped(entries, array.shape)

    def expression(self, entry: object) -> sympy.Expr:
        """One element, or a number, as an expression."""
        return self.domain.to_sympy(entry) if isinstance(entry, FracElement) else sympy.Integer(entry)


def shaped(entries: Iterable[object], shape: tuple[int, ...]) -> Array:
    """Objects as an array, typed as the numbers that they stand for."""
    result = np.empty(int(np.prod(shape)), dtype=object)
    for k, entry in enumerate(entries):
        result[k] = entry
    return cast("Array", result.reshape(shape))


def rational_field(arrays: Iterable[Array]) -> Rational:
    """The smallest field that holds the entries of some arrays of traced numbers."""
    symbols: set[sympy.Symbol] = set()
    names: dict[sympy.Expr, sympy.Symbol] = {}
    for array in arrays:
        for entry in array.flat:
            expression = expression_of(entry)
            for part in outermost_functions(expression):
                names.setdefault(part, sympy.Dummy(f"f{len(names)}"))
            symbols |= expression.xreplace(names).free_symbols
    # a field needs a symbol, also for plain numbers
    generators = sorted(symbols, key=str) or [sympy.Dummy("none")]
    return Rational(sympy.QQ.frac_field(*generators), names)


def outermost_functions(expression: sympy.Expr) -> Iterator[sympy.Expr]:
    """Roots and functions in an expression, not those inside others."""
    if isinstance(expression, sympy.Function) or (expression.is_Pow and not expression.exp.is_Integer):
        yield expression
        return
    for part in expression.args:
        yield from outermost_functions(part)


def canonical(array: Array) -> Array:
    """The expressions of an array of traced numbers, expanded, so that what is identically zero is zero."""
    field = rational_field([array])
    return field.expressions(field.elements(array))


class ExactFactor:
    """A regular matrix of traced numbers, solved with exactly."""

    def __init__(self, A: Array) -> None:
        self.A = A
        self.plain = DenseFactor(values(A))

    def solve(self, right: Array) -> Array:
        """Solution x of A x = *right*."""
        return self.solution(self.A, right, self.plain.solve(values(right)))

    def solve_transposed(self, right: Array) -> Array:
        """Solution x of A' x = *right*."""
        return self.solution(self.A.T, right, self.plain.solve_transposed(values(right)))

    def solution(self, A: Array, right: Array, numbers: Array) -> Array:
        """Solution with its *numbers* known."""
        columns = right.reshape(len(A), -1)
        field = rational_field([A, columns])
        both = np.hstack([A, columns])
        system: Any = DomainMatrix(field.elements(both).tolist(), both.shape, field.domain)
        solved = system.to_sparse().rref()[0].to_dense().to_list()
        expressions = field.expressions(shaped((e for row in solved for e in row[len(A) :]), columns.shape))
        entries = (traced(n, e) for n, e in zip(numbers.flat, expressions.flat, strict=True))
        return shaped(entries, right.shape)

    def smallest(self) -> float:
        """A lower bound of the smallest singular value at the trim."""
        return self.plain.smallest()


def build(shape: tuple[int, int], entries: Iterable[Entry]) -> Array:
    """A matrix of traced numbers from its entries."""
    matrix = np.full(shape, 0.0, dtype=object)
    for rows, columns, own in entries:
        matrix[rows[:, np.newaxis], columns] += own
    return cast("Array", matrix)


EXACT = Algebra(build, ExactFactor)
