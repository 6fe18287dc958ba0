"""Stability over two parameters."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from eom.analysis.family import check_values, with_unit
from eom.analysis.stability import largest_real_part, least_damping
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.linear import linearise
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Axis(NamedTuple):
    """A parameter with its values, rising or falling, in a unit (SI if empty)."""

    parameter: str
    values: Sequence[float]
    unit: str = ""

    @property
    def label(self) -> str:
        """Name and unit."""
        return f"{self.parameter} [{self.unit}]" if self.unit else self.parameter


class MapPoint(NamedTuple):
    """One point of a map: indices of its values, rightmost real part [1/s], least damping ratio."""

    row: int
    column: int
    rightmost: float
    damping: float


@dataclass(frozen=True)
class StabilityMap:
    """How stable a vehicle is over two parameters; NaN where it was not computed.

    Attributes
    ----------
    first, second : Axis
    rightmost : Array
        Largest real part of all roots [1/s], shape (first, second); roots that are zero but for rounding are left out.
        It is negative where the vehicle is stable, and exactly zero for an undamped one.
    damping : Array
        Damping ratio of the least damped oscillation, same shape; NaN also where nothing oscillates.
    title : str
        The vehicle's name.
    """

    first: Axis
    second: Axis
    rightmost: Array
    damping: Array
    title: str

    def plot(self) -> "Figure":
        """Contours of both figures, the border of stability as a thick line."""
        from eom.analysis.maps_plot import plot_map  # noqa: PLC0415  draws with what is slow to import

        return plot_map(self)


def stability_map(vehicle: Vehicle, first: Axis, second: Axis) -> StabilityMap:
    """Rightmost root and least damping of a vehicle over a grid of two parameters.

    Raises
    ------
    AnalysisError
        If both are the same parameter, or values do not go one way.
    EomError
        As `eom.linearise`, at the first point that the vehicle refuses.
    """
    return map_of(vehicle, first, second, map_points(vehicle, first, second))


def map_points(vehicle: Vehicle, first: Axis, second: Axis) -> Iterator[MapPoint]:
    """The points of a map, row by row; each is computed when it is asked for."""
    if first.parameter == second.parameter:
        raise AnalysisError(f"map over {first.parameter}: expected two parameters, got the same one twice")
    for axis in (first, second):
        check_values(axis.parameter, axis.values)
    for (i, a), (k, b) in product(enumerate(first.values), enumerate(second.values)):
        settings = {first.parameter: with_unit(a, first.unit), second.parameter: with_unit(b, second.unit)}
        modes = linearise(vehicle.with_values(**settings)).modes()
        yield MapPoint(i, k, largest_real_part(modes), least_damping(modes))


def map_of(vehicle: Vehicle, first: Axis, second: Axis, points: Iterable[MapPoint]) -> StabilityMap:
    """The map of those points that there are."""
    values = np.full((2, len(first.values), len(second.values)), np.nan)
    for point in points:
        values[:, point.row, point.column] = point.rightmost, point.damping
    return StabilityMap(first, second, values[0], values[1], vehicle.name)
