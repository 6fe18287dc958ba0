"""Sensors: a signal sampled, delayed and with noise."""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.simulation.blocks import BlockError
from eom.simulation.kinds import is_number
from eom.simulation.sampling_times import SMALLEST, exact

LATEST = 1_000_000
"""Periods."""


@dataclass
class Sensor:
    """A signal at sample times, late by a whole number of periods, with Gaussian noise; port ``value``.

    Before the start it has measured what it measures at the first sample.

    Attributes
    ----------
    name : str
    signal : str
        What it measures: an output or input of the model, ``state:NAME``, or a block's ``BLOCK.PORT``.
    period : float
        Time between samples [s].
    delay : float
        [s], a whole number of periods. With one or more periods it is not `direct`, and may close a loop.
    noise : float or Array
        Standard deviation of the noise in the signal's unit; in a batch one number, or one for each case.
    seed : int or sequence of int
        Of the noise, which is the same after every `reset`. In a batch one seed gives every case the same noise, and
        a seed for each case its own; each is that of a single run with this seed.

    Raises
    ------
    BlockError
        With a sentence for every value that cannot be.
    """

    name: str
    signal: str
    period: float
    delay: float = 0.0
    noise: float | Array = 0.0
    seed: int | Sequence[int] | NDArray[np.integer] = 0
    outputs: tuple[str, ...] = field(default=("value",), init=False)
    units: tuple[str | None, ...] = field(default=(None,), init=False)

    def __post_init__(self) -> None:
        times = {"period": self.period, "delay": self.delay}
        wrong = {name: f"is {value!r}: expected a time" for name, value in times.items() if not is_number(value)}
        if wrong:
            raise BlockError(self.name, wrong)
        if not (np.isfinite(self.period) and self.period >= SMALLEST):
            wrong["period"] = f"is {self.period:g} s: expected a time of at least {SMALLEST:g} s"
        elif not (np.isfinite(self.delay) and self.delay >= 0.0 and self.late.denominator == 1):
            wrong["delay"] = f"is {self.delay:g} s: expected a whole number of periods of {self.period:g} s"
        elif self.late > LATEST:
            wrong["delay"] = f"is {self.delay:g} s: expected at most {LATEST} periods of {self.period:g} s"
        if not (np.all(np.isfinite(self.noise)) and np.all(np.asarray(self.noise) >= 0.0)):
            wrong["noise"] = f"is {self.noise}: expected a standard deviation, no less than zero"
        seeds = np.asarray(self.seed)
        if seeds.ndim > 1 or not np.all((seeds == np.floor(seeds)) & (seeds >= 0) & (seeds < 2**63)):
            wrong["seed"] = f"is {self.seed}: expected a whole number, no less than zero"
        if wrong:
            raise BlockError(self.name, wrong)
        self.reset()

    @property
    def late(self) -> Fraction:
        """The delay in periods."""
        return exact(self.delay) / exact(self.period)

    @property
    def inputs(self) -> tuple[str, ...]:
        """The signal."""
        return (self.signal,)

    @property
    def direct(self) -> bool:
        """Whether a sample shows at once: without delay."""
        return self.late == 0

    def reset(self) -> None:
        """Forget what was measured, and begin the noise anew."""
        self._waiting: deque[Array] = deque()
        seeds = np.asarray(self.seed).astype(np.int64)
        self._noises = [np.random.default_rng(seed) for seed in seeds.reshape(-1).tolist()]

    def update(self, t: float, y: Array) -> Array:
        """The measured signal, in a batch of each case; a block that is not direct acts one period later than this."""
        del t
        value = y + self._noise()
        waits = max(int(self.late) - 1, 0)
        if not self._waiting:
            self._waiting.extend([value] * waits)
        self._waiting.append(value)
        return self._waiting.popleft()

    def _noise(self) -> Array:
        """The next sample of the noise, () or (cases,)."""
        drawn = np.array([noise.standard_normal() for noise in self._noises])
        return np.asarray(self.noise * (drawn if np.ndim(self.seed) else drawn[0]))
