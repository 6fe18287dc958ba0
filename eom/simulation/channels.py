"""Signals of a run by name, and the limits that it reached."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array

STATE = "state:"
"""What stands before the name of a state where all signals are in one list: an output may have the same name."""


@dataclass(frozen=True)
class Event:
    """A limit that was reached.

    Attributes
    ----------
    kind : str
        ``lift``, ``lock``, ``jackknife``, ``rollover``, ``roll``, ``articulation``, ``traction``, ``standstill`` or
        ``divergence``.
    owner : str
        The wheel, unit or body.
    time : float
        When it was reached [s].
    until : float or None
        When it was left again [s]; None if never.
    sentence : str
        What the owner does there, without its name and the time.
    state : Array
        Shape (states,): the state at ``time``.
    """

    kind: str
    owner: str
    time: float
    until: float | None
    sentence: str
    state: Array

    def __str__(self) -> str:
        end = "" if self.until is None else f" (until {self.until:.6g} s)"
        return f"{self.time:.6g} s: {self.owner}: {self.sentence}{end}"


class Channels(NamedTuple):
    """One group of signals: names, units and descriptions, (signals,) each, and values, (samples, signals)."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    descriptions: tuple[str, ...]
    values: Array


def joined(groups: Iterable[Channels]) -> Channels:
    """Several groups over the same time as one."""
    names, units, descriptions, values = zip(*groups, strict=True)
    return Channels(sum(names, ()), sum(units, ()), sum(descriptions, ()), np.hstack(values))


def as_states(group: Channels) -> Channels:
    """The group with `STATE` before every name."""
    return group._replace(names=tuple(STATE + name for name in group.names))


def owner_and_quantity(name: str) -> tuple[str, str]:
    """Parts of a signal's name: ``axle_4.left`` and ``Fz`` of ``axle_4.left.Fz``; no owner in a name without a dot."""
    owner, _, quantity = name.rpartition(".")
    return owner, quantity


def misshapen(kind: str, group: Channels, samples: int) -> Iterator[str]:
    """Sentences for a group whose parts do not belong together, or that has not as many samples as the time."""
    count, shape = len(group.names), group.values.shape
    for what, length in (("units", len(group.units)), ("descriptions", len(group.descriptions))):
        if length != count:
            yield f"{kind}: {count} names, but {length} {what}"
    if shape != (samples, count):
        yield f"{kind}: expected values of shape ({samples}, {count}), samples by signals, got {shape}"


def repeated(names: Iterable[str]) -> Iterator[str]:
    """A sentence for every name that stands for two signals."""
    seen: dict[str, int] = {}
    for name in names:
        seen[name] = seen.get(name, 0) + 1
    for name, count in seen.items():
        if count > 1:
            yield f"signal {name}: {count} signals of the run have this name, expected one"
