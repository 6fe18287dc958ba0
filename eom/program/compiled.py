"""Whether and what to compile: programs by LLVM, plain functions by numba."""

import contextlib
import pickle
from collections.abc import Callable, Iterator
from functools import cache
from importlib.util import find_spec

from eom.program.cache import kept, key
from eom.program.machine import machine_text
from eom.program.object_code import address
from eom.program.plan import Plan

HIDDEN: list[bool] = []


@contextlib.contextmanager
def without_compiler() -> Iterator[None]:
    """Within it everything runs in Python and NumPy, as where numba is not installed."""
    HIDDEN.append(True)
    try:
        yield
    finally:
        HIDDEN.pop()


@cache
def there() -> bool:
    """Whether numba is there; it is loaded only to compile."""
    return find_spec("numba") is not None


def installed() -> bool:
    """Whether there is a compiler."""
    return not HIDDEN and there()


def kept_plan(signature: str, make: Callable[[], Plan]) -> Plan:
    """The plan of a structure, from the cache if it was made before."""
    # the user's own cache, as compiled code is
    plan: Plan = pickle.loads(kept(f"plan_{key(signature)}.pickle", lambda: pickle.dumps(make())))  # noqa: S301
    return plan


def compiled_program(signature: str, plan: Plan) -> int:
    """Address of the machine code of a plan."""
    return address(f"program_{key(signature)}", lambda: machine_text(plan))
