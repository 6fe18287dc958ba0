"""What is wrong, or odd, about a system of constraints: joints that lock the same motion, joints that cannot move."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.reduction import ROUNDING, Reduction, full
from eom.assembly.rows import force_directions, local_rows, row_count, six
from eom.assembly.statics import RANK_TOLERANCE
from eom.assembly.vectors import Array, directions
from eom.vehicle.elements import GROUND, Connection, System

SHOWN = 0.1
PLACES = 3


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


def redundant_locks(system: System, J: Array, tolerance: float = RANK_TOLERANCE) -> list[tuple[Lock, ...]]:
    """For each dimension of redundancy the motions, joint by joint, of which the others imply any one.

    They are the left null vectors of the scaled rows of J, brought to echelon form so that each group is as small as
    its redundancy allows.
    """
    dense = full(J)
    scale = np.maximum(np.linalg.norm(dense, axis=1), 1e-300)
    U, sigma, _ = np.linalg.svd(dense / scale[:, np.newaxis])
    rank = int(np.sum(sigma > tolerance * sigma[0])) if sigma.size else 0
    null = U[:, rank:].T.copy()
    for k in range(len(null)):
        pivot = int(np.argmax(np.abs(null[k])))
        null[k] /= null[k, pivot]
        for other in range(len(null)):
            if other != k:
                null[other] -= null[other, pivot] * null[k]
    joints = [item.connection for item in system.constraints]
    return [tuple(locks(joints, vector / scale)) for vector in null]


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


def redundant_joints(system: System, J: Array, tolerance: float = RANK_TOLERANCE) -> list[tuple[str, ...]]:
    """Names of the joints that lock the same motion, one group for each dimension of redundancy."""
    return [tuple(dict.fromkeys(lock.joint for lock in group)) for group in redundant_locks(system, J, tolerance)]


def locked_joints(system: System, reduction: Reduction) -> list[str]:
    """Joints that leave their bodies some relative motion of which the loops they belong to leave none."""
    found = []
    for item in system.constraints:
        joint = item.connection
        if joint.line or not joint.forces or row_count(joint) >= 6:
            continue
        every = local_rows(system.bodies, joint._replace(forces=3, moments=3))
        motion = np.zeros((6, reduction.T.shape[1]))
        for end, body in enumerate(joint.bodies):
            if body != GROUND:
                motion += every[:, six(end)] @ reduction.T[six(body)]
        if np.all(np.abs(motion) <= ROUNDING * max(1.0, float(np.max(np.abs(reduction.T), initial=0.0)))):
            found.append(joint.name)
    return found
