"""Coefficients of tyre models as fields that know their unit, meaning and bounds."""

import dataclasses
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from eom.errors import TyreError

Values = float | np.ndarray[Any, Any]
"""A number, or an array of them: one tyre, or several whose coefficients are stacked."""


def coefficient(
    meaning: str,
    unit: str = "",
    *,
    default: float | None = None,
    above: float = -math.inf,
    at_least: float = -math.inf,
    at_most: float = math.inf,
    non_zero: bool = False,
) -> Any:
    """A dataclass field for a finite number, in SI units; without a *default* it has to be given.

    *above* is a bound that the number must exceed, *at_least* and *at_most* are bounds that it may reach; one that
    the equations divide by is *non_zero*.
    """
    metadata = {
        "meaning": meaning,
        "unit": unit,
        "above": above,
        "at_least": at_least,
        "at_most": at_most,
        "non_zero": non_zero,
    }
    if default is None:
        return dataclasses.field(metadata=metadata)
    return dataclasses.field(default=default, metadata=metadata)


def coefficients(owner: Any) -> Iterator["dataclasses.Field[Any]"]:
    """The fields made by `coefficient` of a parameter object or its class, in order."""
    return (item for item in dataclasses.fields(owner) if "unit" in item.metadata)


def check_bounds(parameters: Any) -> None:
    """Raise `TyreError` with a sentence for every coefficient that is no finite number or is out of its bounds."""
    if wrong := bound_problems(parameters):
        raise TyreError("\n".join(wrong))


def bound_problems(parameters: Any) -> list[str]:
    """A sentence for every coefficient that is no finite number or is out of its bounds."""
    return [
        f"{type(parameters).__name__}: {item.name} = {getattr(parameters, item.name)}: {problem}"
        for item in coefficients(parameters)
        if (problem := problem_of(item, getattr(parameters, item.name)))
    ]


def problem_of(item: "dataclasses.Field[Any]", value: Any) -> str:
    """What is wrong with a value of a coefficient; empty if nothing is."""
    limits = item.metadata
    try:
        numbers = np.asarray(value + 0.0, dtype=float)
    except (TypeError, ValueError):
        return "expected a number"
    if not np.all(np.isfinite(numbers)):
        problem = "expected a finite number"
    elif np.any(numbers <= limits["above"]):
        problem = f"expected more than {limits['above']:g}"
    elif np.any(numbers < limits["at_least"]):
        problem = f"expected at least {limits['at_least']:g}"
    elif np.any(numbers > limits["at_most"]):
        problem = f"expected at most {limits['at_most']:g}"
    elif limits["non_zero"] and np.any(numbers == 0.0):
        problem = "expected a number other than 0"
    else:
        return ""
    unit = f" {limits['unit']}" if limits["unit"] else ""
    return f"{problem}{unit} ({limits['meaning']})"
