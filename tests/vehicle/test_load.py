"""Loading: values in SI, overrides, templates."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import FOLDER, NAMES

TRAIN = FOLDER / "b_train_yaw_roll.yaml"
UNITS = """
name: all in odd units
gravity: 9.81 m/s^2
trim: {speed: 36 km/h}
parameters:
  height: {value: 50 cm, min: 1 mm, max: 1 m}
  plain: {value: 1e3}
  angle: {value: 180 deg}
  twice: {value: 2*height}
bodies:
  frame:
    mass: 1.5 t
    at: [100 mm, 1 in, height]
    inertia: {xx: plain, yy: 1.0e6, zz: 1e+3 kg*m^2, xz: -2}
    spin: [0, 60 rpm, angle/2]
loads:
  push: {body: frame, force: [1 kN, 0.5kN, -1 lbf]}
"""


def test_values_are_in_si() -> None:
    vehicle = eom.loads(UNITS)
    (body,) = vehicle.system.bodies
    assert body.mass == 1500.0
    assert body.centre == (0.1, 0.0254, 0.5)
    assert body.velocity == (10.0, 0.0, 0.0)
    assert body.spin == pytest.approx((0.0, 2 * np.pi, np.pi / 2))
    assert body.inertia == ((1000.0, 0.0, 2.0), (0.0, 1e6, 0.0), (2.0, 0.0, 1000.0))
    assert vehicle.system.gravity == (0.0, 0.0, -9.81)
    assert vehicle.system.loads[0].force == (1000.0, 500.0, -4.4482216152605)
    assert vehicle.system.loads[0].place == body.centre
    assert vehicle.values["trim.speed"] == 10.0
    assert vehicle.values["twice"] == 1.0


@pytest.mark.parametrize("name", NAMES)
def test_loading_twice_gives_the_same(name: str) -> None:
    path = FOLDER / f"{name}.yaml"
    first, second = eom.load(path), eom.load(str(path))
    assert first.system == second.system
    assert first.values == second.values
    assert first.digest == second.digest
    # names of files in it start from its folder
    assert eom.loads(path.read_bytes(), str(path)).system == first.system
    assert eom.loads(path.read_text(encoding="utf-8"), str(path)).digest == first.digest


@pytest.mark.parametrize(
    "value", [25, 25.0, np.float64(25.0), np.int64(25), "25", "25 m/s", "25m/s", "90 km/h", "90km/h", "5*5", "2.5e1"]
)
def test_an_override_is_a_number_in_si_or_a_text_with_a_unit(value: str | float) -> None:
    vehicle = eom.load(TRAIN, U=value)
    assert vehicle.values["U"] == pytest.approx(25.0, rel=1e-15)
    assert vehicle.system.bodies[0].velocity == (vehicle.values["U"], 0.0, 0.0)


def test_literals_are_parameters_named_after_their_object() -> None:
    changes: dict[str, Any] = {"tractor_frame.mass": "6.5 t", "tractor_frame.at.x": "-140 cm", "axle_2.x": -5.1}
    vehicle = eom.load(TRAIN, **changes)
    frame = next(body for body in vehicle.system.bodies if body.name == "tractor_frame")
    assert frame.mass == 6500.0
    assert frame.centre[0] == pytest.approx(-1.4)
    assert vehicle.values["axle_2.x"] == -5.1
    assert eom.load(TRAIN).values["tractor_frame.mass"] == 6308.0


def test_an_override_may_refer_to_parameters() -> None:
    assert eom.load(TRAIN, h_r="0.7 + U/U/10").values["h_r"] == pytest.approx(0.8)
    assert eom.loads(UNITS, plain="2*twice").values["plain"] == 2.0


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        ({"u": 3}, "cannot set 'u': there is no such parameter; did you mean 'U'?"),
        ({"tractor_fram.mass": 3}, "did you mean 'tractor_frame.mass'?"),
        ({"U": "30 kg"}, "'30 kg' is in kg, expected m/s"),
        ({"U": "30 mps"}, "unknown unit of measure 'mps'"),
        ({"U": "speed"}, "unknown parameter 'speed'"),
        ({"U": "2*U"}, "is computed from itself: U -> U"),
        ({"U": "1/0"}, "divides by zero"),
        ({"U": "400 km/h"}, "at most 44.4444 is allowed"),
        ({"U": float("nan")}, "not a finite number"),
        ({"U": 10**400}, "too large for a number"),
        ({"U": True}, "expected a number"),
        ({"U": None}, "expected a number"),
        ({"U": [1]}, "expected a number"),
        ({"tractor_frame.mass": "3 m"}, "'3 m' is in m, expected kg"),
    ],
)
def test_an_override_that_cannot_be(overrides: dict[str, Any], words: str) -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.load(TRAIN, **overrides)
    assert len(caught.value.mistakes) == 1
    assert words in str(caught.value)


def test_every_override_that_cannot_be_is_reported() -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.load(TRAIN, u=1, h="2 m")
    assert len(caught.value.mistakes) == 2


def test_a_template_used_twice_gives_two_units() -> None:
    vehicle = eom.load(TRAIN, **{"semitrailer_2.K_r": "2.5 MN*m/rad"})
    rolls = {item.connection.name: item.stiffness[1] for item in vehicle.system.elastic}
    assert rolls["semitrailer_1_tridem_suspension.roll"] == 2.0e6
    assert rolls["semitrailer_2_tridem_suspension.roll"] == 2.5e6
    bodies = {body.name: body for body in vehicle.system.bodies}
    first, second = bodies["semitrailer_1_frame"], bodies["semitrailer_2_frame"]
    assert first.mass == second.mass == 15927.0
    # the kingpins are 12.57 m apart
    assert first.centre[0] - second.centre[0] == pytest.approx(12.57)
    assert first.centre[1:] == second.centre[1:]


def test_a_file_with_a_byte_order_mark_or_other_line_ends_is_the_same() -> None:
    text = UNITS.lstrip()
    for other in ("\ufeff" + text, text.replace("\n", "\r\n")):
        assert eom.loads(other).system == eom.loads(text).system


def test_a_file_is_named_in_its_mistakes(tmp_path: Path) -> None:
    path = tmp_path / "wrong.yaml"
    path.write_text("name: n\nbodies:\n  a: {mass: 1 m, at: [0, 0, 0]}\n", encoding="utf-8")
    with pytest.raises(eom.DescriptionError) as caught:
        eom.load(path)
    assert str(caught.value) == f"{path}:3:13: bodies.a.mass: '1 m' is in m, expected kg"


@pytest.mark.parametrize("name", ["path", "file", "text", "settings", "overrides"])
def test_a_parameter_may_have_any_name(name: str, tmp_path: Path) -> None:
    file = tmp_path / "named.yaml"
    file.write_text(f"name: named\nparameters: {{{name}: 3}}\nbodies: {{a: {{mass: {name}, at: [0, 0, 0]}}}}\n")
    overrides: dict[str, Any] = {name: 2.0}
    assert eom.load(file, **overrides).system.bodies[0].mass == 2.0


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        ({"U": "h_r"}, "cannot set 'U': 'h_r' is in m, expected m/s"),
        ({"U": 100.0}, "cannot set 'U': it is 100, but at most 44.4444 is allowed"),
        ({"U": "2*V"}, "cannot set 'U': unknown parameter 'V'"),
        ({"tractor_ride.at.z": 1.0}, "cannot set 'tractor_ride.at.z': it is computed from h_r"),
    ],
)
def test_a_refused_override_is_called_by_name(settings: dict[str, Any], sentence: str) -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.load(TRAIN, **settings)
    assert sentence in str(caught.value)


def test_a_parameter_may_be_a_plain_number_or_quantity() -> None:
    file = "name: short\nparameters: {m: 2 t, n: 2*m}\nbodies: {a: {mass: n, at: [0, 0, 0]}}\n"
    assert eom.loads(file).system.bodies[0].mass == 4000.0
