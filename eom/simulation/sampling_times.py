"""Sample times as exact fractions, so that samples that should coincide do."""

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array

DENOMINATOR = 10**9
SMALLEST = 1.0 / DENOMINATOR


class Instant(NamedTuple):
    """A sample time [s] and the numbers of the blocks that are due then."""

    time: float
    due: tuple[int, ...]


def exact(time: float) -> Fraction:
    """A time [s] as the closest fraction with a denominator of at most a thousand millions.

    Decimal times become what they read as: 0.01 is one hundredth. Others change by less than 1e-9 s.
    """
    return Fraction(time).limit_denominator(DENOMINATOR)


def instants(periods: Sequence[float]) -> Iterator[Instant]:
    """All sample times from 0 on, without end: the multiples of all periods [s], each once, none without periods.

    A time is the float next to the exact multiple, so that nothing adds up.
    """
    fractions = [exact(period) for period in periods]
    ticks = math.lcm(*(period.denominator for period in fractions))
    whole, now = [int(period * ticks) for period in fractions], 0
    while whole:
        yield Instant(now / ticks, tuple(k for k, period in enumerate(whole) if now % period == 0))
        now = min((now // period + 1) * period for period in whole)


def multiples(period: float, last: float) -> Array:
    """The multiples of a period [s] from 0 to a last instant [s], each the float next to the exact one."""
    own = exact(period)
    count = int(np.floor(last / period * (1.0 + 1e-12) + 1e-9))
    return np.minimum(np.arange(count + 1) * own.numerator / own.denominator, last)
