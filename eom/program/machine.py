"""A plan as machine code: straight lines of arithmetic, and loops over lanes, several to a vector register.

What compilers do with loops and arrays is not needed where everything is known beforehand; so instructions are handed
to LLVM one by one.
"""

from collections.abc import Sequence
from importlib import import_module
from typing import Any

from eom.program.launch import Launch
from eom.program.object_code import ENTRY
from eom.program.operations import Op
from eom.program.plan import Plan
from eom.program.value import WRITTEN, Value, constant, double, integer

POINTERS = ("state", "input", "parameters", "scratch", "results")
WIDE = 20
"""Lanes side by side: several vector registers, which hide each other's latency."""


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
            with builder.if_then(builder.icmp_signed(">=", level, constant(integer(), launch.level))):
                write_lanes(launch, memory)


def write_stage(plan: Plan, stage: int, memory: Memory, level: Any) -> None:
    """Scalar operations of a stage, arguments of the calls that follow, and results in the last one."""
    values, builder = Values(plan, memory), memory.builder

    def write_level(k: int) -> None:
        """What a level needs, and those after it."""
        for place in plan.stages[stage][k]:
            values.compute(place)
        for item in plan.launches[stage]:
            if item.level == k:
                fill_lanes(plan, item, values)
        if stage == len(plan.stages) - 1:
            first = sum(len(group) for group in plan.roots[:k])
            for row, place in enumerate(plan.roots[k]):
                memory.store(values.of(place), "results", first + row)
        if k + 1 < len(plan.roots):
            with builder.if_then(builder.icmp_signed(">", level, constant(integer(), k))):
                write_level(k + 1)

    write_level(0)


def fill_lanes(plan: Plan, item: Launch, values: "Values") -> None:
    """Set the arguments of a launch that are not there already."""
    for lane, (index, own) in enumerate(item.lanes):
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
