"""``eom tyre`` as a user runs it."""

import csv
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from eom.tyre import read_tir, slopes
from tests.cli.test_commands import run
from tests.vehicles.shipped import FOLDER

CAR = FOLDER / "tyres" / "passenger_car.tir"


def test_figures_of_the_shipped_tyre(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(monkeypatch, "tyre", CAR) == 0
    out = capsys.readouterr().out
    cornering = -float(np.asarray(slopes(read_tir(CAR).tyre, 0.0, 0.0, 4000.0).alpha.Fy))
    for piece in (
        "Magic Formula 6.1",
        "4000 N, free radius 313.5 mm, 220 kPa",
        f"{cornering:.0f}",
        "notes: none",
        "suspicious: none",
    ):
        assert piece in out
    assert "numbers" not in out


def test_numbers_and_pictures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "tyre", CAR, "--out", tmp_path / "new") == 0
    assert "passenger_car.csv" in capsys.readouterr().out
    assert {path.name for path in (tmp_path / "new").iterdir()} == {
        f"passenger_car.{end}" for end in ("csv", "png", "svg")
    }
    assert (tmp_path / "new" / "passenger_car.png").stat().st_size > 20_000
    with (tmp_path / "new" / "passenger_car.csv").open(encoding="utf-8") as file:
        header, *lines = csv.reader(file)
    assert header == [
        "curves",
        "alpha [rad]",
        "kappa",
        "Fz [N]",
        "Fx [N]",
        "Fy [N]",
        "Mx [N m]",
        "My [N m]",
        "Mz [N m]",
    ]
    numbers = np.array([[float(cell) for cell in line[1:]] for line in lines])
    forces = read_tir(CAR).tyre.forces(*numbers[:, :3].T)
    # full precision: not a bit is lost, but vector instructions may round differently in arrays of another length
    assert np.allclose(numbers[:, 3:].T, np.array(forces), rtol=1e-12, atol=1e-9)
    assert {line[0] for line in lines} == {"side", "drive", "ellipse"}


def test_notes_and_suspicions_are_told_with_their_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "odd.tir"
    text = CAR.read_text(encoding="utf-8").replace("= -21.0", "= 21.0").replace("= 61 ", "= 62 ")
    file.write_text(text, encoding="utf-8")
    assert run(monkeypatch, "tyre", file) == 0
    out = capsys.readouterr().out
    assert "PKY1 = 21, PKY2 = 1.6: the lateral force grows with the slip angle" in out
    line = 1 + next(k for k, text in enumerate(text.splitlines()) if text.startswith("FITTYP"))
    assert f"  line {line}: MODEL.FITTYP: read by the equations of the Magic Formula 6.1" in out


def test_what_a_note_says_is_not_said_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = CAR.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith(("PCX1", "PDX1", "PKX1"))]
    for k, (content, sentence) in enumerate(
        (
            ("\n".join(lines), "the tyre has no longitudinal force"),
            (text.replace("\nRBX1", "\n$").replace("\nRBY1", "\n$"), "RBX1 = 0, RBY1 = 0: the slips"),
        )
    ):
        file = tmp_path / f"tyre{k}.tir"
        file.write_text(content, encoding="utf-8")
        assert run(monkeypatch, "tyre", file) == 0
        out = capsys.readouterr().out
        assert out.count(sentence) == 1
        assert "suspicious: none" in out
        assert max(map(len, out.splitlines())) <= 120


def test_mistakes_of_a_file_give_their_sentences_and_status_2(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "bad.tir"
    text = CAR.read_text(encoding="utf-8").replace("PCX1 ", "PCX9 ").replace("= 4000 ", "= many ")
    file.write_text(text, encoding="utf-8")
    assert run(monkeypatch, "tyre", file) == 2
    out, err = capsys.readouterr()
    assert not out
    assert f"{file}:" in err
    assert "PCX9" in err
    assert "FNOMIN" in err
    assert "Traceback" not in err


def test_a_file_that_is_not_there_gives_a_sentence_and_status_2(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "tyre", tmp_path / "no.tir") == 2
    assert "no.tir" in capsys.readouterr().err


def test_help_and_check_import_neither_tyres_nor_scipy() -> None:
    code = (
        "import sys; sys.argv = ['eom', *{arguments}]\n"
        "from eom.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "print('loaded', [name for name in sys.modules if name in ('eom.tyre', 'scipy.optimize', 'matplotlib')])"
    )
    for arguments in (["--help"], ["check", str(FOLDER / "quarter_car.yaml")]):
        command = [sys.executable, "-c", code.format(arguments=arguments)]
        done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=FOLDER.parent)
        assert done.stdout.rstrip().endswith("loaded []")
