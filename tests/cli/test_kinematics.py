"""``eom kinematics`` as a user runs it."""

import csv
from pathlib import Path

import numpy as np
import pytest

import eom
from tests.cli.test_commands import run
from tests.vehicles.shipped import FOLDER, vehicle

STRUT = FOLDER / "strut_suspension.yaml"
HEAVE = ("--drive", "left_road=-80mm:80mm", "--drive", "right_road=-80mm:80mm", "--hold", "chassis")


def test_tables_numbers_and_picture_of_a_sweep(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    numbers, picture = tmp_path / "new" / "travel.csv", tmp_path / "travel.png"
    assert run(monkeypatch, "kinematics", STRUT, *HEAVE, "--points", 5, "--csv", numbers, "--plot", picture) == 0
    out = capsys.readouterr().out
    for piece in ("left_tyre\n", "camber [deg]", "roll_centre_height [mm]", "smallest motion taken: left_wheel.pitch"):
        assert piece in out
    assert picture.stat().st_size > 10_000
    with numbers.open(encoding="utf-8") as file:
        header, *lines = csv.reader(file)
    sweep = eom.kinematic_sweep(
        vehicle("strut_suspension"),
        {"left_road": (-0.08, 0.08), "right_road": (-0.08, 0.08)},
        hold=["chassis"],
        points=5,
    )
    assert header[:3] == ["left_road [m]", "right_road [m]", "left_tyre.travel [m]"]
    written = np.array([float(line[header.index("left_tyre.camber [rad]")]) for line in lines])
    assert np.array_equal(written, sweep.measures["left_tyre.camber"].values)


def test_a_sweep_that_ends_early_keeps_what_it_has_and_says_where(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drive = ("--drive", "left_road=-600mm:600mm", "--hold", "chassis", "--points", 13)
    assert run(monkeypatch, "kinematics", STRUT, *drive) == 2
    out, err = capsys.readouterr()
    assert "left_tyre" in out
    assert "the loops lock on the way from the drawing: they let 'left_road' to" in err
    assert "of 13 points" in err


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--drive", "left_road"), "--drive left_road: expected NAME=FROM:TO"),
        (("--drive", "left_road=-80:80mm"), "give both ends a unit, or neither"),
        (("--drive", "left_road=0:1mm", "--drive", "left_road=0:2mm"), "--drive left_road: is given twice"),
        (("--drive", "left_road=0:1kg"), "'1kg' is"),
        (("--drive", "left_rod=0:1mm"), "did you mean 'left_road'?"),
    ],
)
def test_a_mistake_gives_its_sentence_and_status_2(
    arguments: tuple[str, ...],
    sentence: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, "kinematics", STRUT, *arguments) == 2
    assert sentence in capsys.readouterr().err


def test_nothing_to_drive_is_a_mistake_of_the_command_line(monkeypatch: pytest.MonkeyPatch) -> None:
    assert run(monkeypatch, "kinematics", STRUT) == 2


def test_a_picture_needs_an_ending_that_tells_its_format(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drive = ("--drive", "rack=-10mm:10mm", "--plot", tmp_path / "curves.xyz")
    assert run(monkeypatch, "kinematics", FOLDER / "strut_suspension.yaml", *drive) == 2
    assert "expected a picture's name that ends in .png or .svg" in capsys.readouterr().err
