"""A plan as machine code: straight lines of arithmetic, and loops over lanes, several to a vector register.

What compilers do with loops and arrays is not needed where everything is known beforehand; so instructions are handed
to LLVM one by one.
"""

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any

from eom.program import elementary
from eom.program.object_code import ENTRY
from eom.program.plan import Launch, Plan
from eom.program.tape import Op

POINTERS = ("state", "input", "parameters", "scratch", "results")
WIDE = 20
"""Lanes side by side: several vector registers, which hide each other's latency."""
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


class Memory:
    """The arrays of a function that is being written, by name."""

    def __init__(self, builder: Any, pointers: dict[str, Any]) -> None:
        self.builder, self.pointers = builder, pointers

    def place(self, name: str, index: int, begin: Any = None, kind: Any = None) -> Any:
        """Pointer to an element, counted from a *begin* that is known at run time only, of a kind of vector."""
        at = constant(integer(), index)
        at = at if begin is None else self.builder.add(begin, at)
        pointer = self.builder.gep(self.pointers[name], [at], inbounds=True)
        return pointer if kind is None else self.builder.bitcast(pointer, kind.as_pointer())

    def load(self, name: str, index: int, begin: Any = None, kind: Any = None) -> Value:
        """An element, or several from there on."""
        item = self.builder.load(self.place(name, index, begin, kind))
        item.align = 8
        return Value(self.builder, item)

    def store(self, value: Value, name: str, index: int, begin: Any = None) -> None:
        """Set an element, or several from there on."""
        kind = value.item.type
        pointer = self.place(name, index, begin, None if kind == double() else kind)
        self.builder.store(value.item, pointer).align = 8


def write(plan: Plan, builder: Any, pointers: Sequence[Any], level: Any) -> None:
    """Write the instructions of a plan: results of levels up to *level*, which is known at run time only."""
    memory = Memory(builder, dict(zip(POINTERS, pointers, strict=True)))
    for stage, launches in enumerate(plan.launches):
        write_stage(plan, stage, memory, level)
        for launch in launches:
            wanted = min(plan.call_levels[index] for index, _ in launch.lanes)
            with builder.if_then(builder.icmp_signed(">=", level, constant(integer(), wanted))):
                write_lanes(launch, memory)


def write_stage(plan: Plan, stage: int, memory: Memory, level: Any) -> None:
    """Scalar operations of a stage, arguments of the calls that follow, and results in the last one."""
    values, builder = Values(plan, memory), memory.builder

    def write_level(k: int) -> None:
        """What a level needs, and those after it."""
        for place in plan.stages[stage][k]:
            values.compute(place)
        for item in plan.launches[stage]:
            fill_lanes(plan, item, k, values)
        if stage == len(plan.stages) - 1:
            first = sum(len(group) for group in plan.roots[:k])
            for row, place in enumerate(plan.roots[k]):
                memory.store(values.of(place), "results", first + row)
        if k + 1 < len(plan.roots):
            with builder.if_then(builder.icmp_signed(">", level, constant(integer(), k))):
                write_level(k + 1)

    write_level(0)


def fill_lanes(plan: Plan, item: Launch, level: int, values: "Values") -> None:
    """Set the arguments of a launch that are not there already, of the calls that a level needs first."""
    for lane, (index, own) in enumerate(item.lanes):
        if plan.call_levels[index] == level:
            for row in item.filled:
                place = plan.tape.calls[index].arguments[row][own]
                values.memory.store(values.of(place), "scratch", item.arguments[row] + lane)


class Values:
    """The values of places in a stage."""

    def __init__(self, plan: Plan, memory: Memory) -> None:
        self.plan, self.memory = plan, memory
        self.parameter = {place: k for k, place in reversed(list(enumerate(plan.parameters)))}
        self.result = {
            pair: (item, lane)
            for launches in plan.launches
            for item in launches
            for lane, pair in enumerate(item.lanes)
        }
        self.known: dict[int, Value] = {}

    def of(self, place: int) -> Value:
        """The value of a place: computed in this stage, or loaded."""
        if place not in self.known:
            self.known[place] = self.loaded(place)
        return self.known[place]

    def loaded(self, place: int) -> Value:
        """A value from where it stands in memory."""
        op, *args = self.plan.tape.ops[place]
        if op == Op.CONST:
            return Value(self.memory.builder, constant(double(), self.plan.tape.constants[args[0]]))
        if place in self.parameter:
            return self.memory.load("parameters", self.parameter[place])
        if op in {Op.STATE, Op.INPUT}:
            return self.memory.load("state" if op == Op.STATE else "input", args[0])
        if op == Op.LANE:
            item, lane = self.result[args[0], args[2]]
            return self.memory.load("scratch", item.results + item.stride * args[1] + lane)
        return self.memory.load("scratch", self.plan.slots[place])

    def compute(self, place: int) -> None:
        """Do an operation; what later stages need is kept."""
        op, *args = self.plan.tape.ops[place]
        self.known[place] = WRITTEN[Op(op)](*map(self.of, args))
        if place in self.plan.slots:
            self.memory.store(self.known[place], "scratch", self.plan.slots[place])


def write_lanes(launch: Launch, memory: Memory) -> None:
    """A loop over the lanes of a call, and half a block if that is what is left."""
    whole = launch.stride // WIDE * WIDE
    if whole:
        builder = memory.builder
        before, body, after = builder.block, builder.append_basic_block(), builder.append_basic_block()
        builder.branch(body)
        builder.position_at_end(body)
        begin = builder.phi(integer())
        write_block(launch, memory, begin, WIDE)
        following = builder.add(begin, constant(integer(), WIDE))
        begin.add_incoming(constant(integer(), 0), before)
        begin.add_incoming(following, builder.block)
        builder.cbranch(builder.icmp_signed("<", following, constant(integer(), whole)), body, after)
        builder.position_at_end(after)
    if whole < launch.stride:
        write_block(launch, memory, constant(integer(), whole), launch.stride - whole)


def write_block(launch: Launch, memory: Memory, begin: Any, width: int) -> None:
    """A call in some lanes side by side."""
    kind, lane = import_module("llvmlite.ir").VectorType(double(), width), launch.call.lane
    values: list[Value] = []
    for op, *args in lane.ops:
        if op == Op.CONST:
            values.append(Value(memory.builder, constant(kind, lane.constants[args[0]])))
        elif op == Op.PARAMETER:
            values.append(memory.load("parameters", launch.coefficients + launch.stride * args[0], begin, kind))
        elif op == Op.INPUT:
            values.append(memory.load("scratch", launch.arguments[args[0]], begin, kind))
        else:
            values.append(WRITTEN[Op(op)](*(values[arg] for arg in args)))
    for row, place in enumerate(lane.roots):
        memory.store(values[place], "scratch", launch.results + launch.stride * row, begin)


def machine_text(plan: Plan) -> str:
    """LLVM's text of a function of (state, input, parameters, scratch, results, level), pointers and a number."""
    ir = import_module("llvmlite.ir")
    module = ir.Module()
    kind = ir.FunctionType(ir.VoidType(), [double().as_pointer()] * len(POINTERS) + [integer()])
    function = ir.Function(module, kind, ENTRY)
    builder = ir.IRBuilder(function.append_basic_block())
    *pointers, level = function.args
    for pointer in pointers:
        pointer.add_attribute("noalias")
    write(plan, builder, pointers, level)
    builder.ret_void()
    return str(module)
