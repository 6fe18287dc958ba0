"""The single lane change of S. Zhu's thesis (figures 3.11 to 3.15, 3.20, 3.21), nonlinear models and linear twins.

Run from the project's folder: ``python tools/lane_change.py [PICTURE.png]``. One cycle of 0.4 Hz at the tractor's front
axle at 110 km/h, of 1.79 and of 3.58 deg.
"""

import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

import eom
from eom.model.tyre import build_tyre_model
from eom.report.table import table

FOLDER = Path(__file__).parents[1] / "vehicles"
UNITS = ("tractor", "semitrailer_1", "semitrailer_2")
AMPLITUDES = (1.79, 3.58)
MODELS = (
    ("29 DOF, f_r = 0", "b_train", {"f_r": 0.0}),
    ("29 DOF, f_r = 0.02", "b_train", {}),
    ("yaw plane", "b_train_yaw_plane_nonlinear", {}),
)
G, FREQUENCY, START, DURATION, STEP = 9.8, 0.4, 0.5, 7.0, 0.02


class Course(NamedTuple):
    """A run: instants [s], outputs by name, and what was reached first at which instant."""

    t: np.ndarray
    y: dict[str, np.ndarray]
    reached: dict[str, float]


def steer(t: float, amplitude: float) -> float:
    """One cycle of a sine [rad], of an amplitude in degrees."""
    cycle = (t - START) * FREQUENCY
    return float(np.radians(amplitude) * np.sin(2.0 * np.pi * cycle)) if 0.0 < cycle < 1.0 else 0.0


def nonlinear(model: eom.TyreModel, amplitude: float) -> Course:
    """The nonlinear model from its trim on."""
    x0, u0 = model.trim()
    at = model.inputs.index("axle_1.steer")

    def inputs(t: float) -> np.ndarray:
        """Inputs at an instant."""
        u = u0.copy()
        u[at] = steer(t, amplitude)
        return u

    run = solve_ivp(lambda t, x: model.rhs(t, x, inputs(t)), (0.0, DURATION), x0, rtol=1e-6, atol=1e-7, max_step=STEP)
    values = np.array([model.output(t, x, inputs(t)) for t, x in zip(run.t, run.y.T, strict=True)])
    reached: dict[str, float] = {}
    for t, x in zip(run.t, run.y.T, strict=True):
        for limit in model.reached(x, inputs(t)):
            reached.setdefault(f"{limit.owner}: {limit.sentence}", float(t))
    return Course(run.t, dict(zip(model.outputs, values.T, strict=True)), reached)


def linear(model: eom.LinearModel, amplitude: float) -> Course:
    """The linear twin."""
    B, D = (matrix[:, model.inputs.index("axle_1.steer")] for matrix in (model.B, model.D))
    start = np.zeros(len(model.A))
    run = solve_ivp(
        lambda t, x: model.A @ x + B * steer(t, amplitude), (0.0, DURATION), start, rtol=1e-6, atol=1e-8, max_step=STEP
    )
    values = run.y.T @ model.C.T + np.outer([steer(t, amplitude) for t in run.t], D)
    return Course(run.t, dict(zip(model.outputs, values.T, strict=True)), {})


def peaks(course: Course) -> list[float]:
    """Largest lateral acceleration of each unit [g]."""
    return [float(np.max(np.abs(course.y[f"{unit}.ay"]))) / G for unit in UNITS]


def main() -> None:
    """Run everything, print peaks and what lifts, and draw the picture if one is asked for."""
    courses = {}
    for amplitude in AMPLITUDES:
        rows = []
        for label, name, values in MODELS:
            vehicle = eom.load(FOLDER / f"{name}.yaml", U="110 km/h", **values)
            model = build_tyre_model(vehicle)
            pair = nonlinear(model, amplitude), linear(eom.linearise(vehicle), amplitude)
            courses[amplitude, label] = pair
            found, twin = map(peaks, pair)
            lost = [100.0 * (own / other - 1.0) for own, other in zip(found, twin, strict=True)]
            rows.append((label, *(f"{p:.3f} {q:.3f} {r:+.1f} %" for p, q, r in zip(found, twin, lost, strict=True))))
        print(f"steer of {amplitude} deg: peak lateral acceleration [g], nonlinear, linear, difference")
        print(table(("model", *UNITS), rows), end="\n\n")
    for sentence, t in courses[3.58, MODELS[1][0]][0].reached.items():
        print(f"{t:6.2f} s  {sentence}")
    if len(sys.argv) > 1:
        draw(courses, Path(sys.argv[1]))


def draw(courses: dict[tuple[float, str], tuple[Course, Course]], path: Path) -> None:
    """Lateral accelerations at both amplitudes, and wheel loads and rolls at the higher one."""
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    figure = Figure(figsize=(9.0, 6.4), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True)
    label = MODELS[1][0]
    for panel, amplitude in zip(panels[0], AMPLITUDES, strict=True):
        own, twin = courses[amplitude, label]
        for k, unit in enumerate(UNITS):
            panel.plot(own.t, own.y[f"{unit}.ay"] / G, color=f"C{k}", label=unit)
            panel.plot(twin.t, twin.y[f"{unit}.ay"] / G, color=f"C{k}", linestyle=":")
        panel.set_title(f"steer {amplitude} deg", fontsize=10)
        panel.set_ylabel("lateral acceleration [g]")
    panels[0, 0].plot([], [], color="0.3", linestyle=":", label="linear")
    panels[0, 0].legend(fontsize=8, frameon=False)
    course, _ = courses[AMPLITUDES[1], label]
    for axle, color in (("axle_1", "C0"), ("axle_4", "C1"), ("axle_7", "C2")):
        panels[1, 0].plot(course.t, course.y[f"{axle}.left.Fz"] / 1e3, color=color, label=f"{axle}.left")
        panels[1, 0].plot(
            course.t, course.y[f"{axle}.right.Fz"] / 1e3, color=color, linestyle="--", label=f"{axle}.right"
        )
    panels[1, 0].set_ylabel("wheel load [kN], 3.58 deg")
    panels[1, 0].set_ylim(-3.0, 75.0)
    panels[1, 0].legend(fontsize=8, frameon=False, ncols=3)
    for k, unit in enumerate(UNITS):
        panels[1, 1].plot(course.t, np.degrees(course.y[f"{unit}_frame.roll"]), color=f"C{k}", label=f"{unit}_frame")
    panels[1, 1].set_ylabel("roll [deg], 3.58 deg")
    for panel in panels[1]:
        panel.set_xlabel("time [s]")
    for panel in panels.flat:
        panel.grid(alpha=0.3)
        panel.margins(x=0.0)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    main()
