"""Balance of power: what road, drive, brakes, air and dampers do to a vehicle is what it has more of energy.

At every state the identity is exact, articulation and roll however large: velocities and forces belong together. So
joints do no work, nor do gyroscopic and centripetal terms. Springs and weight have a potential to the second order of
the displacements, in which they are linear.
"""

import numpy as np
import pytest

from eom.model.tyre import TyreModel
from tests.splice.powers import Powers, kinetic_energy, powers
from tests.splice.shared import STEP, Array, by_name, march, model, places
from tests.vehicles.shipped import WHEELED

SPRUNG = ("a_train_double", "b_train", "tractor_semitrailer")
SEEDS = range(5)


def random_state(found: TyreModel, seed: int) -> tuple[Array, Array]:
    """Displacements to 0.1, velocities to 1 from 20 m/s, spins to 30 %, and inputs of every kind."""
    random = np.random.default_rng(seed)
    at, x = places(found), found.trim(20.0).x.copy()
    x[at["frame"]] = random.uniform([-50, -50, -3], [50, 50, 3])
    x[at["q"]] += random.uniform(-0.1, 0.1, len(x[at["q"]]))
    x[at["n"]] += random.uniform(-1.0, 1.0, len(x[at["n"]]))
    x[at["spin"]] *= random.uniform(0.7, 1.3, len(x[at["spin"]]))
    size = {"rad": (-0.1, 0.1), "Pa": (0.0, 5e5), "N*m": (-1e4, 1e4)}
    return x, np.array([random.uniform(*size[unit]) for unit in found.input_units])


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", WHEELED)
def test_kinetic_energy_grows_by_the_power_of_all_forces(name: str, seed: int) -> None:
    """Exact derivatives on one side, sums of some ten powers on the other: rounding. Seen are 2e-15."""
    found = model(name)
    x, u = random_state(found, seed)
    growth = kinetic_energy(found, x + 1j * STEP * found.rhs(0.0, x, u)).imag / STEP
    acting = powers(found, found.evaluated(x, u), u)
    assert abs(growth - sum(acting)) < 1e-11 * sum(map(abs, acting))


def potential(found: TyreModel) -> tuple[Array, Array]:
    """Stiffness (q, q) of springs and weight, and what of their power is no rate of a potential, (n, q)."""
    body = found.numbers.body
    turned = np.einsum("i,kin->kn", body.f, body.W_turn.reshape(-1, *body.W.shape))
    power = body.W.T @ body.K @ body.T - turned.T
    stiffness = np.linalg.lstsq(body.rate.T, power, rcond=None)[0]
    return stiffness, body.rate.T @ stiffness - power


@pytest.mark.parametrize("name", SPRUNG)
def test_springs_and_weight_have_a_potential(name: str) -> None:
    """Their power is minus dq/dt K q with a symmetric K, whatever the speed: rounding of a fit. Seen are 2e-16."""
    stiffness, left = potential(model(name))
    scale = 1e-12 * np.max(np.abs(stiffness))
    np.testing.assert_allclose(stiffness, stiffness.T, atol=scale)
    np.testing.assert_allclose(left, 0.0, atol=scale)


def test_a_cars_springs_have_a_potential_but_for_what_balances_the_drive() -> None:
    """Springs that the drive's pitch moment loads do work when the rolled car yaws.

    Its rate of pitch is not its pitch rate. That is of the second order, and of the size of that moment.
    """
    found = model("car")
    at, body = places(found), found.numbers.body
    stiffness, left = potential(found)
    n, q = found.states[at["n"]], found.states[at["q"]]
    pitch = float((body.f @ body.W)[n.index("car_body.pitch_rate")])
    assert 50.0 < pitch < 500.0
    left[n.index("car_body.yaw_rate"), q.index("car_body.roll")] += pitch
    scale = 1e-12 * np.max(np.abs(stiffness))
    np.testing.assert_allclose(stiffness, stiffness.T, atol=scale)
    np.testing.assert_allclose(left, 0.0, atol=scale)


def test_dampers_of_the_b_train_turn_the_energy_of_its_file_into_heat() -> None:
    found = model("b_train")
    x, u = random_state(found, 3)
    now = found.evaluated(x, u)
    rates = now.motion.w[3::6]
    heat = sum(c * (rates[2 * k] - rates[2 * k + 1]) ** 2 for k, c in enumerate((130e3, 120e3, 120e3)))
    # rounding
    assert powers(found, now, u).dampers == pytest.approx(-heat, rel=1e-12)


def test_a_manoeuvre_of_the_b_train_keeps_its_balance() -> None:
    """A sine of steer of 2 deg at 110 km/h, brakes in it: energy changes by the works, to 1e-6 of their size.

    Works are quadratures of the motion by Gauss's rule between the corners of the inputs, on panels of 30 ms; with the
    integrator's 1e-9 and corners of loads that lift, seen are 1e-12. What springs and weight gave is back in
    their potential, to the same measure.
    """
    found = model("b_train")
    start = found.trim()
    braking = by_name(found, every_brake_pressure=2e5)

    def inputs(t: float) -> Array:
        steer = by_name(found, axle_1__steer=np.radians(2.0) * np.sin(0.8 * np.pi * t) if t < 2.5 else 0.0)
        # brakes come and go without a corner
        pressure = braking * np.sin(np.pi * (t - 1.0) / 2.0) ** 2 * (1.0 < t < 3.0)
        return np.asarray(start.u + steer + pressure)

    works = np.zeros(len(Powers._fields))
    nodes, weights = np.polynomial.legendre.leggauss(4)
    run = march(lambda t, x: found.rhs(t, x, inputs(t)), start.x, (0.0, 1.0, 2.5, 3.0, 4.0))
    for first, last, state in run:
        panels = round((last - first) / 0.03)
        half = (last - first) / (2 * panels)
        for k in range(panels):
            times = first + half * (2 * k + 1 + nodes)
            for t, weight in zip(times, weights, strict=True):
                u = inputs(t)
                works += half * weight * np.array(tuple(powers(found, found.evaluated(state(t), u), u)))
    x = run[-1].state(run[-1].last)
    gained = (kinetic_energy(found, x) - kinetic_energy(found, start.x)).real
    done = Powers(*works)
    size = sum(map(abs, done))
    assert min(done.drive, -done.brakes, -done.road) > 1e6
    assert abs(gained - sum(done)) < 1e-6 * size
    q = x[places(found)["q"]]
    stored = 0.5 * q @ potential(found)[0] @ q
    assert stored > 10.0
    assert stored == pytest.approx(-done.dead - done.springs, abs=1e-9 * size)
