"""The straight run: what balances what, at any speed."""

import numpy as np
import pytest

import eom
from eom.model.tyre import tyre_slopes
from eom.splice.closure import close
from eom.splice.trim import loads_at_rest
from tests.splice.b_train import B_TRAIN
from tests.vehicles.shipped import FOLDER, vehicle

G = 9.8
MASS = 8258.0 + 2 * 17997.0
RADIUS = 0.51
AIR = """      air: {type: drag, body: frame, at: [-1.0, 0, 1.6], area: 9 m^2, coefficient: 0.7, density: 1.2 kg/m^3}
"""


def b_train(file: str = B_TRAIN, **values: float | str) -> eom.TyreModel:
    """The B-train of a text."""
    model = eom.build(eom.loads(file, str(FOLDER / "b_train.yaml"), **values))
    assert isinstance(model, eom.TyreModel)
    return model


def test_loads_at_rest_are_those_of_levers() -> None:
    """To a tenth of a newton: front 52 219.3, tandem 91 677.9, tridems 182 830.5 and 106 941.9, by levers alone."""
    model = b_train()
    loads = loads_at_rest(model.prepared.system, model.prepared.pivots).reshape(-1, 2).sum(axis=1)
    groups = [loads[0], loads[1:3].sum(), loads[3:6].sum(), loads[6:].sum()]
    np.testing.assert_allclose(groups, [52219.3, 91677.9, 182830.5, 106941.9], atol=0.05)
    # levers: semitrailer 2 on kingpin and tridem, semitrailer 1 with that kingpin's load, tractor with the first one's
    x_s, x_a, m_s, m_a = 6.385, 11.49720, 15927.0, 2070.0
    moment = G * (m_s * x_s + m_a * x_a)
    last = moment / 11.5
    hitch_2 = G * (m_s + m_a) - last
    first = (moment + 12.57 * hitch_2) / 11.5
    np.testing.assert_allclose([last, first], groups[:1:-1], rtol=1e-12)


def test_loads_without_the_lever_of_the_second_hitch_are_the_thesis_ones() -> None:
    """29 395.1 N per dual pair of the first tridem, which then carries all of the second hitch's load."""
    model = b_train(B_TRAIN, **{"fifth_wheel_2.at.semitrailer_1.x": -11.5})
    loads = loads_at_rest(model.prepared.system, model.prepared.pivots)
    np.testing.assert_allclose(loads[6:12], 29395.1, atol=0.05)


@pytest.mark.parametrize("kmh", [5, 60, 88, 110, 120])
def test_drive_torque_balances_rolling_resistance_drag_and_grade(kmh: float) -> None:
    """Rolling resistance and grade are per weight, drag grows with the square of the speed; moments are per radius.

    Loads add up to the weight: the grade is a force along the road, without its second-order loss of load.
    """
    file = B_TRAIN.replace("trim: {speed: U}", "trim: {speed: U, grade: 0.015}").replace(
        "    axle_groups:\n      front: {body: axles",
        f"    connectors:\n{AIR}    axle_groups:\n      front: {{body: axles",
    )
    model = b_train(file, U=f"{kmh} km/h")
    U = kmh / 3.6
    drag = 0.5 * 1.2 * 9.0 * 0.7 * U**2
    trim = model.prepared.trim
    # below 1 m/s resistance fades, here it is whole
    assert trim.torque == pytest.approx(RADIUS * (0.02 * MASS * G + 0.015 * MASS * G + drag), rel=1e-9)
    assert np.sum(trim.load) == pytest.approx(MASS * G, rel=1e-12)
    x, u = model.trim()
    assert np.max(np.abs(model.rhs(0.0, x, u)[3:])) < 1e-9


@pytest.mark.parametrize(
    "name", ["b_train", "car", "tractor_semitrailer", "a_train_double", "b_train_yaw_plane_nonlinear"]
)
@pytest.mark.parametrize("kmh", [20, 60, 100])
def test_one_build_runs_straight_at_any_speed(name: str, kmh: float) -> None:
    """Nothing accelerates; what a build at that speed finds is the same but for springs that give way to drag."""
    model = eom.build(vehicle(name))
    assert isinstance(model, eom.TyreModel)
    x, u = model.trim(kmh / 3.6)
    assert np.max(np.abs(model.rhs(0.0, x, u)[3:])) < 1e-9
    assert x[model.states.index(next(name for name in model.states if name.endswith(".v_x")))] == kmh / 3.6
    own = eom.build(vehicle(name, U=f"{kmh} km/h"))
    assert isinstance(own, eom.TyreModel)
    # the car's springs stand some 1e-3 m apart under the drag of two speeds; the others have none
    given_way = 2e-3 if name == "car" else 1e-9
    np.testing.assert_allclose(x, own.trim().x, rtol=given_way, atol=given_way)


def test_a_run_that_asks_more_than_friction_is_refused_by_the_axle() -> None:
    with pytest.raises(eom.EquilibriumError, match=r"axles.drive_1.*more than its tyre can give"):
        eom.build(eom.load(FOLDER / "b_train.yaml", mu=0.05, f_r=0.1))


def test_resistance_without_drive_is_refused_with_what_to_do() -> None:
    with pytest.raises(eom.EquilibriumError, match=r"resist the straight run and nothing drives.*driven: true"):
        eom.build(eom.loads(B_TRAIN.replace("driven: true", "driven: false"), str(FOLDER / "b_train.yaml")))


def test_a_support_that_carries_nothing_is_refused_by_its_axle() -> None:
    """The tractor's frame so far back that its front axle would have to pull."""
    with pytest.raises(eom.EquilibriumError, match=r"b_train.yaml:\d+:\d+: units.tractor.axles.front.*normal load"):
        eom.build(eom.load(FOLDER / "b_train.yaml", **{"tractor_frame.at.x": -12.0}))


def test_a_train_that_leans_stands_on_its_tyres_by_moments() -> None:
    """The tractor's frame 0.1 m to the left: its weight's moment is carried by tyres and the roll springs of hitches.

    Without resistance, which would pull it aside. Loads have the moment of the masses about the plane of symmetry.
    """
    model = b_train(B_TRAIN, f_r=0.0, **{"tractor_frame.at.y": 0.1})
    x, u = model.trim()
    assert np.max(np.abs(model.rhs(0.0, x, u)[3:])) < 1e-9
    load = model.evaluated(x, u).balance.load
    half_tracks = np.array([wheel.place[1] for wheel in model.prepared.system.wheels])
    assert load @ half_tracks == pytest.approx(6308.0 * G * 0.1, rel=1e-9)
    assert load[0] > 1.01 * load[1]
    A, B = tyre_slopes(model, x, u)
    closed = close(model.prepared)
    for found, wanted in ((A, closed.A), (B, closed.B)):
        scale = np.max(np.abs(wanted), axis=1, keepdims=True)
        assert np.max(np.abs(found - wanted) / np.maximum(scale, 1e-9 * np.max(scale))) < 1e-9
