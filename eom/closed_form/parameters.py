"""What every parameter set has in common: values are finite, masses and their like are positive."""

from dataclasses import dataclass, fields
from math import isfinite
from typing import Any, ClassVar

import numpy as np

from eom.errors import EomError


@dataclass(frozen=True)
class Parameters:
    """Base of the parameter sets; values are numbers in SI units, or symbols.

    Raises
    ------
    EomError
        With every number that is not finite, and every one that must be positive and is not.
    """

    POSITIVE: ClassVar[tuple[str, ...]] = ()
    """Names that must be positive, properties included."""

    def __post_init__(self) -> None:
        odd = [field.name for field in fields(self) if isinstance(getattr(self, field.name), str | complex | None)]
        if odd:
            got = ", ".join(f"{name}: {getattr(self, name)!r}" for name in odd)
            raise EomError(f"{type(self).__name__}: expected real numbers or symbols, got {got}")
        bad = [field.name for field in fields(self) if not finite(getattr(self, field.name))]
        mistakes = [f"{name}: expected a finite number, got {getattr(self, name)}" for name in bad]
        values = {name: getattr(self, name) for name in self.POSITIVE if name not in bad}
        mistakes += [
            f"{name}: expected a positive number, got {value:g}"
            for name, value in values.items()
            if is_number(value) and value <= 0.0
        ]
        if mistakes:
            raise EomError("\n".join(f"{type(self).__name__}.{mistake}" for mistake in mistakes))


def is_number(value: Any) -> bool:
    """Whether a value is a plain number, not a symbol."""
    return isinstance(value, int | float | np.integer | np.floating)


def finite(value: Any) -> bool:
    """Whether a value is a symbol or a finite number."""
    return not is_number(value) or isfinite(value)


def check_speed(U: float) -> None:
    """Refuse a forward speed [m/s] that is a number but not a positive, finite one."""
    if isinstance(U, str | None):
        raise EomError(f"speed U: expected a number of m/s or a symbol, got {U!r}")
    if is_number(U) and not (isfinite(U) and U > 0.0):
        raise EomError(f"speed U: expected a positive number of m/s, got {U:g}; slip angles have no meaning at rest")
