"""What an accepted step leaves: states between its ends, events where limits are crossed, samples."""

from typing import Any

import numpy as np

from eom.simulation.memory import (
    BEFORE,
    DONE,
    EVENT_LIMIT,
    EVENT_REACHED,
    EVENT_STATE,
    EVENT_TIME,
    EVENTS,
    FULL,
    INPUTS,
    K0,
    K6,
    LIMITS,
    NEW,
    NOW,
    RESULTS,
    RIGHT,
    SAMPLES,
    SHARE,
    STATES,
    TERMINAL,
    TIME,
    U,
    X,
)
from eom.simulation.pieces import fill_inputs
from eom.simulation.steps import evaluate

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
LOCATED = 1e-10
"""Share of a step to which an event is found."""


def between(share: float, h: float, last: int, v: Any) -> None:
    """Set row RIGHT to the state at a share of a step.

    By states and rates at its ends, the latter in row *last*: cubic, or of order four for Dormand and Prince's.
    """
    rest = 1.0 - share
    for i in range(v.shape[1]):
        change = v[NEW, i] - v[X, i]
        bent = h * v[K0, i] - change
        twisted = change - h * v[last, i] - bent
        if last == K6:
            more = 0.0
            for j in range(len(DENSE)):
                more += DENSE[j] * v[K0 + j, i]
            twisted += rest * h * more
        v[RIGHT, i] = v[X, i] + share * (change + rest * (bent + share * twisted))


def accept(
    program: Any,
    h: float,
    now: float,
    closed: bool,
    last: int,
    clock: Any,
    counts: Any,
    margins: Any,
    times: Any,
    columns: Any,
    rows: Any,
    events: Any,
    terminal: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> int:
    """Go on to the end of a step, or to where a limit in it ends the run; says which.

    If there is no room for its events nothing is done. Samples at the end are taken if the step is *closed*.
    """
    t, n, m, reach, crossed = clock[TIME], at[STATES], at[LIMITS], 2.0, 0
    for i in range(m):
        margins[NOW, i] = work[at[RESULTS] + n + i]
        crossed += (margins[BEFORE, i] < 0.0) != (margins[NOW, i] < 0.0)
    if counts[EVENTS] + crossed > len(events):
        return FULL
    if crossed:
        for i in range(m):
            margins[SHARE, i] = 2.0
            if (margins[BEFORE, i] < 0.0) != (margins[NOW, i] < 0.0):
                margins[SHARE, i] = crossing(program, i, t, h, last, margins, at, v, work, pieces, signals)
                if terminal[i] and margins[NOW, i] < 0.0:
                    reach = min(reach, margins[SHARE, i])
        for i in range(m):
            if margins[SHARE, i] <= min(reach, 1.0):
                between(margins[SHARE, i], h, last, v)
                note(i, t + margins[SHARE, i] * h, margins[NOW, i] < 0.0, RIGHT, counts, events, v)
    end = now if reach > 1.0 else t + reach * h
    take_samples(
        program, h, end, closed or end < now, last, clock, counts, times, columns, rows, at, v, work, pieces, signals
    )
    if reach <= 1.0:
        between(reach, h, last, v)
    for i in range(n):
        v[X, i] = v[RIGHT, i] if reach <= 1.0 else v[NEW, i]
        v[K0, i] = v[last, i]
    for i in range(m):
        margins[BEFORE, i] = margins[NOW, i]
    clock[TIME] = end
    return TERMINAL if reach <= 1.0 else DONE


def note(i: int, t: float, reached: bool, row: int, counts: Any, events: Any, v: Any) -> None:
    """Write an event down, with the state in a row."""
    event = counts[EVENTS]
    events[event, EVENT_TIME], events[event, EVENT_LIMIT], events[event, EVENT_REACHED] = t, i, 1.0 if reached else 0.0
    for j in range(v.shape[1]):
        events[event, EVENT_STATE + j] = v[row, j]
    counts[EVENTS] = event + 1


def crossing(
    program: Any,
    i: int,
    t: float,
    h: float,
    last: int,
    margins: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> float:
    """The share of a step at which a margin changes its sign, by false position with Illinois' weights."""
    lower, upper, left, right = 0.0, 1.0, margins[BEFORE, i], margins[NOW, i]
    halve = False
    while upper - lower > LOCATED:
        width = upper - lower
        share = lower + 0.5 * width
        if not halve:
            share = min(max(lower + width * left / (left - right), lower + 0.25 * LOCATED), upper - 0.25 * LOCATED)
        between(share, h, last, v)
        fill_inputs(t + share * h, True, at, work, pieces, signals)
        evaluate(program, at, v, RIGHT, work, 1)
        found = work[at[RESULTS] + at[STATES] + i]
        if (found < 0.0) == (margins[NOW, i] < 0.0):
            upper, right, left = share, found, 0.5 * left
        else:
            lower, left, right = share, found, 0.5 * right
        # where the line misleads, halves do not
        halve = upper - lower > 0.5 * width
    return upper


def take_samples(
    program: Any,
    h: float,
    end: float,
    closed: bool,
    last: int,
    clock: Any,
    counts: Any,
    times: Any,
    columns: Any,
    rows: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> None:
    """Fill in the samples that are due until the end of a step, those at a *closed* end included.

    *columns* say what of states, inputs and outputs, one after the other, is kept.
    """
    n, inputs = at[STATES], at[INPUTS]
    while counts[SAMPLES] < len(times):
        sample = counts[SAMPLES]
        if times[sample] > end or (times[sample] == end and not closed):
            return
        instant = times[sample]
        if h > 0.0:
            between((instant - clock[TIME]) / h, h, last, v)
        else:
            for i in range(n):
                v[RIGHT, i] = v[X, i]
        fill_inputs(instant, False, at, work, pieces, signals)
        evaluate(program, at, v, RIGHT, work, 2)
        for k in range(len(columns)):
            column = columns[k]
            if column < n:
                rows[sample, k] = v[RIGHT, column]
            elif column < n + inputs:
                rows[sample, k] = work[at[U] + column - n]
            else:
                rows[sample, k] = work[at[RESULTS] + at[LIMITS] + column - inputs]
        counts[SAMPLES] = sample + 1


def look(program: Any, t: float, at: Any, v: Any, work: Any, pieces: Any, signals: Any) -> None:
    """Set inputs and outputs to those of the state at an instant, after what jumps there."""
    fill_inputs(t, False, at, work, pieces, signals)
    evaluate(program, at, v, X, work, 2)
