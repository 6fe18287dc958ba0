"""Time of 18 tyres, in NumPy and compiled: ``python tools/tyre_speed.py``.

The compiled time is of the formula in a compiled loop, as an integrator calls it; beside it that of one call from
Python. All numbers are best of several rounds in one run: carry over the ratios.
"""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numba
import numpy as np

from eom.program.make import CALL
from eom.tyre import Dugoff, Kernel, Linear, MagicFormula, Tyre, compile_forces, read_tir, stack

COUNT, ROUNDS = 18, 7
CAR = Path(__file__).parents[1] / "vehicles" / "tyres" / "passenger_car.tir"
LOAD = 4000.0
STIFF = {"nominal_load": LOAD, "cornering": 6e4, "longitudinal": 8e4}
MAGIC = {"nominal_load": LOAD, "mu_x": 1.0, "mu_y": 0.9, "k_x": 20.0, "k_y": 15.0, "E_y": -0.7}


def tyres() -> dict[str, Tyre]:
    """A tyre of every formula."""
    return {
        "linear": Linear(**STIFF),
        "Dugoff": Dugoff(friction=0.9, **STIFF),
        "Magic Formula of the thesis, ellipse": MagicFormula(combined="ellipse", **MAGIC),
        "Magic Formula of the thesis, cosine": MagicFormula(combined="cosine", **MAGIC),
        "Magic Formula 6.1, tool": read_tir(CAR).tyre,
    }


def best(call: Callable[[], object], repeats: int) -> float:
    """Microseconds of a call, the best round's mean."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(repeats):
            call()
        times.append((time.perf_counter() - start) / repeats)
    return 1e6 * min(times)


def in_loop(kernel: Kernel, arguments: "np.ndarray[Any, Any]") -> float:
    """Microseconds of one evaluation in a compiled loop; each depends on the one before: none can be left out."""
    run, repeats = CALL(kernel.ready.program.address), 5000

    def loop(x: Any, u: Any, p: Any, scratch: Any, out: Any) -> None:
        for _ in range(repeats):
            run(x.ctypes.data, u.ctypes.data, p.ctypes.data, scratch.ctypes.data, out.ctypes.data, 0)
            x[0] += 1e-12 * out[1]

    compiled = numba.njit(loop)
    x, out, scratch = arguments.ravel(), np.empty(arguments.size), np.ones(kernel.ready.program.plan.scratch)
    compiled(x, np.empty(0), kernel.ready.parameters, scratch, out)
    return best(lambda: compiled(x, np.empty(0), kernel.ready.parameters, scratch, out), 1) / repeats


def main() -> None:
    """Print the table."""
    rng = np.random.default_rng(1)
    arguments = np.array(
        [
            rng.uniform(-0.2, 0.2, COUNT),
            rng.uniform(-0.2, 0.2, COUNT),
            rng.uniform(0.5 * LOAD, 1.5 * LOAD, COUNT),
            rng.uniform(-0.05, 0.05, COUNT),
            np.full(COUNT, 22.0),
        ]
    )
    features = llvm.get_host_cpu_features()
    vector = next((name for name in ("avx512f", "avx2", "avx", "neon", "sse2") if features.get(name)), "scalar")
    print(f"{COUNT} tyres, microseconds; numba {numba.__version__}, numpy {np.__version__}, vectors {vector}\n")
    print(f"{'':38}{'NumPy':>8}{'compiled':>10}{'ratio':>7}{'from Python':>13}{'compilation':>14}")
    for name, tyre in tyres().items():
        joined = stack([tyre] * COUNT)
        start = time.perf_counter()
        kernel = compile_forces(joined)
        compilation = time.perf_counter() - start
        numpy_time = best(lambda: joined.forces(*arguments), 300)  # noqa: B023  called at once
        loop_time = in_loop(kernel, arguments)
        call_time = best(lambda: kernel.forces(*arguments), 300)  # noqa: B023
        numbers = (
            f"{numpy_time:8.1f}{loop_time:10.2f}{numpy_time / loop_time:7.0f}{call_time:13.2f}{compilation:12.1f} s"
        )
        print(f"{name:38}{numbers}")


if __name__ == "__main__":
    main()
