"""Speed keeping holds a speed without a steady error, within its limits, and does not wind up."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.assembly.vectors import Array
from eom.driver import SpeedKeeping
from eom.errors import SimulationError
from eom.simulation.blocks import BlockError
from eom.simulation.sampling import begun, sample_times, updated
from eom.simulation.wiring import wired

MASS, RADIUS, SLOPE, PERIOD, SET = 40_000.0, 0.5, 300.0, 0.05, 20.0
KP, KI = 12_000.0, 3_000.0
SIGNALS, INPUTS = {"tractor.speed": "m/s", "drive_torque": "N*m"}, {"drive_torque": "N*m"}
Values = float | Array


def driven(
    block: SpeedKeeping, start: Values, trim: Values, count: int, drag: Values = 1000.0, period: float = PERIOD
) -> tuple[Array, Array]:
    """Speeds and torques at samples of m v' = T / r - drag - c v, exact between them: from a speed and the trim's T."""
    v = np.asarray(start, dtype=float)
    torque = np.full(v.shape, trim)
    wiring = wired([block], {"drive_torque": f"{block.name}.torque"}, SIGNALS, INPUTS)
    held = begun(wiring, None if v.ndim == 0 else len(v))
    a = np.exp(-SLOPE / MASS * period)
    speeds, torques = list[Array](), list[Array]()
    for instant, _ in zip(sample_times(wiring), range(count), strict=False):
        held = updated(wiring, instant.due, instant.time, np.stack((v, torque)), held)
        torque = held.acting[0]
        speeds.append(v)
        torques.append(torque)
        v = np.asarray(a * v + (1.0 - a) / SLOPE * (torque / RADIUS - drag))
    return np.array(speeds), np.array(torques)


def keeping(**changed: object) -> SpeedKeeping:
    values = {"speed": SET, "kp": KP, "ki": KI, "period": PERIOD, "start": 0.0} | changed
    return SpeedKeeping(**values)  # type: ignore[arg-type]


def test_there_is_no_steady_error() -> None:
    speeds, torques = driven(keeping(), 15.0, 0.0, 3000)
    assert abs(speeds[-1] - SET) < 1e-9
    assert torques[-1] == pytest.approx(RADIUS * (1000.0 + SLOPE * SET), rel=1e-9)


def test_the_error_follows_the_poles_of_the_closed_loop() -> None:
    errors = SET - driven(keeping(), 15.0, 0.0, 200)[0]
    a = np.exp(-SLOPE / MASS * PERIOD)
    b = (1.0 - a) / SLOPE / RADIUS
    # the error's own difference equation, z^2 - (1 + a - b kp) z + a - b kp + b ki T, without a constant
    recurrence = (1.0 + a - b * KP) * errors[1:-1] - (a - b * KP + b * KI * PERIOD) * errors[:-2]
    assert np.allclose(errors[2:], recurrence, rtol=0.0, atol=1e-12 * SET * 10.0)


@given(st.floats(0.05, 0.6), st.floats(0.3, 1.5))
def test_for_short_periods_the_gains_of_the_docstring_give_frequency_and_damping(w: float, d: float) -> None:
    period = 1e-5
    kp = 2.0 * d * w * RADIUS * MASS - SLOPE * RADIUS
    ki = w**2 * RADIUS * MASS
    fall = -np.expm1(-SLOPE / MASS * period)
    b = fall / SLOPE / RADIUS
    # the sampled polynomial of the test above with z = 1 + s T, over T^2
    assert b * ki / period == pytest.approx(w**2, rel=1e-6)
    assert (fall + b * kp) / period == pytest.approx(2.0 * d * w, rel=1e-6)


def test_the_trim_is_an_equilibrium_with_the_torque_that_acts_at_the_start() -> None:
    trim = RADIUS * (1000.0 + SLOPE * SET)
    for own in (keeping(start=None), keeping(start=trim)):
        speeds, torques = driven(own, SET, trim, 100)
        assert np.allclose(torques, trim, rtol=1e-12)
        assert np.allclose(speeds, SET, rtol=1e-12)


@given(
    st.lists(st.floats(-30.0, 70.0), min_size=1, max_size=60),
    st.floats(0.0, 1e5),
    st.floats(0.0, 1e6),
    st.floats(-1e5, 1e4),
    st.floats(1.0, 1e5),
)
def test_the_torque_never_exceeds_its_limits(
    speeds: list[float], kp: float, ki: float, lowest: float, width: float
) -> None:
    own = keeping(kp=kp + 1.0, ki=ki, lowest=lowest, highest=lowest + width)
    for speed in speeds:
        (torque,) = own.update(0.0, np.array([speed]))
        assert lowest <= torque <= lowest + width


@given(st.integers(1, 5000), st.floats(1e-3, 100.0), st.floats(1e-3, 100.0), st.sampled_from([1.0, -1.0]))
def test_after_saturation_of_any_length_the_torque_leaves_its_limit_as_soon_as_the_error_changes_its_sign(
    samples: int, error: float, back: float, sign: float
) -> None:
    own = keeping(lowest=-5000.0, highest=5000.0, ki=1e5)
    for _ in range(samples):
        own.update(0.0, np.array([SET - sign * error]))
    (torque,) = own.update(0.0, np.array([SET + sign * back]))
    assert sign * torque < 5000.0


def test_a_long_saturation_leaves_no_trace_of_its_length() -> None:
    # up a hill that the torque cannot hold, for one or ten minutes, then down again
    after = []
    for minutes in (1, 10):
        own = keeping(lowest=0.0, highest=5000.0)
        speeds, torques = driven(own, SET, 0.0, minutes * 1200, drag=8000.0)
        assert torques[-1] == 5000.0
        assert speeds[-1] < SET
        after.append([own.update(0.0, np.array([v]))[0] for v in (21.0, 20.5, 20.0, 19.9)])
    assert after[0] == after[1]


def test_each_case_of_a_batch_is_its_single_run() -> None:
    changed = {
        "speed": np.array([20.0, 22.0, 25.0]),
        "kp": np.array([12e3, 8e3, 20e3]),
        "ki": np.array([3e3, 1e3, 9e3]),
        "lowest": np.array([0.0, -1e3, -1e4]),
        "highest": np.array([5e3, 6e3, 1e4]),
        "start": np.array([100.0, 200.0, 0.0]),
    }
    v, drag = np.array([15.0, 25.0, 18.0]), np.array([500.0, 1000.0, 2000.0])
    speeds, torques = driven(keeping(**changed), v, 0.0, 400, drag)
    for k in range(3):
        own = keeping(**{name: float(values[k]) for name, values in changed.items()})
        alone = driven(own, float(v[k]), 0.0, 400, float(drag[k]))
        assert np.array_equal(speeds[:, k], alone[0])
        assert np.array_equal(torques[:, k], alone[1])


def test_after_a_reset_a_run_repeats() -> None:
    own = keeping(start=None, highest=6000.0)
    first, second = driven(own, 15.0, 2000.0, 300), driven(own, 15.0, 2000.0, 300)
    assert np.array_equal(first, second)


def test_every_value_that_cannot_be_is_named() -> None:
    with pytest.raises(BlockError) as caught:
        SpeedKeeping(
            speed=float("nan"), kp=np.array([1.0, 0.0]), ki=-1.0, lowest=2.0, highest=1.0, start=np.inf, period=0.0
        )
    assert set(caught.value.wrong) == {"speed", "kp", "ki", "lowest", "start", "period"}
    assert "block speed_keeping: ki is -1.0: expected no less than zero" in str(caught.value)


def test_it_keeps_nothing_but_a_speed() -> None:
    with pytest.raises(SimulationError, match=r"reads 'car\.yaw_rate', which is in rad/s, expected a signal in m/s"):
        wired([keeping(signal="car.yaw_rate")], {}, {"car.yaw_rate": "rad/s"}, {})
