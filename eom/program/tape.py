"""A tape of scalar operations: what functions of arrays do, written down once, without what is zero or said twice."""

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from eom.program.operations import BRANCH, LEAVES, VALUES, VARYING, Op

if TYPE_CHECKING:
    from eom.program.call import Call


@dataclass
class Tape:
    """Operations in the order of their first use; equal ones are one.

    ``samples`` are the parameters of one case, ``vanishing`` those that are zero in some cases; ``alone`` are places of
    numbers that are no part of an array, ``asked`` the parameters among them whose sign decided a branch; ``varying``
    says of each place whether it varies in a run.
    """

    ops: list[tuple[int, ...]] = field(default_factory=list)
    constants: list[float] = field(default_factory=list)
    calls: list["Call"] = field(default_factory=list)
    samples: list[float] = field(default_factory=list)
    vanishing: set[int] = field(default_factory=set)
    alone: set[int] = field(default_factory=set)
    asked: set[int] = field(default_factory=set)
    varying: list[bool] = field(default_factory=list)
    places: dict[tuple[int, ...], int] = field(default_factory=dict)
    known: dict[float | str, int] = field(default_factory=dict)

    def node(self, op: Op, *args: int) -> "Node":
        """The node of an operation, an old one if it was done before."""
        key = (int(op), *args)
        place = self.places.setdefault(key, len(self.ops))
        if place == len(self.ops):
            self.ops.append(key)
            self.varying.append(op in VARYING or (op not in LEAVES and any(self.varying[arg] for arg in args)))
        return Node(self, place)

    def constant(self, value: float) -> "Node":
        """The node of a number; minus zero is zero."""
        value = float(value) + 0.0
        index = self.known.setdefault(value, len(self.constants))
        if index == len(self.constants):
            self.constants.append(value)
        return self.node(Op.CONST, index)


class Node:
    """One scalar on a tape; arithmetic with it is written down, constants are folded."""

    __slots__ = ("place", "tape")

    def __init__(self, tape: Tape, place: int) -> None:
        self.tape, self.place = tape, place

    @property
    def op(self) -> tuple[int, ...]:
        """Its operation with its arguments."""
        return self.tape.ops[self.place]

    @property
    def value(self) -> float | None:
        """The number, if it is constant."""
        op = self.op
        return self.tape.constants[op[1]] if op[0] == Op.CONST else None

    def lifted(self, other: object) -> "Node":
        """A number as a node of the same tape."""
        return other if isinstance(other, Node) else self.tape.constant(float(other))  # type: ignore[arg-type]

    def apply(self, op: Op, *others: object) -> "Node":
        """An operation on this node and others."""
        nodes = [self, *map(self.lifted, others)]
        values = [node.value for node in nodes]
        if None not in values:
            return self.tape.constant(float(VALUES[op](*map(np.float64, values))))
        return self.tape.node(op, *(node.place for node in nodes))

    def sin(self) -> "Node":
        """The sine; NumPy asks for functions of objects by these names."""
        return self.apply(Op.SIN)

    def cos(self) -> "Node":
        """The cosine."""
        return self.apply(Op.COS)

    def arctan(self) -> "Node":
        """The arctangent."""
        return self.apply(Op.ARCTAN)

    def tan(self) -> "Node":
        """The tangent."""
        return self.apply(Op.TAN)

    def exp(self) -> "Node":
        """The exponential."""
        return self.apply(Op.EXP)

    def log(self) -> "Node":
        """The natural logarithm."""
        return self.apply(Op.LOG)

    def sqrt(self) -> "Node":
        """The square root."""
        return self.apply(Op.SQRT)

    def __bool__(self) -> bool:
        if self.value is None:
            raise TypeError(BRANCH)
        return bool(self.value)

    def __gt__(self, other: object) -> bool:
        op, value = self.op, self.value
        if op[0] == Op.PARAMETER and self.place in self.tape.alone and other == 0.0:
            self.tape.asked.add(op[1])
            value = self.tape.samples[op[1]]
        if value is None:
            raise TypeError(BRANCH)
        return value > float(other)  # type: ignore[arg-type]

    def __eq__(self, other: object) -> bool:
        raise TypeError(BRANCH)

    def __hash__(self) -> int:
        return hash(self.place)

    def __abs__(self) -> "Node":
        return self.apply(Op.ABS)

    def __add__(self, other: object) -> "Node":
        if isinstance(other, np.ndarray):
            return NotImplemented
        node = self.lifted(other)
        if self.value == 0.0 or node.value == 0.0:
            return node if self.value == 0.0 else self
        if node.op[0] == Op.NEG:
            return self - Node(self.tape, node.op[1])
        if self.op[0] == Op.NEG:
            return node - Node(self.tape, self.op[1])
        return self.apply(Op.ADD, node) if self.place <= node.place else node.apply(Op.ADD, self)

    def __radd__(self, other: object) -> "Node":
        return self + other

    def __neg__(self) -> "Node":
        return Node(self.tape, self.op[1]) if self.op[0] == Op.NEG else self.apply(Op.NEG)

    def __sub__(self, other: object) -> "Node":
        if isinstance(other, np.ndarray):
            return NotImplemented
        node = self.lifted(other)
        if node.value == 0.0:
            return self
        if self.value == 0.0:
            return -node
        if self.place == node.place:
            return self.tape.constant(0.0)
        if node.op[0] == Op.NEG:
            return self + Node(self.tape, node.op[1])
        return self.apply(Op.SUB, node)

    def __rsub__(self, other: object) -> "Node":
        return self.lifted(other) - self

    def __mul__(self, other: object) -> "Node":
        if isinstance(other, np.ndarray):
            return NotImplemented
        node = self.lifted(other)
        for one, rest in ((self, node), (node, self)):
            match one.value:
                case 0.0:
                    return one
                case 1.0:
                    return rest
                case -1.0:
                    return -rest
            if one.op[0] == Op.NEG:
                return -(Node(self.tape, one.op[1]) * rest)
        return self.apply(Op.MUL, node) if self.place <= node.place else node.apply(Op.MUL, self)

    def __rmul__(self, other: object) -> "Node":
        return self * other

    def __truediv__(self, other: object) -> "Node":
        if isinstance(other, np.ndarray):
            return NotImplemented
        node = self.lifted(other)
        if self.value == 0.0 or node.value == 1.0:
            return self
        if self.tape.varying[self.place] and not self.tape.varying[node.place]:
            # a product is many times as fast as a quotient, and its reciprocal is computed beforehand
            return self * (1.0 / node)
        return self.apply(Op.DIV, node)

    def __rtruediv__(self, other: object) -> "Node":
        return self.lifted(other) / self


def binary(op: Op, a: Any, b: Any) -> Any:
    """An operation on two numbers, of which any may be a node."""
    if not (isinstance(a, Node) or isinstance(b, Node)):
        return float(VALUES[op](a, b))
    a, b = both(a, b)
    neutral = {Op.MAX: -math.inf, Op.MIN: math.inf}.get(op)
    if neutral is not None and neutral in {a.value, b.value}:
        return b if a.value == neutral else a
    return a if a.place == b.place and neutral is not None else a.apply(op, b)


def chosen(test: Any, then: Any, other: Any) -> Any:
    """One of two numbers by a test; any of the three may be a node."""
    nodes = [item for item in (test, then, other) if isinstance(item, Node)]
    if not nodes:
        return then if test else other
    test, then, other = map(nodes[0].lifted, (test, then, other))
    if test.value is not None:
        return then if test.value != 0.0 else other
    return then if then.place == other.place else test.apply(Op.CHOOSE, then, other)


def both(a: Any, b: Any) -> tuple[Node, Node]:
    """Two numbers, one of which is a node, as nodes."""
    node: Node = a if isinstance(a, Node) else b
    return node.lifted(a), node.lifted(b)
