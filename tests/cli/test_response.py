"""``eom response`` as a user runs it."""

import csv
from pathlib import Path

import numpy as np
import pytest

import eom
from eom.analysis import frequency_response, road_response, sine_response, step_response
from tests.cli.test_commands import run
from tests.vehicles.shipped import FOLDER, NAMES, vehicle

TRAIN = FOLDER / "b_train_yaw_roll.yaml"
RATIO = "semitrailer_2.ay/tractor.ay"


def columns(path: Path) -> dict[str, np.ndarray]:
    """A CSV file's columns by their headings."""
    with path.open(encoding="utf-8") as file:
        header, *lines = csv.reader(file)
    return dict(zip(header, np.array(lines, dtype=float).T, strict=True))


def line_of(out: str, start: str) -> list[str]:
    """The words of the first line that starts so."""
    return next(line for line in out.splitlines() if line.startswith(start)).split()


@pytest.mark.parametrize("name", NAMES)
def test_every_shipped_vehicle_responds_to_its_first_input(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "response", FOLDER / f"{name}.yaml") == 0
    model = eom.linearise(vehicle(name))
    out = capsys.readouterr().out
    assert f"response to {model.inputs[0]}" in out
    assert all(f"\n{output} " in out for output in model.outputs)


def test_frequency_response_steady_gain_and_peak_of_a_ratio(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("--input", "axle_1.steer", "--output", "tractor.ay", "--output", RATIO, "--from", "0.05Hz", "--to", 3)
    assert run(monkeypatch, "response", TRAIN, *arguments, "--out", tmp_path) == 0
    out = capsys.readouterr().out
    assert "at 110 km/h: response to axle_1.steer [rad]" in out
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    written = columns(tmp_path / "b_train_yaw_roll_frequency.csv")
    f = written["frequency [Hz]"]
    response = frequency_response(model, "axle_1.steer", ["tractor.ay", RATIO], f)
    # written at full precision: not a bit may be lost
    assert np.array_equal(written[f"{RATIO} magnitude [-]"], response.magnitude[:, 1])
    assert np.array_equal(written["tractor.ay phase [rad]"], response.phase[:, 0])
    assert (f[0], f[-1]) == (0.05, 3.0)
    peak = response.peaks()[1]
    assert line_of(out, RATIO)[1:] == ["-", "1", f"{peak.value:.5g}", f"{peak.frequency:.5g}"]
    # the table's phase is that of the fine grid, not unwrapped over its own few lines
    shown = [line.split() for line in out.split(f"\n{RATIO}\n")[1].splitlines() if line.strip()[:1].isdigit()]
    at = int(np.searchsorted(f, 2.0))
    assert ["2", f"{np.rad2deg(response.phase[at, 1]):.1f}"] in [[words[0], words[3]] for words in shown]
    for suffix, start in (("png", b"\x89PNG"), ("svg", b"<?xml")):
        assert (tmp_path / f"b_train_yaw_roll_frequency.{suffix}").read_bytes().startswith(start)


def test_a_step_and_a_sine_in_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    common = ("response", TRAIN, "--output", "tractor.ay", "--output", RATIO, "--amplitude", "2deg", "--duration", "8s")
    assert run(monkeypatch, *common, "--time", "step", "--out", tmp_path) == 0
    assert "step of axle_1.steer, 0.0349066 rad" in capsys.readouterr().out
    written = columns(tmp_path / "b_train_yaw_roll_time.csv")
    t = written["time [s]"]
    expected = step_response(model, "axle_1.steer", t, amplitude=float(np.deg2rad(2.0)))
    assert np.array_equal(written["semitrailer_2.ay [m/s^2]"], expected.of("semitrailer_2.ay"))
    assert t[-1] == 8.0
    assert run(monkeypatch, *common, "--time", "sine:0.4Hz") == 0
    sine = sine_response(model, "axle_1.steer", 0.4, t, amplitude=float(np.deg2rad(2.0)))
    ratio = np.max(np.abs(sine.of("semitrailer_2.ay"))) / np.max(np.abs(sine.of("tractor.ay")))
    # the ratio's line in the table of times gives that of the largest magnitudes
    out = capsys.readouterr().out.split("1 cycle of axle_1.steer")[1]
    assert line_of(out, RATIO)[2] == f"{ratio:.5g}"


def test_an_impulse_through_a_damper_is_told_besides(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "response", FOLDER / "quarter_car.yaml", "--time", "impulse") == 0
    out = capsys.readouterr().out
    assert "besides, tyre_deflection has an impulse of -1 m s at t = 0" in out


def test_a_random_road(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    file = FOLDER / "quarter_car.yaml"
    arguments = ("--road", "C", "--speed", "72km/h", "--from", 0.5, "--to", 80, "--out", tmp_path)
    assert run(monkeypatch, "response", file, *arguments) == 0
    out = capsys.readouterr().out
    expected = road_response(vehicle("quarter_car"), "C", speed=20.0, band=(0.5, 80.0))
    assert "road of class C at 72 km/h, 0.5 to 80 Hz, by road" in out
    found = out.split("road of class C")[1]
    assert line_of(found, "sprung_acceleration")[1:] == ["m/s^2", f"{expected.rms_of('sprung_acceleration'):.5g}"]
    written = columns(tmp_path / "quarter_car_road.csv")
    assert np.array_equal(written["sprung_acceleration PSD [(m/s^2)^2/Hz]"], expected.psd[:, 0])


def test_gains_of_an_unstable_vehicle_are_called_formal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "response", FOLDER / "pendulum_cart.yaml", "--output", "angle") == 0
    out = capsys.readouterr().out
    assert "unstable or undamped: the vehicle does not settle, gains and frequency responses are formal" in out
    assert "steady gain (formal)" in out
    assert "\nangle (formal)\n" in out


def test_without_steady_gains_the_rest_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "response", FOLDER / "spinning_top.yaml") == 0
    out = capsys.readouterr().out
    assert "Sleeping top: has a zero root besides those of its cyclic coordinates" in out
    assert line_of(out, "roll ")[4] == "-"


def test_an_output_that_an_input_drives_without_end_has_an_infinite_gain(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "response", FOLDER / "pendulum_cart.yaml", "--output", "position") == 0
    assert "infinite" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "sentences"),
    [
        (("--input", "axle_1.ster"), ["input axle_1.ster: there is no such input; did you mean 'axle_1.steer'?"]),
        (
            ("--output", "tractor.az", "--output", "semitrailer_2.ay/tracto.ay", "--from", "x", "--time", "stop"),
            [
                "did you mean 'tractor.ay'?",
                "output tracto.ay: there is no such output",
                "--from x: expected a number in Hz",
                "--time stop: expected step, impulse or sine:FREQUENCY",
            ],
        ),
        (("--from", "2", "--to", "1"), ["--from 2 --to 1: expected the first one to be smaller"]),
        (("--from", "0"), ["--from 0: expected a number larger than zero"]),
        (("--to", "3 rad/s"), ["--to 3 rad/s: expected a frequency in Hz"]),
        (("--time", "sine"), ["--time sine: expected step, impulse or sine:FREQUENCY"]),
        (("--time", "sine:-1"), ["--time sine: -1: expected a number larger than zero"]),
        (("--amplitude", "2deg", "--duration", "3"), ["--amplitude 2deg: goes with --time", "--duration 3: goes with"]),
        (("--time", "step", "--amplitude", "2 kg"), ["--amplitude 2 kg: '2 kg' is in kg, expected rad"]),
        (("--road", "c"), ["--road c: expected a class of ISO 8608, A to H"]),
        (("--speed", "3"), ["--speed 3: goes with --road"]),
        (("--road", "C"), ["no input is a height of the road"]),
    ],
)
def test_mistakes_end_with_their_sentences_and_status_2(
    arguments: tuple[str, ...],
    sentences: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, "response", TRAIN, *arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Traceback" not in captured.err
    for sentence in sentences:
        assert sentence in captured.err


def test_a_vehicle_without_inputs_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "still.yaml"
    file.write_text("name: Still\nbodies:\n  block: {mass: 1 kg, at: [0, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}\n")
    assert run(monkeypatch, "response", file) == 2
    assert "Still: has no inputs" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["sine:0.4Hz", "sine:200Hz", "impulse"])
def test_the_largest_value_does_not_depend_on_how_long_is_looked(
    kind: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    largest = []
    for duration in ("4s", "3000s"):
        options = ("--output", "axle_1.ay", "--time", kind, "--duration", duration)
        assert run(monkeypatch, "response", FOLDER / "b_train_yaw_roll.yaml", *options) == 0
        # the table in time is the last one
        line = [row for row in capsys.readouterr().out.splitlines() if row.startswith("axle_1.ay")][-1]
        largest.append(float(line.split()[2]))
    # between two samples of an oscillation the largest value is missed by less
    assert largest[1] == pytest.approx(largest[0], rel=2e-3)
