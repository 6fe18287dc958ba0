"""Shipped vehicles with wheels of their own: what moves, what carries them, what they share with their linear twins."""

import numpy as np
import pytest

import eom
from eom.analysis.loads import trim_loads
from eom.assembly.elastic import elastic_items
from eom.assembly.matrices import assemble_matrices
from eom.assembly.pivots import choose_coordinates
from eom.splice.contact import spliced
from tests.vehicles.shipped import vehicle

G = 9.8
TRACTOR = ((6308, 1.384), (1950, 3.98845))
TRAILER = ((15_927, 6.385), (2070, 11.4972))


@pytest.mark.parametrize(
    ("name", "motions", "spins"),
    [
        # x, y, yaw; a yaw for each towed unit; a roll for each of two bodies of a unit
        ("b_train", 3 + 2 + 6, 18),
        ("tractor_semitrailer", 3 + 1 + 4, 12),
        ("a_train_double", 3 + 3 + 8, 20),
        ("tractor_semitrailer_nonlinear", 3 + 1, 0),
        ("b_train_yaw_plane_nonlinear", 3 + 2, 0),
        # six of the body, one of each wheel carrier
        ("car", 6 + 4, 4),
    ],
)
def test_degrees_of_freedom_are_those_of_the_bodies_and_of_spinning_wheels(name: str, motions: int, spins: int) -> None:
    still = {"car_air.area": 0.0} if name == "car" else {}
    assembly = eom.assemble(vehicle(name, **still))
    assert len(assembly.reduction.independent) == motions
    assert len(assembly.independent) == 2 * motions
    assert sum(wheel.number for wheel in assembly.system.wheels if wheel.spin_inertia) == spins


def carried(
    masses: tuple[tuple[float, float], ...], far: float, hitch: tuple[float, float] = (0.0, 0.0)
) -> list[float]:
    """Loads [N] at the front of a unit and *far* behind it, of (mass, place behind) and of a load with its place."""
    moment = G * sum(mass * behind for mass, behind in masses) + hitch[0] * hitch[1]
    rear = moment / far
    return [G * sum(mass for mass, _ in masses) + hitch[0] - rear, rear]


def test_every_unit_of_the_a_train_double_stands_by_its_levers() -> None:
    second, last = carried(TRAILER, 11.5)
    pintle, dolly = carried(((700, 1.7), (900, 2.1)), 2.1, (second, 2.1))
    first, tridem = carried(TRAILER, 11.5, (pintle, 13.4))
    front, tandem = carried(TRACTOR, 5.635, (first, 5.635))
    loads = trim_loads(eom.assemble(vehicle("a_train_double", f_r=0.0)))
    # rounding of a solve
    assert [force[2] for force, _ in loads.supports.values()] == pytest.approx(
        [front, tandem, tridem, dolly, last], rel=1e-9
    )
    assert [force[2] for force, _ in loads.couplings.values()] == pytest.approx([first, pintle, second], rel=1e-9)


def test_the_tractor_semitrailer_stands_by_its_levers() -> None:
    first, tridem = carried(TRAILER, 11.5)
    front, tandem = carried(TRACTOR, 5.635, (first, 5.635))
    loads = trim_loads(eom.assemble(vehicle("tractor_semitrailer", f_r=0.0)))
    # rounding of a solve
    assert [force[2] for force, _ in loads.supports.values()] == pytest.approx([front, tandem, tridem], rel=1e-9)


@pytest.mark.parametrize(
    ("name", "twin"),
    [
        ("tractor_semitrailer_nonlinear", "tractor_semitrailer_yaw_plane"),
        ("b_train_yaw_plane_nonlinear", "b_train_yaw_plane"),
        ("b_train", "b_train_yaw_roll"),
    ],
)
def test_a_nonlinear_file_has_the_bodies_places_and_stiffnesses_of_its_linear_twin(name: str, twin: str) -> None:
    rich, plain = vehicle(name).system, vehicle(twin).system
    assert rich.bodies == plain.bodies
    assert rich.gravity == plain.gravity
    assert {law.name: law.cornering for law in rich.tyres} == {law.name: law.cornering for law in plain.tyres}
    assert {law.kind for law in rich.tyres} == {"magic_formula"}
    assert not any(item.moving for item in rich.constraints)
    middle = {wheel.axle: wheel for wheel in plain.wheels}
    for axle, wheel in middle.items():
        own = [item for item in rich.wheels if item.axle == axle]
        assert sum(item.number for item in own) == wheel.number
        centre = np.mean([item.place for item in own], axis=0)
        assert np.array_equal(centre, wheel.place)
        assert {(item.tyre, item.steer) for item in own} == {(wheel.tyre, wheel.steer)}


def test_the_car_stands_on_springs_that_carry_the_weight_above_them() -> None:
    car = vehicle("car")
    at_rest = spliced(car.system)
    items = elastic_items(at_rest)
    tensions = assemble_matrices(at_rest, choose_coordinates(at_rest)).statics.tensions
    loads = dict(zip((item.name for item in items), tensions, strict=True))
    sprung = 1400 * 9.81 / 2.0
    front, rear = sprung * 1.5 / 2.7, sprung * 1.2 / 2.7
    # tension is positive
    expected = {
        "car_front_left_spring": -front,
        "car_rear_right_spring": -rear,
        "axle_1.left.vertical": front + 40 * 9.81,
        "axle_2.right.vertical": rear + 44 * 9.81,
    }
    # rounding of a solve
    assert {name: loads[name] for name in expected} == pytest.approx(expected, rel=1e-9)
    assert {wheel.spring: wheel.mirrored for wheel in car.system.wheels} == {
        "axle_1.left.vertical": False,
        "axle_1.right.vertical": True,
        "axle_2.left.vertical": False,
        "axle_2.right.vertical": True,
    }


def test_the_cars_front_wheels_steer_and_drive() -> None:
    wheels = vehicle("car").system.wheels
    assert [wheel.drive_share for wheel in wheels] == [0.5, 0.5, 0.0, 0.0]
    assert [wheel.steer for wheel in wheels] == ["axle_1.steer", "axle_1.steer", "", ""]
    assert [wheel.brake_gain for wheel in wheels] == pytest.approx([150e-6, 150e-6, 75e-6, 75e-6], rel=1e-15)
