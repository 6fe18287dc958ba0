"""How matrices are put together and solved: densely here, for large systems as `eom.assembly.sparse` does."""

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.vehicle.elements import GROUND

Indices = NDArray[np.intp]
Entry = tuple[Indices, Indices, Array]
"""A small matrix and the rows and columns of a large one that it is added to."""


class Factor(Protocol):
    """A regular matrix, ready to be solved with."""

    def solve(self, right: Array) -> Array:
        """Solution x of A x = *right*."""
        ...

    def solve_transposed(self, right: Array) -> Array:
        """Solution x of A' x = *right*."""
        ...

    def smallest(self) -> float:
        """About the smallest singular value."""
        ...


class Algebra(NamedTuple):
    """``build`` adds entries into a matrix of a shape, ``factor`` prepares a square matrix for solving."""

    build: Callable[[tuple[int, int], Iterable[Entry]], Array]
    factor: Callable[[Array], Factor]


class DenseFactor:
    """A dense regular matrix, inverted once; solutions are refined by one step."""

    def __init__(self, A: Array) -> None:
        self.A = A
        try:
            self.inverse = np.asarray(np.linalg.inv(A), dtype=np.float64)
        except np.linalg.LinAlgError:
            # exactly singular: `smallest` says so
            self.inverse = np.full(A.shape, np.inf)

    def solve(self, right: Array) -> Array:
        """Solution x of A x = *right*."""
        x = self.inverse @ right
        return np.asarray(x + self.inverse @ (right - self.A @ x))

    def solve_transposed(self, right: Array) -> Array:
        """Solution x of A' x = *right*."""
        x = self.inverse.T @ right
        return np.asarray(x + self.inverse.T @ (right - self.A.T @ x))

    def smallest(self) -> float:
        """A lower bound of the smallest singular value, near it but for a few parts."""
        size = np.abs(self.inverse)
        return float(1.0 / np.sqrt(np.max(size.sum(axis=0), initial=0.0) * np.max(size.sum(axis=1), initial=1e-300)))


def dense(shape: tuple[int, int], entries: Iterable[Entry]) -> Array:
    """A matrix of the given shape from its entries."""
    matrix = np.zeros(shape)
    for rows, columns, values in entries:
        matrix[rows[:, np.newaxis], columns] += values
    return matrix


DENSE = Algebra(dense, DenseFactor)
SIX = np.arange(6)


@lru_cache(maxsize=4096)
def moving_columns(bodies: tuple[int, ...]) -> tuple[Indices, Indices]:
    """Coordinates of those of the bodies that are not the ground, and their places among six columns a body."""
    ends = [end for end, body in enumerate(bodies) if body != GROUND]
    starts = 6 * np.array([[bodies[end] for end in ends], ends], dtype=np.intp)
    columns, local = (starts[:, :, np.newaxis] + SIX).reshape(2, -1)
    columns.flags.writeable = local.flags.writeable = False
    return columns, local


def row_entry(at: int, bodies: tuple[int, ...], rows: Array) -> Entry:
    """Rows over six columns a body, from row *at* of a matrix over all coordinates."""
    columns, local = moving_columns(bodies)
    return np.arange(at, at + len(rows)), columns, rows if len(local) == rows.shape[1] else rows[:, local]


def square_entry(bodies: tuple[int, ...], matrix: Array) -> Entry:
    """A matrix over six coordinates a body, in one over all coordinates."""
    columns, local = moving_columns(bodies)
    return columns, columns, matrix if len(local) == len(matrix) else matrix[local[:, np.newaxis], local]


def stacked(blocks: Sequence[tuple[tuple[int, ...], Array]], size: int, algebra: Algebra) -> Array:
    """Rows of several items, each given with its bodies, one below the other over *size* coordinates."""
    starts = np.cumsum([0, *(len(rows) for _, rows in blocks)])
    entries = (row_entry(int(at), bodies, rows) for at, (bodies, rows) in zip(starts, blocks, strict=False))
    return algebra.build((int(starts[-1]), size), entries)


def block_diagonal(blocks: Sequence[Array], algebra: Algebra) -> Array:
    """Matrices along a diagonal."""
    starts = np.cumsum([(0, 0), *(block.shape for block in blocks)], axis=0)
    entries = (
        (row + np.arange(block.shape[0]), column + np.arange(block.shape[1]), block)
        for (row, column), block in zip(starts, blocks, strict=False)
    )
    return algebra.build((int(starts[-1][0]), int(starts[-1][1])), entries)
