"""Inputs and outputs: those that follow from the train by role, and the file's actuators and sensors."""

from collections.abc import Iterable

from eom.vehicle import parts
from eom.vehicle.draft import ONE, ORIGIN, ZERO, Draft, UnitDraft, X, Y, Z
from eom.vehicle.elements import GROUND, Connection, Input, Output, Vector
from eom.vehicle.source import Path
from eom.vehicle.validate import did_you_mean

UNITS = {
    ("along", "position"): "m",
    ("along", "velocity"): "m/s",
    ("along", "acceleration"): "m/s^2",
    ("about", "position"): "rad",
    ("about", "velocity"): "rad/s",
    ("about", "acceleration"): "rad/s^2",
}


def along(draft: Draft, body: int, axis: Vector, place: Vector | None = None) -> Connection:
    """Translation of a place of a body (its centre if not given) against the ground."""
    where = place or (ORIGIN if body == GROUND else draft.bodies[body].centre)
    return draft.connection("", (body, GROUND), where, forces=1, force_axis=axis)


def about(draft: Draft, body: int, axis: Vector) -> Connection:
    """Rotation of a body against the ground."""
    place = ORIGIN if body == GROUND else draft.bodies[body].centre
    return draft.connection("", (body, GROUND), place, moments=1, moment_axis=axis)


def unit_mass(draft: Draft, unit: UnitDraft) -> float:
    """Whole mass of a unit."""
    masses = [draft.bodies[body].mass for body in unit.bodies.values()]
    total = masses[0]
    for mass in masses[1:]:
        total = total + mass
    return total


def whole_mass_terms(draft: Draft, unit: UnitDraft, axis: Vector) -> tuple[tuple[float, Connection], ...]:
    """Translation of a unit's whole-mass centre: its bodies' centres, each with its share of the mass."""
    total = unit_mass(draft, unit)
    bodies = list(unit.bodies.values())
    if len(bodies) == 1:
        return ((ONE, along(draft, bodies[0], axis)),)
    return tuple((draft.bodies[body].mass / total, along(draft, body, axis)) for body in bodies)


def draft_train_outputs(draft: Draft, rolling_bodies: Iterable[str], front: Connection | None) -> None:
    """Outputs by role: accelerations, yaw rates, sideslips, articulations and rolls of the units' bodies.

    *front* is the roll-axis point above the front axle.
    """
    outputs = draft.outputs
    for unit in draft.units:
        terms = whole_mass_terms(draft, unit, Y)
        outputs.append(Output(f"{unit.name}.ay", "m/s^2", "acceleration", "inertial", terms))
    if front is not None:
        outputs.append(Output("axle_1.ay", "m/s^2", "acceleration", "inertial", ((ONE, front),)))
    for unit in draft.units:
        heading = about(draft, lead_body(unit), Z)
        outputs.append(Output(f"{unit.name}.yaw_rate", "rad/s", "velocity", "body", ((ONE, heading),)))
    for unit in draft.units:
        terms = tuple((weight / draft.speed, item) for weight, item in whole_mass_terms(draft, unit, Y))
        outputs.append(Output(f"{unit.name}.sideslip", "rad", "velocity", "body", terms))
    for ahead, unit in zip(draft.units, draft.units[1:], strict=False):
        angle = draft.connection(
            "", (lead_body(unit), lead_body(ahead)), draft.bodies[lead_body(unit)].centre, moments=1, moment_axis=Z
        )
        outputs.append(Output(f"{unit.name}.articulation", "rad", "position", "inertial", ((ONE, angle),)))
    for name in rolling_bodies:
        roll = about(draft, draft.index[name], X)
        outputs.append(Output(f"{name}.roll", "rad", "position", "inertial", ((ONE, roll),)))


def lead_body(unit: UnitDraft) -> int:
    """A unit's first body, whose heading is the unit's."""
    return next(iter(unit.bodies.values()))


def draft_actuator(draft: Draft, name: str, item: parts.Actuator, path: Path) -> None:
    """Add an input of the file."""
    registry = draft.registry
    draft.claim(name, path)
    body = draft.body(item.body, (*path, "body"))
    reaction = draft.body(item.reaction_on, (*path, "reaction_on"))
    if item.body == item.reaction_on:
        registry.report((*path, "body"), "pushes a body against itself")
    connection = signal_connection(draft, name, item, (body, reaction), path)
    gain = ONE if item.gain is None else registry.number(item.gain, f"{name}.gain", (*path, "gain"))
    rate_gain = (
        ZERO if item.rate_gain is None else registry.number(item.rate_gain, f"{name}.rate_gain", (*path, "rate_gain"))
    )
    default = "N" if item.along is not None else "N*m"
    unit = item.unit or ("" if item.gain is not None or item.rate_gain is not None else default)
    draft.inputs.append(Input(name, unit, connection, (gain,), (rate_gain,)))


def signal_connection(draft: Draft, name: str, item: parts.Signal, bodies: tuple[int, int], path: Path) -> Connection:
    """The one-directional connection of an actuator or sensor."""
    place = ORIGIN if bodies[0] == GROUND else draft.bodies[bodies[0]].centre
    if item.at is not None:
        place = draft.registry.place(item.at, f"{name}.at", (*path, "at"))
    if item.about is not None:
        axis = draft.registry.axis(item.about, (*path, "about"))
        return draft.connection(name, bodies, place, moments=1, moment_axis=axis)
    axis = Z if item.along is None else draft.registry.axis(item.along, (*path, "along"))
    return draft.connection(name, bodies, place, forces=1, force_axis=axis)


def draft_sensor(draft: Draft, name: str, item: parts.Sensor, path: Path) -> None:
    """Add an output of the file."""
    registry = draft.registry
    draft.claim(name, path)
    terms: tuple[tuple[float, Connection], ...]
    if item.centre_of is not None and item.along is not None:
        axis = registry.axis(item.along, (*path, "along"))
        unit = next((unit for unit in draft.units if unit.name == item.centre_of), None)
        if unit is None:
            known = [unit.name for unit in draft.units]
            if not registry.excuses(item.centre_of):
                what = f"unknown unit '{item.centre_of}'{did_you_mean(item.centre_of, known)}"
                registry.report((*path, "centre_of"), what)
            return
        other = draft.body(item.relative_to, (*path, "relative_to"))
        if not unit.bodies:
            return
        terms = tuple(
            (weight, connection._replace(bodies=(connection.bodies[0], other)))
            for weight, connection in whole_mass_terms(draft, unit, axis)
        )
    else:
        body = draft.body(item.body or "", (*path, "body"))
        other = draft.body(item.relative_to, (*path, "relative_to"))
        if item.body == item.relative_to:
            registry.report((*path, "body"), "measures a body against itself")
        terms = ((ONE, signal_connection(draft, name, item, (body, other), path)),)
    unit_text = UNITS["along" if item.along is not None else "about", item.measure]
    if item.gain is not None:
        gain = registry.number(item.gain, f"{name}.gain", (*path, "gain"))
        terms = tuple((gain * weight, connection) for weight, connection in terms)
        unit_text = ""
    draft.outputs.append(
        Output(name, item.unit or unit_text, item.measure, item.frame, terms, feedthrough(draft, name, item, path))
    )


def feedthrough(draft: Draft, name: str, item: parts.Sensor, path: Path) -> tuple[tuple[str, float], ...]:
    """The sensor's direct gains, their inputs checked."""
    known = [signal.name for signal in draft.inputs] + wheel_inputs(draft)
    result = []
    for signal, gain in item.feedthrough.items():
        here = (*path, "feedthrough", signal)
        if signal in known:
            result.append((signal, draft.registry.number(gain, f"{name}.feedthrough.{signal}", here)))
        elif not draft.registry.broken:
            draft.registry.report(here, f"unknown input '{signal}'{did_you_mean(signal, known)}")
    return tuple(result)


def wheel_inputs(draft: Draft) -> list[str]:
    """Names of the inputs that wheels have where tyres are no linear slip: steer angles, brake pressures, drive."""
    if not draft.rich:
        return []
    steers = dict.fromkeys(wheel.steer for wheel in draft.contacts if wheel.steer)
    pressures = [f"{wheel.name}.brake_pressure" for wheel in draft.contacts if wheel.brake_gain is not ZERO]
    return [*steers, *pressures, *(["drive_torque"] if draft.driven else [])]
