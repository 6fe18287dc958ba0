"""Speed of simulations of the 29-DOF B-train: ``python tools/simulation_speed.py``.

Times are the best of several rounds, on one core but where said; "x" is simulated time over time on the clock. Carry
over ratios: all are measured in one run, on whatever machine this is.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

import eom
from eom.model.tyre import build_tyre_model
from eom.program.compiled import without_compiler
from eom.report.table import table
from eom.simulation import Case, Sine, simulate_many

FILE = Path(__file__).parents[1] / "vehicles" / "b_train.yaml"
DURATION, ROUNDS, CASES = 10.0, 5, 1024
UNITS = ("tractor", "semitrailer_1", "semitrailer_2")
HIGHWAY = 110.0 / 3.6
STEER = {"axle_1.steer": Sine(np.radians(1.79), 0.4, 0.5)}
FIRST = """
import time, numpy as np, eom
from eom.simulation import Sine
model = eom.build(eom.load({file!r}))
model.trim()
start = time.perf_counter()
eom.simulate(model, {{"axle_1.steer": Sine(0.03, 0.4)}}, 1.0)
print(time.perf_counter() - start)
"""


def best(call: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Seconds of a call, the best round."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


class Driver:
    """Steers to a line by place and heading, 100 times a second."""

    name, period = "driver", 0.01
    inputs, outputs, units = ("tractor.y", "tractor.yaw"), ("steer",), ("rad",)

    def reset(self) -> None:
        """Nothing is remembered."""

    def update(self, t: float, y: np.ndarray) -> np.ndarray:
        """The steer angle [rad] towards a line 3 m to the left from 1 s on."""
        return np.array([0.02 * ((3.0 if t > 1.0 else 0.0) - y[0]) - 0.4 * y[1]])


def errors(run: eom.Run, reference: eom.Run) -> tuple[float, float]:
    """Largest error of the units' paths [m], and of the last unit's lateral acceleration over its largest value."""
    path = max(float(np.max(np.abs(run.of(f"{u}.{c}") - reference.of(f"{u}.{c}")))) for u in UNITS for c in "xy")
    ay = reference.of(f"{UNITS[-1]}.ay")
    return path, float(np.max(np.abs(run.of(f"{UNITS[-1]}.ay") - ay)) / np.max(np.abs(ay)))


def single_runs(model: eom.TyreModel) -> None:
    """Lane changes by several methods at several speeds."""
    rows = []
    for speed, method, step in (
        (HIGHWAY, "rk4", 1e-3),
        (HIGHWAY, "rk4", 5e-3),
        (HIGHWAY, "automatic", None),
        (2.0, "automatic", None),
        (0.6, "automatic", None),
    ):
        reference = eom.simulate(model, STEER, DURATION, speed=speed, tolerance=1e-12, method="dormand_prince")

        def again(speed: float = speed, method: str = method, step: float | None = step) -> eom.Run:
            """The run, from its request to its results."""
            return eom.simulate(model, STEER, DURATION, speed=speed, method=method, step=step)

        run = again()
        wall = best(again)
        path, ay = errors(run, reference)
        label = method if step is None else f"{method}, {1e3 * step:g} ms"
        rows.append(
            (f"{speed:.3g} m/s", label, f"{1e3 * wall:.1f}", f"{DURATION / wall:.0f} x", f"{path:.0e}", f"{ay:.0e}")
        )
    print(table(("speed", "method", "time [ms]", "", "path error [m]", "error of ay"), rows), end="\n\n")


def against_lsoda(model: eom.TyreModel) -> None:
    """The same lane change by SciPy's LSODA on NumPy's right-hand side."""
    x, u = model.trim()
    place = model.inputs.index("axle_1.steer")

    def rates(t: float, x: np.ndarray) -> np.ndarray:
        """With the steer angle of the moment."""
        now = u.copy()
        now[place] = np.radians(1.79) * np.sin(0.8 * np.pi * (t - 0.5)) if 0.5 < t < 3.0 else 0.0
        return model.rhs(t, x, now)

    def lsoda() -> None:
        """States at the samples alone."""
        solve_ivp(rates, (0.0, DURATION), x, method="LSODA", rtol=1e-6, atol=1e-7, max_step=0.1)

    own, other = best(lambda: eom.simulate(model, STEER, DURATION)), best(lsoda, 1)
    print(
        f"LSODA on the NumPy right-hand side {other:.2f} s, automatic with all outputs {own:.3f} s: 1/{other / own:.0f}"
    )


def with_driver(model: eom.TyreModel) -> None:
    """A driver in Python at 100 Hz."""
    wires = {"axle_1.steer": "driver.steer"}
    wall = best(lambda: eom.simulate(model, {}, DURATION, blocks=[Driver()], wires=wires))
    print(f"Python driver at 100 Hz {1e3 * wall:.0f} ms: {DURATION / wall:.0f} x\n")


def batches(model: eom.TyreModel) -> None:
    """Cases of other steer angles and frequencies."""
    rng = np.random.default_rng(1)
    cases = [
        Case({"axle_1.steer": Sine(float(np.radians(angle)), float(frequency), 0.5)})
        for angle, frequency in zip(rng.uniform(0.5, 2.0, CASES), rng.uniform(0.2, 0.6, CASES), strict=True)
    ]
    rows, alone = [], 0.0
    for label, count, method, step, threads in (
        ("numba, automatic", CASES, "automatic", None, 1),
        ("numba, rk4 of 10 ms", CASES, "rk4", 0.01, 1),
        ("numba, rk4 of 10 ms, two cores", CASES, "rk4", 0.01, 2),
        ("NumPy alone, rk4 of 16 ms", CASES, "rk4", 0.016, 1),
    ):

        def run(count: int = count, method: str = method, step: float | None = step, threads: int = threads) -> None:
            """All cases, one signal kept."""
            keep = ["semitrailer_2.ay"]
            simulate_many(
                model, cases[:count], DURATION, keep=keep, sample=0.05, method=method, step=step, threads=threads
            )

        if label.startswith("NumPy"):
            with without_compiler():
                wall = best(run, 1)
        else:
            wall = best(run, 2)
        speed = count * DURATION / wall
        alone = speed if label == "numba, rk4 of 10 ms" else alone
        more = f"{speed / alone:.2f} of one" if threads == 2 else ""
        rows.append((label, str(count), f"{wall:.1f}", f"{speed:.0f}", more))
    print(table(("batch", "cases", "time [s]", "simulated s per s", ""), rows), end="\n\n")


def first_use() -> None:
    """The first run in a new environment, and in a new process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", FIRST.format(file=str(FILE))]
        environment = dict(os.environ, EOM_CACHE=folder)
        times = []
        for _ in range(2):
            found = subprocess.run(command, env=environment, capture_output=True, check=True)  # noqa: S603
            times.append(float(found.stdout))
    print(f"first run in a new environment {times[0]:.1f} s, in a new process {times[1]:.2f} s")


def main() -> None:
    """Print everything."""
    model = build_tyre_model(eom.load(FILE, U="110 km/h"))
    x, u = model.trim()
    ready = model.program
    ready.results(x, u, 0)
    in_numpy = best(lambda: [model.rhs(0.0, x, u) for _ in range(100)]) / 100
    called = best(lambda: [ready.results(x, u, 0) for _ in range(1000)]) / 1000
    print(f"rates: NumPy {1e6 * in_numpy:.0f} us, compiled, called from Python {1e6 * called:.1f} us\n")
    single_runs(model)
    against_lsoda(model)
    with_driver(model)
    batches(model)
    first_use()


if __name__ == "__main__":
    main()
