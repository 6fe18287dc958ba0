"""Which modes the inputs can move, and which the outputs can see."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from eom.assembly.vectors import Array
from eom.model.eigen import Complex
from eom.model.linear import LinearModel

# PBH distances below it are rounding: the eigenvalues are those of a matrix nearer than that
NOTHING = 1e-10


@dataclass(frozen=True)
class ModalReach:
    """Controllability by each input and observability by each output, mode by mode, in balanced coordinates.

    The modes are those that are not exact zeros of cyclic coordinates, a conjugate pair once.

    Attributes
    ----------
    eigenvalues : Complex
        Shape (modes,) [1/s], none with a negative imaginary part, the slowest first.
    states : tuple of str
        The state with the largest share in each mode.
    controllability : Array
        Cosine between the mode's left eigenvector and the input's column, shape (modes, inputs), from 0 to 1.
    observability : Array
        Cosine between the mode's eigenvector and the output's row, shape (modes, outputs), from 0 to 1.
    input_distance, output_distance : Array
        PBH distances, same shapes: smallest singular value of [A - s I, b] with A and b of norm one, that is how much
        the model must change for the mode to be out of reach of the input; of [A - s I; c] for the output.
    inputs, outputs : tuple of str

    Notes
    -----
    Several modes with one root can never all be moved by one input: each is then told as out of reach.
    """

    eigenvalues: Complex
    states: tuple[str, ...]
    controllability: Array
    observability: Array
    input_distance: Array
    output_distance: Array
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def unmoved(self) -> Iterator[tuple[complex, str]]:
        """Each mode with an input that cannot move it."""
        for mode, column in np.argwhere(self.input_distance < NOTHING):
            yield complex(self.eigenvalues[mode]), self.inputs[column]

    def unseen(self) -> Iterator[tuple[complex, str]]:
        """Each mode with an output that cannot see it."""
        for mode, row in np.argwhere(self.output_distance < NOTHING):
            yield complex(self.eigenvalues[mode]), self.outputs[row]


def modal_reach(model: LinearModel) -> ModalReach:
    """Modal measures of controllability and observability, and the distances of Popov, Belevitch and Hautus.

    Outputs of cyclic coordinates see a mode through what it makes of them: their row is counted on the other states
    by (s I - N)^-1 at the mode's root, with N the cyclic states' own matrix.

    Source: A. M. A. Hamdan and A. H. Nayfeh, Measures of modal controllability and observability for first- and
    second-order linear systems, J. Guidance, Control and Dynamics 12 (1989), for the cosines.
    """
    from scipy.linalg import matrix_balance  # noqa: PLC0415  slow to import

    c = np.array(model.cyclic, dtype=int)
    r = np.setdiff1d(np.arange(len(model.A)), c)
    balanced, (scale, _) = matrix_balance(model.A[np.ix_(r, r)], permute=False, separate=True)
    A, B = balanced, model.B[r] / scale[:, np.newaxis]
    modes = model.modes()
    wanted = [k for k in range(len(c), len(modes.eigenvalues)) if modes.eigenvalues[k].imag >= 0.0]
    roots = modes.eigenvalues[wanted]
    chain = model.A[np.ix_(c, r)]
    N = model.A[np.ix_(c, c)]
    left, right, near_input, near_output = [], [], [], []
    for root in roots:
        seen = model.C[:, r].astype(complex)
        if root != 0.0:
            seen = seen + model.C[:, c] @ np.linalg.solve(root * np.eye(len(c)) - N, chain)
        seen = normalised(seen * scale, axis=1)
        pencil = (A - root * np.eye(len(A))) / (np.linalg.norm(A, 2) or 1.0)
        U, _, Vh = np.linalg.svd(pencil)
        moved = normalised(B.astype(complex), axis=0)
        left.append(np.abs(U[:, -1].conj() @ moved))
        right.append(np.abs(seen @ Vh[-1].conj()))
        near_input.append([distance(np.column_stack([pencil, column])) for column in moved.T])
        near_output.append([distance(np.vstack([pencil, row]).T) for row in seen])
    k, m, n = len(model.outputs), len(model.inputs), len(roots)
    return ModalReach(
        roots,
        tuple(modes.dominant(k, 1)[0] for k in wanted),
        np.reshape(left, (n, m)),
        np.reshape(right, (n, k)),
        np.reshape(near_input, (n, m)),
        np.reshape(near_output, (n, k)),
        model.inputs,
        model.outputs,
    )


def normalised(matrix: Complex, axis: int) -> Complex:
    """Rows or columns of length one; zero ones stay."""
    length = np.linalg.norm(matrix, axis=axis, keepdims=True)
    return np.asarray(matrix / np.where(length > 0.0, length, 1.0))


def distance(matrix: Complex) -> float:
    """Smallest singular value of a matrix with no more rows than columns."""
    return float(np.linalg.svd(matrix, compute_uv=False)[-1])
