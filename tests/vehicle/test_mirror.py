"""Mirror images in the plane y = 0."""

import numpy as np
import pytest

import eom
from eom.vehicle.mirror import other_side

TEXT = """
name: mirrored
parameters:
  track: {value: 2 m}
bodies:
  left_wheel:
    mass: 20 kg
    at: [1, track/2, 0.3]
    inertia: {xx: 1, yy: 2, zz: 1.5, xy: 0.1, yz: 0.2, xz: 0.3}
    velocity: [5, 0.1, 0.2]
    spin: [0.4, 16, 0.6]
    mirror: true
  rear_left_link:
    mass: 2
    at: [0, 0.5, 0.2]
    inertia: {tensor: [[1, -0.1, -0.3], [-0.1, 2, -0.2], [-0.3, -0.2, 1.5]]}
    mirror: true
  upright: {mass: 1, at: [0, 0, 0]}
connectors:
  hub_left:
    {type: rigid_point, between: [left_wheel, upright], at: [1, 1, 0.3], forces: 1, axis: [0.6, 0.8, 0], mirror: true}
  left_spring:
    {type: spring, between: [rear_left_link, ground], ends: [[0, 0.5, 0.2], [0, 0.4, 1]], damping: 1, mirror: true}
loads:
  left_push: {body: left_wheel, force: [1, 2, 3], moment: [4, 5, 6], frame: left_wheel, mirror: true}
actuators:
  left_pull: {body: left_wheel, reaction_on: rear_left_link, at: [1, 1, 0], along: [0, 1, 0], mirror: true}
sensors:
  left_y: {body: left_wheel, relative_to: upright, along: [0, 1, 0], measure: position, mirror: true}
"""
FLIP = np.diag([1.0, -1.0, 1.0])


def system() -> tuple[eom.Vehicle, dict[str, int]]:
    vehicle = eom.loads(TEXT)
    return vehicle, {body.name: k for k, body in enumerate(vehicle.system.bodies)}


@pytest.mark.parametrize(("left", "right"), [("left_wheel", "right_wheel"), ("rear_left_link", "rear_right_link")])
def test_bodies(left: str, right: str) -> None:
    vehicle, index = system()
    one, image = (vehicle.system.bodies[index[name]] for name in (left, right))
    assert image.mass == one.mass
    assert np.array_equal(image.centre, FLIP @ one.centre)
    assert np.array_equal(image.velocity, FLIP @ one.velocity)
    # a spin is axial: the reflection of the plane's normal keeps y alone
    assert np.array_equal(image.spin, -FLIP @ one.spin)
    assert np.array_equal(image.inertia, FLIP @ np.array(one.inertia) @ FLIP)


def test_both_forms_of_an_inertia_are_the_same() -> None:
    vehicle, index = system()
    for side in ("left", "right"):
        wheel, link = (vehicle.system.bodies[index[name]] for name in (f"{side}_wheel", f"rear_{side}_link"))
        assert wheel.inertia == link.inertia


def test_connectors_stand_on_the_other_side_between_the_images() -> None:
    vehicle, index = system()
    joints = {item.connection.name: item.connection for item in vehicle.system.constraints}
    assert joints["hub_right"].bodies == (index["right_wheel"], index["upright"])
    assert joints["hub_right"].places[0] == (1.0, -1.0, 0.3)
    assert joints["hub_right"].force_axis == (0.6, -0.8, 0.0)
    springs = {item.connection.name: item.connection for item in vehicle.system.elastic}
    assert springs["right_spring"].bodies == (index["rear_right_link"], -1)
    assert springs["right_spring"].places == ((0.0, -0.5, 0.2), (0.0, -0.4, 1.0))


def test_forces_are_polar_and_moments_axial() -> None:
    vehicle, index = system()
    load = {item.name: item for item in vehicle.system.loads}["right_push"]
    assert load.force == (1.0, -2.0, 3.0)
    assert load.moment == (-4.0, 5.0, -6.0)
    assert load.frame == load.body == index["right_wheel"]


def test_signals_keep_their_direction() -> None:
    vehicle, index = system()
    pull = {item.name: item.connection for item in vehicle.system.inputs}["right_pull"]
    assert pull.bodies == (index["right_wheel"], index["rear_right_link"])
    assert pull.force_axis == (0.0, 1.0, 0.0)
    assert pull.places[0] == (1.0, -1.0, 0.0)
    seen = {item.name: item.terms[0][1] for item in vehicle.system.outputs}["right_y"]
    assert seen.bodies == (index["right_wheel"], index["upright"])
    assert seen.force_axis == (0.0, 1.0, 0.0)


def test_images_follow_their_parameters() -> None:
    wide = eom.loads(TEXT, track="4 m")
    centres = {body.name: body.centre for body in wide.system.bodies}
    assert centres["left_wheel"][1] == 2.0
    assert centres["right_wheel"][1] == -2.0


def test_what_is_not_mirrored_has_no_image() -> None:
    _, index = system()
    assert set(index) == {"left_wheel", "right_wheel", "rear_left_link", "rear_right_link", "upright"}


@pytest.mark.parametrize(
    ("name", "image"),
    [
        ("left", "right"),
        ("front_left_hub", "front_right_hub"),
        ("wheel_right_2", "wheel_left_2"),
        ("left2", "right2"),
        ("upright", "upright"),
        ("cleft_lip", "cleft_lip"),
    ],
)
def test_sides_are_whole_words(name: str, image: str) -> None:
    assert other_side(name) == image
    assert other_side(image) == name


def test_a_mirrored_sensor_feels_the_mirrored_input() -> None:
    file = """
name: two wheels
bodies:
  left_wheel: {mass: 10, at: [0, 1, 0], inertia: {xx: 1, yy: 1, zz: 1}, mirror: true}
actuators:
  left_road: {body: left_wheel, along: [0, 0, 1], mirror: true}
sensors:
  left_deflection: {body: left_wheel, along: [0, 0, 1], measure: position, feedthrough: {left_road: -1}, mirror: true}
"""
    outputs = {item.name: item.feedthrough for item in eom.loads(file).system.outputs}
    assert outputs == {"left_deflection": (("left_road", -1.0),), "right_deflection": (("right_road", -1.0),)}
