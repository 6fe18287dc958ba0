"""Runs of all vehicles with wheels beside scipy's integrators on the model's own right side.

Both sides are integrated with errors far below the bounds; what remains are compiled elementary functions, a few units
in the last place, and forces that are differences by 1e-6 of the load, of which 1e-10 is kept, see
`tests.splice.test_compiled`.
"""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from eom.model.tyre import TyreModel
from eom.simulation import Run, Sine, Steps, Table, simulate
from eom.simulation.equations import equations_of
from eom.simulation.inputs import Input
from tests.splice.shared import model
from tests.vehicles.shipped import WHEELED

Array = NDArray[np.float64]

CORNERS = (0.0, 0.05, 0.1, 0.25, 0.35)
"""Where the inputs of the manoeuvre jump or bend [s]; it ends at the last one."""
TORQUE, PRESSURE, STEER = 800.0, 1.5e5, 0.02


Method = Literal["DOP853", "Radau"]


class Manoeuvre(NamedTuple):
    """Inputs as a run is told them, and as functions of time and of the corner before it."""

    told: Mapping[str, Input]
    functions: Mapping[str, Callable[[float, float], float]]


def manoeuvre(found: TyreModel) -> Manoeuvre:
    """A cycle of steer, a torque that rises in a ramp, brakes of the left side that come in a step."""
    told: dict[str, Input] = {
        "axle_1.steer": Sine(STEER, 5.0, start=0.05, cycles=1.0),
        "drive_torque": Table(np.array([0.0, 0.1, 0.25, 1.0]), np.array([0.0, 0.0, TORQUE, TORQUE])),
    }
    functions: dict[str, Callable[[float, float], float]] = {
        "axle_1.steer": lambda t, corner: STEER * np.sin(10.0 * np.pi * (t - 0.05)) if 0.05 <= corner < 0.25 else 0.0,
        "drive_torque": lambda t, _: TORQUE * min(max((t - 0.1) / 0.15, 0.0), 1.0),
    }
    for name in found.inputs:
        if name.endswith("left.brake_pressure"):
            told[name] = Steps(np.array([0.1]), np.array([PRESSURE]))
            functions[name] = lambda _, corner: PRESSURE if corner >= 0.1 else 0.0
    return Manoeuvre(told, functions)


def referee(
    found: TyreModel, speed: float | None, own: Manoeuvre, method: Method, relative: float
) -> tuple[Array, Array]:
    """States and inputs at the corners, the inputs as they are after each."""
    x, u = found.trim(speed)
    size = equations_of(found).size

    def inputs(corner: float, t: float) -> Array:
        now = u.copy()
        for name, function in own.functions.items():
            now[found.inputs.index(name)] = function(t, corner)
        return now

    def rates(corner: float, t: float, state: Array) -> Array:
        return found.rhs(t, state, inputs(corner, t))

    states = [x]
    for first, last in pairwise(CORNERS):
        run = solve_ivp(
            partial(rates, first), (first, last), states[-1], method, t_eval=[last], rtol=relative, atol=relative * size
        )
        assert run.success
        states.append(run.y[:, -1])
    return np.array(states), np.array([inputs(t, t) for t in CORNERS])


def ours(found: TyreModel, speed: float | None, own: Manoeuvre, method: str, tolerance: float) -> Run:
    return simulate(found, own.told, CORNERS[-1], speed=speed, sample=0.05, method=method, tolerance=tolerance)


def at_corners(run: Run, values: Array) -> Array:
    """The samples at the corners."""
    return values[np.searchsorted(run.time, np.array(CORNERS) - 1e-9)]


def assert_near(found: TyreModel, run: Run, states: Array, inputs: Array, bound: float) -> None:
    """States differ by less than the bound of their size, inputs by rounding, outputs as their states let them."""
    size = equations_of(found).size + np.abs(states)
    assert np.max(np.abs(at_corners(run, run.states.values) - states) / size) < bound
    np.testing.assert_allclose(at_corners(run, run.inputs.values), inputs, rtol=1e-11, atol=1e-14)
    outputs = np.array([found.output(0.0, x, u) for x, u in zip(states, inputs, strict=True)])
    # an output's size is its largest value of all, and its unit of the smallest thing that it tells
    largest = np.max(np.abs(outputs), axis=0)
    forces = np.array([1e3 if unit in {"N", "N*m"} else 1.0 for unit in found.output_units])
    assert np.max(np.abs(at_corners(run, run.outputs.values) - outputs) / (largest + forces)) < 1e3 * bound


@pytest.mark.parametrize("name", WHEELED)
def test_a_run_is_that_of_scipys_method_of_order_eight(name: str) -> None:
    found = model(name)
    own = manoeuvre(found)
    states, inputs = referee(found, None, own, "DOP853", 1e-11)
    run = ours(found, None, own, "automatic", 1e-11)
    assert not run.ended
    assert_near(found, run, states, inputs, 4e-9)


@pytest.mark.parametrize("name", WHEELED)
def test_a_slow_run_is_that_of_scipys_implicit_method(name: str) -> None:
    """At 2 m/s wheels relax in milliseconds; the Rosenbrock method is told to run where none would be needed, too."""
    found = model(name)
    own = manoeuvre(found)
    states, inputs = referee(found, 2.0, own, "Radau", 1e-7)
    for method in ("automatic", "rosenbrock"):
        assert_near(found, ours(found, 2.0, own, method, 1e-8), states, inputs, 2e-6)


@pytest.mark.parametrize("name", WHEELED)
def test_all_methods_agree(name: str) -> None:
    """By the errors that each is allowed: fixed steps of 0.1 ms make far smaller ones."""
    found = model(name)
    own = manoeuvre(found)
    size = equations_of(found).size
    exact = ours(found, None, own, "dormand_prince", 1e-12).states.values
    fixed = simulate(found, own.told, CORNERS[-1], sample=0.05, method="rk4", step=1e-4).states.values
    implicit = ours(found, None, own, "rosenbrock", 1e-9).states.values
    assert np.max(np.abs(fixed - exact) / (size + np.abs(exact))) < 1e-8
    assert np.max(np.abs(implicit - exact) / (size + np.abs(exact))) < 1e-7
