"""Compilation by numba: of programs, and of plain functions that call them."""

import contextlib
import pickle
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from types import FunctionType
from typing import Any

from eom.program.cache import folder, key, module, replace, straight_lines_in_vectors
from eom.program.machine import intrinsic
from eom.program.numbers import PACKAGE, loaded
from eom.program.plan import Plan

PROGRAM = '''"""Compiled by eom; may be removed at any time."""

from numba import cfunc, types

from eom.program.compiled import pending

program = pending("{name}")
NUMBERS = types.CPointer(types.float64)


@cfunc(types.void(NUMBERS, NUMBERS, NUMBERS, NUMBERS, NUMBERS, types.int64), cache=True)
def evaluate(state, source, parameters, scratch, results, level):
    program(state, source, parameters, scratch, results, level)
'''

HIDDEN: list[bool] = []
WAITING: dict[str, Callable[[], Plan]] = {}
"""Plans of programs that are being loaded, by name."""


@contextlib.contextmanager
def without_compiler() -> Iterator[None]:
    """Within it everything runs in Python and NumPy, as where numba is not installed."""
    HIDDEN.append(True)
    try:
        yield
    finally:
        HIDDEN.pop()


def installed() -> bool:
    """Whether there is a compiler."""
    if HIDDEN:
        return False
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


def compiled_program(signature: str, plan: Callable[[], Plan]) -> int:
    """Address of the machine code of a plan; the plan is asked for when it has to be compiled."""
    name = f"program_{key(signature)}"
    WAITING[name] = plan
    with straight_lines_in_vectors():
        return int(module(name, PROGRAM.format(name=name)).evaluate.address)


def pending(name: str) -> Any:
    """The function that a file of the cache compiles."""
    return intrinsic(WAITING[name])


@cache
def compiled_function(function: Any) -> Any:
    """A plain function as machine code that is kept in the cache, and with it all that it calls."""
    path = folder() / f"{function.__name__}_{key(function.__module__, function.__name__)}.py"
    if not path.exists():
        replace(path, b"# stands for compiled code; may be removed at any time")
    return machine_code(function, {}, path)


def machine_code(function: Any, made: dict[Any, Any], path: Path | None = None) -> Any:
    """A function compiled, with all functions of this package that it calls.

    *made* holds what is compiled already; numba looks beside the *path* for what it kept. A function with an attribute
    ``written`` is replaced by what that gives, and one that is ``kept`` by what is in the cache.
    """
    written = getattr(function, "written", None)
    if written is not None:
        return written()
    if path is None and getattr(function, "kept", False):
        return compiled_function(function)
    if function not in made:
        names = {}
        for name in loaded(function, "LOAD_GLOBAL"):
            value = function.__globals__.get(name)
            if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
                names[name] = machine_code(value, made)
        code = function.__code__ if path is None else function.__code__.replace(co_filename=str(path))
        plain = FunctionType(code, {**function.__globals__, **names}, function.__name__)
        alone = path is not None
        options = {"cache": alone, "nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True, "_nrt": False}
        # what is called by compiled code alone needs no door for Python
        made[function] = one_version(import_module("numba").njit(no_cpython_wrapper=not alone, **options)(plain))
    return made[function]


def one_version(dispatcher: Any) -> Any:
    """A compiled function that does not become another one for every constant that it is called with."""
    unliteral, template = import_module("numba.types").unliteral, dispatcher.get_call_template
    dispatcher.get_call_template = lambda args, kws: template(
        tuple(map(unliteral, args)), {name: unliteral(kind) for name, kind in kws.items()}
    )
    return dispatcher
