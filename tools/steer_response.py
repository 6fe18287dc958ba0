"""Picture of a train's response to one sine of steer at its front axle, from its generated module.

Usage: python tools/steer_response.py build/b_train_yaw_roll.py picture.png
"""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import matplotlib as mpl
import numpy as np
from scipy.signal import lsim

mpl.use("Agg")
from matplotlib import pyplot as plt

AMPLITUDE, FREQUENCY, START, DURATION = np.deg2rad(1.79), 0.4, 0.5, 8.0
STANDARD_GRAVITY = 9.80665


def load_module(path: Path) -> ModuleType:
    """The generated module at *path*."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        message = f"{path} is no Python module"
        raise SystemExit(message)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def steer(t: np.ndarray) -> np.ndarray:
    """One sine of steer [rad], left first."""
    active = (t >= START) & (t < START + 1.0 / FREQUENCY)
    return np.where(active, AMPLITUDE * np.sin(2.0 * np.pi * FREQUENCY * (t - START)), 0.0)


def plot(module: ModuleType, target: Path) -> None:
    """Steer, lateral acceleration of the units and roll of their sprung bodies over time."""
    model = module.linearise()
    inputs, outputs = ([name for name, _ in labels] for labels in (module.INPUTS, module.OUTPUTS))
    t = np.linspace(0.0, DURATION, 1601)
    u = np.zeros((len(t), len(inputs)))
    u[:, inputs.index("axle_1.steer")] = steer(t)
    _, y, _ = lsim((model.A, model.B, model.C, model.D), u, t)
    panels = [
        ("lateral acceleration [g]", [n for n in outputs if n.endswith(".ay") and n != "axle_1.ay"], STANDARD_GRAVITY),
        ("roll [deg]", [n for n in outputs if n.endswith("_frame.roll")], np.pi / 180.0),
    ]
    panels = [panel for panel in panels if panel[1]]
    figure, axes = plt.subplots(
        1 + len(panels), 1, sharex=True, figsize=(7.5, 2.0 + 2.2 * len(panels)), layout="constrained", squeeze=False
    )
    axes[0, 0].plot(t, np.rad2deg(u[:, inputs.index("axle_1.steer")]), color="0.3")
    axes[0, 0].set_ylabel("steer [deg]")
    speed = f" at {module.PARAMETERS['U'].value * 3.6:.0f} km/h" if "U" in module.PARAMETERS else ""
    axes[0, 0].set_title(f"{module.NAME}{speed}")
    for axis, (label, names, scale) in zip(axes[1:, 0], panels, strict=True):
        for name in names:
            axis.plot(t, y[:, outputs.index(name)] / scale, label=name)
        axis.set_ylabel(label)
        axis.legend(loc="upper right", fontsize="small")
    for axis in axes[:, 0]:
        axis.grid(alpha=0.3)
    axes[-1, 0].set_xlabel("time [s]")
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, dpi=130)
    plt.close(figure)


def main() -> None:
    """Run from the command line."""
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    source, target = map(Path, sys.argv[1:])
    plot(load_module(source), target)
    print(f"picture   {target}")


if __name__ == "__main__":
    main()
