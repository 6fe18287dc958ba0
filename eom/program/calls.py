"""Calls of a plain function for many cases, as machine code where there is a compiler."""

import ctypes
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from eom.program.cache import key
from eom.program.compiled import installed
from eom.program.loop_text import Kind, kind_of, loop_text
from eom.program.make import place_of
from eom.program.object_code import address

POINTER, WHOLE = ctypes.c_void_p, ctypes.c_int64
CALL = ctypes.CFUNCTYPE(ctypes.c_int32, POINTER, POINTER, WHOLE, POINTER, POINTER, WHOLE, POINTER, WHOLE, POINTER)
"""How the machine code of `eom.program.loop_text.loop_text` is called."""


REAL = Kind("f", 0)


class Each(NamedTuple):
    """An argument that is another one in each case."""

    values: Any


class Form(NamedTuple):
    """How a function is called.

    Kinds of its arguments; where they stand in a row of a table, or of numbers; lengths of both rows; the entry.
    """

    kinds: Mapping[str, Kind]
    places: Mapping[str, int]
    whole_numbers: int
    real_numbers: int
    entry: Any


@cache
def form_of(function: Any, kinds: tuple[tuple[str, Kind], ...]) -> Form:
    """The form of a function with arguments of some kinds, compiled if it never was."""
    places: dict[str, int] = {}
    width = count = 0
    for name, kind in kinds:
        places[name] = count if kind == REAL else width
        width, count = width + kind.width, count + (kind == REAL)
    own = [kind for _, kind in kinds]
    code = function.__code__
    text = f"{function.__module__}.{function.__name__} {code.co_code.hex()} {code.co_consts} {own}"
    entry = CALL(address(f"loop_{key(text)}", lambda: loop_text(function, own)))
    return Form(dict(kinds), places, width, count, entry)


class Calls:
    """A plain function with its arguments in each case: numbers, and arrays that it changes in place.

    It gives a whole number. Compiled it may use what numba knows, and functions of this package that do.

    Attributes
    ----------
    results : NDArray
        Whole numbers that the function gave last in each case, (cases,).
    """

    def __init__(self, function: Any, cases: int, arguments: Mapping[str, Any]) -> None:
        self.function, self.arguments = function, dict(arguments)
        self.results = np.zeros(cases, dtype=np.int64)
        self.compiled = installed()
        if not self.compiled:
            return
        names = function.__code__.co_varnames[: function.__code__.co_argcount]
        self.form = form_of(function, tuple((name, kind_of(one(self.arguments[name], 0))) for name in names))
        self.table = np.zeros((cases, self.form.whole_numbers), dtype=np.int64)
        self.numbers = np.zeros((cases, self.form.real_numbers))
        self.ignored = np.zeros(2, dtype=np.int64)
        place = place_of(self.ignored)
        self.before = place, place + 8
        table, numbers = (
            (place_of(self.table), self.form.whole_numbers),
            (place_of(self.numbers), self.form.real_numbers),
        )
        self.after = *table, *numbers, place_of(self.results)
        for name in names:
            self.set(name, self.arguments[name])

    def set(self, name: str, value: Any) -> None:
        """Give an argument another value, one for all cases or `Each`; ``ValueError`` if it is of another kind."""
        if not self.compiled:
            self.arguments[name] = value
            return
        kind, place = self.form.kinds[name], self.form.places[name]
        if kind.axes:
            many = value.values if isinstance(value, Each) else [value]
            self.table[:, place : place + kind.width] = [address_and_shape(item, kind) for item in many]
        elif kind == REAL:
            self.numbers[:, place] = value.values if isinstance(value, Each) else value
        elif kind_of(one(value, 0)) != kind:
            raise ValueError(f"{name}: expected a whole number")
        else:
            self.table[:, place] = value.values if isinstance(value, Each) else value
        # what is pointed to stays as long as it is
        self.arguments[name] = value

    def __call__(self, cases: Any) -> None:
        """Call it for some cases."""
        if self.compiled:
            which = np.ascontiguousarray(cases, dtype=np.int64)
            self.form.entry(*self.before, len(which), place_of(which), *self.after)
            return
        for case in cases:
            own = {name: one(value, case) for name, value in self.arguments.items()}
            self.results[case] = self.function(**own)


def one(value: Any, case: int) -> Any:
    """The value of an argument in a case."""
    return value.values[case] if isinstance(value, Each) else value


def address_and_shape(array: Any, kind: Kind) -> tuple[int, ...]:
    """Of an array of a kind whose elements stand one after the other."""
    if kind_of(array) != kind or not array.flags.c_contiguous:
        raise ValueError(f"an array of another kind than {kind}")
    return (place_of(array), *array.shape)
