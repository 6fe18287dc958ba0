"""A plan as plain Python: numbers for one case, NumPy's arrays for many cases at once; needs no compiler."""

import functools
import math
from collections.abc import Callable, Sequence
from types import CodeType
from typing import Any

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
    calls, own = rows_of_calls(plan, parameters), parameters.tolist()
    return lambda x, u, level: np.array(program(own, calls, (), x, u, level))


def of_arrays(plan: Plan, code: tuple[CodeType, int], parameters: Array) -> Plain:
    """The program of many cases, (parameters, cases)."""
    cases, ends = parameters.shape[1], plan.ends
    program = bound(code[0], {**COMMON, "empty": lambda level: np.empty((ends[level], cases))})
    # what is the same in all cases need not be read for each of them
    same = np.all(parameters == parameters[:, :1], axis=1)
    own = [np.array(row[0]) if one else row for row, one in zip(parameters, same, strict=True)]
    return functools.partial(program, own, rows_of_calls(plan, parameters), list(np.empty((code[1], cases))))


def bound(code: CodeType, names: dict[str, Any]) -> Any:
    """The function of a text, with meanings for the names in it."""
    space = dict(names)
    exec(code, space)  # noqa: S102  our own text, made of a tape
    return space["program"]


def rows_of_calls(plan: Plan, parameters: Array) -> list[tuple[Any, ...]]:
    """For each launch rows over lanes: of coefficients, for arguments, for results, and for what is between.

    They are made once: memory that comes and goes costs more time than what NumPy computes in it.
    """
    own, cases = launches(plan), parameters.shape[1:]
    wide = max((len(launch.lanes) for launch in own), default=0)
    filled = max((len(launch.filled) for launch in own), default=0)
    between = max((row_count(launch.call.lane) for launch in own), default=0)
    memory = np.empty((filled + between, wide, *cases))
    calls = []
    for launch in own:
        lanes = len(launch.lanes)
        rows = list(memory[:, :lanes])
        results = np.empty((launch.call.rows, lanes, *cases))
        calls.append((list(coefficients(launch, parameters)), rows[:filled], results, rows[filled:]))
    return calls


def coefficients(launch: Launch, parameters: Array) -> Array:
    """Coefficients of a launch, (rows, lanes) or (rows, lanes, cases); one case stands for all if they are the same."""
    end = launch.coefficients + launch.stride * len(launch.call.coefficients)
    rows = parameters[launch.coefficients : end].reshape(-1, launch.stride, *parameters.shape[1:])
    own = rows[:, : len(launch.lanes)]
    return own[..., :1] if own.ndim > 2 and np.all(own == own[..., :1]) else own
