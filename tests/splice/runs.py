"""Runs of models in time, integrated by SciPy."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

import eom

Inputs = Callable[[float], np.ndarray]


class Trace(NamedTuple):
    """Instants [s], states (times, n), outputs by name over time."""

    t: np.ndarray
    x: np.ndarray
    outputs: dict[str, np.ndarray]


def inputs_of(names: tuple[str, ...], base: np.ndarray, **signals: Callable[[float], float]) -> Inputs:
    """Constant inputs, to which named signals are added (``axle_1__steer`` for ``axle_1.steer``)."""
    at = {names.index(name.replace("__", ".")): signal for name, signal in signals.items()}

    def inputs(t: float) -> np.ndarray:
        """All inputs at an instant."""
        u = base.copy()
        for k, signal in at.items():
            u[k] += signal(t)
        return u

    return inputs


def run(model: eom.TyreModel, x: np.ndarray, inputs: Inputs, duration: float, step: float = 0.02) -> Trace:
    """A nonlinear model from a state on, with local errors of a millionth, and steps no longer than *step* [s]."""
    found = solve_ivp(
        lambda t, x: model.rhs(t, x, inputs(t)), (0.0, duration), x, method="RK45", rtol=1e-6, atol=1e-7, max_step=step
    )
    assert found.success
    values = np.array([model.output(t, x, inputs(t)) for t, x in zip(found.t, found.y.T, strict=True)])
    return Trace(found.t, found.y.T, dict(zip(model.outputs, values.T, strict=True)))


def run_linear(model: eom.LinearModel, inputs: Inputs, duration: float, step: float = 0.02) -> Trace:
    """A linear model from its trim on; inputs count from the trim's."""
    found = solve_ivp(
        lambda t, x: model.A @ x + model.B @ inputs(t),
        (0.0, duration),
        np.zeros(len(model.A)),
        method="RK45",
        rtol=1e-6,
        atol=1e-8,
        max_step=step,
    )
    assert found.success
    values = found.y.T @ model.C.T + np.array([inputs(t) for t in found.t]) @ model.D.T
    return Trace(found.t, found.y.T, dict(zip(model.outputs, values.T, strict=True)))


def single_sine(amplitude: float, frequency: float = 0.4, start: float = 0.5) -> Callable[[float], float]:
    """One cycle of a sine [rad, Hz, s]."""

    def signal(t: float) -> float:
        """Its value at an instant."""
        after = (t - start) * frequency
        return amplitude * float(np.sin(2.0 * np.pi * after)) if 0.0 < after < 1.0 else 0.0

    return signal
