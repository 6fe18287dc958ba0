"""How long a user waits for the commands, as multiples of starting Python itself on the same machine.

Usage: python tools/startup_time.py
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

VEHICLE = Path(__file__).parents[1] / "vehicles" / "b_train_yaw_roll.yaml"
REPEATS = 5


def best(command: list[str]) -> float:
    """Shortest wall-clock time of several runs [s], after one that warms the caches."""
    times = []
    for _ in range(REPEATS + 1):
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)  # noqa: S603
        times.append(time.perf_counter() - start)
    return min(times[1:])


def main() -> None:
    """Print a table."""
    eom = str(Path(sys.executable).parent / "eom")
    base = best([sys.executable, "-c", "pass"])
    print(f"{'python':22s} {base:6.3f} s")
    with tempfile.TemporaryDirectory() as folder:
        for arguments in (["--help"], ["check", str(VEHICLE)], ["build", str(VEHICLE), "--out", folder]):
            seconds = best([eom, *arguments])
            print(f"eom {arguments[0]:18s} {seconds:6.3f} s  {seconds / base:5.1f} times python")


if __name__ == "__main__":
    main()
