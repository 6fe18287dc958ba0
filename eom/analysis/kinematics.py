"""The kinematic sweep: a mechanism's postures and measures while its actuators are driven."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from eom.analysis.closed import Factors, Mechanism
from eom.analysis.closure import Posture
from eom.analysis.continuation import Reached, advance, drives_locked
from eom.analysis.drives import Drives, End, Wheel, plan, wheels
from eom.analysis.measures import Measure, pair_measures, pair_name, sensor_measures, wheel_measures
from eom.analysis.rotation import matrix
from eom.analysis.wheels import wheel_state
from eom.assembly.matrices import DISPLACEMENTS
from eom.assembly.vectors import Array
from eom.errors import MechanismError
from eom.vehicle.load import Vehicle
from eom.vehicle.mirror import other_side


@dataclass(frozen=True)
class KinematicSweep:
    """What a mechanism does while it is driven; inertial axes, SI units and radians.

    Attributes
    ----------
    vehicle : Vehicle
    drives : dict
        Prescribed values by actuator.
    positions : Array
        Centres of mass, shape (points, bodies, 3) [m].
    rotations : Array
        Rotation matrices from the drawing, shape (points, bodies, 3, 3).
    motions : Array
        Velocity and angular velocity of every body, shape (points, bodies, 6), per unit of the sweep, which runs
        from 0 to 1 over the whole range.
    measures : dict
        By name: each wheel's ``travel``, ``camber``, ``toe``, ``steer``, ``contact_x``, ``contact_y``; each pair's
        ``track``, ``roll_centre_height``, ``roll_centre_y``; every position sensor.
    wheels, pairs : tuple of str
        Names that the measures start with.
    undriven : tuple of str
        Coordinates that nothing drives or locks; of their motion the smallest is taken.
    residuals : Array
        By how much the loops fail to close at each point [m].
    """

    vehicle: Vehicle
    drives: Mapping[str, Measure]
    positions: Array
    rotations: Array
    motions: Array
    measures: Mapping[str, Measure]
    wheels: tuple[str, ...]
    pairs: tuple[str, ...]
    undriven: tuple[str, ...]
    residuals: Array


class Point(NamedTuple):
    """One point of a sweep."""

    reached: Reached
    motion: Array


def kinematic_sweep(
    vehicle: Vehicle,
    drive: Mapping[str, tuple[End, End]],
    *,
    hold: Sequence[str] = (),
    free: Sequence[str] = (),
    points: int = 33,
) -> KinematicSweep:
    """Drive actuators of a vehicle through ranges, all together, and measure what its bodies do.

    Parameters
    ----------
    vehicle : Vehicle
    drive : mapping
        Actuator to its first and last value: numbers [m, rad] or texts such as ``"-80 mm"``. The value is the
        displacement along (the turn about) the actuator's axis from the drawing, whatever its gain.
    hold : sequence of str
        Bodies that stay where they are drawn.
    free : sequence of str
        Actuators that move as they like; all others of the file stay at zero.
    points : int
        Number of values, both ends included.

    Raises
    ------
    MechanismError
        With every mistake of the request; or, with the sweep so far as ``partial``, where the loops lock.
    DescriptionError
        Where a wheel has no radius.
    """
    drives = plan(vehicle, drive, hold, free, points)
    found = wheels(vehicle, drives.mechanism.held)
    if locked := drives_locked(drives.mechanism):
        names = ", ".join(drives.names)
        raise MechanismError(f"{vehicle.file}: drive {names}: cannot move from the drawing, locked by {locked}")
    reached, ends = follow(drives)
    if not reached:
        raise MechanismError("\n".join(f"{vehicle.file}: {what}" for what in ends))
    sweep = describe(vehicle, drives, found, reached)
    if ends:
        raise MechanismError("\n".join(f"{vehicle.file}: {what}" for what in ends), sweep)
    return sweep


def follow(drives: Drives) -> tuple[list[Reached], list[str]]:
    """Postures in the order of the sweep, and a sentence for each way that ended early."""
    values, mechanism = drives.values, drives.mechanism
    # the value nearest to the drawing comes first, then both ways from there
    span = np.maximum(np.max(np.abs(values), axis=0), 1e-300)
    nearest = int(np.argmin(np.sum((values / span) ** 2, axis=1)))
    drawn = Reached(Posture.drawn(len(mechanism.bodies)), np.zeros(values.shape[1]), 0.0)
    start = advance(mechanism, drawn, values[nearest])
    if start.end is not None:
        return [], [sentence(drives, start, values[nearest])]
    up, down, ends = [start], [start], []
    for way, targets in ((up, values[nearest + 1 :]), (down, values[:nearest][::-1])):
        for target in targets:
            following = advance(mechanism, way[-1], target)
            if following.end is not None:
                ends.append(sentence(drives, following, targets[-1]))
                break
            way.append(following)
    return [*down[:0:-1], *up], ends


def sentence(drives: Drives, reached: Reached, wanted: Array) -> str:
    """How far a way has led, and what locks it."""
    ways = ", ".join(
        f"'{name}' to {value:.6g} {unit} of {goal:.6g} {unit}"
        for name, unit, value, goal in zip(drives.names, drives.units, reached.values, wanted, strict=True)
    )
    return f"the loops lock on the way from the drawing: they let {ways}; locked by {reached.end}"


def describe(vehicle: Vehicle, drives: Drives, found: Sequence[Wheel], reached: Sequence[Reached]) -> KinematicSweep:
    """The sweep's result from its postures."""
    mechanism = drives.mechanism
    rates = drives.values[-1] - drives.values[0]
    points = [Point(item, mechanism.velocity(item.posture, item.values, rates)[0]) for item in reached]
    centres = np.array([body.centre for body in mechanism.bodies])
    states = {
        wheel.name: [wheel_state(vehicle.system.bodies, wheel, item.posture, motion) for item, motion in points]
        for wheel in found
    }
    pairs = [name for name in states if other_side(name) in states and states[name][0].contact[1] > 0.0]
    pairs = [name for name in pairs if name != other_side(name)]
    drawn = Posture.drawn(len(centres))
    factors = mechanism.velocity(drawn, 0.0 * rates, rates)[1]
    return KinematicSweep(
        vehicle=vehicle,
        drives={
            name: Measure(unit, np.array([item.values[k] for item in reached]))
            for k, (name, unit) in enumerate(zip(drives.names, drives.units, strict=True))
        },
        positions=np.array([centres + item.posture.offsets for item in reached]),
        rotations=np.array([[matrix(q) for q in item.posture.turns] for item in reached]),
        motions=np.array([motion.reshape(-1, 6) for _, motion in points]),
        measures={
            **{k: v for wheel in found for k, v in wheel_measures(wheel, states[wheel.name])},
            **{k: v for name in pairs for k, v in pair_measures(name, states[name], states[other_side(name)])},
            **dict(sensor_measures(vehicle, [item.posture for item in reached])),
        },
        wheels=tuple(states),
        pairs=tuple(map(pair_name, pairs)),
        undriven=undriven(mechanism, factors),
        residuals=np.array([item.residual for item in reached]),
    )


def undriven(mechanism: Mechanism, factors: Factors) -> tuple[str, ...]:
    """Names of coordinates whose motions nothing drives or locks, one for each of them."""
    null = factors.Vt[factors.rank :].copy()
    names = []
    for k in range(len(null)):
        rest = null[k:]
        row, column = divmod(int(np.argmax(np.abs(rest).round(9))), rest.shape[1])
        null[[k, k + row]] = null[[k + row, k]]
        null[k] /= null[k, column]
        null[k + 1 :] -= np.outer(null[k + 1 :, column], null[k])
        index = int(mechanism.free[column])
        names.append((index, f"{mechanism.bodies[index // 6].name}.{DISPLACEMENTS[index % 6]}"))
    return tuple(name for _, name in sorted(names))
