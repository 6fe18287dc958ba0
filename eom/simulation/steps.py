"""One step of each integrator, in loops for a compiler.

Every step starts with the state in row X of *v* and its rates in K0. It leaves state, error and rates at its end.
"""

from typing import Any

import numpy as np

from eom.simulation.by_address import by_address
from eom.simulation.memory import DRIFT, ERROR, K0, K1, K2, K3, K4, K6, NEW, RESULTS, RIGHT, V0, X
from eom.simulation.pieces import fill_inputs


def evaluate(program: Any, at: Any, v: Any, row: int, work: Any, level: int) -> None:
    """Fill the results for the state in a row: of level 0 rates, 1 margins too, 2 outputs too."""
    program(at, v, row, work, level)


# a compiler calls by address instead
evaluate.written = by_address  # type: ignore[attr-defined]


def rates(
    program: Any,
    t: float,
    before: bool,
    row: int,
    level: int,
    k: int,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> None:
    """Set row *k* to the rates of the state in a row at t."""
    fill_inputs(t, before, at, work, pieces, signals)
    evaluate(program, at, v, row, work, level)
    for i in range(v.shape[1]):
        v[k, i] = work[at[RESULTS] + i]


def runge_kutta(program: Any, t: float, h: float, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> int:
    """The classical method of order four; returns the row of the rates at t + h.

    The error is that of the method of order three that takes these rates for its last stage: larger than the one made.
    """
    n = v.shape[1]
    for stage in range(1, 4):
        step = h if stage == 3 else 0.5 * h
        for i in range(n):
            v[NEW, i] = v[X, i] + step * v[K0 + stage - 1, i]
        rates(program, t + step, True, NEW, 0, K0 + stage, at, v, work, pieces, signals)
    for i in range(n):
        v[NEW, i] = v[X, i] + h / 6.0 * (v[K0, i] + 2.0 * (v[K1, i] + v[K2, i]) + v[K3, i])
    rates(program, t + h, True, NEW, 1, K4, at, v, work, pieces, signals)
    for i in range(n):
        v[ERROR, i] = h / 6.0 * (v[K3, i] - v[K4, i])
    return K4


# J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26, table 2
NODES = np.array([0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0])
STAGES = np.array(
    [
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
    ]
)
DEFECT = np.array([71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0])


def dormand_prince(program: Any, t: float, h: float, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> int:
    """Order five with an error of order four; returns the row of the rates at t + h."""
    n = v.shape[1]
    for stage in range(1, 7):
        for i in range(n):
            total = 0.0
            for j in range(stage):
                total += STAGES[stage, j] * v[K0 + j, i]
            v[NEW, i] = v[X, i] + h * total
        level = 1 if stage == 6 else 0
        rates(program, t + NODES[stage] * h, True, NEW, level, K0 + stage, at, v, work, pieces, signals)
    for i in range(n):
        total = 0.0
        for j in range(7):
            total += DEFECT[j] * v[K0 + j, i]
        v[ERROR, i] = h * total
    return K6


# ROS34PW2 of J. Rang, L. Angermann, BIT 45 (2005) 761-787: order three whatever the Jacobian, stiffly accurate
GAMMA = 4.3586652150845900e-01
ALPHA = np.array(
    [
        [0.0, 0.0, 0.0],
        [8.7173304301691801e-01, 0.0, 0.0],
        [8.4457060015369423e-01, -1.1299064236484185e-01, 0.0],
        [0.0, 0.0, 1.0],
    ]
)
GAMMAS = np.array(
    [
        [0.0, 0.0, 0.0],
        [-8.7173304301691801e-01, 0.0, 0.0],
        [-9.0338057013044082e-01, 5.4180672388095326e-02, 0.0],
        [2.4212380706095346e-01, -1.2232505839045147e00, 5.4526025533510214e-01],
    ]
)
WEIGHTS = np.array([2.4212380706095346e-01, -1.2232505839045147e00, 1.5452602553351020e00, 4.3586652150845900e-01])
EMBEDDED = np.array([3.7810903145819369e-01, -9.6042292212423178e-02, 0.5, 2.1793326075422950e-01])


def rosenbrock(
    program: Any,
    t: float,
    h: float,
    jacobian: Any,
    factors: Any,
    pivots: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> int:
    """Order three with an error of order two; *factors* are of 1/(h gamma) - J. Returns the row of rates at t + h.

    Each stage solves
    (1/(h gamma) - J) gamma v_i = f(t + alpha_i h, x + sum alpha_ij v_j) + J sum gamma_ij v_j + h gamma_i df/dt.
    """
    n = v.shape[1]
    for stage in range(4):
        later, slope, k = 0.0, GAMMA, K0
        for j in range(stage):
            later += ALPHA[stage, j]
            slope += GAMMAS[stage, j]
        if stage > 0:
            for i in range(n):
                v[NEW, i] = v[X, i]
                v[RIGHT, i] = 0.0
                for j in range(stage):
                    v[NEW, i] += ALPHA[stage, j] * v[V0 + j, i]
                    v[RIGHT, i] += GAMMAS[stage, j] * v[V0 + j, i]
            k = K1
            rates(program, t + later * h, True, NEW, 0, k, at, v, work, pieces, signals)
        for i in range(n):
            total = v[k, i] + h * slope * v[DRIFT, i]
            if stage > 0:
                for j in range(n):
                    total += jacobian[i, j] * v[RIGHT, j]
            v[V0 + stage, i] = total / GAMMA
        solve(factors, pivots, v, V0 + stage)
    for i in range(n):
        v[NEW, i], v[ERROR, i] = v[X, i], 0.0
        for j in range(4):
            v[NEW, i] += WEIGHTS[j] * v[V0 + j, i]
            v[ERROR, i] += (WEIGHTS[j] - EMBEDDED[j]) * v[V0 + j, i]
    rates(program, t + h, True, NEW, 1, K4, at, v, work, pieces, signals)
    return K4


def solve(factors: Any, pivots: Any, v: Any, row: int) -> None:
    """Replace a row by the solution of the system of which it is the right side."""
    n = v.shape[1]
    for j in range(n):
        v[row, j], v[row, pivots[j]] = v[row, pivots[j]], v[row, j]
    for i in range(n):
        total = v[row, i]
        for j in range(i):
            total -= factors[i, j] * v[row, j]
        v[row, i] = total
    for i in range(n - 1, -1, -1):
        total = v[row, i]
        for j in range(i + 1, n):
            total -= factors[i, j] * v[row, j]
        v[row, i] = total / factors[i, i]
