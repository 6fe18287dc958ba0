"""From a file to a vehicle: read, validate, draft, set parameters; every mistake at once."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path as FilePath
from typing import Any, cast

from eom.errors import DescriptionError, Mistake
from eom.vehicle.description import Description
from eom.vehicle.draft import (
    ORIGIN,
    ZERO,
    Draft,
    Site,
    X,
    declare_parameters,
    draft_body,
    draft_connector,
    draft_load,
)
from eom.vehicle.elements import GROUND, Constraint, System
from eom.vehicle.expression import Expression, Name, Number, evaluate, names
from eom.vehicle.mirror import with_mirror_images
from eom.vehicle.quantity import parse_quantity
from eom.vehicle.registry import Live, Registry
from eom.vehicle.signals import draft_actuator, draft_sensor
from eom.vehicle.source import Path, Source, read_source
from eom.vehicle.train_draft import draft_train
from eom.vehicle.validate import did_you_mean, validate


@dataclass(frozen=True)
class Vehicle:
    """A described system with values for all its parameters; nothing in it changes.

    Attributes
    ----------
    name : str
        As the file says.
    file : str
        The file's name as given.
    digest : str
        SHA-256 of the file's text.
    description : Description
        The validated file.
    draft : Draft
        The system with expressions for numbers, and what is known by role.
    system : System
        The system with numbers, SI units.
    values : Mapping
        Value of every parameter, SI units: declared ones by name, literals as ``object.quantity``.
    """

    name: str
    file: str
    digest: str
    description: Description
    draft: Draft
    system: System
    values: Mapping[str, float]
    source: Source

    def mistake(self, obj: str, what: str) -> Mistake:
        """A mistake that points at a named object of the file, or at what it belongs to (``joint.row``)."""
        path = self.draft.names.get(obj) or self.draft.names.get(obj.split(".")[0], ())
        return self.source.mistake(path, what)


def load(path: str | FilePath, **overrides: str | float) -> Vehicle:
    """Read a vehicle file; any parameter can be overridden by keyword.

    Parameters
    ----------
    path : str or Path
        The YAML file.
    **overrides : str or float
        Values by parameter name, as numbers in SI units or texts such as ``"110 km/h"``. A literal of the file is
        a parameter too, named after its object: ``**{"tractor_frame.mass": "6.5 t"}``.

    Raises
    ------
    DescriptionError
        With every mistake of the file and the overrides.
    """
    try:
        raw = FilePath(path).read_bytes()
    except OSError as error:
        raise DescriptionError([Mistake(str(path), 0, 0, "", f"cannot be read: {error.strerror}")]) from None
    return loads(raw, str(path), **overrides)


def loads(text: str | bytes, file: str = "<text>", **overrides: str | float) -> Vehicle:
    """The vehicle that a text describes; see `load`."""
    raw = text.encode() if isinstance(text, str) else text
    try:
        source = read_source(raw.decode(), file)
    except UnicodeDecodeError as error:
        what = f"not readable as text: byte {error.start} is no UTF-8"
        raise DescriptionError([Mistake(file, 0, 0, "", what)]) from None
    description, broken = validate(source)
    if description is None:
        raise DescriptionError(source.mistakes)
    draft = make_draft(description, broken)
    source.mistakes += [Mistake(file, 0, 0, "", what) for what in override(draft.registry, overrides)]
    for where, what in draft.registry.mistakes:
        source.report(where, what)
    values = parameter_values(draft.registry, source)
    if source.mistakes:
        raise DescriptionError(source.mistakes)
    system = numbers(draft.system(), values, draft, source)
    for expression, where, what in draft.zeros:
        if abs(evaluate(expression, values)) > 1e-9:
            source.report(where, what)
    if source.mistakes:
        raise DescriptionError(source.mistakes)
    digest = hashlib.sha256(raw).hexdigest()
    return Vehicle(description.name, file, digest, description, draft, cast("System", system), values, source)


def make_draft(description: Description, broken: frozenset[str]) -> Draft:
    """The draft of a description; mistakes are left in its registry."""
    registry = Registry(broken=broken)
    declare_parameters(registry, description)
    trim = description.trim
    speed = ZERO if trim is None else registry.number(trim.speed, "trim.speed", ("trim", "speed"))
    draft = Draft(registry, speed)
    draft.gravity = gravity(registry, description)
    for name in description.tyres:
        draft.claim(name, ("tyres", name))
    for name, (written, body) in mirrored(draft, description, "bodies").items():
        draft_body(draft, name, body, ("bodies", written))
    draft_train(draft, description)
    for name, (written, connector) in mirrored(draft, description, "connectors").items():
        draft_connector(draft, dict(description.tyres), name, connector, ("connectors", written), Site())
    for name, (written, item) in mirrored(draft, description, "loads").items():
        draft_load(draft, name, item, ("loads", written))
    for name, (written, actuator) in mirrored(draft, description, "actuators").items():
        draft_actuator(draft, name, actuator, ("actuators", written))
    for name, (written, sensor) in mirrored(draft, description, "sensors").items():
        draft_sensor(draft, name, sensor, ("sensors", written))
    if not draft.bodies and not broken:
        registry.report((), "describes no body: give 'bodies' or 'units'")
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


def override(registry: Registry, overrides: Mapping[str, str | float]) -> list[str]:
    """Replace the values of named parameters; what cannot be replaced is returned as sentences."""
    mistakes = []
    for name, value in overrides.items():
        live = registry.parameters.get(name)
        if live is None:
            guess = did_you_mean(name, registry.parameters)
            mistakes.append(f"cannot set '{name}': there is no such parameter{guess}")
            continue
        try:
            quantity = parse_quantity(value, live.unit)
            if live.unit == "*" and None not in {live.dimension, quantity.dimension}:
                check_same(live, quantity.dimension, value)
            for needed in names(quantity.expression):
                check_known(needed, registry)
        except ValueError as error:
            mistakes.append(f"cannot set '{name}': {error}")
            continue
        registry.parameters[name] = replace(live, default=quantity.expression)
    return mistakes


def check_known(name: str, registry: Registry) -> None:
    """An override's expression may refer to the file's parameters."""
    if name not in registry.parameters:
        message = f"unknown parameter '{name}'{did_you_mean(name, registry.parameters)}"
        raise ValueError(message)


def check_same(live: Live, dimension: object, value: object) -> None:
    """An override must have the dimension of the value that it replaces."""
    if dimension != live.dimension:
        message = f"'{value}' has another dimension than the file's value"
        raise ValueError(message)


def parameter_values(registry: Registry, source: Source) -> dict[str, float]:
    """Values of all parameters, each after those that it is computed from; cycles and bounds are reported."""
    values: dict[str, float] = {}
    state: dict[str, str] = {}

    def settle(name: str, trail: tuple[str, ...]) -> None:
        live = registry.parameters[name]
        if state.get(name) == "open":
            ring = " -> ".join((*trail[trail.index(name) :], name))
            source.report(live.path, f"is computed from itself: {ring}")
            return
        if name in state:
            return
        state[name] = "open"
        for needed in names(live.default):
            if needed in registry.parameters:
                settle(needed, (*trail, name))
        state[name] = "done"
        if all(needed in values for needed in names(live.default)):
            try:
                values[name] = evaluate(live.default, values)
            except ValueError as error:
                source.report(live.path, str(error))

    for name in registry.parameters:
        settle(name, ())
    for name, live in registry.parameters.items():
        check_bounds(name, live, values, source)
    return values


def check_bounds(name: str, live: Live, values: Mapping[str, float], source: Source) -> None:
    """Report a value outside its bounds."""
    for bound, word, sign in ((live.minimum, "least", -1.0), (live.maximum, "most", 1.0)):
        if bound is None or name not in values or any(needed not in values for needed in names(bound)):
            continue
        try:
            limit = evaluate(bound, values)
        except ValueError as error:
            source.report(live.path, str(error))
            continue
        if sign * (values[name] - limit) > 0.0:
            source.report(live.path, f"is {values[name]:g}, but at {word} {limit:g} is allowed (SI units)")


def numbers(item: object, values: Mapping[str, float], draft: Draft, source: Source, owner: str = "") -> object:
    """The same structure with every expression evaluated; failures are reported at the object they belong to."""
    if isinstance(item, Expression):
        try:
            return evaluate(item, values)
        except ValueError as error:
            path: Path = draft.names.get(owner.split(".")[0], ())
            source.report(path, AT_REST if stands_still(item, draft, values) else str(error))
            return 0.0
    if isinstance(item, tuple):
        own = getattr(item, "name", "") or getattr(getattr(item, "connection", None), "name", "") or owner
        parts = [numbers(part, values, draft, source, own) for part in item]
        return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
    return item


AT_REST = "needs a moving trim: slip and sideslip are angles against the trim speed, which is zero"


def stands_still(expression: Expression, draft: Draft, values: Mapping[str, float]) -> bool:
    """Whether an expression has to do with a trim speed that is zero."""
    speed = cast("Expression", draft.speed)
    return evaluate(speed, values) == 0.0 and (
        isinstance(speed, Number) or set(names(speed)) <= set(names(expression))
    )
