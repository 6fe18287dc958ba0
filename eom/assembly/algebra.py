"""How matrices are put together and solved: densely here, for large systems as `eom.assembly.sparse` does."""

from collections.abc import Callable, Iterable, Sequence
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
    """A dense regular matrix."""

    def __init__(self, A: Array) -> None:
        self.A = A

    def solve(self, right: Array) -> Array:
        """Solution x of A x = *right*."""
        return np.asarray(np.linalg.solve(self.A, right), dtype=np.float64)

    def solve_transposed(self, right: Array) -> Array:
        """Solution x of A' x = *right*."""
        return np.asarray(np.linalg.solve(self.A.T, right), dtype=np.float64)

    def smallest(self) -> float:
        """The smallest singular value."""
        return float(np.linalg.svd(self.A, compute_uv=False)[-1]) if len(self.A) else np.inf


def dense(shape: tuple[int, int], entries: Iterable[Entry]) -> Array:
    """A matrix of the given shape from its entries."""
    matrix = np.zeros(shape)
    for rows, columns, values in entries:
        matrix[rows[:, np.newaxis], columns] += values
    return matrix


DENSE = Algebra(dense, DenseFactor)
SIX = np.arange(6)


def moving_columns(bodies: Sequence[int]) -> tuple[Indices, Indices]:
    """Coordinates of those of the bodies that are not the ground, and their places among six columns a body."""
    ends = [end for end, body in enumerate(bodies) if body != GROUND]
    starts = 6 * np.array([[bodies[end] for end in ends], ends], dtype=np.intp)
    columns, local = (starts[:, :, np.newaxis] + SIX).reshape(2, -1)
    return columns, local


def row_entry(at: int, bodies: Sequence[int], rows: Array) -> Entry:
    """Rows over six columns a body, from row *at* of a matrix over all coordinates."""
    columns, local = moving_columns(bodies)
    return np.arange(at, at + len(rows)), columns, rows if len(local) == rows.shape[1] else rows[:, local]


def square_entry(bodies: Sequence[int], matrix: Array) -> Entry:
    """A matrix over six coordinates a body, in one over all coordinates."""
    columns, local = moving_columns(bodies)
    return columns, columns, matrix if len(local) == len(matrix) else matrix[local[:, np.newaxis], local]


def stacked(blocks: Sequence[tuple[Sequence[int], Array]], size: int, algebra: Algebra) -> Array:
    """Rows of several items, each given with its bodies, one below the other over *size* coordinates."""
    starts = np.cumsum([0, *(len(rows) for _, rows in blocks)])
    entries = (row_entry(int(at), bodies, rows) for at, (bodies, rows) in zip(starts, blocks, strict=False))
    return algebra.build((int(starts[-1]), size), entries)


def block_diagonal(blocks: Sequence[Array], algebra: Algebra) -> Array:
    """Square matrices along a diagonal."""
    starts = np.cumsum([0, *(len(block) for block in blocks)])
    places = [np.arange(at, at + len(block)) for at, block in zip(starts, blocks, strict=False)]
    entries = ((place, place, block) for place, block in zip(places, blocks, strict=True))
    return algebra.build((int(starts[-1]), int(starts[-1])), entries)
