"""Truck, dolly and trailer against Newton's balances of three rigid units."""

import numpy as np
import pytest

import eom
from tests.referees.train import Axle, Body, Hitch, LinearModel, TrainParameters, Unit, yaw_plane
from tests.vehicles.agreement import assert_responses_agree, assert_roots_agree, response
from tests.vehicles.shipped import vehicle

UNITS = ("truck", "dolly", "trailer")
DATA = TrainParameters(
    units=(
        Unit("truck", (Body(15e3, -3.0, 78e3),), (Axle(0.0, 300e3), Axle(-4.8, 480e3))),
        # bogie and drawbar turn as one
        Unit("dolly", (Body(1200.0, -2.5, 900.0), Body(150.0, -0.95, 45.0)), (Axle(-2.5, 420e3),)),
        Unit("trailer", (Body(15e3, -2.4, 72e3),), (Axle(-5.0, 420e3),)),
    ),
    hitches=(Hitch(x_ahead=-6.6), Hitch(x_ahead=-2.5)),
)


def models(speed: float) -> tuple[eom.LinearModel, LinearModel]:
    return eom.linearise(vehicle("truck_full_trailer", U=speed)), yaw_plane(DATA, speed)


@pytest.mark.parametrize("kmh", [30.0, 80.0, 120.0])
def test_roots_and_transfer_functions_are_those_of_three_rigid_units(kmh: float) -> None:
    model, other = models(kmh / 3.6)
    assert model.without_cyclic().A.shape == (6, 6)
    # two derivations in double precision
    assert_roots_agree(model, other, 1e-10)
    # 5 frequencies, 10 shared outputs, steer and two yaw moments
    assert assert_responses_agree(model, other, 1e-10) == 5 * 10 * 3


@pytest.mark.parametrize("kmh", [30.0, 80.0])
def test_in_a_steady_turn_every_unit_has_lateral_acceleration_of_speed_times_the_one_yaw_rate(kmh: float) -> None:
    model, _ = models(kmh / 3.6)
    short = model.without_cyclic()
    turn = (short.D - short.C @ np.linalg.solve(short.A, short.B))[:, short.inputs.index("axle_1.steer")]
    rates = [turn[short.outputs.index(f"{unit}.yaw_rate")] for unit in UNITS]
    accelerations = [turn[short.outputs.index(f"{unit}.ay")] for unit in UNITS]
    # rounding of one linear solve
    np.testing.assert_allclose(rates, rates[0], rtol=1e-11)
    np.testing.assert_allclose(accelerations, kmh / 3.6 * rates[0], rtol=1e-11)


def test_rearward_amplification_is_that_of_the_independent_derivation() -> None:
    model, other = models(80.0 / 3.6)
    frequencies = np.linspace(0.1, 1.0, 46)
    own = np.abs(model.frequency_response(frequencies)[:, :, model.inputs.index("axle_1.steer")])
    theirs = np.abs([response(other, float(f))[:, other.inputs.index("axle_1.steer")] for f in frequencies])
    gains = [
        np.max(values[:, names.index("trailer.ay")] / values[:, names.index("truck.ay")])
        for values, names in ((own, list(model.outputs)), (theirs, list(other.outputs)))
    ]
    # a trailer that swings more than the truck; equal as the transfer functions are
    assert gains[0] > 1.0
    assert gains[0] == pytest.approx(gains[1], rel=1e-9)


def test_the_drawbar_lies_half_on_the_hook_and_axles_carry_the_rest_by_the_levers() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(vehicle("truck_full_trailer")))
    g = 9.81
    hook = 150.0 * g / 2.0
    rear = (15e3 * g * 3.0 + hook * 6.6) / 4.8
    expected = {"axle_1": 15e3 * g + hook - rear, "axle_2": rear}
    # levers about the rear axle: the turntable carries the pitch of the bogie, 0.6 m ahead of which the hinge pushes
    bogie = (15e3 * g * 2.6 + 1200.0 * g * 5.0 + hook * 5.6) / 5.0
    expected |= {"axle_3": bogie, "axle_4": (15e3 + 1200.0) * g + hook - bogie}
    assert loads.axles == pytest.approx(expected, rel=1e-12)
    assert loads.couplings["hook"][0][2] == pytest.approx(hook, rel=1e-12)
    assert loads.couplings["turntable"][0][2] == pytest.approx(bogie - 1200.0 * g - hook, rel=1e-12)
