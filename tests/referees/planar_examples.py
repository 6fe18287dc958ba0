"""A double of three units to try the planar referee on, at random, and its motion written by complex numbers."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from eom.tyre import MagicFormula
from tests.referees.planar_parts import Array, PlanarTrain, PlanarUnit, PlanarWheel, split, straight_state

ROUNDING = 1e-10
"""Of a sum against its largest term: a solve of some ten unknowns of one size leaves 1e-14 to 1e-13."""

TRUCK = MagicFormula(
    nominal_load=30e3, mu_x=0.85, mu_y=0.8, k_x=5.0, k_y=9.5, E_y=-1.0, trail=0.04, rolling_resistance=0.006, radius=0.5
)


def pair(x: float, *, steered: int | None = None, count: int = 2, spin_inertia: float = 11.0) -> list[PlanarWheel]:
    """A left and a right wheel with Magic Formula tyres."""
    place = PlanarWheel(
        x=x, radius=0.49, load=21e3, tyre=TRUCK.forces, spin_inertia=spin_inertia, steer_index=steered, count=count
    )
    return [replace(place, y=y) for y in (0.95, -0.95)]


DOUBLE = PlanarTrain(
    (
        PlanarUnit(
            mass=8258.0,
            yaw_inertia=44e3,
            wheels=(*pair(2.0, steered=0, count=1), *pair(-3.0), *pair(-4.3, spin_inertia=0.0)),
            rear=-3.6,
            drag=lambda v: 3.0 * v * v,
        ),
        PlanarUnit(mass=18e3, yaw_inertia=491e3, wheels=(*pair(-3.3), *pair(-5.8, steered=1)), front=7.0, rear=-5.6),
        PlanarUnit(mass=12e3, yaw_inertia=300e3, wheels=(*pair(-3.3), *pair(-4.6, spin_inertia=0.0)), front=6.0),
    )
)
FREE = PlanarTrain(tuple(replace(unit, wheels=(), drag=lambda _: 0.0) for unit in DOUBLE.units))


class Working(NamedTuple):
    state: Array
    steer: Array
    torque: Array


def working_point(train: PlanarTrain, seed: int) -> Working:
    """Any heading and articulation, speeds of a skid, wheels that slip, steer and torques at random."""
    random = np.random.default_rng(seed)
    state = straight_state(train, 20.0)
    n, wheels = len(train.units), len(train.placed)
    spread = np.concatenate([np.full(2, 50.0), np.full(n, 3.0), [6.0, 4.0], np.full(n, 0.8), np.full(len(state), 12.0)])
    state = state + spread[: len(state)] * random.uniform(-1.0, 1.0, len(state))
    return Working(state, random.uniform(-0.6, 0.6, 2), random.uniform(-4e3, 4e3, wheels))


def kinetic_energy(train: PlanarTrain, state: Array) -> float:
    """Of all units and spinning wheels, J; velocities by the positions of `centres`, not by those of the referee."""
    now, velocity = split(train, state), centres(train, state)[1]
    bodies = sum(
        0.5 * unit.mass * v @ v + 0.5 * unit.yaw_inertia * r**2
        for unit, v, r in zip(train.units, velocity, now.yaw_rate, strict=True)
    )
    spinning = [wheel.count * wheel.spin_inertia for _, wheel in train.placed if wheel.spin_inertia]
    return float(bodies + 0.5 * np.array(spinning) @ now.spin**2)


def centres(train: PlanarTrain, state: Array) -> tuple[Array, Array]:
    """Places and velocities of the units' centres, inertial, with complex numbers for plane vectors: (n, 2) each."""
    now = split(train, state)
    place, velocity = [complex(*now.position)], [complex(*now.velocity) * np.exp(1j * now.yaw[0])]
    for k, (ahead, behind) in enumerate(zip(train.units, train.units[1:], strict=False)):
        arms = (ahead.rear or 0.0) * np.exp(1j * now.yaw[k]), (behind.front or 0.0) * np.exp(1j * now.yaw[k + 1])
        place.append(place[k] + arms[0] - arms[1])
        velocity.append(velocity[k] + 1j * now.yaw_rate[k] * arms[0] - 1j * now.yaw_rate[k + 1] * arms[1])
    both = np.array([place, velocity])
    places, velocities = np.stack([both.real, both.imag], axis=-1)
    return places, velocities
