"""What an accepted step leaves: states between its ends, events where limits are crossed, samples."""

from typing import Any

import numpy as np

from eom.simulate.memory import (
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
    RESULTS,
    RIGHT,
    SAMPLES,
    STATES,
    TERMINAL,
    TIME,
    U,
    X,
)
from eom.simulate.pieces import fill_inputs
from eom.simulate.steps import evaluate

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
    """Go on to the end of a step, or to where a limit in it ends the run; says which."""
    t, n, m, reach, status = clock[TIME], at[STATES], at[LIMITS], 1.0, DONE
    crossed = False
    for i in range(m):
        margins[1, i] = work[at[RESULTS] + n + i]
        crossed = crossed or (margins[0, i] < 0.0) != (margins[1, i] < 0.0)
    if crossed:
        for i in range(m):
            if (margins[0, i] < 0.0) == (margins[1, i] < 0.0):
                continue
            share = crossing(program, i, t, h, last, margins, at, v, work, pieces, signals)
            if terminal[i] and margins[1, i] < 0.0 and share < reach:
                reach, status = share, TERMINAL
            event = counts[EVENTS]
            if event == len(events):
                status = FULL if status == DONE else status
                continue
            events[event, EVENT_TIME], events[event, EVENT_LIMIT] = t + share * h, i
            events[event, EVENT_REACHED] = 1.0 if margins[1, i] < 0.0 else 0.0
            for j in range(n):
                events[event, EVENT_STATE + j] = v[RIGHT, j]
            counts[EVENTS] = event + 1
    end = now if reach == 1.0 else t + reach * h
    take_samples(program, h, end, last, clock, counts, times, columns, rows, at, v, work, pieces, signals)
    if reach < 1.0:
        between(reach, h, last, v)
    for i in range(n):
        v[X, i] = v[RIGHT, i] if reach < 1.0 else v[NEW, i]
        v[K0, i] = v[last, i]
    for i in range(m):
        margins[0, i] = margins[1, i]
    clock[TIME] = end
    return status


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
    """The share of a step at which a margin is zero, by false position with Illinois' weights; sets the state there."""
    lower, upper, left, right = 0.0, 1.0, margins[0, i], margins[1, i]
    for _ in range(60):
        if upper - lower <= LOCATED:
            break
        share = lower + (upper - lower) * left / (left - right)
        share = min(max(share, lower + 0.25 * LOCATED), upper - 0.25 * LOCATED)
        between(share, h, last, v)
        fill_inputs(t + share * h, True, at, work, pieces, signals)
        evaluate(program, at, v, RIGHT, work, 1)
        found = work[at[RESULTS] + at[STATES] + i]
        if (found < 0.0) == (margins[1, i] < 0.0):
            upper, right, left = share, found, 0.5 * left
        else:
            lower, left, right = share, found, 0.5 * right
        if found == 0.0:
            break
    between(upper, h, last, v)
    return upper


def take_samples(
    program: Any,
    h: float,
    end: float,
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
    """Fill in the samples that are due until the end of a step.

    *columns* say what of states, inputs and outputs, one after the other, is kept.
    """
    n, inputs = at[STATES], at[INPUTS]
    while counts[SAMPLES] < len(times) and times[counts[SAMPLES]] <= end:
        sample = counts[SAMPLES]
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
