"""Which joints of a redundant system of constraints lock the same motion."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.statics import RANK_TOLERANCE
from eom.assembly.vectors import Array

SHOWN = 0.1


def redundant_joints(J: Array, owners: Sequence[str], tolerance: float = RANK_TOLERANCE) -> list[tuple[str, ...]]:
    """Groups of joints that lock the same motion, one group for each dimension of redundancy.

    *owners* names the joint of each row. The left null vectors of the scaled rows are reduced to echelon form, so
    that each group is as small as its redundancy allows.
    """
    scaled = J / np.maximum(np.linalg.norm(J, axis=1), 1e-300)[:, np.newaxis]
    U, sigma, _ = np.linalg.svd(scaled)
    rank = int(np.sum(sigma > tolerance * sigma[0])) if sigma.size else 0
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
