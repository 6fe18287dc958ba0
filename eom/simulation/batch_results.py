"""From a fleet to the results of a batch."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.vectors import Array
from eom.model.tyre import TyreModel
from eom.simulation import memory as of
from eom.simulation.equations import Model
from eom.simulation.fleet import Fleet
from eom.simulation.report import events
from eom.simulation.request import Request
from eom.simulation.runs import Runs


def told(
    model: Model, asked: Request, own: Fleet, kept: Sequence[tuple[int, str]], held: Sequence[tuple[float, Array]]
) -> Runs:
    """The results of all cases."""
    wiring, limits = asked.wiring, model.limits if isinstance(model, TyreModel) else ()
    units = [*model.state_units, *model.input_units, *model.output_units]
    values = own.rows
    if wiring.signals and not held:
        values = np.concatenate((values, np.full((*values.shape[:2], len(wiring.signals)), np.nan)), axis=2)
    elif wiring.signals:
        instants, ports = zip(*held, strict=True)
        at = np.array(ports)[np.searchsorted(instants, own.times, side="right") - 1]
        for k, until in enumerate(own.until):
            # where a case ends its blocks are not asked any more
            at[own.times == until, :, k] = ports[max(int(np.searchsorted(instants, until)) - 1, 0)][:, k]
        taken = np.arange(len(own.times)) < own.counts[:, of.SAMPLES, np.newaxis]
        values = np.concatenate((values, np.where(taken[:, :, np.newaxis], at.transpose(2, 0, 1), np.nan)), axis=2)
    diverging = [own.diverging(k, model.states) for k in range(len(own.clock))]
    return Runs(
        name=model.vehicle.name if isinstance(model, TyreModel) else model.name,
        time=own.times,
        signals=(*(name for _, name in kept), *wiring.signals),
        units=(*(units[k] for k, _ in kept), *wiring.units),
        values=values,
        events=tuple((*events(parts, limits), *more) for parts, more in zip(own.events, diverging, strict=True)),
        ended=tuple(own.ended(k, asked.duration, limits, more) for k, more in enumerate(diverging)),
    )
