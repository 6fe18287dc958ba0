"""Arrays of numbers or of symbols, and the one solve that needs numbers."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from eom.errors import EomError

Array = NDArray[Any]
"""Floats, or objects where an entry is a symbol or an exact fraction."""


def matrix(rows: Sequence[Any] | Array) -> Array:
    """An array of floats, or of objects if an entry is none of Python's or NumPy's numbers; complex stays complex."""
    array = np.array(rows)
    return array.astype(float) if array.dtype.kind == "i" else array


def solve(left: Array, right: Array, name: str) -> Array:
    """left^-1 right in floating point.

    Raises
    ------
    EomError
        If an entry is a symbol, or *left*, called *name*, is singular.
    """
    if np.dtype(object) in {left.dtype, right.dtype}:
        raise EomError(
            f"{name}: expected numbers to solve with, got symbols; 'matrices' is the function that takes them"
        )
    try:
        return np.linalg.solve(left, right)
    except np.linalg.LinAlgError:
        raise EomError(f"{name} is singular: expected masses, inertias and places that give it full rank") from None
