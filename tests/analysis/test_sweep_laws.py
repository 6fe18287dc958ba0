"""Laws of the kinematic sweep on the shipped suspensions."""

import numpy as np
import pytest
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

import eom
from eom.analysis import KinematicSweep
from eom.vehicle.elements import GROUND
from eom.vehicle.mirror import other_side
from tests.vehicles.shipped import text, vehicle

LIFT = (-0.08, 0.08)
DOWN = (0.08, -0.08)
CAR, STRUT = "double_wishbone_car", "strut_suspension"
FRONT = {"double_wishbone_car": "front_left_road", "strut_suspension": "left_road"}
RACK = "rack_travel"


def sweep(name: str, points: int = 5, **drive: tuple[float, float]) -> KinematicSweep:
    return eom.kinematic_sweep(vehicle(name), drive, hold=["chassis"], points=points)


@pytest.mark.parametrize("name", [CAR, STRUT])
@pytest.mark.parametrize("drive", ["road", "rack"])
def test_at_the_drawing_the_sweeps_motion_is_one_of_the_linear_models(name: str, drive: str) -> None:
    result = sweep(name, 3, **{FRONT[name] if drive == "road" else RACK: (-0.02, 0.02)})
    assembly = eom.assemble(result.vehicle)
    motion = result.motions[1].ravel()
    T = assembly.reduction.T
    # in the space that T spans: its coordinates reproduce it
    again = T @ motion[assembly.reduction.independent]
    assert np.max(np.abs(again - motion)) < 1e-8 * np.max(np.abs(motion))
    assert np.max(np.abs(assembly.J @ motion)) < 1e-10


@pytest.mark.parametrize("name", [CAR, STRUT])
def test_the_motion_told_is_the_derivative_of_the_positions(name: str) -> None:
    fine = sweep(name, 81, **{FRONT[name]: (0.0, 0.04), RACK: (0.0, 0.02)})
    h = 1.0 / 80
    k = 40
    rate = (fine.positions[k - 2] - 8 * fine.positions[k - 1] + 8 * fine.positions[k + 1] - fine.positions[k + 2]) / (
        12.0 * h
    )
    # fourth order: h^4 is 2e-8, times derivatives of a few units over thirty; the spin takes no part
    assert np.max(np.abs(rate - fine.motions[k, :, :3])) < 1e-8


@pytest.mark.parametrize("name", [CAR, STRUT])
def test_the_mirrored_drive_gives_mirrored_curves(name: str) -> None:
    left, right = FRONT[name], other_side(FRONT[name])
    one = sweep(name, 5, **{left: LIFT, right: (-0.02, 0.03), RACK: (-0.02, 0.04)})
    two = sweep(name, 5, **{right: LIFT, left: (-0.02, 0.03), RACK: (0.02, -0.04)})
    signs = {"steer": -1.0, "contact_y": -1.0, "roll_centre_y": -1.0}
    for key, measure in one.measures.items():
        owner, _, quantity = key.rpartition(".")
        if owner in one.wheels or owner in one.pairs:
            image = two.measures[f"{other_side(owner)}.{quantity}"].values * signs.get(quantity, 1.0)
            assert measure.values == pytest.approx(image, abs=1e-9, nan_ok=True)


@pytest.mark.parametrize("name", [CAR, STRUT])
def test_every_joint_is_closed_in_plain_geometry(name: str) -> None:
    result = sweep(name, 7, **{FRONT[name]: LIFT, other_side(FRONT[name]): DOWN, RACK: (-0.03, 0.05)})
    system = result.vehicle.system

    def place(k: int, body: int, drawn: tuple[float, ...]) -> np.ndarray:
        if body == GROUND:
            return np.array(drawn)
        arm = np.subtract(drawn, system.bodies[body].centre)
        return np.asarray(result.positions[k, body] + result.rotations[k, body] @ arm)

    seen = 0
    for item in (constraint.connection for constraint in system.constraints):
        for k in range(7):
            first, second = (place(k, *pair) for pair in zip(item.bodies, item.places, strict=True))
            if item.line:
                length = np.linalg.norm(np.subtract(*item.places))
                assert np.linalg.norm(first - second) == pytest.approx(length, abs=1e-10)
            elif item.forces == 3:
                assert first == pytest.approx(second, abs=1e-10)
            seen += 1
    assert seen > 50


def distances(upright: np.ndarray, fixed: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    return np.asarray(np.linalg.norm(upright - fixed, axis=1) - lengths)


def test_a_double_wishbone_corner_is_the_one_that_six_distances_give() -> None:
    """The upright as three balls, each wishbone as two rods, the tie rod as one: distances alone, no joints."""
    result = sweep(CAR, 9, front_left_road=LIFT, rack_travel=(-0.04, 0.04))
    x = 1.25
    hub = np.array([x, 0.78, 0.31])
    balls = np.array([[x + 0.005, 0.72, 0.19], [x - 0.015, 0.69, 0.49], [x - 0.13, 0.70, 0.24]])
    lower, upper, rod = np.array([x, 0.36, 0.2]), np.array([x - 0.01, 0.42, 0.46]), np.array([x - 0.13, 0.37, 0.24])
    along_lower, along_upper = 0.1 * np.array([1.0, 0.0, -0.02]), 0.1 * np.array([1.0, 0.0, 0.06])
    inner = np.array([lower - along_lower, lower + along_lower, upper - along_upper, upper + along_upper, rod])
    which = [0, 0, 1, 1, 2]
    lengths = np.linalg.norm(balls[which] - inner, axis=1)
    body = result.vehicle.draft.index["front_left_upright"]
    drawn = np.array(result.vehicle.system.bodies[body].centre)

    def closed(unknown: np.ndarray, lift: float, rack: float) -> np.ndarray:
        R = Rotation.from_rotvec(unknown[3:]).as_matrix()
        moved = hub + unknown[:3] + (balls - hub) @ R.T
        ends = inner + np.array([[0.0, 0.0, 0.0]] * 4 + [[0.0, rack, 0.0]])
        return np.append(distances(moved[which], ends, lengths), unknown[2] - lift)

    for k, (lift, rack) in enumerate(zip(*(item.values for item in result.drives.values()), strict=True)):
        unknown, _, flag, _ = fsolve(
            closed, [0.0, 0.0, lift, 0.0, 0.0, 4.0 * rack], (lift, rack), full_output=True, xtol=1e-13
        )
        assert flag == 1
        R = Rotation.from_rotvec(unknown[3:]).as_matrix()
        assert result.rotations[k, body] == pytest.approx(R, abs=1e-9)
        centre = hub + unknown[:3] + R @ (drawn - hub)
        assert result.positions[k, body] == pytest.approx(centre, abs=1e-9)
        steer, camber = np.arctan2(-R[0, 1], R[1, 1]), -np.arctan2(R[2, 1], R[1, 1])
        assert result.measures["front_left_tyre.steer"].values[k] == pytest.approx(steer, abs=1e-9)
        assert result.measures["front_left_tyre.camber"].values[k] == pytest.approx(camber, abs=1e-9)
        assert result.measures["front_left_tyre.toe"].values[k] == pytest.approx(-steer, abs=1e-9)


def test_a_steered_rack_turns_both_wheels_to_the_side_it_should_and_leaves_the_rear_alone() -> None:
    result = sweep(CAR, 3, rack_travel=(-0.03, 0.03))
    left, right = (result.measures[f"front_{side}_tyre.steer"].values for side in ("left", "right"))
    # the rods stand behind the axle: a rack to the left pulls the wheels' rear to the left, the wheels turn right
    assert left[-1] < -0.1
    assert right[-1] < -0.1
    assert result.measures["front_tyre.roll_centre_height"].values == pytest.approx(np.full(3, np.nan), nan_ok=True)
    assert np.max(np.abs(result.measures["rear_left_tyre.steer"].values)) < 1e-12
    assert np.max(np.abs(result.measures["rear_left_tyre.travel"].values)) < 1e-12


def test_undriven_motions_are_named() -> None:
    spins = tuple(f"{end}_{side}_wheel.pitch" for end in ("front", "rear") for side in ("left", "right"))
    held = sweep(CAR, 3, front_left_road=LIFT)
    assert set(held.undriven) == set(spins)
    free = eom.kinematic_sweep(
        vehicle(CAR), {"front_left_road": (0.0, 0.02)}, hold=["chassis"], free=["rear_left_road"], points=3
    )
    assert len(free.undriven) == 5
    assert any(name.startswith("rear_left") and name not in spins for name in free.undriven)
    # what nothing drives stays where it is
    assert np.max(np.abs(free.measures["rear_left_tyre.travel"].values)) < 1e-12


def test_ends_of_a_range_and_the_number_of_points_do_not_change_the_curve() -> None:
    whole = sweep(STRUT, 9, left_road=(-0.04, 0.04))
    part = sweep(STRUT, 3, left_road=(0.02, 0.04))
    for key, measure in whole.measures.items():
        assert measure.values[6:] == pytest.approx(part.measures[key].values, abs=1e-9, nan_ok=True)


def test_a_request_is_refused_with_all_its_mistakes() -> None:
    with pytest.raises(eom.MechanismError) as stop:
        eom.kinematic_sweep(
            vehicle(STRUT), {"left_rood": (0, 1), "right_road": (0, "20 kg")}, hold=["chasis"], free=["rack"], points=1
        )
    message = str(stop.value)
    for piece in (
        "drive 'left_rood': unknown actuator; did you mean 'left_road'?",
        "drive 'right_road': '20 kg' is",
        "hold 'chasis': unknown body; did you mean 'chassis'?",
        "free 'rack': unknown actuator",
        "points: expected 2 to 10000, got 1",
    ):
        assert piece in message
    with pytest.raises(eom.MechanismError, match="nothing moves"):
        sweep(STRUT, left_road=(0.01, 0.01))
    with pytest.raises(eom.MechanismError, match="nothing is driven"):
        sweep(STRUT)


def test_a_wheel_needs_its_radius_at_its_place_in_the_file() -> None:
    bare = eom.loads(text(STRUT).replace(", radius: r", ""), "strut.yaml")
    with pytest.raises(eom.DescriptionError, match=r"strut.yaml:\d+:\d+: connectors.left_tyre: needs 'radius'"):
        eom.kinematic_sweep(bare, {"left_road": LIFT}, hold=["chassis"])
    with pytest.raises(eom.DescriptionError, match=r"connectors\.left_tyre\.radius: is 0: expected more than zero"):
        eom.loads(text(STRUT).replace("radius: r", "radius: 0"), "strut.yaml")


def test_a_contact_patch_takes_no_part_in_what_its_wheel_does() -> None:
    """A relaxation length changes no kinematics."""
    lagging = text(STRUT).replace("{per: wheel,", "{per: wheel, relaxation: 0.3,")
    assert lagging != text(STRUT)
    one, other = (
        eom.kinematic_sweep(eom.loads(file), {"left_road": LIFT}, hold=["chassis"], points=5)
        for file in (text(STRUT), lagging)
    )
    assert not any("patch" in name for name in other.undriven)
    for key, measure in one.measures.items():
        assert other.measures[key].values == pytest.approx(measure.values, abs=1e-12, nan_ok=True)


def test_a_locked_drive_names_what_locks_it() -> None:
    with pytest.raises(eom.MechanismError, match="cannot move from the drawing, locked by") as stop:
        eom.kinematic_sweep(vehicle(STRUT), {"left_road": LIFT}, hold=["chassis", "left_arm"])
    assert "left_road" in str(stop.value)
    assert stop.value.partial is None


def test_the_contact_of_a_rolling_wheel_is_refused() -> None:
    with pytest.raises(eom.MechanismError, match="contact of a rolling wheel"):
        eom.kinematic_sweep(vehicle("disc"), {"lean_moment": (0.0, 0.1)})
