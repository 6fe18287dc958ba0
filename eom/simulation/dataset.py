"""A run as an xarray data set."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.simulation.channels import Channels

if TYPE_CHECKING:
    from xarray import Dataset

RESERVED = ("time", "state", "states", "state_unit")


def dataset(time: Array, signals: Channels, states: Channels, about: Mapping[str, str]) -> "Dataset":
    """Signals as variables of their own, states as one variable over names; see `eom.simulation.Run.data`.

    Raises `AnalysisError` for signals with names that the data set needs for itself.
    """
    from xarray import Dataset  # noqa: PLC0415  slow to import

    taken = [name for name in signals.names if name in RESERVED]
    if taken:
        kept = f"a data set keeps {', '.join(RESERVED)} for itself: give the sensor or actuator another name"
        raise AnalysisError("\n".join(f"signal {name}: {kept}" for name in taken))
    described = zip(signals.names, signals.units, signals.descriptions, signals.values.T, strict=True)
    variables = {
        name: ("time", values, {"units": unit, "long_name": description or name})
        for name, unit, description, values in described
    }
    data = Dataset(variables, {"time": ("time", time, {"units": "s", "long_name": "time"})}, dict(about))
    if not states.names:
        # netCDF3 has no dimension of length zero
        return data
    labels = {"state": ("state", list(states.names)), "state_unit": ("state", list(states.units))}
    return data.assign(states=(("time", "state"), states.values, {"long_name": "states"})).assign_coords(labels)
