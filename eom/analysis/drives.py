"""A vehicle as a mechanism: which actuators drive it, which are locked, which bodies are held."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from eom.analysis.closed import Mechanism
from eom.assembly.vectors import Array
from eom.errors import DescriptionError, MechanismError
from eom.vehicle.elements import GROUND, Connection
from eom.vehicle.expression import evaluate
from eom.vehicle.load import Vehicle
from eom.vehicle.mirror import with_mirror_images
from eom.vehicle.quantity import parse_quantity
from eom.vehicle.validate import did_you_mean

MAX_POINTS = 10_000
End = str | float


class Drives(NamedTuple):
    """A mechanism with the values that its actuators are driven through.

    Attributes
    ----------
    mechanism : Mechanism
    names, units : tuple of str
        Driven actuators, and ``m`` or ``rad``.
    values : Array
        Prescribed values, shape (points, drives).
    """

    mechanism: Mechanism
    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array


def actuators(vehicle: Vehicle) -> dict[str, Connection]:
    """Every input that moves along or about one axis; not the steer of tyres, which is no motion of a body."""
    slip = {item.connection for item in vehicle.system.slip}
    return {
        item.name: item.connection._replace(name=item.name)
        for item in vehicle.system.inputs
        if item.connection.forces + item.connection.moments == 1 and item.connection not in slip
    }


def plan(
    vehicle: Vehicle,
    drive: Mapping[str, tuple[End, End]],
    hold: Sequence[str],
    free: Sequence[str],
    points: int,
) -> Drives:
    """The mechanism of a sweep; `MechanismError` with every mistake of the request."""
    known, mistakes = actuators(vehicle), []
    of_file = with_mirror_images(vehicle.description.actuators, lambda *_: None)
    bodies = {body.name: k for k, body in enumerate(vehicle.system.bodies)}
    for word, names, all_names in (
        ("drive", drive, known),
        ("free", free, of_file),
        ("hold", hold, bodies),
    ):
        what = "body" if word == "hold" else "actuator"
        there = ", ".join(all_names) or "none"
        mistakes += [
            f"{word} '{name}': unknown {what}{did_you_mean(name, all_names) or f'; there are: {there}'}"
            for name in names
            if name not in all_names
        ]
    mistakes += [f"free '{name}': it is driven" for name in free if name in drive]
    if not drive:
        mistakes.append(f"nothing is driven: name an actuator; there are: {', '.join(known) or 'none'}")
    if not 2 <= points <= MAX_POINTS:
        mistakes.append(f"points: expected 2 to {MAX_POINTS}, got {points}")
    ranges = np.zeros((0, 2))
    try:
        ranges = np.array([read_range(vehicle, name, drive[name], known[name]) for name in drive if name in known])
        if drive and not mistakes and np.all(ranges[:, 0] == ranges[:, 1]):
            mistakes.append("nothing moves: at least one range must lead from one value to another")
    except ValueError as error:
        mistakes += str(error).splitlines()
    mistakes += rolling_contacts(vehicle, {bodies[name] for name in hold if name in bodies})
    if mistakes:
        raise MechanismError("\n".join(f"{vehicle.file}: {what}" for what in mistakes))
    # the patch of a tyre lies on the road and takes no part in what its wheel does
    patches = frozenset(vehicle.draft.patches)
    held = frozenset(bodies[name] for name in hold) | patches
    still = {GROUND, *held}
    joints = [item.connection for item in vehicle.system.constraints if not item.moving]
    locked = [known[name] for name in of_file if name not in drive and name not in free]
    closed = [item for item in (*joints, *locked) if not (set(item.bodies) <= still or set(item.bodies) & patches)]
    mechanism = Mechanism(vehicle.system.bodies, closed, [known[name] for name in drive], held)
    units = tuple("m" if known[name].forces else "rad" for name in drive)
    return Drives(mechanism, tuple(drive), units, np.linspace(ranges[:, 0], ranges[:, 1], points))


def read_range(vehicle: Vehicle, name: str, ends: tuple[End, End], connection: Connection) -> list[float]:
    """Both ends of a range in SI units; ``ValueError`` with a sentence."""
    unit = "m" if connection.forces else "rad"
    values = []
    for text in ends:
        try:
            quantity = parse_quantity(text, unit)
            values.append(evaluate(quantity.expression, vehicle.values))
        except ValueError as error:
            message = f"drive '{name}': {error}"
            raise ValueError(message) from None
    return values


def rolling_contacts(vehicle: Vehicle, held: set[int]) -> list[str]:
    """Sentences for contacts of rolling wheels, whose finite motion the file does not tell."""
    return [
        f"'{item.connection.name}' is the contact of a rolling wheel, which a sweep does not follow: hold "
        f"'{vehicle.system.bodies[item.connection.bodies[0]].name}', or describe the wheel's support by a flex_point"
        for item in vehicle.system.constraints
        if item.connection.rolling_axis is not None and not set(item.connection.bodies) <= {GROUND, *held}
    ]


class Wheel(NamedTuple):
    """A wheel: its body, contact place [m] and radius [m] at the drawing; ``side`` is 1 left and -1 right."""

    name: str
    body: int
    contact: Array
    radius: float
    side: float


def wheels(vehicle: Vehicle, held: frozenset[int]) -> list[Wheel]:
    """The tyre connectors on bodies that are not held; `DescriptionError` where one lacks its radius."""
    places = {item.connection.name: item.connection for item in vehicle.system.slip}
    result, mistakes = [], []
    for name, (body, expression) in vehicle.draft.wheels.items():
        if body in held:
            continue
        radius = 0.0 if expression is None else evaluate(expression, vehicle.values)  # type: ignore[arg-type]
        contact = np.asarray(places[name].places[0], dtype=float)
        if expression is None:
            mistakes.append(vehicle.mistake(name, "needs 'radius' [m]: the sweep looks for the wheel's centre"))
        result.append(Wheel(name, body, contact, radius, 1.0 if contact[1] >= 0.0 else -1.0))
    if mistakes:
        raise DescriptionError(mistakes)
    return result
