"""A whole description into a draft."""

from pathlib import Path as FilePath
from typing import Any

from eom.vehicle.description import Description
from eom.vehicle.draft import ORIGIN, ZERO, Draft, Site, X
from eom.vehicle.draft_connectors import draft_connector
from eom.vehicle.draft_drive import draft_drive, draft_grade
from eom.vehicle.draft_laws import draft_law
from eom.vehicle.draft_parts import declare_parameters, draft_body, draft_load
from eom.vehicle.draft_signals import draft_actuator, draft_sensor
from eom.vehicle.draft_train import draft_train
from eom.vehicle.elements import GROUND, Constraint
from eom.vehicle.mirror import with_mirror_images
from eom.vehicle.registry import Registry


def make_draft(description: Description, broken: frozenset[str], folder: FilePath) -> Draft:
    """The draft of a description whose names of files start from a folder; mistakes are left in its registry."""
    registry = Registry(broken=set(broken))
    declare_parameters(registry, description)
    trim = description.trim
    speed = ZERO if trim is None else registry.number(trim.speed, "trim.speed", ("trim", "speed"))
    draft = Draft(registry, speed, folder=folder)
    draft.gravity = gravity(registry, description)
    for name, tyre in description.tyres.items():
        draft.claim(name, ("tyres", name))
        draft_law(draft, name, tyre)
    for name, (written, body) in mirrored(draft, description, "bodies").items():
        draft_body(draft, name, body, ("bodies", written), Site())
    draft_train(draft, description)
    draft_drive(draft, description)
    for name, (written, connector) in mirrored(draft, description, "connectors").items():
        draft_connector(draft, dict(description.tyres), name, connector, ("connectors", written), Site())
    for name, (written, item) in mirrored(draft, description, "loads").items():
        draft_load(draft, name, item, ("loads", written))
    for name, (written, actuator) in mirrored(draft, description, "actuators").items():
        draft_actuator(draft, name, actuator, ("actuators", written))
    for name, (written, sensor) in mirrored(draft, description, "sensors").items():
        draft_sensor(draft, name, sensor, ("sensors", written))
    draft_grade(draft, description)
    if trim is not None and trim.hold and draft.bodies:
        lead = draft.connection("trim.hold", (0, GROUND), draft.bodies[0].centre, forces=1, force_axis=X)
        draft.constraints.append(Constraint(lead, moving=True))
    return draft


def mirrored(draft: Draft, description: Description, collection: str) -> dict[str, tuple[str, Any]]:
    """A collection with its mirror images."""
    items: dict[str, Any] = getattr(description, collection)
    return with_mirror_images(items, lambda key, what: draft.registry.report((collection, key), what))


def gravity(registry: Registry, description: Description) -> tuple[float, float, float]:
    """Gravity as a vector: along -z if the file gives one number, none if it gives nothing."""
    match description.gravity:
        case None:
            return ORIGIN
        case tuple() as vector:
            return registry.place(vector, "gravity", ("gravity",))
        case quantity:
            down = registry.number(quantity, "gravity", ("gravity",))
            return ZERO, ZERO, -down
