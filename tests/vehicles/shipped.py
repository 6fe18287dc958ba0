"""The vehicle files that ship with the project, for tests over all of them."""

from pathlib import Path

import eom

FOLDER = Path(__file__).parents[2] / "vehicles"
NAMES = sorted(path.stem for path in FOLDER.glob("*.yaml"))
WHEELED = (
    "a_train_double",
    "b_train",
    "b_train_yaw_plane_nonlinear",
    "car",
    "tractor_semitrailer",
    "tractor_semitrailer_nonlinear",
)
"""Vehicles with wheels: nonlinear tyres and a free speed."""
LINEAR = [name for name in NAMES if name not in WHEELED]
TRAINS = ("tractor_semitrailer_yaw_plane", "b_train_yaw_plane", "b_train_yaw_roll")


def vehicle(name: str, **overrides: str | float) -> eom.Vehicle:
    """A shipped vehicle, some parameters overridden."""
    return eom.load(FOLDER / f"{name}.yaml", **overrides)


def text(name: str) -> str:
    """A shipped vehicle's file."""
    return (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
