"""Measured points of a tyre, checked."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from eom.errors import TyreError
from eom.tyre.interface import ARGUMENTS, REFERENCE_SPEED, Forces

Array = np.ndarray[Any, Any]
DEFAULTS = {"alpha": 0.0, "kappa": 0.0, "gamma": 0.0, "speed": REFERENCE_SPEED}


class Points(NamedTuple):
    """Arguments of `Tyre.forces` by name, and the measured channels by name; arrays of one length."""

    arguments: dict[str, Array]
    channels: dict[str, Array]


def points_of(data: Mapping[str, ArrayLike]) -> Points:
    """Columns by name as points; raises `TyreError` with a sentence for everything that is wrong with them."""
    known = (*ARGUMENTS, *Forces._fields)
    wrong = [f"column {name!r} is not known: expected some of {', '.join(known)}" for name in data if name not in known]
    columns: dict[str, Array] = {}
    for name in known:
        if name in data:
            try:
                columns[name] = np.asarray(data[name], dtype=float)
            except (TypeError, ValueError):
                wrong.append(f"column {name!r}: expected numbers")
    wrong += missing(data)
    wrong += [f"column {name!r}: {problem}" for name, array in columns.items() if (problem := problem_of(array))]
    if len({array.shape for array in columns.values()}) > 1:
        lengths = ", ".join(f"{name} {array.shape}" for name, array in columns.items())
        wrong.append(f"columns of different shapes: {lengths}")
    elif "Fz" in columns and np.any(columns["Fz"] <= 0.0):
        wrong.append(f"column 'Fz': expected loads above 0 N, got {np.min(columns['Fz']):g} N")
    if wrong:
        raise TyreError("\n".join(f"fit: {sentence}" for sentence in wrong))
    shape = columns["Fz"].shape
    arguments = {name: columns[name] if name in columns else np.full(shape, DEFAULTS[name]) for name in ARGUMENTS}
    return Points(arguments, {name: columns[name] for name in Forces._fields if name in columns})


def missing(data: Mapping[str, ArrayLike]) -> list[str]:
    """Sentences for columns that have to be there."""
    wrong = []
    if "Fz" not in data:
        wrong.append("no column 'Fz': expected the load of each point [N]")
    if "alpha" not in data and "kappa" not in data:
        wrong.append("no slip: expected a column 'alpha' [rad] or 'kappa', or both")
    if not any(name in data for name in Forces._fields):
        wrong.append(f"nothing measured: expected at least one of the columns {', '.join(Forces._fields)}")
    return wrong


def problem_of(array: Array) -> str:
    """What is wrong with a column; empty if nothing is."""
    if array.ndim != 1:
        return f"expected one dimension, got shape {array.shape}"
    if not array.size:
        return "has no points"
    if bad := np.flatnonzero(~np.isfinite(array)).tolist():
        return f"{len(bad)} of {array.size} points are no finite numbers, the first at index {bad[0]}: leave them out"
    return ""
