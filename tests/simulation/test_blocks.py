"""Blocks act in the order of their wires, at exact times, and say what is wrong with them."""

from fractions import Fraction
from itertools import islice, pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import SimulationError
from eom.simulation.blocks import Block
from eom.simulation.sampling import begun, updated
from eom.simulation.sampling_times import instants
from eom.simulation.sensors import Sensor
from eom.simulation.wiring import Wiring, wired
from tests.simulation.block_samples import Function, add_one, sampled

SIGNALS = {"car.speed": "m/s", "car.yaw_rate": "rad/s", "torque": "N*m", "state:x": "m"}
INPUTS = {"torque": "N*m", "steer": "rad"}
Y = np.array([1.0, 2.0, 3.0, 4.0])


def connected(*blocks: Block, **wires: str) -> Wiring:
    return wired(blocks, wires, SIGNALS, INPUTS)


def port_values(wiring: Wiring, acting: np.ndarray) -> dict[str, float]:
    return dict(zip(wiring.signals, acting.tolist(), strict=True))


@st.composite
def graphs(draw: st.DrawFn) -> tuple[list[list[int]], list[int]]:
    """Which earlier blocks each block reads, and an order in which the blocks are given."""
    count = draw(st.integers(1, 8))
    reads = [draw(st.lists(st.integers(0, k - 1), unique=True, max_size=3)) if k else [] for k in range(count)]
    return reads, draw(st.permutations(range(count)))


@given(graphs())
def test_the_order_of_evaluation_follows_the_wires_whatever_the_order_in_the_list(
    graph: tuple[list[list[int]], list[int]],
) -> None:
    reads, order = graph
    blocks = [Function(f"b{k}", ("car.speed", *(f"b{j}.out" for j in reads[k])), add_one) for k in range(len(reads))]
    expected: list[float] = []
    for own in reads:
        expected.append(Y[0] + 1.0 + sum(expected[j] for j in own))
    wiring = connected(*(blocks[k] for k in order))
    _, (held,) = sampled(wiring, 1, lambda _: Y)
    assert port_values(wiring, held.acting) == {f"b{k}.out": value for k, value in enumerate(expected)}


def test_what_a_slow_block_gives_is_held_between_its_samples() -> None:
    slow = Function("slow", ("car.speed",), lambda _, y: y, period=0.3)
    fast = Function("fast", ("slow.out", "car.speed"), lambda _, y: y[1:] - y[:1], period=0.1)
    wiring = connected(fast, slow)
    times, found = sampled(wiring, 7, lambda t: Y + t)
    acting = np.array([held.acting for held in found])
    assert np.allclose(acting[:, 0], times - np.floor(times / 0.3 + 1e-9) * 0.3, rtol=0.0, atol=1e-12)
    assert slow.times == [0.0, 0.3, 0.6]
    assert fast.times == times.tolist()


def test_a_cycle_of_direct_blocks_is_named_along_its_wires() -> None:
    blocks = [Function(name, (f"{before}.out",), add_one) for before, name in pairwise("cabc")]
    with pytest.raises(SimulationError) as caught:
        connected(*blocks, Function("d", ("a.out",), add_one))
    assert "a -> b -> c -> a" in str(caught.value)
    assert "direct = False" in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_a_block_that_is_not_direct_closes_a_cycle_and_acts_one_sample_later() -> None:
    one = Function("one", ("two.out",), lambda _, y: 2.0 * y)
    two = Function("two", ("one.out", "car.speed"), lambda _, y: y[:1] + y[1:], direct=False)
    wiring = connected(two, one)
    _, found = sampled(wiring, 5, lambda t: Y + 10.0 * t)
    acting = np.array([held.acting for held in found])
    # two(n) = one(n-1) + speed(n-1), one(n) = 2 two(n); the first result of two acts at once
    speeds = Y[0] + np.arange(5.0)
    assert acting[0].tolist() == [speeds[0], 0.0]
    for n in range(1, 5):
        assert acting[n, 0] == acting[n - 1, 1] + speeds[n - 1]
        assert acting[n, 1] == 2.0 * acting[n, 0]


@pytest.mark.parametrize("reverse", [False, True])
def test_the_first_result_of_a_delayed_block_is_there_for_all_that_read_it(reverse: bool) -> None:
    late = Function("late", ("car.speed",), lambda _, y: y, direct=False)
    blocks = [late, Function("reader", ("late.out",), add_one)]
    wiring = connected(*(blocks[::-1] if reverse else blocks))
    _, found = sampled(wiring, 3, lambda t: Y + 10.0 * t)
    assert [port_values(wiring, held.acting)["reader.out"] for held in found] == [Y[0] + 1.0, Y[0] + 1.0, Y[0] + 2.0]


@given(st.lists(st.integers(1, 3000), min_size=1, max_size=4), st.sampled_from([1000, 300, 7]))
def test_samples_of_commensurate_periods_coincide_exactly(multiples: list[int], per_second: int) -> None:
    found = list(islice(instants([multiple / per_second for multiple in multiples]), 200))
    for instant in found:
        ticks = Fraction(instant.time).limit_denominator(10**6) * per_second
        assert ticks.denominator == 1
        assert instant.due == tuple(k for k, multiple in enumerate(multiples) if ticks % multiple == 0)
        assert instant.time == float(ticks / per_second)
    assert all(a.time < b.time for a, b in pairwise(found))
    # none is left out
    end = Fraction(found[-1].time).limit_denominator(10**6) * per_second
    assert len(found) == len({k * m for m in multiples for k in range(int(end) // m + 1)})


def test_without_blocks_there_are_no_samples() -> None:
    assert list(instants([])) == []
    wiring = connected()
    assert updated(wiring, (), 0.0, Y, begun(wiring)).acting.shape == (0,)


def test_every_mistake_of_a_wiring_is_said_at_once() -> None:
    with pytest.raises(SimulationError) as caught:
        connected(
            Function("a", ("car.sped",), add_one),
            Function("b", ("c.out", "b.nothing"), add_one),
            Function("c", ("b.out",), add_one),
            Function("car", (), add_one, outputs=("speed",)),
            Function("e", ("car.yaw_rate",), add_one, input_units=("m/s",)),
            Function("f", (), add_one, units=("deg",)),
            torque="a.uot",
            steer="f.out",
            ster="a.out",
        )
    for sentence in (
        "block a: reads 'car.sped': there is no such signal; did you mean 'car.speed'?",
        "block b: waits for itself, b -> c -> b: make one of them 'direct = False'",
        "block b: reads 'b.nothing': there is no such signal",
        "block car: its port 'car.speed' has the name of a signal of the model",
        "block e: reads 'car.yaw_rate', which is in rad/s, expected a signal in m/s",
        "wire torque: expected a port 'BLOCK.PORT', got 'a.uot': there is no such port; did you mean 'a.out'?",
        "wire steer: 'f.out' is in deg, expected rad",
        "wire ster: there is no such input; did you mean 'steer'?",
    ):
        assert sentence in str(caught.value)
    assert len(str(caught.value).splitlines()) == 8


def test_every_mistake_of_blocks_as_such_is_said_at_once() -> None:
    with pytest.raises(SimulationError) as caught:
        connected(
            Function("a", ("car.speed",), add_one, period=0.0),
            Function("a", ("car.speed",), add_one, period=float("nan")),
            Function("b.c", (), add_one, outputs=("x", "x"), units=("",)),
            Function("d", "car.speed", add_one),  # type: ignore[arg-type]
            Sensor,  # type: ignore[arg-type]
            "text",  # type: ignore[arg-type]
        )
    for sentence in (
        "block a: period: expected a time of at least 1e-09 s, got 0.0",
        "block a: period: expected a time of at least 1e-09 s, got nan",
        "block a: the name is given twice",
        "block b.c: 'b.c' is no name",
        "block b.c: has the port 'x' twice",
        "block b.c: units: expected 2, got 1",
        "block d: inputs: expected a tuple of names, got 'car.speed'",
        "block number 5: expected a block with name,",
        "got the class Sensor",
        "block number 6: expected a block with name,",
    ):
        assert sentence in str(caught.value)
    assert len(str(caught.value).splitlines()) == 9


def test_a_signal_of_the_model_drives_nothing_without_a_sensor() -> None:
    with pytest.raises(SimulationError, match=r"got 'car\.speed': a sensor makes one of it"):
        connected(torque="car.speed")


def test_wires_name_ports_and_inputs_by_their_places() -> None:
    two = Function("two", (), add_one, outputs=("x", "y"), units=("N*m", "rad"))
    wiring = connected(Function("one", ("state:x",), add_one), two, torque="two.x", steer="two.y")
    assert wiring.signals == ("one.out", "two.x", "two.y")
    assert [list(INPUTS)[k] for k in wiring.inputs] == ["torque", "steer"]
    assert [wiring.signals[k] for k in wiring.sources] == ["two.x", "two.y"]


def test_the_port_of_a_sensor_has_the_unit_of_what_it_measures_through_a_chain() -> None:
    chain = [Sensor("c", "b.value", 0.1), Sensor("b", "a.value", 0.1), Sensor("a", "car.yaw_rate", 0.1)]
    assert connected(*chain).units == ("rad/s",) * 3


def test_an_exception_in_a_block_names_block_and_time_and_is_chained() -> None:
    def fails(t: float, _: object) -> object:
        if t > 0.15:
            raise KeyError("gain")
        return np.zeros(1)

    with pytest.raises(SimulationError, match=r"^block own at 0\.2 s: raised KeyError: 'gain'$") as caught:
        sampled(connected(Function("own", ("car.speed",), fails)), 5, lambda _: Y)
    assert isinstance(caught.value.__cause__, KeyError)


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (np.zeros(2), r"gave an array of shape \(2,\), expected \(1,\)"),
        (0.0, r"gave an array of shape \(\), expected \(1,\)"),
        (None, r"gave out = nan, expected a finite number"),
        ("much", "raised ValueError: could not convert"),
        ([np.inf], r"gave out = inf, expected a finite number"),
    ],
)
def test_what_a_block_gives_is_refused_by_name_if_it_is_no_finite_number_for_each_port(
    given: object, sentence: str
) -> None:
    given = [None] if given is None else given
    with pytest.raises(SimulationError, match=f"block own at 0 s: {sentence}"):
        sampled(connected(Function("own", ("car.speed",), lambda *_: given)), 1, lambda _: Y)


def test_a_single_run_whose_signals_are_not_finite_is_refused_by_their_names() -> None:
    wiring = connected(Function("own", ("torque", "car.speed"), add_one))
    with pytest.raises(SimulationError, match=r"block own at 0 s: reads car\.speed, which is not finite"):
        sampled(wiring, 1, lambda _: np.array([np.nan, 0.0, 0.0, 0.0]))


def test_in_a_batch_a_case_that_has_ended_says_nothing_about_a_block_and_others_are_named() -> None:
    wiring = connected(Function("own", ("car.speed",), lambda _, y: np.where(y > 2.0, np.inf, y)))
    y = np.vstack([[np.nan, 1.0, 2.0], np.zeros((3, 3))])
    _, (held,) = sampled(wiring, 1, lambda _: y, cases=3)
    assert np.array_equal(held.acting, [[np.nan, 1.0, 2.0]], equal_nan=True)
    y[0, 2] = 3.0
    with pytest.raises(SimulationError, match="block own at 0 s: gave out = inf in case 2, expected"):
        sampled(wiring, 1, lambda _: y, cases=3)


def test_a_sample_changes_nothing_that_it_is_given() -> None:
    def spoils(_: float, y: np.ndarray) -> np.ndarray:
        y[:] = 7.0
        return y

    wiring = connected(Function("a", ("car.speed",), spoils), Function("b", ("a.out", "car.speed"), add_one))
    before, y = begun(wiring), Y.copy()
    held = updated(wiring, (0, 1), 0.0, y, before)
    assert np.array_equal(y, Y)
    assert not before.acting.any()
    assert not before.started.any()
    assert held.acting.tolist() == [7.0, 7.0 + Y[0] + 1.0]
