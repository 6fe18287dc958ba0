"""Mistakes in what ``eom simulate`` is told: every one, each with a sentence."""

from pathlib import Path

import pytest

from tests.cli.test_commands import run
from tests.vehicles.shipped import FOLDER

TRAIN, CAR = FOLDER / "b_train.yaml", FOLDER / "quarter_car.yaml"
SPEED_KEEPING = FOLDER / "runs" / "speed_keeping.yaml"


@pytest.mark.parametrize(
    ("arguments", "sentences"),
    [
        ((), ["--duration is missing: without a run file say how long"]),
        (
            ("--input", "axle_1.ster=1deg", "--input", "axle_2.steer", "--duration", "x", "--method", "rk5"),
            [
                "--input axle_1.ster: there is no such input; did you mean 'axle_1.steer'?",
                "--input axle_2.steer: expected NAME=KIND, KIND being a value, sine:AMPLITUDE:FREQUENCY",
                "--duration x: expected a number in s",
                "--method rk5: expected automatic, rk4, dormand_prince, rosenbrock; did you mean 'rk4'?",
            ],
        ),
        (("--input", "axle_1.steer=sin:1deg:1Hz"), ["or step:VALUE[:START]; did you mean 'sine'?"]),
        (("--input", "axle_1.steer=sine:1deg"), ["expected sine:AMPLITUDE:FREQUENCY[:START[:CYCLES]]"]),
        (("--input", "axle_1.steer=sine:1deg:3rad/s:0:-1"), ["expected a frequency in Hz", "cycles -1: expected"]),
        (("--input", "axle_1.steer=step:1deg:1m"), ["start 1m: '1m' is in m, expected s"]),
        (("--input", "axle_1.steer=3kg"), ["value 3kg: '3kg' is in kg, expected rad"]),
        (("--input", "axle_1.steer=1deg", "--input", "axle_1.steer=2deg"), ["--input axle_1.steer: is given twice"]),
        (("--duration", "1s", "--method", "rk4"), ["--method rk4 needs a step, such as --step 1ms"]),
        (("--duration", "1s", "--step", "1ms"), ["--step 1ms: goes with --method rk4"]),
        (("--duration", "1s", "--sample", "2s"), ["time between samples of 2 s: longer than the duration of 1 s"]),
        (("--duration", "1s", "--speed", "-3"), ["--speed -3: expected a number larger than zero"]),
        (("--run", "no.yaml", "--speed", "0"), ["no.yaml: cannot be read", "--speed 0: expected a number larger"]),
        (("--run", SPEED_KEEPING, "--input", "drive_torque=0"), ["input drive_torque has a signal and a wire"]),
    ],
)
def test_mistakes_end_with_their_sentences_and_status_2(
    arguments: tuple[object, ...],
    sentences: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, "simulate", TRAIN, *arguments, "--out", tmp_path / "out") == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Traceback" not in captured.err
    for sentence in sentences:
        assert sentence in captured.err


def test_mistakes_of_a_run_file_are_told_with_their_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "wrong.yaml"
    file.write_text("duration: 3 s\ninputs:\n  rod: 1 cm\n")
    assert run(monkeypatch, "simulate", CAR, "--run", file, "--speed", "3m/s") == 2
    err = capsys.readouterr().err
    assert f"{file}:3:3: inputs.rod: there is no such input; did you mean 'road'?" in err
    assert "--speed 3m/s: goes with axles that have nonlinear tyres" in err


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("duration: 1 s\nmethod: rk4\n", "2:9: method: rk4 needs a step, such as 'step: 1 ms'"),
        ("duration: 1 s\nspeed: 3 m/s\n", "2:8: speed: goes with axles that have nonlinear tyres"),
    ],
)
def test_what_a_run_file_lacks_or_a_model_does_not_take_is_told_with_its_place(
    text: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "wrong.yaml"
    file.write_text(text)
    assert run(monkeypatch, "simulate", CAR, "--run", file) == 2
    assert f"{file}:{sentence}" in capsys.readouterr().err


def test_results_that_memory_may_not_hold_are_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """6 million samples of 232 signals; a sine of 40 million cycles is no burden, as only the first are needed."""
    sine = "axle_1.steer=sine:1deg:0.4Hz:0s:4e7"
    assert run(monkeypatch, "simulate", TRAIN, "--duration", "60000s", "--input", sine) == 2
    err = capsys.readouterr().err
    assert "results of 11.1 GB, expected at most 4: take fewer samples" in err
    assert "Traceback" not in err
