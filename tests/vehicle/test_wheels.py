"""Wheels, tyre laws, drive, drag and grade as the elements that a file makes of them."""

import math
from pathlib import Path
from typing import get_args

import pytest

import eom
from eom.analysis.loads import trim_loads
from eom.codegen.module import module_text
from eom.tyre.dugoff import Dugoff
from eom.tyre.magic_formula import MagicFormula
from eom.tyre.parameters import coefficients
from eom.vehicle.elements import Drive, System, Wheel
from eom.vehicle.tyres import FOLLOWS, DugoffLaw, MagicFormulaLaw
from tests.vehicles.shipped import vehicle

CAR = """\
name: car
gravity: 9.8
trim: {speed: 20 m/s}
tyres:
  tyre: {per: wheel, cornering: 50 kN/rad, trail: 30 mm, relaxation: 0.4 m}
units:
  car:
    bodies:
      frame: {mass: 1500, at: [0, 0, 0.5], inertia: {xx: 500, yy: 2000, zz: 2200}}
      left_hub: {mass: 20, at: [-1.4, 0.8, 0.3], inertia: {xx: 1, yy: 1, zz: 1}, mirror: true}
    axle_groups:
      front: {body: frame, support: {at: [1.2, 0, 0]}}
      rear: {body: frame, support: {at: [-1.4, 0, 0]}, roll_stiffness: 60 kN*m/rad}
    axles:
      front: {group: front, x: 1.2, tyre: tyre, steered: true}
      rear: {group: rear, x: -1.4, tyre: tyre}
"""


def system(*changes: tuple[str, str]) -> System:
    """The car's elements, with changes to its text."""
    text = CAR
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return eom.loads(text).system


def by_name(elements: System) -> dict[str, Wheel]:
    """Wheels by their names."""
    return {wheel.name: wheel for wheel in elements.wheels}


APART = ("steered: true", "steered: true, radius: 0.3, track: 1.6 m")


def test_a_file_without_new_keys_keeps_its_slip_and_has_a_wheel_in_the_middle_of_each_axle() -> None:
    car = system()
    assert [item.connection.name for item in car.slip] == ["axle_1", "axle_2"]
    assert [item.name for item in car.inputs] == ["axle_1.steer"]
    front, rear = car.wheels
    assert (front.name, front.axle, front.number, front.steer) == ("axle_1", "axle_1", 2.0, "axle_1.steer")
    assert (rear.name, rear.place, rear.steer) == ("axle_2", (-1.4, 0.0, 0.0), "")
    assert (front.support, front.share, rear.support, rear.share) == ("car_front", 1.0, "car_rear", 1.0)
    assert rear.roll_rate == 0.0
    assert car.tyres[0][:7] == ("tyre", "linear", 50e3, 0.0, 0.0, 0.03, 0.4)
    assert car.drive == Drive(0.0, 0.0, ())


@pytest.mark.parametrize(
    "key", ["radius: 0.3", "track: 1.6", "driven: true, radius: 0.3", "brake_gain: 0.01, radius: 0.3"]
)
def test_any_new_key_of_an_axle_takes_the_linear_tyres_out_of_the_whole_file(key: str) -> None:
    car = system(("steered: true", f"steered: true, {key}"))
    assert car.slip == ()
    assert car.inputs == ()
    assert [body.name for body in car.bodies] == ["car_frame", "car_left_hub", "car_right_hub"]


@pytest.mark.parametrize("key", ["rolling_resistance: 0.01", "nonlinear: {kind: dugoff, friction: 0.9}"])
def test_any_new_key_of_a_tyre_takes_the_linear_tyres_out_of_the_whole_file(key: str) -> None:
    radius = ("steered: true", "steered: true, radius: 0.3"), ("tyre: tyre}", "tyre: tyre, radius: 0.3}")
    assert system(("trail: 30 mm", key), *radius).slip == ()


def test_a_track_sets_wheels_left_and_right_of_the_middle() -> None:
    wheels = by_name(system(APART))
    assert list(wheels) == ["axle_1.left", "axle_1.right", "axle_2"]
    assert (wheels["axle_1.left"].place, wheels["axle_1.right"].place) == ((1.2, 0.8, 0.0), (1.2, -0.8, 0.0))
    assert [wheel.number for wheel in wheels.values()] == [1.0, 1.0, 2.0]
    assert [wheel.mirrored for wheel in wheels.values()] == [False, True, False]
    assert [wheel.share for wheel in wheels.values()] == [0.5, 0.5, 1.0]
    assert {wheels["axle_1.left"].steer, wheels["axle_1.right"].steer} == {"axle_1.steer"}


def test_spin_inertia_and_brakes_count_for_all_that_a_wheel_stands_for() -> None:
    keys = "radius: 0.3, spin_inertia: 2, brake_gain: 10 kN*m/MPa"
    tyre = ("relaxation: 0.4 m", "longitudinal: 60 kN")
    both = ("tyre: tyre}", f"tyre: tyre, {keys}}}")
    wheels = by_name(system(tyre, both, ("steered: true", f"steered: true, {keys}, track: 1.6")))
    assert [wheel.spin_inertia for wheel in wheels.values()] == [2.0, 2.0, 4.0]
    assert [wheel.brake_gain for wheel in wheels.values()] == pytest.approx([0.01, 0.01, 0.02], rel=1e-15)


def test_driven_wheels_share_the_torque_equally() -> None:
    wheels = by_name(system(("steered: true", "steered: true, driven: true, radius: 0.3, track: 1.6")))
    assert [wheel.drive_share for wheel in wheels.values()] == [0.5, 0.5, 0.0]
    both = ("tyre: tyre}", "tyre: tyre, driven: true, radius: 0.3}")
    wheels = by_name(system(("steered: true", "steered: true, driven: true, radius: 0.3, track: 1.6"), both))
    assert [wheel.drive_share for wheel in wheels.values()] == [0.25, 0.25, 0.5]


def test_a_locked_differential_names_the_driven_axles_and_lags_are_seconds() -> None:
    more = "drive: {differential: locked, lag: 100 ms}\nbrakes: {lag: 0.25 s}\n"
    axle = "tyre: tyre, driven: true, radius: 0.3, brake_gain: 0.01}\n"
    assert system(("tyre: tyre}\n", axle + more)).drive == Drive(0.1, 0.25, ("axle_2",))


def test_a_roll_to_the_right_unloads_the_left_wheels_by_their_part_of_the_groups_roll_stiffness() -> None:
    rear = ("tyre: tyre}", "tyre: tyre, track: 1.5 m}\n      last: {like: rear, x: -2.4, track: 2 m}")
    wheels = [wheel for wheel in system(rear).wheels if wheel.axle != "axle_1"]
    assert [wheel.roll_rate for wheel in wheels] == pytest.approx([-20e3, 20e3, -15e3, 15e3], rel=1e-15)
    moment = sum(wheel.roll_rate * wheel.place[1] for wheel in wheels)
    assert moment == pytest.approx(-60e3, rel=1e-15)
    assert {wheel.spring for wheel in wheels} == {"car_rear.tyres"}
    assert sum(wheel.share for wheel in wheels) == 1.0


def test_vertical_springs_stand_under_each_wheel() -> None:
    stiff = ("relaxation: 0.4 m", "vertical_stiffness: 200 kN/m, vertical_damping: 300 N*s/m")
    free = (", support: {at: [1.2, 0, 0]}", ""), (", support: {at: [-1.4, 0, 0]}, roll_stiffness: 60 kN*m/rad", "")
    car = system(stiff, *free, APART)
    springs = {item.connection.name: item for item in car.elastic}
    assert list(springs) == ["axle_1.left.vertical", "axle_1.right.vertical", "axle_2.vertical"]
    assert [item.stiffness[0] for item in springs.values()] == [200e3, 200e3, 400e3]
    assert [item.damping[0] for item in springs.values()] == [300.0, 300.0, 600.0]
    for wheel in car.wheels:
        assert springs[wheel.spring].connection.places[0] == wheel.place
        assert (wheel.support, wheel.share) == ("", 0.0)


def test_wheels_on_bodies_of_their_own_stand_on_the_left_and_the_right_one() -> None:
    car = system(("group: rear, x: -1.4, tyre: tyre", "bodies: [left_hub, right_hub], x: -1.4, tyre: tyre, track: 1.6"))
    wheels = by_name(car)
    names = [body.name for body in car.bodies]
    assert names[wheels["axle_2.left"].body] == "car_left_hub"
    assert names[wheels["axle_2.right"].body] == "car_right_hub"


def test_an_axle_like_another_has_its_keys_but_for_its_own() -> None:
    like = "\n      last: {like: rear, x: -2.4, steered: true, radius: 0.4}"
    car = eom.loads(CAR.replace("tyre: tyre}", "tyre: tyre, radius: 0.3, track: 1.5, brake_gain: 2}" + like))
    rear, last = (by_name(car.system)[name] for name in ("axle_2.left", "axle_3.left"))
    assert last == rear._replace(
        name="axle_3.left", axle="axle_3", place=(-2.4, 0.75, 0.0), radius=0.4, steer="axle_3.steer"
    )
    # its literals change apart
    other = by_name(car.with_values(**{"axle_3.track": 1.7}).system)
    assert (other["axle_2.left"].place[1], other["axle_3.left"].place[1]) == (0.75, 0.85)


def test_stiffness_per_axle_is_that_of_two_wheels() -> None:
    law = system(("per: wheel", "per: axle"), ("trail: 30 mm", "trail: 30 mm, camber: 2 kN/rad")).tyres[0]
    assert (law.cornering, law.camber, law.trail, law.relaxation) == (25e3, 1e3, 0.03, 0.4)


def test_a_magic_formula_has_friction_both_ways_and_its_further_coefficients() -> None:
    text = "nonlinear: {kind: magic_formula, friction: 0.8, mu_y: 0.7, C_y: 1.4, RBX1: 9, combined: cosine}"
    (law,) = system(("relaxation: 0.4 m", text)).tyres
    assert law.kind == "magic_formula"
    assert dict(law.coefficients) == {"mu_x": 0.8, "mu_y": 0.7, "C_y": 1.4, "RBX1": 9.0, "combined": 1.0}


def test_a_tyre_of_a_file_needs_no_stiffness(tmp_path: Path) -> None:
    (tmp_path / "tyres").mkdir()
    (tmp_path / "tyres" / "any.tir").write_text("", encoding="utf-8")
    file = tmp_path / "car.yaml"
    tyre = "tyre: {per: wheel, nonlinear: {kind: tir, file: tyres/any.tir}}"
    tyre_line = next(line.strip() for line in CAR.splitlines() if "cornering" in line)
    file.write_text(CAR.replace(tyre_line, tyre), encoding="utf-8")
    (law,) = eom.load(file).system.tyres
    assert (law.kind, law.file) == ("tir", str((tmp_path / "tyres" / "any.tir").resolve()))
    assert (law.cornering, law.longitudinal) == (0.0, 0.0)


def test_the_schema_knows_every_coefficient_of_the_laws_that_nothing_else_settles() -> None:
    known = set(MagicFormulaLaw.model_fields) - {"kind", "friction", "combined"}
    assert known == {item.name for item in coefficients(MagicFormula)} - set(FOLLOWS)
    combined = MagicFormulaLaw.model_fields["combined"].annotation
    assert get_args(combined) == ("ellipse", "cosine")
    settled = {*FOLLOWS, "cornering", "longitudinal"}
    assert set(DugoffLaw.model_fields) - {"kind"} == {item.name for item in coefficients(Dugoff)} - settled


def test_a_grade_pulls_every_body_backwards_by_its_part_of_the_weight() -> None:
    car = system(("speed: 20 m/s", "speed: 20 m/s, grade: 0.05"))
    assert [(car.bodies[load.body].name, load.frame) for load in car.loads] == [
        ("car_frame", 0),
        ("car_left_hub", 1),
        ("car_right_hub", 2),
    ]
    for load in car.loads:
        body = car.bodies[load.body]
        assert load.place == body.centre
        assert load.force == pytest.approx((-body.mass * 9.8 * 0.05, 0.0, 0.0), rel=1e-15)


def test_drag_is_a_load_at_the_trim_and_its_slope_about_it() -> None:
    air = "connectors:\n  air: {type: drag, body: car_frame, at: [1, 0, 0.6], area: 2 m^2, coefficient: 0.3%s}\n"
    for density, rho in (("", 1.2), (", density: 1.0 kg/m^3", 1.0)):
        car = system(("tyre: tyre}\n", "tyre: tyre}\n" + air % density))
        (drag,), (load,), slip = car.drags, car.loads, car.slip[-1]
        assert drag[:3] == ("air", 0, (1.0, 0.0, 0.6))
        assert drag.factor == pytest.approx(0.3 * rho, rel=1e-15)
        assert (load.name, load.frame, load.place) == ("air", 0, drag.place)
        assert load.force[0] == pytest.approx(-drag.factor * 400.0, rel=1e-15)
        assert slip.moving
        # the slope of factor times U^2
        assert slip.coefficients[0][0] == pytest.approx(2.0 * drag.factor * 20.0, rel=1e-15)


def test_a_sensor_may_feed_the_steer_angle_of_a_wheel_through() -> None:
    text = CAR.replace(*APART)
    sensor = (
        "sensors:\n  slip: {body: car_frame, along: [0, 1, 0], measure: velocity, feedthrough: {axle_1.steer: -1}}\n"
    )
    assert eom.loads(text + sensor).system.outputs[-1].feedthrough == (("axle_1.steer", -1.0),)
    with pytest.raises(eom.DescriptionError, match=r"unknown input 'axle_2\.steer'; did you mean 'axle_1\.steer'"):
        eom.loads(text + sensor.replace("axle_1.", "axle_2."))


def test_names_of_wheels_lead_to_their_axles_in_the_file() -> None:
    car = eom.loads(CAR.replace(*APART), "car.yaml")
    assert str(car.mistake("axle_1.right", "lifts off")).startswith("car.yaml:15:7: units.car.axles.front: ")


def test_modules_of_files_with_linear_tyres_have_no_wheels_in_them() -> None:
    text = module_text(vehicle("b_train_yaw_plane"))
    assert " wheels=" not in text
    assert "tyres=" not in text


LOADS = {
    "tractor_front": 52_219.3,
    "tractor_tandem": 91_677.9,
    "semitrailer_1_tridem": 182_830.5,
    "semitrailer_2_tridem": 106_941.9,
}


def test_the_b_train_has_eighteen_wheels_on_four_supports() -> None:
    train = vehicle("b_train")
    wheels = train.system.wheels
    assert len(wheels) == 18
    assert len(train.system.tyres) == 4
    for support in LOADS:
        assert sum(wheel.share for wheel in wheels if wheel.support == support) == pytest.approx(1.0, rel=1e-15)
    assert sum(wheel.drive_share for wheel in wheels) == 1.0
    assert {wheel.axle for wheel in wheels if wheel.drive_share} == {"axle_2", "axle_3"}
    stiffness = {item.connection.name: item.stiffness[1] for item in train.system.elastic}
    for spring in {wheel.spring for wheel in wheels}:
        moment = math.fsum(wheel.roll_rate * wheel.place[1] for wheel in wheels if wheel.spring == spring)
        assert moment == pytest.approx(-stiffness[spring], rel=1e-14)


def test_the_b_trains_supports_carry_what_levers_of_its_weights_give() -> None:
    """Each trailer about its kingpin, then the tractor about its front axle."""
    trailer = 15_927 * 6.385 + 2070 * 11.4972
    rear = 9.8 * trailer / 11.5
    second = 9.8 * 17_997 - rear
    middle = (9.8 * trailer + second * 12.57) / 11.5
    first = 9.8 * 17_997 + second - middle
    tandem = 9.8 * (6308 * 1.384 + 1950 * 3.98845) / 5.635 + first
    front = 9.8 * 8258 + first - tandem
    found = trim_loads(eom.assemble(vehicle("b_train", f_r=0.0))).supports
    levers = dict(zip(LOADS, (front, tandem, middle, rear), strict=True))
    for name, printed in LOADS.items():
        # rounding of a solve, and of the printed digits
        assert found[name][0][2] == pytest.approx(levers[name], rel=1e-10)
        assert found[name][0][2] == pytest.approx(printed, abs=0.05)
