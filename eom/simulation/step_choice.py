"""Which method and what step come next, in loops for a compiler."""

from typing import Any

import numpy as np

from eom.simulation.memory import DORMAND_PRINCE, LARGEST, ROOT, ROSENBROCK, RUNGE_KUTTA, STEP

STABLE_4, STABLE_5 = 2.5, 3.1
"""Largest product of step and fastest root; the classical method is stable up to 2.78, Dormand and Prince's to 3.31."""
STIFF, CALM = 600.0, 400.0
"""Fastest roots [1/s] from which on the implicit method takes over, and below which the explicit one does again."""
SMALLEST = 1e-9
"""A step [s] that is smaller follows no motion of a vehicle."""
SAFETY, SHRINK, GROW, SAME = 0.9, 0.2, 5.0, 1.2


def chosen_method(method: int, root: float) -> int:
    """The adaptive method for a fastest root; it changes only when another one is clearly cheaper."""
    if method == DORMAND_PRINCE and root > STIFF:
        return ROSENBROCK
    if method == ROSENBROCK and root < CALM:
        return DORMAND_PRINCE
    return method


def chosen_step(left: float, method: int, clock: Any, settings: Any) -> float:
    """The next step, in equal parts of what is left if that are few."""
    h = settings[LARGEST]
    if method != RUNGE_KUTTA:
        h = min(h, clock[STEP])
    if method == DORMAND_PRINCE:
        h = min(h, STABLE_5 / max(clock[ROOT], SMALLEST))
    parts = np.ceil(left / h * (1.0 - 1e-9))
    return float(left / max(parts, 1.0)) if method == RUNGE_KUTTA or parts <= 2.0 else h


def power(method: int) -> float:
    """How the step follows from the error."""
    return 1.0 / 5.0 if method == DORMAND_PRINCE else 1.0 / 3.0


def smaller(wrong: float, method: int) -> float:
    """By what to shorten a step of too large an error."""
    return max(SHRINK, SAFETY * wrong ** -power(method)) if np.isfinite(wrong) else 0.1


def following_step(h: float, wrong: float, method: int, planned: float) -> float:
    """What step comes next; one that was cut short says little."""
    factor = min(GROW, SAFETY * max(wrong, 1e-6) ** -power(method))
    if method == ROSENBROCK and 1.0 <= factor < SAME:
        factor = 1.0
    return float(h * factor if h >= planned * (1.0 - 1e-9) else max(h * factor, planned))
