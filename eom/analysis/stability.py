"""On which side of the imaginary axis roots are, and which of them decides."""

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.model.eigen import Complex
from eom.model.modes import Modes

# of the largest root, and of an oscillation's own: a smaller real part is rounding
ON_AXIS, ON_AXIS_OSCILLATING = 1e-9, 1e-7


def on_axis(roots: Complex) -> Array:
    """Per root of all roots of a model: the real part that may be rounding [1/s]."""
    size = np.abs(roots)
    own = np.where(roots.imag != 0.0, ON_AXIS_OSCILLATING * size, 0.0)
    return np.asarray(ON_AXIS * np.max(size, initial=0.0) + own)


def sides_of(roots: Complex) -> NDArray[np.intp]:
    """Per root of all roots of a model: 1 right of the imaginary axis, -1 left, 0 on it but for rounding."""
    return np.where(np.abs(roots.real) <= on_axis(roots), 0, np.sign(roots.real)).astype(np.intp)


def sides(modes: Modes) -> NDArray[np.intp]:
    """Per mode: on which side of the imaginary axis it is, see `sides_of`."""
    return sides_of(modes.eigenvalues)


def rightmost(modes: Modes) -> int | None:
    """The mode with the largest real part, None where there is none; roots that are zero but for rounding left out."""
    size = np.abs(modes.eigenvalues)
    moving = np.flatnonzero(size > ON_AXIS * np.max(size, initial=0.0))
    return int(moving[np.argmax(modes.eigenvalues.real[moving])]) if moving.size else None


def largest_real_part(modes: Modes) -> float:
    """Of `rightmost` [1/s], exactly zero where it is but for rounding; NaN where there is none."""
    worst = rightmost(modes)
    if worst is None:
        return np.nan
    return float(modes.eigenvalues[worst].real) if sides(modes)[worst] else 0.0


def least_damping(modes: Modes) -> float:
    """Damping ratio of the least damped oscillation; NaN where nothing oscillates."""
    ratios = modes.damping_ratio[modes.oscillates]
    return float(np.min(ratios, initial=np.inf)) if ratios.size else np.nan
