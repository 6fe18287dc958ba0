"""From equations to something to call: machine code where there is a compiler, plain Python elsewhere."""

import ctypes
import functools
import hashlib
from collections.abc import Callable
from dataclasses import dataclass, fields
from types import CodeType
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.program.compiled import compiled_program, installed, kept_plan
from eom.program.numbers import Numbers, gathered
from eom.program.plain import OverCases, Plain, arrays_code, numbers_code, of_numbers
from eom.program.plan import Plan, planned, traced

CALL = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5, ctypes.c_int64)
"""How machine code is called: states, inputs, parameters, scratch memory, results; level."""


@dataclass(frozen=True)
class Program:
    """Equations ready to be called for cases with the same structure.

    Attributes
    ----------
    plan : Plan
    signature : str
        Of the structure: programs with the same one are the same.
    states, inputs : int
        How many there are.
    """

    plan: Plan
    signature: str
    states: int
    inputs: int

    def __getstate__(self) -> dict[str, Any]:
        # addresses are those of this process, and code is made again
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @functools.cached_property
    def address(self) -> int:
        """Of its machine code, which is compiled if it never was."""
        return compiled_program(self.signature, self.plan)

    @functools.cached_property
    def numbers_code(self) -> CodeType:
        """The plan as Python's code for numbers."""
        return numbers_code(self.plan)

    @functools.cached_property
    def arrays_code(self) -> tuple[CodeType, int]:
        """The plan as Python's code for arrays over cases."""
        return arrays_code(self.plan)

    def of_numbers(self, parameters: Array) -> Plain:
        """The same in plain Python for one case, (parameters,)."""
        return of_numbers(self.plan, self.numbers_code, parameters)

    def of_arrays(self, parameters: Array) -> OverCases:
        """The same in NumPy for many cases at once, (parameters, cases)."""
        return OverCases(self.plan, self.arrays_code, parameters)


class Ready(NamedTuple):
    """A program with the parameters of one case, (parameters,)."""

    program: Program
    parameters: Array

    def results(self, x: Array, u: Array, level: int) -> Array:
        """Results of the first levels up to one, compiled where there is a compiler.

        Raises ``ValueError`` if there are not as many states or inputs as the program has.
        """
        if len(x) != self.program.states or len(u) != self.program.inputs:
            expected = f"expected {self.program.states} states and {self.program.inputs} inputs"
            raise ValueError(f"{expected}, got {len(x)} and {len(u)}")
        if not installed():
            with np.errstate(all="ignore"):
                return self.program.of_numbers(self.parameters)(x.tolist(), u.tolist(), level)
        ends = self.program.plan.ends
        out, scratch = np.empty(ends[-1]), np.ones(self.program.plan.scratch)
        x, u = np.ascontiguousarray(x, dtype=float), np.ascontiguousarray(u, dtype=float)
        CALL(self.program.address)(*map(place_of, (x, u, self.parameters, scratch, out)), level)
        return out[: ends[level]]


def place_of(array: Any) -> int:
    """Address of the elements of an array."""
    place: int = array.__array_interface__["data"][0]
    return place


def ready(function: Callable[..., Any], numbers: Any, states: int, inputs: int) -> Ready:
    """``function(x, u, numbers)`` as a program, ready for one case."""
    found = gathered([numbers])
    made = program(function, found, states, inputs)
    return Ready(made, np.ascontiguousarray(made.plan.parameter_values(found)[:, 0]))


MADE: dict[str, Program] = {}
"""Programs of this process."""


def program(function: Callable[..., Any], numbers: Numbers, states: int, inputs: int) -> Program:
    """The program of ``function(x, u, numbers)``, from the cache if there is one."""
    code = hashlib.sha256(f"{function.__code__.co_code.hex()}{function.__code__.co_consts}".encode()).hexdigest()
    signature = f"{function.__module__}.{function.__qualname__} {code} {states} {inputs} {numbers.signature}"

    def make() -> Plan:
        """Write the equations down."""
        return planned(*traced(function, numbers, states, inputs))

    if signature not in MADE:
        MADE[signature] = Program(kept_plan(signature, make) if installed() else make(), signature, states, inputs)
    return MADE[signature]
