"""The operations that a tape knows."""

import operator
from collections.abc import Callable
from enum import IntEnum
from typing import Any

import numpy as np


class Op(IntEnum):
    """Operations; arguments are places on the tape but for the first five."""

    CONST = 0
    """A number, ``args[0]`` among the tape's constants."""
    PARAMETER = 1
    """Number ``args[0]`` among those that may change from case to case."""
    STATE = 2
    INPUT = 3
    LANE = 4
    """Row ``args[1]`` of what call ``args[0]`` gives in lane ``args[2]``."""
    ADD = 5
    SUB = 6
    MUL = 7
    DIV = 8
    NEG = 9
    ABS = 10
    SQRT = 11
    FLOOR = 12
    SIN = 13
    COS = 14
    TAN = 15
    ARCTAN = 16
    EXP = 17
    LOG = 18
    MAX = 19
    MIN = 20
    COPYSIGN = 21
    LESS = 22
    """1 where the first is less than the second, else 0."""
    CHOOSE = 23
    """The second where the first is not zero, else the third."""


BRANCH = "a branch on a number that is not known before the run: use where, maximum or minimum of arrays"
LEAVES = frozenset((Op.CONST, Op.PARAMETER, Op.STATE, Op.INPUT, Op.LANE))
VARYING = frozenset((Op.STATE, Op.INPUT, Op.LANE))

VALUES: dict[Op, Callable[..., Any]] = {
    Op.ADD: operator.add,
    Op.SUB: operator.sub,
    Op.MUL: operator.mul,
    Op.DIV: operator.truediv,
    Op.NEG: operator.neg,
    Op.ABS: np.abs,
    Op.SQRT: np.sqrt,
    Op.FLOOR: np.floor,
    Op.SIN: np.sin,
    Op.COS: np.cos,
    Op.TAN: np.tan,
    Op.ARCTAN: np.arctan,
    Op.EXP: np.exp,
    Op.LOG: np.log,
    Op.MAX: np.maximum,
    Op.MIN: np.minimum,
    Op.COPYSIGN: np.copysign,
    Op.LESS: lambda a, b: np.where(a < b, 1.0, 0.0),
    Op.CHOOSE: lambda test, then, other: np.where(test != 0.0, then, other),
}
"""What operations do to numbers or arrays."""
