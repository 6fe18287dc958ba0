"""Runs of linear models beside their exact solution by matrix exponentials.

Errors are counted by the size of a state: what counts as one of its unit, and its own value. Bounds are 2e-12 of it,
more where a model amplifies what its states carry: by the gain of its transition matrix in the time, in these sizes.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.signal import cont2discrete

import eom
from eom.model.linear import LinearModel
from eom.simulation import Sine, Steps, Table, simulate
from eom.simulation.equations import equations_of
from eom.simulation.inputs import Input
from tests.vehicles.shipped import vehicle

Array = NDArray[np.float64]
NAMES = (
    "b_train_yaw_roll",
    "bicycle_rider",
    "car_trailer",
    "full_car",
    "motorcycle",
    "quarter_car",
    "shimmy",
    "spinning_top",
    "tractor_semitrailer",
    "truck_full_trailer",
)
DURATION, SAMPLE = 0.6, 0.05
VALUE, FREQUENCY = 0.01, 2.5


def held(model: LinearModel, column: int) -> Array:
    """States under a constant input, by exact discretisation."""
    system = (model.A, model.B[:, [column]], model.C, model.D[:, [column]])
    A, B, *_ = cont2discrete(system, SAMPLE)
    states = [np.zeros(len(A))]
    for _ in range(round(DURATION / SAMPLE)):
        states.append(A @ states[-1] + VALUE * B[:, 0])
    return np.array(states)


def swung(model: LinearModel, column: int) -> Array:
    """States under a sine, which two more states make."""
    n = len(model.A)
    whole, w = np.zeros((n + 2, n + 2)), 2.0 * np.pi * FREQUENCY
    whole[:n, :n], whole[:n, n] = model.A, VALUE * model.B[:, column]
    whole[n, n + 1], whole[n + 1, n] = w, -w
    step, states = expm(whole * SAMPLE), [np.concatenate((np.zeros(n + 1), [1.0]))]
    for _ in range(round(DURATION / SAMPLE)):
        states.append(step @ states[-1])
    return np.array(states)[:, :n]


def bent(model: LinearModel, column: int) -> Array:
    """States under a ramp to the middle of the time, after which the input stays."""
    n = len(model.A)
    whole = np.zeros((n + 2, n + 2))
    whole[:n, :n], whole[:n, n] = model.A, VALUE * model.B[:, column]
    whole[n, n + 1] = 1.0
    step, states = expm(whole * SAMPLE), [np.concatenate((np.zeros(n + 1), [2.0 / DURATION]))]
    for k in range(round(DURATION / SAMPLE)):
        if k == round(0.5 * DURATION / SAMPLE):
            states[-1][n:] = 1.0, 0.0
        states.append(step @ states[-1])
    return np.array(states)[:, :n]


HALF = 0.5 * DURATION
CASES: dict[str, tuple[Input, object]] = {
    "constant": (VALUE, held),
    "sine": (Sine(VALUE, FREQUENCY, cycles=10.0), swung),
    "function": (lambda t: VALUE * np.sin(2.0 * np.pi * FREQUENCY * t), swung),
    "step": (Steps(np.array([0.0]), np.array([VALUE])), held),
    "ramp": (Table(np.array([0.0, HALF, 2.0]), np.array([0.0, VALUE, VALUE])), bent),
    "function with a kink": (lambda t: VALUE * min(t / HALF, 1.0), bent),
}


def gain(model: LinearModel, size: Array) -> float:
    """Largest amplification of an error of the states in the time."""
    found = [np.linalg.norm(expm(model.A * t) * size / size[:, np.newaxis], 2) for t in (0.2, 0.4, DURATION)]
    return max(1.0, *map(float, found))


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("name", NAMES)
def test_a_run_of_a_linear_model_is_its_exact_solution(name: str, case: str) -> None:
    model = eom.linearise(vehicle(name))
    told, solution = CASES[case]
    size = equations_of(model).size
    wanted = solution(model, 0)  # type: ignore[operator]
    run = simulate(model, {model.inputs[0]: told}, DURATION, sample=SAMPLE, method="dormand_prince", tolerance=1e-13)
    bound = 2e-12 * gain(model, size)
    assert np.max(np.abs(run.states.values - wanted) / (size + np.abs(wanted))) < bound
    outputs = run.states.values @ model.C.T + np.outer(run.inputs.values[:, 0], model.D[:, 0])
    np.testing.assert_allclose(run.outputs.values, outputs, rtol=1e-9, atol=1e-12 * np.max(np.abs(outputs)))


@pytest.mark.parametrize("method", ["automatic", "rosenbrock", "rk4"])
@pytest.mark.parametrize("name", NAMES)
def test_every_method_comes_near_the_exact_solution(name: str, method: str) -> None:
    model = eom.linearise(vehicle(name))
    size = equations_of(model).size
    wanted, step = held(model, 0), 1e-3 if method == "rk4" else None
    run = simulate(model, {model.inputs[0]: VALUE}, DURATION, sample=SAMPLE, method=method, step=step, tolerance=1e-8)
    assert np.max(np.abs(run.states.values - wanted) / (size + np.abs(wanted))) < 1e-5 * gain(model, size)


@given(st.integers(0, 2**31), st.sampled_from(["b_train_yaw_roll", "full_car", "tractor_semitrailer"]))
@settings(max_examples=10, deadline=None)
def test_answers_of_a_linear_model_to_several_inputs_add_up(seed: int, name: str) -> None:
    model = eom.linearise(vehicle(name))
    rng, size = np.random.default_rng(seed), equations_of(model).size
    parts = [{model.inputs[k]: Steps(rng.uniform(0.0, 0.4, 1), 0.01 * rng.normal(size=1))} for k in (0, 1)]
    runs = [simulate(model, own, 0.5, tolerance=1e-11).states.values for own in (*parts, parts[0] | parts[1])]
    assert np.max(np.abs(runs[0] + runs[1] - runs[2]) / size) < 1e-8 * gain(model, size)
