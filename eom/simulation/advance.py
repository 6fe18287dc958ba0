"""A run from one instant to another, in loops for a compiler."""

from typing import Any

import numpy as np

from eom.simulation.accepted import accept, look, note, take_samples
from eom.simulation.memory import (
    AGE,
    AUTOMATIC,
    BEFORE,
    COLLAPSED,
    DIVERGED,
    DONE,
    DORMAND_PRINCE,
    ERROR,
    EVENTS,
    FACTORED,
    FULL,
    INACCURATE,
    K0,
    LARGEST,
    LIMITS,
    LOOKED,
    METHOD,
    METHOD_NOW,
    REJECTED,
    RESULTS,
    ROOT,
    ROSENBROCK,
    RUNGE_KUTTA,
    STATES,
    STEP,
    TERMINAL,
    TIME,
    TOLERANCE,
    UNSTABLE,
    X,
)
from eom.simulation.step_choice import SMALLEST, STABLE_4, chosen_method, chosen_step, following_step, smaller
from eom.simulation.steps import dormand_prince, rates, rosenbrock, runge_kutta
from eom.simulation.stiffness import differentiate, drift, factorise, fastest, size_of

LOOK = 0.05
"""Time [s] after which the fastest root is looked for again, at the latest."""
GUARD = 1e4
"""A fixed step may make this many times the error that the other methods are allowed."""
EXACTING = 10.0
"""By what the error of an implicit step counts more: over a run it adds up to more than that of an explicit one."""
KEPT = 20
"""Steps for which a Jacobian is kept: the method's order does not depend on it, its error does."""


def advance(
    looking: bool,
    program: Any,
    until: float,
    pause: float,
    closed: bool,
    settings: Any,
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
    stops: Any,
    jacobian: Any,
    factors: Any,
    pivots: Any,
) -> int:
    """Go on until an instant [s], or until something ends the run; says which, see `eom.simulation.memory`.

    After the step that reaches *pause* [s] it stops, to be called again; the steps are the same with any pause. A
    sample at its end is taken if that is *closed*; else it is left for the next time, when inputs may have changed.

    Just *looking* it goes nowhere, but sets inputs and outputs to those at the instant.

    *times* are instants of samples, whose *columns* are kept in *rows*. Steps end at *stops* [s], where an input or
    its slope jumps.
    """
    if looking:
        look(program, clock[TIME], at, v, work, pieces, signals)
        return DONE
    stop = 0
    while stop < len(stops) and stops[stop] <= clock[TIME]:
        stop += 1
    status = start(program, clock, counts, margins, events, terminal, at, v, work, pieces, signals)
    if status == FULL:
        return status
    begun = closed or clock[TIME] < until
    take_samples(program, 0.0, clock[TIME], begun, 0, clock, counts, times, columns, rows, at, v, work, pieces, signals)
    if status != DONE:
        return status
    method = int(clock[METHOD_NOW] if settings[METHOD] == AUTOMATIC else settings[METHOD])
    while clock[TIME] < min(until, pause):
        t = clock[TIME]
        ahead = settings[LARGEST] if settings[METHOD] == RUNGE_KUTTA else clock[STEP]
        if t + min(ahead, LOOK) > clock[LOOKED] + LOOK:
            clock[ROOT], clock[LOOKED] = fastest(program, t, clock, at, v, work, pieces, signals), t
        if settings[METHOD] == AUTOMATIC:
            method = chosen_method(method, clock[ROOT])
            clock[AGE] = clock[AGE] if clock[METHOD_NOW] == method else KEPT
            clock[METHOD_NOW] = method
        end = min(until, stops[stop]) if stop < len(stops) else until
        h = chosen_step(end - t, method, clock, settings)
        if method == RUNGE_KUTTA:
            if h * clock[ROOT] > STABLE_4:
                return UNSTABLE
            last = runge_kutta(program, t, h, at, v, work, pieces, signals)
        elif method == DORMAND_PRINCE:
            last = dormand_prince(program, t, h, at, v, work, pieces, signals)
        else:
            if clock[AGE] >= KEPT:
                differentiate(program, t, jacobian, at, v, work, pieces, signals)
                clock[AGE] = clock[FACTORED] = 0.0
            if clock[FACTORED] != h:
                factorise(h, jacobian, factors, pivots)
                clock[FACTORED] = h
            drift(program, t, h, at, v, work, pieces, signals)
            last = rosenbrock(program, t, h, jacobian, factors, pivots, at, v, work, pieces, signals)
            clock[AGE] += 1.0
        wrong = size_of(ERROR, v) / settings[TOLERANCE] * (EXACTING if method == ROSENBROCK else 1.0)
        if not wrong <= (GUARD if method == RUNGE_KUTTA else 1.0):
            if method == RUNGE_KUTTA:
                return INACCURATE if np.isfinite(wrong) else DIVERGED
            counts[REJECTED] += 1
            clock[STEP] = h * smaller(wrong, method)
            clock[AGE] = KEPT if clock[AGE] > 1.0 else 0.0
            if clock[STEP] < SMALLEST:
                return COLLAPSED if np.isfinite(wrong) else DIVERGED
            continue
        now = end if h == end - t else t + h
        status = accept(
            program,
            h,
            now,
            closed or now < until,
            last,
            clock,
            counts,
            margins,
            times,
            columns,
            rows,
            events,
            terminal,
            at,
            v,
            work,
            pieces,
            signals,
        )
        if status == FULL:
            return status
        counts[method] += 1
        if status != DONE:
            return status
        clock[STEP] = following_step(h, wrong, method, clock[STEP])
        if now == end and end < until:
            stop += 1
            clock[AGE] = KEPT
            status = start(program, clock, counts, margins, events, terminal, at, v, work, pieces, signals)
            if status != DONE:
                return status
    return DONE


def start(
    program: Any,
    clock: Any,
    counts: Any,
    margins: Any,
    events: Any,
    terminal: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
) -> int:
    """Rates and margins from which to go on; limits that are crossed by a jump of the inputs, or from the beginning."""
    rates(program, clock[TIME], False, X, 1, K0, at, v, work, pieces, signals)
    status = DONE
    if counts[EVENTS] + at[LIMITS] > len(events):
        return FULL
    for i in range(at[LIMITS]):
        now = work[at[RESULTS] + at[STATES] + i]
        if (now < 0.0) != (margins[BEFORE, i] < 0.0):
            note(i, clock[TIME], now < 0.0, X, counts, events, v)
            if terminal[i] and now < 0.0:
                status = TERMINAL
        margins[BEFORE, i] = now
    return status
