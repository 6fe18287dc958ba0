"""Roots of a model with the right and left eigenvectors by which they are recognised in another one."""

from collections.abc import Set as AbstractSet
from typing import NamedTuple

import numpy as np

from eom.analysis.family import Node
from eom.assembly.vectors import Array
from eom.model.eigen import Complex


class Spectrum(NamedTuple):
    """Roots beside those of some cyclic states.

    Attributes
    ----------
    modes : Array
        Which of the model's modes these are, shape (n,).
    roots : Complex
        Shape (n,) [1/s].
    A : Array
        State matrix of the states that these modes belong to, (n, n).
    right, left : Complex
        Eigenvectors as columns and as rows, left right = 1.
    states : tuple of str
    """

    modes: Array
    roots: Complex
    A: Array
    right: Complex
    left: Complex
    states: tuple[str, ...]


def spectrum(node: Node, apart: AbstractSet[str]) -> Spectrum:
    """Spectrum without the cyclic states *apart*, which are neither driven by nor drive the other roots."""
    model, modes = node.model, node.modes
    rest = np.array([k for k, name in enumerate(model.states) if name not in apart], dtype=int)
    own = [k for k, state in enumerate(modes.cyclic) if model.states[state] not in apart]
    columns = np.array([*own, *range(len(modes.cyclic), len(modes.eigenvalues))], dtype=int)
    right = modes.eigenvectors[np.ix_(rest, columns)]
    right = right / np.linalg.norm(right, axis=0)
    return Spectrum(
        columns,
        modes.eigenvalues[columns],
        model.A[np.ix_(rest, rest)],
        right,
        # of a defective matrix they are the nearest that there is
        np.linalg.pinv(right),
        tuple(model.states[k] for k in rest),
    )


def shared_cyclic(one: Node, two: Node) -> AbstractSet[str]:
    """States that are cyclic in both models."""
    first, second = ({node.model.states[k] for k in node.model.cyclic} for node in (one, two))
    return first & second
