"""Cost of a sweep: modes, tracked branches and a frequency response of a B-train at many speeds.

    python tools/sweep_speed.py [--speeds 100] [--frequencies 100]

Each time is also given as a multiple of one `eom.load` and `eom.linearise` on the same machine in the same run.
"""

import argparse
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numpy as np

import eom
from eom.analysis.family import family_of, nodes_at
from eom.analysis.locus import locus_of

VEHICLE = Path(__file__).parents[1] / "vehicles" / "b_train_yaw_roll.yaml"
Result = TypeVar("Result")


def timed(action: Callable[[], Result]) -> tuple[float, Result]:
    """Seconds that an action takes, and what it gives."""
    start = time.perf_counter()
    result = action()
    return time.perf_counter() - start, result


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--speeds", type=int, default=100)
    parser.add_argument("--frequencies", type=int, default=100)
    arguments = parser.parse_args()
    speeds = np.linspace(20.0, 150.0, arguments.speeds).tolist()
    frequencies = np.linspace(0.05, 5.0, arguments.frequencies)

    vehicle = eom.load(VEHICLE)
    family = family_of(vehicle, "U", "km/h")
    locus_of(family, nodes_at(family, speeds[:3]))  # imports what is slow to import
    unit = min(timed(lambda: eom.linearise(eom.load(VEHICLE)))[0] for _ in range(5))

    models, nodes = timed(lambda: nodes_at(family, speeds))
    modes, _ = timed(lambda: [node.modes for node in nodes])
    tracking, _ = timed(lambda: locus_of(family, nodes))
    responses, _ = timed(lambda: [node.model.frequency_response(frequencies) for node in nodes])
    print(f"{arguments.speeds} speeds, {arguments.frequencies} frequencies, {len(nodes[0].model.states)} states")
    parts = {"models": models, "modes": modes, "tracking": tracking, "frequency responses": responses}
    for name, seconds in {"load and linearise once": unit, **parts, "sweep": sum(parts.values())}.items():
        print(f"{name:24} {seconds:7.3f} s {seconds / unit:7.1f} times one load and linearise")


if __name__ == "__main__":
    main()
