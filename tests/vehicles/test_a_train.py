"""The A-train against a Lagrangian derivation: a pintle hands on no roll, a fifth wheel does."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import eom
from tests.referees.train import B_TRAIN, Axle, Body, Hitch, LinearModel, RollParts, TrainParameters, Unit, yaw_roll
from tests.vehicles.agreement import assert_responses_agree, assert_roots_agree, response
from tests.vehicles.shipped import text, vehicle

TRACTOR, SEMITRAILER_1, SEMITRAILER_2 = B_TRAIN.units
DOLLY = Unit(
    "dolly",
    bodies=(
        Body(mass=700.0, x=-1.7, z=0.95, i_xx=200.0, i_zz=950.0),
        Body(mass=900.0, x=-2.1, z=0.5, i_xx=400.0, i_zz=400.0),
    ),
    axles=(Axle(-2.1, 480e3),),
    roll=RollParts(0.705, 0.9e6, 40e3, 1.8e6),
)
DATA = TrainParameters(
    units=(TRACTOR, SEMITRAILER_1, DOLLY, SEMITRAILER_2),
    hitches=(
        Hitch(x_ahead=-5.635, height=1.1, roll_stiffness=550e3),
        Hitch(x_ahead=-13.4, height=0.9),
        Hitch(x_ahead=-2.1, height=1.1, roll_stiffness=550e3),
    ),
)
UNITS = tuple(unit.name for unit in DATA.units)
NAMES = {f"{unit}_frame.roll": f"{unit}.roll" for unit in UNITS} | {
    f"{unit}_axles.roll": f"{unit}.unsprung_roll" for unit in UNITS
}


def models(kmh: float) -> tuple[eom.LinearModel, LinearModel]:
    return eom.linearise(vehicle("a_train", U=kmh / 3.6)), yaw_roll(DATA, kmh / 3.6)


def steady(model: eom.LinearModel, signal: str) -> dict[str, float]:
    """Steady response of each output to one unit of an input, place and heading left out."""
    short = model.without_cyclic()
    gain = short.D - short.C @ np.linalg.solve(short.A, short.B)
    return dict(zip(short.outputs, gain[:, short.inputs.index(signal)], strict=True))


@pytest.mark.parametrize("kmh", [30.0, 90.0, 120.0])
def test_roots_and_transfer_functions_equal_an_independent_derivation(kmh: float) -> None:
    model, other = models(kmh)
    # two derivations in double precision
    assert_roots_agree(model, other, 1e-10)
    # 5 frequencies; 4 accelerations and that of the first axle, 4 yaw rates, 4 sideslips, 8 rolls; 8 inputs
    assert assert_responses_agree(model, other, 1e-10, NAMES) == 5 * 21 * 8


def test_the_elastic_matrix_joins_rolls_across_fifth_wheels_and_not_across_the_pintle() -> None:
    assembly = eom.assemble(vehicle("a_train"))
    roll = [assembly.coordinates.index(f"{unit}_frame.roll") for unit in UNITS]
    stiffness = assembly.matrices.K_elastic
    between = [stiffness[ahead, behind] for ahead, behind in pairwise(roll)]
    assert between == [-550e3, 0.0, -550e3]


def test_a_steady_roll_moment_passes_the_fifth_wheel_and_ends_at_the_pintle() -> None:
    model, _ = models(90.0)
    ahead, behind = ("tractor", "semitrailer_1"), ("dolly", "semitrailer_2")
    for pushed, beyond in ((ahead, behind), (behind, ahead)):
        for unit in pushed:
            rolls = steady(model, f"{unit}.roll_moment")
            own = abs(rolls[f"{unit}_frame.roll"])
            assert all(abs(rolls[f"{other}_frame.roll"]) > 0.02 * own for other in pushed)
            # a steady moment inside a unit leaves the tyres without side force: nothing crosses but rounding
            assert all(abs(rolls[f"{other}_frame.roll"]) < 1e-11 * own for other in beyond)


def test_a_stiffer_pintle_would_hand_on_roll() -> None:
    file = text("a_train").replace("dolly: [0, 0, 0.9]}\n", "dolly: [0, 0, 0.9]}\n    roll_stiffness: 1 MN*m/rad\n")
    model = eom.linearise(eom.loads(file))
    rolls = steady(model, "semitrailer_2.roll_moment")
    assert abs(rolls["semitrailer_1_frame.roll"]) > 1e-3 * abs(rolls["semitrailer_2_frame.roll"])


def test_a_fifth_wheel_that_carries_roll_rigidly_is_the_limit_of_a_stiff_one() -> None:
    elastic = "carries: [x, y]\n    roll_stiffness: 550 kN*m/rad"
    file = text("a_train")
    assert file.count(elastic) == 2
    rigid = eom.linearise(eom.loads(file.replace(elastic, "carries: [x, y, roll]")))
    # each rigid one takes a roll and its rate away
    assert len(rigid.states) == len(models(90.0)[0].states) - 4
    own = rigid.frequency_response(np.array([0.4]))[0, :, rigid.inputs.index("axle_1.steer")]
    errors = []
    for stiffness in (1e9, 1e10):
        hitches = [replace(item, roll_stiffness=stiffness if item.roll_stiffness else 0.0) for item in DATA.hitches]
        other = yaw_roll(TrainParameters(DATA.units, tuple(hitches)), 25.0)
        theirs = response(other, 0.4)[:, other.inputs.index("axle_1.steer")]
        pairs = [
            (own[k], theirs[other.outputs.index(NAMES.get(output, output))])
            for k, output in enumerate(rigid.outputs)
            if NAMES.get(output, output) in other.outputs
        ]
        errors.append(max(abs(a - b) / abs(b) for a, b in pairs))
    # what a finite stiffness leaves is in proportion to its compliance
    assert errors[0] < 0.02
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.05)


@pytest.mark.parametrize("kmh", [30.0, 90.0])
def test_in_a_steady_turn_every_unit_has_lateral_acceleration_of_speed_times_the_one_yaw_rate(kmh: float) -> None:
    model, _ = models(kmh)
    turn = steady(model, "axle_1.steer")
    rates = [turn[f"{unit}.yaw_rate"] for unit in UNITS]
    # rounding of one linear solve
    np.testing.assert_allclose(rates, rates[0], rtol=1e-10)
    np.testing.assert_allclose([turn[f"{unit}.ay"] for unit in UNITS], kmh / 3.6 * rates[0], rtol=1e-10)


def test_rearward_amplification_grows_with_speed_as_in_the_independent_derivation() -> None:
    frequencies = np.linspace(0.1, 1.0, 46)
    largest = []
    for kmh in (60.0, 90.0, 110.0):
        model, other = models(kmh)
        own = np.abs(model.frequency_response(frequencies)[:, :, model.inputs.index("axle_1.steer")])
        theirs = np.abs([response(other, float(f))[:, other.inputs.index("axle_1.steer")] for f in frequencies])
        gains = [
            np.max(values[:, names.index("semitrailer_2.ay")] / values[:, names.index("axle_1.ay")])
            for values, names in ((own, list(model.outputs)), (theirs, list(other.outputs)))
        ]
        # equal as the transfer functions are
        assert gains[0] == pytest.approx(gains[1], rel=1e-9)
        largest.append(gains[0])
    assert largest == sorted(largest)
    assert largest[1] > 1.0
