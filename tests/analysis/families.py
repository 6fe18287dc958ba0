"""Linear models over a parameter, written as matrices."""

from collections.abc import Callable

import numpy as np
from scipy.linalg import block_diag

import eom

Array = np.ndarray


def model_of(A: Array) -> eom.LinearModel:
    """A linear model with this state matrix, no inputs, and a single body that nothing moves."""
    n = len(A)
    names = tuple(f"x{k}" for k in range(n))
    return eom.LinearModel(
        A=A,
        B=np.zeros((n, 0)),
        C=np.zeros((0, n)),
        D=np.zeros((0, 0)),
        states=names,
        inputs=(),
        outputs=(),
        state_units=("-",) * n,
        input_units=(),
        output_units=(),
        cyclic=(),
        name="matrix",
        speed=0.0,
        bodies=("body",),
        centres=np.zeros((1, 3)),
        motion=np.zeros((6, n)),
    )


def oscillator(frequency: float, damping: float) -> Array:
    """State matrix of x'' + 2 damping frequency x' + frequency^2 x = 0."""
    return np.array([[0.0, 1.0], [-(frequency**2), -2.0 * damping * frequency]])


def hidden(blocks: Callable[[float], list[Array]], T: Array) -> Callable[[float], eom.LinearModel]:
    """The family of block-diagonal matrices in the coordinates of T."""
    return lambda value: model_of(T @ np.linalg.solve(T.T, block_diag(*blocks(value)).T).T)
