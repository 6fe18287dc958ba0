"""How fast a model's roots are, and the derivatives that implicit steps need; in loops for a compiler."""

from typing import Any

import numpy as np

from eom.simulate.memory import DIRECTION, DRIFT, GROWING, K0, NEW, RIGHT, ROOT, SIZE, X
from eom.simulate.steps import GAMMA, rates

NUDGE = 1e-7
"""Relative step of differences."""
FIRST, AGAIN = 12, 1
"""Iterations towards the fastest root when nothing is known of it, and later on."""


def size_of(row: int, v: Any) -> float:
    """Root mean square of a change of state over the size of the states."""
    total = 0.0
    for i in range(v.shape[1]):
        ratio = v[row, i] / (v[SIZE, i] + v[GROWING, i] * abs(v[X, i]))
        total += ratio * ratio
    return float((total / v.shape[1]) ** 0.5)


def fastest(program: Any, t: float, clock: Any, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> float:
    """Magnitude [1/s] of the fastest root at the state, by iteration along the direction in which rates change most.

    As B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326, section 3, find it. It
    tends to be too large while the direction still turns.
    """
    root = 0.0
    for _ in range(FIRST if clock[ROOT] == 0.0 else AGAIN):
        step = NUDGE / size_of(DIRECTION, v)
        for i in range(v.shape[1]):
            v[NEW, i] = v[X, i] + step * v[DIRECTION, i]
        rates(program, t, False, NEW, 0, RIGHT, at, v, work, pieces, signals)
        for i in range(v.shape[1]):
            v[RIGHT, i] -= v[K0, i]
        root = size_of(RIGHT, v) / NUDGE
        if root > 0.0 and np.isfinite(root):
            for i in range(v.shape[1]):
                v[DIRECTION, i] = v[RIGHT, i] / root
    return root


def differentiate(program: Any, t: float, jacobian: Any, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> None:
    """Set the Jacobian at the state by differences."""
    n = v.shape[1]
    for i in range(n):
        v[NEW, i] = v[X, i]
    for j in range(n):
        v[NEW, j] = v[X, j] + NUDGE * (v[SIZE, j] + v[GROWING, j] * abs(v[X, j]))
        step = v[NEW, j] - v[X, j]
        rates(program, t, False, NEW, 0, RIGHT, at, v, work, pieces, signals)
        v[NEW, j] = v[X, j]
        for i in range(n):
            jacobian[i, j] = (v[RIGHT, i] - v[K0, i]) / step


def drift(program: Any, t: float, h: float, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> None:
    """Set df/dt, which inputs bring that change within a step."""
    rates(program, t + NUDGE * h, True, X, 0, RIGHT, at, v, work, pieces, signals)
    for i in range(v.shape[1]):
        v[DRIFT, i] = (v[RIGHT, i] - v[K0, i]) / (NUDGE * h)


def factorise(h: float, jacobian: Any, factors: Any, pivots: Any) -> None:
    """Triangular factors of 1/(h gamma) - J, with rows exchanged as *pivots* say."""
    n = len(pivots)
    for i in range(n):
        for j in range(n):
            factors[i, j] = -jacobian[i, j]
        factors[i, i] += 1.0 / (h * GAMMA)
    for j in range(n):
        best = j
        for i in range(j + 1, n):
            if abs(factors[i, j]) > abs(factors[best, j]):
                best = i
        pivots[j] = best
        if best != j:
            for column in range(n):
                factors[j, column], factors[best, column] = factors[best, column], factors[j, column]
        for i in range(j + 1, n):
            if factors[i, j] != 0.0:
                factors[i, j] /= factors[j, j]
                for column in range(j + 1, n):
                    factors[i, column] -= factors[i, j] * factors[j, column]
