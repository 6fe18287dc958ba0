"""Batches: a case is its single run to the last bit, whatever the others are and whichever thread computes it."""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest

from eom.assembly.vectors import Array
from eom.driver.speed_keeping import SpeedKeeping
from eom.errors import AnalysisError, SimulationError
from eom.model.linear import linearise
from eom.model.tyre import TyreModel, build_tyre_model
from eom.simulation import (
    Block,
    Case,
    Event,
    Run,
    RunInterrupted,
    Sensor,
    Sine,
    Steps,
    Table,
    batch,
    simulate,
    simulate_many,
)
from eom.simulation.progress import Progress
from eom.simulation.runs import Runs
from tests.simulation.block_samples import Function
from tests.splice.shared import model
from tests.vehicles.shipped import vehicle

pytest.importorskip("numba")

TRAIN = "tractor_semitrailer_nonlinear"
STEER, TORQUE, ANGLE = "axle_1.steer", "drive_torque", "semitrailer_frame.yaw_from_tractor_frame"
SWERVE = {STEER: Sine(0.03, 0.5)}
END = 1.5
METHODS: dict[str, dict[str, Any]] = {
    "automatic": {},
    "rk4": {"method": "rk4", "step": 0.01},
    "rosenbrock": {"method": "rosenbrock"},
}

CASES = (
    Case(),
    Case(SWERVE),
    Case({STEER: lambda t: 0.02 * np.sin(3.0 * t), TORQUE: 3000.0}),
    Case(start={"tractor_frame.yaw_rate": 0.2, "tractor_frame.v_y": -0.4}),
    Case({STEER: Steps(np.array([0.2, 0.7]), np.array([0.05, -0.05]))}, speed=12.0),
    Case(SWERVE, parameters={"mu": 0.3}),
    Case(
        {"axle_2.steer": Table(np.array([0.0, 0.5, 2.0]), np.array([0.0, 0.02, 0.0]))},
        speed=30.0,
        parameters={"tractor_frame.mass": 9000.0, "semitrailer_frame.inertia.zz": 2e5},
    ),
    # over at once, soon, and when the table ends
    Case(start={ANGLE: 1.1}),
    Case(start={ANGLE: 0.9, "semitrailer_frame.yaw_rate": 1.0}),
    Case({STEER: Table(np.array([0.0, 0.55]), np.array([0.0, 0.01]))}),
    # a step of 10 ms is too long for this one
    Case(SWERVE, speed=0.5),
)
"""Cases that differ in all that cases may differ in, and end in all ways."""
AT_ONCE, SOON, SHORT, SLOW = 7, 8, 9, 10


@pytest.fixture(autouse=True)
def _goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A batch that stands still is a failure, not a wait for ever."""
    stands = [0.0]

    def reached(_: Progress, now: float) -> None:
        stands[:] = [*stands, now] if now == stands[-1] else [now]
        assert len(stands) < 100, f"no case goes on after {now:g} s"

    monkeypatch.setattr(Progress, "reached", reached)


def train() -> TyreModel:
    return model(TRAIN)


def alone(case: Case, duration: float = END, **options: Any) -> Run:
    """The single run of a case, until it broke down if it did."""
    own = train()
    if case.parameters:
        own = build_tyre_model(own.vehicle.with_values(**case.parameters))
    try:
        return simulate(own, case.inputs, duration, start=case.start, speed=case.speed, **options)
    except SimulationError as error:
        partial = error.partial
    if not isinstance(partial, Run):
        raise TypeError(partial)
    return partial


def told(events: Sequence[Event]) -> list[tuple[object, ...]]:
    """All that events say."""
    return [(event.kind, event.owner, event.time, event.until, event.state.tobytes()) for event in events]


def assert_same(runs: Runs, k: int, run: Run) -> None:
    """A case is a run: signals to the last bit, nothing after its end, events, sentence."""
    count = len(run.time)
    assert np.array_equal(runs.time[:count], run.time)
    for name in runs.signals:
        assert np.array_equal(runs.of(name)[k, :count], run.of(name), equal_nan=True), (k, name)
        assert np.all(np.isnan(runs.of(name)[k, count:])), (k, name)
    assert told(runs.events[k]) == told(run.events)
    assert runs.ended[k] == run.ended


@cache
def every_case(method: str) -> Runs:
    """The batch of all cases, in one thread."""
    return simulate_many(train(), CASES, END, threads=1, **METHODS[method])


@pytest.mark.parametrize("method", METHODS)
def test_a_case_is_the_single_run_of_it_to_the_last_bit(method: str) -> None:
    runs = every_case(method)
    assert set(runs.signals) == {*(f"state:{name}" for name in train().states), *train().inputs, *train().outputs}
    for k, case in enumerate(CASES):
        assert_same(runs, k, alone(case, **METHODS[method]))


@pytest.mark.parametrize("method", METHODS)
def test_a_case_does_not_depend_on_their_number_their_order_or_threads(method: str) -> None:
    order = np.random.default_rng(3).permutation(np.repeat(np.arange(len(CASES)), 3))
    runs, wanted = (
        simulate_many(train(), [CASES[k] for k in order], END, threads=2, **METHODS[method]),
        every_case(method),
    )
    for k, case in enumerate(order):
        assert np.array_equal(runs.values[k], wanted.values[case], equal_nan=True)
        assert told(runs.events[k]) == told(wanted.events[case])
        assert runs.ended[k] == wanted.ended[case]


def test_a_case_does_not_depend_on_where_the_runs_pause(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Progress, "next_stop", lambda _, now, __: now + 0.0137)
    runs = simulate_many(train(), [CASES[1], CASES[SOON]], END)
    for k, case in enumerate((1, SOON)):
        assert np.array_equal(runs.values[k], every_case("automatic").values[case], equal_nan=True)


def test_a_case_that_ends_says_why_and_is_not_a_number_afterwards() -> None:
    runs = every_case("rk4")
    last = [int(np.sum(np.isfinite(own))) for own in runs.of("tractor.yaw_rate")]
    assert last[AT_ONCE] == 1
    assert 1 < last[SOON] < 50
    assert last[SHORT] == 56
    assert last[0] == len(runs.time) == 151
    for k, words in (
        (AT_ONCE, "0 s: semitrailer: "),
        (SOON, "beyond it"),
        (SHORT, "ends at 0.55 s"),
        (SLOW, "unstable"),
    ):
        assert words in runs.ended[k]
    assert [k for k, sentence in enumerate(runs.ended) if sentence] == [AT_ONCE, SOON, SHORT, SLOW]
    assert [event.kind for event in runs.events[SOON]].count("jackknife") == 2


def test_a_case_whose_input_ends_does_not_keep_the_others_from_going_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A pause that is short on the wall is short in the run too; every one has to bring some case further."""
    monkeypatch.setattr(batch, "SLICE", 1e-9)
    runs = simulate_many(train(), [CASES[SHORT], Case()], END, threads=1)
    assert np.all(np.isfinite(runs.of("tractor.speed")[1]))


@pytest.mark.parametrize("others", [(), (Case(),)])
def test_parameters_act_whether_all_cases_share_them_or_not(others: tuple[Case, ...]) -> None:
    case = Case(SWERVE, parameters={"mu": 0.3})
    runs = simulate_many(train(), [case, case, *others], END)
    assert_same(runs, 0, alone(case))
    assert_same(runs, 1, alone(case))


@pytest.mark.parametrize(("name", "values"), [("fifth_wheel.at.tractor.y", (0.03, 0.0)), ("mu", (1.0, 0.7))])
def test_a_case_does_not_depend_on_which_numbers_of_others_are_zero_or_one(
    name: str, values: tuple[float, ...]
) -> None:
    cases = [Case(SWERVE, parameters={name: value}) for value in values]
    runs = simulate_many(train(), cases, 1.0)
    for k, case in enumerate(cases):
        own = alone(case, 1.0)
        for name_, column in zip(runs.signals, runs.values[k].T, strict=True):
            # sums of other terms pair in another order
            expected = own.of(name_)
            assert np.max(np.abs(column - expected)) <= 1e-12 * max(1.0, float(np.max(np.abs(expected))))


def test_parameters_that_change_the_structure_are_refused() -> None:
    """Without lag the torque of the drive is no state."""
    with pytest.raises(SimulationError, match="structure"):
        simulate_many(model("car"), [Case(), Case(parameters={"drive.lag": 0.0})], 0.1)


def test_linear_models_are_simulated_as_alone() -> None:
    found = linearise(vehicle("car_trailer"))
    cases = [Case({found.inputs[0]: Sine(0.02, 0.5 + k)}, start={found.states[-1]: 0.01 * k}) for k in range(3)]
    runs = simulate_many(found, cases, 1.0)
    for k, case in enumerate(cases):
        assert_same(runs, k, simulate(found, case.inputs, 1.0, start=case.start))
    with pytest.raises(SimulationError) as caught:
        simulate_many(found, [Case(), Case(speed=3.0), Case(parameters={"U": 3.0})], 1.0)
    assert "case 1: speed" in str(caught.value)
    assert "case 2: a linear model has no parameters" in str(caught.value)


# blocks

SPEEDS, GAINS, SEEDS = np.array([24.0, 26.0, 20.0, 24.4]), np.array([9e3, 9e3, 2e4, 1e4]), np.array([4, 4, 7, 2**40])
LIMITS = np.array([900.0, 2500.0, 4000.0, 1e9])
WITH_BLOCKS = (CASES[1], Case(), Case(SWERVE, speed=20.5, parameters={"mu": 0.5}), CASES[SOON])
WIRES = {TORQUE: "speed_keeping.torque"}


def keeper(k: Any) -> SpeedKeeping:
    """That of a case, or of some."""
    return SpeedKeeping(SPEEDS[k], kp=GAINS[k], ki=0.3 * GAINS[k], highest=LIMITS[k], period=0.02)


def gyro(k: Any, noise: Any = 0.01) -> Sensor:
    """That of a case, or of some."""
    seed = SEEDS[k]
    return Sensor("gyro", "tractor.yaw_rate", 0.05, delay=0.1, noise=noise, seed=seed if np.ndim(seed) else int(seed))


@pytest.mark.parametrize("method", METHODS)
def test_blocks_of_a_case_are_those_of_its_single_run(method: str) -> None:
    every, options = slice(None), METHODS[method]
    blocks: list[Block] = [keeper(every), gyro(every)]
    for _ in range(2):
        runs = simulate_many(train(), WITH_BLOCKS, END, blocks=blocks, wires=WIRES, sample=0.025, **options)
        assert runs.signals[-2:] == ("speed_keeping.torque", "gyro.value")
        for k, case in enumerate(WITH_BLOCKS):
            own: list[Block] = [keeper(k), gyro(k)]
            assert_same(runs, k, alone(case, blocks=own, wires=WIRES, sample=0.025, **options))
    assert np.array_equal(runs.units[-2:], ["N*m", "rad/s"])
    clipped = runs.of("speed_keeping.torque")[1]
    assert np.max(clipped) == LIMITS[1]


def test_seeds_that_differ_give_noise_that_differs_and_the_same_gives_the_same() -> None:
    cases = [Case()] * 4
    runs = simulate_many(train(), cases, 0.5, blocks=[gyro(slice(None), np.array([0.1, 0.1, 0.1, 0.0]))], sample=0.05)
    noise = runs.of("gyro.value")
    assert np.array_equal(noise[0], noise[1])
    assert not np.any(noise[0] == noise[2])
    np.testing.assert_allclose(noise[3], 0.0, atol=1e-12)


def test_blocks_do_not_depend_on_batch_order_or_threads() -> None:
    order = np.tile([2, 0, 3, 1], 5)
    runs = simulate_many(
        train(), [WITH_BLOCKS[k] for k in order], END, blocks=[keeper(order), gyro(order)], wires=WIRES, threads=2
    )
    wanted = simulate_many(
        train(), WITH_BLOCKS, END, blocks=[keeper(slice(None)), gyro(slice(None))], wires=WIRES, threads=1
    )
    assert np.array_equal(runs.values, wanted.values[order], equal_nan=True)


def test_with_blocks_the_sample_at_the_end_of_an_input_is_taken() -> None:
    """The table ends at a sample of the block, between two, and at none of the results."""
    for end in (0.3, 0.35, 0.333):
        case = Case({STEER: Table(np.array([0.0, end]), np.array([0.0, 0.01]))})
        options: dict[str, Any] = {"sample": 0.05}
        runs = simulate_many(train(), [case, Case()], 0.6, blocks=[Sensor("gyro", "tractor.yaw_rate", 0.1)], **options)
        assert_same(runs, 0, alone(case, 0.6, blocks=[Sensor("gyro", "tractor.yaw_rate", 0.1)], **options))


def test_a_block_that_fails_names_itself_and_the_cases() -> None:
    def wrong(t: float, y: Any) -> Any:
        return np.where((t > 0.15) & (np.arange(y.shape[1]) != 1), np.nan, y)

    with pytest.raises(SimulationError, match=r"block fails at 0\.2 s: gave out = nan in case 0, 2"):
        simulate_many(train(), [Case()] * 3, 0.5, blocks=[Function("fails", ("tractor.ay",), wrong)])


# what is kept

KEEP = ("tractor.yaw_rate", "state:tractor_frame.v_x", STEER, "axle_3.Fy")


def test_signals_that_are_kept_are_those_of_all_in_the_order_asked() -> None:
    runs = simulate_many(train(), CASES, END, keep=KEEP)
    assert runs.signals == KEEP
    assert runs.units == ("rad/s", "m/s", "rad", "N")
    assert runs.values.shape == (len(CASES), 151, 4)
    for name in KEEP:
        assert np.array_equal(runs.of(name), every_case("automatic").of(name), equal_nan=True)
    assert runs.ended == every_case("automatic").ended
    with pytest.raises(AnalysisError, match=r"tractor\.ay: was not kept"):
        runs.of("tractor.ay")


def test_ports_of_blocks_are_kept_besides_what_is_named() -> None:
    wanted = simulate_many(train(), [CASES[1], CASES[SOON]], 0.5, blocks=[gyro(slice(2))], sample=0.05)
    for keep in (KEEP, (), ("tractor.ltr",)):
        runs = simulate_many(train(), [CASES[1], CASES[SOON]], 0.5, keep=keep, blocks=[gyro(slice(2))], sample=0.05)
        assert runs.signals == (*keep, "gyro.value")
        assert np.array_equal(runs.of("gyro.value"), wanted.of("gyro.value"), equal_nan=True)


def test_nothing_needs_to_be_kept() -> None:
    runs = simulate_many(train(), [Case(), CASES[SOON]], 0.5, keep=())
    assert runs.values.shape == (2, 51, 0)
    assert [bool(sentence) for sentence in runs.ended] == [False, True]


def test_data_has_every_signal_with_its_unit_over_case_and_time() -> None:
    runs = simulate_many(train(), [CASES[1], CASES[SOON]], END, keep=KEEP, blocks=[gyro(slice(2))])
    data = runs.data()
    assert dict(data.sizes) == {"case": 2, "time": 151}
    assert list(data.data_vars) == [*KEEP, "gyro.value"]
    for name, unit in zip(runs.signals, runs.units, strict=True):
        assert data[name].dims == ("case", "time")
        assert data[name].attrs["units"] == unit
        assert np.array_equal(data[name].values, runs.of(name), equal_nan=True)
    assert np.array_equal(data["time"].values, runs.time)
    assert [str(sentence) for sentence in data["ended"].values] == list(runs.ended)
    assert data.attrs["vehicle"] == train().vehicle.name


# mistakes


def mistakes(ask: Callable[[], object]) -> list[str]:
    """The sentences of the error."""
    with pytest.raises(SimulationError) as caught:
        ask()
    return str(caught.value).splitlines()


def test_all_mistakes_of_all_cases_are_told_with_their_numbers() -> None:
    cases = [
        Case(),
        Case({"axle_1.ster": 0.1, TORQUE: np.nan}),
        Case(start={"tractor_frame.vx": 1.0}),
        Case(),
        Case({STEER: Table(np.array([0.0, 0.0]), np.zeros(2))}, start={"tractor_frame.v_x": np.inf}),
    ]
    found = mistakes(lambda: simulate_many(train(), cases, 1.0))
    wanted = (
        ("case 1: ", "axle_1.ster", f"did you mean '{STEER}'"),
        ("case 1: ", TORQUE, "nan"),
        ("case 2: ", "tractor_frame.vx", "did you mean"),
        ("case 4: ", STEER, "grow"),
        ("case 4: ", "tractor_frame.v_x", "inf"),
    )
    assert len(found) == len(wanted)
    for words in wanted:
        assert any(line.startswith(words[0]) and all(word in line for word in words) for line in found), words


def test_mistakes_of_cases_and_of_what_is_kept_are_told_at_once() -> None:
    found = mistakes(lambda: simulate_many(train(), [Case({"steer": 0.0})], 1.0, keep=["tractor.yawrate", "ay"]))
    assert len(found) == 3
    assert any("keep tractor.yawrate" in line and "did you mean 'tractor.yaw_rate'" in line for line in found)
    assert any(line.startswith("case 0: input steer") for line in found)


def test_cases_are_needed_and_room_for_them() -> None:
    assert mistakes(lambda: simulate_many(train(), [], 1.0)) == ["cases: expected one or more"]
    (line,) = mistakes(lambda: simulate_many(train(), [Case()] * 1000, 100.0, sample=1e-3))
    assert "GB" in line


@pytest.mark.parametrize("threads", [-1, 0])
def test_threads_that_cannot_be_are_refused(threads: int) -> None:
    (line,) = mistakes(lambda: simulate_many(train(), [Case()] * 20, 0.1, threads=threads))
    assert "threads" in line
    assert str(threads) in line


def test_what_only_a_case_makes_impossible_is_told_with_its_number() -> None:
    """An input that ends at the start, in two cases."""
    ends = Case({STEER: Table(np.array([0.0]), np.array([0.0]))})
    found = mistakes(lambda: simulate_many(train(), [Case(), ends, ends], 1.0))
    assert [line[:8] for line in found] == ["case 1: ", "case 2: "]


def test_parameters_that_no_vehicle_has_are_refused() -> None:
    with pytest.raises(SimulationError, match=r"case 1: .*mew"):
        simulate_many(train(), [Case(), Case(parameters={"mew": 0.3})], 1.0)


class Failing:
    """A block that fails, or interrupts, after some samples."""

    name, period = "failing", 0.05
    inputs, outputs, units = ("tractor.ay",), ("held",), ("m/s^2",)

    def __init__(self, error: BaseException, after: int) -> None:
        self.error, self.after = error, after
        self.reset()

    def reset(self) -> None:
        """Count anew."""
        self.count = 0

    def update(self, t: float, y: Array) -> Array:
        """What it reads, so many times."""
        del t
        self.count += 1
        if self.count > self.after:
            raise self.error
        return y


@pytest.mark.parametrize("error", [ValueError("no more"), KeyboardInterrupt()])
def test_what_was_computed_before_a_failure_or_an_interrupt_is_kept(error: BaseException) -> None:
    cases = [Case(SWERVE), Case()]
    with pytest.raises((SimulationError, RunInterrupted)) as stopped:
        simulate_many(train(), cases, 1.0, blocks=[Failing(error, 3)])
    partial = getattr(stopped.value, "partial", None)
    assert isinstance(partial, Runs)
    whole = simulate_many(train(), cases, 1.0, blocks=[Failing(error, 99)])
    taken = partial.time < 0.15
    for name in whole.signals:
        assert np.array_equal(partial.of(name)[:, taken], whole.of(name)[:, taken])
        assert np.all(np.isnan(partial.of(name)[:, ~taken]))
