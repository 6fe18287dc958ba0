"""What cannot be asked, and what goes wrong on the way: a sentence that says what and when, and the run until then."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest

import eom
from eom.errors import SimulationError
from eom.model.tyre import TyreModel
from eom.program.compiled import without_compiler
from eom.simulation import Case, Run, RunInterrupted, Steps, Table, simulate, simulate_many
from eom.simulation.functions import pieces_of
from eom.simulation.inputs import Input
from tests.simulation.block_samples import Function
from tests.splice.shared import model
from tests.vehicles.shipped import vehicle

NAN = float("nan")
STEER = "axle_1.steer"
Answer = Callable[[], object]


def train() -> TyreModel:
    return model("b_train")


def partial_of(error: object) -> Run:
    partial = getattr(error, "partial", None)
    assert isinstance(partial, Run)
    return partial


def assert_partial(error: SimulationError, last: float) -> None:
    """The error holds all samples until the last one, and says why in the run too."""
    partial = partial_of(error)
    np.testing.assert_allclose(partial.time, np.arange(round(last / 0.01) + 1) * 0.01, atol=1e-12)
    assert partial.ended == str(error)
    assert np.all(np.isfinite(partial.states.values))
    assert np.all(np.isfinite(partial.outputs.values))


SHORT: dict[str, tuple[Input, str, float]] = {
    "NaN in a table": (
        Table(np.array([0.0, 0.3, 0.6, 2.0]), np.array([0.0, 0.01, NAN, 0.0])),
        "input axle_1.steer is nan at 0.6 s",
        0.3,
    ),
    "a table that ends": (
        Table(np.array([0.0, 0.305]), np.array([0.0, 0.01])),
        "input axle_1.steer ends at 0.305 s",
        0.3,
    ),
    "a step to no number": (
        Steps(np.array([0.0, 0.305]), np.array([0.0, np.inf])),
        "input axle_1.steer is inf at 0.305 s",
        0.3,
    ),
    "a function that becomes NaN": (
        lambda t: 0.01 * t if t < 0.305 else NAN,
        r"input axle_1.steer is not finite from 0.305 s on",
        0.3,
    ),
}


@pytest.mark.parametrize("case", SHORT)
def test_an_input_that_ends_before_the_run_keeps_the_run_until_then(case: str) -> None:
    told, message, last = SHORT[case]
    with pytest.raises(SimulationError) as refused:
        simulate(train(), {STEER: told}, 1.0)
    text = str(refused.value)
    assert text.replace("0.304999999", "0.305").startswith(message)
    assert_partial(refused.value, last)


def test_a_table_as_long_as_the_run_is_long_enough() -> None:
    run = simulate(train(), {STEER: Table(np.array([0.0, 0.3]), np.array([0.0, 0.01]))}, 0.3)
    assert not run.ended
    assert len(run.time) == 31


NOTHING: dict[str, Input] = {
    "NaN after the first value": Table(np.array([0.0, 1.0]), np.array([0.0, NAN])),
    "NaN first": Table(np.array([0.0, 1.0]), np.array([NAN, 0.0])),
    "one value": Table(np.array([0.0]), np.array([0.0])),
    "a function of NaN": lambda _: NAN,
    "a step of NaN": Steps(np.array([0.0]), np.array([NAN])),
}


@pytest.mark.parametrize("case", NOTHING)
def test_an_input_that_ends_where_the_run_begins_is_named(case: str) -> None:
    with pytest.raises(SimulationError, match=STEER):
        simulate(train(), {STEER: NOTHING[case]}, 1.0)


def fails(t: float) -> float:
    """A function that fails after 0.305 s."""
    if t > 0.305:
        message = "no more"
        raise ValueError(message)
    return 0.01 * t


def test_a_function_that_raises_is_named_with_the_time() -> None:
    with pytest.raises(SimulationError, match=r"^input axle_1.steer at 0.3[\d]* s: .*ValueError: no more") as refused:
        simulate(train(), {STEER: fails}, 1.0)
    assert isinstance(refused.value.__cause__, ValueError)


def test_a_function_that_raises_keeps_the_run_until_then() -> None:
    with pytest.raises(SimulationError) as refused:
        simulate(train(), {STEER: fails}, 1.0)
    assert_partial(refused.value, 0.3)


def interrupt() -> float:
    raise KeyboardInterrupt


def test_an_interrupt_in_a_function_comes_before_anything_is_computed() -> None:
    """Functions become pieces before the run: there is nothing to keep, and nothing is swallowed."""
    with pytest.raises(KeyboardInterrupt) as interrupted:
        simulate(train(), {STEER: lambda t: interrupt() if t > 0.305 else 0.01 * t}, 1.0)
    assert not isinstance(interrupted.value, RunInterrupted)


SMOOTH: dict[str, Callable[[float], float]] = {
    "a slow versine": lambda t: 0.05 * (1.0 - np.cos(0.05 * t)),
    "a late ramp": lambda t: 1.0 + np.tanh((t - 2.0) / 0.1),
    "single precision": lambda t: float(np.float32(np.sin(t))),
    "rounded": lambda t: round(np.sin(t), 4),
}


@pytest.mark.parametrize("case", SMOOTH)
def test_a_function_with_rounding_errors_becomes_few_pieces(case: str) -> None:
    """A second of it: the digits that are lost in a difference are no shape that could be followed."""
    calls = 0

    def counted(t: float) -> float:
        nonlocal calls
        calls += 1
        if calls > 200_000:
            message = "asked for 200000 values in one second of time"
            raise ValueError(message)
        return SMOOTH[case](t)

    found = pieces_of(counted, STEER, 1.0)
    assert len(found.rows) < 20_000


def late(answer: Answer, time: float = 0.3) -> Callable[[float, Any], object]:
    """What a block does: nothing until a time."""
    return lambda t, _: answer() if t >= time else np.zeros(1)


def looped(of: Callable[[float, Any], object], inputs: Mapping[str, Input] | None = None, name: str = "b") -> Run:
    """A run with a block that steers."""
    block = Function(name, ("tractor.speed",), of, units=("rad",))
    return simulate(train(), inputs or {}, 1.0, blocks=[block], wires={STEER: f"{name}.out"})


ANSWERS: dict[str, tuple[Answer, str]] = {
    "raises": (lambda: 1 / 0, "block b at 0.3 s: raised ZeroDivisionError"),
    "is of the wrong shape": (lambda: np.zeros(2), r"block b at 0.3 s: gave an array of shape \(2,\), expected \(1,\)"),
    "is a number": (lambda: 0.0, r"block b at 0.3 s: gave an array of shape \(\), expected \(1,\)"),
    "is nothing": (lambda: None, "block b at 0.3 s: gave"),
    "is text": (lambda: ["left"], "block b at 0.3 s: raised ValueError"),
    "is NaN": (lambda: np.array([NAN]), "block b at 0.3 s: gave out = nan"),
    "is infinite": (lambda: np.array([np.inf]), "block b at 0.3 s: gave out = inf"),
}


@pytest.mark.parametrize("case", ANSWERS)
def test_a_block_that_fails_is_named_with_the_time_and_the_run_until_then_kept(case: str) -> None:
    answer, message = ANSWERS[case]
    with pytest.raises(SimulationError, match=f"^{message}") as refused:
        looped(late(answer))
    assert_partial(refused.value, 0.3)


@pytest.mark.parametrize("case", ANSWERS)
def test_a_block_that_fails_at_its_first_sample_is_named(case: str) -> None:
    answer, message = ANSWERS[case]
    with pytest.raises(SimulationError, match=f"^{message.replace('0.3 s', '0 s')}"):
        looped(late(answer, 0.0))


@pytest.mark.parametrize("time", [0.0, 0.3])
def test_an_interrupt_in_a_block_keeps_the_run_until_then(time: float) -> None:
    with pytest.raises((KeyboardInterrupt, SimulationError)) as interrupted:
        looped(late(interrupt, time))
    assert isinstance(interrupted.value, RunInterrupted)
    partial = partial_of(interrupted.value)
    assert partial.time[-1] == pytest.approx(time)
    assert "interrupted" in partial.ended


def test_a_port_and_the_input_that_it_drives_are_the_same_signal() -> None:
    """At sample times too, after the sample: at a jump the value after it."""
    block = Function("b", ("tractor.speed",), lambda t, _: np.array([1e-3 * round(10.0 * t)]), units=("rad",))
    run = simulate(train(), {}, 1.0, blocks=[block], wires={STEER: "b.out"}, sample=0.05)
    np.testing.assert_array_equal(run.of(STEER), run.of("b.out"))


def test_every_mistake_of_a_request_is_told_at_once() -> None:
    block = Function("b", ("tractor.spead",), lambda _t, _y: np.zeros(1))
    with pytest.raises(SimulationError) as refused:
        simulate(
            train(),
            {"axle_1.stear": 0.0, "axle_2.steer": 0.0},
            -1.0,
            start={"no.state": 1.0, "tractor_frame.roll": NAN},
            blocks=[block],
            wires={"axle_2.steer": "b.out", "axle_3.steer": "b.exit"},
            sample=0.0,
            method="rk5",
            step=NAN,
            tolerance=1.0,
        )
    text = str(refused.value)
    for part in (
        "axle_1.stear",
        "did you mean 'axle_1.steer'",
        "no.state",
        "start of tractor_frame.roll",
        "duration = -1.0",
        "sample = 0.0",
        "step = nan",
        "tolerance = 1.0",
        "'rk5'",
        "tractor.spead",
        "b.exit",
        "axle_2.steer has a signal and a wire",
    ):
        assert part in text, part


def test_wrong_values_of_inputs_are_told_with_the_other_mistakes() -> None:
    wrong: dict[str, Input] = {
        STEER: NAN,
        "axle_2.steer": Table(np.array([0.0, 1.0]), np.array([0.0])),
        "axle_3.steer": Table(np.array([0.0, 1.0, 1.0]), np.zeros(3)),
        "axle_4.steer": "left",  # type: ignore[dict-item]
    }
    with pytest.raises(SimulationError) as refused:
        simulate(train(), wrong, -1.0)
    for part in (*wrong, "duration = -1.0"):
        assert part in str(refused.value), part


@pytest.mark.parametrize("value", [np.float64(0.01), np.float32(0.01), np.int64(0), np.array(0.01), 0, 0.01])
def test_any_number_is_a_number(value: Any) -> None:
    run = simulate(train(), {STEER: value}, 0.02)
    np.testing.assert_allclose(run.of(STEER), float(value))


def test_rk4_needs_a_step() -> None:
    with pytest.raises(SimulationError, match="needs a step"):
        simulate(train(), {}, 1.0, method="rk4")


def test_a_linear_model_has_no_other_speed() -> None:
    found = eom.linearise(vehicle("car_trailer"))
    with pytest.raises(SimulationError, match="speed"):
        simulate(found, {}, 1.0, speed=10.0)


def test_something_else_is_no_model() -> None:
    with pytest.raises(SimulationError, match="is no model"):
        simulate("b_train", {}, 1.0)  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [1e100, 1e300, 1.7e308])
@pytest.mark.parametrize("method", ["automatic", "rosenbrock", "rk4"])
@pytest.mark.parametrize("name", ["axle_1.steer", "drive_torque", "axle_1.left.brake_pressure"])
def test_a_motion_that_diverges_ends_with_a_sentence_and_finite_samples(name: str, method: str, value: float) -> None:
    step = 1e-3 if method == "rk4" else None
    with pytest.raises(SimulationError, match=r"^at 0.1[\d]* s (the motion (diverges|cannot)|a step)") as refused:
        simulate(train(), {name: Steps(np.array([0.105]), np.array([value]))}, 1.0, method=method, step=step)
    assert_partial(refused.value, 0.1)
    partial = partial_of(refused.value)
    if "a step of" not in str(refused.value):
        *_, event = partial.events
        assert (event.kind, event.until) == ("divergence", None)
        assert str(refused.value).endswith(event.sentence)
        assert 0.1 <= event.time <= 0.2
        assert event.state.shape == (len(partial.states.names),)
        assert np.all(np.isfinite(event.state))
        assert any(state.startswith(f"{event.owner}.") for state in partial.states.names)


def test_the_body_that_diverges_is_named() -> None:
    """One that spins so fast that its centripetal forces are no numbers; the same in a batch, with or without numba."""
    start = {"semitrailer_2_frame.yaw_rate": 1e250}
    with pytest.raises(SimulationError) as refused:
        simulate(train(), {}, 0.5, start=start)
    assert str(refused.value) == "at 0 s the motion diverges: yaw rate of semitrailer_2_frame leaves all bounds"
    found = simulate_many(train(), [Case(), Case(start=start)], 0.5)
    with without_compiler():
        alike = simulate_many(train(), [Case(), Case(start=start)], 0.5, method="rk4", step=1e-3)
    for runs in (found, alike):
        assert not any(event.kind == "divergence" for event in runs.events[0])
        assert [event.owner for event in runs.events[1] if event.kind == "divergence"] == ["semitrailer_2_frame"]


def test_a_run_does_not_change_its_model_or_its_inputs() -> None:
    found, signal = train(), Steps(np.array([0.0, 0.1]), np.array([0.01, 0.0]))
    before = found.trim()
    first = simulate(found, {STEER: signal}, 0.3, start={"tractor_frame.v_x": 20.0})
    second = simulate(found, {STEER: signal}, 0.3, start={"tractor_frame.v_x": 20.0})
    np.testing.assert_array_equal(first.states.values, second.states.values)
    np.testing.assert_array_equal(found.trim().x, before.x)
    np.testing.assert_array_equal(found.trim().u, before.u)
