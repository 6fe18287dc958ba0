"""How fast the roots of many cases are, in NumPy, as `eom.simulation.stiffness.fastest`."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation import memory as of
from eom.simulation.stiffness import NUDGE

if TYPE_CHECKING:
    from eom.simulation.fleet import Fleet


class LaneRoots:
    """Fastest roots [1/s] of all cases, (cases,), the directions they were found along, and when [s]."""

    def __init__(self, fleet: "Fleet") -> None:
        self.root, self.looked = (fleet.clock[:, k].copy() for k in (of.ROOT, of.LOOKED))
        self.direction = np.ascontiguousarray(fleet.v[:, of.DIRECTION].T)

    def look(self, due: Any, t: Array, x: Array, f: Array, size: Array, rates: Callable[[Array], Array]) -> None:
        """Look again in cases that are *due*: their instants, states, rates, sizes of the states, all for them alone.

        *rates* gives those of other states at the same instants.
        """
        direction = self.direction[:, due]

        def change(direction: Array) -> Array:
            """The Jacobians times directions, by differences."""
            length = size_of(direction, size)
            step = NUDGE / np.where(length > 0.0, length, np.inf)
            near = rates(x + step * direction)
            return np.asarray(np.where(step > 0.0, (near - f) / np.where(step > 0.0, step, 1.0), 0.0))

        once = change(direction)
        again = change(once)
        root = fastest_roots(direction, once, again, size)
        length = size_of(again, size)
        good = (length > 0.0) & np.isfinite(length)
        self.direction[:, due] = np.where(good, again / np.where(good, length, 1.0), direction)
        self.root[due] = np.where(np.isfinite(root), root, self.root[due])
        self.looked[due] = t

    def hand_back(self, fleet: "Fleet") -> None:
        """Leave everything where the next time finds it."""
        fleet.v[:, of.DIRECTION] = self.direction.T
        fleet.clock[:, of.ROOT], fleet.clock[:, of.LOOKED] = self.root, self.looked


def size_of(change: Array, size: Array) -> Array:
    """Root mean square of changes of the states over their sizes, (cases,)."""
    ratio = change / size
    return np.asarray(np.sqrt(np.mean(ratio * ratio, axis=0)))


def fastest_roots(direction: Array, once: Array, again: Array, size: Array) -> Array:
    """Magnitudes of the fastest roots [1/s] by directions d, J d and J J d."""
    d, e, f = direction / size, once / size, again / size
    dd, de, ee = np.sum(d * d, axis=0), np.sum(d * e, axis=0), np.sum(e * e, axis=0)
    df, ef = np.sum(d * f, axis=0), np.sum(e * f, axis=0)
    apart = ee * dd - de * de
    a, b = (ef * dd - df * de) / apart, (ee * df - de * ef) / apart
    inner = a * a + 4.0 * b
    real = 0.5 * (np.abs(a) + np.sqrt(np.maximum(inner, 0.0)))
    pair = np.where(inner >= 0.0, real, np.sqrt(np.maximum(-b, 0.0)))
    return np.asarray(np.where(apart > 1e-8 * ee * dd, pair, np.sqrt(ee / dd)))
