"""What is wrong, or odd, about a system of constraints: joints that lock the same motion, joints that cannot move."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.reduction import ROUNDING, Reduction
from eom.assembly.rows import force_directions, local_rows, row_count, six
from eom.assembly.vectors import Array, directions
from eom.vehicle.elements import GROUND, Connection, System

SHOWN, PLACES, MANY = 0.1, 3, 8


class Lock(NamedTuple):
    """A motion that a joint locks: translation [-] and rotation of its first body against its second one."""

    joint: str
    translation: tuple[float, ...]
    rotation: tuple[float, ...]

    def __str__(self) -> str:
        """The motion in words."""
        parts = [
            f"{kind} ({', '.join(f'{value:g}' for value in vector)})"
            for kind, vector in (("translation along", self.translation), ("rotation about", self.rotation))
            if any(vector)
        ]
        return f"{self.joint}: {' with '.join(parts)}"


def redundant_locks(system: System, null: Array) -> list[tuple[Lock, ...]]:
    """For each dimension of redundancy the motions, joint by joint, of which the others imply any one.

    Columns of *null* are left null vectors of J, such as `eom.assembly.statics.self_stresses` gives.
    """
    joints = [item.connection for item in system.constraints]
    return [tuple(locks(joints, vector)) for vector in echelon(null).T]


def echelon(null: Array) -> Array:
    """The same space of columns, each with a row of its own, so that few rows are not zero."""
    result = null.copy()
    for k in range(result.shape[1]):
        pivot = int(np.argmax(np.abs(result[:, k])))
        result[:, k] /= result[pivot, k]
        others = np.delete(np.arange(result.shape[1]), k)
        result[:, others] -= np.outer(result[:, k], result[pivot, others])
    return result


def near_null(J: Array, tolerance: float) -> Array:
    """Combinations of the rows of J that all but vanish, as columns."""
    scale = np.maximum(np.linalg.norm(J, axis=1), 1e-300)
    U, sigma, _ = np.linalg.svd(J / scale[:, np.newaxis])
    rank = int(np.sum(sigma > tolerance * sigma[0])) if sigma.size else 0
    return np.asarray(U[:, rank:] / scale[:, np.newaxis])


def locks(joints: Sequence[Connection], multipliers: Array) -> Iterator[Lock]:
    """The motion of each joint that a combination of constraint rows stands for, the largest component 1."""
    at, largest = 0, float(np.max(np.abs(multipliers)))
    for joint in joints:
        own = multipliers[at : at + row_count(joint)] / largest
        at += len(own)
        if np.any(np.abs(own) > SHOWN):
            along = force_directions(joint)
            about = directions(joint.moments, joint.moment_axis)
            translation, rotation = own[: len(along)] @ along, own[len(along) :] @ about
            yield Lock(joint.name, rounded(translation), rounded(rotation))


def rounded(vector: Array) -> tuple[float, ...]:
    """Components to three places, without negative zeros."""
    return tuple(float(value) + 0.0 for value in np.round(vector, PLACES))


def redundant_joints(system: System, null: Array) -> str:
    """Names of the joints that lock the same motion, a group for each column of *null*."""
    groups = [[lock.joint for lock in group] for group in redundant_locks(system, null)]
    return "; ".join(dict.fromkeys(" with ".join(some(group)) for group in groups))


def groups_of(null: Array, owners: Sequence[str]) -> list[tuple[str, ...]]:
    """Owners of the rows that take part in each null vector, as few as the redundancy allows."""
    return [
        tuple(dict.fromkeys(owners[int(k)] for k in np.flatnonzero(np.abs(vector) > SHOWN * np.max(np.abs(vector)))))
        for vector in echelon(null).T
    ]


def some(names: list[str]) -> list[str]:
    """The names, or if they are many the first ones and how many others there are."""
    return names if len(names) <= MANY else [*names[: MANY - 1], f"{len(names) - MANY + 1} others"]


def locked_joints(system: System, reduction: Reduction) -> list[str]:
    """Joints that leave their bodies some relative motion of which the loops they belong to leave none."""
    found = []
    limit = ROUNDING * max(1.0, float(np.max(np.abs(reduction.T), initial=0.0)))
    # what holds a speed is no loop
    towed = {body for item in system.constraints if item.moving for body in item.connection.bodies}
    for item in system.constraints:
        joint = item.connection
        if joint.line or not joint.forces or row_count(joint) >= 6 or set(joint.bodies) <= towed:
            continue
        every = local_rows(system.bodies, joint._replace(forces=3, moments=3))
        motion = np.zeros((6, reduction.T.shape[1]))
        for end, body in enumerate(joint.bodies):
            if body != GROUND:
                motion += every[:, six(end)] @ reduction.T[six(body)]
        if np.all(np.abs(motion) <= limit):
            found.append(joint.name)
    return found
