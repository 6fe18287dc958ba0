"""The thesis's vehicles against derivations that share nothing with the generator, and against printed numbers."""

import numpy as np
import pytest

import eom
from tests.referees.train import (
    B_TRAIN,
    B_TRAIN_WHOLE_MASS,
    TRACTOR_SEMITRAILER,
    LinearModel,
    TrainParameters,
    yaw_plane,
    yaw_roll,
)
from tests.vehicles.shipped import TRAINS, text, vehicle

SPEEDS = (30.0, 60.0, 88.0, 110.0, 120.0)  # km/h
FREQUENCIES = np.array([0.05, 0.2, 0.4, 1.0, 3.0])  # Hz


def referee(name: str, speed: float) -> LinearModel:
    """The independent model of a shipped train at a speed in m/s."""
    data: dict[str, TrainParameters] = {
        "tractor_semitrailer_yaw_plane": TRACTOR_SEMITRAILER,
        "b_train_yaw_plane": B_TRAIN_WHOLE_MASS,
        "b_train_yaw_roll": B_TRAIN,
    }
    return (yaw_roll if name == "b_train_yaw_roll" else yaw_plane)(data[name], speed)


def response(model: LinearModel, frequency: float) -> np.ndarray:
    """Transfer functions of the referee at a frequency in Hz."""
    s = 2j * np.pi * frequency
    return np.asarray(model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B) + model.D)


def roots_sorted(A: np.ndarray) -> np.ndarray:
    """Eigenvalues in a fixed order."""
    values = np.linalg.eigvals(A)
    return values[np.lexsort((values.imag, np.round(values.real, 6)))]


@pytest.mark.parametrize("kmh", SPEEDS)
@pytest.mark.parametrize("name", TRAINS)
def test_roots_equal_an_independent_derivation(name: str, kmh: float) -> None:
    own = eom.linearise(vehicle(name, U=kmh / 3.6)).without_cyclic().A
    # two derivations in double precision; the eigenvalues' condition numbers stay below 1e3
    np.testing.assert_allclose(roots_sorted(own), roots_sorted(referee(name, kmh / 3.6).A), rtol=1e-10)


ROLL_NAMES = {f"{unit}_frame.roll": f"{unit}.roll" for unit in ("tractor", "semitrailer_1", "semitrailer_2")} | {
    f"{unit}_axles.roll": f"{unit}.unsprung_roll" for unit in ("tractor", "semitrailer_1", "semitrailer_2")
}


@pytest.mark.parametrize("kmh", [60.0, 110.0])
@pytest.mark.parametrize("name", TRAINS)
def test_every_transfer_function_equals_an_independent_derivation(name: str, kmh: float) -> None:
    model, other = eom.linearise(vehicle(name, U=kmh / 3.6)), referee(name, kmh / 3.6)
    own = model.frequency_response(FREQUENCIES)
    outputs = {ROLL_NAMES.get(output, output): k for k, output in enumerate(model.outputs)}
    inputs = {signal: k for k, signal in enumerate(model.inputs)}
    shared = [signal for signal in other.inputs if signal in inputs]
    measured = [output for output in other.outputs if output in outputs]
    assert len(measured) >= 4
    assert len(shared) >= 3
    for k, frequency in enumerate(FREQUENCIES):
        theirs = response(other, float(frequency))
        for output in measured:
            for signal in shared:
                expected = theirs[other.outputs.index(output), other.inputs.index(signal)]
                got = own[k, outputs[output], inputs[signal]]
                # relative to the output's largest response: a zero of a transfer function has no relative accuracy
                scale = np.max(np.abs(theirs[other.outputs.index(output)]) * input_scale(other.inputs))
                assert abs(got - expected) * input_scale([signal])[0] < 1e-10 * scale, (output, signal)


def input_scale(names: tuple[str, ...] | list[str]) -> np.ndarray:
    """Sizes that make inputs comparable: 1 rad of steer, 1e6 N m of moment."""
    return np.array([1.0 if name.endswith("steer") else 1e6 for name in names])


def test_the_yaw_plane_b_train_has_its_published_roots_at_110_kmh() -> None:
    roots = np.linalg.eigvals(eom.linearise(vehicle("b_train_yaw_plane", U="110 km/h")).without_cyclic().A)
    published = [-3.1012 + 1.4201j, -1.9230 + 2.7864j, -1.3179 + 2.0835j]
    for value in published:
        # four printed decimals
        assert np.min(np.abs(roots - value)) < 0.8e-4


# thesis, Appendix B, at 10 m/s: (unit, Y_beta, N_beta, Y_r, N_r)
DERIVATIVES = (
    ("tractor", -1264400.0, 2208200.0, 220820.0, -1314400.0),
    ("semitrailer_1", -1745700.0, 7902300.0, 790230.0, -3764800.0),
    ("semitrailer_2", -1039500.0, 4705500.0, 470550.0, -2241800.0),
)


@pytest.mark.parametrize(("unit", "Y_beta", "N_beta", "Y_r", "N_r"), DERIVATIVES)
def test_tyre_derivatives_are_those_printed_in_appendix_b(
    unit: str, Y_beta: float, N_beta: float, Y_r: float, N_r: float
) -> None:
    speed = 10.0
    assembly = eom.assemble(vehicle("b_train_yaw_plane", U=speed))
    v, r = (assembly.velocities.index(f"{unit}_frame.{name}") for name in ("v_y", "yaw_rate"))
    force = -assembly.matrices.C_slip
    ours = (speed * force[v, v], speed * force[r, v], force[v, r], force[r, r])
    printed = (Y_beta, N_beta, Y_r, N_r)
    # five printed digits, from places before rounding (3.257 m stands for 3.2566 m)
    np.testing.assert_allclose(ours, printed, rtol=2e-4)


STEER_DERIVATIVES = (
    ("axle_1", "tractor", 424000.0, 847530.0),
    ("axle_4", "semitrailer_1", 581900.0, -1895100.0),
    ("axle_5", "semitrailer_1", 581900.0, -2634100.0),
    ("axle_6", "semitrailer_1", 581900.0, -3373100.0),
    ("axle_7", "semitrailer_2", 346500.0, -1128400.0),
    ("axle_8", "semitrailer_2", 346500.0, -1568500.0),
    ("axle_9", "semitrailer_2", 346500.0, -2008600.0),
)


@pytest.mark.parametrize(("axle", "unit", "Y_delta", "N_delta"), STEER_DERIVATIVES)
def test_steer_derivatives_are_those_printed_in_appendix_b(
    axle: str, unit: str, Y_delta: float, N_delta: float
) -> None:
    assembly = eom.assemble(vehicle("b_train_yaw_plane"))
    column = [item.name for item in assembly.system.inputs].index(f"{axle}.steer")
    F = assembly.matrices.F[:, column]
    lateral, yaw = (assembly.coordinates.index(f"{unit}_frame.{name}") for name in ("y", "yaw"))
    np.testing.assert_allclose([F[lateral], F[yaw]], [Y_delta, N_delta], rtol=2e-4)


@pytest.mark.parametrize("kmh", SPEEDS)
@pytest.mark.parametrize("name", TRAINS)
def test_lateral_acceleration_is_speed_times_yaw_rate_in_a_steady_turn(name: str, kmh: float) -> None:
    car = vehicle(name, U=kmh / 3.6)
    model = eom.linearise(car).without_cyclic()
    gain = model.D - model.C @ np.linalg.solve(model.A, model.B)
    turn = gain[:, model.inputs.index("axle_1.steer")]
    for unit in car.draft.units:
        ay, rate = (turn[model.outputs.index(f"{unit.name}.{name}")] for name in ("ay", "yaw_rate"))
        # rounding of one linear solve
        assert ay == pytest.approx(kmh / 3.6 * rate, rel=1e-11)


def test_every_unit_of_a_held_train_has_the_same_steady_yaw_rate() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll")).without_cyclic()
    turn = (model.D - model.C @ np.linalg.solve(model.A, model.B))[:, 0]
    rates = [turn[model.outputs.index(f"{unit}.yaw_rate")] for unit in ("tractor", "semitrailer_1", "semitrailer_2")]
    np.testing.assert_allclose(rates, rates[0], rtol=1e-11)


def with_axle_supports() -> str:
    """The yaw-roll B-train on vertical supports at its axle groups, its hitches carrying weight."""
    file = text("b_train_yaw_roll")
    lines = [line for line in file.splitlines() if "ride:" not in line and line.strip() != "connectors:"]
    changed = "\n".join(lines).replace("carries: [x, y]", "carries: [x, y, z]")
    for group, x in (("tridem", -11.5), ("front", 0), ("tandem", -5.635)):
        changed = changed.replace(
            f"{group}: {{body: axles,", f"{group}: {{body: axles, support: {{at: [{x}, 0, h_r]}},"
        )
    return changed


def test_loads_of_a_train_on_its_axle_groups_are_those_of_the_levers() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(eom.loads(with_axle_supports())))
    # levers over the hitches by hand; published for this data to 0.1 N
    expected = {
        "tractor_front": 52219.3,
        "tractor_tandem": 91677.9,
        "semitrailer_1_tridem": 182830.5,
        "semitrailer_2_tridem": 106941.9,
    }
    for name, value in expected.items():
        assert loads.supports[name][0][2] == pytest.approx(value, abs=0.05)
    assert -loads.couplings["fifth_wheel_1"][0][2] == pytest.approx(-62968.8, abs=0.05)
    assert loads.couplings["fifth_wheel_2"][0][2] == pytest.approx(69428.7, abs=0.05)
    assert loads.preloads == {}
    assert loads.axles["axle_4"] == pytest.approx(182830.5 / 3, abs=0.05)


def test_loads_of_the_tractor_semitrailer_are_those_of_its_table() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(vehicle("tractor_semitrailer_yaw_plane")))
    # levers over Table A1's places by hand, g = 9.8
    hitch = 11665 * 9.8 * 4.507 / 10.0
    rear = (6525 * 9.8 * 1.115 + hitch * 3.074) / 3.7
    by_hand = {"axle_1": 6525 * 9.8 + hitch - rear, "axle_2": rear, "axle_3": 11665 * 9.8 * 5.493 / 10.0}
    assert loads.axles == pytest.approx(by_hand, rel=1e-12)
    assert loads.couplings["fifth_wheel"][0][2] == pytest.approx(hitch, rel=1e-12)
    # published for this data in whole newtons, with g = 9.81
    published = trim_loads(eom.assemble(vehicle("tractor_semitrailer_yaw_plane", gravity=9.81))).axles
    assert published == pytest.approx({"axle_1": 53447.0, "axle_2": 62139.0, "axle_3": 62858.0}, abs=0.5)


def test_vertical_hitch_load_changes_the_roots_as_little_as_published() -> None:
    own = eom.linearise(eom.loads(with_axle_supports())).without_cyclic().A
    other = eom.linearise(vehicle("b_train_yaw_roll")).without_cyclic().A
    a, b = np.linalg.eigvals(own), np.linalg.eigvals(other)
    for value in b[np.abs(b) < 30.0]:
        nearest = np.min(np.abs(a - value)) / abs(value)
        # published: less than 0.6 % in roll and 0.1 % in yaw (the slow roots)
        assert nearest < (0.001 if abs(value) < 4.0 else 0.006)
