"""Comparison of a generated train with a referee's: roots, and every transfer function that both have."""

from collections.abc import Mapping

import numpy as np

import eom
from tests.referees.train import LinearModel

Array = np.ndarray
FREQUENCIES = (0.05, 0.2, 0.4, 1.0, 3.0)  # Hz


def ordered(roots: Array) -> Array:
    """Roots in a fixed order, conjugates next to each other."""
    return roots[np.lexsort((roots.imag, np.round(roots.real, 6)))]


def assert_roots_agree(model: eom.LinearModel, other: LinearModel, tolerance: float) -> None:
    """The roots, but for exact zeros of cyclic coordinates, equal to a relative tolerance."""
    own = np.linalg.eigvals(model.without_cyclic().A)
    np.testing.assert_allclose(ordered(own), ordered(np.linalg.eigvals(other.A)), rtol=tolerance)


def response(other: LinearModel, frequency: float) -> Array:
    """Transfer functions of a referee at a frequency in Hz, shape (outputs, inputs)."""
    s = 2j * np.pi * frequency
    return np.asarray(other.C @ np.linalg.solve(s * np.eye(len(other.A)) - other.A, other.B) + other.D)


def size_of(signal: str) -> float:
    """What makes inputs comparable: 1 rad of steer, 1e6 N m of moment."""
    return 1.0 if signal.endswith("steer") else 1e6


def assert_responses_agree(
    model: eom.LinearModel, other: LinearModel, tolerance: float, names: Mapping[str, str] | None = None
) -> int:
    """Transfer functions between shared signals, relative to each output's largest one; how many were compared.

    *names* renames outputs of the model to those of the referee.
    """
    own = model.frequency_response(np.array(FREQUENCIES))
    outputs = {(names or {}).get(output, output): k for k, output in enumerate(model.outputs)}
    shared = [signal for signal in other.inputs if signal in model.inputs]
    compared = 0
    for k, frequency in enumerate(FREQUENCIES):
        theirs = response(other, frequency)
        for row, output in enumerate(other.outputs):
            if output not in outputs:
                continue
            largest = max(abs(theirs[row, column]) * size_of(name) for column, name in enumerate(other.inputs))
            for signal in shared:
                got = own[k, outputs[output], model.inputs.index(signal)]
                expected = theirs[row, other.inputs.index(signal)]
                assert abs(got - expected) * size_of(signal) < tolerance * largest, (output, signal, frequency)
                compared += 1
    return compared
