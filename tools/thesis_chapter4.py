"""The linear results of chapter 4 of S. Zhu's thesis, printed beside those of the generated model.

Usage: python tools/thesis_chapter4.py

The vehicle is `vehicles/tractor_semitrailer_yaw_plane.yaml` at 150 km/h: the chapter's tables fit no other speed, as
its gains of 7.48 g/rad near zero frequency show (88 km/h gives 5.76).
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

import eom
from eom.analysis import frequency_response, sine_response
from eom.assembly.vectors import Array
from eom.report.table import table

VEHICLE = Path(__file__).parents[1] / "vehicles" / "tractor_semitrailer_yaw_plane.yaml"
SPEED = "150 km/h"
G = 9.8  # m/s^2, as the thesis counts
STEER, TRACTOR, TRAILER = "axle_1.steer", "tractor.ay", "semitrailer.ay"
UNITS = (TRACTOR, TRAILER)
SAMPLES = 2001  # a cycle; the correlation's error is 1e-6 of the amplitude

TABLE_4_4 = {1.51: (0.115, 0.075), 2.51: (-0.035, -0.101), 3.51: (0.0, 0.012), 4.51: (0.001, 0.002)}
"""Lateral acceleration [g] of tractor and trailer by time [s], one sine of 0.8 Hz and 1.5 deg from 1 s on."""
TABLE_4_5 = {0.06: (7.478, 7.481), 0.41: (6.958, 8.755), 0.81: (4.545, 3.138)}
"""Gains [g/rad] of tractor and trailer by printed frequency [Hz], linear model."""
TABLE_4_6 = {0.1: 1.023, 0.4: 1.189, 0.8: 0.842}
"""Rearward amplification by frequency [Hz] of a single sine."""
TABLE_4_6_AFRM = {0.1: 1.013, 0.4: 1.229, 0.8: 0.763}
TABLE_4_2_AFRM = {0.2: 1.060, 0.8: 0.758}
TABLE_4_2 = {0.2: 1.068, 0.8: 0.724}
"""Rearward amplification by the transfer functions; the table's other row is by the measuring technique."""
STIFFER = {"rear.cornering": 1.15, "trailer.cornering": 1.29}
"""Factors on the tyres of the tractor's rear axle and of the trailer with which Table 4.2 would come out."""


FINE = np.array([0.01 * k for k in range(1, 101)])
"""Frequencies of the fine sweep [Hz]."""


class Row(NamedTuple):
    """A printed value and ours."""

    what: str
    printed: float
    ours: float


def model(speed: str = SPEED, factors: Mapping[str, float] = MappingProxyType({})) -> eom.LinearModel:
    """The linear model at a speed, some parameters multiplied by factors."""
    vehicle = eom.load(VEHICLE, U=speed)
    return eom.linearise(
        vehicle.with_values(U=speed, **{name: vehicle.values[name] * f for name, f in factors.items()})
    )


def single_sine(linear: eom.LinearModel, frequency: float, time: Array | Sequence[float], start: float = 0.0) -> Array:
    """Lateral accelerations [g] of tractor and trailer at times [s], shape (times, 2): one sine of 1.5 deg."""
    response = sine_response(linear, STEER, frequency, time, amplitude=float(np.deg2rad(1.5)), start=start)
    return np.stack([response.of(unit) for unit in UNITS], axis=1) / G


def table_4_4() -> list[Row]:
    """Table 4.4, linear model."""
    found = single_sine(model(), 0.8, list(TABLE_4_4), start=1.0)
    return [
        Row(f"{unit} at {time} s", printed[k], float(found[j, k]))
        for j, (time, printed) in enumerate(TABLE_4_4.items())
        for k, unit in enumerate(("tractor", "trailer"))
    ]


def measured_response(linear: eom.LinearModel, frequencies: Array) -> Array:
    """Gains [g/rad] as the thesis's measuring technique (AFRM) gets them, shape (frequencies, 2).

    One cycle of sine at each frequency, the vehicle's state carried over from one to the next; the output is
    correlated over the cycle with sine and cosine of the same frequency (equations 4.1 and 4.2).
    """
    state, gains = np.zeros(len(linear.A)), []
    for f in frequencies:
        t = np.linspace(0.0, 1.0 / f, SAMPLES)
        response = sine_response(linear, STEER, f, t, initial=state)
        state = response.states[-1]
        wave = np.exp(-2j * np.pi * f * t)
        gains.append([abs(np.trapezoid(response.of(unit) * wave, t)) * 2.0 * f / G for unit in UNITS])
    return np.array(gains)


def table_4_5(late: int = 1) -> list[Row]:
    """Table 4.5, linear model: gains measured from 0.01 Hz in steps of 0.05 Hz, told *late* steps after their own.

    Equation 4.2 shows a gain while the next sine already runs, so that the table's labels are one step late.
    """
    sweep = np.array([0.01 + 0.05 * k for k in range(20)])
    gains = measured_response(model(), sweep)
    return [
        Row(f"{unit} at '{label} Hz', measured at {sweep[j]:.2f} Hz", printed[k], float(gains[j, k]))
        for label, printed in TABLE_4_5.items()
        for j in [int(np.argmin(np.abs(sweep - label))) - late]
        for k, unit in enumerate(("tractor", "trailer"))
    ]


def gains_at_labels() -> list[Row]:
    """Table 4.5's rows against the transfer functions at the frequencies of its labels."""
    found = frequency_response(model(), STEER, UNITS, list(TABLE_4_5)).magnitude / G
    return [
        Row(f"{unit} at {label} Hz, transfer function", printed[k], float(found[j, k]))
        for j, (label, printed) in enumerate(TABLE_4_5.items())
        for k, unit in enumerate(("tractor", "trailer"))
    ]


def largest(y: Array) -> float:
    """Largest magnitude."""
    return float(np.max(np.abs(y)))


def first_peak(y: Array) -> float:
    """The first extreme value."""
    turns = np.flatnonzero(np.diff(np.sign(np.diff(y))) != 0.0)
    return float(abs(y[turns[0] + 1]))


READINGS: dict[str, Callable[[Array], float]] = {
    "peak": largest,
    "peak to peak": lambda y: float(np.ptp(y)),
    "first peak": first_peak,
}
"""How an amplitude may be read from a transient."""
READ = {0.1: "peak", 0.4: "peak to peak", 0.8: "first peak"}
"""The reading that comes nearest to Table 4.6, which differs from frequency to frequency."""


def amplification(linear: eom.LinearModel, frequency: float, reading: str) -> float:
    """Rearward amplification of one sine of steer, amplitudes read in one of the ways."""
    y = single_sine(linear, frequency, np.linspace(0.0, 1.0 / frequency + 6.0, 20 * SAMPLES))
    return READINGS[reading](y[:, 1]) / READINGS[reading](y[:, 0])


def table_4_6() -> list[Row]:
    """Table 4.6, single sine, each frequency by the reading that comes nearest."""
    linear = model()
    return [
        Row(f"at {f} Hz, {READ[f]}", printed, amplification(linear, f, READ[f])) for f, printed in TABLE_4_6.items()
    ]


def ratios(linear: eom.LinearModel, frequencies: Sequence[float]) -> Array:
    """Rearward amplification by the transfer functions."""
    return frequency_response(linear, STEER, [f"{TRAILER}/{TRACTOR}"], frequencies).magnitude[:, 0]


def table_4_2(linear: eom.LinearModel) -> list[Row]:
    """Table 4.2 by transfer functions."""
    found = ratios(linear, list(TABLE_4_2))
    return [
        Row(f"at {f} Hz, transfer function", printed, float(ours))
        for (f, printed), ours in zip(TABLE_4_2.items(), found, strict=True)
    ]


def nearest_speed() -> tuple[float, float]:
    """The speed [km/h] from 20 to 200 at which Table 4.2 is least wrong, and its larger relative error there."""
    misses = {
        speed: max(abs(row.ours / row.printed - 1.0) for row in table_4_2(model(f"{speed} km/h")))
        for speed in range(20, 201, 5)
    }
    best = min(misses, key=lambda speed: misses[speed])
    return float(best), misses[best]


def measured_ratios(linear: eom.LinearModel) -> Array:
    """Amplifications by the measuring technique at `FINE`."""
    gains = measured_response(linear, FINE)
    return np.asarray(gains[:, 1] / gains[:, 0])


def measured_rows(linear: eom.LinearModel) -> list[Row]:
    """The measured rows of Tables 4.2 and 4.6, labels one step late."""
    measured = measured_ratios(linear)
    rows = []
    for f, printed in (*TABLE_4_2_AFRM.items(), *TABLE_4_6_AFRM.items()):
        own = int(np.argmin(np.abs(FINE - f))) - 1
        rows.append(Row(f"at '{f} Hz', measured at {FINE[own]:.2f} Hz", printed, float(measured[own])))
    return rows


def error_of_measuring(linear: eom.LinearModel, late: int) -> Array:
    """Relative error [%] of the measured amplification at the frequencies of `FINE` from number *late* on."""
    measured, exact = measured_ratios(linear), ratios(linear, FINE.tolist())
    return np.asarray(100.0 * (measured[: len(FINE) - late] / exact[late:] - 1.0))


def worst(linear: eom.LinearModel, late: int) -> str:
    """The largest error of measuring, in words."""
    error = error_of_measuring(linear, late)
    k = int(np.argmax(np.abs(error)))
    return f"largest error of measuring, labels {late} late: {error[k]:+.2f} % at {FINE[k + late]:.2f} Hz"


def shown(title: str, rows: Sequence[Row]) -> str:
    """A table of printed and own values."""
    lines = ((row.what, f"{row.printed:.3f}", f"{row.ours:.4f}", f"{row.ours - row.printed:+.4f}") for row in rows)
    return f"{title}\n{table(('', 'thesis', 'eom', 'difference'), lines)}"


def report() -> Iterator[str]:
    """All tables as text."""
    linear, stiffer = model(), model(factors=STIFFER)
    speed, miss = nearest_speed()
    factors = ", ".join(f"{name} x {factor}" for name, factor in STIFFER.items())
    yield shown("Table 4.4, lateral acceleration [g], one sine of 0.8 Hz: reproduced", table_4_4())
    yield shown("Table 4.5, gains [g/rad] measured by one cycle each, labels one step late: reproduced", table_4_5())
    yield shown("The same against transfer functions at its labels: not what was printed", gains_at_labels())
    yield shown("Table 4.6, amplification of a single sine: each value by another reading", table_4_6())
    yield shown("Table 4.2, amplification by transfer functions: not reproduced", table_4_2(linear))
    yield f"no speed from 20 to 200 km/h gives Table 4.2: the nearest, {speed:g} km/h, is off by {100.0 * miss:.0f} %"
    yield shown("Tables 4.2 and 4.6, amplification as measured: not reproduced", measured_rows(linear))
    yield f"{worst(linear, 1)}\n{worst(linear, 0)}\n(thesis: 4.72 % at 0.76 Hz)"
    yield shown(f"Table 4.2 with stiffer tyres ({factors}): nearly", table_4_2(stiffer))
    yield shown("Tables 4.2 and 4.6 as measured, with these tyres: nearly", measured_rows(stiffer))
    yield worst(stiffer, 1)


def main() -> None:
    """Run from the command line."""
    print("\n\n".join(report()))


if __name__ == "__main__":
    main()
