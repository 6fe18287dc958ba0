"""The generated module is the in-memory model (law 6), stands alone, and follows changed parameters."""

import importlib.util
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import eom
from eom.codegen import module_text
from tests.vehicles.shipped import LINEAR, text, vehicle

# eom's own arithmetic in another file: equal to the last bit on one machine, 1e-14 allows another one's library
SAME = 1e-14


def imported(car: eom.Vehicle, folder: Path) -> ModuleType:
    """The vehicle's generated module."""
    path = eom.write_module(car, folder)
    spec = importlib.util.spec_from_file_location(f"generated_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def assert_same(generated: object, model: eom.LinearModel, tolerance: float) -> None:
    """Every matrix equal, relative to its largest entry."""
    for name in "ABCD":
        expected = getattr(model, name)
        scale = max(1.0, float(np.max(np.abs(expected), initial=0.0)))
        np.testing.assert_allclose(getattr(generated, name), expected, rtol=0.0, atol=tolerance * scale)


@pytest.mark.parametrize("name", LINEAR)
def test_the_module_gives_what_the_model_in_memory_gives(name: str, tmp_path: Path) -> None:
    car = vehicle(name)
    model, module = eom.linearise(car), imported(car, tmp_path)
    assert_same(module.linearise(), model, SAME)
    for labels, names, units in (
        (module.STATES, model.states, model.state_units),
        (module.INPUTS, model.inputs, model.input_units),
        (module.OUTPUTS, model.outputs, model.output_units),
    ):
        assert labels == tuple(zip(names, units, strict=True))


def test_mass_hitch_place_and_speed_changed_in_the_module_give_the_changed_files_model(tmp_path: Path) -> None:
    module = imported(vehicle("b_train_yaw_roll"), tmp_path)
    file = text("b_train_yaw_roll")
    for old, new in (
        ("mass: 6308 kg", "mass: 7100 kg"),
        ("semitrailer_1: [-12.57, 0, 1.1]", "semitrailer_1: [-12.1, 0, 1.1]"),
        ("value: 110 km/h", "value: 23 m/s"),
        ("roll_damping: 130 kN*m*s/rad", "roll_damping: 90 kN*m*s/rad"),
    ):
        assert old in file
        file = file.replace(old, new)
    changes = {
        "tractor_frame.mass": 7100.0,
        "fifth_wheel_2.at.semitrailer_1.x": -12.1,
        "U": 23.0,
        "tractor_suspension.roll_damping": 90e3,
    }
    # the same steps on the same numbers: 1e-12 covers another choice of coordinates, were there one
    assert_same(module.linearise(changes), eom.linearise(eom.loads(file)), 1e-12)
    assert_same(module.linearise(changes), eom.linearise(vehicle("b_train_yaw_roll", **changes)), 1e-12)


def test_expressions_of_the_file_stay_alive_in_the_module(tmp_path: Path) -> None:
    module = imported(vehicle("bicycle"), tmp_path)
    changes = {"U": 4.0, "c": 0.06, "r_front": 0.33, "tilt": 0.3}
    # the head's place and the axes are functions of these; sines of two libraries may differ in the last bit
    assert_same(module.linearise(changes), eom.linearise(vehicle("bicycle", **changes)), 1e-12)


def test_an_overridden_vehicle_writes_its_own_values_into_the_module(tmp_path: Path) -> None:
    car = vehicle("b_train_yaw_plane", U="60 km/h")
    module = imported(car, tmp_path)
    assert module.PARAMETERS["U"].value == pytest.approx(60 / 3.6)
    assert_same(module.linearise(), eom.linearise(car), SAME)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"V": 3.0}, "no such parameter: V"),
        ({"U": 100.0}, "U is 100, which is not between 0.138889 and 44.4444"),
        ({"trim.speed": 0.0}, "no such parameter: trim.speed"),
        ({"tractor_frame.mass": float("nan")}, "not a finite number"),
        ({"tractor_frame.mass": -5.0}, "a mass is not negative"),
        ({"tractor_frame.inertia.zz": 1e6}, "no body has principal moments"),
        ({"fifth_wheel_1.at.tractor.z": 1.2}, "must be equally high"),
    ],
)
def test_impossible_changes_are_refused_with_a_sentence(
    changes: dict[str, float], sentence: str, tmp_path: Path
) -> None:
    module = imported(vehicle("b_train_yaw_roll"), tmp_path)
    with pytest.raises(ValueError, match=sentence):
        module.linearise(changes)


def test_the_module_at_rest_says_that_slip_needs_motion(tmp_path: Path) -> None:
    file = text("b_train_yaw_plane").replace("min: 0.5 km/h, ", "")
    with pytest.raises(ValueError, match="need a moving trim"):
        imported(eom.loads(file, "train.yaml"), tmp_path).linearise({"U": 0.0})


def test_wheels_that_stop_spinning_keep_their_coordinates(tmp_path: Path) -> None:
    module = imported(vehicle("bicycle"), tmp_path)
    roots = np.sort(np.linalg.eigvals(module.linearise({"U": 0.0}).A).real)
    # published eigenvalues at rest, Meijaard et al. (2007), Table 2
    np.testing.assert_allclose(
        roots[[0, 1, -2, -1]], [-5.53094371765393, -3.13164324790656, 3.13164324790656, 5.53094371765393]
    )


def test_a_motion_that_stops_being_free_of_forces_is_noticed(tmp_path: Path) -> None:
    file = text("b_train_yaw_plane") + (
        "connectors:\n  tether: {type: flex_point, between: [tractor_frame, ground], at: [-1.999, 0, 0], forces: 1, "
        "axis: [0, 1, 0], stiffness: 0}\n"
    )
    module = imported(eom.loads(file, "tethered.yaml"), tmp_path)
    with pytest.raises(ValueError, match="no longer does"):
        module.linearise({"tether.stiffness": 1e4})


def test_the_module_needs_numpy_alone(tmp_path: Path) -> None:
    path = eom.write_module(vehicle("b_train_yaw_roll"), tmp_path)
    site = tmp_path / "site"
    site.mkdir()
    for package in Path(np.__file__).parents[1].glob("numpy*"):
        (site / package.name).symlink_to(package)
    code = (
        f"import sys; sys.path[:0] = [{str(tmp_path)!r}, {str(site)!r}]\n"
        f"import {path.stem} as model\n"
        "assert 'eom' not in sys.modules and 'scipy' not in sys.modules\n"
        "print(model.linearise().A.shape, len(model.STATES))"
    )
    run = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["(20,", "20)", "20"]


def test_writing_twice_gives_identical_files() -> None:
    assert module_text(vehicle("b_train_yaw_roll")) == module_text(vehicle("b_train_yaw_roll"))


def test_the_modules_are_linted_and_typed(tmp_path: Path) -> None:
    for name in LINEAR:
        eom.write_module(vehicle(name), tmp_path)
    (tmp_path / "__init__.py").write_text('"""Generated."""\n')
    settings = Path(__file__).parents[2] / "pyproject.toml"
    tool = Path(sys.executable).parent
    subprocess.run([tool / "ruff", "check", "--config", settings, tmp_path], check=True)
    subprocess.run([tool / "mypy", "--strict", tmp_path / "b_train_yaw_roll.py"], check=True, cwd=tmp_path)


def test_text_of_the_file_cannot_break_out_of_the_module(tmp_path: Path) -> None:
    hostile = 'x""" + __import__("os").getcwd() + """\\'
    file = text("quarter_car").replace("name: Quarter car", f"name: '{hostile}'")
    file = file.replace("source: >-", 'source: >-\n  """\n  import os')
    module = imported(eom.loads(file, 'quote".yaml'), tmp_path)
    assert hostile == module.NAME


@pytest.mark.parametrize(
    ("file", "module"), [("numpy", "vehicle_numpy"), ("class", "vehicle_class"), ("1st", "vehicle_1st")]
)
def test_no_module_hides_another_one(file: str, module: str, tmp_path: Path) -> None:
    assert eom.write_module(eom.loads(text("disc"), f"{file}.yaml"), tmp_path).stem == module


def test_a_module_near_a_bad_choice_of_coordinates_says_so(tmp_path: Path) -> None:
    module = imported(vehicle("bicycle"), tmp_path)
    # without trail the steer angle no longer tells the rear frame's yaw rate
    with pytest.raises(ValueError, match="choose them anew"):
        module.linearise({"c": 1e-8})


@pytest.mark.parametrize("body", ["x", "y", "z", "x1", "pivots", "inputs", "relative", "ground_", "np"])
def test_a_body_of_any_name_leaves_the_kernel_alone(body: str, tmp_path: Path) -> None:
    file = text("disc").replace("  disc: {mass", f"  {body}: {{mass").replace("[disc, ground]", f"[{body}, ground]")
    car = eom.loads(file.replace("{body: disc", f"{{body: {body}"), "named.yaml")
    assert_same(imported(car, tmp_path).linearise(), eom.linearise(car), SAME)


def test_bodies_whose_names_differ_in_case_alone_stay_apart(tmp_path: Path) -> None:
    file = """
name: two
bodies:
  w: {mass: 2, at: [0, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
  W: {mass: 7, at: [1, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
connectors:
  k: {type: spring, between: [w, ground], ends: [[0, 0, 1], [0, 0, 0]], stiffness: 100}
  l: {type: spring, between: [W, ground], ends: [[1, 0, 1], [1, 0, 0]], stiffness: 300}
"""
    car = eom.loads(file, "two.yaml")
    assert_same(imported(car, tmp_path).linearise(), eom.linearise(car), SAME)


def test_the_module_refuses_a_trim_that_runs_backward(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="the trim runs forward"):
        imported(vehicle("disc"), tmp_path).linearise({"U": -3.0})
