"""Exact steps of a linear system in time, under inputs that are a system of their own within each step.

    dx/dt = A x + B u,  u = H xi,  dxi/dt = S xi

One matrix exponential of [[A, B H], [0, S]] gives x after a step without error but rounding: S = 0 for a constant
input, a nilpotent S for a straight line, a rotation for a sine.

Source: C. F. Van Loan, Computing integrals involving the matrix exponential, IEEE Trans. Automatic Control 23 (1978).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array

# of the end time: steps that differ by less are one
EQUAL = 1e-12


class Drive(NamedTuple):
    """The inputs' own system: S (k, k) [1/s] and H (inputs, k)."""

    S: Array
    H: Array


def held(inputs: int) -> Drive:
    """Inputs that stay constant within a step: xi = u."""
    return Drive(np.zeros((inputs, inputs)), np.eye(inputs))


def straight(inputs: int) -> Drive:
    """Inputs that follow a straight line within a step: xi = (u, du/dt)."""
    zero, one = np.zeros((inputs, inputs)), np.eye(inputs)
    return Drive(np.block([[zero, one], [zero, zero]]), np.hstack([one, zero]))


def sine(inputs: int, source: int, frequency: float) -> Drive:
    """One input that is a sine of a frequency [Hz] within a step: xi = amplitude (sin, cos) of its angle."""
    turn = 2.0 * np.pi * frequency
    H = np.zeros((inputs, 2))
    H[source, 0] = 1.0
    return Drive(np.array([[0.0, turn], [-turn, 0.0]]), H)


def distinct_steps(time: Array) -> tuple[Array, NDArray[np.intp]]:
    """The different lengths among a time's steps [s], and which of them each step has."""
    steps = np.diff(time)
    _, which = np.unique(np.round(steps / (EQUAL * np.max(np.abs(time), initial=1e-300))), return_inverse=True)
    return np.bincount(which, steps) / np.bincount(which), which


def march(A: Array, B: Array, drive: Drive, time: Array, starts: Array, x0: Array) -> Array:
    """States at times, shape (len(time), states); *starts* holds xi at the beginning of each step, shape (steps, k).

    The times need not be evenly spaced: each different step costs one matrix exponential.
    """
    from scipy.linalg import expm  # noqa: PLC0415  slow to import

    states, own = len(A), len(drive.S)
    result = np.empty((len(time), states))
    result[0] = x0
    if len(time) == 1:
        return result
    # the exponential's accuracy is that of the whole matrix: inputs of any unit get the size of A
    driven = B @ drive.H
    scale = (float(np.linalg.norm(driven)) or 1.0) / (float(np.linalg.norm(A)) or 1.0)
    whole = np.block([[A, driven / scale], [np.zeros((own, states)), drive.S]])
    lengths, which = distinct_steps(time)
    moves = expm(whole * lengths[:, np.newaxis, np.newaxis])[:, :states]
    for k, kind in enumerate(which):
        result[k + 1] = moves[kind] @ np.concatenate([result[k], scale * starts[k]])
    return result
