"""Frequency response of outputs, and of ratios of two outputs, by one input."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from eom.analysis.figures import panels
from eom.analysis.gains import steady_gains
from eom.analysis.grid import frequency_grid, undamped_frequencies
from eom.analysis.roots import is_stable
from eom.analysis.signals import Channel, ratio_unit, signals
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.eigen import Complex
from eom.model.linear import LinearModel

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Peak(NamedTuple):
    """The largest magnitude over a range of frequencies; ``inside`` unless it stands at an end of the range.

    Infinite where an undamped root stands in the range and the channel sees it.
    """

    frequency: float
    value: float
    inside: bool


@dataclass(frozen=True)
class FrequencyResponse:
    """Complex amplitudes of outputs per amplitude of an input, or of one output per another.

    Attributes
    ----------
    model : LinearModel
    source : str
        The input.
    channels : tuple of Channel
        What the columns of ``values`` are.
    frequency : Array
        Shape (n,) [Hz].
    values : Complex
        Shape (n, channels): output's unit per input's, a ratio's unit of one output per the other's.
    stable : bool
        False: no motion settles to the response, it is formal.
    """

    model: LinearModel
    source: str
    channels: tuple[Channel, ...]
    frequency: Array
    values: Complex
    stable: bool

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the channels."""
        return tuple(item.name for item in self.channels)

    @property
    def units(self) -> tuple[str, ...]:
        """Units of the channels' magnitudes."""
        own = self.model.input_units[self.model.inputs.index(self.source)]
        return tuple(item.unit if item.under is not None else ratio_unit(item.unit, own) for item in self.channels)

    @property
    def magnitude(self) -> Array:
        """Shape (n, channels)."""
        return np.abs(self.values)

    @property
    def decibel(self) -> Array:
        """20 log10 of the magnitude in its unit; -inf where it is zero."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.magnitude))

    @property
    def phase(self) -> Array:
        """Phase [rad], positive where the output leads, without jumps of more than pi between frequencies.

        NaN where the value is infinite or not defined.
        """
        phase = np.full(self.values.shape, np.nan)
        for k, known in enumerate(np.isfinite(self.values).T):
            phase[known, k] = np.unwrap(np.angle(self.values[known, k]))
        return phase

    def peaks(self) -> tuple[Peak, ...]:
        """The largest magnitude of each channel over the range, refined between the frequencies of the grid."""
        return tuple(self._peak(k) for k in range(len(self.channels)))

    def _peak(self, k: int) -> Peak:
        """The peak of one channel: the best frequency of the grid, improved between its neighbours."""
        from scipy.optimize import minimize_scalar  # noqa: PLC0415  slow to import

        f, magnitude = self.frequency, np.where(np.isnan(self.magnitude[:, k]), -np.inf, self.magnitude[:, k])
        best = int(np.argmax(magnitude))
        if magnitude[best] < 0.0:
            return Peak(float(f[best]), np.nan, False)
        found = Peak(float(f[best]), float(magnitude[best]), 0 < best < len(f) - 1)
        if len(f) < 2 or not np.isfinite(found.value):
            return found
        ends = float(f[max(best - 1, 0)]), float(f[min(best + 1, len(f) - 1)])
        only = self.channels[k : k + 1]
        source = self.model.inputs.index(self.source)

        def height(frequency: float) -> float:
            return float(np.abs(evaluate(self.model, source, only, np.array([frequency]))[0, 0]))

        for pole in undamped_frequencies(self.model):
            # a pole multiplies by a hundred from one distance to the other
            if f[0] < pole < f[-1] and height(pole * (1.0 + 1e-6)) > 10.0 * height(pole * (1.0 + 1e-4)):
                return Peak(float(pole), np.inf, True)
        fine = minimize_scalar(lambda x: -height(x), bounds=ends, method="bounded", options={"xatol": 1e-10 * ends[1]})
        return Peak(float(fine.x), -float(fine.fun), True) if -fine.fun > found.value else found

    def plot(self) -> "Figure":
        """Magnitude over frequency, a panel for each unit, and phase in a last one."""
        curves = list(zip(self.names, self.units, self.magnitude.T, strict=True))
        turns = [
            (name, "phase [deg]", np.rad2deg(column)) for name, column in zip(self.names, self.phase.T, strict=True)
        ]
        note = "" if self.stable else " (unstable or undamped: formal)"
        title = f"{self.model.name}: response to {self.source}{note}"
        moving = self.frequency > 0.0
        every = [(name, unit or "ratio [-]", column[moving]) for name, unit, column in [*curves, *turns]]
        return panels(self.frequency[moving], every, ("frequency [Hz]", title), ("log", "linear"))


def frequency_response(
    model: LinearModel, source: str, outputs: Iterable[str] | None = None, frequency: ArrayLike | None = None
) -> FrequencyResponse:
    """Frequency response of outputs by an input.

    Parameters
    ----------
    model : LinearModel
    source : str
        The input.
    outputs : iterable of str, optional
        Outputs, or ratios of two such as ``"semitrailer_2.ay/tractor.ay"``, the rearward amplification. All outputs
        if not given.
    frequency : array_like, optional
        Frequencies [Hz]; at zero the steady gain is taken, at an undamped root that an output sees it is infinite. By
        default as `eom.analysis.grid.frequency_grid`.

    Raises
    ------
    AnalysisError
        For names that the model does not have, for negative frequencies.
    SingularError
        As `eom.analysis.gains.steady_gains`, at zero.
    """
    index, channels = signals(model, source, outputs)
    f = frequency_grid(model) if frequency is None else np.atleast_1d(np.asarray(frequency, dtype=float))
    if f.ndim != 1 or not np.all(np.isfinite(f) & (f >= 0.0)) or np.any(np.diff(f) <= 0.0):
        message = "frequencies: expected finite numbers in Hz, zero or positive, each larger than the one before"
        raise AnalysisError(message)
    return FrequencyResponse(model, source, channels, f, evaluate(model, index, channels, f), is_stable(model))


def at_a_pole(model: LinearModel, source: int, f: float) -> Complex:
    """Values of all outputs at a frequency [Hz] where an undamped root may stand: infinite where the output sees it."""
    try:
        return model.frequency_response([f])[0, :, source]
    except np.linalg.LinAlgError:
        # a pole multiplies by a hundred from one distance to the other
        far, near = model.frequency_response([f * (1.0 + 1e-7), f * (1.0 + 1e-9)])[:, :, source]
        return np.where(np.abs(near) > 10.0 * np.abs(far), np.inf, near)


def evaluate(model: LinearModel, source: int, channels: tuple[Channel, ...], f: Array) -> Complex:
    """Values of the channels at frequencies [Hz], shape (n, channels)."""
    every = np.empty((len(f), len(model.outputs)), dtype=complex)
    moving = f > 0.0
    try:
        every[moving] = model.frequency_response(f[moving])[:, :, source]
    except np.linalg.LinAlgError:
        every[moving] = [at_a_pole(model, source, float(frequency)) for frequency in f[moving]]
    if not np.all(moving):
        every[~moving] = steady_gains(model).values[:, source]
    columns = []
    with np.errstate(divide="ignore", invalid="ignore"):
        for item in channels:
            value = every[:, item.over]
            columns.append(value if item.under is None else value / every[:, item.under])
    return np.stack(columns, axis=1) if columns else np.empty((len(f), 0), dtype=complex)
