"""Tyre formulas as machine code: several tyres at once, a lane of a vector register each."""

import dis
import functools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from numbers import Real
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np

from eom.errors import TyreError
from eom.tyre import fast_elementary
from eom.tyre.interface import ARGUMENTS, REFERENCE_SPEED, Forces, Formula, Tyre, as_numbers
from eom.tyre.parameters import Values

LANES = 32
"""Tyres of one block; with a constant stride between coefficients a compiler sees that no two of them overlap."""
WIDTH = 8
"""Tyres are evaluated in groups of so many, the widest vector register; those that fill up the last are discarded."""
PACKAGE = "eom.tyre"


@dataclass(frozen=True)
class Kernel:
    """The compiled formula of n tyres.

    Attributes
    ----------
    table : array, (blocks, coefficients * LANES)
        Coefficients that the formula uses.
    run : function
        Compiled ``run(table, arguments, out)``, to be called from other compiled code: *arguments* are alpha, kappa,
        Fz, gamma, speed of each tyre, *out* gets Fx, Fy, Mx, My, Mz; both of shape (5, n), unchecked.
    count : int
        Number of tyres.
    """

    table: "np.ndarray[Any, Any]"
    run: Callable[["np.ndarray[Any, Any]", "np.ndarray[Any, Any]", "np.ndarray[Any, Any]"], None]
    count: int

    def forces(
        self, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
    ) -> Forces:
        """Forces and moments as of `Tyre.forces`; each argument is a number or has one element for each tyre."""
        arguments = np.empty((len(ARGUMENTS), self.count))
        for row, name, value in zip(arguments, ARGUMENTS, (alpha, kappa, Fz, gamma, speed), strict=True):
            numbers = as_numbers(name, value)
            if numbers.dtype.kind == "c" or numbers.shape not in {(), (1,), (self.count,)}:
                raise TyreError(f"{name}: expected a real number or {self.count} of them, one for each tyre")
            row[:] = numbers
        out = np.empty_like(arguments)
        self.run(self.table, arguments, out)
        return Forces(*out)


def compile_forces(tyre: Tyre) -> Kernel:
    """Compile a tyre's formula; several tyres are first made one by `stack`.

    The formula is the very one that NumPy evaluates, with elementary functions that have no branches. The first call
    in a process takes seconds for each formula.

    Raises
    ------
    TyreError
        If numba is not installed.
    """
    formula = tyre.formula
    names = tuple(used_coefficients(formula, tyre))
    columns = np.array(np.broadcast_arrays(*(np.atleast_1d(getattr(tyre, name)) for name in names)), dtype=float)
    count = columns.shape[1]
    blocks = -(-count // LANES)
    filled = np.concatenate([columns, np.repeat(columns[:, -1:], blocks * LANES - count, axis=1)], axis=1)
    table = filled.reshape(len(names), blocks, LANES).transpose(1, 0, 2).reshape(blocks, -1)
    return Kernel(np.ascontiguousarray(table), compiled_loop(formula, names), count)


def used_coefficients(formula: Formula, tyre: Tyre) -> Iterator[str]:
    """The names of a tyre's numbers that its formula reads."""
    for name in sorted({name for function in reached(formula) for name in loaded(function, "LOAD_ATTR")}):
        if isinstance(getattr(tyre, name, None), (Real, np.ndarray)):
            yield name


def reached(function: Any) -> Iterator[Any]:
    """A function and all functions of this package that it calls."""
    yield function
    for _, called in calls(function):
        yield from reached(called)


def calls(function: Any) -> Iterator[tuple[str, Any]]:
    """What a function calls of this package, by name; elementary functions are the ones without branches."""
    for name in loaded(function, "LOAD_GLOBAL"):
        value = getattr(fast_elementary, name, function.__globals__.get(name))
        if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
            yield name, value


def loaded(function: Any, instruction: str) -> set[str]:
    """The names that a function loads by a kind of instruction."""
    return {item.argval for item in dis.get_instructions(function) if item.opname == instruction}


@functools.cache
def compiled(function: Any) -> Any:
    """A function as machine code that is inlined where it is called, and with it all that it calls."""
    names = {name: compiled(called) for name, called in calls(function)}
    plain = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
    return numba().njit(forceinline=True, error_model="numpy", fastmath={"contract"})(plain)


@functools.cache
def compiled_loop(formula: Formula, names: tuple[str, ...]) -> Any:
    """``run(table, arguments, out)`` of `Kernel` for a formula that reads the named coefficients."""
    njit = numba().njit
    Coefficients = NamedTuple("Coefficients", [(name, float) for name in names])  # type: ignore[misc]
    # unsigned, an index cannot count from the end, which would have to be asked for each of them
    rows = [np.uint64(k * LANES) for k in range(max(len(names), len(ARGUMENTS)))]
    space: dict[str, Any] = {"Coefficients": Coefficients, **{f"row_{k}": row for k, row in enumerate(rows)}}
    values = ", ".join(f"block[row_{k} + lane]" for k in range(len(names)))
    # a tuple of so many elements can only be written out
    exec(f"def coefficients(block, lane):\n    return Coefficients({values})", space)  # noqa: S102
    coefficients = njit(forceinline=True)(space["coefficients"])
    forces = compiled(formula)

    _, row_1, row_2, row_3, row_4 = rows[: len(ARGUMENTS)]

    def block_forces(block: Any, x: Any, y: Any, count: int) -> None:
        for index in range(count):
            lane = np.uint64(index)
            arguments = x[lane], x[row_1 + lane], x[row_2 + lane], x[row_3 + lane], x[row_4 + lane]
            Fx, Fy, Mx, My, Mz = forces(coefficients(block, lane), *arguments)
            y[lane] = Fx
            y[row_1 + lane] = Fy
            y[row_2 + lane] = Mx
            y[row_3 + lane] = My
            y[row_4 + lane] = Mz

    inner = njit(error_model="numpy")(block_forces)

    def run(table: Any, arguments: Any, out: Any) -> None:
        rows, total = arguments.shape
        x, y = np.ones(rows * LANES), np.empty(rows * LANES)
        for b in range(table.shape[0]):
            first, count = np.uint64(b * LANES), min(LANES, total - b * LANES)
            for row in range(rows):
                begin = np.uint64(row * LANES)
                for index in range(count):
                    lane = np.uint64(index)
                    x[begin + lane] = arguments[np.uint64(row), first + lane]
            inner(table[b], x, y, (count + WIDTH - 1) // WIDTH * WIDTH)
            for row in range(rows):
                begin = np.uint64(row * LANES)
                for index in range(count):
                    lane = np.uint64(index)
                    out[np.uint64(row), first + lane] = y[begin + lane]

    return njit(error_model="numpy")(run)


def numba() -> Any:
    """The compiler, imported on first use; raises `TyreError` if it is not installed."""
    try:
        import numba  # noqa: PLC0415  slow to import, and an extra
    except ImportError:
        raise TyreError("compiled tyres need numba: install eom-vehicle[fast]") from None
    return numba
