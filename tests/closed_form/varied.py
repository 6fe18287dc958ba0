"""Random parameter sets around the nominal ones, of exact fractions or of floats."""

from dataclasses import fields, replace
from typing import Any, TypeVar

import numpy as np
import sympy as sp
from hypothesis import strategies as st

from eom.closed_form.parameters import Parameters

P = TypeVar("P", bound=Parameters)
PERCENT = st.integers(50, 200)
HEAVIER, LIGHTER = st.integers(100, 200), st.integers(50, 100)
ZERO = 60.0
"""What stands in for a nominal value of zero, so that it is varied too."""


def percents(name: str) -> st.SearchStrategy[int]:
    """Percents of its nominal value that a parameter may take; sprung masses stay below the whole ones."""
    if name.startswith("m_s"):
        return LIGHTER
    return HEAVIER if name in {"m1", "m2", "m3"} else PERCENT


def varied(kind: type[P]) -> st.SearchStrategy[P]:
    """Parameter sets of exact fractions, each between half and twice its nominal value."""
    nominal = kind()
    factors = st.fixed_dictionaries({field.name: percents(field.name) for field in fields(kind)})

    def of(percent: dict[str, int]) -> P:
        values: dict[str, Any] = {
            name: sp.Rational(str(getattr(nominal, name) or ZERO)) * sp.Rational(share, 100)
            for name, share in percent.items()
        }
        return kind(**values)

    return factors.map(of)


def in_floats(p: P) -> P:
    """The same parameters in floating point."""
    return replace(p, **{field.name: float(getattr(p, field.name)) for field in fields(p)})


SPEEDS = st.integers(5, 40).map(sp.Integer)
"""Forward speeds in m/s."""


def close(got: Any, expected: Any, tolerance: float) -> bool:
    """Whether two matrices agree, relative to the largest of each row, as entries of a row have one unit per column."""
    one, other = np.array(got, dtype=float), np.array(expected, dtype=float)
    scale = np.max(np.abs(other), axis=1, keepdims=True)
    return bool(np.all(np.abs(one - other) <= tolerance * scale))
