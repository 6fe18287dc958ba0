"""Time of the B-train's right-hand side, in NumPy and compiled: ``python tools/model_speed.py``.

Beside a call from Python stands one in a compiled loop, as an integrator calls it. All numbers are best of several
rounds in one run: carry over the ratios.
"""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import numpy as np

import eom
from eom.model.tyre import build_tyre_model
from eom.splice.compiled import compile_rates

FILE = Path(__file__).parents[1] / "vehicles" / "b_train.yaml"
ROUNDS = 7


def best(call: Callable[[], object], repeats: int) -> float:
    """Microseconds of a call, the best round's mean."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(repeats):
            call()
        times.append((time.perf_counter() - start) / repeats)
    return 1e6 * min(times)


def main() -> None:
    """Print the table."""
    model = build_tyre_model(eom.load(FILE))
    x, u = model.trim()
    x, u = x + 1e-3, u + 1e-3
    start = time.perf_counter()
    rates, numbers = compile_rates(model.numbers)
    rates(x, u, numbers)
    compilation = time.perf_counter() - start
    count = 1000

    def loop(x: Any, u: Any, numbers: Any) -> float:
        total = 0.0
        for _ in range(count):
            # each evaluation depends on the one before: none can be left out
            total += 1e-12 * rates(x, u, numbers)[0]
            x[0] += total
        return total

    compiled_loop = numba.njit(loop)
    compiled_loop(x.copy(), u, numbers)
    in_numpy = best(lambda: model.rhs(0.0, x, u), 100)
    called = best(lambda: rates(x, u, numbers), 1000)
    looped = best(lambda: compiled_loop(x.copy(), u, numbers), 1) / count
    print(f"{len(x)} states, microseconds; numba {numba.__version__}, numpy {np.__version__}")
    print(f"NumPy {in_numpy:.0f}, compiled {called:.1f} from Python (1/{in_numpy / called:.0f}), ", end="")
    print(f"{looped:.1f} in a loop (1/{in_numpy / looped:.0f}); compilation {compilation:.0f} s")


if __name__ == "__main__":
    main()
