"""Constrained linear equations of second order: constraints eliminated, roots and transfer functions.

By an orthonormal null space from a singular value decomposition.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tests.referees.jets import Array

Complex = NDArray[np.complex128]
RANK = 1e-9
"""Singular values below this part of the largest are zeros; matrices of a few bodies have them at 1e-15."""


class Measured(NamedTuple):
    """An output: shape (6 n,) each, on q and on q', to be differentiated ``order`` times more."""

    on_q: Array
    on_rate: Array
    order: int
    direct: Array


class Spatial(NamedTuple):
    """M q'' + C q' + K q = F u + G u' + reactions; J q = 0; Jn q' + Kn q = 0."""

    M: Array
    C: Array
    K: Array
    F: Array
    G: Array
    J: Array
    Jn: Array
    Kn: Array
    outputs: tuple[Measured, ...]

    def reduced(self) -> tuple[Array, Array, Array]:
        """N, W, Y of q = N z, z' = W v + Y z: all motion that satisfies the constraints."""
        N = null_space(self.J)
        rolling = self.Jn @ N
        return N, null_space(rolling), -np.linalg.pinv(rolling, rcond=RANK) @ (self.Kn @ N)

    def A(self) -> Array:
        """System matrix in the states (z, v)."""
        N, W, Y = self.reduced()
        M, C, K = (N.T @ matrix @ N for matrix in (self.M, self.C, self.K))
        lower = -np.linalg.solve(W.T @ M @ W, W.T @ np.hstack([(M @ Y + C) @ Y + K, (M @ Y + C) @ W]))
        return np.vstack([np.hstack([Y, W]), lower])

    def eigenvalues(self) -> Complex:
        """Roots, zeros of free motions included."""
        return np.asarray(np.linalg.eigvals(self.A()), dtype=np.complex128)

    def pencil(self, s: complex) -> Complex:
        """Square matrix on (z, v) that is singular at the roots, also where motions have no mass."""
        N, W, Y = self.reduced()
        dynamic = W.T @ N.T @ (s * s * self.M + s * self.C + self.K) @ N
        kinematic = s * np.eye(len(Y)) - Y
        return np.block([[kinematic, -W], [dynamic, np.zeros((len(dynamic), W.shape[1]))]])

    def transfer(self, s: complex) -> Complex:
        """Transfer functions (outputs, inputs) at *s*."""
        N, W, Y = self.reduced()
        right = np.vstack([np.zeros((len(Y), self.F.shape[1])), W.T @ N.T @ (self.F + s * self.G)])
        q = N @ np.linalg.solve(self.pencil(s), right)[: len(Y)]
        rows = [s**item.order * (item.on_q + s * item.on_rate) @ q + item.direct for item in self.outputs]
        return np.array(rows, dtype=np.complex128)


def null_space(matrix: Array) -> Array:
    """Orthonormal columns that a matrix maps to zero."""
    _, values, right = np.linalg.svd(np.vstack([matrix, np.zeros((1, matrix.shape[1]))]))
    rank = int(np.sum(values > RANK * max(1.0, float(values[0]))))
    return np.asarray(right[rank:].T, dtype=np.float64)
