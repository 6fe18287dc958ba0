"""The nonlinear equations as machine code: the functions that NumPy runs, with compiled ones in place of what they call."""

import functools
from collections.abc import Callable, Sequence
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.splice.laws import forces as tyre_forces
from eom.splice.rates import rates
from eom.splice.state import Model
from eom.tyre.kernel import Kernel, compile_forces, loaded, numba

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
    return Compiled(compiled_rates(tuple(kernel.run for kernel in kernels)), compact(p, kernels))


@functools.cache
def compiled_rates(formulas: tuple[Any, ...]) -> Any:
    """The rates with given compiled formulas, a group of wheels each."""
    return machine_code(rates, {tyre_forces: forces_by(formulas)})


def machine_code(function: Any, made: dict[Any, Any]) -> Any:
    """A function compiled, and with it all functions of this package that it calls; *made* holds what is already."""
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
        result = np.zeros((5, len(count)))
        arguments = np.stack((alpha, kappa, Fz / count, gamma, speed))
        fill(groups, arguments, count, result)
        return result

    return njit(forces)


def nothing(groups: Any, arguments: Any, count: Any, result: Any) -> None:
    """What is left to do after the last group."""


def group_filler(k: int, formula: Any, rest: Any) -> Callable[..., None]:
    """Evaluates group *k* and then the *rest*."""

    def fill(groups: Any, arguments: Any, count: Any, result: Any) -> None:
        wheels, coefficients = groups[k]
        own = np.empty((5, len(wheels)))
        for column in range(len(wheels)):
            own[:, column] = arguments[:, wheels[column]]
        found = np.empty_like(own)
        formula(coefficients, own, found)
        for column in range(len(wheels)):
            wheel = wheels[column]
            result[:, wheel] = count[wheel] * found[:, column]
        rest(groups, arguments, count, result)

    return fill


def compact(p: Model, kernels: Sequence[Kernel]) -> Any:
    """A model's numbers with contiguous arrays of one type, and tables of coefficients in place of tyres."""
    tables = tuple(
        Table(np.ascontiguousarray(group.wheels, dtype=np.int64), kernel.table)
        for group, kernel in zip(p.laws, kernels, strict=True)
    )
    return Model(plain(p.body), plain(p.contact), plain(p.control), tables, plain(p.load_gain))


def plain(part: Any) -> Any:
    """Arrays in row order, of doubles or 64-bit integers; the rest as it is."""
    if isinstance(part, np.ndarray):
        return np.ascontiguousarray(part, dtype=np.float64 if part.dtype.kind == "f" else np.int64)
    return type(part)(*map(plain, part)) if isinstance(part, tuple) else part
