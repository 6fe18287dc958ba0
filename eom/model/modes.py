"""Modes of a linear model: eigenvalues and what an engineer reads from them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Modes:
    """Eigenvalues, the slowest first; those of cyclic coordinates are exactly zero and come first of all.

    Attributes
    ----------
    eigenvalues : Complex
        Shape (modes,) [1/s].
    natural_frequency : Array
        abs(eigenvalue)/(2 pi) [Hz]; zero for real roots.
    damping_ratio : Array
        -Re/abs; NaN for real roots.
    time_constant : Array
        -1/Re [s]; infinite for undamped roots, negative for unstable ones.
    participation : Array
        Share of each state in each mode, shape (states, modes), columns sum to one.
    states : tuple of str
    """

    eigenvalues: Complex
    natural_frequency: Array
    damping_ratio: Array
    time_constant: Array
    participation: Array
    states: tuple[str, ...]

    def dominant(self, mode: int, count: int = 2) -> tuple[str, ...]:
        """The states that take the largest part in a mode."""
        order = np.argsort(-self.participation[:, mode], kind="stable")
        return tuple(self.states[k] for k in order[:count])


def modes_of(A: Array, states: tuple[str, ...], cyclic: tuple[int, ...]) -> Modes:
    """Modes of dx/dt = A x whose *cyclic* columns are known to give exact zeros."""
    kept = np.setdiff1d(np.arange(len(A)), cyclic)
    values, vectors = np.linalg.eig(A[np.ix_(kept, kept)])
    order = np.lexsort((-values.imag, np.round(np.abs(values), 12)))
    values, vectors = values[order], vectors[:, order]
    shares = np.abs(vectors * np.linalg.pinv(vectors).T)
    participation = np.zeros((len(A), len(A)))
    participation[list(cyclic), np.arange(len(cyclic))] = 1.0
    participation[np.ix_(kept, np.arange(len(cyclic), len(A)))] = shares / np.sum(shares, axis=0)
    eigenvalues = np.concatenate([np.zeros(len(cyclic)), values]).astype(complex)
    size = np.abs(eigenvalues)
    oscillates = np.abs(eigenvalues.imag) > 1e-9 * np.maximum(size, 1e-300)
    with np.errstate(divide="ignore", invalid="ignore"):
        damping = np.where(oscillates, -eigenvalues.real / size, np.nan)
        constant = np.where(eigenvalues.real == 0.0, np.inf, -1.0 / eigenvalues.real)
    frequency = np.where(oscillates, size / (2.0 * np.pi), 0.0)
    return Modes(eigenvalues, frequency, damping, constant, participation, states)
