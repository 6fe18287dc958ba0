"""A train in the plane as data: wheels, units, state, and what `planar_train` says of its motion."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from eom.tyre import Forces

Array = NDArray[np.float64]
TyreForces = Callable[[float, float, float, float, float], Forces]
"""Slip angle, longitudinal slip, load, camber and forward speed to forces of the road: `forces` of any `eom.tyre`."""


@dataclass(frozen=True, kw_only=True)
class PlanarWheel:
    """Equal wheels at one place.

    Attributes
    ----------
    x, y : float
        Place of the contact, and of the steering axis, m.
    radius : float
        Effective rolling radius, m.
    load : float
        Normal load of each wheel, N.
    tyre : TyreForces
        Of one wheel.
    spin_inertia : float
        Of each wheel, kg m^2. One without rolls along at kappa = 0, and the road passes on what its axle applies:
        Fx = (torque + My) / radius.
    steer_index : int or None
        Which of the steer angles turns it.
    count : int
        How many wheels stand there; each has this load and inertia, and the torque that is given.
    """

    x: float
    radius: float
    load: float
    tyre: TyreForces
    y: float = 0.0
    spin_inertia: float = 0.0
    steer_index: int | None = None
    count: int = 1


def no_drag(_: float) -> float:
    """No force whatever the speed."""
    return 0.0


@dataclass(frozen=True, kw_only=True)
class PlanarUnit:
    """A rigid unit, wheels included in its mass (kg) and its yaw inertia about the centre of mass (kg m^2).

    `front` and `rear` are x (m) of the pins to the units ahead and behind. `drag` gives the force (N) against the
    unit's x axis, at its centre of mass, by the velocity of that centre along the axis (m/s).
    """

    mass: float
    yaw_inertia: float
    wheels: tuple[PlanarWheel, ...] = ()
    front: float | None = None
    rear: float | None = None
    drag: Callable[[float], float] = no_drag


@dataclass(frozen=True)
class PlanarTrain:
    """Units front to rear."""

    units: tuple[PlanarUnit, ...]

    @property
    def placed(self) -> tuple[tuple[int, PlanarWheel], ...]:
        """All wheels with the index of their unit, unit by unit: the order of torques, spins and contacts."""
        return tuple((k, wheel) for k, unit in enumerate(self.units) for wheel in unit.wheels)

    @property
    def pins(self) -> tuple[tuple[float, float], ...]:
        """Of each pin its x on the unit ahead and on the unit behind, m."""
        ends = [(ahead.rear, behind.front) for ahead, behind in zip(self.units, self.units[1:], strict=False)]
        if any(end is None for pair in ends for end in pair):
            raise ValueError("expected a rear pin on each unit but the last, a front pin on each but the first")
        return tuple((float(rear or 0.0), float(front or 0.0)) for rear, front in ends)


class State(NamedTuple):
    """A state by its parts, in the order of the vector.

    `position` (2,) of the first unit's centre, inertial, m; `yaw` (n,) of each unit, not less that of the unit ahead;
    `velocity` (2,) of the first unit's centre in its own axes, m/s; `yaw_rate` (n,), rad/s; `spin` of the wheels that
    have spin inertia, in the order of all wheels, rad/s.
    """

    position: Array
    yaw: Array
    velocity: Array
    yaw_rate: Array
    spin: Array


class Contacts(NamedTuple):
    """Each wheel in its own axes, shape (wheels,): slips, velocity of the contact (m/s), force (N) and moments (N m).

    Forces are those of a single wheel where several stand at one place.
    """

    alpha: Array
    kappa: Array
    v_x: Array
    v_y: Array
    Fx: Array
    Fy: Array
    My: Array
    Mz: Array


class Motion(NamedTuple):
    """What a train does in a state.

    Attributes
    ----------
    velocity, acceleration : Array
        Of each unit's centre against the ground, (n, 2), forward and left in its own axes, m/s, m/s^2.
    yaw_acceleration : Array
        (n,), rad/s^2.
    spin_acceleration : Array
        Of the wheels that have spin inertia, rad/s^2.
    pin_force : Array
        On the unit behind by the unit ahead, (n - 1, 2), in the axes of the unit ahead, N.
    contacts : Contacts
    """

    velocity: Array
    acceleration: Array
    yaw_acceleration: Array
    spin_acceleration: Array
    pin_force: Array
    contacts: Contacts


def split(train: PlanarTrain, state: ArrayLike) -> State:
    """The parts of a state vector of 4 + 2 n + (wheels with spin inertia) numbers."""
    n = len(train.units)
    return State(*np.split(np.asarray(state, dtype=float), np.cumsum([2, n, 2, n])))


def straight_state(train: PlanarTrain, speed: float) -> Array:
    """Running straight along x, in line, the wheels rolling without slip."""
    n = len(train.units)
    spin = [speed / wheel.radius for _, wheel in train.placed if wheel.spin_inertia]
    return np.concatenate([np.zeros(2 + n), [speed, 0.0], np.zeros(n), spin])
