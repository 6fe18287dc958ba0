"""Responses in time against SciPy and python-control on the same matrices, and their own laws.

Where two programs take the same exact steps, rounding is left: 1e-9 of the largest value, as the matrix exponential of
stiff vehicles loses a few digits. Where the other one integrates, its own tolerance is.
"""

import control
import numpy as np
import pytest
import scipy.integrate
import scipy.signal
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.analysis import (
    forced_response,
    frequency_response,
    impulse_response,
    sine_response,
    steady_gains,
    step_response,
)
from tests.analysis.random_models import drifting_models, model_of, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import vehicle

Array = np.ndarray
SHIPPED = ("b_train_yaw_roll", "quarter_car", "full_car", "a_train", "double_wishbone_car", "articulated_bus")
RANDOM = settings(max_examples=30, deadline=None, phases=PHASES)


def close(found: Array, expected: Array, tolerance: float = 1e-9) -> None:
    """Equal relative to the largest value of each column."""
    size = np.max(np.abs(expected), axis=0, initial=1e-12)
    assert np.max(np.abs(found - expected) / size) <= tolerance


def noise(model: eom.LinearModel, t: Array) -> dict[str, Array]:
    """Rough inputs of the first two inputs."""
    rng = np.random.default_rng(7)
    return {name: rng.normal(size=len(t)) for name in model.inputs[:2]}


def matrix(model: eom.LinearModel, inputs: dict[str, Array], t: Array) -> Array:
    """The inputs as columns."""
    return np.stack([inputs.get(name, np.zeros(len(t))) for name in model.inputs], axis=1)


@pytest.mark.parametrize("name", SHIPPED)
def test_inputs_that_run_straight_between_samples_give_scipys_response(name: str) -> None:
    model = eom.linearise(vehicle(name))
    t = np.linspace(0.0, 3.0, 301)
    inputs = noise(model, t)
    _, expected, _ = scipy.signal.lsim((model.A, model.B, model.C, model.D), matrix(model, inputs, t), t)
    close(forced_response(model, t, inputs).outputs, np.reshape(expected, (len(t), -1)))


@pytest.mark.parametrize("name", SHIPPED)
def test_inputs_that_are_held_between_samples_give_scipys_discrete_system(name: str) -> None:
    model = eom.linearise(vehicle(name))
    t = np.linspace(0.0, 3.0, 301)
    inputs = noise(model, t)
    discrete = scipy.signal.cont2discrete((model.A, model.B, model.C, model.D), t[1])
    _, expected, _ = scipy.signal.dlsim(discrete, matrix(model, inputs, t))
    close(forced_response(model, t, inputs, between="constant").outputs, expected)


@RANDOM
@given(stable_models())
def test_random_systems_respond_as_python_control_says(model: eom.LinearModel) -> None:
    t = np.linspace(0.0, 4.0, 161)
    inputs = noise(model, t)
    system = control.ss(model.A, model.B, model.C, model.D)
    expected = control.forced_response(system, t, matrix(model, inputs, t).T, squeeze=False).outputs
    close(forced_response(model, t, inputs).outputs, expected.T)


@RANDOM
@given(stable_models())
def test_step_and_impulse_are_those_of_python_control(model: eom.LinearModel) -> None:
    t = np.linspace(0.0, 4.0, 161)
    system = control.ss(model.A, model.B, model.C, model.D)
    # python-control drops the impulse through D, and warns
    without = control.ss(model.A, model.B, model.C, np.zeros_like(model.D))
    for k, source in enumerate(model.inputs):
        step = control.step_response(system, t, input=k, squeeze=False).outputs[:, 0].T
        close(step_response(model, source, t).outputs, step)
        impulse = impulse_response(model, source, t)
        close(impulse.outputs, control.impulse_response(without, t, input=k, squeeze=False).outputs[:, 0].T)
        assert np.array_equal(impulse.delta, model.D[:, k])


@RANDOM
@given(drifting_models())
def test_a_step_is_the_integral_of_the_impulse_its_delta_included(model: eom.LinearModel) -> None:
    t = np.linspace(0.0, 2.0, 2001)
    impulse, step = impulse_response(model, "u0", t), step_response(model, "u0", t)
    area = scipy.integrate.cumulative_simpson(impulse.outputs, x=t, axis=0, initial=0.0) + impulse.delta
    # Simpson's rule at steps of 1e-3: error h^4/180 times a fourth derivative of up to 10^4
    assert area[::2] == pytest.approx(step.outputs[::2], abs=1e-7)


@RANDOM
@given(drifting_models(), st.integers(0, 2**32 - 1))
def test_more_samples_on_the_same_straight_lines_change_nothing(model: eom.LinearModel, seed: int) -> None:
    rng = np.random.default_rng(seed)
    knots = np.concatenate([[0.0], np.cumsum(rng.uniform(0.01, 0.5, 12))])
    values = rng.normal(size=len(knots))
    fine = np.union1d(knots, rng.uniform(0.0, knots[-1], 40))
    coarse = forced_response(model, knots, {"u0": values}).outputs
    dense = forced_response(model, fine, {"u0": lambda t: np.interp(t, knots, values)}).outputs
    close(dense[np.searchsorted(fine, knots)], coarse, 1e-10)


@RANDOM
@given(stable_models(), st.floats(0.05, 3.0), st.floats(0.0, 1.0), st.integers(1, 3))
def test_cycles_of_a_sine_give_what_an_integrator_gives(
    model: eom.LinearModel, frequency: float, start: float, cycles: int
) -> None:
    end = start + cycles / frequency
    told = np.linspace(0.0, end + 1.0, 23)

    def rate(t: float, x: Array) -> Array:
        u = 2.0 * np.sin(2.0 * np.pi * frequency * (t - start)) if start <= t < end else 0.0
        return np.asarray(model.A @ x + model.B[:, 0] * u)

    expected, x = {0.0: np.zeros(len(model.A))}, np.zeros(len(model.A))
    for first, last in zip((0.0, start, end), (start, end, told[-1]), strict=True):
        own = told[(told > first) & (told <= last)]
        if last > first:
            # at rest the integrator knows no scale, and its first steps would be as long as it likes
            path = scipy.integrate.solve_ivp(
                rate,
                (first, last),
                x,
                "DOP853",
                rtol=1e-12,
                atol=1e-12,
                max_step=0.1 / frequency,
                t_eval=np.union1d(own, [last]),
            )
            expected |= dict(zip(path.t, path.y.T, strict=True))
            x = path.y[:, -1]
    found = sine_response(model, "u0", frequency, told, amplitude=2.0, start=start, cycles=cycles)
    # the integrator's tolerance, of states of up to a hundred
    assert found.states == pytest.approx(np.array([expected[t] for t in told]), abs=1e-8)


@RANDOM
@given(stable_models(), st.floats(0.05, 3.0))
def test_many_cycles_of_a_sine_settle_at_the_frequency_response(model: eom.LinearModel, frequency: float) -> None:
    cycles = int(120.0 * frequency) + 3
    # roots are 0.2 1/s or faster: e^-24 = 4e-11 of the transient is left in the last cycle
    t = (cycles - 1.0 + np.linspace(0.0, 1.0, 40, endpoint=False)) / frequency
    settled = sine_response(model, "u0", frequency, t, cycles=cycles).outputs
    G = frequency_response(model, "u0", None, [frequency]).values[0]
    expected = (G * np.exp(2j * np.pi * frequency * t)[:, np.newaxis]).imag
    # transients of up to 1e3 times that
    assert settled == pytest.approx(expected, abs=1e-6)


def test_an_initial_state_decays_as_the_matrix_exponential_says() -> None:
    model = eom.linearise(vehicle("quarter_car"))
    x0 = np.array([0.1, -0.02, 0.5, -1.0])
    t = np.array([0.0, 0.013, 0.4, 0.41, 1.7])
    values, vectors = np.linalg.eig(model.A)
    expected = np.array([(vectors * np.exp(values * time) @ np.linalg.solve(vectors, x0)).real for time in t])
    found = forced_response(model, t, {}, initial=x0)
    assert found.states == pytest.approx(expected, rel=1e-10, abs=1e-12)
    free = sine_response(model, "road", 1.0, t, amplitude=0.0, initial=x0).states
    assert free == pytest.approx(expected, rel=1e-10, abs=1e-12)


def test_the_default_times_show_a_step_settle() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    response = step_response(model, "axle_1.steer")
    gains = steady_gains(model).values[:, 0]
    # seven time constants of the slowest root: e^-7 = 1e-3 of a transient of the gain's size is left
    assert response.outputs[-1] == pytest.approx(gains, rel=5e-3)


def test_the_default_times_of_an_unstable_system_end_at_a_growth_of_a_hundred() -> None:
    model = model_of(np.array([[0.5]]), np.array([[1.0]]), np.array([[1.0]]))
    response = impulse_response(model, "u0")
    assert response.outputs[-1, 0] == pytest.approx(100.0, rel=1e-12)
    assert not response.stable


def test_a_response_draws_the_inputs_that_act_and_the_outputs_asked_for() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    figure = step_response(model, "axle_1.steer", amplitude=0.02).plot(["tractor.ay", "semitrailer_2.ay"])
    assert [axes.get_ylabel() for axes in figure.axes] == ["input [rad]", "[m/s^2]"]
    assert [len(axes.lines) for axes in figure.axes] == [1, 2]


def test_every_mistake_of_a_table_of_inputs_gets_its_sentence() -> None:
    model = eom.linearise(vehicle("full_car"))
    with pytest.raises(eom.AnalysisError) as error:
        forced_response(model, [0.0, 1.0, 1.0], {"front_left_rod": [0, 0, 0], "rear_left_road": [1.0]})
    lines = str(error.value).splitlines()
    assert lines[0] == "input front_left_rod: there is no such input; did you mean 'front_left_road'?"
    assert lines[1].startswith("times: expected finite numbers in s")
    assert lines[2] == "input rear_left_road: expected a finite number for each of the 3 samples"
    with pytest.raises(eom.AnalysisError, match="expected a finite number for each of the 14 states"):
        forced_response(model, [0.0, 1.0], {}, initial=[1.0, 2.0])
    with pytest.raises(eom.AnalysisError, match="expected zero or later"):
        step_response(model, "rear_left_road", [-1.0, 1.0])
    with pytest.raises(eom.AnalysisError, match="expected all positive"):
        sine_response(model, "rear_left_road", -1.0)


def test_a_system_without_states_passes_its_inputs_through() -> None:
    empty = np.zeros((0, 0))
    model = model_of(empty, np.zeros((0, 1)), np.zeros((1, 0)), np.array([[3.0]]))
    t = np.array([0.0, 0.4, 1.0])
    assert forced_response(model, t, {"u0": [1.0, 2.0, -1.0]}).of("y0") == pytest.approx([3.0, 6.0, -3.0])
    assert step_response(model, "u0", t).of("y0") == pytest.approx([3.0, 3.0, 3.0])
    assert steady_gains(model).values == pytest.approx(np.array([[3.0]]))
    assert frequency_response(model, "u0").magnitude == pytest.approx(3.0)
