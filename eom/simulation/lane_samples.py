"""Samples of many cases, evaluated together: that takes no longer than the samples of one."""

from typing import TYPE_CHECKING, Any

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation import memory as of

if TYPE_CHECKING:
    from eom.simulation.fleet import Fleet


class LaneSamples:
    """Samples that wait, one of each case at most."""

    def __init__(self, fleet: "Fleet", x: Array, u: Array) -> None:
        self.fleet, self.x, self.u = fleet, x.copy(), u.copy()
        self.waiting = np.zeros(x.shape[1], dtype=bool)
        self.rows = np.zeros(x.shape[1], dtype=np.int64)

    def add(self, cases: Any, x: Array, u: Array) -> None:
        """Take the next sample of some cases, of states and inputs, (n, cases) and (inputs, cases)."""
        if np.any(self.waiting[cases]):
            self.evaluate()
        counts = self.fleet.counts
        self.x[:, cases], self.u[:, cases], self.rows[cases] = x, u, counts[cases, of.SAMPLES]
        self.waiting[cases] = True
        counts[cases, of.SAMPLES] += 1

    def evaluate(self) -> None:
        """Fill in all that wait."""
        due = np.flatnonzero(self.waiting)
        if not due.size:
            return
        first = int(self.fleet.at[of.STATES] + self.fleet.at[of.LIMITS])
        outputs = self.fleet.over_cases(self.x, self.u, 2)[first:]
        every = np.concatenate((self.x, self.u, outputs))[:, due]
        self.fleet.rows[due, self.rows[due]] = every[self.fleet.columns].T
        self.waiting[due] = False
