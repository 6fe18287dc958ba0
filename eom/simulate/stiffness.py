"""How fast a model's roots are, and the derivatives that implicit steps need."""

from typing import Any

import numpy as np

from eom.simulate.carried import Clock, Implicit, Settings, size_of
from eom.simulate.steps import Problem, factor, rates_into

NUDGE = 1e-7
"""Relative step of differences."""
FIRST, AGAIN = 12, 2
"""Iterations towards the fastest root when nothing is known of it, and later on."""
KEPT = 6
"""Steps for which a Jacobian is kept; the method's order does not depend on it, its error does."""


def fastest(t: float, clock: Clock, settings: Settings, p: Problem, f: Any) -> float:
    """Magnitude [1/s] of the fastest root at the state, by iteration along the direction in which rates change most.

    Rates are those of the right side itself, B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88
    (1998) 315-326, section 3. It tends to be too large while the direction still turns.
    """
    x, direction, rate = clock.x, clock.direction, 0.0
    for _ in range(FIRST if clock.time[2] == 0.0 else AGAIN):
        length = size_of(direction, x, settings)
        step = NUDGE / length
        rates_into(f, t, False, x + step * direction, 0, p)
        f -= clock.k[0]
        rate = size_of(f, x, settings) / NUDGE
        if rate > 0.0 and np.isfinite(rate):
            direction[:] = f / rate
    return rate


def prepared(n: int) -> Implicit:
    """Memory for implicit steps of n states."""
    return Implicit(
        np.zeros((n, n)),
        np.zeros((n, n)),
        np.zeros(n, dtype=np.int64),
        np.zeros(n),
        np.zeros((4, n)),
        np.zeros(n),
        np.zeros(3),
    )


def differentiate(t: float, h: float, clock: Clock, implicit: Implicit, settings: Settings, p: Problem) -> None:
    """Set the Jacobian at the state by differences."""
    x, f = clock.x, implicit.right
    for j in range(len(x)):
        kept = x[j]
        x[j] = kept + NUDGE * (settings.size[j] + settings.growing[j] * abs(kept))
        step = x[j] - kept
        rates_into(f, t, False, x, 0, p)
        x[j] = kept
        implicit.jacobian[:, j] = (f - clock.k[0]) / step
    implicit.age[0], implicit.age[1], implicit.age[2] = 0.0, 0.0, 1.0


def refresh(t: float, h: float, gamma: float, clock: Clock, implicit: Implicit, settings: Settings, p: Problem) -> None:
    """Make Jacobian, drift and factors ready for a step."""
    age = implicit.age
    if age[2] == 0.0 or age[1] >= KEPT:
        differentiate(t, h, clock, implicit, settings, p)
    # inputs that change within the step
    rates_into(implicit.right, t + NUDGE * h, True, clock.x, 0, p)
    implicit.drift[:] = (implicit.right - clock.k[0]) / (NUDGE * h)
    if age[0] != h:
        implicit.factors[:] = -implicit.jacobian
        for j in range(len(clock.x)):
            implicit.factors[j, j] += 1.0 / (h * gamma)
        factor(implicit.factors, implicit.pivots)
        age[0] = h
    age[1] += 1.0
