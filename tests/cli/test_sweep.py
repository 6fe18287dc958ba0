"""``eom sweep`` and ``eom modes`` as a user runs them."""

import csv
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import eom
from tests.cli.test_commands import run
from tests.vehicles.shipped import FOLDER, vehicle


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_a_sweep_prints_a_table_and_critical_values_and_writes_roots_and_pictures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "sweep", FOLDER / "bicycle.yaml", "U=3:7:0.5m/s", "--out", tmp_path) == 0
    out = capsys.readouterr().out
    lines = [line.split()[:2] for line in out.splitlines() if line[:1].isdigit()]
    # stable between weave speed 4.29 m/s and capsize speed 6.02 m/s
    assert lines[:9] == [[f"{3 + k / 2:g}", "yes" if 2 < k < 7 else "no"] for k in range(9)]
    assert lines[9:] == [["4.292383", "flutter"], ["6.024262", "divergence"]]
    assert len(rows(tmp_path / "bicycle_U.csv")) == 9 * 8
    assert (tmp_path / "bicycle_U.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "bicycle_U.svg").read_text(encoding="utf-8")


def test_the_numbers_of_a_sweep_are_the_branches_of_the_locus_to_the_last_bit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(monkeypatch, "sweep", FOLDER / "car_trailer.yaml", "U=60:120:20km/h", "--out", tmp_path) == 0
    locus = eom.root_locus(vehicle("car_trailer"), "U", [60.0, 80.0, 100.0, 120.0], "km/h")
    table = rows(tmp_path / "car_trailer_U.csv")
    found = np.array([complex(float(row["real [1/s]"]), float(row["imaginary [1/s]"])) for row in table])
    np.testing.assert_array_equal(found.reshape(4, -1), locus.branches)
    assert [row["branch"] for row in table[:6]] == list("123456")
    assert {row["U [km/h]"] for row in table} == {"60.0", "80.0", "100.0", "120.0"}


def test_the_same_sweep_writes_the_same_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written = []
    for name in ("one", "two"):
        assert run(monkeypatch, "sweep", FOLDER / "disc.yaml", "U=1:3:0.5m/s", "--out", tmp_path / name) == 0
        written.append({path.name: path.read_bytes() for path in (tmp_path / name).iterdir()})
    assert written[0] == written[1]


def test_two_parameters_give_a_map(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ranges = ("U=100:120:10km/h", "ahead=0:0.2:0.1m")
    assert run(monkeypatch, "sweep", FOLDER / "car_trailer.yaml", *ranges, "--out", tmp_path) == 0
    assert "U [km/h] \\ ahead [m]" in capsys.readouterr().out
    table = rows(tmp_path / "car_trailer_U_ahead.csv")
    assert [(row["U [km/h]"], row["ahead [m]"]) for row in table[:4]] == [
        ("100.0", "0.0"),
        ("100.0", "0.1"),
        ("100.0", "0.2"),
        ("110.0", "0.0"),
    ]
    one = eom.linearise(vehicle("car_trailer", U="110 km/h", ahead="0.1 m")).modes()
    assert float(table[4]["rightmost real part [1/s]"]) == np.max(one.eigenvalues[one.eigenvalues != 0.0].real)
    assert float(table[4]["least damping ratio"]) == np.min(one.damping_ratio[one.oscillates])
    for ending in ("png", "svg"):
        assert (tmp_path / f"car_trailer_U_ahead.{ending}").stat().st_size > 1000


def interrupted_after(count: int, function: Callable[..., Any]) -> Callable[..., Any]:
    calls = iter(range(1000))

    def interrupted(*arguments: Any) -> Any:
        if next(calls) == count:
            raise KeyboardInterrupt
        return function(*arguments)

    return interrupted


def test_an_interrupted_sweep_keeps_what_it_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import eom.analysis.family

    calls = {3.0}

    def interrupted(car: eom.Vehicle) -> eom.LinearModel:
        if car.speed > max(calls):
            raise KeyboardInterrupt
        return eom.linearise(car)

    monkeypatch.setattr(eom.analysis.family, "linearise", interrupted)
    assert run(monkeypatch, "sweep", FOLDER / "disc.yaml", "U=1:9:1", "--out", tmp_path) == 2
    assert "interrupted after 3 of 9 values" in capsys.readouterr().err
    assert len(rows(tmp_path / "disc_U.csv")) == 3 * 8


@pytest.mark.parametrize("points", [1, 4, 7])
def test_an_interrupted_map_keeps_what_it_has(
    points: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import eom.analysis.maps

    monkeypatch.setattr(eom.analysis.maps, "linearise", interrupted_after(points, eom.linearise))
    arguments = ("sweep", FOLDER / "car_trailer.yaml", "U=100:120:10km/h", "ahead=0:0.2:0.1m", "--out", tmp_path)
    assert run(monkeypatch, *arguments) == 2
    assert f"interrupted after {points} of 9 values" in capsys.readouterr().err
    assert len(rows(tmp_path / "car_trailer_U_ahead.csv")) == points
    assert (tmp_path / "car_trailer_U_ahead.png").exists()


def test_a_sweep_interrupted_before_anything_is_computed_ends_with_status_130(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import eom.analysis.family

    monkeypatch.setattr(eom.analysis.family, "linearise", interrupted_after(0, eom.linearise))
    assert run(monkeypatch, "sweep", FOLDER / "disc.yaml", "U=1:9:1", "--out", tmp_path) == 130


def test_a_sweep_beyond_a_bound_keeps_what_it_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = FOLDER / "b_train_yaw_plane.yaml"
    assert run(monkeypatch, "sweep", file, "U=140:200:10km/h", "--out", tmp_path) == 2
    captured = capsys.readouterr()
    assert "at most 44.4444 is allowed" in captured.err
    assert "stopped after 3 of 7 values" in captured.err
    assert (tmp_path / "b_train_yaw_plane_U.csv").exists()


def test_a_sweep_of_one_value_is_a_locus_of_one_point(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "sweep", FOLDER / "disc.yaml", "U=3:3:1", "--out", tmp_path) == 0
    assert "no critical value of U between 3 and 3" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "sentences"),
    [
        (["U=1:2"], ["U=1:2: expected NAME=FROM:TO:STEP"]),
        (["U=1:2:0"], ["does not lead from 1 to 2"]),
        (["U=2:1:0.5"], ["does not lead from 2 to 1"]),
        (["U=1:2:1e-9"], ["steps, at most"]),
        (["U=0:1e308:1e-10"], ["steps, at most"]),
        (["U=1:2", "r=2:1:1"], ["U=1:2: expected", "r=2:1:1: the step does not lead"]),
        (["U=1:2:1", "U=3:4:1"], ["U: is swept twice"]),
        (["U=1:2:1", "r=1:2:1", "m=1:2:1"], ["3 ranges: expected one for a locus, or two for a map"]),
        (["U=1:2:0.001", "r=1:2:0.01"], ["are 101101 points, at most 10000"]),
        (["U=1:1:1", "r=1:2:1"], ["U: has one value, a map needs two or more"]),
        (["U=1:2:1", "--set", "U=1"], ["--set U: the sweep sets it"]),
        (["speed=1:2:1"], ["cannot set 'speed'", "there is no such parameter"]),
        (["U=1:2:1kg"], ["is in kg, expected m/s"]),
        (["U=1:2:1", "--out", __file__], ["cannot be written"]),
    ],
)
def test_mistakes_end_with_their_sentences_and_status_2(
    arguments: list[str], sentences: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "sweep", FOLDER / "disc.yaml", *arguments) == 2
    captured = capsys.readouterr()
    for sentence in sentences:
        assert sentence in captured.err
    assert "Traceback" not in captured.err


def test_modes_print_wavelengths_and_shapes(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "modes", FOLDER / "car_trailer.yaml", "--shapes") == 0
    out = capsys.readouterr().out
    # 80 km/h at 3.6275 rad/s: 22.2222 2 pi / 3.6275
    assert "38.4908" in out
    assert "mode 3: -0.5743 ± 3.6275i 1/s" in out
    # a heading of the whole turns both about the car's centre of mass
    assert out.count("(-1.250, 0.000, ") == 2


def test_modes_write_numbers_and_a_picture_when_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    numbers, picture = tmp_path / "new" / "modes.csv", tmp_path / "new" / "modes.svg"
    arguments = ("modes", FOLDER / "b_train_yaw_roll.yaml", "--csv", numbers, "--plot", picture)
    assert run(monkeypatch, *arguments) == 0
    assert f"numbers  {numbers}\npicture  {picture}" in capsys.readouterr().out
    modes = eom.linearise(vehicle("b_train_yaw_roll")).modes()
    table = rows(numbers)
    # written at full precision: not a bit may be lost
    assert [float(row["wavelength [m]"]) for row in table] == pytest.approx(
        modes.wavelength.tolist(), rel=0, nan_ok=True
    )
    shares = [float(row[f"participation of {modes.states[-1]}"]) for row in table]
    np.testing.assert_array_equal(shares, modes.participation[-1])
    name = f"{modes.bodies[-1]}.yaw"
    motion = [complex(float(row[f"{name} real"]), float(row[f"{name} imaginary"])) for row in table]
    np.testing.assert_array_equal(motion, modes.shapes[-1, 5])
    assert "<svg" in picture.read_text(encoding="utf-8")


def test_a_picture_of_an_unknown_format_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "modes", FOLDER / "disc.yaml", "--plot", tmp_path / "modes.bmp") == 2
    assert "ends in .png or .svg" in capsys.readouterr().err
