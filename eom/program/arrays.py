"""Arrays of nodes: NumPy's functions, written down on a tape instead of computed."""

import functools
from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np

from eom.program.call import called
from eom.program.operations import BRANCH, VALUES, Op
from eom.program.tape import Node, Tape, binary, both, chosen

MANY = 4
"""So many elementary functions of the same kind at once are a call over lanes."""


def elementwise(function: Callable[..., Any], arity: int) -> Callable[..., Any]:
    """A function of scalars over arrays of objects."""
    made: Callable[..., Any] = np.frompyfunc(function, arity, 1)
    return made


def one(op: Op) -> Callable[..., Any]:
    """An operation on one node."""
    return elementwise(lambda a: a.apply(op) if isinstance(a, Node) else float(VALUES[op](a)), 1)


def two(op: Op) -> Callable[..., Any]:
    """An operation on two numbers or nodes."""
    return elementwise(lambda a, b: binary(op, a, b), 2)


def equal(a: Any, b: Any) -> Node:
    """1 where two constants are equal, else 0; a parameter is never like a constant, or it would be one."""
    a, b = both(a, b)
    tape: Tape = a.tape
    for one_ in (a, b):
        kind, index = one_.op[:2]
        if kind not in {Op.CONST, Op.PARAMETER} or (kind == Op.PARAMETER and index in tape.vanishing):
            raise TypeError(BRANCH)
    return tape.constant(float(a.place == b.place))


def infinite(a: Node) -> Node:
    """1 for a constant that is infinite; what a run computes is not."""
    kind, index = a.op[:2]
    if kind == Op.PARAMETER and index in a.tape.vanishing:
        raise TypeError(BRANCH)
    return a.tape.constant(float(a.value is not None and np.isinf(a.value)))


class NodeArray(np.ndarray[Any, np.dtype[np.object_]]):
    """An array of nodes that NumPy's functions take like one of numbers."""

    UFUNCS: ClassVar[dict[str, Callable[..., Any]]] = {
        "maximum": two(Op.MAX),
        "minimum": two(Op.MIN),
        "greater": elementwise(lambda a, b: binary(Op.LESS, b, a), 2),
        "less": two(Op.LESS),
        "equal": elementwise(equal, 2),
        "not_equal": elementwise(lambda a, b: 1.0 - equal(a, b), 2),
        "copysign": two(Op.COPYSIGN),
        "absolute": one(Op.ABS),
        "sqrt": one(Op.SQRT),
        "floor": one(Op.FLOOR),
        "isinf": elementwise(infinite, 1),
    }
    TRANSCENDENTAL: ClassVar[dict[str, Op]] = {
        name: Op[name.upper()] for name in ("sin", "cos", "tan", "arctan", "exp", "log")
    }

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, out: Any = None, **options: Any) -> Any:
        """Any elementwise function, or its reduction."""
        plain = [item.view(np.ndarray) if isinstance(item, NodeArray) else item for item in inputs]
        if method == "__call__" and ufunc.__name__ in self.TRANSCENDENTAL:
            result = transcendental(self.TRANSCENDENTAL[ufunc.__name__], plain[0])
        elif method == "__call__" and ufunc.__name__ in self.UFUNCS:
            result = self.UFUNCS[ufunc.__name__](*plain)
        elif method == "__call__" and ufunc.__name__ == "matmul":
            result = product(*(np.asarray(item, dtype=object) for item in plain))
        elif method == "reduce" and ufunc.__name__ == "add" and options["axis"] is not None:
            result = np.apply_along_axis(lambda row: balanced(list(row)), options["axis"], plain[0])
        elif method == "reduce" and ufunc.__name__ in self.UFUNCS:
            function, axis = self.UFUNCS[ufunc.__name__], options["axis"]
            result = functools.reduce(function, np.moveaxis(plain[0], axis, 0))
        else:
            result = getattr(ufunc, method)(*plain, **options)
        if out is None:
            return as_nodes(result)
        out[0][...] = result
        return out[0]

    def __array_function__(self, func: Any, types: Any, args: Any, kwargs: Any) -> Any:
        """Functions that are not elementwise; most are made of those that are."""
        match func.__name__:
            case "where":
                return as_nodes(elementwise(chosen, 3)(*(np.asarray(item, dtype=object) for item in args)))
            case "result_type":
                return np.dtype(object)
            case "solve":
                return as_nodes(solved(*(np.asarray(item, dtype=object) for item in args)))
        result = super().__array_function__(func, types, args, kwargs)
        return as_nodes(result) if isinstance(result, np.ndarray) and result.dtype == object else result

    def over_lanes(self, function: Any, coefficients: Any, arguments: list[Any]) -> Any:
        """``function(coefficients, *arguments)`` of arrays over lanes as one call, (rows, lanes)."""
        tape, count = tape_of(self), len(arguments[0])

        def places(values: Any) -> tuple[int, ...]:
            """Places of the nodes of an array over lanes, numbers written down as constants."""
            row = np.broadcast_to(np.asarray(values, dtype=object), (count,))
            return tuple((item if isinstance(item, Node) else tape.constant(float(item))).place for item in row)

        names: tuple[str, ...] = () if coefficients is None else coefficients.names
        given = [places(values) for values in (*(getattr(coefficients, name) for name in names), *arguments)]

        def in_one(nodes: Sequence[Node]) -> list[Node]:
            """The function in one lane."""
            values = [as_nodes(node) for node in nodes]
            own = () if coefficients is None else (SimpleNamespace(**dict(zip(names, values, strict=False))),)
            found = function(*own, *values[len(names) :])
            return [nodes[0].lifted(np.asarray(item, dtype=object).item()) for item in found]

        return as_nodes(called(tape, in_one, given))

    def solve_positive(self, right: Any) -> Any:
        """Solution of a system whose matrix this is, symmetric and positive definite: by L D L'."""
        n = len(self)
        order = elimination_order(self)
        matrix = self[np.ix_(order, order)]
        L = np.zeros((n, n), dtype=object)
        pivots: list[Any] = []
        inverse: list[Any] = []
        for j in range(n):
            moved = [L[j, k] * pivots[k] for k in range(j)]
            for i in range(j, n):
                left = matrix[i, j]
                for k in range(j):
                    left = left - L[i, k] * moved[k]
                if i == j:
                    pivots.append(left)
                    inverse.append(1.0 / left)
                else:
                    L[i, j] = left * inverse[j]
        x = [right[i] for i in order]
        for i in range(n):
            for k in range(i):
                x[i] = x[i] - L[i, k] * x[k]
        x = [value * own for value, own in zip(x, inverse, strict=True)]
        for i in reversed(range(n)):
            for k in range(i + 1, n):
                x[i] = x[i] - L[k, i] * x[k]
        return as_nodes(np.array(x, dtype=object)[np.argsort(order)])


def elimination_order(matrix: Any) -> list[int]:
    """The unknowns of a symmetric system: next is one that fewest of the others are left coupled to."""
    coupled = {i: {j for j in range(len(matrix)) if j != i and not zero(matrix[i, j])} for i in range(len(matrix))}
    order: list[int] = []
    while coupled:
        following = min(coupled, key=lambda i: (len(coupled[i]), -i))
        others = coupled.pop(following)
        for i in others:
            coupled[i] = (coupled[i] | others) - {following, i}
        order.append(following)
    return order


def balanced(terms: list[Any]) -> Any:
    """The sum of terms, in pairs: short chains of operations are what a processor can do side by side."""
    while len(terms) > 1:
        terms = [sum(terms[k + 1 : k + 2], terms[k]) for k in range(0, len(terms), 2)]
    return terms[0]


def product(left: Any, right: Any) -> Any:
    """A product of matrices or vectors of nodes; what is zero takes no part."""
    node = next((item for item in (*left.flat, *right.flat) if isinstance(item, Node)), None)
    nothing = 0.0 if node is None else node.lifted(0.0)
    rows, columns = np.atleast_2d(left), right if right.ndim == 2 else right[:, np.newaxis]
    result = np.empty((len(rows), columns.shape[1]), dtype=object)
    nonzero = [[(k, item) for k, item in enumerate(row) if not zero(item)] for row in rows]
    for j, column in enumerate(columns.T):
        for i, row in enumerate(nonzero):
            result[i, j] = balanced([item * column[k] for k, item in row if not zero(column[k])] or [nothing])
    return result.reshape((*left.shape[:-1], *right.shape[1:]))[()]


def zero(item: Any) -> bool:
    """Whether a number is known to be zero."""
    return (item.value if isinstance(item, Node) else item) == 0.0


def as_nodes(array: Any) -> Any:
    """An array of objects as an array of nodes."""
    return np.asarray(array, dtype=object).view(NodeArray)


def tape_of(array: Any) -> Tape:
    """The tape of the first node in an array."""
    tape: Tape = next(item.tape for item in np.asarray(array, dtype=object).flat if isinstance(item, Node))
    return tape


def transcendental(op: Op, array: Any) -> Any:
    """A function that takes long: of many numbers at once it is a call over lanes."""
    array = np.asarray(array, dtype=object)
    nodes = list(dict.fromkeys(item.place for item in array.flat if isinstance(item, Node) and item.value is None))
    if len(nodes) < MANY:
        return one(op)(array)
    tape = tape_of(array)
    (found,) = called(tape, lambda given: [given[0].apply(op)], [tuple(nodes)])
    lanes = dict(zip(nodes, found, strict=True))
    known = one(op)

    def value(item: Any) -> Any:
        """The function of one number."""
        return lanes[item.place] if isinstance(item, Node) and item.place in lanes else known(item)

    return elementwise(value, 1)(array)


def solved(matrix: Any, right: Any) -> Any:
    """Solution of a small system by elimination without pivots: its diagonal must dominate."""
    matrix, right = matrix.copy(), right.copy()
    n = len(matrix)
    for j in range(n):
        for i in range(j + 1, n):
            factor = matrix[i, j] / matrix[j, j]
            for k in range(j + 1, n):
                matrix[i, k] = matrix[i, k] - factor * matrix[j, k]
            right[i] = right[i] - factor * right[j]
    for i in reversed(range(n)):
        for k in range(i + 1, n):
            right[i] = right[i] - matrix[i, k] * right[k]
        right[i] = right[i] / matrix[i, i]
    return right
