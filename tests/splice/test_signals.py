"""Outputs and limits at any heading, forwards and backwards, against kinematics by hand."""

import numpy as np
import pytest

import eom
from tests.splice.b_train import B_TRAIN
from tests.vehicles.shipped import FOLDER

AXES = {"x": "[1, 0, 0]", "y": "[0, 1, 0]"}
SENSORS = "\nsensors:\n" + "".join(
    f"  {measure}_{name}: {{body: tractor_frame, at: [-6.384, 0, 1.019], along: {axis}, measure: {measure}}}\n"
    for measure in ("position", "velocity", "acceleration")
    for name, axis in AXES.items()
)
BEHIND = 5.0
"""The sensors' distance behind the tractor's sprung mass centre [m]."""


def b_train(file: str = B_TRAIN) -> eom.TyreModel:
    """A B-train."""
    model = eom.build(eom.loads(file, str(FOLDER / "b_train.yaml"), U="110 km/h", f_r=0.0))
    assert isinstance(model, eom.TyreModel)
    return model


def momentum_change(model: eom.TyreModel, x: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Change of the whole momentum along the lead body's axes less the wheels' forces, (2,) [N]."""
    found = model.evaluated(x, u)
    yaw = found.motion.displaced[5::6][[wheel.body for wheel in model.prepared.system.wheels]]
    x_forces, y_forces = found.balance.body_forces[:2]
    wheels = [x_forces * np.cos(yaw) - y_forces * np.sin(yaw), x_forces * np.sin(yaw) + y_forces * np.cos(yaw)]
    mass = model.prepared.model.body.mass
    return np.array([mass @ found.balance.dw[k::6] - np.sum(wheels[k]) for k in (0, 1)])


def told(model: eom.TyreModel, x: np.ndarray, u: np.ndarray) -> dict[str, float]:
    """Outputs by name."""
    return dict(zip(model.outputs, map(float, model.output(0.0, x, u)), strict=True))


@pytest.mark.parametrize("heading", [0.0, 0.5 * np.pi, -2.3])
def test_a_sensor_behind_the_centre_moves_as_its_point_at_any_heading(heading: float) -> None:
    """Place, velocity and acceleration of a point of a body that turns in the plane; to rounding."""
    model = b_train(B_TRAIN + SENSORS)
    x, u = model.trim()
    at = {name: k for k, name in enumerate(model.states)}
    x[at["tractor_frame.x"]], x[at["tractor_frame.y"]], x[at["tractor_frame.yaw"]] = 100.0, -20.0, heading
    yaw_rate, v_x, v_y = 0.2, 29.0, 0.7
    x[at["tractor_frame.yaw_rate"]], x[at["tractor_frame.v_x"]], x[at["tractor_frame.v_y"]] = yaw_rate, v_x, v_y
    y, rates = told(model, x, u), model.rhs(0.0, x, u)
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    place = np.array([100.0, -20.0]) + turn @ [-BEHIND, 0.0] - [-BEHIND, 0.0]
    velocity = turn @ [v_x, v_y - BEHIND * yaw_rate]
    change = [rates[at[f"tractor_frame.{name}"]] for name in ("v_x", "v_y", "yaw_rate")]
    acceleration = np.array(
        [change[0] - v_y * yaw_rate + BEHIND * yaw_rate**2, change[1] + v_x * yaw_rate - BEHIND * change[2]]
    )
    for measure, wanted in (("position", place), ("velocity", velocity), ("acceleration", acceleration)):
        found = [y[f"{measure}_{name}"] for name in AXES]
        np.testing.assert_allclose(found, wanted, atol=1e-9)


def test_sideslip_and_slip_angles_have_one_sign_in_reverse_and_stay_finite_at_rest() -> None:
    model = b_train()
    x, u = model.trim()
    at = {name: k for k, name in enumerate(model.states)}
    for v_x in (-5.0, 0.0, 5.0):
        x[at["tractor_frame.v_x"]], x[at["tractor_frame.v_y"]] = v_x, 0.3
        y = told(model, x, u)
        assert np.all(np.isfinite(list(y.values())))
        assert y["tractor.sideslip"] > 0.0
        assert y["axle_2.left.alpha"] > 0.0


@pytest.mark.parametrize("v_x", [-5.0, 5.0])
def test_a_wheel_locks_when_it_slides_and_not_when_it_rolls_either_way(v_x: float) -> None:
    model = b_train()
    x, u = model.trim()
    spins = [k for k, name in enumerate(model.states) if name.endswith(".spin")]
    x[model.states.index("tractor_frame.v_x")] = v_x
    x[spins] = v_x / 0.51
    assert not [limit for limit in model.reached(x, u) if limit.kind == "lock"]
    x[spins] = 0.0
    assert len([limit for limit in model.reached(x, u) if limit.kind == "lock"]) == len(spins)


def test_margins_are_continuous_through_straight_running_and_standstill() -> None:
    model = b_train()
    x, u = model.trim()
    at = {name: k for k, name in enumerate(model.states)}
    spins = [k for k, name in enumerate(model.states) if name.endswith(".spin")]
    x[at["semitrailer_1_frame.yaw_rate"]] = 0.6
    x[spins] = 0.0
    for name, values in (
        ("semitrailer_1_frame.yaw_from_tractor_frame", (-1e-9, 0.0, 1e-9)),
        ("tractor_frame.v_x", (1.0 - 1e-9, 1.0, 1.0 + 1e-9)),
        ("tractor_frame.v_x", (-1e-9, 0.0, 1e-9)),
    ):
        around = []
        for value in values:
            x[at[name]] = value
            around.append(model.margins(x, u))
        # loads change by some MN per rad and m/s
        assert np.max(np.abs(np.diff(around, axis=0))) < 1e-2


def test_load_transfer_is_left_less_right_over_both() -> None:
    """Load transfer is left less right over both; a positive roll loads the right."""
    model = b_train()
    x, u = model.trim()
    roll = model.states.index("semitrailer_1_axles.roll")
    x[roll] = 0.004
    y = told(model, x, u)
    loads = y["axle_4.left.Fz"], y["axle_4.right.Fz"]
    assert y["axle_4.ltr"] == pytest.approx((loads[0] - loads[1]) / sum(loads), rel=1e-12)
    assert y["axle_4.ltr"] < 0.0


@pytest.mark.parametrize("angle", [0.05, 0.1, 0.17])
def test_a_force_input_turns_with_its_body(angle: float) -> None:
    """A push along a towed unit has its part across the lead.

    Of the change of momentum, what the wheels' forces changed with their loads is taken off; to rounding of some MN.
    """
    push = "\nactuators:\n  push: {body: semitrailer_2_frame, along: [1, 0, 0]}\n"
    model = b_train(B_TRAIN + push)
    x, u = model.trim()
    x[model.states.index("semitrailer_2_frame.yaw_from_tractor_frame")] = angle
    at = model.inputs.index("push")
    sums = []
    for force in (0.0, 1000.0):
        u[at] = force
        sums.append(momentum_change(model, x, u))
    pushed = np.subtract(sums[1], sums[0])
    np.testing.assert_allclose(pushed, [1000.0 * np.cos(angle), 1000.0 * np.sin(angle)], atol=1e-5)
