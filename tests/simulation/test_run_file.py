"""A run file is read in SI units, or every mistake in it is reported where it stands, and nothing else."""

import hashlib
from pathlib import Path

import numpy as np
import pytest

import eom
from eom.driver import KINDS, SpeedKeeping
from eom.errors import DescriptionError
from eom.model.tyre import TyreModel, build_tyre_model
from eom.simulation.inputs import Constant, Sine, Steps, Table
from eom.simulation.run_checks import check_against
from eom.simulation.run_file import load_run, loads_run
from eom.simulation.sensors import Sensor
from eom.simulation.wiring import model_inputs, model_signals, wired
from tests.vehicle.monsters import MONSTERS
from tests.vehicle.test_bad_files import expected

ROOT = Path(__file__).parents[2]
BAD = sorted((Path(__file__).parent / "bad_runs").glob("*.yaml"))
GOOD = """\
duration: 10 s
speed: 90 km/h
sample: 10 ms
method: rk4
step: 1 ms
inputs:
  axle_1.steer: {sine: {amplitude: 1.8 deg, frequency: 0.4 Hz, start: 0.5 s}}
  axle_2.steer: 0.9 deg
  axle_3.steer: {file: signals.csv, column: steer}
  axle_4.left.brake_pressure: {steps: {time: [1 s, 3 s], value: [2 bar, 0]}}
  axle_4.steer: {table: {time: [0, 1 s, 2000 ms], value: [0, 2*0.01, -1 deg]}}
blocks:
  cruise: {type: speed_keeping, speed: 90 km/h, kp: 20 kN*s, ki: 2 kN, lowest: 0, highest: 20 kN*m}
  gyro: {type: sensor, signal: tractor.yaw_rate, period: 0.01 s, delay: 20 ms, noise: 1.8 deg/s, seed: 3}
  late: {type: sensor, signal: gyro.value, period: 0.02 s}
wires:
  drive_torque: cruise.torque
"""


@pytest.fixture(scope="module")
def model() -> TyreModel:
    return build_tyre_model(eom.load(ROOT / "vehicles" / "b_train.yaml"))


def test_there_is_a_corpus() -> None:
    assert len(BAD) >= 25


@pytest.mark.parametrize("file", BAD, ids=lambda file: file.stem)
def test_a_bad_file_gives_exactly_its_mistakes(file: Path, model: TyreModel) -> None:
    with pytest.raises(DescriptionError) as caught:
        load_run(file, KINDS, model)
    mistakes = caught.value.mistakes
    wanted = expected(file)
    assert [(m.line, m.column) for m in mistakes] == [(line, column) for line, column, _ in wanted], str(caught.value)
    for mistake, (_, _, words) in zip(mistakes, wanted, strict=True):
        assert words in mistake.what
        assert str(mistake).startswith(f"{file}:{mistake.line}:{mistake.column}: ")


def test_a_run_file_is_read_in_si_units(tmp_path: Path, model: TyreModel) -> None:
    file = tmp_path / "run.yaml"
    file.write_text(GOOD, encoding="utf-8")
    (tmp_path / "signals.csv").write_text("time [ms],other,steer [deg]\n0,1,0\n500,1,1.8\n\n", encoding="utf-8")
    run = load_run(file, KINDS, model)
    assert (run.file, run.digest) == (str(file), hashlib.sha256(GOOD.encode()).hexdigest())
    assert (run.duration, run.speed, run.sample, run.method, run.step) == (10.0, 25.0, 0.01, "rk4", 0.001)
    degree = 0.017453292519943295
    assert run.inputs["axle_1.steer"] == Sine(1.8 * degree, 0.4, 0.5, 1.0)
    assert run.inputs["axle_2.steer"] == Constant(0.9 * degree)
    for name, kind, time, value in (
        ("axle_3.steer", Table, [0.0, 0.5], [0.0, 1.8 * degree]),
        ("axle_4.left.brake_pressure", Steps, [1.0, 3.0], [2e5, 0.0]),
        ("axle_4.steer", Table, [0.0, 1.0, 2.0], [0.0, 0.02, -degree]),
    ):
        item = run.inputs[name]
        assert type(item) is kind
        assert isinstance(item, Table | Steps)
        assert item.time.tolist() == time
        assert np.allclose(item.value, value, rtol=1e-15)
    assert run.blocks == (
        SpeedKeeping(25.0, 20_000.0, 2_000.0, 0.0, 20_000.0, name="cruise"),
        Sensor("gyro", "tractor.yaw_rate", 0.01, 0.02, 1.8 * degree, 3),
        Sensor("late", "gyro.value", 0.02),
    )
    assert run.wires == {"drive_torque": "cruise.torque"}
    assert wired(run.blocks, run.wires, model_signals(model), model_inputs(model)).units == ("N*m", "rad/s", "rad/s")


def test_what_a_run_file_does_not_say_is_left_open() -> None:
    run = loads_run("duration: 1", KINDS)
    assert (run.duration, run.speed, run.sample, run.method, run.step) == (1.0, None, None, "automatic", None)
    assert (run.inputs, run.blocks, run.wires) == ({}, (), {})


def test_without_a_model_a_file_is_read_and_can_be_checked_later(model: TyreModel) -> None:
    text = "duration: 1\ninputs: {axle_1.ster: 1 m, axle_1.steer: 1 m}\n"
    text += "blocks: {a: {type: sensor, signal: tractor.sped, period: 1, noise: 1 bar}}\nwires: {nothing: a.value}\n"
    run = loads_run(text, KINDS)
    with pytest.raises(DescriptionError) as caught:
        check_against(run, model)
    assert [(m.line, m.column) for m in caught.value.mistakes] == [(2, 10), (2, 42), (3, 36), (4, 9)]
    with pytest.raises(DescriptionError) as at_once:
        loads_run(text, KINDS, model=model)
    assert at_once.value.mistakes == caught.value.mistakes
    check_against(loads_run("duration: 1\ninputs: {axle_1.steer: 1 deg}", KINDS), model)


def test_a_linear_model_has_the_same_names(model: TyreModel) -> None:
    linear = eom.linearise(model.vehicle)
    text = "duration: 1\ninputs: {axle_1.steer: 1 deg}\nblocks: {a: {type: sensor, signal: tractor.ay, period: 1}}\n"
    assert loads_run(text, KINDS, model=linear).duration == 1.0


@pytest.mark.parametrize(
    ("text", "sentences"),
    [
        (
            "time,steer\n0,0\n1,x\n2,0,0\n3,1e999\n",
            {3: "'x' is no number", 4: "has 3 values, expected 2", 5: "'1e999'"},
        ),
        ("time,steer\n0,0\n1,0\n1,0\n0.5,0\n", {4: "time 1 s comes after 1 s", 5: "time 0.5 s comes after 1 s"}),
        ("t,steer\n0,0\n", {1: "expected 'time' as the first name, got 't'"}),
        ("time,ster\n0,0\n", {1: "there is no column 'steer'; did you mean 'ster'?"}),
        ("time,steer,steer\n0,0,0\n", {1: "has the column 'steer' twice"}),
        ("time,steer [degg]\n0,0\n", {1: "unknown unit of measure 'degg'"}),
        ("time [m],steer\n0,0\n", {1: "time is in m, expected s"}),
        ("time,steer\n", {1: "has no values below the names"}),
        ("", {0: "is empty: expected names in the first line, 'time' first"}),
        ('time,steer\n"0,0\n', {0: "not readable as CSV"}),
        ("time,st\xff\n".encode("latin-1"), {0: "not readable as UTF-8 text"}),
    ],
)
def test_every_mistake_of_a_signal_file_is_told_with_its_line(
    text: str | bytes, sentences: dict[int, str], tmp_path: Path
) -> None:
    (tmp_path / "steer.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(DescriptionError) as caught:
        loads_run("duration: 1\ninputs: {a: {file: steer.csv, column: steer}}", KINDS, str(tmp_path / "run.yaml"))
    mistakes = caught.value.mistakes
    assert [m.line for m in mistakes] == list(sentences)
    # what is no number begins after the comma
    assert all(m.column == (3 if "no number" in m.what or "1e999" in m.what else min(m.line, 1)) for m in mistakes)
    for mistake, words in zip(mistakes, sentences.values(), strict=True):
        assert words in mistake.what
        assert mistake.file == str(tmp_path / "steer.csv")


def test_of_many_mistakes_of_a_signal_file_some_are_told(tmp_path: Path) -> None:
    (tmp_path / "steer.csv").write_text("time,steer\n" + "x,0\n" * 1000, encoding="utf-8")
    with pytest.raises(DescriptionError) as caught:
        loads_run("duration: 1\ninputs: {a: {file: steer.csv, column: steer}}", KINDS, str(tmp_path / "run.yaml"))
    assert len(caught.value.mistakes) == 21
    assert "and 980 more mistakes" in str(caught.value)


def test_the_unit_of_a_column_is_that_of_its_input(tmp_path: Path, model: TyreModel) -> None:
    (tmp_path / "steer.csv").write_text("time,steer [bar]\n0,0\n", encoding="utf-8")
    text = "duration: 1\ninputs: {axle_1.steer: {file: steer.csv, column: steer}}"
    with pytest.raises(DescriptionError, match=r"2:\d+: .*column: is in kg/m\*s\^2, expected rad"):
        loads_run(text, KINDS, str(tmp_path / "run.yaml"), model)


@pytest.mark.parametrize("name", MONSTERS)
def test_a_monster_is_refused_in_short_sentences(name: str) -> None:
    with pytest.raises(DescriptionError) as caught:
        loads_run(MONSTERS[name][0], KINDS)
    assert all(len(str(mistake)) < 500 for mistake in caught.value.mistakes)
    assert "vehicle file" not in str(caught.value)


@pytest.mark.parametrize("path", ["no/such/file.yaml", ".", "a\0b", "/dev/zero"])
def test_what_is_no_file_is_refused(path: str) -> None:
    with pytest.raises(DescriptionError):
        load_run(path, KINDS)


def test_a_long_chain_of_sensors_is_followed_to_its_mistake_and_a_longer_one_refused(model: TyreModel) -> None:
    lines = [f"  s{k}: {{type: sensor, signal: s{k + 1}.value, period: 1}}\n" for k in range(500)]
    with pytest.raises(DescriptionError, match=r"reads 's500\.value'") as caught:
        loads_run("duration: 1\nblocks:\n" + "".join(lines), KINDS, model=model)
    assert len(caught.value.mistakes) == 1
    with pytest.raises(DescriptionError, match="expected at most 500"):
        loads_run("duration: 1\nblocks:\n" + "".join(lines) + lines[0].replace("s0", "more"), KINDS)
