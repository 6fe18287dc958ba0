"""Hankel singular values: how much of the response from inputs to outputs each direction of the state carries."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from eom.analysis.signals import indices
from eom.analysis.stability import sides, sides_of
from eom.assembly.vectors import Array
from eom.model.eigen import Complex
from eom.model.linear import LinearModel


@dataclass(frozen=True)
class HankelValues:
    """Hankel singular values of a model's stable part.

    Attributes
    ----------
    values : Array
        Falling, one for each stable state. For one input and one output in the unit of their gain; with several,
        they mix units and mean what their scaling means.
    left_out : Complex
        Roots that do not decay, for which there is no such value: unstable ones and the exact zeros of cyclic
        coordinates [1/s].
    left_out_states : tuple of str
        The state with the largest share in each of them.
    inputs, outputs : tuple of str
        Between which they are counted.
    """

    values: Array
    left_out: Complex
    left_out_states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def hankel_values(model: LinearModel, inputs: Iterable[str], outputs: Iterable[str]) -> HankelValues:
    """Square roots of the eigenvalues of the Gramians' product, over the stable part of the model.

    The model is split by its invariant subspaces, G = G_stable + G_rest, so that outputs of cyclic coordinates keep
    their stable part.

    Raises
    ------
    AnalysisError
        With a sentence for every name that the model does not have.

    Notes
    -----
    Source: K. Glover, All optimal Hankel-norm approximations of linear multivariable systems, Int. J. Control 39
    (1984).
    """
    sources, told = tuple(inputs), tuple(outputs)
    columns, rows = indices(model, sources, told)
    A, B, C = stable_part(model, model.B[:, columns], model.C[rows])
    modes = model.modes()
    rest = np.flatnonzero(sides(modes) >= 0)
    names = tuple(modes.dominant(int(k), 1)[0] for k in rest)
    return HankelValues(hankel(A, B, C), modes.eigenvalues[rest], names, sources, told)


def stable_part(model: LinearModel, B: Array, C: Array) -> tuple[Complex, Complex, Complex]:
    """A, B and C of the part whose roots decay, in complex Schur coordinates."""
    from scipy.linalg import solve_sylvester  # noqa: PLC0415  slow to import

    c = np.array(model.cyclic, dtype=int)
    r = np.setdiff1d(np.arange(len(model.A)), c)
    own = model.A[np.ix_(r, r)]
    S, Q, unstable = ordered_schur(own)
    # cyclic states, then roots that do not decay, then those that do: block upper triangular
    first = len(c) + unstable
    A = np.block([[model.A[np.ix_(c, c)], model.A[np.ix_(c, r)] @ Q], [np.zeros((len(r), len(c))), S]])
    B = np.vstack([B[c], Q.conj().T @ B[r]])
    C = np.hstack([C[:, c], C[:, r] @ Q])
    stable = A[first:, first:]
    if first and len(stable):
        # z_rest - Y z_stable moves by itself
        Y = solve_sylvester(-A[:first, :first], stable, A[:first, first:])
        C = np.hstack([C[:, :first], C[:, first:] + C[:, :first] @ Y])
    return stable.astype(complex), B[first:].astype(complex), C[:, first:].astype(complex)


def ordered_schur(A: Array) -> tuple[Complex, Complex, int]:
    """Complex Schur form Q S Q*, roots that do not decay first, and their number."""
    from scipy.linalg import schur  # noqa: PLC0415  slow to import

    if not len(A):
        return A.astype(complex), A.astype(complex), 0
    roots = np.linalg.eigvals(A).astype(complex)
    stays = sides_of(roots) >= 0

    def first(root: complex) -> bool:
        return bool(stays[np.argmin(np.abs(roots - root))])

    # the stubs know the sorting of real forms alone
    S, Q, count = schur(A.astype(complex), output="complex", sort=first)  # type: ignore[call-overload]
    return S, Q, int(count)


def hankel(A: Complex, B: Complex, C: Complex) -> Array:
    """Hankel singular values of a stable system, from factors of its Gramians."""
    from scipy.linalg import solve_continuous_lyapunov  # noqa: PLC0415  slow to import

    if not len(A):
        return np.zeros(0)
    reached = np.asarray(solve_continuous_lyapunov(A, -B @ B.conj().T), dtype=complex)
    seen = np.asarray(solve_continuous_lyapunov(A.conj().T, -C.conj().T @ C), dtype=complex)
    return np.asarray(np.linalg.svd(factor(seen).conj().T @ factor(reached))[1])


def factor(gramian: Complex) -> Complex:
    """F with F F* the Gramian, what rounding made negative set to zero."""
    values, vectors = np.linalg.eigh((gramian + gramian.conj().T) / 2.0)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0)), dtype=complex)
