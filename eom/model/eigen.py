"""Eigenvalues and eigenvectors of a linear model whose cyclic states are known to give exact zeros."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array

Complex = NDArray[np.complex128]

# of the largest root: what rounding makes of a zero
ZERO = 1e-13


class Eigen(NamedTuple):
    """Eigenvalues, the slowest first after those of cyclic states; columns of the matrices belong to them.

    Attributes
    ----------
    values : Complex
        Shape (modes,) [1/s].
    vectors : Complex
        Motion of the states in each mode, (states, modes); a cyclic state's is that state alone.
    participation : Array
        Share of each state in each mode, (states, modes), columns sum to one.
    """

    values: Complex
    vectors: Complex
    participation: Array


def eigen(A: Array, cyclic: Sequence[int]) -> Eigen:
    """Eigenvalues and eigenvectors of dx/dt = A x with the columns *cyclic* zero but for each other's drift."""
    along = np.array(cyclic, dtype=int)
    kept = np.setdiff1d(np.arange(len(A)), along)
    values, own = np.linalg.eig(A[np.ix_(kept, kept)])
    order = np.lexsort((-values.imag, np.round(np.abs(values), 12)))
    values, own = values[order].astype(complex), own[:, order]
    shares = np.abs(own * np.linalg.pinv(own).T)
    count = len(along)
    participation, vectors = np.zeros(A.shape), np.zeros(A.shape, dtype=complex)
    for matrix in (participation, vectors):
        matrix[along, np.arange(count)] = 1.0
    participation[np.ix_(kept, np.arange(count, len(A)))] = shares / np.sum(shares, axis=0)
    vectors[kept, count:] = own
    drift, driven = A[np.ix_(along, along)], A[np.ix_(along, kept)] @ own
    vectors[along, count:] = carried(drift, driven, values)
    return Eigen(np.concatenate([np.zeros(count), values]), vectors, participation)


def carried(drift: Array, driven: Complex, values: Complex) -> Complex:
    """How cyclic states move along in the other modes, (cyclic, modes): s x = drift x + driven.

    A mode whose root is zero carries them away for ever; it is shown without that.
    """
    result = np.zeros_like(driven, dtype=complex)
    moving = np.abs(values) > ZERO * np.max(np.abs(values), initial=0.0)
    systems = values[moving, np.newaxis, np.newaxis] * np.eye(len(drift)) - drift
    result[:, moving] = np.linalg.solve(systems, driven.T[moving, :, np.newaxis])[:, :, 0].T
    return result
