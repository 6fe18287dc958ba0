"""What is of another kind than expected, from Python: sentences, all at once, where they can be; no other error."""

from typing import Any

import numpy as np
import pytest

from eom.errors import SimulationError
from eom.simulation import Case, Constant, Sensor, Sine, Steps, Table, simulate, simulate_many
from eom.simulation.blocks import BlockError
from eom.simulation.kinds import are_numbers, is_number
from tests.splice.shared import model

STEER = "axle_1.steer"
NUMBER = "expected a number"
ROWS = "input axle_1.steer: expected rows of numbers as times and values"


def car() -> Any:
    return model("tractor_semitrailer_nonlinear")


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"duration": "1 s"}, f"duration = '1 s': {NUMBER}"),
        ({"duration": None}, f"duration = None: {NUMBER}"),
        ({"speed": "20 m/s"}, f"speed = '20 m/s': {NUMBER}"),
        ({"tolerance": "small"}, f"tolerance = 'small': {NUMBER}"),
        ({"step": [1.0]}, rf"step = \[1.0\]: {NUMBER}"),
        ({"sample": True}, f"sample = True: {NUMBER}"),
        ({"speed": np.nan}, "speed = nan: expected a speed above zero, in m/s"),
        ({"speed": np.inf}, "speed = inf: expected a speed above zero"),
        ({"speed": -3.0}, r"speed = -3\.0: expected a speed above zero"),
        ({"speed": 0.0}, r"speed = 0\.0: expected a speed above zero"),
        ({"method": ["rk4"]}, r"method = \['rk4'\]: expected automatic"),
        ({"method": None}, "method = None: expected automatic"),
        ({"start": {"tractor_frame.v_x": "a"}}, f"start of tractor_frame.v_x = 'a': {NUMBER}"),
        ({"start": [1.0]}, "start: expected a mapping by name, got a list"),
        ({"inputs": None}, "inputs: expected a mapping by name, got None"),
        ({"inputs": {3: 0.1}}, "inputs: 3 is no name"),
        ({"wires": [1]}, "wires: expected a mapping by name, got a list"),
        ({"wires": {"drive_torque": 3}}, "wire drive_torque: expected a port 'BLOCK.PORT', got 3"),
        ({"blocks": Sensor("a", "tractor.ay", 0.1)}, "blocks: expected a list of blocks, got a Sensor"),
        ({"inputs": {STEER: Table(["a"], ["b"])}}, ROWS),  # type: ignore[arg-type]
        ({"inputs": {STEER: Table([0, [1]], [0, 1])}}, ROWS),  # type: ignore[arg-type]
        ({"inputs": {STEER: Steps(None, None)}}, ROWS),  # type: ignore[arg-type]
        ({"inputs": {STEER: Sine("a", 1.0)}}, "input axle_1.steer: expected a sine of finite"),  # type: ignore[arg-type]
        ({"inputs": {STEER: Constant("a")}}, "input axle_1.steer is 'a', expected a finite"),  # type: ignore[arg-type]
        ({"inputs": {STEER: True}}, "input axle_1.steer is of type bool"),
    ],
)
def test_a_run_that_is_asked_for_in_other_kinds_is_refused_with_a_sentence(asked: Any, sentence: str) -> None:
    with pytest.raises(SimulationError, match=rf"^{sentence}"):
        simulate(car(), **{"inputs": {}, "duration": 0.1, **asked})


def test_all_that_is_of_another_kind_is_told_at_once() -> None:
    with pytest.raises(SimulationError) as refused:
        simulate(car(), [], "1 s", speed="x", wires=[1])  # type: ignore[arg-type]
    told = [line.split(" ")[0] for line in str(refused.value).splitlines()]
    assert told == ["duration", "speed", "inputs:", "wires:"]


@pytest.mark.parametrize(
    ("cases", "options", "sentence"),
    [
        (None, {}, "cases: expected a list of Case, got None"),
        (Case(), {}, "cases: expected a list of Case, got a Case"),
        ([], {}, "cases: expected one or more"),
        ([Case(), {}], {}, "case 1: expected a Case, got a dict"),
        ([Case()], {"threads": "2"}, "threads = '2': expected a whole number, one or more"),
        ([Case()], {"threads": 1.5}, "threads = 1.5: expected a whole number, one or more"),
        ([Case()], {"keep": "tractor.ay"}, "keep: expected a list of names, got 'tractor.ay'"),
        ([Case(speed="3")], {}, f"case 0: speed = '3': {NUMBER}"),  # type: ignore[arg-type]
        ([Case(parameters=None)], {}, "case 0: parameters: expected a mapping"),  # type: ignore[arg-type]
        ([Case(inputs=None)], {}, "case 0: inputs: expected a mapping"),  # type: ignore[arg-type]
        ([Case(parameters={"mu": [0.3]})], {}, r"case 0: parameter mu = \[0.3\]: expected a number"),  # type: ignore[dict-item]
    ],
)
def test_a_batch_that_is_asked_for_in_other_kinds_is_refused_with_a_sentence(
    cases: Any, options: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(SimulationError, match=rf"^{sentence}"):
        simulate_many(car(), cases, 0.1, **options)


def test_wrong_parameters_are_told_with_all_other_mistakes_and_the_numbers_of_their_cases() -> None:
    cases = [
        Case(),
        Case(parameters={"mu": 9}),
        Case(parameters={"muu": 1.0}),
        Case({"axle": 0.1}),
        Case(parameters={"mu": 9}),
    ]
    with pytest.raises(SimulationError) as refused:
        simulate_many(car(), cases, 0.1)
    lines = str(refused.value).splitlines()
    assert [line[:7] for line in lines] == ["case 1:", "case 4:", "case 2:", "case 3:"]
    for line, words in zip(lines, ("at most 1.5", "at most 1.5", "did you mean 'mu'", "input axle"), strict=True):
        assert words in line


@pytest.mark.parametrize("wrong", [{"period": "x"}, {"delay": None}, {"delay": 1e9}])
def test_a_sensor_of_other_kinds_or_that_remembers_too_much_is_refused(wrong: dict[str, Any]) -> None:
    (name,) = wrong
    with pytest.raises(BlockError, match=f"block a: {name} is"):
        Sensor("a", "tractor.ay", **{"period": 0.001, **wrong})


@pytest.mark.parametrize("value", [1, 1.0, np.float32(1), np.int64(1), np.array(1.0)])
def test_numbers_are_numbers(value: Any) -> None:
    assert is_number(value)
    assert are_numbers([value, value])
    assert are_numbers(np.array([1, 2]))
    assert are_numbers([])


@pytest.mark.parametrize("value", [True, "1", None, 1j, [1.0], np.array([1.0]), np.array(True), np.bool_(True)])
def test_nothing_else_is_a_number(value: Any) -> None:
    assert not is_number(value)
    assert not are_numbers(value) or np.ndim(value) == 1
