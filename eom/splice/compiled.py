"""The nonlinear equations as machine code: the functions that NumPy runs, calling compiled ones."""

import functools
from collections.abc import Callable, Sequence
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.splice.flat import flat
from eom.splice.laws import forces as tyre_forces
from eom.splice.loops import rates_by_loops
from eom.splice.state import Model
from eom.splice.structures import as_structure
from eom.tyre.kernel import compile_forces, loaded, numba

PACKAGE = "eom"


class Compiled(NamedTuple):
    """Compiled ``rates(x, u, numbers)`` of real x and u, to be called from Python or from other compiled code.

    ``numbers`` are the model's in the form that it takes.
    """

    rates: Callable[[Array, Array, Any], Array]
    numbers: Any


class Table(NamedTuple):
    """Wheels whose tyres have the same equations, and the coefficients of these as the compiled formula takes them."""

    wheels: NDArray[np.int64]
    coefficients: Array


def compile_rates(p: Model) -> Compiled:
    """Compile the equations of a model.

    Models with the same tyre formulas share the code, whatever their numbers and sizes; the first call of a process
    takes its compilation. Raises `eom.TyreError` if numba is not installed.
    """
    kernels = [compile_forces(group.tyre) for group in p.laws]
    tables = tuple(
        Table(np.ascontiguousarray(group.wheels, dtype=np.int64), kernel.table)
        for group, kernel in zip(p.laws, kernels, strict=True)
    )
    return Compiled(compiled_rates(tuple(kernel.run for kernel in kernels)), as_structure(flat(p, tables)))


@functools.cache
def compiled_rates(formulas: tuple[Any, ...]) -> Any:
    """The rates with given compiled formulas, a group of wheels each."""
    return machine_code(rates_by_loops, {tyre_forces: forces_by(formulas)})


def machine_code(function: Any, made: dict[Any, Any]) -> Any:
    """A function compiled, with all functions of this package that it calls; *made* holds what is compiled already."""
    if function not in made:
        names = {}
        for name in loaded(function, "LOAD_GLOBAL"):
            value = function.__globals__.get(name)
            if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
                names[name] = machine_code(value, made)
        plain = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
        made[function] = numba().njit(error_model="numpy")(plain)
    return made[function]


def forces_by(formulas: Sequence[Any]) -> Any:
    """Compiled `eom.splice.laws.forces` of groups of wheels, a compiled formula each."""
    njit = numba().njit(error_model="numpy")
    fill = njit(nothing)
    for k, formula in reversed(list(enumerate(formulas))):
        fill = njit(group_filler(k, formula, fill))

    def forces(groups: Any, count: Any, alpha: Any, kappa: Any, Fz: Any, gamma: Any, speed: Any) -> Any:
        result, arguments = np.zeros((5, len(count))), np.empty((5, len(count)))
        for k in range(len(count)):
            arguments[0, k], arguments[1, k], arguments[2, k] = alpha[k], kappa[k], Fz[k] / count[k]
            arguments[3, k], arguments[4, k] = gamma[k], speed[k]
        fill(groups, arguments, count, result)
        return result

    return njit(forces)


def nothing(groups: Any, arguments: Any, count: Any, result: Any) -> None:
    """What is left to do after the last group."""


def group_filler(k: int, formula: Any, rest: Any) -> Callable[..., None]:
    """Evaluates group *k* and then the *rest*."""

    def fill(groups: Any, arguments: Any, count: Any, result: Any) -> None:
        wheels, coefficients = groups[k]
        own, found = np.empty((5, len(wheels))), np.empty((5, len(wheels)))
        for row in range(5):
            for column in range(len(wheels)):
                own[row, column] = arguments[row, wheels[column]]
        formula(coefficients, own, found)
        for row in range(5):
            for column in range(len(wheels)):
                result[row, wheels[column]] = count[wheels[column]] * found[row, column]
        rest(groups, arguments, count, result)

    return fill
