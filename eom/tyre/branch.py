"""The branch of a force curve around straight running: what lies between its two peaks."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from eom.tyre.slopes import STEP, derivative

Array = np.ndarray[Any, Any]
Curve = Callable[[Array], Array]
"""Slips, of the shape of the curves behind an axis of their own, to forces; takes complex numbers too."""

GRID = np.linspace(-1.0, 1.0, 49) ** 3
"""Slips over the end of the range at which curves are first looked at: dense about zero, where peaks are narrow."""

AT_PEAK = 1e-9
"""Accuracy of the slip of a peak; the force, which is flat there, is then exact to rounding."""


class Branch(NamedTuple):
    """A piece of a force curve on which the force has one direction over slip.

    Attributes
    ----------
    ends : array
        Slips at the lower and the upper end, stacked along the first axis before the shape of the curves.
    rises : array
        Whether the force grows with slip between them.
    peaks : array
        Whether the force has its peak there, stacked likewise; without one the end is that of the range.
    """

    ends: Array
    rises: Array
    peaks: Array


def branch(curve: Curve, end: float, shape: tuple[int, ...]) -> Branch:
    """The branch of each of many curves around straight running.

    The Magic Formula is nowhere as steep as between its peaks. So the branch is that of the steepest place,
    wherever camber, ply-steer or conicity have shifted it. A curve without any slope, that of a lifted wheel, has a
    branch of no width at zero.

    Parameters
    ----------
    curve : callable
        Forces [N] of slips.
    end : float
        Slips run from -end to end.
    shape : tuple of int
        Shape of the curves.
    """
    grid = end * GRID.reshape(-1, *(1 for _ in shape))
    slope = slope_of(curve, grid)
    count = np.arange(GRID.size).reshape(grid.shape)
    # over the tangent of the slip: the book's Magic Formula and Dugoff's tyre are curves of that
    steepest = np.argmax(np.abs(slope) * np.cos(0.5 * np.pi * grid / end) ** 2, axis=0)
    direction = np.sign(np.take_along_axis(slope, steepest[np.newaxis], axis=0))
    # the nearest places on both sides where the force goes back
    back = slope * direction <= 0.0
    below = np.max(np.where(back & (count < steepest), count, -1), axis=0)
    above = np.min(np.where(back & (count > steepest), count, GRID.size), axis=0)
    peaks = np.stack([below >= 0, above < GRID.size])
    lower = end * GRID[np.stack([np.maximum(below, 0), above - 1])]
    upper = end * GRID[np.stack([below + 1, np.minimum(above, GRID.size - 1)])]
    found = root(lambda slip: slope_of(curve, slip), lower, upper, AT_PEAK)
    ends = np.where(peaks, found, np.stack([lower[0], upper[1]]))
    # rounding bends a curve without a peak at the very end of the range
    peaks &= np.abs(ends) < (1.0 - 1e-6) * end
    still = direction[0] == 0.0
    return Branch(np.where(still, 0.0, ends), direction[0] > 0.0, peaks & ~still)


def slope_of(curve: Curve, slip: Array) -> Array:
    """Slope of each curve, exact to rounding."""
    return derivative(curve(slip + 1j * STEP))


def root(function: Curve, lower: Array, upper: Array, tolerance: float = 0.0) -> Array:
    """Where a function vanishes between two bounds, to a tolerance or to rounding; NaN where it has one sign at both.

    SciPy leaves out elements that are done, but a function of stacked tyres needs a value for each of them.
    """
    from scipy.optimize import elementwise  # noqa: PLC0415  slow to import

    whole = np.array(lower, order="C")

    def some(values: Array, places: Array) -> Array:
        whole.reshape(-1)[places] = values
        return function(whole).reshape(-1)[places]

    places = np.arange(whole.size).reshape(whole.shape)
    # its interpolation divides by differences of forces, which may be as good as zero: it bisects then
    with np.errstate(all="ignore"):
        found = elementwise.find_root(some, (lower, upper), args=(places,), tolerances={"xatol": tolerance})
    return np.asarray(found.x)
