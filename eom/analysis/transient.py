"""Responses in time: step, impulse, sine and given inputs, exact at the samples."""

from collections.abc import Callable, Mapping
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from eom.analysis.grid import time_grid
from eom.analysis.march import held, march, sine, straight
from eom.analysis.signals import input_index, unknown
from eom.analysis.time_response import TimeResponse, finished
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.linear import LinearModel

Signal = ArrayLike | Callable[[Array], ArrayLike]


def checked_time(model: LinearModel, time: ArrayLike | None) -> Array:
    """Times to compute at, those of `eom.analysis.grid.time_grid` by default; raises `AnalysisError`."""
    result = time_grid(model) if time is None else np.asarray(time, dtype=float)
    if result.ndim != 1 or not result.size or not np.all(np.isfinite(result)) or np.any(np.diff(result) <= 0.0):
        message = "times: expected finite numbers in s, each larger than the one before"
        raise AnalysisError(message)
    if time is not None and result[0] < 0.0:
        message = f"times: start at {result[0]:g} s, expected zero or later: the motion starts from rest at zero"
        raise AnalysisError(message)
    return result


def initial_state(model: LinearModel, initial: ArrayLike | None) -> Array:
    """The state to start from, rest by default; raises `AnalysisError` for one that does not fit."""
    x0 = np.zeros(len(model.A)) if initial is None else np.asarray(initial, dtype=float)
    if x0.shape != (len(model.A),) or not np.all(np.isfinite(x0)):
        message = f"initial: expected a finite number for each of the {len(model.A)} states, got shape {x0.shape}"
        raise AnalysisError(message)
    return x0


def from_zero(time: Array) -> tuple[Array, slice]:
    """The times with zero before them, from which the motion starts, and where they are in the result."""
    return (time, slice(0, None)) if time[0] == 0.0 else (np.concatenate([[0.0], time]), slice(1, None))


def step_response(
    model: LinearModel, source: str, time: ArrayLike | None = None, *, amplitude: float = 1.0
) -> TimeResponse:
    """Response from rest to an input that is *amplitude* from t = 0 on; exact.

    Raises
    ------
    AnalysisError
        For an unknown input, or times that do not rise from zero or later.
    """
    column = input_index(model, source)
    t, own = from_zero(checked_time(model, time))
    u = np.zeros((len(t), len(model.inputs)))
    u[:, column] = amplitude
    x = march(model.A, model.B, held(u.shape[1]), t, u, np.zeros(len(model.A)))
    what = f"step of {source}, {amplitude:g} {model.input_units[column]}"
    return finished(model, t[own], u[own], x[own], what)


def impulse_response(
    model: LinearModel, source: str, time: ArrayLike | None = None, *, amplitude: float = 1.0
) -> TimeResponse:
    """Response from rest to an impulse of an input at t = 0, of area *amplitude* [input's unit times s]; exact.

    At t = 0 the outputs just after the impulse are told; the impulse that passes through D stands in ``delta``.

    Raises
    ------
    AnalysisError
        As `step_response`.
    """
    column = input_index(model, source)
    t, own = from_zero(checked_time(model, time))
    u = np.zeros((len(t), len(model.inputs)))
    x = march(model.A, model.B, held(u.shape[1]), t, u, amplitude * model.B[:, column])
    what = f"impulse of {source}, {amplitude:g} {model.input_units[column]} s"
    return finished(model, t[own], u[own], x[own], what, amplitude * model.D[:, column])


def sine_response(
    model: LinearModel,
    source: str,
    frequency: float,
    time: ArrayLike | None = None,
    *,
    amplitude: float = 1.0,
    start: float = 0.0,
    cycles: int = 1,
    initial: ArrayLike | None = None,
) -> TimeResponse:
    """Response to whole cycles of a sine of an input, from *start* [s] on; exact at any times.

    Parameters
    ----------
    model : LinearModel
    source : str
        The input; zero before and after its cycles.
    frequency : float
        [Hz]
    time : array_like, optional
        Times to tell [s]; they need hold neither the start nor the end of the sine.
    amplitude : float
        In the input's unit.
    start : float
        [s]
    cycles : int
    initial : array_like, optional
        State at t = 0; rest by default.

    Raises
    ------
    AnalysisError
        For an unknown input, a frequency or number of cycles that is not positive, a start before zero, times that do
        not rise.
    """
    column = input_index(model, source)
    if not (np.isfinite(frequency) and frequency > 0.0 and cycles >= 1 and start >= 0.0):
        message = f"sine of {cycles} cycles at {frequency:g} Hz from {start:g} s: expected all positive, start >= 0"
        raise AnalysisError(message)
    end = start + cycles / frequency
    default = time_grid(model)
    told = checked_time(model, np.linspace(0.0, end + default[-1], len(default)) if time is None else time)
    t = np.unique(np.concatenate([[0.0, start, end], told]))
    angle = 2.0 * np.pi * frequency * (t - start)
    active = (t >= start) & (t < end)
    xi = np.where(active, amplitude * np.array([np.sin(angle), np.cos(angle)]), 0.0).T
    x0 = initial_state(model, initial)
    x = march(model.A, model.B, sine(len(model.inputs), column, frequency), t, xi, x0)
    u = np.zeros((len(t), len(model.inputs)))
    u[:, column] = xi[:, 0]
    own = np.searchsorted(t, told)
    unit = model.input_units[column]
    what = f"{cycles} cycle{'s' if cycles > 1 else ''} of {source}, {amplitude:g} {unit}, {frequency:g} Hz"
    return finished(model, t[own], u[own], x[own], what)


def forced_response(
    model: LinearModel,
    time: ArrayLike,
    inputs: Mapping[str, Signal],
    *,
    between: Literal["linear", "constant"] = "linear",
    initial: ArrayLike | None = None,
) -> TimeResponse:
    """Response to inputs given at samples, from the first sample on.

    Parameters
    ----------
    model : LinearModel
    time : array_like
        Samples [s], rising, evenly spaced or not.
    inputs : mapping
        By input: its values at the samples, or a function that gives them for an array of times. Others are zero.
    between : str
        How inputs run from sample to sample: ``"linear"`` straight, ``"constant"`` held until the next sample. For
        such inputs the response is exact; one that runs otherwise is replaced by this, so choose samples to follow it.
    initial : array_like, optional
        State at the first sample; rest by default.

    Raises
    ------
    AnalysisError
        For unknown inputs, values that are not one finite number a sample, times that do not rise; all at once.
    """
    t = np.asarray(time, dtype=float)
    mistakes = [unknown("input", name, model.inputs) for name in inputs if name not in model.inputs]
    if t.ndim != 1 or not t.size or not np.all(np.isfinite(t)) or np.any(np.diff(t) <= 0.0):
        mistakes.append("times: expected finite numbers in s, each larger than the one before")
    u = np.zeros((t.size, len(model.inputs)))
    for name, signal in inputs.items():
        values = np.asarray(signal(t) if callable(signal) else signal, dtype=float)
        if values.shape not in {t.shape, ()} or not np.all(np.isfinite(values)):
            mistakes.append(f"input {name}: expected a finite number for each of the {t.size} samples")
        elif name in model.inputs:
            u[:, model.inputs.index(name)] = values
    if between not in {"linear", "constant"}:
        mistakes.append(f"between: expected 'linear' or 'constant', got '{between}'")
    if mistakes:
        raise AnalysisError("\n".join(mistakes))
    drive, starts = held(u.shape[1]), u[:-1]
    if between == "linear":
        drive, starts = straight(u.shape[1]), np.hstack([u[:-1], np.diff(u, axis=0) / np.diff(t)[:, np.newaxis]])
    x0 = initial_state(model, initial)
    return finished(model, t, u, march(model.A, model.B, drive, t - t[0], starts, x0), "given inputs")
