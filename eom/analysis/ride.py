"""Response to a random road: power spectral densities and RMS values of the outputs."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from eom.analysis.figures import panels
from eom.analysis.grid import check_range
from eom.analysis.road import CLASSES, SPATIAL
from eom.analysis.roots import is_stable
from eom.analysis.signals import indices
from eom.analysis.vibration import Contact, integral, output_psd, road_contacts, road_grid
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.assembly import Assembly
from eom.model.linear import LinearModel, linearise
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class RoadResponse:
    """What a vehicle does on a random road at its trim speed.

    Attributes
    ----------
    model : LinearModel
    road : str
        Class or roughness in words.
    roughness : float
        G_d(n0) [m^3].
    speed : float
        [m/s]
    sources : tuple of str
        The inputs that the road moves.
    outputs, units : tuple of str
    frequency : Array
        Shape (n,) [Hz].
    psd : Array
        One-sided, shape (n, outputs) [output's unit squared per Hz].
    rms : Array
        Over the band, shape (outputs,) [output's unit].
    band : tuple of float
        From and to [Hz].
    """

    model: LinearModel
    road: str
    roughness: float
    speed: float
    sources: tuple[str, ...]
    outputs: tuple[str, ...]
    units: tuple[str, ...]
    frequency: Array
    psd: Array
    rms: Array
    band: tuple[float, float]

    def rms_of(self, output: str) -> float:
        """RMS of one output over the band, in its unit."""
        return float(self.rms[self.outputs.index(output)])

    def plot(self) -> "Figure":
        """Square roots of the PSDs over frequency, a panel for each unit."""
        curves = [
            (name, f"[{unit or '-'}/√Hz]", np.sqrt(column))
            for name, unit, column in zip(self.outputs, self.units, self.psd.T, strict=True)
        ]
        title = f"{self.model.name}: {self.road} at {self.speed * 3.6:.4g} km/h"
        return panels(self.frequency, curves, ("frequency [Hz]", title), ("log", "log"))


def road_response(
    vehicle: Vehicle | Assembly,
    road: str | float,
    *,
    speed: float | None = None,
    band: tuple[float | None, float | None] = (None, None),
    outputs: Iterable[str] | None = None,
) -> RoadResponse:
    """PSDs and RMS values of outputs on a random road of ISO 8608.

    The road's inputs are those in metres that push a body up from the ground: each sees the same track earlier or later
    by its place x over the speed, and tracks of different y go together as those of an isotropic road do. All other
    inputs are zero.

    Parameters
    ----------
    vehicle : Vehicle or Assembly
    road : str or float
        Class ``"A"`` to ``"H"``, its geometric mean, or G_d(n0) itself [m^3].
    speed : float, optional
        [m/s], for a vehicle without trim speed.
    band : tuple of float, optional
        Frequencies from and to of the PSDs and of the RMS values [Hz]; by default those of the spatial frequencies 0.01
        and 10 1/m at the speed.
    outputs : iterable of str, optional
        All by default.

    Raises
    ------
    AnalysisError
        Without road inputs, without speed, for an unstable vehicle, unknown outputs or class, all at once; for a band
        that is none.
    """
    model = linearise(vehicle)
    contacts = road_contacts(vehicle.system.inputs)
    names = model.outputs if outputs is None else tuple(dict.fromkeys(outputs))
    mistakes = request_mistakes(model, contacts, road, speed)
    try:
        rows = indices(model, (), names)[1]
    except AnalysisError as error:
        mistakes.append(str(error))
    if mistakes:
        raise AnalysisError("\n".join(mistakes))
    roughness = CLASSES[road] if isinstance(road, str) else road
    moving = model.speed or speed or 0.0
    first, last = (n * moving if given is None else given for given, n in zip(band, SPATIAL, strict=True))
    check_range(first, last)
    frequency = road_grid(model, contacts, moving, (first, last))

    def densities(f: Array) -> Array:
        return output_psd(model, rows, contacts, (roughness, moving), f)

    return RoadResponse(
        model,
        f"road of class {road}" if isinstance(road, str) else f"road of G_d(n0) = {road:g} m^3",
        roughness,
        moving,
        tuple(model.inputs[item.column] for item in contacts),
        names,
        tuple(model.output_units[k] for k in rows),
        frequency,
        densities(frequency),
        np.sqrt(integral(model, densities, first, last)),
        (first, last),
    )


def request_mistakes(model: LinearModel, contacts: list[Contact], road: str | float, speed: float | None) -> list[str]:
    """Sentences for what keeps a vehicle from being driven on a random road."""
    mistakes = []
    if not contacts:
        what = "no input is a height of the road: give actuators on the ground with 'unit: m' along [0, 0, 1]"
        mistakes.append(f"{model.name}: {what}")
    if isinstance(road, str) and road not in CLASSES:
        mistakes.append(f"road {road}: expected a class of ISO 8608, one of {', '.join(CLASSES)}")
    if not isinstance(road, str) and not (np.isfinite(road) and road > 0.0):
        mistakes.append(f"road {road:g}: expected a positive roughness in m^3")
    if model.speed and speed is not None:
        mistakes.append(f"speed {speed:g} m/s: the trim's speed is {model.speed:g} m/s; change it there")
    elif not model.speed and not (speed is not None and np.isfinite(speed) and speed > 0.0):
        mistakes.append(f"{model.name}: a road passes under a moving vehicle: give a speed, in m/s, larger than zero")
    if not is_stable(model):
        mistakes.append(f"{model.name}: is unstable or undamped: no steady vibration exists")
    return mistakes
