"""Steps of many cases at once, and where margins vanish in them."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.accepted import LOCATED


class Step(NamedTuple):
    """A step of every case: begin and length [s], states and rates at both ends, (n, cases)."""

    t: Array
    h: Array
    x: Array
    new: Array
    f: Array
    f_new: Array

    def at(self, share: Array) -> Array:
        """The states at shares of the steps, cubic between the ends."""
        change = self.new - self.x
        bent = self.h * self.f - change
        twisted = change - self.h * self.f_new - bent
        return np.asarray(self.x + share * (change + (1.0 - share) * (bent + share * twisted)))

    def of(self, cases: Any) -> "Step":
        """The step of some cases."""
        return Step(*(part[..., cases] for part in self))


def crossings(margins_at: Callable[[Array], Array], below: Array, above: Array) -> Array:
    """Shares of steps at which margins are zero, as `eom.simulation.accepted.crossing`.

    *margins_at* gives them at shares; they are *below* at the beginning and *above* at the end, of different signs.
    """
    lower, upper, left, right, ends = 0.0 * below, 0.0 * below + 1.0, below.copy(), above.copy(), above < 0.0
    halve = np.zeros(len(below), dtype=bool)
    while np.any(upper - lower > LOCATED):
        going, width = upper - lower > LOCATED, upper - lower
        line = lower + width * left / np.where(left == right, 1.0, left - right)
        share = np.where(halve, lower + 0.5 * width, np.clip(line, lower + 0.25 * LOCATED, upper - 0.25 * LOCATED))
        found = margins_at(share)
        same = (found < 0.0) == ends
        beyond, nearer = going & same, going & ~same
        upper, right = np.where(beyond, share, upper), np.where(beyond, found, np.where(nearer, 0.5 * right, right))
        lower, left = np.where(nearer, share, lower), np.where(nearer, found, np.where(beyond, 0.5 * left, left))
        halve = np.where(going, upper - lower > 0.5 * width, halve)
    return np.asarray(upper)
