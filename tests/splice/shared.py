"""What several tests of the spliced model share: models built once, and parts of their states."""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from eom.model.tyre import TyreModel, build_tyre_model
from eom.splice.state import sizes
from tests.vehicles.shipped import vehicle

Array = NDArray[np.float64]
STEP = 1e-30

SIMPLE = (
    "a_train",
    "articulated_bus",
    "b_train_yaw_plane",
    "b_train_yaw_roll",
    "car_trailer",
    "tractor_semitrailer_yaw_plane",
    "truck_full_trailer",
)
"""Shipped vehicles with linear tyres and a held speed."""
RICH = (
    "a_train_double",
    "b_train",
    "b_train_yaw_plane_nonlinear",
    "car",
    "tractor_semitrailer",
    "tractor_semitrailer_nonlinear",
)
"""Shipped vehicles with nonlinear tyres and a free speed."""


@cache
def model(name: str, **overrides: str | float) -> TyreModel:
    """The nonlinear model of a shipped vehicle, some parameters overridden."""
    return build_tyre_model(vehicle(name, **overrides))


def places(found: TyreModel) -> dict[str, slice]:
    """Where the parts of a state stand, by their names in `eom.splice.state.State`."""
    ends = np.cumsum((0, *sizes(found.numbers)))
    names = ("frame", "q", "n", "spin", "side", "drive", "brake")
    return {name: slice(int(ends[k]), int(ends[k + 1])) for k, name in enumerate(names)}


def by_name(found: TyreModel, **signals: float) -> Array:
    """Inputs, zero but for those named; a double underscore stands for the dot, ``every_x`` for all that end in x."""
    result = np.zeros(len(found.inputs))
    for name, value in signals.items():
        if name.startswith("every_"):
            own = [k for k, each in enumerate(found.inputs) if each.endswith(name.removeprefix("every_"))]
        else:
            own = [found.inputs.index(name.replace("__", "."))]
        if not own:
            raise KeyError(name)
        result[own] = value
    return result
