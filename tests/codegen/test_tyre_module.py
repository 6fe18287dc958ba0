"""The generated module of a vehicle with wheels is the in-memory model (law 6), stands alone, and stays alive."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import eom
from eom.codegen import module_text
from eom.codegen.carried import carried
from eom.codegen.kernel import defined
from eom.codegen.module import LINEAR_FILES, TYRE_FILES
from eom.model.tyre import TyreModel, build_tyre_model
from tests.codegen.test_module import SAME, imported
from tests.vehicles.shipped import NAMES, WHEELED, text, vehicle

ANY = 1e-2
CHANGES: dict[str, dict[str, float]] = {
    "a_train_double": {"U": 19.0, "dolly_axles.mass": 1100.0},
    "b_train": {
        "U": 21.0,
        "mu": 0.6,
        "tractor_frame.mass": 7100.0,
        "steer.cornering": 190e3,
        "steer.nonlinear.C_x": 1.5,
        "fifth_wheel_2.at.semitrailer_1.x": -12.1,
        "K_b": 0.02,
    },
    "b_train_yaw_plane_nonlinear": {"U": 17.0},
    "car": {"U": 21.0, "k_f": 30e3, "r_e": 0.31},
    "tractor_semitrailer": {"U": 23.0},
    "tractor_semitrailer_nonlinear": {"U": 26.0},
}
ALONE = """
import sys
sys.path[:0] = {paths!r}
import importlib
import numpy as np
module = importlib.import_module({name!r})
changes, at = {changes!r}, np.load({at!r})
p = module.prepare(changes)
x, u = module.trim(p=p)
slow = module.trim(9.0, p)
moved = x + at["x"], u + at["u"]
model = module.linearise(changes)
assert "eom" not in sys.modules and "scipy" not in sys.modules
np.savez(
    {out!r}, x=x, u=u, slow=slow.x, rates=module.rhs(0.0, *moved, p), outputs=module.outputs(0.0, *moved, p),
    margins=module.margins(0.0, *moved, p), coordinates=list(module.coordinates(moved[0], p).values()),
    A=model.A, B=model.B, C=model.C, D=model.D,
)
"""


def nearby(model: TyreModel) -> tuple[np.ndarray, np.ndarray]:
    """Small changes of all states and inputs."""
    rng = np.random.default_rng(5)
    return ANY * rng.normal(size=len(model.states)), ANY * rng.normal(size=len(model.inputs))


def in_memory(car: eom.Vehicle) -> dict[str, np.ndarray]:
    """What the module is asked for, by the model in memory."""
    model, linear = build_tyre_model(car), eom.linearise(car)
    run, (dx, du) = model.trim(), nearby(model)
    x, u = run.x + dx, run.u + du
    return {
        "x": run.x,
        "u": run.u,
        "slow": model.trim(9.0).x,
        "rates": model.rhs(0.0, x, u),
        "outputs": model.output(0.0, x, u),
        "margins": model.margins(x, u),
        "coordinates": np.array(list(model.coordinates(x).values())),
        **{name: getattr(linear, name) for name in "ABCD"},
    }


def alone(path: Path, changes: dict[str, float], model: TyreModel) -> dict[str, np.ndarray]:
    """The same from the module, in a process that sees NumPy alone."""
    folder = path.parent
    site = folder / "site"
    site.mkdir(exist_ok=True)
    for package in Path(np.__file__).parents[1].glob("numpy*"):
        if not (site / package.name).exists():
            (site / package.name).symlink_to(package)
    x, u = nearby(model)
    np.savez(folder / "at.npz", x=x, u=u)
    code = ALONE.format(
        paths=[str(folder), str(site)],
        name=path.stem,
        changes=changes,
        at=str(folder / "at.npz"),
        out=str(folder / "out.npz"),
    )
    subprocess.run([sys.executable, "-I", "-S", "-c", code], check=True)
    return dict(np.load(folder / "out.npz"))


@pytest.mark.parametrize("name", WHEELED)
def test_the_module_alone_gives_what_the_model_in_memory_gives_also_after_changes(name: str, tmp_path: Path) -> None:
    car = vehicle(name)
    path = eom.write_module(car, tmp_path)
    for changes in ({}, CHANGES[name]):
        changed = car.with_values(**changes) if changes else car
        found, expected = alone(path, changes, build_tyre_model(changed)), in_memory(changed)
        for key, value in expected.items():
            np.testing.assert_allclose(
                found[key], value, rtol=SAME, atol=SAME * np.max(np.abs(value), initial=1.0), err_msg=key
            )


@pytest.mark.parametrize("name", WHEELED)
def test_the_module_says_names_units_and_limits(name: str, tmp_path: Path) -> None:
    car = vehicle(name)
    model, module, linear = build_tyre_model(car), imported(car, tmp_path), eom.linearise(car)
    for labels, names, units in (
        (module.STATES, model.states, model.state_units),
        (module.INPUTS, model.inputs, model.input_units),
        (module.OUTPUTS, model.outputs, model.output_units),
        (module.LINEAR_OUTPUTS, linear.outputs, linear.output_units),
    ):
        assert labels == tuple(zip(names, units, strict=True))
    assert [tuple(limit) for limit in module.LIMITS] == [tuple(limit) for limit in model.limits]
    assert (car.name, f"{name}.yaml", car.digest) == (module.NAME, module.FILE, module.SHA256)
    assert {name: item.value for name, item in module.PARAMETERS.items()} == {
        name: car.values[name] for name in module.PARAMETERS
    }


def test_the_wheeled_vehicles_are_all_that_have_a_nonlinear_module() -> None:
    assert {name for name in NAMES if vehicle(name).draft.rich} == set(WHEELED)


@pytest.mark.parametrize("name", WHEELED)
def test_no_name_means_two_things_in_a_module(name: str) -> None:
    assert_once(module_text(vehicle(name)))


def test_no_name_means_two_things_in_a_module_with_every_law() -> None:
    laws = "linear_tyre, magic_formula_tyre, dugoff_tyre, MagicFormula61, MagicFormula52, rates, all_outputs, close"
    sections, _ = carried(f"KINDS = TyreError = ({laws}, linear_outputs, prepare_with, steady)\n", TYRE_FILES)
    names = defined(sections)
    assert len(names) == len(set(names)) > 200
    sections, _ = carried("(state_space, check_system)\n", LINEAR_FILES)
    names = defined(sections)
    assert len(names) == len(set(names)) > 100


def assert_once(source: str) -> None:
    """Every name is defined once in a source."""
    names = defined([("", source)])
    assert sorted(names) == sorted(set(names))


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"V": 3.0}, "no such parameter: V"),
        ({"U": 100.0}, "U is 100, which is not between 0.138889 and 44.4444"),
        ({"mu": 0.0}, "mu is 0, which is not between 0.05 and 1.5"),
        ({"steer.nonlinear.C_y": 0.0}, "tyres.steer.nonlinear.C_y is 0: expected more than zero"),
        ({"tractor_frame.mass": -5.0}, "a mass is not negative"),
        ({"semitrailer_2_frame.at.x": 40.0}, "its normal load at the trim is"),
        ({"fifth_wheel_1.at.tractor.z": 1.2}, "must be equally high"),
        ({"f_r": 0.1, "mu": 0.05}, "more than its tyre can give"),
    ],
)
def test_impossible_changes_are_refused_with_a_sentence(
    changes: dict[str, float], sentence: str, tmp_path: Path
) -> None:
    module = imported(vehicle("b_train"), tmp_path)
    with pytest.raises(ValueError, match=sentence):
        module.prepare(changes)


def test_a_run_against_more_air_than_the_tyres_can_take_is_refused_with_a_sentence(tmp_path: Path) -> None:
    module = imported(vehicle("car"), tmp_path)
    with pytest.raises(ValueError, match="trim: no straight run at 400 m/s holds"):
        module.trim(400.0)


def test_the_default_numbers_are_made_once_and_nothing_given_is_changed(tmp_path: Path) -> None:
    module = imported(vehicle("b_train"), tmp_path)
    assert module.default() is module.default()
    x, u = module.trim()
    before = x.copy(), u.copy()
    np.testing.assert_array_equal(module.rhs(0.0, x, u), module.rhs(0.0, x, u, module.prepare()))
    np.testing.assert_array_equal(np.concatenate((x, u)), np.concatenate(before))


def test_complex_steps_through_the_module_carry_derivatives(tmp_path: Path) -> None:
    module = imported(vehicle("b_train"), tmp_path)
    x, u = module.trim()
    A = module.linearise().A
    slope = np.array([module.rhs(0.0, x + 1e-30j * row, u).imag / 1e-30 for row in np.eye(len(x))]).T
    # law 2: rounding of two ways to the same derivative
    np.testing.assert_allclose(slope, A, rtol=0.0, atol=1e-9 * np.max(np.abs(A)))


def test_a_tyre_of_a_file_is_data_and_no_path_is_left() -> None:
    source = module_text(vehicle("car"))
    assert "passenger_car.tir" in source
    assert str(Path(__file__).parents[2]) not in source
    assert "open(" not in source
    assert "MagicFormula61" not in module_text(vehicle("b_train"))


def test_two_files_of_one_name_stay_apart(tmp_path: Path) -> None:
    tyre = (Path(__file__).parents[2] / "vehicles" / "tyres" / "passenger_car.tir").read_text(encoding="latin-1")
    for folder, factor in (("a", "1.25"), ("b", "0.75")):
        (tmp_path / folder).mkdir()
        changed = tyre.replace("LMUY                     = 1", f"LMUY = {factor}")
        assert changed != tyre
        (tmp_path / folder / "tyre.tir").write_text(changed, encoding="latin-1")
    own = "nonlinear: {kind: tir, file: tyres/passenger_car.tir}"
    stiff = "per: wheel, vertical_stiffness: 200 kN/m, vertical_damping: 50 N*s/m"
    file = text("car").replace(own, own.replace("tyres/passenger_car", "a/tyre"))
    file = file.replace("tyres:\n", f"tyres:\n  other: {{{stiff}, {own.replace('tyres/passenger_car', 'b/tyre')}}}\n")
    file = file.replace("x: -a_r\n", "x: -a_r\n        tyre: other\n")
    (tmp_path / "car.yaml").write_text(file, encoding="utf-8")
    module = imported(eom.load(tmp_path / "car.yaml"), tmp_path)
    assert {name: tyre.LMUY for name, tyre in module.TYRES.items()} == {"tyre.tir": 1.25, "tyre_2.tir": 0.75}


def test_writing_twice_gives_identical_files() -> None:
    assert module_text(vehicle("car")) == module_text(vehicle("car"))


def test_the_modules_are_linted_and_typed(tmp_path: Path) -> None:
    paths = [eom.write_module(vehicle(name), tmp_path) for name in WHEELED]
    (tmp_path / "__init__.py").write_text('"""Generated."""\n')
    settings = Path(__file__).parents[2] / "pyproject.toml"
    tool = Path(sys.executable).parent
    subprocess.run([tool / "ruff", "check", "--config", settings, tmp_path], check=True)
    subprocess.run([tool / "mypy", "--strict", *paths], check=True, cwd=tmp_path)
