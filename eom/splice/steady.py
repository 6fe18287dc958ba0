"""The straight run of a model at any forward speed, from the same numbers."""

from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.splice.rates import rates
from eom.splice.state import Model, sizes
from eom.splice.trim import STEP, TrimError

RUN_PASSES = 30
RUN_SETTLED = 1e-12
RUN_BALANCED = 1e-9
"""Rates, over gravity and the speed, that are rounding of light, stiffly rolling wheels."""


def steady(p: Model, speed: float, slip: Array, torque: float) -> tuple[Array, Array]:
    """State and inputs of the straight run at a forward speed [m/s].

    The slips of the wheels and the drive torque of a run nearby are where the search starts; springs give way as far
    as that run's drag and resistance differ from those for which the vehicle was drawn. Raises `TrimError` if there
    is none.
    """
    starts = np.cumsum((0, *sizes(p)))
    x, u = np.zeros(starts[-1]), p.control.demand * torque
    x[starts[2]] = speed
    x[starts[3] : starts[4]] = ((1.0 + slip) * speed / p.contact.radius)[p.contact.spinning]
    unknown = [*range(starts[1], starts[2]), *range(starts[3], starts[4])]
    driven = not p.body.held and bool(np.any(p.control.demand))

    def placed(z: Any) -> tuple[Any, Any]:
        """State and inputs at values of what is unknown: displacements, spins, drive torque."""
        state, inputs = x.astype(z.dtype), u.astype(z.dtype)
        state[unknown] = z[: len(unknown)]
        if driven:
            inputs = p.control.demand * z[-1]
            if p.control.drive_lag > 0.0:
                state[starts[5]] = z[-1]
        return state, inputs

    wanted = [*range(starts[2], starts[4])]
    size = np.concatenate((np.full(starts[3] - starts[2], 9.8), np.full(starts[4] - starts[3], max(1.0, speed))))
    z = np.concatenate((x[unknown], [torque] if driven else []))
    scale = np.maximum(np.abs(z), np.concatenate((np.ones(len(unknown)), [1e3] if driven else [])))
    for _ in range(RUN_PASSES):
        left = rates(*placed(z), p)[wanted] / size
        if np.max(np.abs(left)) <= RUN_SETTLED:
            return placed(z)
        slopes = [rates(*placed(z + 1j * STEP * row), p)[wanted].imag / STEP for row in np.diag(scale)]
        step = np.linalg.lstsq(np.array(slopes).T / size[:, np.newaxis], left, rcond=1e-12)[0]
        z = z - scale * step
        if not np.all(np.isfinite(z)):
            break
        if np.max(np.abs(step)) <= RUN_SETTLED and np.max(np.abs(left)) <= RUN_BALANCED:
            # rates of light, stiffly rolling wheels keep the rounding of their spins
            return placed(z)
    message = f"no straight run at {speed:.6g} m/s holds: a resistance is not balanced, or asks too much of a tyre"
    raise TrimError("trim", message)
