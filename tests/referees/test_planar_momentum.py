"""Energy, momentum and pins in the plane, of the referee `planar_train`."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.referees.planar_examples import DOUBLE, FREE, ROUNDING, centres, kinetic_energy, working_point
from tests.referees.planar_parts import Array, PlanarTrain, split, straight_state
from tests.referees.planar_train import accelerations, axes, left_of, rhs


@pytest.mark.parametrize("seed", range(20))
def test_power_of_road_drag_and_torque_is_the_rate_of_kinetic_energy(seed: int) -> None:
    point = working_point(DOUBLE, seed)
    motion, now = accelerations(DOUBLE, *point), split(DOUBLE, point.state)
    on, spins = motion.contacts, iter(zip(now.spin, motion.spin_acceleration, strict=True))
    powers, rates = [], []
    for j, (k, wheel) in enumerate(DOUBLE.placed):
        powers.append(wheel.count * (on.Fx[j] * on.v_x[j] + on.Fy[j] * on.v_y[j] + on.Mz[j] * now.yaw_rate[k]))
        if wheel.spin_inertia:
            spin, growth = next(spins)
            powers.append(wheel.count * (point.torque[j] - 0.49 * on.Fx[j] + on.My[j]) * spin)
            rates.append(wheel.count * wheel.spin_inertia * spin * growth)
    for k, unit in enumerate(DOUBLE.units):
        powers.append(-unit.drag(motion.velocity[k, 0]) * motion.velocity[k, 0])
        rates.append(unit.mass * motion.velocity[k] @ motion.acceleration[k])
        rates.append(unit.yaw_inertia * now.yaw_rate[k] * motion.yaw_acceleration[k])
    assert sum(powers) == pytest.approx(sum(rates), abs=ROUNDING * float(np.max(np.abs(powers))))


@pytest.mark.parametrize("seed", range(5))
def test_the_derivative_of_the_state_changes_the_energy_by_that_power(seed: int) -> None:
    """Central differences over 1e-5 s: errors of third derivatives of 1e-10, rounding of 1e-16 / 1e-5, times 10."""
    point = working_point(DOUBLE, seed)
    slope, motion, step = rhs(DOUBLE, *point), accelerations(DOUBLE, *point), 1e-5
    forward, back = (kinetic_energy(DOUBLE, point.state + sign * step * slope) for sign in (1.0, -1.0))
    now = split(DOUBLE, point.state)
    expected = sum(
        unit.mass * v @ a + unit.yaw_inertia * r * growth
        for unit, v, a, r, growth in zip(
            DOUBLE.units, motion.velocity, motion.acceleration, now.yaw_rate, motion.yaw_acceleration, strict=True
        )
    )
    inertias = np.array([wheel.count * wheel.spin_inertia for _, wheel in DOUBLE.placed if wheel.spin_inertia])
    expected += (inertias * now.spin) @ motion.spin_acceleration
    scale = kinetic_energy(DOUBLE, point.state)
    assert (forward - back) / (2.0 * step) == pytest.approx(expected, abs=1e-9 * scale)


def test_a_train_without_tyres_keeps_its_momenta_and_its_energy() -> None:
    """Integrated to 1e-12; the trains tumble for two seconds."""
    start = working_point(FREE, 3).state
    run = solve_ivp(lambda _, x: rhs(FREE, x, [], []), (0.0, 2.0), start, method="DOP853", rtol=1e-12, atol=1e-12)
    found = []
    for state in run.y.T:
        places, velocities = centres(FREE, state)
        rates, momentum = split(FREE, state).yaw_rate, np.zeros(3)
        for unit, place, velocity, r in zip(FREE.units, places, velocities, rates, strict=True):
            about_origin = unit.mass * (left_of(place) @ velocity) + unit.yaw_inertia * r
            momentum += [*(unit.mass * velocity), about_origin]
        found.append([*momentum, kinetic_energy(FREE, state)])
    assert np.ptp(split(FREE, run.y[:, -1]).yaw - split(FREE, start).yaw) > 0.5  # they do turn against each other
    np.testing.assert_allclose(found, np.tile(found[0], (len(found), 1)), rtol=1e-9)


def test_units_moved_one_by_one_by_their_own_accelerations_stay_pinned_together() -> None:
    """Each unit's centre is integrated on its own; nothing but the referee's pin forces holds the pins together.

    Integrated to 1e-11 over two seconds. Wheels have no spin inertia, as fast roots of spin take only time.
    """
    train, n, steer = without_spin(DOUBLE), len(DOUBLE.units), np.array([0.15, -0.1])
    torque = np.array([0.0, 0.0, 2e3, 2e3, *[0.0] * (len(train.placed) - 4)])
    start = straight_state(train, 10.0)
    start[2 : 2 + n] = [0.2, -0.3, -0.9]
    size = len(start)

    def slope(_: float, x: Array) -> Array:
        state, velocity = x[:size], x[size + 2 * n :]
        motion, now = accelerations(train, state, steer, torque), split(train, state)
        inertial = [axes(yaw) @ a for yaw, a in zip(now.yaw, motion.acceleration, strict=True)]
        return np.concatenate([rhs(train, state, steer, torque), velocity, np.ravel(inertial)])

    full = np.concatenate([start, *(np.ravel(each) for each in centres(train, start))])
    end = solve_ivp(slope, (0.0, 2.0), full, method="DOP853", rtol=1e-11, atol=1e-11).y[:, -1]
    yaw, places = split(train, end[:size]).yaw, end[size : size + 2 * n].reshape(n, 2)
    assert np.all(np.abs(np.diff(yaw) - np.diff(start[2 : 2 + n])) > 0.05)  # it did bend, by more than at the start
    for k, (rear, front) in enumerate(train.pins):
        gap = places[k] + axes(yaw[k]) @ [rear, 0.0] - places[k + 1] - axes(yaw[k + 1]) @ [front, 0.0]
        np.testing.assert_allclose(gap, 0.0, atol=1e-9)
    np.testing.assert_allclose(places[0], end[:2], atol=1e-9)


def without_spin(train: PlanarTrain) -> PlanarTrain:
    """The same with wheels that roll along at once."""
    return PlanarTrain(
        tuple(
            replace(unit, wheels=tuple(replace(wheel, spin_inertia=0.0) for wheel in unit.wheels))
            for unit in train.units
        )
    )


@pytest.mark.parametrize("seed", range(5))
def test_pin_forces_and_the_road_give_each_unit_its_momentum(seed: int) -> None:
    """Newton and Euler for a towed unit alone, the force in its front pin turned over from the unit ahead."""
    train = PlanarTrain(DOUBLE.units[:2])
    point = working_point(train, seed)
    motion, (ahead, behind) = accelerations(train, *point), train.units
    now, on = split(train, point.state), motion.contacts
    force = axes(now.yaw[0] - now.yaw[1]) @ motion.pin_force[0]
    moment = (behind.front or 0.0) * force[1]
    terms = [force, behind.mass * motion.acceleration[1]]
    for j, wheel in enumerate(behind.wheels, start=len(ahead.wheels)):
        road = wheel.count * axes(0.0 if wheel.steer_index is None else point.steer[1]) @ [on.Fx[j], on.Fy[j]]
        force = force + road
        moment += wheel.x * road[1] - wheel.y * road[0] + wheel.count * on.Mz[j]
        terms.append(road)
    scale = ROUNDING * float(np.max(np.abs(terms)))
    np.testing.assert_allclose(force, behind.mass * motion.acceleration[1], atol=scale)
    assert moment == pytest.approx(behind.yaw_inertia * motion.yaw_acceleration[1], abs=10.0 * scale)  # arms of 10 m
