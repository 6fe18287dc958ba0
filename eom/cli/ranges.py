"""Ranges of parameters on the command line."""

import math
import re
from typing import NamedTuple

from eom.cli.settings import UsageError

RANGE = re.compile(r"\s*([A-Za-z][\w.]*)\s*=\s*([^:]+):([^:]+):\s*([-+\d.eE]+)\s*(.*?)\s*")
MAX_STEPS = 10_000
ROUNDING = 1e-12


class Range(NamedTuple):
    """A parameter with its values and their unit."""

    name: str
    values: list[float]
    unit: str


def parse_ranges(texts: list[str]) -> list[Range]:
    """``NAME=FROM:TO:STEPunit`` texts; every malformed one is named."""
    found, wrong = [], []
    for text in texts:
        try:
            found.append(parse_range(text))
        except UsageError as error:
            wrong.append(str(error))
    names = [item.name for item in found]
    wrong += [f"{name}: is swept twice" for name in dict.fromkeys(names) if names.count(name) > 1]
    points = math.prod(len(item.values) for item in found)
    if len(texts) > 2:
        wrong.append(f"{len(texts)} ranges: expected one for a locus, or two for a map")
    elif points > MAX_STEPS:
        wrong.append(f"{' '.join(texts)}: are {points} points, at most {MAX_STEPS} are allowed")
    elif len(texts) > 1:
        wrong += [f"{item.name}: has one value, a map needs two or more" for item in found if len(item.values) < 2]
    if wrong:
        raise UsageError("\n".join(wrong))
    return found


def parse_range(text: str) -> Range:
    """Name, values (both ends included where the step meets them) and unit."""
    match = RANGE.fullmatch(text)
    expected = f"{text}: expected NAME=FROM:TO:STEP with an optional unit, such as U=10:130:5km/h"
    if match is None:
        raise UsageError(expected)
    try:
        start, stop, step = (float(match[k]) for k in (2, 3, 4))
    except ValueError:
        raise UsageError(expected) from None
    if not all(map(math.isfinite, (start, stop, step))) or step == 0.0 or (stop - start) / step < 0.0:
        raise UsageError(f"{text}: the step does not lead from {start:g} to {stop:g}")
    steps = (stop - start) / step
    if not steps < MAX_STEPS:
        raise UsageError(f"{text}: has {steps:.0f} steps, at most {MAX_STEPS} are allowed")
    count = int(steps * (1.0 + 1e-12) + 1e-9) + 1
    values = [start + k * step for k in range(count)]
    # a value that the steps meet at zero is zero, not what rounding leaves of it
    size = max(abs(start), abs(stop))
    return Range(match[1], [0.0 if abs(value) < ROUNDING * size else value for value in values], match[5])
