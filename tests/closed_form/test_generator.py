"""Law 3: the generated matrices are the hand-derived ones, after the change of variables that this file writes down.

The generated model is in ISO 8855 axes (y left, z up). Its states z are displacements and velocities of bodies. The
hand-derived model is in SAE axes (y right, z down). Its states x are sideslip angles, yaw rates and roll angles. With a
map x = T z, and inputs u_SAE = S u_ISO, both say the same if for every z and u

    T (A z + B u) = A_x T z + B_x S u.

T has a column for every state of the generated model. Those of its cyclic states, the train's place and heading, are
zero: nothing depends on them, and the thesis has no such states. The rest of T is square and regular, so that nothing
of the generated model is lost either.
"""

from typing import Any, NamedTuple

import numpy as np
import pytest

import eom
from eom.closed_form import StateSpace, axes, b_train_yaw_plane, b_train_yaw_roll
from eom.closed_form import tractor_semitrailer as short_train
from tests.closed_form import same_vehicle
from tests.closed_form.same_vehicle import SETS
from tests.vehicles.shipped import vehicle

Array = np.ndarray
SPEEDS = (10.0, 60.0, 110.0)  # km/h
UNITS = {1: "tractor", 2: "semitrailer_1", 3: "semitrailer_2"}
ROUNDING = 1e-10
"""Law 3's tolerance. Both sides are a few solves in double precision with condition numbers up to some 1e4."""


class Case(NamedTuple):
    """A hand-derived model beside the generated one, both of the same vehicle."""

    hand: StateSpace
    generated: eom.LinearModel
    T: Array


# The change of states. In SAE axes all of it but roll has the other sign.


def displacement(model: eom.LinearModel, body: str, quantity: str) -> Array:
    """A displacement of a body by the generated states, such as ``y`` or ``roll``; ISO axes."""
    place = ("x", "y", "z", "roll", "pitch", "yaw").index(quantity)
    return np.asarray(model.motion[6 * model.bodies.index(body) + place])


def rate(model: eom.LinearModel, row: Array) -> Array:
    """The rate of a displacement by the generated states: displacements hang on states whose rates have no input."""
    assert not np.any(row @ model.B)
    return np.asarray(row @ model.A)


def lateral_velocity(model: eom.LinearModel, body: str, ahead: float, above: float) -> Array:
    """Velocity of a point to the left, in axes that yaw with the body: the rate of its place less U times the yaw.

    The point is *ahead* and *above* of the body's mass centre. This is where the train's heading drops out.
    """
    y, roll, yaw = (displacement(model, body, quantity) for quantity in ("y", "roll", "yaw"))
    return rate(model, y + ahead * yaw - above * roll) - model.speed * yaw


def unit_states(model: eom.LinearModel, frame: str, number: int, ahead: float = 0.0, above: float = 0.0) -> Any:
    """The thesis's sideslip and yaw rate of a unit by the generated states, with the signs of SAE axes.

    Sideslip is that of the point *ahead* and *above* of the mass centre of the body called *frame*.
    """
    return {
        f"beta_{number}": -lateral_velocity(model, frame, ahead, above) / model.speed,
        f"psi_dot_{number}": -rate(model, displacement(model, frame, "yaw")),
    }


def roll_states(model: eom.LinearModel, unit: str, number: int) -> Any:
    """Roll angles and rates of both bodies of a unit by the generated states: the same in both axes."""
    sprung, unsprung = (displacement(model, f"{unit}_{body}", "roll") for body in ("frame", "axles"))
    return {
        f"phi_{number}": sprung,
        f"phi_dot_{number}": rate(model, sprung),
        f"phi_t_{number}": unsprung,
        f"phi_t_dot_{number}": rate(model, unsprung),
    }


def short_case(number: int, speed: float) -> Case:
    """The tractor and semitrailer: psi_dot_1, Delta_psi_dot, beta_1, Delta_psi."""
    p = same_vehicle.tractor_semitrailer(number)
    values = same_vehicle.tractor_semitrailer_values(p)
    model = eom.linearise(vehicle("tractor_semitrailer_yaw_plane").with_values(U=speed, **values))
    articulation = displacement(model, "semitrailer_frame", "yaw") - displacement(model, "tractor_frame", "yaw")
    rows = unit_states(model, "tractor_frame", 1) | {
        "Delta_psi": -articulation,
        "Delta_psi_dot": -rate(model, articulation),
    }
    hand = short_train.state_space(p, speed)
    return Case(hand, model, np.array([rows[name] for name in hand.states]))


def plane_case(number: int, speed: float) -> Case:
    """The B-train in the plane: beta and psi_dot of each unit. A frame's mass centre is that of the unit."""
    p = same_vehicle.yaw_plane(number)
    model = eom.linearise(vehicle("b_train_yaw_plane").with_values(U=speed, **same_vehicle.yaw_plane_values(p)))
    rows: dict[str, Array] = {}
    for i, unit in UNITS.items():
        rows |= unit_states(model, f"{unit}_frame", i)
    hand = b_train_yaw_plane.state_space(p, speed)
    return Case(hand, model, np.array([rows[name] for name in hand.states]))


def roll_case(number: int, speed: float) -> Case:
    """The B-train with roll. Sideslip is that of the roll axis below the whole-mass centre.

    That point is behind the frame's mass centre, as the axles draw the common centre to the rear, and below it.
    """
    p = same_vehicle.yaw_roll(number)
    model = eom.linearise(vehicle("b_train_yaw_roll").with_values(U=speed, **same_vehicle.yaw_roll_values(p)))
    ahead = {1: p.a11s - p.a11, 2: p.a2s - p.l_c21, 3: p.a3s - p.l_c3}
    above = {1: p.h_r1 - p.h_s1, 2: p.h_r2 - p.h_s2, 3: p.h_r3 - p.h_s3}
    rows: dict[str, Array] = {}
    for i, unit in UNITS.items():
        rows |= unit_states(model, f"{unit}_frame", i, ahead[i], above[i]) | roll_states(model, unit, i)
    hand = b_train_yaw_roll.state_space(p, speed, "full")
    return Case(hand, model, np.array([rows[name] for name in hand.states]))


CASES = {"tractor_semitrailer": short_case, "b_train_yaw_plane": plane_case, "b_train_yaw_roll": roll_case}
every_case = pytest.mark.parametrize(
    ("name", "number", "kmh"), [(name, number, kmh) for name in CASES for number in SETS for kmh in SPEEDS]
)

# The change of inputs: hand-derived name, generated name. Axles are numbered from the front of the train in both.

STEER_OF_THE_SHORT_TRAIN = {"delta_1f": "axle_1.steer", "delta_2": "axle_2.steer", "delta_3": "axle_3.steer"}
STEER = {"delta_11": "axle_1.steer"} | {f"delta_{k}": f"axle_{k}.steer" for k in range(4, 10)}
YAW_MOMENTS = {"M_z_2": "semitrailer_1.yaw_moment", "M_z_3": "semitrailer_2.yaw_moment"}
ROLL_MOMENTS = {
    # two moments of the thesis act on the same pair of bodies
    "M_x_1f": "tractor.roll_moment",
    "M_x_1r": "tractor.roll_moment",
    "M_x_2": "semitrailer_1.roll_moment",
    "M_x_3": "semitrailer_2.roll_moment",
}
INPUTS = STEER_OF_THE_SHORT_TRAIN | STEER | YAW_MOMENTS | ROLL_MOMENTS


def generated_inputs(case: Case, matrix: Array) -> Array:
    """The columns of a generated B or D that the hand-derived model has, in its order and in SAE signs."""
    columns = [case.generated.inputs.index(INPUTS[name]) for name in case.hand.inputs]
    return np.asarray(matrix[:, columns] * axes.signs(case.hand.inputs))


def comparable(case: Case, matrix: Array) -> Array:
    """Columns by 1 rad of steer and by 1e6 N m of moment, which do about the same."""
    return np.asarray(matrix * [1.0 if name.startswith("delta") else 1e6 for name in case.hand.inputs])


def assert_same(got: Array, expected: Array) -> None:
    """Equal to law 3's tolerance, relative to each row's largest entry; a row of zeros, to the matrix's."""
    size = np.abs(expected)
    scale = np.maximum(np.max(size, axis=1, keepdims=True), 1e-6 * np.max(size))
    wrong = np.argwhere(np.abs(got - expected) > ROUNDING * scale)
    assert not wrong.size, [(place, got[tuple(place)], expected[tuple(place)]) for place in wrong]


@every_case
def test_the_states_of_both_say_the_same(name: str, number: int, kmh: float) -> None:
    case = CASES[name](number, kmh / 3.6)
    kept = np.setdiff1d(np.arange(case.T.shape[1]), case.generated.cyclic)
    # place and heading of the whole train change no state of the thesis
    np.testing.assert_allclose(case.T[:, list(case.generated.cyclic)], 0.0, atol=1e-12)
    assert case.T[:, kept].shape == (len(kept), len(kept))
    assert np.linalg.matrix_rank(case.T[:, kept]) == len(kept)


@every_case
def test_the_generated_a_and_b_are_the_hand_derived_ones(name: str, number: int, kmh: float) -> None:
    hand, generated, T = case = CASES[name](number, kmh / 3.6)
    assert_same(T @ generated.A, hand.A @ T)
    assert_same(comparable(case, generated_inputs(case, T @ generated.B)), comparable(case, hand.B))


# The change of outputs: each generated output by the hand-derived model, in SAE signs.


def pick(case: Case, *names: str) -> Array:
    """Rows that pick states of the hand-derived model."""
    return np.eye(len(case.hand.states))[[case.hand.states.index(name) for name in names]]


def generated_outputs(case: Case, names: list[str], sign: float) -> tuple[Array, Array]:
    """Rows of the generated C and D, in SAE signs."""
    rows = [case.generated.outputs.index(name) for name in names]
    return sign * case.generated.C[rows], sign * generated_inputs(case, case.generated.D[rows])


def assert_same_outputs(case: Case, names: list[str], sign: float, by_state: Array) -> None:
    """The generated outputs are by_state x of the hand-derived model, and nothing of the inputs."""
    C, D = generated_outputs(case, names, sign)
    assert_same(C, by_state @ case.T)
    assert not np.any(D)


def unit_outputs(case: Case, quantity: str) -> list[str]:
    """Names of a generated output of every unit, front to rear."""
    return [name for name in case.generated.outputs if name.endswith(quantity) and not name.startswith("axle")]


@every_case
def test_the_generated_accelerations_are_the_hand_derived_outputs(name: str, number: int, kmh: float) -> None:
    case = CASES[name](number, kmh / 3.6)
    C, D = generated_outputs(case, unit_outputs(case, ".ay"), -1.0)
    # with roll, accelerations of the whole-mass centres are outputs beside those of the roll axes
    kind = "a_y_cg" if name == "b_train_yaw_roll" else "a_y"
    rows = [k for k, output in enumerate(case.hand.outputs) if output.rpartition("_")[0] == kind]
    assert len(rows) == len(C)
    assert_same(C, case.hand.C[rows] @ case.T)
    assert_same(comparable(case, D), comparable(case, case.hand.D[rows]))


@every_case
def test_the_acceleration_at_the_front_axle_is_the_first_output_and_a11_times_the_yaw_acceleration(
    name: str, number: int, kmh: float
) -> None:
    # with roll, both are on the roll axis: this compares the acceleration that the thesis gives, at its own point
    case = CASES[name](number, kmh / 3.6)
    a11 = -float(case.generated.centres[case.generated.bodies.index("tractor_frame"), 0])
    if name == "b_train_yaw_roll":
        a11 = same_vehicle.yaw_roll(number).a11
    C, D = generated_outputs(case, ["axle_1.ay"], -1.0)
    first, yaw = case.hand.outputs.index("a_y_1"), case.hand.states.index("psi_dot_1")
    assert_same(C, (case.hand.C[[first]] + a11 * case.hand.A[[yaw]]) @ case.T)
    assert_same(comparable(case, D), comparable(case, case.hand.D[[first]] + a11 * case.hand.B[[yaw]]))


@every_case
def test_the_generated_yaw_rates_are_states(name: str, number: int, kmh: float) -> None:
    case = CASES[name](number, kmh / 3.6)
    if name == "tractor_semitrailer":
        by_state = np.array([[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]])
    else:
        by_state = pick(case, "psi_dot_1", "psi_dot_2", "psi_dot_3")
    assert_same_outputs(case, unit_outputs(case, ".yaw_rate"), -1.0, by_state)


@every_case
def test_the_generated_articulations_are_the_gaps_that_the_couplings_close(name: str, number: int, kmh: float) -> None:
    case, U = CASES[name](number, kmh / 3.6), kmh / 3.6
    states = pick(case, *case.hand.states)
    by = dict(zip(case.hand.states, states, strict=True))
    if name == "tractor_semitrailer":
        rows = [by["Delta_psi"]]
    else:
        p: Any = same_vehicle.yaw_roll(number) if name == "b_train_yaw_roll" else same_vehicle.yaw_plane(number)
        ahead, behind = (p.l_c1, p.l_c22), (p.l_c21, p.l_c3)
        h = getattr(p, "h_cr1", 0.0)
        rows = []
        for i in (1, 2):
            j = i + 1
            # lateral velocity of the coupling in both units' axes: U beta - l psi_dot + h phi_dot, and U Gamma between
            row = by[f"beta_{i}"] - by[f"beta_{j}"]
            row = row - (ahead[i - 1] * by[f"psi_dot_{i}"] + behind[i - 1] * by[f"psi_dot_{j}"]) / U
            if h:
                row = row + h * (by[f"phi_dot_{i}"] - by[f"phi_dot_{j}"]) / U
            rows.append(row)
    by_state = np.array(rows)
    assert_same_outputs(case, unit_outputs(case, ".articulation"), -1.0, by_state)


@every_case
def test_the_generated_sideslip_is_that_of_the_roll_axis_and_what_rolls_add(name: str, number: int, kmh: float) -> None:
    case, U = CASES[name](number, kmh / 3.6), kmh / 3.6
    by = dict(zip(case.hand.states, pick(case, *case.hand.states), strict=True))
    if name == "tractor_semitrailer":
        short = same_vehicle.tractor_semitrailer(number)
        # (3.3c)
        second = by["beta_1"] - by["Delta_psi"] - (short.l_c1 + short.l_c21) / U * by["psi_dot_1"]
        rows = [by["beta_1"], second - short.l_c21 / U * by["Delta_psi_dot"]]
    else:
        rows = [by[f"beta_{i}"] for i in UNITS]
    if name == "b_train_yaw_roll":
        p: Any = same_vehicle.yaw_roll(number)
        for i in UNITS:
            e_s, e_u = (getattr(p, f"{h}{i}") - getattr(p, f"h_r{i}") for h in ("h_s", "h_u"))
            m_s, m_u, m = (getattr(p, f"{mass}{i}") for mass in ("m_s", "m_u", "m"))
            rows[i - 1] = rows[i - 1] + (m_s * e_s * by[f"phi_dot_{i}"] + m_u * e_u * by[f"phi_t_dot_{i}"]) / (m * U)
    by_state = np.array(rows)
    assert_same_outputs(case, unit_outputs(case, ".sideslip"), -1.0, by_state)


@pytest.mark.parametrize("number", SETS)
@pytest.mark.parametrize("kmh", SPEEDS)
def test_the_generated_roll_angles_are_the_hand_derived_outputs(number: int, kmh: float) -> None:
    case = roll_case(number, kmh / 3.6)
    rolls = [f"{unit}_{body}.roll" for unit in UNITS.values() for body in ("frame", "axles")]
    by_state = pick(case, *(name for name in case.hand.outputs if name.startswith("phi")))
    assert_same_outputs(case, rolls, 1.0, by_state)


def test_no_generated_output_is_left_out() -> None:
    for name, case in CASES.items():
        compared = (".ay", ".yaw_rate", ".articulation", ".sideslip", ".roll")
        assert all(output.endswith(compared) for output in case(0, 20.0).generated.outputs), name


def test_the_generated_model_is_not_the_thesis_variant() -> None:
    # the thesis drops terms of its own equations: its dominant root is 0.3 % away from the generated one's at 110 km/h
    case = roll_case(0, 110.0 / 3.6)
    thesis = b_train_yaw_roll.state_space(same_vehicle.yaw_roll(0), 110.0 / 3.6, "thesis")
    slowest = [values[np.argmax(values.real + 1e-6 * values.imag)] for values in (
        np.linalg.eigvals(case.generated.without_cyclic().A), np.linalg.eigvals(thesis.A)
    )]  # fmt: skip
    assert 0.0025 < abs(slowest[1] - slowest[0]) / abs(slowest[0]) < 0.0035
