"""The integrators' coefficients and orders, measured on small problems in plain Python."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from eom.simulation import Sine, Steps, Table
from eom.simulation import memory as of
from eom.simulation.accepted import between
from eom.simulation.signal_pieces import driven, told
from eom.simulation.steps import (
    ALPHA,
    DEFECT,
    EMBEDDED,
    GAMMA,
    GAMMAS,
    NODES,
    STAGES,
    WEIGHTS,
    dormand_prince,
    rates,
    rosenbrock,
    runge_kutta,
)
from eom.simulation.stiffness import drift, factorise
from tests.simulation.small import Memory, problem, states

Array = NDArray[np.float64]

PUSH = Sine(amplitude=0.8, frequency=0.5, cycles=4.0)
START = (0.7, -0.2)
NONE: Array = np.zeros(0)


def pendulum(x: Any, u: Any, _: Any) -> tuple[Any, Any, Any]:
    """A damped pendulum that is pushed, more where it hangs."""
    return np.stack([x[1], -4.0 * np.sin(x[0]) - 0.3 * x[1] + u[0] * np.cos(x[0])]), np.zeros(0), np.zeros(0)


def slope(x: Array) -> Array:
    """Derivative of the pendulum's rates by its states, without the push."""
    return np.array([[0.0, 1.0], [-4.0 * np.cos(x[0]), -0.3]])


def pushed(t: float, x: Array) -> Array:
    """The pendulum's rates under `PUSH`."""
    return np.asarray(pendulum(x, (0.8 * np.sin(np.pi * t),), None)[0])


@cache
def exact(t: float) -> Array:
    """The pendulum's state, by scipy."""
    return np.asarray(solve_ivp(pushed, (0.0, t), START, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1])


def stepped(method: str, h: float, until: float, jacobian: Callable[[Array], Array] = slope) -> tuple[Memory, int]:
    """The memory after steps of the same length; the row of the rates at the end."""
    memory = Memory(pendulum, START, driven({"u": told(PUSH, "u", until)}, ("u",), np.zeros(1)))
    last, factors, pivots = of.K0, np.zeros((2, 2)), np.zeros(2, dtype=int)
    for k in range(round(until / h)):
        t = k * h
        if k:
            memory.v[of.X] = memory.v[of.NEW]
        rates(memory.program, t, False, of.X, 0, of.K0, *memory.rest)
        if method == "rosenbrock":
            own = jacobian(memory.v[of.X])
            factorise(h, own, factors, pivots)
            drift(memory.program, t, h, *memory.rest)
            last = rosenbrock(memory.program, t, h, own, factors, pivots, *memory.rest)
        else:
            step = {"rk4": runge_kutta, "dormand_prince": dormand_prince}[method]
            last = step(memory.program, t, h, *memory.rest)
    return memory, last


def order_of(errors: list[float]) -> float:
    """The order with which errors fall when steps are halved, from the last two."""
    return float(np.log2(errors[-2] / errors[-1]))


ORDERS = (("rk4", 4), ("dormand_prince", 5), ("rosenbrock", 3))
JACOBIANS: dict[str, Callable[[Array], Array]] = {
    "none": lambda _: np.zeros((2, 2)),
    "of another place": lambda _: slope(np.array([2.0, 0.0])),
    "unrelated": lambda _: np.array([[-1.0, 2.0], [0.5, -3.0]]),
}


@pytest.mark.parametrize(("method", "order"), ORDERS)
def test_error_falls_with_the_order_of_the_method(method: str, order: int) -> None:
    errors = [np.max(np.abs(stepped(method, h, 2.0)[0].v[of.NEW] - exact(2.0))) for h in (0.04, 0.02, 0.01)]
    assert order - 0.25 < order_of(errors) < order + 0.6


@pytest.mark.parametrize("name", JACOBIANS)
def test_order_of_the_rosenbrock_method_does_not_depend_on_its_jacobian(name: str) -> None:
    jacobian = JACOBIANS[name]
    errors = [
        np.max(np.abs(stepped("rosenbrock", h, 2.0, jacobian)[0].v[of.NEW] - exact(2.0))) for h in (0.02, 0.01, 0.005)
    ]
    assert order_of(errors) > 2.75


@pytest.mark.parametrize(("method", "order"), [("rk4", 3), ("dormand_prince", 4), ("rosenbrock", 2)])
def test_estimated_error_of_a_step_has_the_order_below_the_method(method: str, order: int) -> None:
    """It is at least the error that is made, and falls with one order of the step more than the lower method."""
    found = []
    for h in (0.08, 0.04, 0.02):
        memory, _ = stepped(method, h, h)
        found.append(np.max(np.abs(memory.v[of.ERROR])))
        assert found[-1] > np.max(np.abs(memory.v[of.NEW] - exact(h)))
    assert order + 0.6 < order_of(found) < order + 1.8


@pytest.mark.parametrize(("method", "order"), [("rk4", 3), ("dormand_prince", 4), ("rosenbrock", 3)])
def test_states_within_a_step_have_the_order_of_the_interpolation(method: str, order: int) -> None:
    errors = []
    for h in (0.08, 0.04, 0.02):
        memory, last = stepped(method, h, h)
        own = []
        for share in (0.2, 0.5, 0.9):
            between(share, h, last, memory.v)
            own.append(np.max(np.abs(memory.v[of.RIGHT] - exact(share * h))))
        errors.append(max(own))
    assert order_of(errors) > order + 0.7


def trees(A: Array, c: Array) -> list[tuple[int, float, Array]]:
    """Of all rooted trees up to five nodes: number of nodes, density, weights of the stages (Butcher)."""
    one = np.ones(len(c))
    return [
        (1, 1.0, one),
        (2, 2.0, c),
        (3, 3.0, c**2),
        (3, 6.0, A @ c),
        (4, 4.0, c**3),
        (4, 8.0, c * (A @ c)),
        (4, 12.0, A @ c**2),
        (4, 24.0, A @ A @ c),
        (5, 5.0, c**4),
        (5, 10.0, c**2 * (A @ c)),
        (5, 15.0, c * (A @ c**2)),
        (5, 30.0, c * (A @ A @ c)),
        (5, 20.0, (A @ c) ** 2),
        (5, 20.0, A @ c**3),
        (5, 40.0, A @ (c * (A @ c))),
        (5, 60.0, A @ A @ c**2),
        (5, 120.0, A @ A @ A @ c),
    ]


def square() -> Array:
    """Dormand and Prince's stages as a square matrix."""
    return np.hstack((STAGES, np.zeros((7, 1))))


def test_dormand_and_princes_weights_fulfil_all_seventeen_conditions_of_order_five() -> None:
    A = square()
    np.testing.assert_allclose(A.sum(axis=1), NODES, atol=1e-14)
    for _, density, weights in trees(A, NODES):
        assert abs(A[6] @ weights - 1.0 / density) < 2e-15


def test_dormand_and_princes_error_compares_with_a_method_of_order_four_and_no_more() -> None:
    A = square()
    defects = [(nodes, abs(DEFECT @ weights)) for nodes, _, weights in trees(A, NODES)]
    assert max(defect for nodes, defect in defects if nodes < 5) < 2e-15
    assert max(defect for nodes, defect in defects if nodes == 5) > 1e-4


@given(st.floats(0.0, 1.0))
@settings(max_examples=30, deadline=None)
def test_dormand_and_princes_interpolation_fulfils_all_conditions_of_order_four(share: float) -> None:
    """Rates of the stages are unit vectors: the state between is then the weights of the stages."""
    A, v = square(), np.zeros((of.VECTORS, 7))
    v[of.K0 : of.K0 + 7], v[of.NEW] = np.eye(7), A[6]
    between(share, 1.0, of.K6, v)
    for nodes, density, weights in trees(A, NODES):
        if nodes < 5:
            assert abs(v[of.RIGHT] @ weights - share**nodes / density) < 4e-15


def full() -> tuple[Array, Array]:
    """ROS34PW2's matrices of the states and of the Jacobian, square."""
    return np.hstack((ALPHA, np.zeros((4, 1)))), np.hstack((GAMMAS, np.zeros((4, 1)))) + GAMMA * np.eye(4)


def test_ros34pw2_fulfils_the_conditions_of_order_three_whatever_the_jacobian() -> None:
    """Those of W-methods: T. Steihaug, A. Wolfbrandt, Math. Comp. 33 (1979) 521-534."""
    A, G = full()
    one = np.ones(4)
    wanted = {
        1.0: [one],
        1.0 / 2.0: [A @ one],
        1.0 / 3.0: [(A @ one) ** 2],
        1.0 / 6.0: [A @ A @ one],
        0.0: [G @ one, A @ G @ one, G @ A @ one, G @ G @ one],
    }
    for value, all_weights in wanted.items():
        for weights in all_weights:
            assert abs(WEIGHTS @ weights - value) < 2e-15


def test_ros34pw2_compares_with_a_method_of_order_two_whatever_the_jacobian_and_no_more() -> None:
    A, G = full()
    one = np.ones(4)
    for value, weights in ((1.0, one), (0.5, A @ one), (0.0, G @ one)):
        assert abs(EMBEDDED @ weights - value) < 2e-15
    assert abs(EMBEDDED @ (A @ one) ** 2 - 1.0 / 3.0) > 1e-3


def test_ros34pw2_is_stiffly_accurate() -> None:
    A, G = full()
    np.testing.assert_allclose(A[3] + G[3], WEIGHTS, atol=1e-15)


@given(st.floats(-6.0, 6.0), st.floats(np.pi / 2.0, np.pi))
@settings(max_examples=100, deadline=None)
def test_ros34pw2_amplifies_no_decaying_motion_and_forgets_the_fastest(size: float, angle: float) -> None:
    """Its amplification of x' = z x is R(z) = 1 + z b (1 - z (A + G))^-1 1."""
    A, G = full()
    z = 10.0**size * np.exp(1j * angle)
    found = 1.0 + z * (WEIGHTS @ np.linalg.solve(np.eye(4) - z * (A + G), np.ones(4)))
    assert abs(found) < 1.0 + 1e-9
    assert size < 4.0 or abs(found) < 1e-3


def integral(x: Any, u: Any, _: Any) -> tuple[Any, Any, Any]:
    """The integral of an input, and the integral of that."""
    return np.stack([u[0], x[0]]), np.zeros(0), np.zeros(0)


ALL = {"rk4": of.RUNGE_KUTTA, "dormand_prince": of.DORMAND_PRINCE, "rosenbrock": of.ROSENBROCK}


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("method", ALL)
def test_steps_end_where_an_input_jumps(method: str, compiled: bool) -> None:
    """Every method integrates what is constant exactly: a step across a jump would be wrong by far more than 1e-12.

    The tolerance allows errors of 1e-2, so that nothing else finds the jumps.
    """
    time, value = np.array([0.1234567, 0.5, 0.5000001, 1.0 / 3.0 + 0.4]), np.array([1.0, -2.0, 5.0, 0.25])
    times = np.linspace(0.0, 1.5, 40)
    found = problem(integral, (0.0, 0.0), {"u": Steps(time, value)}, times, (ALL[method], 0.2, 1e-2), compiled=compiled)
    assert found.go_on(1.5, np.inf, closed=True) == of.DONE
    since = np.maximum(times[:, np.newaxis] - time, 0.0)
    jumps = np.diff(np.concatenate(([0.0], value)))
    wanted = np.column_stack((since @ jumps, 0.5 * since**2 @ jumps))
    np.testing.assert_allclose(states(found), wanted, atol=2e-11 if method == "rosenbrock" else 1e-12)


@pytest.mark.parametrize("method", ALL)
def test_steps_end_where_the_slope_of_an_input_jumps(method: str) -> None:
    """Every method integrates a straight line twice exactly; a Rosenbrock method as well as it knows the slope."""
    time, value = np.array([0.0, 0.3, 0.7000001, 2.0]), np.array([0.0, 2.0, -1.0, 3.0])
    times = np.linspace(0.0, 1.5, 40)
    found = problem(integral, (0.0, 0.0), {"u": Table(time, value)}, times, (ALL[method], 0.2, 1e-2))
    assert found.go_on(1.5, np.inf, closed=True) == of.DONE
    since = np.maximum(times[:, np.newaxis] - time[:-1], 0.0)
    kinks = np.diff(np.concatenate(([0.0], np.diff(value) / np.diff(time))))
    wanted = np.column_stack((since**2 @ kinks / 2.0, since**3 @ kinks / 6.0))
    np.testing.assert_allclose(states(found), wanted, atol=1e-8 if method == "rosenbrock" else 1e-12)


def test_a_jump_between_steps_leaves_the_order_four_of_the_classical_method() -> None:
    """The jump is at no multiple of the steps, so that a method that steps across it falls to order one."""
    jump = 0.777

    def kicked(t: float, x: Array) -> Array:
        return np.asarray(pendulum(x, (3.0 * (t >= jump),), None)[0])

    state: Any = START
    for first, last in ((0.0, jump), (jump, 2.0)):
        # the end of the first part belongs to the time before the jump
        own = kicked if first else lambda _, x: kicked(0.0, x)
        state = solve_ivp(own, (first, last), state, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    errors = []
    for h in (0.05, 0.025, 0.0125):
        inputs = {"u": Steps(np.array([jump]), np.array([3.0]))}
        found = problem(pendulum, START, inputs, (0.0, 2.0), (of.RUNGE_KUTTA, h, 1e-6))
        assert found.go_on(2.0, np.inf, closed=True) == of.DONE
        errors.append(np.max(np.abs(states(found)[-1] - state)))
    assert 3.6 < order_of(errors) < 4.6


@pytest.mark.parametrize("method", ["dormand_prince", "rosenbrock"])
def test_error_of_an_adaptive_run_follows_its_tolerance(method: str) -> None:
    errors = []
    for tolerance in (1e-4, 1e-6, 1e-8):
        found = problem(pendulum, START, {"u": PUSH}, (0.0, 2.0), (ALL[method], 0.5, tolerance), compiled=True)
        assert found.go_on(2.0, np.inf, closed=True) == of.DONE
        errors.append(np.max(np.abs(states(found)[-1] - exact(2.0))))
        assert errors[-1] < 20.0 * tolerance
    assert errors[-1] < 1e-2 * errors[0]


@pytest.mark.parametrize("method", ALL)
def test_compiled_loops_do_what_plain_python_does(method: str) -> None:
    """Elementary functions differ by units in the last place, and derivatives by differences magnify that."""
    ends = []
    for compiled in (False, True):
        own = (ALL[method], 0.02, 1e-6)
        found = problem(pendulum, START, {"u": PUSH}, np.linspace(0.0, 2.0, 9), own, compiled=compiled)
        assert found.go_on(2.0, np.inf, closed=True) == of.DONE
        ends.append(states(found))
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-10)


@pytest.mark.parametrize("method", ALL)
@given(st.lists(st.floats(0.01, 1.9), max_size=6))
@settings(max_examples=10, deadline=None)
def test_pauses_change_nothing(method: str, pauses: list[float]) -> None:
    own = (ALL[method], 0.03, 1e-5)
    whole, parts = (
        problem(pendulum, START, {"u": PUSH}, np.linspace(0.0, 2.0, 41), own, compiled=True) for _ in range(2)
    )
    assert whole.go_on(2.0, np.inf, closed=True) == of.DONE
    for pause in [*sorted(pauses), np.inf]:
        assert parts.go_on(2.0, pause, closed=True) == of.DONE
    np.testing.assert_array_equal(states(whole), states(parts))
