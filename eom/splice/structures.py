"""Named tuples in compiled code: structures that are passed by reference, with the same names of their parts.

A tuple of arrays is passed by value, and every array in it counted, which makes compilation slow and calls too.
"""

import functools
from importlib import import_module
from typing import Any

import numpy as np

from eom.tyre.kernel import numba


@functools.cache
def structure(kind: Any) -> Any:
    """A class of structures with the fields of a named tuple's class; compiled code makes them as it makes tuples."""
    numba()
    types: Any = import_module("numba.core.types")
    structref: Any = import_module("numba.experimental.structref")

    def preprocess_fields(_self: Any, fields: Any) -> Any:
        return tuple((name, types.unliteral(item)) for name, item in fields)

    typed = structref.register(
        type(f"{kind.__name__}Type", (types.StructRef,), {"preprocess_fields": preprocess_fields})
    )
    proxy = type(kind.__name__, (structref.StructRefProxy,), {"__slots__": ()})
    structref.define_proxy(proxy, typed, list(kind._fields))
    return proxy


def as_structure(part: Any) -> Any:
    """A named tuple, and those in it, as structures; arrays in row order, of doubles or 64-bit integers."""
    if isinstance(part, np.ndarray):
        return np.ascontiguousarray(part, dtype=np.float64 if part.dtype.kind == "f" else np.int64)
    if not hasattr(part, "_fields"):
        return part
    kind: Any = type(part)
    return structure(kind)(*map(as_structure, part))
