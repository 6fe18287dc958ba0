"""One step of each integrator: numbers in, numbers out; for a compiler, and for Python without one.

Every step takes the state x and its rates f at t, and gives state, rates and an estimate of its error at t + h.
"""

from typing import Any, NamedTuple

import numpy as np

from eom.simulate.carried import Implicit
from eom.simulate.pieces import Pieces, fill_inputs


class Problem(NamedTuple):
    """A model in numbers, the memory that it works in, and its inputs; ``program`` is what `evaluate` calls.

    Attributes
    ----------
    program : object
        Address of compiled code, or a function.
    parameters, scratch, results : Array
        What it takes, and what it fills: rates of states, then margins, then outputs.
    pieces : Pieces
    cursor : NDArray
        Where each signal was looked up last.
    u : Array
        Inputs, set at each evaluation.
    """

    program: Any
    parameters: Any
    scratch: Any
    results: Any
    pieces: Pieces
    cursor: Any
    u: Any


def evaluate(program: Any, x: Any, u: Any, parameters: Any, scratch: Any, results: Any, level: int) -> None:
    """Fill the results up to a level: 0 rates, 1 margins too, 2 outputs too. Compiled code calls by address."""
    program(x, u, parameters, scratch, results, level)


evaluate.calls_program = True  # type: ignore[attr-defined]


def rates_into(f: Any, t: float, before: bool, x: Any, level: int, p: Problem) -> None:
    """Set f to the rates of x at t."""
    fill_inputs(t, before, p.pieces, p.cursor, p.u)
    evaluate(p.program, x, p.u, p.parameters, p.scratch, p.results, level)
    f[:] = p.results[: len(f)]


def runge_kutta(t: float, h: float, x: Any, k: Any, new: Any, error: Any, p: Problem) -> None:
    """The classical method of order four; k is (stages, n), k[0] the rates at t, k[4] gets those at t + h.

    The error is that of the method of order three which takes k[4] for k[3]: larger than the one made.
    """
    stage = new
    stage[:] = x + 0.5 * h * k[0]
    rates_into(k[1], t + 0.5 * h, True, stage, 0, p)
    stage[:] = x + 0.5 * h * k[1]
    rates_into(k[2], t + 0.5 * h, True, stage, 0, p)
    stage[:] = x + h * k[2]
    rates_into(k[3], t + h, True, stage, 0, p)
    new[:] = x + h / 6.0 * (k[0] + 2.0 * (k[1] + k[2]) + k[3])
    rates_into(k[4], t + h, True, new, 1, p)
    error[:] = h / 6.0 * (k[3] - k[4])


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
DEFECT = np.array(
    [
        71.0 / 57600.0,
        0.0,
        -71.0 / 16695.0,
        71.0 / 1920.0,
        -17253.0 / 339200.0,
        22.0 / 525.0,
        -1.0 / 40.0,
    ]
)


def dormand_prince(t: float, h: float, x: Any, k: Any, new: Any, error: Any, p: Problem) -> None:
    """Order five with an error of order four; k is (stages, n), k[0] the rates at t, k[6] gets those at t + h."""
    for stage in range(1, 7):
        new[:] = x
        for j in range(stage):
            if STAGES[stage, j] != 0.0:
                new += h * STAGES[stage, j] * k[j]
        rates_into(k[stage], t + NODES[stage] * h, True, new, 1 if stage == 6 else 0, p)
    error[:] = 0.0
    for j in range(7):
        if DEFECT[j] != 0.0:
            error += h * DEFECT[j] * k[j]


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


def rosenbrock(t: float, h: float, x: Any, k: Any, new: Any, error: Any, implicit: Implicit, p: Problem) -> None:
    """Order three with an error of order two; *implicit* are the factors of 1/(h gamma) - J, drift df/dt and memory.

    k is (stages, n), k[0] the rates at t, k[4] gets those at t + h. Each stage solves
    (1/(h gamma) - J) gamma v_i = f(t + alpha_i h, x + sum alpha_ij v_j) + J sum gamma_ij v_j + h gamma_i df/dt.
    """
    factors, pivots, jacobian = implicit.factors, implicit.pivots, implicit.jacobian
    drift, v, right = implicit.drift, implicit.v, implicit.right
    for stage in range(4):
        new[:] = x
        right[:] = 0.0
        at, slope = 0.0, GAMMA
        for j in range(stage):
            new += ALPHA[stage, j] * v[j]
            right += GAMMAS[stage, j] * v[j]
            at += ALPHA[stage, j]
            slope += GAMMAS[stage, j]
        if stage == 0:
            k[1] = k[0]
        else:
            rates_into(k[1], t + at * h, True, new, 0, p)
        right[:] = k[1] + product(jacobian, right) + slope * h * drift
        solve_factored(factors, pivots, right)
        v[stage] = right / GAMMA
    new[:] = x
    error[:] = 0.0
    for j in range(4):
        new += WEIGHTS[j] * v[j]
        error += (WEIGHTS[j] - EMBEDDED[j]) * v[j]
    rates_into(k[4], t + h, True, new, 1, p)


def product(matrix: Any, vector: Any) -> Any:
    """A matrix times a vector."""
    result = np.zeros(len(vector))
    for j in range(len(vector)):
        if vector[j] != 0.0:
            result += vector[j] * matrix[:, j]
    return result


def factor(matrix: Any, pivots: Any) -> None:
    """Turn a matrix into its triangular factors, rows exchanged as *pivots* say."""
    n = len(matrix)
    for j in range(n):
        best = j
        for i in range(j + 1, n):
            if abs(matrix[i, j]) > abs(matrix[best, j]):
                best = i
        pivots[j] = best
        if best != j:
            for column in range(n):
                matrix[j, column], matrix[best, column] = matrix[best, column], matrix[j, column]
        for i in range(j + 1, n):
            if matrix[i, j] != 0.0:
                matrix[i, j] /= matrix[j, j]
                matrix[i, j + 1 :] -= matrix[i, j] * matrix[j, j + 1 :]


def solve_factored(factors: Any, pivots: Any, right: Any) -> None:
    """Replace a right side by the solution."""
    n = len(right)
    for j in range(n):
        right[j], right[pivots[j]] = right[pivots[j]], right[j]
    for j in range(n):
        right[j + 1 :] -= right[j] * factors[j + 1 :, j]
    for j in range(n - 1, -1, -1):
        right[j] /= factors[j, j]
        right[:j] -= right[j] * factors[:j, j]
