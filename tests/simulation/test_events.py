"""Limits that are reached and left: when, in pairs, all of them, whatever makes them happen."""

from collections import Counter
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from eom.simulation import Event, Run, Sine, Steps, Table, simulate
from eom.simulation import engine as engines
from eom.simulation import memory as of
from eom.simulation.inputs import Input
from tests.simulation.small import events, problem
from tests.splice.shared import model

ALL = {"rk4": of.RUNGE_KUTTA, "dormand_prince": of.DORMAND_PRINCE, "rosenbrock": of.ROSENBROCK}


def swinging(x: Any, _u: Any, _: Any) -> tuple[Any, Any, Any]:
    """An oscillator of 7 rad/s, with a limit on each side of it."""
    return np.stack([7.0 * x[1], -7.0 * x[0]]), np.stack([0.5 - x[0], x[0] + 0.8]), np.zeros(0)


def rising(x: Any, u: Any, _: Any) -> tuple[Any, Any, Any]:
    """A clock, with limits at three times and one on the input."""
    margins = np.stack([0.3 - x[0], 0.05 - x[0], 0.4 - x[0], 1.0 - u[0]])
    return np.stack([1.0 + 0.0 * x[0]]), margins, np.zeros(0)


def bent(x: Any, _u: Any, _: Any) -> tuple[Any, Any, Any]:
    """A clock, with limits of all powers that are reached at 1/3, steep and flat."""
    since = 1.0 / 3.0 - x[0]
    cube = since * since * since
    margins = np.stack([since, cube, cube * cube * cube, since * np.exp(40.0 * x[0:1])[0]])
    return np.stack([1.0 + 0.0 * x[0]]), margins, np.zeros(0)


def kicked(u: float, duration: float = 1.0, ends: tuple[bool, ...] = (False, False, False, False)) -> Any:
    """A run of `rising` with an input that steps at 0.2 s."""
    inputs = {"u": Steps(np.array([0.2]), np.array([u]))}
    return problem(rising, (0.0,), inputs, np.linspace(0.0, duration, 11), (of.DORMAND_PRINCE, 0.5, 1e-6), ends)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("method", ALL)
def test_every_crossing_is_found_at_its_time_with_its_direction(method: str, compiled: bool) -> None:
    """The oscillator is sin 7t: crossings are known. Between the ends of a step states are of order three or more."""
    end = 20.0 if compiled else 2.0
    own = (ALL[method], 2e-3, 1e-9)
    run = problem(swinging, (0.0, 1.0), {}, (0.0, end), own, (False, False), compiled=compiled)
    assert run.go_on(end, np.inf, closed=True) == of.DONE
    turns, half = 2.0 * np.pi * np.arange(-1, 24), np.pi
    first, second = np.arcsin([0.5, 0.8])
    wanted = [((turns + first) / 7.0, 0, 1.0), ((turns + half - first) / 7.0, 0, 0.0)]
    wanted += [((turns + half + second) / 7.0, 1, 1.0), ((turns - second) / 7.0, 1, 0.0)]
    got = events(run)
    for times, limit, reached in wanted:
        found = got[(got[:, of.EVENT_LIMIT] == limit) & (got[:, of.EVENT_REACHED] == reached)][:, of.EVENT_TIME]
        expected = times[(times > 0.0) & (times < end)]
        assert len(found) == len(expected)
        np.testing.assert_allclose(found, expected, atol=2e-7)


def test_crossings_of_margins_that_are_steep_or_flat_are_found() -> None:
    """To 1e-10 of a step where the margin has a slope; its ninth power counts as zero within a thousandth."""
    found = problem(bent, (0.0,), {}, (0.0, 1.0), (of.DORMAND_PRINCE, 0.5, 1e-6), (False,) * 4)
    assert found.go_on(1.0, np.inf, closed=True) == of.DONE
    got = events(found)
    assert sorted(got[:, of.EVENT_LIMIT]) == [0, 1, 2, 3]
    by_limit = dict(zip(got[:, of.EVENT_LIMIT].astype(int), got[:, of.EVENT_TIME], strict=True))
    for limit, bound in ((0, 1e-10), (1, 1e-6), (2, 1e-3), (3, 1e-9)):
        assert abs(by_limit[limit] - 1.0 / 3.0) < bound


def test_a_limit_that_an_input_crosses_by_a_jump_is_reached_then() -> None:
    found = kicked(2.0)
    assert found.go_on(1.0, np.inf, closed=True) == of.DONE
    jumps = events(found)[events(found)[:, of.EVENT_LIMIT] == 3]
    np.testing.assert_allclose(jumps[:, of.EVENT_TIME], [0.2])
    np.testing.assert_array_equal(jumps[:, of.EVENT_REACHED], [1.0])


def test_a_limit_that_is_passed_from_the_start_is_reached_at_the_start() -> None:
    inputs = {"u": Steps(np.array([0.0, 0.2]), np.array([2.0, 0.0]))}
    found = problem(rising, (0.0,), inputs, (0.0, 1.0), (of.DORMAND_PRINCE, 0.5, 1e-6), (False,) * 4)
    assert found.go_on(1.0, np.inf, closed=True) == of.DONE
    own = events(found)[events(found)[:, of.EVENT_LIMIT] == 3]
    np.testing.assert_allclose(own[:, of.EVENT_TIME], [0.0, 0.2])
    np.testing.assert_array_equal(own[:, of.EVENT_REACHED], [1.0, 0.0])


def test_nothing_happens_after_the_limit_that_ends_a_run() -> None:
    """All three limits lie in the same step."""
    found = kicked(0.0, ends=(True, False, False, False))
    found.clock[of.STEP] = 0.5
    assert found.go_on(1.0, np.inf, closed=True) == of.TERMINAL
    assert abs(found.time - 0.3) < 1e-9
    assert np.max(events(found)[:, of.EVENT_TIME]) <= found.time
    assert abs(found.state[0] - 0.3) < 1e-9


def test_of_two_limits_that_end_a_run_in_the_same_step_the_earlier_one_does() -> None:
    found = kicked(0.0, ends=(True, False, True, False))
    found.clock[of.STEP] = 0.5
    assert found.go_on(1.0, np.inf, closed=True) == of.TERMINAL
    assert abs(found.time - 0.3) < 1e-9


@pytest.mark.parametrize("room", [1, 2, 3, 256])
def test_no_event_is_lost_for_want_of_room(room: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """20 s are 22.28 turns of four events, of the last one only the first."""
    monkeypatch.setattr(engines, "ROOM", room)
    found = problem(
        swinging, (0.0, 1.0), {}, (0.0, 20.0), (of.DORMAND_PRINCE, 0.5, 1e-3), (False, False), compiled=True
    )
    assert found.go_on(20.0, np.inf, closed=True) == of.DONE
    assert len(events(found)) == 22 * 4 + 1


def test_no_event_is_lost_when_there_are_more_than_256_in_a_slice() -> None:
    """The oscillator makes 445 of them in 100 s; a limit that ends the run after them does end it."""
    found = problem(
        swinging, (0.0, 1.0), {}, (0.0, 100.0), (of.DORMAND_PRINCE, 0.5, 1e-6), (False, False), compiled=True
    )
    assert found.go_on(100.0, np.inf, closed=True) == of.DONE
    assert len(events(found)) == 111 * 4 + 1


def brakes(wheels: tuple[str, ...] | None, signal: Input) -> Mapping[str, Input]:
    """A pressure on some wheels of the B-train, or on all."""
    names = [name for name in model("b_train").inputs if name.endswith("brake_pressure")]
    return {name: signal for name in names if wheels is None or name.removesuffix(".brake_pressure") in wheels}


def test_no_event_of_a_vehicle_is_lost_when_there_are_hundreds() -> None:
    """Brakes of all wheels come and go: wheels that lock, lock at every stroke, left and right alike."""
    strokes = np.arange(0.0, 12.0, 0.5)
    pressure = np.where(np.arange(len(strokes)) % 2 == 1, 8e5, 0.0)
    with pytest.MonkeyPatch.context() as patch:
        found = []
        for room in (256, 5, 1):
            patch.setattr(engines, "ROOM", room)
            found.append(simulate(model("b_train"), brakes(None, Steps(strokes, pressure)), 6.0))
    counts = [Counter((event.kind, event.owner) for event in run.events) for run in found]
    assert counts[0] == counts[1] == counts[2]
    assert all(counts[0]["lock", f"axle_{k}.left"] == counts[0]["lock", f"axle_{k}.right"] for k in range(1, 10))
    assert sum(counts[0].values()) > 40


@pytest.mark.parametrize("wheel", ["axle_1.left", "axle_4.left", "axle_9.right"])
def test_a_wheel_that_is_braked_hard_locks_once_and_rolls_again_when_the_pressure_goes(wheel: str) -> None:
    found = model("b_train")
    inputs = brakes((wheel,), Steps(np.array([0.2, 1.2]), np.array([1e6, 0.0])))
    run = simulate(found, inputs, 2.5, speed=20.0, sample=1e-3)
    (lock,) = run.events
    assert (lock.kind, lock.owner) == ("lock", wheel)
    assert lock.until is not None
    assert 0.2 < lock.time < 1.2 < lock.until < 1.4
    spin = run.of(f"state:{wheel}.spin")
    held = (run.time > lock.time + 0.05) & (run.time < 1.2)
    assert np.max(np.abs(spin[held])) < 0.05 * 20.0 / 0.5
    # no chatter: a locked wheel does not turn to and fro
    assert np.max(np.abs(np.diff(spin[held]))) < 0.05
    assert run.of(f"state:{wheel}.spin")[-1] > 0.9 * 20.0 / 0.51 * run.of("tractor.speed")[-1] / 20.0


def test_time_of_a_lock_is_the_root_of_its_margin_on_a_tight_reference() -> None:
    found = model("b_train")
    wheel = "axle_4.left"
    run = simulate(found, brakes((wheel,), Steps(np.array([0.0]), np.array([1e6]))), 0.6, speed=20.0, tolerance=1e-10)
    (lock,) = run.events
    x, u = found.trim(20.0)
    u[found.inputs.index(f"{wheel}.brake_pressure")] = 1e6
    number = next(k for k, limit in enumerate(found.limits) if (limit.kind, limit.owner) == ("lock", wheel))
    dense = solve_ivp(
        lambda t, own: found.rhs(t, own, u), (0.0, 0.4), x, "DOP853", rtol=1e-10, atol=1e-10, dense_output=True
    ).sol
    assert dense is not None
    time = brentq(lambda t: float(found.margins(dense(t), u)[number]), 0.01, 0.4, xtol=1e-13)
    assert abs(lock.time - time) < 1e-6
    assert abs(found.margins(lock.state, u)[number]) < 1e-6


def test_time_of_an_event_does_not_depend_on_samples_or_tolerance() -> None:
    signal = Sine(0.3, 0.4)
    found = [
        simulate(model("b_train"), {"axle_1.steer": signal}, 6.0, sample=sample, tolerance=tolerance)
        for sample, tolerance in ((0.01, 1e-9), (0.37, 1e-9), (0.01, 1e-6))
    ]
    assert [str(event) for event in found[0].events] == [str(event) for event in found[1].events]
    times = [{(event.kind, event.owner): event.time for event in run.events[:8]} for run in found]
    assert times[0].keys() == times[2].keys()
    assert all(abs(times[0][key] - times[2][key]) < 1e-4 for key in times[0])


def ordered(events: tuple[Event, ...], end: float) -> bool:
    """Whether events follow each other, are left after they are reached, and happen before the end."""
    times = [event.time for event in events]
    left = [event.until for event in events if event.until is not None]
    return (
        times == sorted(times)
        and max([*times, *left, 0.0]) <= end + 1e-9
        and all(event.until is None or event.until > event.time for event in events)
    )


def test_a_run_into_rollover_ends_with_a_sentence() -> None:
    run = simulate(model("b_train"), {"axle_1.steer": Sine(0.3, 0.4)}, 6.0, sample=1e-3)
    last = run.events[-1]
    assert last.kind == "rollover"
    assert last.owner in run.ended
    assert "its roll exceeds 30 deg: it has rolled over" in run.ended
    assert run.ended.startswith(f"{last.time:.6g} s: ")
    assert ordered(run.events, last.time)
    assert run.time[-1] <= last.time < run.time[-1] + 1e-3
    assert np.degrees(np.max(np.abs(run.of(f"{last.owner}.roll")))) < 30.0
    kinds = {event.kind for event in run.events}
    assert {"lift", "roll", "rollover"} <= kinds


def test_the_sentence_at_the_end_is_of_the_limit_that_ended_the_run() -> None:
    """Two bodies roll over within the first step, the semitrailer's frame first."""
    start = {"tractor_frame.roll": 0.52359, "semitrailer_1_frame.roll": 0.5235985}
    start |= {name.replace(".roll", ".roll_rate"): 1.0 for name in start}
    run = simulate(model("b_train"), {}, 1.0, start=start)
    assert "semitrailer_1_frame" in run.ended
    assert ordered(run.events, 3e-7)


def test_a_run_that_starts_beyond_a_limit_says_so() -> None:
    run = simulate(model("b_train"), {}, 0.1, start={"tractor_frame.roll": np.radians(12.0)})
    reached = [event for event in run.events if (event.kind, event.owner) == ("roll", "tractor_frame")]
    assert len(reached) == 1
    assert reached[0].time == 0.0


def test_a_run_that_starts_rolled_over_does_not_go_on() -> None:
    run = simulate(model("b_train"), {}, 0.1, start={"tractor_frame.roll": np.radians(35.0)})
    assert "rolled over" in run.ended


def test_a_torque_that_jumps_asks_for_traction_as_one_that_rises_does() -> None:
    """A wheel without spin slides; a torque that steps is one that rises in no time."""
    found = model("tractor_semitrailer_nonlinear")
    step = simulate(found, {"drive_torque": Steps(np.array([0.0, 0.5, 1.0]), np.array([0.0, 1e5, 0.0]))}, 1.5)
    time, value = np.array([0.0, 0.499, 0.5, 1.0, 1.001, 2.0]), np.array([0.0, 0.0, 1e5, 1e5, 0.0, 0.0])
    ramp = simulate(found, {"drive_torque": Table(time, value)}, 1.5)
    told = [[(event.kind, event.owner) for event in run.events] for run in (step, ramp)]
    assert ("traction", "axle_2") in told[1]
    assert sorted(told[0]) == sorted(told[1])
    for own in step.events:
        assert abs(own.time - 0.5) < 2e-3
        assert own.until is not None
        assert abs(own.until - 1.0) < 2e-3


def test_a_vehicle_that_brakes_to_a_stop_stands_still_once() -> None:
    found = model("b_train")
    run = simulate(found, brakes(None, 2e5), 10.0, speed=10.0)
    stands = [event for event in run.events if event.kind == "standstill"]
    assert [event.owner for event in stands] == ["tractor"]
    assert stands[0].until is None
    assert np.max(np.abs(run.of("tractor.speed")[run.time > stands[0].time])) < 0.1 + 1e-6
    assert isinstance(run, Run)
    assert ordered(run.events, 10.0)
