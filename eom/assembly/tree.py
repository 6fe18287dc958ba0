"""Dependent coordinates of many bodies: along a spanning tree of the joints, then those of the loops.

Complete pivoting over all rows at once, as `eom.assembly.pivots` does for few bodies, would take the cube of their
number. Along a tree each joint determines coordinates of the body that it adds, whatever else moves.
"""

from collections import defaultdict, deque
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.reduction import PIVOT_TOLERANCE
from eom.assembly.rows import local_rows
from eom.assembly.vectors import Array
from eom.vehicle.elements import GROUND, System

Eliminate = Callable[[Array, Array], tuple[list[int], list[int]]]


class Tree(NamedTuple):
    """Rows that a spanning tree uses, the coordinates that they determine, and the rows left to the loops."""

    rows: list[int]
    dependent: list[int]
    loops: list[int]


def spanning_tree(system: System, preference: Array, eliminate: Eliminate) -> Tree:
    """Walk the bodies from the lead body and the ground outwards; each new body pays for its joints."""
    joints = [item.connection for item in system.constraints]
    own = [local_rows(system.bodies, joint) for joint in joints]
    starts = np.cumsum([0, *(len(rows) for rows in own)])
    at_body: dict[int, list[int]] = defaultdict(list)
    for k, joint in enumerate(joints):
        for body in joint.bodies:
            at_body[body].append(k)
    visited, used = {GROUND}, set[int]()
    rows: list[int] = []
    dependent: list[int] = []
    for body in walk(system, at_body):
        visited.add(body)
        new = [k for k in at_body[body] if k not in used and set(joints[k].bodies) <= visited]
        used.update(new)
        numbers = [int(starts[k]) + row for k in new for row in range(len(own[k]))]
        blocks = [own[k][:, 6 * joints[k].bodies.index(body) :][:, :6] for k in new]
        if numbers:
            own_rows = np.vstack(blocks)
            kept, columns = eliminate(own_rows, preference[6 * body : 6 * body + 6])
            refuse_weak(np.linalg.svd(own_rows[kept][:, columns], compute_uv=False))
            rows += [numbers[k] for k in kept]
            dependent += [6 * body + column for column in columns]
    loops = np.setdiff1d(np.arange(starts[-1]), rows).tolist()
    return Tree(sorted(rows), sorted(dependent), loops)


def refuse_weak(sizes: NDArray[np.floating]) -> None:
    """Raise ``ValueError`` unless the sizes of pivots are all far from zero."""
    if sizes.size and np.min(sizes) <= PIVOT_TOLERANCE * np.max(sizes):
        message = "joints all but lock the same motion twice: let one carry less, or move them apart"
        raise ValueError(message)


def walk(system: System, at_body: dict[int, list[int]]) -> list[int]:
    """All bodies, neighbours after each other: from the lead body, then from the ground, then what hangs nowhere."""
    order: list[int] = []
    seen = {GROUND}
    for root in (0, GROUND, *range(len(system.bodies))):
        queue = deque([root])
        if root != GROUND and root in seen:
            continue
        seen.add(root)
        while queue:
            body = queue.popleft()
            if body != GROUND:
                order.append(body)
            for k in at_body[body]:
                for neighbour in system.constraints[k].connection.bodies:
                    if neighbour not in seen:
                        seen.add(neighbour)
                        queue.append(neighbour)
    return order


def pivoted_columns(matrix: Array, preference: Array, tolerance: float, sizes: Array) -> tuple[list[int], list[int]]:
    """Independent rows of a large matrix and as many columns that they determine, by pivoted QR.

    *sizes* are those of the terms that each row is a sum of.
    """
    from scipy.linalg import qr  # noqa: PLC0415  slow to import, for many bodies alone

    scaled = matrix / np.maximum(sizes, 1e-300)[:, np.newaxis]
    columns, sizes = leading(qr(scaled * preference, mode="r", pivoting=True))
    rank = int(np.sum(sizes > tolerance * np.max(sizes, initial=1.0)))
    refuse_weak(sizes[:rank])
    chosen = columns[:rank]
    if rank == len(matrix):
        return list(range(rank)), sorted(chosen)
    rows, _ = leading(qr(scaled[:, chosen].T, mode="r", pivoting=True))
    return sorted(rows[:rank]), sorted(chosen)


def leading(factors: tuple[NDArray[np.floating], NDArray[np.signedinteger]]) -> tuple[list[int], Array]:
    """Order of the columns that a pivoted QR found, and the sizes of its pivots."""
    R, order = factors
    return [int(k) for k in order], np.asarray(np.abs(np.diag(R)), dtype=np.float64)
