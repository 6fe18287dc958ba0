"""Inputs of many cases, each at an instant of its own, in NumPy."""

from typing import TYPE_CHECKING, Any

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation import memory as of
from eom.simulation.pieces import CURSOR, DEGREE, FIRST, INPUT, LAST

if TYPE_CHECKING:
    from eom.simulation.fleet import Fleet


class LaneInputs:
    """Inputs that hold, (inputs, cases), and the pieces of those that change."""

    def __init__(self, fleet: "Fleet") -> None:
        self.base = np.ascontiguousarray(fleet.work[:, : int(fleet.at[of.INPUTS])].T)
        self.pieces, self.signals = fleet.pieces, fleet.signals.copy()

    def at(self, t: Array, before: Any, cases: Any) -> Array:
        """Inputs of some cases, each at an instant, at a joint *before* it or after, (inputs, cases)."""
        u, pieces = self.base[:, cases].copy(), self.pieces
        for k in range(self.signals.shape[1]):
            signal = self.signals[cases, k]
            piece, first, last = signal[:, CURSOR], signal[:, FIRST], signal[:, LAST]
            while True:
                following = pieces[np.minimum(piece + 1, len(pieces) - 1), 0]
                later = (piece < last) & ((following < t) | ((following == t) & ~before))
                own = pieces[piece, 0]
                earlier = (piece > first) & ((own > t) | ((own == t) & before)) & ~later
                if not np.any(later | earlier):
                    break
                piece = piece + later - earlier
            self.signals[cases, k, CURSOR] = piece
            since, value = t - pieces[piece, 0], np.zeros(len(t))
            for power in range(DEGREE, -1, -1):
                value = value * since + pieces[piece, 1 + power]
            u[signal[0, INPUT]] = value
        return u

    def hand_back(self, fleet: "Fleet") -> None:
        """Leave everything where the next time finds it."""
        fleet.signals[:] = self.signals
