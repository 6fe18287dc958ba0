"""Picture of a lane change of a train with nonlinear tyres, from its generated module; dotted, its linear model.

Usage: python tools/module_lane_change.py build/b_train.py picture.png

One cycle of 0.4 Hz and 3.58 deg at the front axle, at the speed of the file.
"""

import importlib
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import matplotlib as mpl
import numpy as np
from scipy.integrate import solve_ivp

mpl.use("Agg")
from matplotlib import pyplot as plt

AMPLITUDE, FREQUENCY, START, DURATION = np.deg2rad(3.58), 0.4, 0.5, 7.0
STANDARD_GRAVITY = 9.80665
STEP = 0.02


def load_module(path: Path) -> ModuleType:
    """The generated module at *path*."""
    sys.path.insert(0, str(path.resolve().parent))
    return importlib.import_module(path.stem)


def steer(t: float) -> float:
    """One sine of steer [rad], left first."""
    active = START <= t < START + 1.0 / FREQUENCY
    return float(AMPLITUDE * np.sin(2.0 * np.pi * FREQUENCY * (t - START))) if active else 0.0


def steered(module: ModuleType, base: np.ndarray) -> Callable[[float], np.ndarray]:
    """Inputs over time: constant ones and the steer of the front axle."""
    at = [name for name, _ in module.INPUTS].index("axle_1.steer")

    def inputs(t: float) -> np.ndarray:
        """Inputs at an instant."""
        u = base.copy()
        u[at] += steer(t)
        return u

    return inputs


def nonlinear(module: ModuleType) -> tuple[np.ndarray, dict[str, np.ndarray], list[str]]:
    """Instants, outputs by name, and a line for whatever lifts or locks, or is reached, for the first time."""
    run = module.trim()
    inputs = steered(module, run.u)
    found = solve_ivp(
        lambda t, x: module.rhs(t, x, inputs(t)), (0.0, DURATION), run.x, rtol=1e-6, atol=1e-7, max_step=STEP
    )
    values = np.array([module.outputs(t, x, inputs(t)) for t, x in zip(found.t, found.y.T, strict=True)])
    margins = np.array([module.margins(t, x, inputs(t)) for t, x in zip(found.t, found.y.T, strict=True)])
    reached = [
        f"{found.t[np.argmax(margin < 0.0)]:6.2f} s  {limit.owner}: {limit.sentence}"
        for limit, margin in zip(module.LIMITS, margins.T, strict=True)
        if np.any(margin < 0.0)
    ]
    return found.t, dict(zip((name for name, _ in module.OUTPUTS), values.T, strict=True)), sorted(reached)


def linear(module: ModuleType) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Instants and outputs by name of the module's linear model."""
    A, B, C, D = module.linearise()
    inputs = steered(module, np.zeros(B.shape[1]))
    found = solve_ivp(
        lambda t, x: A @ x + B @ inputs(t), (0.0, DURATION), np.zeros(len(A)), rtol=1e-6, atol=1e-8, max_step=STEP
    )
    values = found.y.T @ C.T + np.array([inputs(t) for t in found.t]) @ D.T
    return found.t, dict(zip((name for name, _ in module.LINEAR_OUTPUTS), values.T, strict=True))


def plot(module: ModuleType, target: Path) -> list[str]:
    """Draw lateral accelerations, rolls and wheel loads of the last axle; return what was reached."""
    t, y, reached = nonlinear(module)
    t_linear, y_linear = linear(module)
    axle = [name.removesuffix(".left.Fz") for name in y if name.endswith(".left.Fz")][-1]
    panels = [
        ("lateral acceleration [g]", [n for n in y_linear if n.endswith(".ay") and n != "axle_1.ay"], STANDARD_GRAVITY),
        ("roll [deg]", [n for n in y_linear if n.endswith("_frame.roll")], np.pi / 180.0),
        ("wheel load [kN]", [f"{axle}.left.Fz", f"{axle}.right.Fz"], 1e3),
    ]
    figure, axes = plt.subplots(len(panels), 1, sharex=True, figsize=(7.5, 7.6), layout="constrained")
    for axis, (label, names, scale) in zip(axes, panels, strict=True):
        for k, name in enumerate(names):
            axis.plot(t, y[name] / scale, color=f"C{k}", label=name)
            if name in y_linear:
                axis.plot(t_linear, y_linear[name] / scale, color=f"C{k}", linestyle=":")
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
        axis.margins(x=0.0)
        axis.legend(loc="upper right", fontsize="small")
    axes[0].set_title(f"{module.NAME} at {module.PARAMETERS['U'].value * 3.6:.0f} km/h; dotted: linear")
    axes[-1].set_xlabel("time [s]")
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, dpi=110)
    plt.close(figure)
    return reached


def main() -> None:
    """Run from the command line."""
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    source, target = map(Path, sys.argv[1:])
    for line in plot(load_module(source), target):
        print(line)
    print(f"picture   {target}")


if __name__ == "__main__":
    main()
