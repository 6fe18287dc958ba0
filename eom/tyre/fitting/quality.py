"""How well measured points determine fitted coefficients."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from eom.tyre.fitting.data import Array, Points

ARM = 0.1
"""Length [m] that makes a moment per load comparable to a force per load: the size of a large pneumatic trail."""

WEAK = 1e-8
"""Smallest singular value of the Jacobian with columns of length one; below, rounding decides (its square is eps)."""


class Residual(NamedTuple):
    """Root mean square of what a fit leaves of a channel.

    Attributes
    ----------
    value : float
        In N or N m.
    per_load : float
        The same over the root mean square of the load: a number for forces, metres for moments.
    """

    value: float
    per_load: float


def scales_of(points: Points) -> dict[str, float]:
    """What each channel is divided by [N or N m]."""
    load = float(np.sqrt(np.mean(points.arguments["Fz"] ** 2)))
    return {name: load * (ARM if name.startswith("M") else 1.0) for name in points.channels}


def residuals_of(rest: Array, points: Points, scales: Mapping[str, float]) -> dict[str, Residual]:
    """Root mean squares of the residuals, channel by channel."""
    parts = np.split(rest, len(points.channels))
    found = {}
    for name, part in zip(points.channels, parts, strict=True):
        rms = float(np.sqrt(np.mean(part**2)))
        found[name] = Residual(rms * scales[name], rms * (ARM if name.startswith("M") else 1.0))
    return found


def uncertainty(J: Array, rest: Array, names: Sequence[str]) -> tuple[Array, Array, list[str]]:
    """Standard errors, their correlation, and sentences for what the data do not determine.

    The covariance is s^2 (J^T J)^-1 with s^2 the sum of squares over its degrees of freedom. Columns of J are first
    brought to length one; singular values that are nearly zero then show combinations without effect.
    """
    lengths = np.linalg.norm(J, axis=0)
    _, singular, rows = np.linalg.svd(J / np.where(lengths > 0.0, lengths, 1.0), full_matrices=False)
    strong = singular > WEAK * singular[0] if singular[0] > 0.0 else np.zeros(len(singular), dtype=bool)
    # what takes part in a combination without effect, by more than rounding
    loose = np.any(np.abs(rows[~strong]) > np.sqrt(WEAK), axis=0)
    inverse = rows[strong].T / singular[strong]
    spread = np.linalg.norm(inverse, axis=1)
    deviation = np.sqrt(rest @ rest / max(len(rest) - len(names), 1))
    with np.errstate(invalid="ignore", divide="ignore"):
        errors = np.where(loose, np.inf, deviation * spread / lengths)
        correlation = np.where(loose[:, None] | loose, np.nan, inverse @ inverse.T / np.outer(spread, spread))
    sentences = []
    for k in np.flatnonzero(loose).tolist():
        others = [names[i] for i in np.flatnonzero(loose & (lengths > 0.0)).tolist() if i != k]
        why = f"only together with {', '.join(others)}" if lengths[k] > 0.0 else "not at all"
        sentences.append(f"the data determine {names[k]} {why}: its value is one of many")
    return errors, correlation, sentences


def at_bounds(values: Array, mask: Array, names: Sequence[str]) -> list[str]:
    """Sentences for coefficients that the data would move beyond their bounds."""
    return [
        f"{name} = {value:g} stands at its bound: its standard error says nothing"
        for name, value, side in zip(names, values, mask, strict=True)
        if side
    ]
