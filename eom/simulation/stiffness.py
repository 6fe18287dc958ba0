"""How fast a model's roots are, and the derivatives that implicit steps need; in loops for a compiler."""

from typing import Any

import numpy as np

from eom.simulation.memory import DIRECTION, DRIFT, GROWING, K0, NEW, RIGHT, ROOT, SIZE, V0, V1, X
from eom.simulation.steps import GAMMA, rates

NUDGE = 1e-7
"""Relative step of differences."""


def size_of(row: int, v: Any) -> float:
    """Root mean square of a change of state over the size of the states."""
    total = 0.0
    for i in range(v.shape[1]):
        ratio = v[row, i] / (v[SIZE, i] + v[GROWING, i] * abs(v[X, i]))
        total += ratio * ratio
    return float((total / v.shape[1]) ** 0.5)


def fastest(program: Any, t: float, clock: Any, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> float:
    """Magnitude [1/s] of the fastest root at the state, by iteration along the direction in which rates change most.

    As B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326, section 3, but with two
    products: the roots of z^2 = a z + b, where J J d = a J d + b d in least squares, are a pair also if it swings.
    """
    n = v.shape[1]
    change(program, t, DIRECTION, V0, at, v, work, pieces, signals)
    change(program, t, V0, V1, at, v, work, pieces, signals)
    dd = de = ee = df = ef = 0.0
    for i in range(n):
        size = v[SIZE, i] + v[GROWING, i] * abs(v[X, i])
        d, e, f = v[DIRECTION, i] / size, v[V0, i] / size, v[V1, i] / size
        dd, de, ee, df, ef = dd + d * d, de + d * e, ee + e * e, df + d * f, ef + e * f
    # d and J d of one direction, or nearly: one root
    apart = ee * dd - de * de
    if not (apart > 1e-8 * ee * dd):
        root = (ee / dd) ** 0.5
    else:
        a, b = (ef * dd - df * de) / apart, (ee * df - de * ef) / apart
        inner = a * a + 4.0 * b
        root = 0.5 * (abs(a) + inner**0.5) if inner >= 0.0 else (-b) ** 0.5
    length = size_of(V1, v)
    if length > 0.0 and np.isfinite(length):
        for i in range(n):
            v[DIRECTION, i] = v[V1, i] / length
    return float(root) if np.isfinite(root) else clock[ROOT]


def change(
    program: Any, t: float, row: int, result: int, at: Any, v: Any, work: Any, pieces: Any, signals: Any
) -> None:
    """Set a row to the Jacobian times another one, by a difference."""
    length = size_of(row, v)
    step = NUDGE / length if length > 0.0 else 0.0
    for i in range(v.shape[1]):
        v[NEW, i] = v[X, i] + step * v[row, i]
    rates(program, t, False, NEW, 0, result, at, v, work, pieces, signals)
    for i in range(v.shape[1]):
        v[result, i] = (v[result, i] - v[K0, i]) / step if step > 0.0 else 0.0


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
    later = t + NUDGE * h
    rates(program, later, True, X, 0, RIGHT, at, v, work, pieces, signals)
    for i in range(v.shape[1]):
        v[DRIFT, i] = (v[RIGHT, i] - v[K0, i]) / (later - t) if later > t else 0.0


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
