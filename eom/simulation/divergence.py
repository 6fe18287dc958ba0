"""Which state leaves all bounds first where a motion cannot be followed."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.program.make import Ready
from eom.simulation import memory as of
from eom.simulation.channels import Event, owner_and_quantity
from eom.simulation.descriptions import described
from eom.simulation.pieces import fill_inputs

DIVERGING = (of.DIVERGED, of.COLLAPSED)
"""Ends of runs whose motion nothing follows."""


def divergence(
    ready: Ready, states: Sequence[str], t: float, at: Any, v: Array, work: Array, pieces: Array, signals: Any
) -> Event:
    """The event at an instant; memory as in `eom.simulation.memory`, of which nothing is changed.

    It is told of the state that changes fastest over its size. Where a rate is no number most are none: then it is told
    of the state that is largest over its size, place and heading left out.
    """
    work = work.copy()
    fill_inputs(t, False, at, work, pieces, signals.copy())
    x = v[of.X].copy()
    rates = ready.results(x, work[: int(at[of.INPUTS])], 0)
    size = np.abs(x) / v[of.SIZE]
    told = np.abs(rates) / (v[of.SIZE] * (1.0 + size)) if np.all(np.isfinite(rates)) else v[of.GROWING] * size
    name = states[int(np.argmax(told))]
    return Event("divergence", owner_and_quantity(name)[0] or name, t, None, f"{described(name)} leaves all bounds", x)
