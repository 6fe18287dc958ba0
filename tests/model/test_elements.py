"""Elements of the description against closed forms."""

import control
import numpy as np
import pytest

import eom
from tests.model.test_checks import CAR
from tests.vehicles.shipped import text, vehicle

m, I_zz, a, b, C, U = 1500.0, 2200.0, 1.2, 1.4, 80e3, 20.0


def single_track(trail: float) -> tuple[np.ndarray, np.ndarray]:
    """A and B of the textbook single-track car in (v_y, r), each tyre's side force acting *trail* behind its axle.

    Newton and Euler: m (dv/dt + U r) = F1 + F2, I dr/dt = (a - trail) F1 - (b + trail) F2 with slip measured at the
    axle: F1 = -C ((v + a r)/U - steer), F2 = -C (v - b r)/U.
    """
    slips = np.array([[1.0, a], [1.0, -b]]) / U
    forces = -C * slips
    arms = np.array([a - trail, -(b + trail)])
    A = np.array([forces.sum(axis=0) / m, arms @ forces / I_zz]) - np.array([[0.0, U], [0.0, 0.0]])
    return A, np.array([C / m, arms[0] * C / I_zz])


@pytest.mark.parametrize("trail", [0.0, 0.06])
def test_a_car_on_tyres_is_the_single_track_model(trail: float) -> None:
    file = CAR.replace("trim: {speed: U}", "trim: {speed: U, hold: true}")
    if trail:
        file = file.replace("cornering: 80 kN/rad", f"cornering: 80 kN/rad, trail: {trail}")
    model = eom.linearise(eom.loads(file)).without_cyclic()
    A, B = single_track(trail)
    assert model.states == ("frame.v_y", "frame.yaw_rate")
    # the same few operations in another order
    np.testing.assert_allclose(model.A, A, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(model.B[:, 0], B, rtol=1e-13)


def test_stiffness_per_wheel_counts_the_wheels() -> None:
    per_wheel = CAR.replace("per: axle, cornering: 80 kN/rad", "per: wheel, cornering: 40 kN/rad")
    np.testing.assert_array_equal(eom.assemble(eom.loads(per_wheel)).C, eom.assemble(eom.loads(CAR)).C)
    one_wheel = CAR.replace("steered: true}", "steered: true, wheels: 1}")
    halved = eom.assemble(eom.loads(one_wheel)).matrices.D_slip
    assert halved[0, 0] == pytest.approx(halved[1, 1] / 2)


def test_a_slip_damper_of_c_over_u_is_a_tyre() -> None:
    file = CAR.replace(
        "rear: {type: tyre, body: frame, at: [-1.4, 0, 0], tyre: tyre}",
        "rear: {type: slip_damper, body: frame, at: [-1.4, 0, 0], axis: [0, 1, 0], damping: 80000/U}",
    )
    np.testing.assert_array_equal(eom.assemble(eom.loads(file)).C, eom.assemble(eom.loads(CAR)).C)


def test_slip_feedthrough_makes_a_slip_angle_of_a_velocity() -> None:
    file = CAR + (
        "sensors:\n  slip: {body: frame, at: [1.2, 0, 0], along: [0, 1, 0], measure: velocity, frame: body, gain: 1/U, "
        "feedthrough: {front.steer: -1}, unit: rad}\n"
    )
    model = eom.linearise(eom.loads(file)).without_cyclic()
    row, column = model.outputs.index("slip"), model.inputs.index("front.steer")
    v, r = model.states.index("frame.v_y"), model.states.index("frame.yaw_rate")
    assert model.C[row, [v, r]] == pytest.approx([1 / U, a / U])
    assert model.D[row, column] == -1.0


def test_sensor_of_a_units_whole_mass_centre_is_the_mean_of_its_bodies() -> None:
    file = text("b_train_yaw_roll") + (
        "sensors:\n"
        "  centre: {centre_of: tractor, along: [0, 1, 0], measure: acceleration}\n"
        "  frame: {body: tractor_frame, along: [0, 1, 0], measure: acceleration}\n"
        "  axles: {body: tractor_axles, along: [0, 1, 0], measure: acceleration}\n"
    )
    model = eom.linearise(eom.loads(file))
    row = {name: model.C[model.outputs.index(name)] for name in ("centre", "frame", "axles", "tractor.ay")}
    np.testing.assert_allclose(row["centre"], (6308 * row["frame"] + 1950 * row["axles"]) / 8258, rtol=1e-12, atol=1e-9)
    np.testing.assert_array_equal(row["centre"], row["tractor.ay"])


def test_inertial_and_body_acceleration_differ_by_the_centripetal_one() -> None:
    file = CAR + (
        "sensors:\n"
        "  inertial: {body: frame, along: [0, 1, 0], measure: acceleration}\n"
        "  body: {body: frame, along: [0, 1, 0], measure: acceleration, frame: body}\n"
    )
    model = eom.linearise(eom.loads(file)).without_cyclic()
    difference = model.C[model.outputs.index("inertial")] - model.C[model.outputs.index("body")]
    expected = np.where([name == "frame.yaw_rate" for name in model.states], U, 0.0)
    np.testing.assert_allclose(difference, expected, atol=1e-12)


def test_frequency_response_and_poles_are_those_of_python_control() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll")).without_cyclic()
    other = model.to_control()
    frequency = np.array([0.1, 0.4, 2.0])
    theirs = other(2j * np.pi * frequency)
    ours = np.moveaxis(model.frequency_response(frequency), 0, -1)
    scale = np.max(np.abs(theirs), axis=(1, 2), keepdims=True)
    # two solvers for the same 18 equations
    assert np.max(np.abs(ours - theirs) / scale) < 1e-10
    assert isinstance(other, control.StateSpace)
    np.testing.assert_allclose(np.sort(other.poles().real), np.sort(model.modes().eigenvalues.real), rtol=1e-9)


def test_damping_ratio_frequency_and_time_constant_are_those_of_the_closed_form() -> None:
    file = """
name: oscillator
bodies: {mass: {mass: 2, at: [0, 0, 0]}}
connectors:
  guide: {type: rigid_point, between: [mass, ground], at: [0, 0, 0], forces: 2, moments: 3, axis: [1, 0, 0]}
  spring: {type: spring, between: [mass, ground], ends: [[0, 0, 0], [1, 0, 0]], stiffness: 50, damping: 4}
"""
    modes = eom.linearise(eom.loads(file)).modes()
    assert modes.natural_frequency[0] == pytest.approx(5.0 / (2 * np.pi))
    assert modes.damping_ratio[0] == pytest.approx(4.0 / (2 * np.sqrt(50.0 * 2.0)))
    assert modes.time_constant[0] == pytest.approx(1.0)
    np.testing.assert_allclose(modes.participation.sum(axis=0), 1.0)


def test_a_whole_mass_centre_relative_to_a_body_knows_no_absolute_heading() -> None:
    file = text("b_train_yaw_plane") + (
        "sensors:\n"
        "  centre: {centre_of: semitrailer_1, relative_to: tractor_frame, along: [0, 1, 0], measure: position}\n"
        "  body: {body: semitrailer_1_frame, relative_to: tractor_frame, along: [0, 1, 0], measure: position}\n"
    )
    model = eom.linearise(eom.loads(file))
    centre, same = (model.C[model.outputs.index(name)] for name in ("centre", "body"))
    np.testing.assert_array_equal(centre, same)
    np.testing.assert_array_equal(centre[list(model.cyclic)], 0.0)
