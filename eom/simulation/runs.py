"""What many runs give: signals over cases and time."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.simulation.channels import Event
from eom.vehicle.validate import did_you_mean

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Runs:
    """Cases of one model over the same time.

    Attributes
    ----------
    name : str
        Of the vehicle.
    time : Array
        Shape (samples,) [s].
    signals, units : tuple of str
        What was kept, and what blocks gave.
    values : Array
        Shape (cases, samples, signals); not a number after the end of a case.
    events : tuple
        The events of each case.
    ended : tuple of str
        Why each case ended before the duration, a sentence; empty if it did not.
    """

    name: str
    time: Array
    signals: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    events: tuple[tuple[Event, ...], ...]
    ended: tuple[str, ...]

    def of(self, name: str) -> Array:
        """One signal, (cases, samples); raises `AnalysisError` for an unknown one."""
        if name not in self.signals:
            raise AnalysisError(f"signal {name}: was not kept{did_you_mean(name, self.signals)}")
        return np.asarray(self.values[:, :, self.signals.index(name)])

    def data(self) -> "xarray.Dataset":
        """The signals by name over (case, time), with units, and ``ended`` over the cases."""
        import xarray  # noqa: PLC0415  slow to import

        found = {
            name: (("case", "time"), self.of(name), {"units": unit, "long_name": name})
            for name, unit in zip(self.signals, self.units, strict=True)
        }
        coordinates = {
            "time": ("time", self.time, {"units": "s"}),
            "case": np.arange(len(self.values)),
            "ended": ("case", np.array(self.ended)),
        }
        return xarray.Dataset(found, coords=coordinates, attrs={"vehicle": self.name})
