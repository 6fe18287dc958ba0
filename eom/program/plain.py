"""A plan as plain Python: numbers for one case, NumPy's arrays for many cases at once; needs no compiler."""

import functools
import math
from collections.abc import Callable, Sequence
from types import CodeType
from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.program.plan import Launch, Plan
from eom.program.tape import VALUES, Op
from eom.program.text import INTO, launches, program_text, row_count

Plain = Callable[[Any, Any, int], Array]
"""Results of levels up to one, of states and inputs: lists of numbers, or arrays whose last axis is that of cases."""


def divided(a: float, b: float) -> float:
    """A quotient, as NumPy has it also by zero: a branch that is not taken may hold one."""
    if b != 0.0:
        return a / b
    return math.nan if a == 0.0 or a != a else math.copysign(math.inf, a) * math.copysign(1.0, b)  # noqa: PLR0124


def fill(rows: Array, values: Sequence[Any]) -> None:
    """Set rows to numbers or arrays."""
    for row, value in zip(rows, values, strict=True):
        row[...] = value


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
    "rows": lambda x: x,
    "fill": lambda row, values: row.__setitem__(slice(None), values),
    "told": lambda rows: [row.tolist() for row in rows],
}
"""Operations on numbers; rows over lanes are told as lists, which Python's numbers are faster from."""
ARRAYS: dict[str, Any] = {
    **{op.name: function for op, function in VALUES.items()},
    "rows": list,
    "fill": fill,
    "told": lambda rows: rows,
}
WRITING: dict[Op, Any] = {
    **VALUES,
    Op.ADD: np.add,
    Op.SUB: np.subtract,
    Op.MUL: np.multiply,
    Op.DIV: np.divide,
    Op.NEG: np.negative,
    Op.LESS: np.less,
    Op.CHOOSE: lambda test, then, other, out: np.copyto(out, np.where(test != 0.0, then, other)),
}
"""Operations on arrays that write to one."""
OVER_LANES = {**{op.name + INTO: function for op, function in WRITING.items()}, "INFINITE": math.inf}


def compiled_text(plan: Plan) -> CodeType:
    """The plan as Python's code."""
    return compile(program_text(plan), "<program>", "exec")


def plain(plan: Plan, code: CodeType, parameters: Array) -> Plain:
    """The program of one case, whose parameters are (parameters,), or of many, (parameters, cases).

    Rows over lanes are made once: memory that comes and goes costs more time than what NumPy computes in it.
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
        calls.append((coefficients(launch, parameters), rows[:filled], results, rows[filled:]))
    space = {**(ARRAYS if cases else NUMBERS), **OVER_LANES, "whole": functools.partial(whole, cases=cases)}
    exec(code, space)  # noqa: S102  our own text, made of a tape
    return functools.partial(space["program"], list(parameters) if cases else parameters.tolist(), calls)


def whole(rows: Sequence[Any], cases: tuple[int, ...]) -> Array:
    """Rows as one array."""
    if not cases:
        return np.array(rows)
    result = np.empty((len(rows), *cases))
    fill(result, rows)
    return result


def coefficients(launch: Launch, parameters: Array) -> Array:
    """Coefficients of a launch, (rows, lanes) or (rows, lanes, cases)."""
    end = launch.coefficients + launch.stride * len(launch.call.coefficients)
    rows = parameters[launch.coefficients : end].reshape(-1, launch.stride, *parameters.shape[1:])
    return rows[:, : len(launch.lanes)]
