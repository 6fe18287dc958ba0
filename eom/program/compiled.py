"""Compilation by numba: of programs, and of plain functions that call them."""

import dis
import pickle
from collections.abc import Callable
from functools import cache
from importlib import import_module
from types import FunctionType
from typing import Any

from eom.program.cache import folder, key, module, replace, straight_lines_in_vectors
from eom.program.machine import double, integer, intrinsic
from eom.program.plan import Plan

PACKAGE = "eom"

PROGRAM = '''"""Compiled by eom; may be removed at any time."""

from numba import cfunc, types

from eom.program.compiled import pending

program = pending("{name}")
NUMBERS = types.CPointer(types.float64)


@cfunc(types.void(NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS, types.int64), cache=True)
def evaluate(state, source, parameters, scratch, results, level):
    program(state, source, parameters, scratch, results, level)
'''

CALLER = '''"""Compiled by eom; may be removed at any time."""

from numba import njit

from eom.program.compiled import callee

function = callee("{place}", "{function}")


@njit(cache=True, nogil=True, error_model="numpy")
def run({arguments}):
    return function({arguments})
'''

WAITING: dict[str, Callable[[], Plan]] = {}
"""Plans of programs that are being loaded, by name."""


def installed() -> bool:
    """Whether there is a compiler."""
    try:
        import_module("numba")
    except ImportError:
        return False
    return True


def kept_plan(signature: str, make: Callable[[], Plan]) -> Plan:
    """The plan of a structure, from the cache if it was made before."""
    path = folder() / f"plan_{key(signature)}.pickle"
    if path.exists():
        found: Plan = pickle.loads(path.read_bytes())  # noqa: S301  the user's own cache, as numba's is
        return found
    plan = make()
    replace(path, pickle.dumps(plan))
    return plan


@cache
def compiled_program(signature: str, plan: Callable[[], Plan]) -> int:
    """Address of the machine code of a plan; the plan is asked for when it has to be compiled."""
    name = f"program_{key(signature)}"
    WAITING[name] = plan
    with straight_lines_in_vectors():
        return int(module(name, PROGRAM.format(name=name)).evaluate.address)


def pending(name: str) -> Any:
    """The function that a file of the cache compiles."""
    return intrinsic(WAITING[name])


def callee(place: str, function: str) -> Any:
    """A function of this package for numba, and all that it calls; programs are called by their address."""
    return machine_code(getattr(import_module(place), function), {})


@cache
def compiled_function(function: Any) -> Any:
    """A plain function as machine code that is kept in the cache."""
    place, name = function.__module__, function.__name__
    arguments = ", ".join(function.__code__.co_varnames[: function.__code__.co_argcount])
    file = f"{name}_{key(place, name)}"
    return module(file, CALLER.format(place=place, function=name, arguments=arguments)).run


def machine_code(function: Any, made: dict[Any, Any]) -> Any:
    """A function compiled, with all functions of this package that it calls; *made* holds what is compiled already."""
    if getattr(function, "calls_program", False):
        return by_address()
    if function not in made:
        names = {}
        for name in loaded(function):
            value = function.__globals__.get(name)
            if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
                names[name] = machine_code(value, made)
        plain = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
        made[function] = import_module("numba").njit(error_model="numpy")(plain)
    return made[function]


def loaded(function: Any) -> set[str]:
    """The global names that a function reads."""
    return {item.argval for item in dis.get_instructions(function) if item.opname == "LOAD_GLOBAL"}


@cache
def by_address() -> Any:
    """numba's call of a program: its address, five arrays, the level."""
    extending, types, ir = (import_module(name) for name in ("numba.extending", "numba.types", "llvmlite.ir"))

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        arrays = zip(signature.args[1:6], args[1:6], strict=True)
        pointers = [context.make_array(kind)(context, builder, item).data for kind, item in arrays]
        form = ir.FunctionType(ir.VoidType(), [double().as_pointer()] * 5 + [integer()])
        builder.call(builder.inttoptr(args[0], form.as_pointer()), [*pointers, args[6]])
        return context.get_dummy_value()

    def call(_typing: Any, program: Any, x: Any, u: Any, p: Any, scratch: Any, results: Any, level: Any) -> Any:
        return types.void(program, x, u, p, scratch, results, level), code

    return extending.intrinsic(call)
