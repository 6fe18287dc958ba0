"""The commands as a user runs them."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import scipy.io

import eom
from eom.cli import main
from tests.vehicles.shipped import FOLDER, NAMES, vehicle


def run(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    """Run the command line in this process; its exit status."""
    monkeypatch.setattr(sys, "argv", ["eom", *map(str, arguments)])
    with pytest.raises(SystemExit) as stop:
        main()
    return int(stop.value.code or 0)


@pytest.mark.parametrize("name", NAMES)
def test_check_accepts_every_shipped_vehicle(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", FOLDER / f"{name}.yaml") == 0
    out = capsys.readouterr().out
    assert "none redundant" in out
    assert "equilibrium" in out


def test_check_prints_freedom_constraints_and_loads(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", FOLDER / "b_train_yaw_roll.yaml", "--set", "U=100 km/h") == 0
    out = capsys.readouterr().out
    for piece in (
        "constraints         26, rank 26, none redundant",
        "degrees of freedom  10",
        "27.7778 m/s (100 km/h), held",
        "80928.4",
        "fifth_wheel_2",
    ):
        assert piece in out


@pytest.mark.parametrize("setting", ["U=100km/h", "U=100 km/h", "U = 27.777777777777779", "U=27.777777777777779 m/s"])
def test_settings_work_with_and_without_a_space(
    setting: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", FOLDER / "b_train_yaw_plane.yaml", "--set", setting) == 0
    assert "(100 km/h)" in capsys.readouterr().out


def test_build_writes_module_matrices_and_summary(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "build", FOLDER / "b_train_yaw_roll.yaml", "--out", tmp_path) == 0
    out = capsys.readouterr().out
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    arrays = np.load(tmp_path / "b_train_yaw_roll.npz")
    cells = scipy.io.loadmat(tmp_path / "b_train_yaw_roll.mat")
    # written at full precision: not a bit may be lost
    np.testing.assert_array_equal(arrays["ss_A"], model.A)
    np.testing.assert_array_equal(cells["ss_B"], model.B)
    assert tuple(arrays["states"]) == model.states
    assert [str(cell[0][0]) for cell in cells["outputs"]] == list(model.outputs)
    assert arrays["J"].shape == (len(arrays["constraint_rows"]), len(arrays["coordinates"]))
    assert "damping ratio" in (tmp_path / "b_train_yaw_roll.txt").read_text()
    for suffix in ("py", "npz", "mat", "txt"):
        assert f"b_train_yaw_roll.{suffix}" in out


def test_build_writes_the_equations_in_symbols(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    car = FOLDER / "quarter_car.yaml"
    assert run(monkeypatch, "build", car, "--latex", "--symbol", "k_s", "--out", tmp_path) == 0
    assert "equations" in capsys.readouterr().out
    document = (tmp_path / "quarter_car.tex").read_text(encoding="utf-8")
    assert "k_{s}" in document
    assert "k_{t}" not in document


def test_symbols_that_are_no_parameters_are_refused_before_anything_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    car = FOLDER / "quarter_car.yaml"
    assert run(monkeypatch, "build", car, "--latex", "--symbol", "ks", "--out", tmp_path / "out") == 2
    assert "no symbol for 'ks': there is no such parameter; did you mean 'k_s'?" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    assert run(monkeypatch, "build", car, "--symbol", "k_s") == 2
    assert "--symbol goes with --latex" in capsys.readouterr().err


def test_modes_lists_each_pair_once(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(monkeypatch, "modes", FOLDER / "b_train_yaw_plane.yaml") == 0
    out = capsys.readouterr().out
    assert out.count("±") == 3
    assert "-1.3179 ± 2.0835i" in out


def test_schema_is_valid_json_with_the_files_keys(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "schema") == 0
    printed = json.loads(capsys.readouterr().out)
    assert {"bodies", "units", "couplings", "trim"} <= set(printed["properties"])
    assert printed == json.loads((FOLDER / "vehicle.schema.json").read_text())


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["check", "missing.yaml"], "missing.yaml: cannot be read: No such file or directory"),
        (["check", FOLDER / "disc.yaml", "--set", "U"], "expected NAME=VALUE"),
        (["check", FOLDER / "disc.yaml", "--set", "u=3"], "there is no such parameter; did you mean"),
        (["check", FOLDER / "disc.yaml", "--set", "r=3 kg"], "'3 kg' is in kg, expected m"),
        (["check", FOLDER / "b_train_yaw_roll.yaml", "--set", "U=200 km/h"], "at most 44.4444 is allowed"),
    ],
)
def test_mistakes_end_with_a_sentence_and_status_2(
    arguments: list[object], sentence: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, *arguments) == 2
    captured = capsys.readouterr()
    assert sentence in captured.err
    assert "Traceback" not in captured.err


@pytest.mark.parametrize("file", sorted((Path(__file__).parents[1] / "bad_files").glob("*.yaml")), ids=lambda p: p.stem)
def test_every_bad_file_ends_with_status_2_and_its_place(
    file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", file) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert all(line.startswith(f"{file}:") for line in captured.err.splitlines())


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["check", FOLDER / "disc.yaml", "--set", "U=1", "--set", "U=2"], "--set U: is given twice"),
        (["build", FOLDER / "disc.yaml", "--out", __file__], "cannot be written"),
    ],
)
def test_options_that_contradict_each_other_are_refused(
    arguments: list[object], sentence: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, *arguments) == 2
    assert sentence in capsys.readouterr().err


def test_check_refuses_what_build_would_refuse(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "car.yaml"
    sensor = "sensors:\n  axle: {body: unsprung, along: [0, 0, 1], measure: acceleration}"
    file.write_text((FOLDER / "quarter_car.yaml").read_text().replace("sensors:", sensor))
    assert run(monkeypatch, "check", file) == 2
    assert "sensors.axle: output axle would follow the rate of input road" in capsys.readouterr().err


def test_help_imports_nothing_heavy() -> None:
    code = (
        "import sys; sys.argv = ['eom', '--help']\n"
        "from eom.cli import main\n"
        "try:\n    main()\n"
        "except SystemExit:\n    pass\n"
        "heavy = {'numpy', 'scipy', 'pydantic', 'pint', 'matplotlib', 'jinja2'}\n"
        "print(sorted(heavy & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"
