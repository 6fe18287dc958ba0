"""Sparse counterpart of `eom.assembly.algebra.DENSE`, for systems of many bodies."""

from collections.abc import Iterable
from typing import Any, cast

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from eom.assembly.algebra import Algebra, Entry
from eom.assembly.vectors import Array


def build(shape: tuple[int, int], entries: Iterable[Entry]) -> Array:
    """A compressed sparse row array from its entries, typed as the array that it stands in for."""
    parts = [
        (np.repeat(rows, len(columns)), np.tile(columns, len(rows)), values.ravel())
        for rows, columns, values in entries
    ]
    if not parts:
        return cast("Array", sparse.csr_array(shape))
    rows, columns, values = (np.concatenate(part) for part in zip(*parts, strict=True))
    return cast("Array", sparse.csr_array(sparse.coo_array((values, (rows, columns)), shape=shape)))


class SparseFactor:
    """A sparse regular matrix, factorised by SuperLU."""

    def __init__(self, A: Array) -> None:
        self.factor: Any = None
        try:
            self.factor = splu(sparse.csc_array(A))
        except RuntimeError:
            # exactly singular: `smallest` says so
            self.factor = None

    def solve(self, right: Array) -> Array:
        """Solution x of A x = *right*."""
        return np.asarray(self.factor.solve(np.ascontiguousarray(right)))

    def solve_transposed(self, right: Array) -> Array:
        """Solution x of A' x = *right*."""
        return np.asarray(self.factor.solve(np.ascontiguousarray(right), trans="T"))

    def smallest(self) -> float:
        """Zero if exactly singular; the pivots of a tree of joints are checked where they are chosen."""
        return 0.0 if self.factor is None else np.inf


SPARSE = Algebra(build, SparseFactor)
