"""Without a compiler all runs in Python, or in NumPy over all cases at once, and gives what compiled code gives."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from eom.driver.speed_keeping import SpeedKeeping
from eom.errors import SimulationError
from eom.model.linear import linearise
from eom.model.tyre import TyreModel, build_tyre_model
from eom.program import compiled, make
from eom.simulation import (
    Block,
    Case,
    Event,
    Run,
    Sensor,
    Sine,
    Steps,
    Table,
    engine,
    lanes,
    simulate,
    simulate_many,
)
from eom.simulation.inputs import Input
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.progress import Progress
from eom.simulation.runs import Runs
from tests.splice.shared import model
from tests.vehicles.shipped import vehicle

pytest.importorskip("numba")

Array = NDArray[np.float64]
TRAIN = "tractor_semitrailer_nonlinear"
STEER, TORQUE, ANGLE = "axle_1.steer", "drive_torque", "semitrailer_frame.yaw_from_tractor_frame"
NEAR = 1e-10
COUNT: Array = np.arange(250.0)
RK4: dict[str, Any] = {"method": "rk4", "step": 0.01}
JUMPS: Mapping[str, Input] = {
    STEER: Sine(0.03, 0.5),
    TORQUE: Steps(np.array([0.0, 0.1, 0.23]), np.array([0.0, 1e5, 0.0])),
}


@pytest.fixture(autouse=True)
def _goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A batch that stands still is a failure, not a wait for ever."""
    stands = [0.0]

    def reached(_: Progress, now: float) -> None:
        stands[:] = [*stands, now] if now == stands[-1] else [now]
        assert len(stands) < 100, f"no case goes on after {now:g} s"

    monkeypatch.setattr(Progress, "reached", reached)


@contextmanager
def no_compiler() -> Iterator[None]:
    """Numba is not found by any module that asks for it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled, "there", lambda: False)
        patch.setattr(make, "MADE", {})
        yield


def train() -> TyreModel:
    return model(TRAIN)


def fresh(name: str = TRAIN) -> TyreModel:
    """A model that has made no program yet."""
    return build_tyre_model(vehicle(name))


def assert_near(found: Array, wanted: Array, what: object) -> None:
    """Equal over the size of a signal, which is the last axis but for the time; no numbers at the same places."""
    assert found.shape == wanted.shape, what
    assert np.array_equal(np.isnan(found), np.isnan(wanted)), what
    size = 1.0 + np.max(np.abs(np.nan_to_num(wanted)), initial=0.0)
    assert np.max(np.abs(np.nan_to_num(found - wanted)), initial=0.0) <= NEAR * size, what


def assert_events_near(found: Sequence[Event], wanted: Sequence[Event]) -> None:
    """The same events at the same times, in states that are the same."""
    assert sorted((event.owner, event.kind) for event in found) == sorted((event.owner, event.kind) for event in wanted)
    own, other = (sorted(events, key=lambda event: (event.owner, event.kind, event.time)) for events in (found, wanted))
    for a, b in zip(own, other, strict=True):
        assert abs(a.time - b.time) < 1e-9
        assert (a.until is None) == (b.until is None)
        assert abs((a.until or 0.0) - (b.until or 0.0)) < 1e-9
        np.testing.assert_allclose(a.state, b.state, rtol=1e-8, atol=1e-8)


def assert_runs_near(found: Run, wanted: Run) -> None:
    """All that two runs say."""
    assert np.array_equal(found.time, wanted.time)
    for part in ("states", "inputs", "outputs", "blocks"):
        for k, name in enumerate(getattr(wanted, part).names):
            assert_near(getattr(found, part).values[:, k], getattr(wanted, part).values[:, k], name)
    assert_events_near(found.events, wanted.events)
    assert found.ended == wanted.ended


def assert_cases_near(found: Runs, wanted: Runs) -> None:
    """All that two batches say."""
    assert found.signals == wanted.signals
    assert np.array_equal(found.time, wanted.time)
    for k in range(len(wanted.ended)):
        for name in wanted.signals:
            assert_near(found.of(name)[k], wanted.of(name)[k], (k, name))
        assert_events_near(found.events[k], wanted.events[k])
    assert found.ended == wanted.ended


# one run


@pytest.mark.parametrize("method", ["rk4", "dormand_prince", "rosenbrock", "automatic"])
def test_a_run_in_python_is_the_compiled_one(method: str) -> None:
    options: dict[str, Any] = {"method": method, "step": 5e-3 if method == "rk4" else None, "speed": 20.0}
    wanted = simulate(train(), JUMPS, 0.4, **options)
    with no_compiler():
        found = simulate(fresh(), JUMPS, 0.4, **options)
    assert_runs_near(found, wanted)
    assert wanted.events
    assert wanted.method.endswith("; compiled")
    assert found.method == wanted.method.replace("; compiled", "; in Python")
    assert "numba" in wanted.identity["software"]
    assert "numba" not in found.identity["software"]


def test_a_run_in_python_with_blocks_and_an_end_is_the_compiled_one() -> None:
    def run(own: TyreModel) -> Run:
        blocks: list[Block] = [
            SpeedKeeping(26.0, kp=9e3, ki=3e3, period=0.02),
            Sensor("gyro", "tractor.yaw_rate", 0.05, 0.1, 0.01),
        ]
        wires = {TORQUE: "speed_keeping.torque"}
        start = {ANGLE: 1.0, "semitrailer_frame.yaw_rate": 0.5}
        return simulate(own, {STEER: Sine(0.03, 0.5)}, 1.0, start=start, blocks=blocks, wires=wires)

    wanted = run(train())
    assert wanted.ended
    with no_compiler():
        found = run(fresh())
    assert_runs_near(found, wanted)


def test_a_linear_run_in_python_is_the_compiled_one() -> None:
    own = linearise(vehicle("car_trailer"))
    wanted = simulate(own, {own.inputs[0]: Sine(0.02, 0.5)}, 0.5)
    with no_compiler():
        again = linearise(vehicle("car_trailer"))
        found = simulate(again, {own.inputs[0]: Sine(0.02, 0.5)}, 0.5)
        lanes = simulate_many(again, [Case({own.inputs[0]: Sine(0.02, 0.5)}), Case()], 0.5, **RK4)
    assert_runs_near(found, wanted)
    assert_cases_near(lanes, simulate_many(own, [Case({own.inputs[0]: Sine(0.02, 0.5)}), Case()], 0.5, **RK4))


@pytest.mark.parametrize("name", ["car", TRAIN])
def test_equations_in_python_and_over_cases_are_those_of_the_model(name: str) -> None:
    """Of all levels, at the straight run and near it."""
    own, rng = model(name), np.random.default_rng(2)
    run = own.trim()
    x = run.x[:, np.newaxis] + 1e-2 * rng.normal(size=(len(run.x), 3)) * (1.0 + np.abs(run.x[:, np.newaxis]))
    u = run.u[:, np.newaxis] + 1e-2 * rng.normal(size=(len(run.u), 3))
    with no_compiler():
        made = fresh(name).program
        rows = made.program.of_arrays(np.repeat(made.parameters[:, np.newaxis], 3, axis=1))(x, u, 2)
        for k in range(3):
            a, b = x[:, k], u[:, k]
            wanted = np.concatenate((own.rhs(0.0, a, b), own.margins(a, b), own.output(0.0, a, b)))
            for found in (made.results(a, b, 2), rows[:, k]):
                np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("speed", [0.0, -0.0, 1e-12])
def test_a_vehicle_at_rest_is_simulated_in_python_too(speed: float) -> None:
    start = {"tractor_frame.v_x": speed, "tractor_frame.v_y": 0.0}
    wanted = simulate(train(), {}, 0.1, start=start)
    with no_compiler():
        assert_runs_near(simulate(train(), {}, 0.1, start=start), wanted)
        lanes = simulate_many(train(), [Case(start=start), Case()], 0.1, method="rk4", step=1e-3)
    assert_cases_near(lanes, simulate_many(train(), [Case(start=start), Case()], 0.1, method="rk4", step=1e-3))


def told_of_divergence() -> str:
    """What a run from a state that nothing can have says."""
    with pytest.raises(SimulationError) as caught:
        simulate(train(), {}, 0.1, start={"tractor_frame.yaw_rate": 1e200})
    return str(caught.value)


def test_a_run_that_diverges_says_so_in_python_too() -> None:
    wanted = told_of_divergence()
    with no_compiler():
        assert told_of_divergence() == wanted


# cases in lanes

CASES = (
    Case(),
    Case(JUMPS),
    Case({STEER: lambda t: 0.02 * np.sin(3.0 * t), TORQUE: 3000.0}),
    Case(start={"tractor_frame.yaw_rate": 0.2, "tractor_frame.v_y": -0.4}),
    Case({STEER: Steps(np.array([0.2, 0.7, 0.705]), np.array([0.05, -0.05, 0.1]))}, speed=12.0),
    Case({STEER: Sine(0.03, 0.5)}, parameters={"mu": 0.3}),
    Case(
        {"axle_2.steer": Table(np.array([0.0, 0.5, 2.0]), np.array([0.0, 0.02, 0.0]))},
        speed=30.0,
        parameters={"tractor_frame.mass": 9000.0},
    ),
    # over at once, and soon
    Case(start={ANGLE: 1.1}),
    Case(start={ANGLE: 0.9, "semitrailer_frame.yaw_rate": 1.0}),
    # traction at every jump
    Case({TORQUE: Steps(0.05 * COUNT[:30], 1e5 * (COUNT[:30] % 2.0))}),
)
"""Cases that differ in all that cases may differ in, with events in steps, at jumps and at the start."""


def test_lanes_are_the_compiled_cases() -> None:
    wanted = simulate_many(train(), CASES, 1.2, **RK4)
    with no_compiler():
        assert_cases_near(simulate_many(train(), CASES, 1.2, **RK4), wanted)
    kinds = {event.kind for events in wanted.events for event in events}
    assert {"traction", "jackknife"} <= kinds
    assert sum(map(len, wanted.events)) > 25
    assert [bool(sentence) for sentence in wanted.ended] == [k in {7, 8} for k in range(len(CASES))]


def test_a_lane_ends_with_its_input_and_the_others_go_on() -> None:
    cases = [Case({STEER: Table(np.array([0.0, 0.55]), np.array([0.0, 0.01]))}), CASES[1]]
    wanted = simulate_many(train(), cases, 1.2, **RK4)
    with no_compiler():
        assert_cases_near(simulate_many(train(), cases, 1.2, **RK4), wanted)


@pytest.mark.parametrize("ends", [False, True])
def test_lanes_with_blocks_are_the_compiled_cases(ends: bool) -> None:
    count = len(CASES) if ends else 7
    speeds, seeds = np.linspace(20.0, 28.0, count), np.arange(count)

    def run() -> Runs:
        blocks: list[Block] = [
            SpeedKeeping(speeds, kp=2e4, ki=1e4 * np.ones(count), highest=3000.0, period=0.02, signal="speed.value"),
            Sensor("speed", "tractor.speed", 0.02, noise=0.1, seed=seeds),
            Sensor("gyro", "tractor.yaw_rate", 0.05, delay=0.1),
        ]
        cases = [Case({k: v for k, v in own.inputs.items() if k != TORQUE}, own.start, own.speed) for own in CASES]
        wires = {TORQUE: "speed_keeping.torque"}
        return simulate_many(train(), cases[:count], 0.7, blocks=blocks, wires=wires, sample=0.025, **RK4)

    wanted = run()
    with no_compiler():
        assert_cases_near(run(), wanted)


def test_lanes_end_alike_where_a_step_is_unstable() -> None:
    """At several speeds, the lowest of which makes the fastest root; one vehicle brakes until it does."""
    cases = [Case({STEER: Sine(0.03, 0.5)}, speed=speed) for speed in (0.5, 0.62, 0.8, 20.0)]
    cases.append(Case({TORQUE: -6e4}, speed=3.0))
    wanted = simulate_many(train(), cases, 1.0, **RK4)
    assert "unstable" in wanted.ended[0]
    assert "unstable" in wanted.ended[-1]
    with no_compiler():
        assert_cases_near(simulate_many(train(), cases, 1.0, **RK4), wanted)


def test_a_lane_that_diverges_leaves_the_others_alone() -> None:
    cases = [
        Case(start={"tractor_frame.yaw_rate": 1e200}),
        CASES[1],
        Case(start={"tractor_frame.v_y": 1e160}),
        CASES[4],
    ]
    wanted = simulate_many(train(), cases, 0.5, **RK4)
    with no_compiler():
        found = simulate_many(train(), cases, 0.5, **RK4)
    # what the others say of numbers that are none may differ
    for runs in (wanted, found):
        assert [bool(sentence) for sentence in runs.ended] == [True, False, True, False]
    for k in (1, 3):
        expected = wanted.values[k]
        np.testing.assert_allclose(found.values[k], expected, rtol=0.0, atol=1e-10 * np.max(np.abs(expected)))


def test_a_lane_does_not_depend_on_others_or_on_pauses(monkeypatch: pytest.MonkeyPatch) -> None:
    with no_compiler():
        every = simulate_many(train(), CASES, 0.8, **RK4)
        monkeypatch.setattr(Progress, "next_stop", lambda _, now, __: now + 0.0137)
        for some in ([1], [8, 3], [9, 5, 1, 9]):
            found = simulate_many(train(), [CASES[k] for k in some], 0.8, **RK4)
            for k, case in enumerate(some):
                for name in found.signals:
                    assert_near(found.of(name)[k], every.of(name)[case], (case, name))
                assert_events_near(found.events[k], every.events[case])
                assert found.ended[k] == every.ended[case]


@pytest.mark.parametrize("method", ["automatic", "rosenbrock"])
def test_other_methods_run_case_by_case_in_python(method: str) -> None:
    own = [CASES[1], CASES[8]]
    with no_compiler():
        runs = simulate_many(train(), own, 0.2, method=method)
        for k, case in enumerate(own):
            run = simulate(train(), case.inputs, 0.2, start=case.start, method=method)
            for name in runs.signals:
                assert np.array_equal(runs.of(name)[k, : len(run.time)], run.of(name), equal_nan=True)
            assert runs.ended[k] == run.ended
            assert_events_near(runs.events[k], run.events)


@pytest.mark.parametrize("room", [-12, 64])
def test_no_event_of_a_lane_is_lost_for_want_of_room(room: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """With room for one of every limit each event makes a new one; jumps come more often than steps."""
    assert len(train().limits) == 12
    jumps = 0.004 * COUNT
    case = Case({TORQUE: Steps(jumps, 1e5 * (COUNT % 2.0)), STEER: Steps(jumps + 0.001, 0.1 * (jumps % 0.3))})
    wanted = simulate_many(train(), [case, CASES[8]], 1.0, **RK4)
    assert len(wanted.events[0]) > 100
    monkeypatch.setattr(engine, "ROOM", room)
    with no_compiler():
        assert_cases_near(simulate_many(train(), [case, CASES[8]], 1.0, **RK4), wanted)


@pytest.mark.parametrize("steps", [1, 7, 30])
def test_an_interrupt_between_steps_in_numpy_keeps_every_sample_until_then(
    monkeypatch: pytest.MonkeyPatch, steps: int
) -> None:
    """Samples wait for each other, so some have not been evaluated when it comes; cases sample at other steps."""
    cases = [Case({STEER: Sine(0.03, 2.0, duration)}) for duration in (0.11, 0.23)]
    ask = {"sample": 0.025, **RK4}
    wanted = simulate_many(model(TRAIN), cases, 0.6, **ask)
    step, count = lanes.Lanes.step, iter(range(1000))

    def interrupted(own: lanes.Lanes, h: Array, f: Array) -> Any:
        if next(count) >= steps:
            raise KeyboardInterrupt
        return step(own, h, f)

    monkeypatch.setattr(lanes.Lanes, "step", interrupted)
    with no_compiler(), pytest.raises(RunInterrupted) as stopped:
        simulate_many(fresh(), cases, 0.6, **ask)
    partial: Runs = stopped.value.partial
    assert 0.009 * steps <= float(str(stopped.value).split()[2]) <= 0.01 * steps + 1e-9
    for name in wanted.signals:
        for found, whole in zip(partial.of(name), wanted.of(name), strict=True):
            taken = int(np.sum(~np.isnan(found)))
            # steps are 10 ms or a little shorter
            assert steps * 0.009 / 0.025 <= taken <= 1.01 + steps * 0.01 / 0.025
            assert_near(found[:taken], whole[:taken], name)
            assert np.all(np.isnan(found[taken:]))
