"""``eom simulate`` as a user runs it."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import eom
from eom.driver import KINDS
from eom.simulation import Sine, load_run, simulate
from eom.simulation.progress import Progress
from tests.cli.test_commands import run
from tests.cli.test_response import columns, line_of
from tests.vehicles.shipped import FOLDER, vehicle

TRAIN, CAR = FOLDER / "b_train.yaml", FOLDER / "quarter_car.yaml"
LANE_CHANGE, SPEED_KEEPING = FOLDER / "runs" / "lane_change.yaml", FOLDER / "runs" / "speed_keeping.yaml"


def test_a_run_file_gives_the_run_that_python_gives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "simulate", TRAIN, "--run", LANE_CHANGE, "--out", tmp_path) == 0
    out = capsys.readouterr().out
    steer = Sine(float(np.radians(1.79)), 0.4, 0.5)
    model = eom.build(vehicle("b_train"))
    speed = load_run(LANE_CHANGE, KINDS).speed
    assert speed == pytest.approx(110.0 / 3.6)
    expected = simulate(model, {"axle_1.steer": steer}, 10.0, speed=speed)
    assert out.startswith(f"B-train double at 110 km/h: 10 s\n{expected.method}\n")
    assert "events" not in out
    written = columns(tmp_path / "b_train_run.csv")
    # written at full precision: not a bit may be lost
    assert np.array_equal(written["semitrailer_2.ay [m/s^2]"], expected.of("semitrailer_2.ay"))
    ay = expected.of("semitrailer_2.ay")
    peak = int(np.argmax(np.abs(ay)))
    told = ["m/s^2", f"{ay[peak]:.3f}", f"{expected.time[peak]:.6g}", f"{ay[-1]:.3f}"]
    assert line_of(out, "semitrailer_2.ay")[1:] == told
    roll = np.degrees(expected.of("semitrailer_2_frame.roll"))
    assert line_of(out, "semitrailer_2_frame.roll")[1:3] == ["deg", f"{roll[np.argmax(np.abs(roll))]:.3f}"]
    loads = {name: expected.of(name) for name in expected.outputs.names if name.endswith(("left.Fz", "right.Fz"))}
    lightest = min(loads, key=lambda name: float(np.min(loads[name])))
    assert line_of(out, "smallest load,")[2:5] == [lightest, "N", f"{np.min(loads[lightest]):.0f}"]
    with xr.open_dataset(tmp_path / "b_train_run.nc") as data:
        assert np.array_equal(data["semitrailer_2.ay"], ay)
        assert data.attrs["run_file"] == str(LANE_CHANGE)
    for suffix, start in (("png", b"\x89PNG"), ("svg", b"<?xml")):
        assert (tmp_path / f"b_train_run.{suffix}").read_bytes().startswith(start)
    assert all(f"b_train_run.{suffix}" in out for suffix in ("csv", "nc", "png", "svg"))


def test_shipped_gains_of_speed_keeping_place_the_poles_as_it_says() -> None:
    model = eom.build(vehicle("b_train"))
    (cruise,) = load_run(SPEED_KEEPING, KINDS, model).blocks
    values = vars(cruise)
    mass = sum(body.mass for body in vehicle("b_train").system.bodies)
    rolling = 0.51 * mass
    assert values["kp"] == pytest.approx(2.0 * 0.4 * rolling, rel=5e-3)
    assert values["ki"] == pytest.approx(0.4**2 * rolling, rel=5e-3)


def test_speed_keeping_reaches_the_speed_and_a_straight_run_stays_straight(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "simulate", TRAIN, "--run", SPEED_KEEPING) == 0
    out = capsys.readouterr().out
    assert line_of(out, "tractor.speed")[-1] == "25.00"
    assert line_of(out, "cruise.torque")[2] == "9000"
    assert "zero throughout: ay, yaw_rate, articulation, roll, ltr" in out


def test_options_go_before_the_run_file(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    options = ("--duration", "2s", "--speed", "90km/h", "--sample", "0.5s", "--method", "rk4", "--step", "2ms")
    changed = ("--input", "axle_1.steer=0.5deg", "--input", "axle_2.steer=step:0.1deg:1s")
    assert run(monkeypatch, "simulate", TRAIN, "--run", LANE_CHANGE, *options, *changed) == 0
    out = capsys.readouterr().out
    assert out.startswith("B-train double at 90 km/h: 2 s\n1000 steps by Runge and Kutta's classical method")
    assert line_of(out, "axle_1.steer")[1:] == ["deg", "0.5000", "-", "0.5000"]
    assert line_of(out, "axle_2.steer")[1:] == ["deg", "0.1000", "1", "0.1000"]
    # samples lie half a second apart
    assert float(line_of(out, "tractor.ay")[3]) % 0.5 == 0.0


def test_another_method_leaves_the_step_of_the_run_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "fixed.yaml"
    file.write_text("duration: 1 s\nmethod: rk4\nstep: 1 ms\ninputs: {road: 1 cm}\n")
    assert run(monkeypatch, "simulate", CAR, "--run", file) == 0
    assert "1000 steps by Runge" in capsys.readouterr().out
    assert run(monkeypatch, "simulate", CAR, "--run", file, "--method", "dormand_prince") == 0
    assert "Dormand" in capsys.readouterr().out
    assert run(monkeypatch, "simulate", CAR, "--run", file, "--step", "2 ms") == 0
    assert "500 steps by Runge" in capsys.readouterr().out


def test_inputs_of_the_command_line_and_all_outputs_of_a_linear_model(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    kind = "road=sine:2cm:2Hz:0.5s:3"
    assert run(monkeypatch, "simulate", CAR, "--duration", "3s", "--input", kind, "--out", tmp_path) == 0
    out = capsys.readouterr().out
    model = eom.linearise(vehicle("quarter_car"))
    expected = simulate(model, {"road": Sine(0.02, 2.0, 0.5, 3.0)}, 3.0)
    written = columns(tmp_path / "quarter_car_run.csv")
    assert np.array_equal(written["sprung_acceleration [m/s^2]"], expected.of("sprung_acceleration"))
    assert all(f"\n{name} " in out for name in model.outputs)
    assert out.startswith("Quarter car: 3 s\n")


def test_a_parameter_sets_the_speed_of_the_straight_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("--set", "U=72km/h", "--duration", "0.1s")
    assert run(monkeypatch, "simulate", FOLDER / "b_train_yaw_plane_nonlinear.yaml", *arguments) == 0
    out = capsys.readouterr().out
    assert "at 72 km/h: 0.1 s" in out
    assert line_of(out, "tractor.speed")[2] == "20.00"


def test_a_rollover_is_a_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("--input", "axle_1.steer=step:8deg:1s", "--duration", "8s", "--out", tmp_path)
    assert run(monkeypatch, "simulate", TRAIN, *arguments) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    assert "ended early: " in captured.out
    assert "its roll exceeds 30 deg: it has rolled over; beyond it the model means nothing" in captured.out
    # a limit on each line, in the order of time
    events = captured.out.split("\nevents\n")[1].split("\n\n")[0].splitlines()
    times = [float(line.split(" s: ")[0]) for line in events]
    assert times == sorted(times)
    assert any("axle_7.left: it lifts off the road" in line for line in events)
    assert line_of(captured.out, "smallest load,")[4] == "0"
    assert columns(tmp_path / "b_train_run.csv")["time [s]"][-1] < 8.0


def test_a_run_that_cannot_go_on_keeps_what_it_has_and_ends_with_status_2(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "short.yaml"
    file.write_text("duration: 3 s\ninputs: {road: {table: {time: [0 s, 1 s], value: [0 m, 1 cm]}}}\n")
    assert run(monkeypatch, "simulate", CAR, "--run", file, "--out", tmp_path) == 2
    captured = capsys.readouterr()
    assert "Quarter car: 1 s" in captured.out
    assert captured.err == "input road ends at 1 s\n"
    assert columns(tmp_path / "quarter_car_run.csv")["time [s]"][-1] == 1.0
    assert (tmp_path / "quarter_car_run.svg").exists()


def test_an_interrupt_keeps_what_was_computed_and_ends_with_status_130(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(self: Progress, now: float) -> None:
        del self
        if now > 1.0:
            raise KeyboardInterrupt

    monkeypatch.setattr(Progress, "reached", interrupt)
    assert run(monkeypatch, "simulate", CAR, "--input", "road=1cm", "--duration", "1000s", "--out", tmp_path) == 130
    captured = capsys.readouterr()
    assert "ended early: interrupted at" in captured.out
    assert captured.err.startswith("interrupted at")
    assert 1.0 < columns(tmp_path / "quarter_car_run.csv")["time [s]"][-1] < 1000.0


def test_a_run_that_fails_at_its_start_shows_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("--input", "road=1cm", "--duration", "10s", "--method", "rk4", "--step", "1s")
    assert run(monkeypatch, "simulate", CAR, *arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "a step of 1 s is unstable" in captured.err
