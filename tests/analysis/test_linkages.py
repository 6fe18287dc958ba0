"""Sweeps of planar mechanisms against their closed forms."""

import numpy as np
import pytest

import eom
from eom.analysis import KinematicSweep
from tests.analysis.linkages import HALF_TRACK, RADIUS, Point, four_bar, slider_crank, strut, wishbones

# closing loops to 1e-11 m leaves that much, over transmission angles that are never small here
CLOSED = 1e-9


def angle(vector: np.ndarray) -> float:
    """Angle of (x, z) from +x, positive about +y, which turns z towards x."""
    return float(np.arctan2(-vector[1], vector[0]))


def test_a_four_bar_linkage_follows_the_law_of_cosines_through_a_whole_turn_of_its_crank() -> None:
    A, B, C, D = np.array([0.0, 0.0]), np.array([0.0, 0.2]), np.array([0.5, 0.5]), np.array([0.6, 0.0])
    a, b, c = (float(np.linalg.norm(v)) for v in (B - A, C - B, D - C))
    sweep = eom.kinematic_sweep(
        four_bar((0.0, 0.0), (0.0, 0.2), (0.5, 0.5), (0.6, 0.0)), {"motor": ("-30 deg", "330 deg")}, points=73
    )
    crank = sweep.drives["motor"].values
    start = angle(B - A)
    ours = sweep.measures["rocker_turn"].values

    def rocker(turn: float) -> float:
        """Angle of D-C by the diagonal B-D and the law of cosines; the drawn branch has C to the left of B->D."""
        pin = A + a * np.array([np.cos(start + turn), -np.sin(start + turn)])
        diagonal = pin - D
        e = float(np.linalg.norm(diagonal))
        at_D = np.arccos((c**2 + e**2 - b**2) / (2.0 * c * e))
        return angle(diagonal) + float(at_D)

    expected = np.array([rocker(turn) - rocker(0.0) for turn in crank])
    assert np.max(np.abs(np.angle(np.exp(1j * (ours - expected))))) < CLOSED
    assert np.max(sweep.residuals) < 1e-11
    # back where it was after one turn
    assert np.max(np.abs(sweep.positions[-1] - sweep.positions[0])) < CLOSED
    assert sweep.undriven == ()


def test_a_slider_crank_has_its_stroke_through_two_whole_turns() -> None:
    crank, rod, start = 0.1, 0.35, 0.7
    vehicle = slider_crank(crank, rod, (crank * np.cos(start), crank * np.sin(start)))
    sweep = eom.kinematic_sweep(vehicle, {"motor": ("-360 deg", "360 deg")}, points=81)
    theta = start - sweep.drives["motor"].values
    stroke = crank * np.cos(theta) + np.sqrt(rod**2 - (crank * np.sin(theta)) ** 2)
    drawn = crank * np.cos(start) + np.sqrt(rod**2 - (crank * np.sin(start)) ** 2)
    assert np.max(np.abs(sweep.measures["stroke"].values - (stroke - drawn))) < CLOSED


def test_a_sweep_ends_where_crank_and_coupler_are_in_line_and_names_what_locks() -> None:
    A, B, C, D = (0.0, 0.0), (0.0, 0.5), (0.3, 0.6), (0.6, 0.0)
    a, b, c, d = 0.5, np.hypot(0.3, 0.1), np.hypot(0.3, 0.6), 0.6
    with pytest.raises(eom.MechanismError, match="loops lock") as stop:
        eom.kinematic_sweep(four_bar(A, B, C, D), {"motor": (-3.0, 0.2)}, points=33)
    partial = stop.value.partial
    assert isinstance(partial, KinematicSweep)
    # the crank stops where coupler and rocker are in line: the diagonal is b + c
    stretched = np.arccos((a**2 + d**2 - (b + c) ** 2) / (2.0 * a * d))
    limit = -(stretched - np.pi / 2.0)
    message = str(stop.value)
    reached = float(message.split("'motor' to ")[1].split(" rad", maxsplit=1)[0])
    # six digits are printed; at the limit itself the rocker's rate is infinite
    assert reached == pytest.approx(limit, abs=2e-5)
    for name in ("motor", "b", "c", "d"):
        assert name in message.split("locked by")[1]
    values = partial.drives["motor"].values
    assert values[-1] == 0.2
    assert limit < values[0] < limit + 3.2 / 32
    assert len(values) == len(partial.positions) < 33


def test_parallel_equal_wishbones_keep_the_wheel_upright_with_the_roll_centre_on_the_ground() -> None:
    arm = 0.35
    vehicle = wishbones(((0.35, 0.2), (0.35 + arm, 0.2)), ((0.35, 0.45), (0.35 + arm, 0.45)))
    lift = (-0.1, 0.1)
    sweep = eom.kinematic_sweep(vehicle, {"left_lift": lift, "right_lift": lift}, hold=["chassis"], points=21)
    rise = sweep.drives["left_lift"].values
    for side, sign in (("left", 1.0), ("right", -1.0)):
        measures = {name: sweep.measures[f"{side}_tyre.{name}"].values for name in ("camber", "toe", "travel")}
        assert np.max(np.abs(measures["camber"])) < CLOSED
        assert np.max(np.abs(measures["toe"])) < CLOSED
        assert measures["travel"] == pytest.approx(rise, abs=CLOSED)
        inward = arm - np.sqrt(arm**2 - rise**2)
        assert sweep.measures[f"{side}_tyre.contact_y"].values == pytest.approx(-sign * inward, abs=CLOSED)
    height = sweep.measures["tyre.roll_centre_height"].values
    middle = len(height) // 2
    assert height[middle] == pytest.approx(0.0, abs=CLOSED)
    # both lines of a side are parallel to its arms, at their slope
    slope = -rise / np.sqrt(arm**2 - rise**2)
    assert height == pytest.approx(slope * (HALF_TRACK - arm + np.sqrt(arm**2 - rise**2)), abs=1e-8)


def meet(first: tuple[Point, Point], second: tuple[Point, Point]) -> np.ndarray:
    """Where two lines through pairs of points meet."""
    (p, q), (r, s) = (np.array(line) for line in (first, second))
    t, _ = np.linalg.solve(np.column_stack([q - p, r - s]), r - p)
    return np.asarray(p + t * (q - p))


def test_the_roll_centre_of_a_trapezium_lies_on_the_line_to_its_instant_centre() -> None:
    lower, upper = ((0.3, 0.22), (0.7, 0.18)), ((0.4, 0.44), (0.66, 0.48))
    sweep = eom.kinematic_sweep(wishbones(lower, upper), {"left_lift": (-0.05, 0.05), "right_lift": (-0.05, 0.05)},
                                hold=["chassis"], points=5)  # fmt: skip
    pole = meet(lower, upper)
    centre = meet(((HALF_TRACK, 0.0), (float(pole[0]), float(pole[1]))), ((0.0, 0.0), (0.0, 1.0)))
    assert sweep.measures["tyre.roll_centre_height"].values[2] == pytest.approx(centre[1], abs=CLOSED)
    assert sweep.measures["tyre.roll_centre_y"].values == pytest.approx(np.zeros(5), abs=CLOSED)
    # camber per travel is one over the horizontal distance to the instant centre; positive leans outward
    omega = sweep.motions[2, sweep.vehicle.draft.index["left_upright"], 3]
    assert omega == pytest.approx(0.1 / (HALF_TRACK - pole[0]), rel=1e-12)


def test_unequal_travel_gives_the_roll_centre_where_both_sides_lines_meet() -> None:
    lower, upper = ((0.3, 0.22), (0.7, 0.18)), ((0.4, 0.44), (0.66, 0.48))
    sweep = eom.kinematic_sweep(
        wishbones(lower, upper), {"left_lift": (-0.06, 0.06), "right_lift": (0.06, -0.06)}, hold=["chassis"], points=3
    )
    # contact points and instant centres at the last position, from the positions of the arms' ends
    lines = []
    for side, sign in (("left", 1.0), ("right", -1.0)):
        ends = []
        for name, (inner, _) in ((f"{side}_lower", lower), (f"{side}_upper", upper)):
            outer = sweep.positions[-1, sweep.vehicle.draft.index[name], 1:]
            ends.append(((sign * inner[0], inner[1]), (float(outer[0]), float(outer[1]))))
        pole = meet(ends[0], ends[1])
        n = sweep.rotations[-1, sweep.vehicle.draft.index[f"{side}_upright"]] @ [0.0, 1.0, 0.0]
        upright = sweep.positions[-1, sweep.vehicle.draft.index[f"{side}_upright"], 1:]
        R = sweep.rotations[-1, sweep.vehicle.draft.index[f"{side}_upright"]][1:, 1:]
        hub = upright + R @ (np.array([sign * HALF_TRACK, RADIUS]) - [sign * 0.75, 0.3])
        contact = hub - RADIUS * np.array([-n[2], n[1]])
        # the contact point's own path: the lowest point shifts on the disc, the hub turns about the pole
        turn = np.array([-(hub - pole)[1], (hub - pole)[0]])
        own = turn - RADIUS * np.array([-n[1], -n[2]])
        lines.append((contact, np.array([own[1], -own[0]])))
    (c1, u1), (c2, u2) = lines
    t, _ = np.linalg.solve(np.column_stack([u1, -u2]), c2 - c1)
    y, z = c1 + t * u1
    ground = c1[1] + (c2[1] - c1[1]) * (y - c1[0]) / (c2[0] - c1[0])
    assert sweep.measures["tyre.roll_centre_y"].values[-1] == pytest.approx(y, abs=1e-8)
    assert sweep.measures["tyre.roll_centre_height"].values[-1] == pytest.approx(z - ground, abs=1e-8)


def test_a_strut_leans_as_its_top_mount_and_the_end_of_its_arm_say() -> None:
    inner, outer, top = (0.36, 0.22), (0.7, 0.19), (0.56, 0.8)
    sweep = eom.kinematic_sweep(strut(inner, outer, top), {"left_lift": (-0.08, 0.08), "right_lift": (-0.08, 0.08)},
                                hold=["chassis"], points=17)  # fmt: skip
    arm = sweep.rotations[:, sweep.vehicle.draft.index["left_arm"]]
    raised = np.arctan2(arm[:, 2, 1], arm[:, 1, 1])
    a, b = np.subtract(outer, inner)
    ball = np.column_stack(
        [
            inner[0] + a * np.cos(raised) - b * np.sin(raised),
            inner[1] + a * np.sin(raised) + b * np.cos(raised),
        ]
    )
    lean = np.arctan2(*(np.subtract(top, ball)).T) - np.arctan2(*np.subtract(top, outer))
    assert sweep.measures["left_tyre.camber"].values == pytest.approx(lean, abs=CLOSED)
    assert sweep.measures["right_tyre.camber"].values == pytest.approx(lean, abs=CLOSED)
    # instant centre at the drawing: normal to the strut at its top, and the arm
    d = np.subtract(top, outer)
    pole = meet((inner, outer), (top, (top[0] + d[1], top[1] - d[0])))
    centre = meet(((HALF_TRACK, 0.0), (float(pole[0]), float(pole[1]))), ((0.0, 0.0), (0.0, 1.0)))
    assert sweep.measures["tyre.roll_centre_height"].values[8] == pytest.approx(centre[1], abs=CLOSED)
