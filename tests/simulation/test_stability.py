"""Fixed steps beyond stability are refused, others are not; the fastest root that this rests on."""

from functools import cache

import numpy as np
import pytest

import eom
from eom.errors import SimulationError
from eom.model.linear import LinearModel
from eom.model.tyre import TyreModel, tyre_slopes
from eom.simulation import Run, Steps, simulate
from eom.simulation import memory as of
from eom.simulation.engine import engine
from eom.simulation.equations import at_start, equations_of
from eom.simulation.signal_pieces import driven
from tests.splice.shared import model
from tests.vehicles.shipped import WHEELED, vehicle

STABLE = 2.785
"""Product of step and real root up to which the classical method of order four is stable."""
SPEEDS = (1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0, 25.0, 30.0)
WEAKLY_DAMPED = ("quarter_car", "full_car", "pendulum_cart", "truck_full_trailer", "b_train_yaw_plane", "four_bar")
"""Models whose fastest roots are pairs, or are none of a wheel's."""


@cache
def linear(name: str) -> LinearModel:
    return eom.linearise(vehicle(name))


def true_root(found: TyreModel | LinearModel, speed: float | None = None) -> float:
    """Magnitude of the fastest root at the start [1/s]."""
    A = found.A if isinstance(found, LinearModel) else tyre_slopes(found, *found.trim(speed))[0]
    return float(np.max(np.abs(np.linalg.eigvals(A))))


def estimates(found: TyreModel | LinearModel, speed: float | None, until: float = 0.3) -> list[float]:
    """All fastest roots that a run believes in [1/s], the first one at its start."""
    x, u = at_start(found, speed)
    run = engine(equations_of(found), x, driven({}, found.inputs, u), np.array([0.0]), (of.DORMAND_PRINCE, 0.5, 1e-6))
    result = []
    for pause in np.linspace(1e-9, until, 20):
        assert run.go_on(until, pause, closed=True) == of.DONE
        result.append(float(run.clock[of.ROOT]))
    return result


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("name", WHEELED)
def test_fastest_root_is_known_within_a_factor_of_three(name: str, speed: float) -> None:
    """Where it is fast enough to matter, above 100 1/s, within 40 % below and 15 % above."""
    found = model(name)
    true = true_root(found, speed)
    ratios = np.array(estimates(found, speed)) / true
    low, high = (0.6, 1.15) if true > 100.0 else (1.0 / 3.0, 3.0)
    assert low < np.min(ratios)
    assert np.max(ratios) < high


@pytest.mark.parametrize("name", WEAKLY_DAMPED)
def test_fastest_root_of_a_weakly_damped_model_is_known_within_a_factor_of_two(name: str) -> None:
    """Rates of an oscillation grow and shrink as its state turns; its root does not."""
    found = linear(name)
    ratios = np.array(estimates(found, None)) / true_root(found)
    assert np.min(ratios) > 0.5
    assert np.max(ratios) < 2.0


def fixed(found: TyreModel | LinearModel, h: float, duration: float, speed: float | None = None) -> Run:
    inputs = {found.inputs[0]: Steps(np.array([0.0]), np.array([1e-4]))}
    return simulate(found, inputs, duration, speed=speed, method="rk4", step=h)


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("name", WHEELED)
def test_a_fixed_step_beyond_stability_is_refused_at_its_start(name: str, speed: float) -> None:
    found = model(name)
    h = 1.05 * STABLE / true_root(found, speed)
    with pytest.raises(SimulationError, match=r"^at 0 s a step of .* (is unstable|is too long)") as refused:
        fixed(found, h, 40.0 * h, speed)
    assert isinstance(refused.value.partial, Run)
    assert list(refused.value.partial.time) == [0.0]


@pytest.mark.parametrize("name", WHEELED)
def test_a_fixed_step_within_stability_is_taken(name: str) -> None:
    found = model(name)
    run = fixed(found, min(0.8 * STABLE / true_root(found), 0.02), 1.0)
    assert not run.ended
    assert run.time[-1] == 1.0


@pytest.mark.parametrize("name", WEAKLY_DAMPED)
def test_a_fixed_step_far_within_stability_is_taken_whatever_the_model(name: str) -> None:
    """A third of what is stable, and short for the motion."""
    found = linear(name)
    run = fixed(found, min(0.3 * STABLE / true_root(found), 5e-3), 1.0)
    assert not run.ended


@pytest.mark.parametrize("name", ["quarter_car", "full_car", "truck_full_trailer"])
def test_nothing_implicit_runs_where_no_root_is_stiff(name: str) -> None:
    """The fastest root of each is below 100 1/s, far from the 600 1/s from which on the implicit method is taken."""
    found = linear(name)
    assert true_root(found) < 100.0
    run = simulate(found, {found.inputs[0]: Steps(np.array([0.0]), np.array([1e-4]))}, 5.0, tolerance=1e-9)
    assert "Rosenbrock" not in run.method


def test_a_fixed_step_that_becomes_unstable_as_the_vehicle_slows_down_is_refused_then() -> None:
    """Roots of wheels grow as the speed falls; samples until then are those of small steps."""
    found = model("b_train")
    inputs = {name: 1.5e5 for name in found.inputs if name.endswith("brake_pressure")}
    h = 0.7 * STABLE / true_root(found, 5.0)
    with pytest.raises(SimulationError, match=r"^at [1-9][.\d]* s a step of .* is unstable") as refused:
        simulate(found, inputs, 20.0, speed=15.0, method="rk4", step=h)
    partial = refused.value.partial
    assert isinstance(partial, Run)
    assert partial.of("tractor.speed")[-1] > 1.5
    exact = simulate(found, inputs, float(partial.time[-1]), speed=15.0, tolerance=1e-9)
    size = equations_of(found).size + np.abs(exact.states.values)
    assert np.max(np.abs(partial.states.values - exact.states.values) / size) < 1e-3


@pytest.mark.parametrize("name", WHEELED)
def test_the_method_follows_the_fastest_root(name: str) -> None:
    """Explicit at speed, implicit at a crawl where wheels spin."""
    found = model(name)
    assert ("Rosenbrock" in simulate(found, {}, 0.2, speed=25.0).method) == (true_root(found, 25.0) > 600.0)
    assert ("Rosenbrock" in simulate(found, {}, 0.2, speed=1.0).method) == (true_root(found, 1.0) > 600.0)
