"""A run from one instant to another, for a compiler, and for Python without one."""

from typing import Any

import numpy as np

from eom.simulate.accepted import accept, take_samples
from eom.simulate.carried import (
    AUTOMATIC,
    COLLAPSED,
    DIVERGED,
    DONE,
    DORMAND_PRINCE,
    INACCURATE,
    ROSENBROCK,
    RUNGE_KUTTA,
    STEPS_REJECTED,
    UNSTABLE,
    Clock,
    Implicit,
    Record,
    Settings,
    size_of,
)
from eom.simulate.pieces import fill_inputs
from eom.simulate.steps import GAMMA, Problem, dormand_prince, evaluate, rosenbrock, runge_kutta
from eom.simulate.stiffness import fastest, prepared, refresh

STABLE = 2.5
"""Largest product of step and fastest root; both explicit methods are stable a little beyond."""
STIFF, CALM = 600.0, 400.0
"""Fastest roots [1/s] from which on the implicit method takes over, and below which the explicit one does again."""
LOOK = 0.02
"""Time [s] after which the fastest root is looked for again, at the latest."""
SMALLEST = 1e-9
"""A step [s] that is smaller follows no motion of a vehicle."""
GUARD = 1e4
"""A fixed step may make this many times the error that the other methods are allowed."""
SAFETY, SHRINK, GROW = 0.9, 0.2, 5.0
ORDER_5, ORDER_3 = 1.0 / 5.0, 1.0 / 3.0


def start(clock: Clock, p: Problem) -> None:
    """Rates and margins at the instant from which to go on."""
    n = len(clock.x)
    fill_inputs(clock.time[0], False, p.pieces, p.cursor, p.u)
    evaluate(p.program, clock.x, p.u, p.parameters, p.scratch, p.results, 1)
    clock.k[0] = p.results[:n]
    clock.margins[:] = p.results[n : n + len(clock.margins)]


def advance(until: float, clock: Clock, record: Record, settings: Settings, p: Problem) -> int:
    """Go on until an instant [s], or until something ends the run; says which by the constants of `carried`."""
    new, error, spare = np.empty_like(clock.x), np.empty_like(clock.x), np.empty_like(clock.x)
    implicit, stops = prepared(len(clock.x)), p.pieces.stops
    stop = np.searchsorted(stops, clock.time[0], side="right")
    start(clock, p)
    take_samples(clock.time[0], 0.0, clock.time[0], new, 0, spare, clock, record, p)
    method = DORMAND_PRINCE if settings.method == AUTOMATIC else settings.method
    while clock.time[0] < until:
        t = clock.time[0]
        if clock.time[2] == 0.0 or t >= clock.time[3] + LOOK or t + clock.time[1] > clock.time[3] + LOOK:
            clock.time[2], clock.time[3] = fastest(t, clock, settings, p, spare), t
        if settings.method == AUTOMATIC:
            method = chosen_method(method, clock.time[2])
        end = min(until, stops[stop]) if stop < len(stops) else until
        h = chosen_step(end - t, method, clock, settings)
        if method == RUNGE_KUTTA and h * clock.time[2] > STABLE:
            return UNSTABLE
        last = step(method, t, h, new, error, clock, implicit, settings, p)
        wrong = size_of(error, clock.x, settings) / settings.tolerance
        if not wrong <= (GUARD if method == RUNGE_KUTTA else 1.0):
            if method == RUNGE_KUTTA:
                return INACCURATE if np.isfinite(wrong) else DIVERGED
            clock.counts[STEPS_REJECTED] += 1
            clock.time[1] = h * smaller(wrong, method)
            implicit.age[1] = np.inf if implicit.age[1] > 1.0 else 0.0
            if clock.time[1] < SMALLEST:
                return COLLAPSED if np.isfinite(wrong) else DIVERGED
            continue
        clock.counts[method] += 1
        now = end if h == end - t else t + h
        status = accept(t, h, now, new, last, clock, record, p)
        if status != DONE:
            return status
        whole = h >= clock.time[1] * (1.0 - 1e-9)
        clock.time[1] = h * larger(wrong, method) if whole else max(h * larger(wrong, method), clock.time[1])
        if now == end and end < until:
            stop += 1
            implicit.age[2] = 0.0
            start(clock, p)
    return DONE


def chosen_method(method: int, root: float) -> int:
    """The adaptive method for a fastest root; it changes only when another one is clearly cheaper."""
    if method == DORMAND_PRINCE and root > STIFF:
        return ROSENBROCK
    if method == ROSENBROCK and root < CALM:
        return DORMAND_PRINCE
    return method


def chosen_step(left: float, method: int, clock: Clock, settings: Settings) -> float:
    """The next step, in equal parts of what is left if that are few."""
    h = settings.step
    if method != RUNGE_KUTTA:
        h = min(h, clock.time[1])
    if method == DORMAND_PRINCE:
        h = min(h, STABLE / max(clock.time[2], 1e-9))
    parts = np.ceil(left / h * (1.0 - 1e-9))
    return float(left / max(parts, 1.0)) if method == RUNGE_KUTTA or parts <= 2.0 else h


def smaller(wrong: float, method: int) -> float:
    """By what to shorten a step of too large an error."""
    if not np.isfinite(wrong):
        return 0.1
    return max(SHRINK, SAFETY * wrong ** -(ORDER_5 if method == DORMAND_PRINCE else ORDER_3))


def larger(wrong: float, method: int) -> float:
    """What step comes next, over the last one."""
    return min(GROW, SAFETY * max(wrong, 1e-6) ** -(ORDER_5 if method == DORMAND_PRINCE else ORDER_3))


def step(
    method: int,
    t: float,
    h: float,
    new: Any,
    error: Any,
    clock: Clock,
    implicit: Implicit,
    settings: Settings,
    p: Problem,
) -> int:
    """One step by a method; the row of the rates at its end."""
    if method == RUNGE_KUTTA:
        runge_kutta(t, h, clock.x, clock.k, new, error, p)
        return 4
    if method == DORMAND_PRINCE:
        dormand_prince(t, h, clock.x, clock.k, new, error, p)
        return 6
    refresh(t, h, GAMMA, clock, implicit, settings, p)
    rosenbrock(t, h, clock.x, clock.k, new, error, implicit, p)
    return 4
