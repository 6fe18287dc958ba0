"""A file with every type of connector: its module, and its symmetry."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import eom
from eom.report.summary import summary
from eom.vehicle.connectors import Connector
from eom.vehicle.load import Vehicle
from tests.codegen.test_module import SAME, assert_same, imported

FILE = Path(__file__).parent / "every_type.yaml"


def vehicle(**overrides: float) -> Vehicle:
    """The file, some parameters overridden."""
    return eom.load(FILE, **overrides)


def test_the_file_has_every_type() -> None:
    union = Connector.__args__[0].__args__
    types = {item.model_fields["type"].annotation.__args__[0] for item in union}
    text = FILE.read_text(encoding="utf-8")
    assert {name for name in types if f"type: {name}" not in text} == {"nh_point"}


def test_its_module_gives_what_the_model_in_memory_gives(tmp_path: Path) -> None:
    module = imported(vehicle(), tmp_path)
    assert_same(module.linearise(), eom.linearise(vehicle()), SAME)


@pytest.mark.parametrize(
    "changes",
    [
        {"U": 33.0},
        {"EI": 12e3},
        {"rubber.relaxation": 0.7, "rubber.vertical_stiffness": 150e3},
        {"mount.stiffness.11": 7e5, "wing_left.derivatives.z_w": -3.0, "fluid_left.added_mass.33": 9.0},
        {"skin_left.corner_3.y": 0.6, "skin_left.poisson": 0.2, "pole.mass_per_length": 2.5},
        {"strut_left.inertance": 5.0, "coil_left.damping": 9.0},
    ],
)
def test_a_parameter_changed_in_the_module_gives_the_changed_files_model(
    changes: dict[str, float], tmp_path: Path
) -> None:
    module = imported(vehicle(), tmp_path)
    # the same steps on the same numbers: 1e-12 covers another choice of coordinates, were there one
    assert_same(module.linearise(changes), eom.linearise(vehicle(**changes)), 1e-12)


def test_its_module_is_linted_and_typed(tmp_path: Path) -> None:
    path = eom.write_module(vehicle(), tmp_path)
    (tmp_path / "__init__.py").write_text('"""Generated."""\n')
    settings = Path(__file__).parents[2] / "pyproject.toml"
    tool = Path(sys.executable).parent
    subprocess.run([tool / "ruff", "check", "--config", settings, tmp_path], check=True)
    subprocess.run([tool / "mypy", "--strict", path], check=True, cwd=tmp_path)
    assert importlib.util.find_spec("eom") is not None


def test_its_report_names_every_preload_once() -> None:
    assembly = eom.assemble(vehicle())
    assert len(assembly.elastic_rows) == len(set(assembly.elastic_rows)) == assembly.matrices.H.shape[0]
    report = summary(assembly)
    for name in ("mount[2]", "pole[0]", "skin_left[0]", "coil_right"):
        assert f"\n{name} " in report


MIRROR = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])


@pytest.mark.parametrize("name", ["M", "C", "K"])
def test_mirrored_parts_make_a_vehicle_that_is_its_own_mirror_image(name: str) -> None:
    """Bodies and their coordinates reflected in y = 0 leave each matrix as it is; the one skew beam is left out."""
    text = FILE.read_text(encoding="utf-8")
    assembly = eom.assemble(eom.loads(text.replace("normal: [0, 1, 0.2]", "normal: [0, 1, 0]")))
    bodies = [body.name for body in assembly.system.bodies]
    image = [bodies.index(_other(body)) for body in bodies]
    order = np.concatenate([6 * k + np.arange(6) for k in image])
    signs = np.tile(MIRROR, len(bodies))
    matrix = getattr(assembly, name)
    reflected = (signs[:, np.newaxis] * matrix * signs)[np.ix_(order, order)]
    # statics shares loads with that much rounding
    np.testing.assert_allclose(reflected, matrix, atol=1e-9 * np.max(np.abs(matrix)))


def test_mirrored_flaps_push_as_mirror_images() -> None:
    assembly = eom.assemble(vehicle())
    F, inputs = assembly.matrices.F, [item.name for item in assembly.system.inputs]
    boom = 6 * [body.name for body in assembly.system.bodies].index("boom")
    left, right = (F[boom : boom + 6, inputs.index(f"flap_{side}.deflection")] for side in ("left", "right"))
    np.testing.assert_allclose(right, MIRROR * left, rtol=1e-13)
    assert np.count_nonzero(left) == 3


def _other(name: str) -> str:
    """The name of the body on the other side."""
    swap = {"left": "right", "right": "left"}
    side = next((side for side in swap if side in name), None)
    return name if side is None else name.replace(side, swap[side])
