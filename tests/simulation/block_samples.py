"""Blocks made of functions, and a loop that does nothing but sample them."""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import islice

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.sampling import Held, begun, sample_times, updated
from eom.simulation.wiring import Wiring


@dataclass
class Function:
    """A block that is a function of time and inputs; one port ``out`` unless told otherwise."""

    name: str
    inputs: tuple[str, ...]
    of: Callable[[float, Array], object]
    period: float = 0.1
    direct: bool = True
    outputs: tuple[str, ...] = ("out",)
    units: tuple[str | None, ...] = ("",)
    input_units: tuple[str | None, ...] = ()
    times: list[float] = field(default_factory=list)

    def reset(self) -> None:
        self.times.clear()

    def update(self, t: float, y: Array) -> Array:
        self.times.append(t)
        return self.of(t, y)  # type: ignore[return-value]


def add_one(_: float, y: Array) -> Array:
    """One more than the sum of all inputs."""
    return np.asarray(np.sum(y, axis=0, keepdims=True) + 1.0)


def sampled(
    wiring: Wiring, count: int, y: Callable[[float], Array], cases: int | None = None
) -> tuple[Array, list[Held]]:
    """Times of the first samples, and what the ports hold after each."""
    held, times, found = begun(wiring, cases), [], []
    for instant in islice(sample_times(wiring), count):
        held = updated(wiring, instant.due, instant.time, y(instant.time), held)
        times.append(instant.time)
        found.append(held)
    return np.array(times), found
