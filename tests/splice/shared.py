"""What several tests of the spliced model share: models built once, and parts of their states."""

from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

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


class Piece(NamedTuple):
    """A run between two corners of its inputs; ``state`` gives the state at a time between them."""

    first: float
    last: float
    state: Callable[[float], Array]


def march(
    rates: Callable[[float, Array], Array], start: Array, corners: Sequence[float], relative: float = 1e-9
) -> list[Piece]:
    """A motion from corner to corner of its inputs, by Runge and Kutta of the eighth order."""
    pieces = []
    for first, last in pairwise(corners):
        run = solve_ivp(rates, (first, last), start, "DOP853", dense_output=True, rtol=relative, atol=relative)
        assert run.success
        assert run.sol is not None
        pieces.append(Piece(first, last, run.sol))
        start = run.y[:, -1]
    return pieces
