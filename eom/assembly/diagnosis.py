"""What is wrong with a system of constraints or masses, by name: rank, redundancy, massless motions."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.matrices import Matrices
from eom.assembly.reduction import Reduction
from eom.assembly.statics import RANK_TOLERANCE
from eom.assembly.vectors import Array

SHOWN = 0.1


def redundant_joints(J: Array, owners: Sequence[str]) -> list[tuple[str, ...]]:
    """Groups of joints that lock the same motion, one group for each dimension of redundancy.

    *owners* names the joint of each row. The left null vectors of the scaled rows are reduced to echelon form, so
    that each group is as small as its redundancy allows.
    """
    scaled = J / np.maximum(np.linalg.norm(J, axis=1), 1e-300)[:, np.newaxis]
    U, sigma, _ = np.linalg.svd(scaled)
    rank = int(np.sum(sigma > RANK_TOLERANCE * sigma[0])) if sigma.size else 0
    null = U[:, rank:].T.copy()
    for k in range(len(null)):
        pivot = int(np.argmax(np.abs(null[k])))
        null[k] /= null[k, pivot]
        for other in range(len(null)):
            if other != k:
                null[other] -= null[other, pivot] * null[k]
    return [
        tuple(dict.fromkeys(owners[int(i)] for i in np.flatnonzero(np.abs(vector) > SHOWN * np.max(np.abs(vector)))))
        for vector in null
    ]


def massless_motion(matrices: Matrices, reduction: Reduction) -> int | None:
    """Coordinate that moves most in a motion without mass, or None if every motion has mass."""
    mass = reduction.W.T @ matrices.M @ reduction.W
    scale = np.sqrt(np.maximum(np.diag(mass), 1e-300))
    values, vectors = np.linalg.eigh(mass / np.outer(scale, scale))
    weightless = np.flatnonzero(np.diag(mass) <= 0.0)
    if weightless.size:
        return int(reduction.independent_velocities[weightless[0]])
    if values.size == 0 or values[0] > RANK_TOLERANCE:
        return None
    motion = reduction.W @ (vectors[:, 0] / scale)
    return int(np.argmax(np.abs(motion)))
