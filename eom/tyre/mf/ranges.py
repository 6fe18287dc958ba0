"""Ranges within which a Magic Formula tyre was measured; infinite where the file says none."""

import dataclasses
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.tyre.parameters import Values


def limit(meaning: str, unit: str = "", *, default: float) -> Any:
    """A dataclass field for an end of a range, in SI units; an infinite one is no limit."""
    return dataclasses.field(default=default, metadata={"meaning": meaning, "limit_unit": unit})


@dataclass(frozen=True, kw_only=True)
class LongSlipRange:
    """Section [LONG_SLIP_RANGE]."""

    KPUMIN: Values = limit("least longitudinal slip", default=-math.inf)
    KPUMAX: Values = limit("greatest longitudinal slip", default=math.inf)


@dataclass(frozen=True, kw_only=True)
class SlipAngleRange:
    """Section [SLIP_ANGLE_RANGE]."""

    ALPMIN: Values = limit("least slip angle", "rad", default=-math.inf)
    ALPMAX: Values = limit("greatest slip angle", "rad", default=math.inf)


@dataclass(frozen=True, kw_only=True)
class InclinationAngleRange:
    """Section [INCLINATION_ANGLE_RANGE]."""

    CAMMIN: Values = limit("least camber", "rad", default=-math.inf)
    CAMMAX: Values = limit("greatest camber", "rad", default=math.inf)


@dataclass(frozen=True, kw_only=True)
class VerticalForceRange:
    """Section [VERTICAL_FORCE_RANGE]."""

    FZMIN: Values = limit("least load", "N", default=0.0)
    FZMAX: Values = limit("greatest load", "N", default=math.inf)


@dataclass(frozen=True, kw_only=True)
class InflationPressureRange:
    """Section [INFLATION_PRESSURE_RANGE]."""

    PRESMIN: Values = limit("least inflation pressure", "Pa", default=0.0)
    PRESMAX: Values = limit("greatest inflation pressure", "Pa", default=math.inf)


def range_ends(owner: Any) -> Iterator["dataclasses.Field[Any]"]:
    """The fields made by `limit` of a parameter object or its class, in order."""
    return (item for item in dataclasses.fields(owner) if "limit_unit" in item.metadata)


def range_problems(owner: Any, values: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """For every range that cannot be or that no value is in: the name of its wrong end, and the sentence.

    *values* are the ends of the ranges of *owner*, a parameter object or its class; ends left out have their default.
    No lower end is below its default, which is 0 for load and pressure.
    """
    items = list(range_ends(owner))
    for low, high in zip(items[::2], items[1::2], strict=True):
        least, most = (values.get(item.name, item.default) for item in (low, high))
        if not all_hold(np.greater_equal, least, low.default):
            yield low.name, f"expected a number of at least {low.default:g}"
        elif not all_hold(np.less, least, most):
            yield high.name, f"expected a number above {low.name} = {least}"


def all_hold(relation: "np.ufunc", left: Any, right: Any) -> bool:
    """Whether all elements are numbers in a relation."""
    try:
        return bool(np.all(relation(left, right)))
    except TypeError:
        return False
