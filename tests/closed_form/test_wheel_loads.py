"""The thesis's wheel loads (3.42), corrected, and the loads of the model of the same train."""

import numpy as np
import pytest

import eom
from eom.closed_form import BTrainYawRoll, wheel_loads
from eom.closed_form.wheel_loads import Motion
from eom.splice.trim import loads_at_rest
from tests.splice.runs import inputs_of, run
from tests.vehicles.shipped import vehicle

P = BTrainYawRoll()


def model(**values: float) -> eom.TyreModel:
    """The B-train with wheels."""
    built = eom.build(vehicle("b_train", **values))
    assert isinstance(built, eom.TyreModel)
    return built


def test_static_loads_are_the_printed_ones() -> None:
    """29395 and 17824 N per dual pair; by the model's levers 30 471.7 N, to the rounding of Appendix B's places."""
    at_rest = wheel_loads.wheel_loads(P, Motion())
    np.testing.assert_allclose(at_rest[3:6], 29395.1, atol=0.1)
    np.testing.assert_allclose(at_rest[6:], 17823.7, atol=0.1)
    assert np.sum(at_rest) == pytest.approx((P.m1 + P.m2 + P.m3) * P.g, rel=1e-12)
    with_lever = wheel_loads.wheel_loads(P, Motion(), lever=True)
    own = model()
    found = loads_at_rest(own.prepared.system, own.prepared.pivots).reshape(9, 2)
    # a11 and places of the whole-mass centres are given to a millimetre
    np.testing.assert_allclose(found, with_lever, rtol=3e-4)


def test_loads_in_a_gentle_turn_are_those_of_the_tyres_springs() -> None:
    """The model's own transfer, with rolls from it; the thesis's form is right in the sum, low on the tractor.

    A positive steer turns left; in SAE axes accelerations are to the right, rolls keep their sign.
    """
    own = model(f_r=0.0)
    x, u = own.trim()
    turn = run(own, x, inputs_of(own.inputs, u, axle_1__steer=lambda t: 0.008 * min(t, 1.0)), 6.0)
    last = {name: float(values[-1]) for name, values in turn.outputs.items()}
    units = ("tractor", "semitrailer_1", "semitrailer_2")
    phi, phi_t = (np.array([last[f"{unit}_{body}.roll"] for unit in units]) for body in ("frame", "axles"))
    motion = Motion(a_y=-np.array([last[f"{unit}.ay"] for unit in units]), phi=phi, phi_t=phi_t)
    found = np.array([[last[f"axle_{k}.{side}.Fz"] for side in ("left", "right")] for k in range(1, 10)])
    by_tyres = wheel_loads.wheel_loads(P, motion, lever=True, transfer="tyres")
    # the slowing train shifts a little load along
    np.testing.assert_allclose(found, by_tyres, rtol=5e-3)
    thesis = wheel_loads.wheel_loads(P, motion, lever=True)
    moved, printed = ((loads[:, 1] - loads[:, 0]) @ (0.5 * TRACK) for loads in (found, thesis))
    assert printed == pytest.approx(moved, rel=0.02)
    share = [(loads[:3, 1] - loads[:3, 0]) @ (0.5 * TRACK[:3]) for loads in (thesis, found)]
    assert 0.65 < share[0] / share[1] < 0.78


def test_load_moves_forward_under_braking_as_moments_say() -> None:
    """Every unit braked by itself, so that hitches carry no force along; rates of spin and pitch of none matter."""
    own = model(f_r=0.0)
    x, u = own.trim()
    at_rest = own.evaluated(x, u).balance.load
    # pressures in proportion to the load that each unit has to stop
    share = np.array([P.m1 / 6.0] * 6 + [P.m2 / 6.0] * 12)
    for wheel, part in zip(own.prepared.system.wheels, share, strict=True):
        u[own.inputs.index(f"{wheel.name}.brake_pressure")] = part * 2.0 * 0.51 / wheel.brake_gain
    slowed = run(own, x, lambda t: u * min(1.0, t / 0.5), 2.0)
    last = {name: float(values[-1]) for name, values in slowed.outputs.items()}
    a_x = np.array([last[f"{unit}.ax"] for unit in ("tractor", "semitrailer_1", "semitrailer_2")])
    found = own.evaluated(slowed.x[-1], u).balance.load - at_rest
    formula = wheel_loads.wheel_loads(P, Motion(a_x=a_x), lever=True) - wheel_loads.wheel_loads(P, Motion(), lever=True)
    # wheels are slowed too, and the hitches, 1.1 m high, carry what is left of their forces
    np.testing.assert_allclose(found.reshape(9, 2), formula, atol=0.05 * np.max(np.abs(formula)))


TRACK = np.array([1.98, *[1.65] * 8])
