"""Words that suspicions share."""

from collections.abc import Callable, Iterator
from typing import Any

from eom.tyre.linear import Linear

Rule = Callable[[Any], Iterator[str]]
"""A tyre to the sentences that one kind of suspicion has about it."""


def told(tyre: Any, *names: str) -> str:
    """Those of the coefficients that the tyre has, with their values; scaling factors of one are left out."""
    values = {name: getattr(tyre, name) for name in names if hasattr(tyre, name)}
    return ", ".join(
        f"{name} = {value:g}" for name, value in values.items() if not (name.startswith("L") and value == 1.0)
    )


def drives(tyre: Any) -> bool:
    """Whether the tyre has a longitudinal force."""
    return bool(tyre.longitudinal > 0.0) if isinstance(tyre, Linear) else getattr(tyre, "use", "") != "lateral"


def corners(tyre: Any) -> bool:
    """Whether the tyre has a lateral force."""
    return bool(tyre.cornering > 0.0) if isinstance(tyre, Linear) else getattr(tyre, "use", "") != "longitudinal"
