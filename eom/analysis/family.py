"""Linear models over the values of one parameter."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from eom.errors import AnalysisError
from eom.model.linear import LinearModel, linearise
from eom.model.modes import Modes
from eom.vehicle.load import Vehicle

Family = Callable[[float], LinearModel]
"""A linear model by the value of its parameter."""


@dataclass(frozen=True)
class Node:
    """One value of a parameter with its linear model."""

    value: float
    model: LinearModel

    @cached_property
    def modes(self) -> Modes:
        """The model's modes."""
        return self.model.modes()


def with_unit(value: float, unit: str) -> str | float:
    """A value as `eom.load` takes it."""
    return f"{float(value)!r} {unit}" if unit else float(value)


def family_of(vehicle: Vehicle, parameter: str, unit: str = "") -> Family:
    """Linear models of a vehicle over one of its parameters, in a unit (SI if empty)."""
    return lambda value: linearise(vehicle.with_values(**{parameter: with_unit(value, unit)}))


def nodes_at(family: Family, values: Sequence[float]) -> list[Node]:
    """The models at several values."""
    return [Node(float(value), family(float(value))) for value in values]


def check_values(parameter: str, values: Sequence[float]) -> None:
    """Raise `AnalysisError` unless the values are finite and go one way."""
    steps = np.diff(np.asarray(values, dtype=float))
    if not len(values) or not np.all(np.isfinite(values)):
        raise AnalysisError(f"sweep of {parameter}: expected finite values, at least one, got {list(values)}")
    if not (np.all(steps > 0.0) or np.all(steps < 0.0)):
        raise AnalysisError(f"sweep of {parameter}: expected values that rise, or fall, from each to the next")


def check_states(one: Node, two: Node) -> None:
    """Raise `AnalysisError` where the number of states differs."""
    counts = len(one.model.states), len(two.model.states)
    if counts[0] != counts[1]:
        raise AnalysisError(
            f"{one.model.name}: the model has {counts[0]} states at {one.value:g} and {counts[1]} at {two.value:g}, so "
            "that its roots cannot be followed between them; sweep both sides apart"
        )
