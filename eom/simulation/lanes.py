"""Many cases at once in NumPy, by the classical method: what `eom.simulation.advance` does, case by case in lanes.

Every array's last axis is that of the cases. Each case takes the very steps that it would take alone. The caller lets
NumPy ignore what cases that have ended compute.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation import memory as of
from eom.simulation.advance import GUARD, LOOK
from eom.simulation.lane_inputs import LaneInputs
from eom.simulation.lane_roots import LaneRoots, size_of
from eom.simulation.lane_samples import LaneSamples
from eom.simulation.lane_steps import Step, crossings
from eom.simulation.step_choice import STABLE_4

if TYPE_CHECKING:
    from eom.simulation.fleet import Fleet


class Lanes:
    """All cases of a fleet side by side, last axis."""

    def __init__(self, fleet: "Fleet") -> None:
        self.fleet = fleet
        self.n, self.limits = int(fleet.at[of.STATES]), int(fleet.at[of.LIMITS])
        self.program = fleet.over_cases
        self.inputs, self.roots = LaneInputs(fleet), LaneRoots(fleet)
        self.x = np.ascontiguousarray(fleet.v[:, of.X].T)
        self.size, self.growing = fleet.v[0, of.SIZE][:, np.newaxis], fleet.v[0, of.GROWING][:, np.newaxis]
        self.time = fleet.clock[:, of.TIME].copy()
        self.status = fleet.status.copy()
        self.stop = np.zeros(len(self.time), dtype=np.int64)
        self.margins = np.ascontiguousarray(fleet.margins[:, of.BEFORE].T)
        self.samples = LaneSamples(fleet, self.x, self.inputs.base)

    def results(self, t: Array, before: Any, x: Array, level: int, cases: Any = None) -> Array:
        """Results of some cases, or all, at instants and states, (results, cases), of levels up to one."""
        return self.program(x, self.inputs.at(t, before, slice(None) if cases is None else cases), level, cases)

    def sizes(self, x: Array) -> Array:
        """Sizes of the states that count as one, (n, cases)."""
        return np.asarray(self.size + self.growing * np.abs(x))

    def go_on(self, until: Array, pause: float, closed: Any) -> None:
        """Go on to instants [s], one for every case of the fleet, or past a pause."""
        pausing = np.minimum(until, pause)
        self.find_stops()
        active = (self.status == of.DONE) & (self.time < pausing)
        if not np.any(active):
            return
        f, margins = self.start(np.zeros_like(self.x), self.margins, active)
        begun = active | ((self.status == of.TERMINAL) & (self.time < pausing))
        try:
            self.sample(Step(self.time, 0.0 * self.time, self.x, self.x, f, f), self.time, begun, begun)
            f, margins = self.steps(until, pausing, closed, active & (self.status == of.DONE), f, margins)
        finally:
            # also of what is interrupted
            self.samples.evaluate()
            self.hand_back(margins)

    def steps(
        self, until: Array, pausing: Array, closed: Any, active: Any, f: Array, margins: Array
    ) -> tuple[Array, Array]:
        """Steps of all cases side by side until none is active; rates and margins at their ends."""
        while np.any(active):
            self.look(f, active)
            following = self.following()
            end = np.minimum(until, following)
            left = np.where(active, end - self.time, 0.0)
            parts = np.ceil(left / self.fleet.settings[of.LARGEST] * (1.0 - 1e-9))
            h = left / np.maximum(parts, 1.0)
            self.ended(active & (h * self.roots.root > STABLE_4), of.UNSTABLE, active)
            new, f_new, new_margins, error = self.step(h, f)
            wrong = size_of(error, self.sizes(self.x)) / self.fleet.settings[of.TOLERANCE]
            self.ended(active & ~np.isfinite(wrong), of.DIVERGED, active)
            self.ended(active & ~(wrong <= GUARD), of.INACCURATE, active)
            taken = Step(self.time, np.where(active, h, 0.0), self.x, np.where(active, new, self.x), f, f_new)
            now = np.where(active, np.where(h == left, end, self.time + h), self.time)
            reach = self.events(taken, margins, new_margins, active)
            cut = active & (reach <= 1.0)
            ended = np.where(cut, taken.t + reach * taken.h, now)
            self.sample(taken, ended, active, closed | (ended < until))
            self.x = np.where(cut, taken.at(np.where(cut, reach, 1.0)), taken.new)
            self.status[cut] = of.TERMINAL
            self.fleet.counts[active, of.RUNGE_KUTTA] += 1
            f, margins = np.where(active, f_new, f), np.where(active, new_margins, margins)
            joint, self.time = active & ~cut & (now == following) & (now < until), ended
            self.stop += joint
            active &= ~cut
            if np.any(joint) and not self.crowded(active):
                f, margins = self.start(f, margins, joint)
                active &= self.status == of.DONE
            active &= self.time < pausing
            self.crowded(active)
        return f, margins

    def observe(self) -> Array:
        """Outputs, inputs and states of all cases at their instants, (signals, cases)."""
        after = np.zeros(len(self.time), dtype=bool)
        found = self.results(self.time, after, self.x, 2)
        u = self.inputs.at(self.time, after, slice(None))
        return np.concatenate((found[self.n + self.limits :], u, self.x))

    def find_stops(self) -> None:
        """The stop that comes next in each case."""
        for c in range(len(self.time)):
            own = self.fleet.stops[self.fleet.stops_first[c] : self.fleet.stops_first[c + 1]]
            self.stop[c] = self.fleet.stops_first[c] + np.searchsorted(own, self.time[c], side="right")

    def following(self) -> Array:
        """The instant [s] of the next stop of each case."""
        there = self.stop < self.fleet.stops_first[1:]
        padded = np.append(self.fleet.stops, np.inf)
        return np.where(there, padded[np.minimum(self.stop, len(self.fleet.stops))], np.inf)

    def start(self, f: Array, margins: Array, starting: Any) -> tuple[Array, Array]:
        """Rates and margins, new in cases that start from where they are; limits that are crossed there."""
        cases = np.flatnonzero(starting)
        t, x, f, new = self.time[cases], self.x[:, cases], f.copy(), margins.copy()
        found = self.results(t, np.zeros(len(cases), dtype=bool), x, 1, cases)
        f[:, cases], new[:, cases] = found[: self.n], found[self.n :]
        limit, lane = np.nonzero((margins < 0.0) != (new < 0.0))
        for k in np.lexsort((limit, lane)):
            reached = bool(new[limit[k], lane[k]] < 0.0)
            self.note(lane[k], self.time[lane[k]], limit[k], reached, self.x[:, lane[k]])
            if reached and self.fleet.terminal[limit[k]]:
                self.status[lane[k]] = of.TERMINAL
        return f, new

    def note(self, lane: int, t: float, limit: int, reached: bool, x: Array) -> None:
        """Write an event down; there is room for those of many steps, and one case that has none left is wrong."""
        room, event = self.fleet.room[lane], self.fleet.counts[lane, of.EVENTS]
        room[event, : of.EVENT_STATE] = t, limit, reached
        room[event, of.EVENT_STATE :] = x
        self.fleet.counts[lane, of.EVENTS] += 1

    def look(self, f: Array, active: Any) -> None:
        """Look for the fastest roots again where it is time."""
        ahead = min(self.fleet.settings[of.LARGEST], LOOK)
        due = np.flatnonzero(active & (self.time + ahead > self.roots.looked + LOOK))
        if not due.size:
            return
        t, x, before = self.time[due], self.x[:, due], np.zeros(len(due), dtype=bool)
        self.roots.look(due, t, x, f[:, due], self.sizes(x), lambda x: self.results(t, before, x, 0, due))

    def step(self, h: Array, f: Array) -> tuple[Array, Array, Array, Array]:
        """State, rates, margins at the end of a step, and its error, as `eom.simulation.steps.runge_kutta`."""
        before, n = np.ones(len(h), dtype=bool), self.n
        midway = self.inputs.at(self.time + 0.5 * h, before, slice(None))
        half = self.program(self.x + 0.5 * h * f, midway, 0)
        again = self.program(self.x + 0.5 * h * half, midway, 0)
        ending = self.inputs.at(self.time + h, before, slice(None))
        full = self.program(self.x + h * again, ending, 0)
        new = self.x + h / 6.0 * (f + 2.0 * (half + again) + full)
        found = self.program(new, ending, 1)
        return new, found[:n], found[n:], h / 6.0 * (full - found[:n])

    def ended(self, cases: Any, status: int, active: Any) -> None:
        """End some cases."""
        self.status[cases] = status
        active &= ~cases

    def crowded(self, active: Any) -> bool:
        """Whether a case has no room left for its next events; then all end, and go on when there is more."""
        crowded = bool(np.any(self.fleet.counts[:, of.EVENTS] + self.limits > self.fleet.room.shape[1]))
        if crowded:
            self.ended(active.copy(), of.FULL, active)
        return crowded

    def events(self, step: Step, margins: Array, new: Array, active: Any) -> Array:
        """Note the limits that are crossed in a step; the share of it after which each case ends, 2 if it does not."""
        reach = np.full(len(self.time), 2.0)
        limit, lane = np.nonzero(((margins < 0.0) != (new < 0.0)) & active)
        if not limit.size:
            return reach
        crossed = step.of(lane)

        def margins_at(share: Array) -> Array:
            """Of each crossing its own."""
            before = np.ones(len(limit), dtype=bool)
            found = self.results(crossed.t + share * crossed.h, before, crossed.at(share), 1, lane)
            return np.asarray(found[self.n + limit, np.arange(len(limit))])

        share = crossings(margins_at, margins[limit, lane], new[limit, lane])
        reached = new[limit, lane] < 0.0
        ending = self.fleet.terminal[limit] & reached
        np.minimum.at(reach, lane[ending], share[ending])
        states = crossed.at(share)
        for k in np.lexsort((limit, lane)):
            if share[k] <= min(reach[lane[k]], 1.0):
                at = step.t[lane[k]] + share[k] * step.h[lane[k]]
                self.note(lane[k], at, limit[k], bool(reached[k]), states[:, k])
        return reach

    def sample(self, step: Step, end: Array, active: Any, closed: Any) -> None:
        """Fill in the samples that are due until the instants to which the cases get, those at *closed* ones too."""
        fleet, counts = self.fleet, self.fleet.counts
        padded = np.append(fleet.times, np.inf)
        while True:
            instants = padded[np.minimum(counts[:, of.SAMPLES], len(fleet.times))]
            due = np.flatnonzero(active & ((instants < end) | ((instants == end) & closed)))
            if not due.size:
                return
            t, own = instants[due], step.of(due)
            x = np.where(own.h > 0.0, own.at((t - own.t) / np.where(own.h > 0.0, own.h, 1.0)), own.x)
            self.samples.add(due, x, self.inputs.at(t, np.zeros(len(due), dtype=bool), due))

    def hand_back(self, margins: Array) -> None:
        """Leave everything where the next time finds it."""
        fleet = self.fleet
        fleet.v[:, of.X], fleet.clock[:, of.TIME] = self.x.T, self.time
        fleet.status[:], fleet.margins[:, of.BEFORE] = self.status, margins.T
        self.inputs.hand_back(fleet)
        self.roots.hand_back(fleet)
