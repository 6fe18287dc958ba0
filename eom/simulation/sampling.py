"""A sample of all blocks that are due: what their ports hold afterwards."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.errors import SimulationError, raised
from eom.simulation.blocks import Block
from eom.simulation.sampling_times import Instant, instants
from eom.simulation.wiring import Wiring

SHOWN = 5


class Held(NamedTuple):
    """What ports give between samples, and what waits to.

    Attributes
    ----------
    acting : Array
        What every port gives, (ports,) or (ports, cases), in the order of `Wiring.signals`; zero before any result.
    pending : Array
        Last result of every port, which for blocks that are not direct acts from the next sample on.
    started : NDArray
        Whether each block has had a sample, (blocks,).
    """

    acting: Array
    pending: Array
    started: NDArray[np.bool_]


def begun(wiring: Wiring, cases: int | None = None) -> Held:
    """Ports before the first sample of a run, or of a batch of some cases; all blocks are reset."""
    for block in wiring.blocks:
        block.reset()
    nothing = np.zeros(len(wiring.signals) if cases is None else (len(wiring.signals), cases))
    return Held(nothing, nothing, np.zeros(len(wiring.blocks), dtype=bool))


def sample_times(wiring: Wiring) -> Iterator[Instant]:
    """All sample times from 0 on, with the numbers of the blocks that are due, in the order of evaluation; endless."""
    return instants([block.period for block in wiring.blocks])


def updated(
    wiring: Wiring, due: Iterable[int], t: float, y: Array, held: Held, over: NDArray[np.bool_] | None = None
) -> Held:
    """Ports after a sample.

    Parameters
    ----------
    wiring : Wiring
    due : iterable of int
        Numbers of the blocks to evaluate, ascending, as `sample_times` gives them.
    t : float
        Time [s].
    y : Array
        The model's signals in the order of `model_signals`, (signals,) or (signals, cases), at *t* and before this
        sample acts: inputs that blocks drive have the value that they are driven with until now, before the first
        sample that of the trim.
    held : Held
        Ports before the sample; it is not changed.
    over : NDArray, optional
        Which cases of a batch have ended, (cases,).

    Raises
    ------
    SimulationError
        Naming block and time, for a block that raises an exception, which is chained, or that gives another shape than
        its ports have, or a value that is not finite; in a batch, for a case that goes on and in which all that it
        reads is finite.
    """
    numbers = tuple(due)
    seen = np.concatenate((y, held.acting))
    # a view: what a block gives is there for those that come after it
    acting = seen[len(y) :]
    pending, started = held.pending.copy(), held.started.copy()
    for k in numbers:
        if started[k] and not wiring.direct[k]:
            acting[wiring.ports[k]] = pending[wiring.ports[k]]
    for k in numbers:
        ports = wiring.ports[k]
        pending[ports] = result(wiring.blocks[k], t, seen[wiring.reads[k]], over)
        if wiring.direct[k] or not started[k]:
            acting[ports] = pending[ports]
        started[k] = True
    return Held(acting.copy(), pending, started)


def result(block: Block, t: float, y: Array, over: NDArray[np.bool_] | None) -> Array:
    """What a block makes of its inputs at a time [s], checked, but not in cases that are *over*."""
    who = f"block {block.name} at {t:g} s"
    blind = ~np.isfinite(y).all(axis=0)
    if y.ndim == 1 and blind:
        which = ", ".join(name for name, value in zip(block.inputs, y, strict=True) if not np.isfinite(value))
        raise SimulationError(f"{who}: reads {which}, which is not finite")
    try:
        given = np.asarray(block.update(t, y.copy()), dtype=float)
    except Exception as error:
        raise SimulationError(f"{who}: {raised(error)}") from error
    shape = (len(block.outputs), *y.shape[1:])
    if given.shape != shape:
        raise SimulationError(f"{who}: gave an array of shape {given.shape}, expected {shape}")
    wrong = ~np.isfinite(given) & ~blind
    if over is not None:
        wrong &= ~over
    if np.any(wrong):
        raise SimulationError(f"{who}: gave {not_finite(block, given, wrong)}, expected a finite number")
    return given


def not_finite(block: Block, given: Array, wrong: NDArray[np.bool_]) -> str:
    """Which ports, and of which cases, are not finite."""
    ports = ", ".join(
        f"{port} = {row[bad].flat[0]:g}"
        for port, row, bad in zip(block.outputs, given, wrong, strict=True)
        if np.any(bad)
    )
    if given.ndim == 1:
        return ports
    cases = np.flatnonzero(wrong.any(axis=0))
    more = f" and {len(cases) - SHOWN} more" if len(cases) > SHOWN else ""
    return f"{ports} in case {', '.join(map(str, cases[:SHOWN]))}{more}"
