"""Algebra of small matrices in loops, for a compiler: no library is called, nothing is copied."""

import math
from typing import Any

import numpy as np

from eom.splice.flat import Entries


def add_product(matrix: Entries, x: Any, y: Any, factor: float) -> None:
    """Add a factor times a matrix times x to y."""
    row, column, value = matrix.row, matrix.column, matrix.value
    for k in range(len(value)):
        y[row[k]] += factor * value[k] * x[column[k]]


def product(matrix: Entries, x: Any, length: int) -> Any:
    """A matrix of a number of rows times x."""
    y = np.zeros(length)
    add_product(matrix, x, y, 1.0)
    return y


def factorised(mass: Any, first: int) -> None:
    """Turn a mass matrix from row *first* on into its Cholesky factor, in place, below and on the diagonal."""
    n = len(mass)
    for j in range(first, n):
        for i in range(j, n):
            left = mass[i, j]
            for k in range(first, j):
                left -= mass[i, k] * mass[j, k]
            mass[i, j] = math.sqrt(left) if i == j else left / mass[j, j]


def solved(factor: Any, force: Any, first: int) -> Any:
    """Accelerations under forces, by the Cholesky factor of the mass; zero before row *first*."""
    n = len(force)
    x = force.copy()
    x[:first] = 0.0
    for i in range(first, n):
        for k in range(first, i):
            x[i] -= factor[i, k] * x[k]
        x[i] /= factor[i, i]
    for i in range(n - 1, first - 1, -1):
        for k in range(i + 1, n):
            x[i] -= factor[k, i] * x[k]
        x[i] /= factor[i, i]
    return x


def gauss(matrix: Any, right: Any) -> Any:
    """Solution of a small system by elimination with pivots; both arguments are used up."""
    n = len(right)
    for j in range(n):
        pivot = j
        for i in range(j + 1, n):
            if abs(matrix[i, j]) > abs(matrix[pivot, j]):
                pivot = i
        for k in range(n):
            matrix[j, k], matrix[pivot, k] = matrix[pivot, k], matrix[j, k]
        right[j], right[pivot] = right[pivot], right[j]
        for i in range(j + 1, n):
            factor = matrix[i, j] / matrix[j, j]
            for k in range(j, n):
                matrix[i, k] -= factor * matrix[j, k]
            right[i] -= factor * right[j]
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            right[i] -= matrix[i, k] * right[k]
        right[i] /= matrix[i, i]
    return right


def projected(W: Any, force: Any) -> Any:
    """W' times generalised forces."""
    result = np.zeros(W.shape[1])
    for row in range(W.shape[0]):
        for j in range(W.shape[1]):
            result[j] += W[row, j] * force[row]
    return result


def moved_by(W: Any, n: Any) -> Any:
    """W times velocities."""
    result = np.zeros(W.shape[0])
    for row in range(W.shape[0]):
        for j in range(W.shape[1]):
            result[row] += W[row, j] * n[j]
    return result
