"""Units and wheels in the plane: the referee `planar_train` against textbook equations and against itself."""

from dataclasses import replace

import numpy as np
import pytest

from eom.tyre import Linear, MagicFormula
from tests.referees.planar_examples import DOUBLE, ROUNDING, pair, working_point
from tests.referees.planar_parts import PlanarTrain, PlanarUnit, PlanarWheel, straight_state
from tests.referees.planar_train import accelerations, rhs


@pytest.mark.parametrize("seed", range(5))
def test_a_single_unit_has_the_equations_of_the_single_track_model(seed: int) -> None:
    m, inertia, a, b, radius, spin_inertia = 1500.0, 2500.0, 1.2, 1.5, 0.3, 1.1
    tyre = MagicFormula(nominal_load=7e3, mu_x=1.0, mu_y=0.9, k_x=18.0, k_y=14.0)
    front = PlanarWheel(x=a, radius=radius, load=8e3, tyre=tyre.forces, spin_inertia=spin_inertia, steer_index=0)
    rear = PlanarWheel(x=-b, radius=radius, load=6e3, tyre=tyre.forces, spin_inertia=spin_inertia)
    car = PlanarTrain((PlanarUnit(mass=m, yaw_inertia=inertia, wheels=(front, rear)),))
    state, (delta, _), torque = working_point(car, seed)
    _, _, yaw, vx, vy, r, *spin = state

    alpha_f, alpha_r = np.arctan2(vy + a * r, vx) - delta, np.arctan2(vy - b * r, vx)
    speed_f = vx * np.cos(delta) + (vy + a * r) * np.sin(delta)
    at_f = tyre.forces(alpha_f, (spin[0] * radius - speed_f) / speed_f, 8e3)
    at_r = tyre.forces(alpha_r, (spin[1] * radius - vx) / vx, 6e3)
    c, s = np.cos(delta), np.sin(delta)
    expected = [
        vx * np.cos(yaw) - vy * np.sin(yaw),
        vx * np.sin(yaw) + vy * np.cos(yaw),
        r,
        (at_f.Fx * c - at_f.Fy * s + at_r.Fx) / m + vy * r,
        (at_f.Fx * s + at_f.Fy * c + at_r.Fy) / m - vx * r,
        (a * (at_f.Fx * s + at_f.Fy * c) - b * at_r.Fy) / inertia,
        (torque[0] - radius * at_f.Fx) / spin_inertia,
        (torque[1] - radius * at_r.Fx) / spin_inertia,
    ]
    np.testing.assert_allclose(rhs(car, state, [delta], torque), expected, rtol=ROUNDING, atol=ROUNDING)


@pytest.mark.parametrize("slip", [-0.02, 0.03])
def test_a_wheel_without_spin_inertia_is_one_whose_torque_balances(slip: float) -> None:
    """A linear tyre: slip changes neither its side force nor its rolling resistance."""
    tyre = Linear(nominal_load=5e3, cornering=9e4, longitudinal=1.2e5, rolling_resistance=0.01, radius=0.3)
    wheel = PlanarWheel(x=-1.4, radius=0.3, load=5e3, tyre=tyre.forces, spin_inertia=1.0)
    unit = PlanarUnit(mass=1200.0, yaw_inertia=2e3, wheels=(wheel,))
    torque = 0.3 * (1.2e5 * slip + 0.01 * 5e3)
    motion = [1.0, 2.0, 0.4, 18.0, 0.7, 0.2]
    spinning = rhs(PlanarTrain((unit,)), [*motion, (1.0 + slip) * 18.0 / 0.3], [], [torque])
    rigid = PlanarTrain((replace(unit, wheels=(replace(wheel, spin_inertia=0.0),)),))
    np.testing.assert_allclose(spinning, [*rhs(rigid, motion, [], [torque]), 0.0], rtol=ROUNDING, atol=ROUNDING)


def test_several_wheels_at_a_place_are_as_many_single_ones() -> None:
    dual = PlanarUnit(mass=9e3, yaw_inertia=4e4, wheels=(*pair(-2.0),))
    state, steer, torque = working_point(PlanarTrain((dual,)), 1)
    single = replace(dual, wheels=tuple(replace(wheel, count=1) for wheel in dual.wheels for _ in range(2)))
    few = rhs(PlanarTrain((dual,)), state, steer, torque)
    many = rhs(PlanarTrain((single,)), [*state[:-2], *np.repeat(state[-2:], 2)], steer, np.repeat(torque, 2))
    np.testing.assert_allclose(many, [*few[:-2], *np.repeat(few[-2:], 2)], rtol=ROUNDING, atol=ROUNDING)


def test_wheels_that_roll_straight_without_slip_have_no_side_force() -> None:
    motion = accelerations(DOUBLE, straight_state(DOUBLE, 25.0), [0.0, 0.0], np.zeros(len(DOUBLE.placed)))
    for values in (motion.contacts.alpha, motion.contacts.kappa, motion.contacts.Fy):
        np.testing.assert_allclose(values, 0.0, atol=1e-12)
    assert np.all(motion.contacts.My < 0.0)


def test_a_train_whose_pins_are_incomplete_is_refused() -> None:
    with pytest.raises(ValueError, match="expected a rear pin"):
        _ = PlanarTrain((PlanarUnit(mass=1.0, yaw_inertia=1.0), PlanarUnit(mass=1.0, yaw_inertia=1.0, front=1.0))).pins
