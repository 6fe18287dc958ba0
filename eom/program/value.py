"""Numbers in a function that is being written for LLVM, one or several side by side, with all operations on them."""

from collections.abc import Callable
from importlib import import_module
from typing import Any

from eom.program import elementary
from eom.program.operations import Op

SLOPPY = ("contract",)
"""A product and a sum may be one instruction: more exact, not less."""


class Value:
    """A number, or several at once, in a function that is being written."""

    __slots__ = ("builder", "item")

    def __init__(self, builder: Any, item: Any) -> None:
        self.builder, self.item = builder, item

    def of(self, other: object) -> Any:
        """Another value, or a number, as an operand."""
        return other.item if isinstance(other, Value) else constant(self.item.type, float(other))  # type: ignore[arg-type]

    def new(self, item: Any) -> "Value":
        """A value of the same function."""
        return Value(self.builder, item)

    def __add__(self, other: object) -> "Value":
        return self.new(self.builder.fadd(self.item, self.of(other), flags=SLOPPY))

    __radd__ = __add__

    def __sub__(self, other: object) -> "Value":
        return self.new(self.builder.fsub(self.item, self.of(other), flags=SLOPPY))

    def __rsub__(self, other: object) -> "Value":
        return self.new(self.builder.fsub(self.of(other), self.item, flags=SLOPPY))

    def __mul__(self, other: object) -> "Value":
        return self.new(self.builder.fmul(self.item, self.of(other), flags=SLOPPY))

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> "Value":
        return self.new(self.builder.fdiv(self.item, self.of(other)))

    def __neg__(self) -> "Value":
        return self.new(self.builder.fneg(self.item))

    def less(self, other: object) -> "Value":
        """Whether it is less than another, one or more bits."""
        return self.new(self.builder.fcmp_ordered("<", self.item, self.of(other)))

    def pick(self, then: Any, other: Any) -> "Value":
        """Of bits: one of two values."""
        like = then if isinstance(then, Value) else other
        if not isinstance(like, Value):
            like = self.new(constant(lanes_of(self.item.type, double()), 0.0))
        return self.new(self.builder.select(self.item, like.of(then), like.of(other)))

    def library(self, name: str, *others: "Value") -> "Value":
        """An instruction that LLVM has under a name."""
        ir = import_module("llvmlite.ir")
        kind, module = self.item.type, self.builder.module
        full = f"llvm.{name}.{'f64' if kind == double() else f'v{kind.count}f64'}"
        function = module.globals.get(full) or ir.Function(
            module, ir.FunctionType(kind, [kind] * (1 + len(others))), full
        )
        return self.new(self.builder.call(function, [self.item, *(other.item for other in others)]))

    def absolute(self) -> "Value":
        """|x|."""
        return self.library("fabs")

    def floored(self) -> "Value":
        """The largest whole number that is not larger."""
        return self.library("floor")

    def root(self) -> "Value":
        """The square root."""
        return self.library("sqrt")

    def signed_as(self, other: "Value") -> "Value":
        """Its size with the sign of another."""
        return self.library("copysign", other)

    def power_of_two(self) -> "Value":
        """2 to a whole number, by its exponent's bits."""
        whole = lanes_of(self.item.type, integer())
        shifted = self.builder.add(self.builder.fptosi(self.item, whole), constant(whole, 1023))
        return self.new(self.builder.bitcast(self.builder.shl(shifted, constant(whole, 52)), self.item.type))

    def split(self) -> tuple["Value", "Value"]:
        """M and e with x = m 2^e and 1 <= m < 2, of x > 0."""
        kind = self.item.type
        whole = lanes_of(kind, integer())
        bits = self.builder.bitcast(self.item, whole)
        exponent = self.builder.sub(self.builder.lshr(bits, constant(whole, 52)), constant(whole, 1023))
        rest = self.builder.and_(bits, constant(whole, 0x000FFFFFFFFFFFFF))
        one = self.builder.or_(rest, constant(whole, 0x3FF0000000000000))
        return self.new(self.builder.bitcast(one, kind)), self.new(self.builder.sitofp(exponent, kind))


def double() -> Any:
    """LLVM's type of a number."""
    return import_module("llvmlite.ir").DoubleType()


def integer() -> Any:
    """LLVM's type of an index."""
    return import_module("llvmlite.ir").IntType(64)


def lanes_of(kind: Any, element: Any) -> Any:
    """As many elements as a type has."""
    return import_module("llvmlite.ir").VectorType(element, kind.count) if hasattr(kind, "count") else element


def constant(kind: Any, value: float) -> Any:
    """A number, in every lane of a type."""
    ir = import_module("llvmlite.ir")
    if hasattr(kind, "count"):
        return ir.Constant(kind, [ir.Constant(kind.element, value)] * kind.count)
    return ir.Constant(kind, value)


WRITTEN: dict[Op, Callable[..., Value]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.ABS: Value.absolute,
    Op.SQRT: Value.root,
    Op.FLOOR: Value.floored,
    Op.SIN: elementary.sine,
    Op.COS: elementary.cosine,
    Op.TAN: elementary.tangent,
    Op.ARCTAN: elementary.arctangent,
    Op.EXP: elementary.exponential,
    Op.LOG: elementary.logarithm,
    # the first one where either is no number
    Op.MAX: lambda a, b: a.less(b).pick(b, a),
    Op.MIN: lambda a, b: b.less(a).pick(b, a),
    Op.COPYSIGN: Value.signed_as,
    Op.LESS: lambda a, b: a.less(b).pick(1.0, 0.0),
    Op.CHOOSE: lambda test, then, other: (-test.absolute()).less(0.0).pick(then, other),
}
