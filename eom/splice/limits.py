"""What a model of small roll and articulation must watch: where it ends, and what the vehicle does there."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.splice.outputs import Signals
from eom.splice.signals import units_of
from eom.splice.state import Evaluation, Model
from eom.splice.wheels import free_loads
from eom.tyre.contact import rolling_sense
from eom.vehicle.elements import System

SMALL_ARTICULATION, SMALL_ROLL = np.radians(15.0), np.radians(10.0)
"""Angles [rad] beyond which the displacements are not small any more."""
JACKKNIFE = np.radians(30.0)
"""Rate of articulation [rad/s] of a train that folds up; lane changes stay below 15 deg/s."""
STRAIGHT = np.radians(1.0)
"""Articulation [rad] about which a train has no side to fold to."""
SLOW = 1.0
"""Forward speed [m/s] below which no wheel counts as locked, by degrees."""
LOCKED = 0.05
"""Share of the forward speed that is left to the tread of a wheel that locks."""


FOLDED, OVERTURNED = np.radians(60.0), np.radians(30.0)
"""Articulation and roll [rad] beyond which the model means nothing any more."""
STANDING = 0.1
"""Forward speed [m/s] of a vehicle that stands: there brakes fade."""


class Limit(NamedTuple):
    """Something to watch: it happens when its margin becomes negative.

    ``kind`` names it, ``owner`` the object; ``ends`` tells that a run means nothing beyond it.
    """

    kind: str
    owner: str
    sentence: str
    ends: bool = False


def limits(system: System) -> tuple[Limit, ...]:
    """All that is watched of a vehicle, in the order of `all_margins`."""
    units = units_of(system)
    towed = [unit.name for unit in units[1:]]
    found = [
        Limit("articulation", name, "its articulation exceeds 15 deg: forces are turned rightly, levers are not")
        for name in towed
    ]
    found += [Limit("jackknife", name, "its articulation grows faster than 30 deg/s: it folds up") for name in towed]
    found += [
        Limit("roll", body.name, "its roll exceeds 10 deg, where roll is not small any more") for body in system.bodies
    ]
    found += [
        Limit("jackknife", name, "its articulation exceeds 60 deg: it has folded up", ends=True) for name in towed
    ]
    found += [
        Limit("rollover", body.name, "its roll exceeds 30 deg: it has rolled over", ends=True) for body in system.bodies
    ]
    found += [Limit("standstill", units[0].name, "it stands still")]
    found += [Limit("lift", wheel.name, "it lifts off the road and carries nothing") for wheel in system.wheels]
    found += [
        Limit("lock", wheel.name, "it locks: its tread moves at less than 5 % of its forward speed")
        for wheel in system.wheels
        if wheel.spin_inertia > 0.0
    ]
    found += [
        Limit("traction", wheel.name, "its torque asks for more along the road than its load: without a spin it slides")
        for wheel in system.wheels
        if wheel.spin_inertia == 0.0 and wheel.radius > 0.0
    ]
    if any(wheel.name != wheel.axle for wheel in system.wheels):
        found += [
            Limit(
                "rollover",
                unit.name,
                "all its wheels of one side are off the road: units that it is coupled to hold it, or it rolls over",
            )
            for unit in units
        ]
    return tuple(found)


def all_margins(evaluation: Evaluation, p: Model, s: Signals) -> Any:
    """How far each of `limits` is away; negative beyond it."""
    _, at, slip, found = evaluation
    c = p.contact
    yaw, yaw_rate = at.displaced[5::6][s.leads], at.w[5::6][s.leads]
    angle, rate = np.diff(yaw), np.diff(yaw_rate)
    forward = slip.forward[c.spinning]
    # along the way the wheel moves; a wheel that stands locks nothing
    sense = rolling_sense(forward, SLOW)
    tread = sense * (slip.omega[c.spinning] * c.radius[c.spinning] - LOCKED * forward) + SLOW * (1.0 - sense * sense)
    free = free_loads(at, found.assumed, p)
    parts: list[NDArray[np.float64]] = [
        SMALL_ARTICULATION - np.abs(angle),
        JACKKNIFE - rate * angle / np.sqrt(angle * angle + STRAIGHT * STRAIGHT),
        SMALL_ROLL - np.abs(at.displaced[3::6]),
        FOLDED - np.abs(angle),
        OVERTURNED - np.abs(at.displaced[3::6]),
        np.abs(at.local[:1]) - STANDING,
        free,
        tread,
        (found.load - np.abs(found.forces[0]))[c.passing],
    ]
    if np.any(s.side):
        parts.append(standing(free, s))
    return np.concatenate(parts)


def standing(free: Any, s: Signals) -> Any:
    """Largest load of each unit's wheels on the side that carries less; negative when all of that side have lifted."""
    sides = [np.where(s.units * (s.side == side) > 0.0, free, -np.inf).max(axis=1) for side in (1.0, -1.0)]
    return np.where(np.isinf(np.minimum(*sides)), 1.0, np.minimum(*sides))


def happened(found: Sequence[Limit], margin: Any) -> tuple[Limit, ...]:
    """Those limits that are reached."""
    return tuple(limit for limit, value in zip(found, margin, strict=True) if value < 0.0)
