"""A plain function with loops as LLVM's text, by numba: for rows of arguments, one row after the other."""

from collections.abc import Sequence
from importlib import import_module
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np

from eom.program.numbers import PACKAGE, loaded
from eom.program.object_code import ENTRY
from eom.program.value import constant, integer

NAME = "eom_entry_of_rows"


class Kind(NamedTuple):
    """What an argument is: a number ("f" or "i"), or an array of a type and a number of axes."""

    type: str
    axes: int

    @property
    def width(self) -> int:
        """Places that it takes in a table of whole numbers: an array stands there by its address and shape."""
        return 1 + self.axes if self.axes else int(self.type == "i")


def kind_of(value: Any) -> Kind:
    """The kind of an argument."""
    if isinstance(value, np.ndarray) and value.ndim:
        return Kind(value.dtype.str, value.ndim)
    return Kind("f" if isinstance(value, (float, np.floating)) else "i", 0)


def loop_text(function: Any, kinds: Sequence[Kind]) -> str:
    """LLVM's text of ``entry(_, _, n, which, table, width, numbers, count, results)``.

    Of *n* rows, the numbers of *which* are listed, it sets the results: what the function gives for the arguments in
    that row of *table* (int64, of a *width*) and of *numbers* (float64, *count* in a row), in the order of the kinds.
    Two pointers to memory come first, which numba fills with what is not of interest here.
    """
    numba, types = import_module("numba"), import_module("numba.types")
    names: dict[str, Any] = {"function": machine_code(function, {})}
    arguments, place, number = [], 0, 0
    for k, kind in enumerate(kinds):
        if kind.axes:
            names[f"view_{k}"] = view(types.Array(numba.from_dtype(np.dtype(kind.type)), kind.axes, "C"))
            arguments.append(f"view_{k}(table, i * width + {place})")
        else:
            arguments.append(f"numbers[i * count + {number}]" if kind.type == "f" else f"table[i * width + {place}]")
        place, number = place + kind.width, number + (kind == Kind("f", 0))
    text = (
        f"def {NAME}(n, which, table, width, numbers, count, results):\n"
        f"    for k in range(n):\n"
        f"        i = which[k]\n"
        f"        results[i] = function({', '.join(arguments)})\n"
    )
    exec(text, names)  # noqa: S102  our own text
    whole, real = types.int64, types.float64
    pointers = types.CPointer(whole), types.CPointer(whole), whole, types.CPointer(real), whole, types.CPointer(whole)
    entry = numba.njit(types.void(whole, *pointers), **OPTIONS)(names[NAME])
    found: str = entry.inspect_llvm(entry.signatures[0])
    module = import_module("llvmlite.binding").parse_assembly(found)
    (symbol,) = (item.name for item in module.functions if NAME in item.name and not item.is_declaration)
    return found.replace(symbol, ENTRY)


# for code that only such code calls, with arrays that others own
OPTIONS = {
    "nogil": True,
    "error_model": "numpy",
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
    "_nrt": False,
}


def machine_code(function: Any, made: dict[Any, Any]) -> Any:
    """A function for numba, with all functions of this package that it calls; *made* holds those that are ready.

    A function with an attribute ``written`` is replaced by what that gives.
    """
    written = getattr(function, "written", None)
    if written is not None:
        return written()
    if function not in made:
        names = {}
        for name in loaded(function, "LOAD_GLOBAL"):
            value = function.__globals__.get(name)
            if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
                names[name] = machine_code(value, made)
        plain = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
        made[function] = one_version(import_module("numba").njit(**OPTIONS)(plain))
    return made[function]


def one_version(dispatcher: Any) -> Any:
    """A compiled function that does not become another one for every constant that it is called with."""
    unliteral, template = import_module("numba.types").unliteral, dispatcher.get_call_template
    dispatcher.get_call_template = lambda args, kws: template(
        tuple(map(unliteral, args)), {name: unliteral(kind) for name, kind in kws.items()}
    )
    return dispatcher


def view(kind: Any) -> Any:
    """Numba's function of a table and a place in it, that gives the array whose address and shape stand there."""
    extending, arrays = import_module("numba.extending"), import_module("numba.np.arrayobj")

    def code(context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        table, place = args

        def entry(k: int) -> Any:
            """A number of the table."""
            at = builder.add(place, constant(integer(), k))
            return builder.load(builder.gep(table, [at], inbounds=True))

        element = context.get_data_type(kind.dtype)
        shape = [entry(1 + k) for k in range(kind.ndim)]
        strides = [constant(integer(), context.get_abi_sizeof(element))]
        for length in reversed(shape[1:]):
            strides.insert(0, builder.mul(strides[0], length))
        array = context.make_array(kind)(context, builder)
        data = builder.inttoptr(entry(0), element.as_pointer())
        arrays.populate_array(array, data=data, shape=shape, strides=strides, itemsize=strides[-1], meminfo=None)
        return array._getvalue()  # noqa: SLF001  as in numba's own examples

    def array_at(_typing: Any, table: Any, place: Any) -> Any:
        return kind(table, place), code

    return extending.intrinsic(array_at)
