"""Several tyres of one model as one, whose coefficients are arrays."""

import dataclasses
from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from eom.errors import TyreError
from eom.tyre.interface import Tyre
from eom.tyre.parameters import coefficients

T = TypeVar("T", bound=Tyre)
FORMS = ("form", "use", "combined")
"""What chooses the equations, of which all tyres of a stack have the same."""


def stack(tyres: Sequence[T]) -> T:
    """One tyre object for n tyres: arguments of shape (..., n) give the forces of each.

    Ranges and side, which enter no formula, are those of the first one.

    Raises `TyreError` if there is none, or if the tyres are of different models, forms or uses.
    """
    if not tyres:
        raise TyreError("stack: expected at least one tyre")
    first = tyres[0]
    numeric = [item.name for item in coefficients(first)]
    numeric += [item.name for item in dataclasses.fields(first) if isinstance(getattr(first, item.name), bool)]  # type: ignore[arg-type]
    forms = [name for name in FORMS if hasattr(first, name)]
    for k, tyre in enumerate(tyres):
        if type(tyre) is not type(first):
            kinds = f"{type(first).__name__} and {type(tyre).__name__}"
            raise TyreError(f"stack: tyre 1 and tyre {k + 1} are {kinds}: expected tyres of one model")
        for name in forms:
            if getattr(tyre, name) != getattr(first, name):
                values = f"{getattr(first, name)!r} and {getattr(tyre, name)!r}"
                raise TyreError(f"stack: tyre 1 and tyre {k + 1} have {name} = {values}: expected one and the same")
    columns = {name: np.array([getattr(tyre, name) for tyre in tyres]) for name in numeric}
    return dataclasses.replace(first, **columns)  # type: ignore[type-var]
