"""Transmission zeros: complex frequencies at which a motion of the inputs leaves the outputs at rest."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from eom.analysis.signals import indices
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.eigen import Complex
from eom.model.linear import LinearModel

# of the scaled system, whose matrices have norm one: a smaller singular value is rounding
ROUNDING = 1e-11


@dataclass(frozen=True)
class Zeros:
    """Zeros from some inputs to some outputs.

    Attributes
    ----------
    values : Complex
        Finite zeros [1/s], the smallest first.
    inputs, outputs : tuple of str
    """

    values: Complex
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def transmission_zeros(model: LinearModel, inputs: Iterable[str], outputs: Iterable[str]) -> Zeros:
    """Finite zeros of the Rosenbrock pencil [[A - s I, B], [C, D]] between any numbers of inputs and outputs.

    Cyclic states that none of these outputs measures are left out. Modes that the inputs cannot move or the outputs
    cannot see are zeros too (see `eom.analysis.reach.modal_reach`). Infinite zeros are removed by orthogonal
    reductions of the scaled system, not by their size.

    Raises
    ------
    AnalysisError
        For names that the model does not have; where the transfer matrix is zero, so that any number is a zero.

    Notes
    -----
    Source: A. Emami-Naeini and P. Van Dooren, Computation of zeros of linear multivariable systems, Automatica 18
    (1982).
    """
    sources, told = tuple(inputs), tuple(outputs)
    columns, rows = indices(model, sources, told)
    kept = np.arange(len(model.A))
    cyclic = np.array(model.cyclic, dtype=int)
    if not np.any(model.C[np.ix_(rows, cyclic)]):
        kept = np.setdiff1d(kept, cyclic)
    A, B = model.A[np.ix_(kept, kept)], model.B[np.ix_(kept, columns)]
    C, D = model.C[np.ix_(rows, kept)], model.D[np.ix_(rows, columns)]
    A, B, C, D, rate = scaled(A, B, C, D)
    A, B, C, D = rows_reduced(A, B, C, D)
    A, C, B, D = (matrix.T for matrix in rows_reduced(A.T, C.T, B.T, D.T))
    if not len(D):
        message = f"zeros from {', '.join(sources)} to {', '.join(told)}: the inputs do not move the outputs"
        raise AnalysisError(message)
    # D is square and regular: with y = 0 the inputs are u = -D^-1 C x
    values = rate * np.linalg.eigvals(A - B @ np.linalg.solve(D, C)) if len(A) else np.zeros(0)
    ordered = np.asarray(values, dtype=complex)[np.lexsort((-values.imag, np.round(np.abs(values), 12)))]
    return Zeros(ordered, sources, told)


def scaled(A: Array, B: Array, C: Array, D: Array) -> tuple[Array, Array, Array, Array, float]:
    """The system in balanced states, with A, inputs and outputs of norm one, and the rate [1/s] taken out of it."""
    from scipy.linalg import matrix_balance  # noqa: PLC0415  slow to import

    if len(A):
        balanced, (scale, _) = matrix_balance(A, permute=False, separate=True)
        A, B, C = np.asarray(balanced, dtype=float), B / scale[:, np.newaxis], C * scale
    rate = float(np.linalg.norm(A)) or 1.0
    A, B = A / rate, B / rate
    for _ in range(2):
        size = np.sqrt(np.sum(B**2, axis=0) + np.sum(D**2, axis=0))
        B, D = (matrix / np.where(size > 0.0, size, 1.0) for matrix in (B, D))
        size = np.sqrt(np.sum(C**2, axis=1) + np.sum(D**2, axis=1))[:, np.newaxis]
        C, D = (matrix / np.where(size > 0.0, size, 1.0) for matrix in (C, D))
    return A, B, C, D, rate


def rows_reduced(A: Array, B: Array, C: Array, D: Array) -> tuple[Array, Array, Array, Array]:
    """A system with the same finite zeros whose D has full row rank: states that zero outputs fix are taken out."""
    while True:
        U, s, _ = np.linalg.svd(D)
        rank = int(np.sum(s > ROUNDING))
        C, D = U.T @ C, U.T @ D
        free = C[rank:]
        if not len(free):
            return A, B, C, D
        _, s, Vh = np.linalg.svd(free)
        fixed = int(np.sum(s > ROUNDING))
        C, D = C[:rank], D[:rank]
        if not fixed:
            return A, B, C, D
        # the first states stay, the last ones are zero while the outputs are
        V = np.roll(Vh, -fixed, axis=0).T
        A, B, C = V.T @ A @ V, V.T @ B, C @ V
        stay = len(A) - fixed
        C, D = np.vstack([C[:, :stay], A[stay:, :stay]]), np.vstack([D, B[stay:]])
        A, B = A[:stay, :stay], B[:stay]
