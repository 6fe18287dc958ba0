"""Signals that an analysis is asked for: an input, an output, the ratio of two outputs."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.errors import AnalysisError
from eom.model.linear import LinearModel
from eom.vehicle.validate import did_you_mean

Indices = NDArray[np.int_]


class Channel(NamedTuple):
    """An output of a model, or the ratio of two: indices of outputs, ``under`` None for a plain output."""

    name: str
    unit: str
    over: int
    under: int | None = None


def ratio_unit(over: str, under: str) -> str:
    """The unit of a quotient, empty where both are the same."""
    return "" if over == under else f"{over or '1'} per {under or '1'}"


def unknown(kind: str, name: str, known: tuple[str, ...]) -> str:
    """The sentence for a name that a model does not have."""
    there = f"there is no such {kind}{did_you_mean(name, known)}"
    return f"{kind} {name}: {there}" + ("" if known else f": the vehicle has no {kind}s at all")


def channel(model: LinearModel, name: str, mistakes: list[str]) -> Channel | None:
    """The channel that ``output`` or ``output/output`` names; a sentence for each unknown output joins *mistakes*."""
    parts = [part.strip() for part in name.split("/")]
    if len(parts) > 2 or not all(parts):
        mistakes.append(f"output {name}: expected the name of an output, or two with one '/' between them")
        return None
    wrong = [unknown("output", part, model.outputs) for part in parts if part not in model.outputs]
    if wrong:
        mistakes += wrong
        return None
    over, *rest = (model.outputs.index(part) for part in parts)
    if not rest:
        return Channel(parts[0], model.output_units[over], over)
    return Channel("/".join(parts), ratio_unit(model.output_units[over], model.output_units[rest[0]]), over, rest[0])


def signals(model: LinearModel, source: str, outputs: Iterable[str] | None) -> tuple[int, tuple[Channel, ...]]:
    """Index of an input and the channels of outputs, all of them for None.

    Raises `AnalysisError` with a sentence for every name that the model does not have.
    """
    mistakes = [] if source in model.inputs else [unknown("input", source, model.inputs)]
    names = model.outputs if outputs is None else tuple(dict.fromkeys(outputs))
    found = [channel(model, name, mistakes) for name in names]
    if mistakes:
        raise AnalysisError("\n".join(dict.fromkeys(mistakes)))
    return model.inputs.index(source), tuple(item for item in found if item is not None)


def input_index(model: LinearModel, source: str) -> int:
    """Index of an input; raises `AnalysisError` for an unknown one."""
    return signals(model, source, ())[0]


def indices(model: LinearModel, inputs: Iterable[str], outputs: Iterable[str]) -> tuple[Indices, Indices]:
    """Indices of inputs and of outputs; raises `AnalysisError` with a sentence for every unknown name."""
    sources, told = tuple(inputs), tuple(outputs)
    mistakes = [unknown("input", name, model.inputs) for name in sources if name not in model.inputs]
    mistakes += [unknown("output", name, model.outputs) for name in told if name not in model.outputs]
    if mistakes:
        raise AnalysisError("\n".join(mistakes))
    columns, rows = [model.inputs.index(name) for name in sources], [model.outputs.index(name) for name in told]
    return np.array(columns, dtype=int), np.array(rows, dtype=int)
