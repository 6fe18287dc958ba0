"""A plan as plain Python: numbers for one case, NumPy's arrays for many cases at once; needs no compiler."""

import math
from collections import Counter
from collections.abc import Callable, Iterator
from types import CodeType
from typing import Any

import numpy as np

from eom.program.numbers import Coefficients
from eom.program.plan import Launch, Plan, needs
from eom.program.tape import LEAVES, VALUES, Op

SIGNS = {Op.ADD: "({} + {})", Op.SUB: "({} - {})", Op.MUL: "({} * {})", Op.NEG: "(-{})"}
DEEP = 6
"""Nesting of expressions; names are given to what is used more than once or nested deeper."""


def divided(a: float, b: float) -> float:
    """A quotient, as NumPy has it also by zero: a branch that is not taken may hold one."""
    if b != 0.0:
        return a / b
    return math.nan if a == 0.0 or a != a else math.copysign(math.inf, a) * math.copysign(1.0, b)  # noqa: PLR0124


NUMBERS: dict[str, Any] = {
    "ABS": abs,
    "DIV": divided,
    "SQRT": lambda x: math.sqrt(x) if x >= 0.0 else math.nan,
    "FLOOR": math.floor,
    "SIN": math.sin,
    "COS": math.cos,
    "TAN": math.tan,
    "ARCTAN": math.atan,
    "EXP": math.exp,
    "LOG": math.log,
    "MAX": max,
    "MIN": min,
    "COPYSIGN": math.copysign,
    "LESS": lambda a, b: float(a < b),
    "INFINITE": math.inf,
    "CHOOSE": lambda test, then, other: then if test != 0.0 else other,
}
"""Operations on numbers; `VALUES` are those on arrays."""


Plain = Callable[[Any, Any, Any, int], list[Any]]
"""Results of levels up to one, of states, inputs and parameters."""


def of_numbers(plan: Plan, code: CodeType) -> Plain:
    """The program of one case: states and inputs are lists, parameters an array."""
    return bound(plan, code, {**NUMBERS, "stacked": np.array, "told": lists})


def of_arrays(plan: Plan, code: CodeType) -> Plain:
    """The program of many cases; the last axis of states, inputs and parameters is theirs."""
    names: dict[str, Any] = {op.name: function for op, function in VALUES.items()}
    return bound(plan, code, {**names, "INFINITE": math.inf, "stacked": stacked, "told": lambda rows: rows})


def lists(rows: list[Any]) -> list[list[float]]:
    """Rows as lists, which Python's numbers are faster from."""
    return [row.tolist() for row in rows]


def stacked(rows: list[Any]) -> Any:
    """Numbers and arrays over cases as rows of one array."""
    result = np.stack(np.broadcast_arrays(*rows))
    return result if result.ndim > 1 else result[:, np.newaxis]


def compiled_text(plan: Plan) -> CodeType:
    """The plan as Python's code."""
    return compile("\n".join(text(plan)), "<program>", "exec")


def bound(plan: Plan, code: CodeType, names: dict[str, Any]) -> Plain:
    """The code as a function, with meanings for the names in it."""
    space = dict(names)
    for k, launch in enumerate(launches(plan)):
        space[f"call_{k}"] = caller(launch)
    exec(code, space)  # noqa: S102  our own text, made of a tape
    program: Plain = space["program"]
    return program


def launches(plan: Plan) -> list[Launch]:
    """All launches in order."""
    return [launch for stage in plan.launches for launch in stage]


def caller(launch: Launch) -> Callable[..., Any]:
    """A launch's function of parameters and its arguments; gives rows of lanes."""
    call, lanes = launch.call, len(launch.lanes)
    end = launch.coefficients + launch.stride * len(call.names)

    def call_it(parameters: Any, *arguments: Any) -> Any:
        """The rows."""
        part = parameters[launch.coefficients : end]
        rows = part.reshape(len(call.names), launch.stride, *part.shape[1:])
        own = Coefficients(**dict(zip(call.names, rows[:, :lanes], strict=True)))
        return [value + 0.0 * arguments[0] for value in call.of(own, arguments)]

    return call_it


def text(plan: Plan) -> Iterator[str]:
    """The lines of ``program(x, u, p, level)``."""
    yield "def program(x, u, p, level):"
    counter = 0
    expression = expressions(plan)
    for stage, own in enumerate(plan.launches):
        for level in range(len(plan.roots)):
            if level:
                yield f"{'    ' * level}if level >= {level}:"
            indent = "    " * (level + 1)
            yield f"{indent}pass"
            for place in plan.stages[stage][level]:
                if place not in expression.inlined:
                    yield f"{indent}v{place} = {expression.of(place, whole=True)}"
        for launch in own:
            rows = [expression.row(launch, row) for row in range(len(launch.call.arguments))]
            wanted = min(plan.call_levels[index] for index, _ in launch.lanes)
            yield f"    if level >= {wanted}:"
            yield f"        r{counter} = told(call_{counter}(p, {', '.join(rows)}))"
            counter += 1
    yield "    out = []"
    for level, group in enumerate(plan.roots):
        yield f"    if level >= {level}:"
        yield f"        out += [{', '.join(expression.of(place) for place in group)}]"
    yield "    return out"


class Expressions:
    """Text of places; what is used once, and soon, is written where it is used."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.parameter = {place: k for k, place in reversed(list(enumerate(plan.parameters)))}
        self.result = {pair: (k, lane) for k, item in enumerate(launches(plan)) for lane, pair in enumerate(item.lanes)}
        self.inlined: set[int] = set()
        self.depth: dict[int, int] = {}

    def row(self, launch: Launch, row: int) -> str:
        """The text of a row of arguments of a launch."""
        calls = self.plan.tape.calls
        return f"stacked([{', '.join(self.of(calls[index].arguments[row][lane]) for index, lane in launch.lanes)}])"

    def of(self, place: int, *, whole: bool = False) -> str:
        """The text of a place: its name, or what is behind it."""
        tape = self.plan.tape
        op, *args = tape.ops[place]
        if op == Op.CONST:
            return f"({tape.constants[args[0]]!r})".replace("inf", "INFINITE")
        if place in self.parameter:
            return f"p[{self.parameter[place]}]"
        if op in {Op.STATE, Op.INPUT}:
            return f"{'x' if op == Op.STATE else 'u'}[{args[0]}]"
        if op == Op.LANE:
            launch, lane = self.result[args[0], args[2]]
            return f"r{launch}[{args[1]}][{lane}]"
        if not whole and place not in self.inlined:
            return f"v{place}"
        parts = [self.of(arg) for arg in args]
        return SIGNS[Op(op)].format(*parts) if op in SIGNS else f"{Op(op).name}({', '.join(parts)})"


def expressions(plan: Plan) -> Expressions:
    """How to write each place."""
    found, tape = Expressions(plan), plan.tape
    where = {place: (s, k) for s, groups in enumerate(plan.stages) for k, group in enumerate(groups) for place in group}
    uses = Counter(arg for place in where for arg in tape.ops[place][1:] if tape.ops[place][0] not in LEAVES)
    kept = {place for group in plan.roots for place in group}
    kept |= {place for call in tape.calls for row in call.arguments for place in row}
    user = {arg: place for place in where for arg in needs(tape, place)}
    for place in sorted(where):
        args = needs(tape, place)
        found.depth[place] = 1 + max((found.depth.get(arg, 0) for arg in args if arg in found.inlined), default=0)
        once = uses[place] == 1 and place not in kept and where.get(user[place]) == where[place]
        if once and found.depth[place] < DEEP:
            found.inlined.add(place)
    return found
