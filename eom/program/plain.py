"""A plan as plain Python: numbers for one case, NumPy's arrays for many cases at once; needs no compiler."""

import math
from collections.abc import Callable, Sequence
from types import CodeType
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.program.lane_text import INTO, row_count
from eom.program.launch import Launch
from eom.program.operations import VALUES, Op
from eom.program.plan import Plan
from eom.program.text import ArraysText, NumbersText, launches

Plain = Callable[[Any, Any, int], Array]
"""Results of levels up to one, of states and inputs: lists of numbers, or arrays whose last axis is that of cases."""


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
    "CHOOSE": lambda test, then, other: then if test != 0.0 else other,
    "fill": lambda row, values: row.__setitem__(slice(None), values),
    "told": lambda rows: [row.tolist() for row in rows],
}
"""Operations on numbers; rows over lanes are told as lists, which Python's numbers are faster from."""


def fill(rows: Array, values: Sequence[Any]) -> None:
    """Set rows to numbers or arrays."""
    for row, value in zip(rows, values, strict=True):
        row[...] = value


ARRAYS: dict[Op, Any] = {
    **VALUES,
    Op.ADD: np.add,
    Op.SUB: np.subtract,
    Op.MUL: np.multiply,
    Op.DIV: np.divide,
    Op.NEG: np.negative,
    Op.LESS: np.less,
    Op.MAX: lambda a, b, out: np.maximum(a, b, out=out),
    Op.MIN: lambda a, b, out: np.minimum(a, b, out=out),
    Op.CHOOSE: lambda test, then, other, out: np.copyto(out, np.where(test != 0.0, then, other)),
}
"""Operations on arrays that write to the last one given."""
COMMON = {
    **{op.name + INTO: function for op, function in ARRAYS.items()},
    "INFINITE": math.inf,
    "fill": fill,
    "told": lambda rows: rows,
}


def numbers_code(plan: Plan) -> CodeType:
    """The plan as Python's code for numbers."""
    return compile(NumbersText(plan).whole(), "<program>", "exec")


def arrays_code(plan: Plan) -> tuple[CodeType, int]:
    """The plan as Python's code for arrays, and how many rows it needs for what is between."""
    text = ArraysText(plan)
    return compile(text.whole(), "<program>", "exec"), text.names.made


def of_numbers(plan: Plan, code: CodeType, parameters: Array) -> Plain:
    """The program of one case, (parameters,)."""
    program = bound(code, {**COMMON, **NUMBERS})
    rows, own = rows_of(plan), parameters.tolist()
    parts = rows.of(np.empty(rows.size), ())
    calls = [(coefficients(launch, parameters), *part) for launch, part in zip(launches(plan), parts, strict=True)]
    return lambda x, u, level: np.array(program(own, calls, (), x, u, level))


class OverCases:
    """The program of many cases, whose parameters are (parameters, cases)."""

    def __init__(self, plan: Plan, code: tuple[CodeType, int], parameters: Array) -> None:
        self.plan, self.between, self.rows = plan, code[1], rows_of(plan)
        self.memory = np.empty(0)
        self.program = bound(code[0], {**COMMON, "empty": self.empty})
        # what is the same in all cases need not be read for each of them
        same = np.all(parameters == parameters[:, :1], axis=1)
        self.parameters = [np.array(row[0]) if one else row for row, one in zip(parameters, same, strict=True)]
        self.coefficients = [list(coefficients(launch, parameters)) for launch in launches(plan)]

    def __call__(self, x: Array, u: Array, level: int, which: Any = None) -> Array:
        """Results of states and inputs, a column a case: of all cases, or those *which* are listed."""
        self.columns = x.shape[1]
        size = (self.between + self.rows.size) * self.columns
        if size > self.memory.size:
            self.memory = np.empty(size)
        parameters, own = self.parameters, self.coefficients
        if which is not None:
            parameters = [row[which] if row.ndim else row for row in parameters]
            own = [[row[:, which] if row.shape[1] > 1 else row for row in rows] for rows in own]
        begin = self.between * self.columns
        parts = self.rows.of(self.memory[begin:size], (self.columns,))
        calls = [(coefficients_, *part) for coefficients_, part in zip(own, parts, strict=True)]
        between = list(self.memory[:begin].reshape(self.between, self.columns))
        found: Array = self.program(parameters, calls, between, x, u, level)
        return found

    def empty(self, level: int) -> Array:
        """Room for the results of levels up to one."""
        return np.empty((self.plan.ends[level], self.columns))


def bound(code: CodeType, names: dict[str, Any]) -> Any:
    """The function of a text, with meanings for the names in it."""
    space = dict(names)
    exec(code, space)  # noqa: S102  our own text, made of a tape
    return space["program"]


class Rows(NamedTuple):
    """How many rows over how many lanes calls need, at most, beside those of results."""

    filled: int
    between: int
    wide: int
    results: tuple[tuple[int, int], ...]

    @property
    def size(self) -> int:
        """Numbers in all of them."""
        return (self.filled + self.between) * self.wide + sum(rows * lanes for rows, lanes in self.results)

    def of(self, memory: Array, columns: tuple[int, ...]) -> list[tuple[Array, Array, Array]]:
        """For each launch rows over lanes for arguments, results, and what is between, one after the other in memory.

        Memory is made once: what comes and goes costs more time than what NumPy computes in it.
        """
        width = math.prod(columns)
        begin = (self.filled + self.between) * self.wide * width
        shared = memory[:begin].reshape(self.filled + self.between, self.wide, *columns)
        found = []
        for rows, lanes in self.results:
            end = begin + rows * lanes * width
            own = memory[begin:end].reshape(rows, lanes, *columns)
            found.append((shared[: self.filled, :lanes], own, shared[self.filled :, :lanes]))
            begin = end
        return found


def rows_of(plan: Plan) -> Rows:
    """The rows of a plan's calls."""
    own = launches(plan)
    return Rows(
        filled=max((len(launch.filled) for launch in own), default=0),
        between=max((row_count(launch.call.lane) for launch in own), default=0),
        wide=max((len(launch.lanes) for launch in own), default=0),
        results=tuple((launch.call.rows, len(launch.lanes)) for launch in own),
    )


def coefficients(launch: Launch, parameters: Array) -> Array:
    """Coefficients of a launch, (rows, lanes) or (rows, lanes, cases); one case stands for all if they are the same."""
    end = launch.coefficients + launch.stride * len(launch.call.coefficients)
    rows = parameters[launch.coefficients : end].reshape(-1, launch.stride, *parameters.shape[1:])
    own = rows[:, : len(launch.lanes)]
    return own[..., :1] if own.ndim > 2 and np.all(own == own[..., :1]) else own
