"""Responses of linear models as tables and files of numbers."""

import csv
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from eom.analysis.frequency import FrequencyResponse
from eom.analysis.gains import SteadyGains
from eom.analysis.ride import RoadResponse
from eom.analysis.time_response import TimeResponse
from eom.model.linear import LinearModel
from eom.report.table import table

STEPS = (1.0, 2.0, 5.0)
ROUNDING = 1e-12


def shown(value: float) -> str:
    """A value to five digits; ``infinite``, and ``-`` where there is none."""
    if np.isnan(value):
        return "-"
    return f"{value:.5g}" if np.isfinite(value) else "infinite" if value > 0.0 else "-infinite"


def round_values(first: float, last: float) -> list[float]:
    """The numbers 1, 2 and 5 times powers of ten from *first* to *last*, both ends included as they are."""
    powers = range(int(np.floor(np.log10(first))), int(np.ceil(np.log10(last))) + 1)
    inner = [step * 10.0**power for power in powers for step in STEPS]
    return [first, *(value for value in inner if first * (1 + 1e-9) < value < last * (1 - 1e-9)), last]


def formal(stable: bool) -> str:
    """What a heading says about a system that does not settle."""
    return "" if stable else " (formal)"


def heading(model: LinearModel, source: str, stable: bool) -> str:
    """Name, speed, input, and a warning where the vehicle does not settle."""
    speed = f" at {model.speed * 3.6:.5g} km/h" if model.speed else ""
    unit = model.input_units[model.inputs.index(source)]
    warning = (
        ""
        if stable
        else "\nunstable or undamped: the vehicle does not settle, gains and frequency responses are formal"
    )
    return f"{model.name}{speed}: response to {source} [{unit or '-'}]{warning}"


def summary_table(response: FrequencyResponse, gains: SteadyGains | None) -> str:
    """Steady gain, if there is one, and largest magnitude of each channel; a ratio's gain is that of its gains."""
    column = np.full(len(response.model.outputs), np.nan)
    if gains is not None:
        column = gains.values[:, gains.inputs.index(response.source)]
    lines = []
    for item, unit, peak in zip(response.channels, response.units, response.peaks(), strict=True):
        with np.errstate(divide="ignore", invalid="ignore"):
            gain = float(column[item.over] if item.under is None else column[item.over] / column[item.under])
        at = shown(peak.frequency) + ("" if peak.inside else " (end)")
        lines.append((item.name, unit or "-", shown(gain), shown(peak.value), at))
    note = formal(response.stable)
    return table(("output", "unit", f"steady gain{note}", f"largest{note}", "at [Hz]"), lines, 2)


def frequency_tables(response: FrequencyResponse, told: Sequence[float]) -> str:
    """Magnitude and phase of each channel at some of the response's frequencies [Hz], a table each."""
    rows = np.searchsorted(response.frequency, told)
    blocks = []
    phase, decibel = np.rad2deg(response.phase), response.decibel
    for k, (item, unit) in enumerate(zip(response.names, response.units, strict=True)):
        header = ("frequency [Hz]", f"magnitude [{unit or '-'}]", "[dB]", "phase [deg]")
        lines = [
            (shown(f), shown(response.magnitude[j, k]), f"{decibel[j, k]:.2f}", f"{phase[j, k] + 0.0:.1f}")
            for f, j in zip(told, rows, strict=True)
        ]
        blocks.append(f"{item}{formal(response.stable)}\n{table(header, lines, 0)}")
    return "\n\n".join(blocks)


def time_table(response: TimeResponse, outputs: Sequence[str]) -> str:
    """Largest value, its time and the last value of outputs; for a ratio that of the largest magnitudes."""
    lines = []
    for name in outputs:
        over, _, under = name.partition("/")
        values = response.of(over.strip())
        unit = response.model.output_units[response.model.outputs.index(over.strip())]
        best = int(np.argmax(np.abs(values)))
        if under:
            with np.errstate(divide="ignore", invalid="ignore"):
                ratio = float(np.abs(values[best]) / np.max(np.abs(response.of(under.strip()))))
            lines.append((name, "-", shown(ratio), "-", "-"))
        else:
            lines.append((name, unit, shown(values[best]), shown(response.time[best]), shown(values[-1])))
    note = "" if response.stable else " (does not settle)"
    header = ("output", "unit", f"largest{note}", "at [s]", f"at {response.time[-1]:.5g} s{note}")
    return "\n".join([response.what, table(header, lines, 2), *delta_lines(response, outputs)])


def delta_lines(response: TimeResponse, outputs: Sequence[str]) -> Iterator[str]:
    """What impulses pass straight through to outputs, rounding left out."""
    whole = np.max(np.abs(response.outputs), axis=0) * float(response.time[-1])
    model = response.model
    for name, area, unit, size in zip(model.outputs, response.delta, model.output_units, whole, strict=True):
        if name in outputs and abs(area) > ROUNDING * size:
            yield f"besides, {name} has an impulse of {shown(float(area))} {unit} s at t = 0"


def road_table(response: RoadResponse) -> str:
    """RMS values of outputs."""
    first, last = (shown(value) for value in response.band)
    title = (
        f"{response.road} at {response.speed * 3.6:.5g} km/h, {first} to {last} Hz, by {', '.join(response.sources)}"
    )
    lines = (
        (name, unit or "-", shown(float(rms)))
        for name, unit, rms in zip(response.outputs, response.units, response.rms, strict=True)
    )
    return f"{title}\n{table(('output', 'unit', 'RMS'), lines, 2)}"


def write_columns(path: Path, columns: Sequence[tuple[str, np.ndarray]]) -> None:
    """Columns of numbers as CSV, full precision."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([name for name, _ in columns])
        writer.writerows(zip(*([repr(v) for v in values.tolist()] for _, values in columns), strict=True))


def frequency_columns(response: FrequencyResponse) -> list[tuple[str, np.ndarray]]:
    """Frequency, and magnitude and phase of each channel."""
    columns = [("frequency [Hz]", response.frequency)]
    for k, (name, unit) in enumerate(zip(response.names, response.units, strict=True)):
        columns.append((f"{name} magnitude [{unit or '-'}]", response.magnitude[:, k]))
        columns.append((f"{name} phase [rad]", response.phase[:, k]))
    return columns


def time_columns(response: TimeResponse, outputs: Sequence[str]) -> list[tuple[str, np.ndarray]]:
    """Time, the inputs that act, and outputs."""
    model, columns = response.model, [("time [s]", response.time)]
    acting = np.flatnonzero(np.any(response.inputs != 0.0, axis=0))
    columns += [(f"{model.inputs[k]} [{model.input_units[k]}]", response.inputs[:, k]) for k in acting]
    units = dict(zip(model.outputs, model.output_units, strict=True))
    return columns + [(f"{name} [{units[name]}]", response.of(name)) for name in outputs]


def road_columns(response: RoadResponse) -> list[tuple[str, np.ndarray]]:
    """Frequency, and the PSD of each output."""
    columns = [("frequency [Hz]", response.frequency)]
    for name, unit, psd in zip(response.outputs, response.units, response.psd.T, strict=True):
        columns.append((f"{name} PSD [({unit or '-'})^2/Hz]", psd))
    return columns
