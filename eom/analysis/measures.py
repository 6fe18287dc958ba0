"""Measures of a sweep by name: of each wheel, of each pair of wheels, of each position sensor."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from eom.analysis.closure import Posture, measured
from eom.analysis.drives import Wheel
from eom.analysis.wheels import WheelState, roll_centre
from eom.assembly.vectors import Array
from eom.vehicle.load import Vehicle


class Measure(NamedTuple):
    """A measure over the sweep: its SI unit and its value at each point, NaN where it is not defined."""

    unit: str
    values: Array


def wheel_measures(wheel: Wheel, states: Sequence[WheelState]) -> Iterator[tuple[str, Measure]]:
    """The measures of one wheel."""
    for name, unit in (("travel", "m"), ("camber", "rad"), ("toe", "rad"), ("steer", "rad")):
        yield f"{wheel.name}.{name}", Measure(unit, np.array([getattr(state, name) for state in states]))
    for k, axis in enumerate("xy"):
        shift = np.array([state.contact[k] - wheel.contact[k] for state in states])
        yield f"{wheel.name}.contact_{axis}", Measure("m", shift)


def pair_name(name: str) -> str:
    """The name of a left wheel without its side."""
    return "_".join(word for word in name.split("_") if word not in {"left", "right"}) or "pair"


def pair_measures(name: str, left: Sequence[WheelState], right: Sequence[WheelState]) -> Iterator[tuple[str, Measure]]:
    """The measures of a left and a right wheel together."""
    pair = pair_name(name)
    track = [float(a.contact[1] - b.contact[1]) for a, b in zip(left, right, strict=True)]
    centre = np.array([roll_centre(a, b) for a, b in zip(left, right, strict=True)])
    yield f"{pair}.track", Measure("m", np.array(track))
    yield f"{pair}.roll_centre_height", Measure("m", centre[:, 1])
    yield f"{pair}.roll_centre_y", Measure("m", centre[:, 0])


def sensor_measures(vehicle: Vehicle, postures: Sequence[Posture]) -> Iterator[tuple[str, Measure]]:
    """Every position sensor and output, without feed-through; turns are followed from point to point."""
    for item in vehicle.system.outputs:
        if item.quantity != "position":
            continue
        total = np.zeros(len(postures))
        for weight, connection in item.terms:
            own = np.array([measured(vehicle.system.bodies, connection, posture) for posture in postures])
            total += weight * (own if connection.forces else np.unwrap(own, period=4.0 * np.pi))
        yield item.name, Measure(item.unit, total)
