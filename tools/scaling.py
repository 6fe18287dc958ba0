"""Cost of assembly, reduction and state space from 10 to 1000 bodies: chains of hinges and grids with loops.

    python tools/scaling.py [--largest 1000]

Each time is also given as a multiple of one dense solve of 1000 equations on the same machine in the same run.
"""

import argparse
import time
from collections.abc import Callable
from itertools import product

import numpy as np

from eom.assembly.matrices import assemble_matrices
from eom.assembly.pivots import choose_coordinates, complete
from eom.assembly.state_space import StateSpace, state_space
from eom.model.assembly import algebra_for
from eom.vehicle.elements import GROUND, Body, Connection, Constraint, Elastic, System, Vector

DOWN: Vector = (0.0, 0.0, -9.81)
INERTIA = ((0.1, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.0, 0.2))


def body(name: str, x: float, y: float = 0.0) -> Body:
    """A body of one kilogram at rest."""
    return Body(name, 1.0, (x, y, 0.0), INERTIA, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


def chain(count: int) -> System:
    """Bodies hinged to each other about y and z in turn, with torsion springs and dampers; the first to the ground."""
    axes: tuple[Vector, Vector] = ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    hinges, springs = [], []
    for k in range(count):
        place: Vector = (float(k), 0.0, 0.0)
        ends = (k, k - 1 if k else GROUND)
        axis = axes[k % 2]
        hinges.append(Constraint(Connection(f"hinge_{k}", ends, (place, place), 3, axis, 2, axis)))
        twist = Connection(f"spring_{k}", ends, (place, place), 0, axis, 1, axis)
        springs.append(Elastic(twist, (0.0, 1e6), (0.0, 10.0)))
    return System(
        tuple(body(f"b{k}", k + 0.5) for k in range(count)), DOWN, tuple(hinges), (), tuple(springs), (), (), (), ()
    )


def grid(side: int) -> System:
    """A net of bodies: ball joints along its rows, rods across them, so that every mesh is a closed loop."""
    joints = []
    for i, j in product(range(side), range(side)):
        here = i * side + j
        if i:
            place: Vector = (i - 0.5, float(j), 0.0)
            joints.append(Constraint(Connection(f"ball_{i}_{j}", (here, here - side), (place, place), 3)))
        if j:
            ends: tuple[Vector, Vector] = ((float(i), float(j), 0.1), (float(i), j - 1.0, -0.1))
            joints.append(Constraint(Connection(f"rod_{i}_{j}", (here, here - 1), ends, 1, line=True)))
    bodies = tuple(body(f"b{i}_{j}", float(i), float(j)) for i, j in product(range(side), range(side)))
    return System(bodies, (0.0, 0.0, 0.0), tuple(joints), (), (), (), (), (), ())


def reduce(system: System) -> StateSpace:
    """All of it: pivots, statics, matrices, first-order form, cyclic motions, state space."""
    algebra = algebra_for(len(system.bodies))
    pivots = choose_coordinates(system, algebra)
    matrices = assemble_matrices(system, pivots, algebra)
    return state_space(system, matrices, *complete(system, matrices, pivots))


def seconds(action: Callable[[], object], repeats: int) -> float:
    """The shortest of several runs."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--largest", type=int, default=1000, help="bodies of the longest chain")
    largest = parser.parse_args().largest
    matrix = np.random.default_rng(0).normal(size=(1000, 1000))
    unit = seconds(lambda: np.linalg.solve(matrix, matrix), 3)
    print(f"one dense solve of 1000 equations: {unit * 1e3:.0f} ms")
    print(f"{'system':12}{'bodies':>8}{'rows of J':>11}{'states':>8}{'time [s]':>10}{'in solves':>11}")
    chains = [("chain", chain(count)) for count in (10, 35, 100, 300, 1000) if count <= largest]
    grids = [("grid", grid(side)) for side in (5, 10, 20, 30) if side * side <= largest]
    for name, system in (*chains, *grids):
        count = len(system.bodies)
        time_taken = seconds(lambda system=system: reduce(system), 5 if count < 200 else 2)  # type: ignore[misc]
        rows = sum(3 if item.connection.forces == 3 else 1 for item in system.constraints) + sum(
            item.connection.moments for item in system.constraints
        )
        states = len(reduce(system).A) if count < 200 else 2 * (6 * count - rows)
        print(f"{name:12}{count:8}{rows:11}{states:8}{time_taken:10.3f}{time_taken / unit:11.1f}", flush=True)


if __name__ == "__main__":
    main()
