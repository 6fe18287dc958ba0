"""How the B-train with wheels differs from the yaw-roll model: what supports, spins and resistance do to its roots.

Run from the project's folder: ``python tools/b_train_roots.py``.
"""

from pathlib import Path

import numpy as np

import eom
from eom.report.table import table

FOLDER = Path(__file__).parents[1] / "vehicles"
LIGHT = {f"axle_{k}.spin_inertia": 1e-4 for k in range(1, 10)}
STEPS: tuple[tuple[str, str, dict[str, float]], ...] = (
    ("yaw-roll: each unit carries its own weight", "b_train_yaw_roll", {}),
    ("weight on axle groups and hitches", "b_train", {"f_r": 0.0, **LIGHT}),
    ("wheels that spin", "b_train", {"f_r": 0.0}),
    ("rolling resistance 0.02, driven", "b_train", {}),
)
PAIRS = 6


def slow_pairs(model: eom.LinearModel) -> np.ndarray:
    """The roots of oscillations that decay slowest, one of each pair, from the least damped on."""
    roots = np.asarray(model.modes().eigenvalues)
    pairs = roots[roots.imag > 0.1]
    order = np.argsort(np.abs(pairs))
    return np.asarray(pairs[order][:PAIRS])


def main() -> None:
    """Print the roots of each step, and how far each step moves them."""
    rows, before = [], None
    for label, name, values in STEPS:
        found = slow_pairs(eom.linearise(eom.load(FOLDER / f"{name}.yaml", U="110 km/h", **values)))
        rows.append((label, *(f"{root.real:.3f} ± {root.imag:.3f}i" for root in found)))
        if before is not None:
            moved = 100.0 * np.abs(found - before) / np.abs(before)
            rows.append(("  moves them by", *(f"{change:.2f} %" for change in moved)))
        before = found
    print("B-train double at 110 km/h, roots [1/s]")
    print(table(("with", *(f"pair {k}" for k in range(1, PAIRS + 1))), rows))


if __name__ == "__main__":
    main()
