"""What an accepted step leaves: states between its ends, events where limits are crossed, samples."""

from typing import Any

import numpy as np

from eom.simulate.carried import DONE, EVENTS, FULL, SAMPLES, TERMINAL, Clock, Record
from eom.simulate.pieces import fill_inputs
from eom.simulate.steps import Problem, evaluate

# E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 1993, section II.6 and code DOPRI5
DENSE = np.array(
    [
        -12715105075.0 / 11282082432.0,
        0.0,
        87487479700.0 / 32700410799.0,
        -10690763975.0 / 1880347072.0,
        701980252875.0 / 199316789632.0,
        -1453857185.0 / 822651844.0,
        69997945.0 / 29380423.0,
    ]
)
LAST = 6
"""Row of the rates at the end of a step of Dormand and Prince's."""
EXACT = 1e-10
"""Share of a step to which an event is located."""


def between(share: float, h: float, x: Any, new: Any, k: Any, last: int, result: Any) -> None:
    """The state at a share of a step: cubic by states and rates at its ends, of order four for Dormand and Prince's."""
    rest = 1.0 - share
    for i in range(len(x)):
        change = new[i] - x[i]
        bent = h * k[0, i] - change
        twisted = change - h * k[last, i] - bent
        if last == LAST:
            more = 0.0
            for j in range(LAST + 1):
                more += DENSE[j] * k[j, i]
            twisted += rest * h * more
        result[i] = x[i] + share * (change + rest * (bent + share * twisted))


def accept(t: float, h: float, now: float, new: Any, last: int, clock: Clock, record: Record, p: Problem) -> int:
    """Go on to the end of a step, or to where a limit in it ends the run; says which."""
    n, m = len(clock.x), len(clock.margins)
    margins, at, status = p.results[n : n + m].copy(), np.empty(n), DONE
    reach = 1.0
    for i in range(m):
        if (margins[i] < 0.0) != (clock.margins[i] < 0.0):
            share = crossing(i, t, h, new, last, margins[i], at, clock, p)
            if record.terminal[i] and margins[i] < 0.0 and share < reach:
                reach, status = share, TERMINAL
            if clock.counts[EVENTS] == len(record.event_times):
                # there is none that ends the run without room for it: the caller makes some before every call
                status = FULL if status == DONE else status
                continue
            event = clock.counts[EVENTS]
            record.event_times[event] = t + share * h
            record.event_states[event] = at
            record.events[event, 0], record.events[event, 1] = i, int(margins[i] < 0.0)
            clock.counts[EVENTS] += 1
    end = now if reach == 1.0 else t + reach * h
    take_samples(t, h, end, new, last, at, clock, record, p)
    if reach < 1.0:
        between(reach, h, clock.x, new, clock.k, last, at)
        clock.x[:] = at
    else:
        clock.x[:] = new
        clock.k[0] = clock.k[last]
    clock.time[0] = end
    clock.margins[:] = margins
    return status


def crossing(
    i: int, t: float, h: float, new: Any, last: int, margin: float, at: Any, clock: Clock, p: Problem
) -> float:
    """The share of a step at which a margin is zero, by false position with Illinois' weights; sets the state there."""
    n, lower, upper = len(clock.x), 0.0, 1.0
    below, above, share = clock.margins[i], margin, 1.0
    for _ in range(60):
        if upper - lower <= EXACT:
            break
        share = lower + (upper - lower) * below / (below - above) if below != above else 0.5 * (lower + upper)
        share = min(max(share, lower + 0.25 * EXACT), upper - 0.25 * EXACT)
        between(share, h, clock.x, new, clock.k, last, at)
        fill_inputs(t + share * h, True, p.pieces, p.cursor, p.u)
        evaluate(p.program, at, p.u, p.parameters, p.scratch, p.results, 1)
        found = p.results[n + i]
        if (found < 0.0) == (margin < 0.0):
            upper, above, below = share, found, 0.5 * below
        else:
            lower, below, above = share, found, 0.5 * above
        if found == 0.0:
            break
    between(upper, h, clock.x, new, clock.k, last, at)
    return upper


def take_samples(
    t: float, h: float, end: float, new: Any, last: int, at: Any, clock: Clock, record: Record, p: Problem
) -> None:
    """Fill in the samples that are due until the end of a step, from (t, clock.x) on."""
    n, m = len(clock.x), len(clock.margins)
    while clock.counts[SAMPLES] < len(record.times) and record.times[clock.counts[SAMPLES]] <= end:
        sample = clock.counts[SAMPLES]
        instant = record.times[sample]
        if instant == end and h == 0.0:
            at[:] = clock.x
        else:
            between((instant - t) / h, h, clock.x, new, clock.k, last, at)
        fill_inputs(instant, False, p.pieces, p.cursor, p.u)
        evaluate(p.program, at, p.u, p.parameters, p.scratch, p.results, 2)
        record.states[sample], record.inputs[sample] = at, p.u
        record.outputs[sample] = p.results[n + m :]
        clock.counts[SAMPLES] += 1
