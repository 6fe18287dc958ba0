"""A sensor gives the sample of some periods before, with noise that repeats."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.assembly.vectors import Array
from eom.simulation.blocks import BlockError
from eom.simulation.sensors import Sensor
from eom.simulation.wiring import wired
from tests.simulation.block_samples import sampled

SIGNALS = {"car.yaw_rate": "rad/s"}


def measured(sensor: Sensor, count: int, cases: int | None = None) -> tuple[Array, Array]:
    """What a sensor shows after each sample of sin(t), one row for each case, and the times."""
    wiring = wired([sensor], {}, SIGNALS, {})
    shape = (1,) if cases is None else (1, cases)
    times, held = sampled(wiring, count, lambda t: np.full(shape, np.sin(t)), cases)
    return np.array([item.acting[0] for item in held]), times


@given(st.integers(0, 7), st.sampled_from([0.01, 0.1, 0.3, 1.0 / 3.0, 0.007]))
def test_a_delay_of_k_periods_gives_the_sample_k_periods_before(k: int, period: float) -> None:
    values, times = measured(Sensor("own", "car.yaw_rate", period, delay=k * period), 20)
    assert values[k:].tolist() == np.sin(times[: 20 - k]).tolist()
    # before the start it had measured the same
    assert not values[: k + 1].any()


def test_a_sensor_with_a_delay_closes_a_loop_and_one_without_does_not() -> None:
    assert Sensor("own", "car.yaw_rate", 0.1).direct
    assert not Sensor("own", "car.yaw_rate", 0.1, delay=0.1).direct


def test_noise_has_the_stated_deviation_and_no_mean_and_no_memory() -> None:
    values, times = measured(Sensor("own", "car.yaw_rate", 0.01, noise=0.3, seed=5), 20_000)
    noise = values - np.sin(times)
    # four standard errors
    assert abs(np.mean(noise)) < 4.0 * 0.3 / np.sqrt(20_000)
    assert abs(np.std(noise) / 0.3 - 1.0) < 4.0 / np.sqrt(40_000)
    assert abs(np.corrcoef(noise[1:], noise[:-1])[0, 1]) < 4.0 / np.sqrt(20_000)


def test_noise_repeats_after_reset_and_differs_between_seeds() -> None:
    sensor = Sensor("own", "car.yaw_rate", 0.01, delay=0.02, noise=0.3, seed=5)
    first, second = measured(sensor, 50)[0], measured(sensor, 50)[0]
    assert first.tolist() == second.tolist()
    other = measured(Sensor("own", "car.yaw_rate", 0.01, delay=0.02, noise=0.3, seed=6), 50)[0]
    assert np.all(first != other)


def test_each_case_of_a_batch_is_the_single_run_of_its_seed_and_deviation() -> None:
    noise, seeds = np.array([0.1, 0.2, 0.0]), [3, 4, 3]
    batch = measured(Sensor("own", "car.yaw_rate", 0.01, 0.03, noise, seeds), 30, cases=3)[0]
    same = measured(Sensor("own", "car.yaw_rate", 0.01, 0.03, 0.1, 3), 30, cases=2)[0]
    for k in range(3):
        alone = measured(Sensor("own", "car.yaw_rate", 0.01, 0.03, float(noise[k]), seeds[k]), 30)[0]
        assert batch[:, k].tolist() == alone.tolist()
    assert same[:, 0].tolist() == same[:, 1].tolist() == batch[:, 0].tolist()


def test_every_value_that_cannot_be_is_named() -> None:
    with pytest.raises(BlockError) as caught:
        Sensor("own", "car.yaw_rate", 0.01, delay=0.013, noise=-1.0, seed=-1)
    assert set(caught.value.wrong) == {"delay", "noise", "seed"}
    assert "block own: delay is 0.013 s: expected a whole number of periods of 0.01 s" in str(caught.value)


@pytest.mark.parametrize("period", [0.0, -1.0, float("nan"), float("inf")])
def test_a_period_is_positive_and_finite(period: float) -> None:
    with pytest.raises(BlockError, match="block own: period is"):
        Sensor("own", "car.yaw_rate", period)


@pytest.mark.parametrize("delay", [-0.01, float("nan"), float("inf")])
def test_a_delay_is_not_negative_and_finite(delay: float) -> None:
    with pytest.raises(BlockError, match="block own: delay is"):
        Sensor("own", "car.yaw_rate", 0.01, delay=delay)
