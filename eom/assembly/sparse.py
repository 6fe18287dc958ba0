"""Sparse counterpart of `eom.assembly.algebra.DENSE`, for systems of many bodies."""

from collections.abc import Iterable
from typing import Any, cast

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import LinearOperator, onenormest, splu

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
        self.size = A.shape[0]
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
        """A lower estimate of the smallest singular value, from the 1-norm of the inverse."""
        if self.factor is None:
            return 0.0
        shape = (self.size, self.size)
        inverse = LinearOperator(shape, matvec=self.solve, rmatvec=self.solve_transposed, dtype=np.dtype(float))
        return float(1.0 / (onenormest(inverse) * np.sqrt(self.size)))


SPARSE = Algebra(build, SparseFactor)
