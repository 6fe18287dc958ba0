"""Values for a draft's parameters: overrides, order of computation, bounds, and the system with numbers."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

from eom.errors import Mistake
from eom.vehicle.draft import Draft
from eom.vehicle.elements import System
from eom.vehicle.expression import Expression, evaluate, names
from eom.vehicle.quantity import parse_quantity
from eom.vehicle.registry import Live, Registry
from eom.vehicle.source import Path, Source
from eom.vehicle.units import Dimension, parse_unit, show_dimension, stated_in
from eom.vehicle.validate import did_you_mean

MAX_RING = 8


def override(registry: Registry, overrides: Mapping[str, str | float]) -> list[str]:
    """Replace the values of named parameters; what cannot be replaced is returned as sentences."""
    mistakes = []
    for name, value in overrides.items():
        live = registry.parameters.get(name)
        if live is None:
            mistakes.append(f"cannot set '{name}': {why_unknown(name, registry)}")
            continue
        try:
            quantity = parse_quantity(value, live.unit)
            for needed in names(quantity.expression):
                check_known(needed, registry)
            wanted = live.dimension if live.unit == "*" else parse_unit(live.unit)[1]
            check_same(wanted, quantity.dimension or registry.dimension(quantity.expression), value)
        except ValueError as error:
            mistakes.append(f"cannot set '{name}': {error}")
            continue
        registry.parameters[name] = replace(live, default=quantity.expression, overridden=True)
    return mistakes


def why_unknown(name: str, registry: Registry) -> str:
    """Why a name cannot be set, and what can be instead."""
    if name in registry.computed:
        return f"it is computed from {', '.join(registry.computed[name]) or 'numbers'}"
    return f"there is no such parameter{did_you_mean(name, registry.parameters)}"


def check_known(name: str, registry: Registry) -> None:
    """An override's expression may refer to the file's parameters."""
    if name not in registry.parameters:
        message = f"unknown parameter '{name}'{did_you_mean(name, registry.parameters)}"
        raise ValueError(message)


def check_same(wanted: Dimension | None, given: Dimension | None, value: object) -> None:
    """An override must have the dimension of the value that it replaces, where both are known."""
    if wanted is not None and given is not None and given != wanted:
        message = f"'{value}' is {stated_in(given)}, expected {show_dimension(wanted)}"
        raise ValueError(message)


def parameter_values(registry: Registry, source: Source) -> dict[str, float]:
    """Values of all parameters, each after those that it is computed from; cycles and bounds are reported."""
    values: dict[str, float] = {}
    needed = {
        name: [part for part in names(live.default) if part in registry.parameters]
        for name, live in registry.parameters.items()
    }
    order, rings = in_order(needed)
    for ring in rings:
        blame(source, ring[0], registry.parameters[ring[0]], f"is computed from itself: {show_ring(ring)}")
    for name in order:
        live = registry.parameters[name]
        if all(part in values for part in names(live.default)):
            try:
                values[name] = evaluate(live.default, values)
            except ValueError as error:
                blame(source, name, live, str(error))
    for name, live in registry.parameters.items():
        check_bounds(name, live, values, source)
    return values


def in_order(needed: Mapping[str, Sequence[str]]) -> tuple[list[str], list[list[str]]]:
    """All names, each after those that it needs, and the rings of names that need each other.

    Written without recursion, whose depth a file could exhaust.
    """
    order: list[str] = []
    rings: list[list[str]] = []
    done: set[str] = set()
    for root in needed:
        trail = [root]
        pending = [iter(needed[root])]
        while trail and root not in done:
            part = next(pending[-1], None)
            if part is None:
                pending.pop()
                done.add(trail[-1])
                order.append(trail.pop())
            elif part in trail:
                rings.append([*trail[trail.index(part) :], part])
            elif part not in done:
                trail.append(part)
                pending.append(iter(needed[part]))
    return order, rings


def blame(source: Source, name: str, live: Live, what: str) -> None:
    """Report a value where it stands in the file, or by name if it was set from outside."""
    if live.overridden:
        source.mistakes.append(Mistake(source.file, 0, 0, "", f"cannot set '{name}': it {what}"))
    else:
        source.report(live.path, what)


def show_ring(ring: list[str]) -> str:
    """A cycle of names, its middle left out if it is long."""
    return " -> ".join(ring if len(ring) <= MAX_RING else [*ring[:3], "...", *ring[-2:]])


def check_bounds(name: str, live: Live, values: Mapping[str, float], source: Source) -> None:
    """Report a value outside its bounds."""
    for bound, word, sign in ((live.minimum, "least", -1.0), (live.maximum, "most", 1.0)):
        if bound is None or name not in values or any(needed not in values for needed in names(bound)):
            continue
        try:
            limit = evaluate(bound, values)
        except ValueError:
            # check_expressions reports it where it stands
            continue
        if sign * (values[name] - limit) > 0.0:
            blame(source, name, live, f"is {values[name]:g}, but at {word} {limit:g} is allowed (SI units)")


def check_expressions(registry: Registry, values: Mapping[str, float], source: Source) -> None:
    """Report, where it stands, every expression that has no value."""
    for expression, path in registry.expressions:
        if path and all(name in values for name in names(expression)):
            try:
                evaluate(expression, values)
            except ValueError as error:
                source.report(path, str(error))


def check_floors(registry: Registry, values: Mapping[str, float], source: Source) -> None:
    """Report every value that is negative, or zero, where it must not be."""
    for expression, path, zero in registry.floors:
        try:
            value = evaluate(expression, values)
        except (KeyError, ValueError):
            # reported where it stands
            continue
        if value < 0.0 or (value == 0.0 and not zero):
            source.report(path, f"is {value:g}: expected {'no less' if zero else 'more'} than zero")


def with_entries(item: object, entry: Callable[[Expression, str], object]) -> object:
    """The same structure with every expression replaced by what *entry* makes of it and of its object's name.

    What occurs in several places is made once.
    """
    made: dict[int, object] = {}

    def copy(part: object, owner: str) -> object:
        if id(part) in made:
            return made[id(part)]
        result = part
        if isinstance(part, Expression):
            result = entry(part, owner)
        elif isinstance(part, tuple):
            own = getattr(part, "name", "") or getattr(getattr(part, "connection", None), "name", "") or owner
            parts: list[Any] = [copy(inner, own) for inner in part]
            result = type(part)(*parts) if hasattr(part, "_fields") else tuple(parts)
        made[id(part)] = result
        return result

    return copy(item, "")


def numbers(system: System, values: Mapping[str, float], draft: Draft, source: Source) -> System:
    """The system with every expression evaluated; a slip at zero speed is reported at its object."""

    def number(expression: Expression, owner: str) -> float:
        try:
            return evaluate(expression, values)
        except ValueError as error:
            path: Path = draft.names.get(owner.split(".", maxsplit=1)[0], ())
            at_rest = evaluate(cast("Expression", draft.speed), values) == 0.0
            source.report(path, AT_REST if at_rest else str(error))
            return 0.0

    return cast("System", with_entries(system, number))


AT_REST = "needs a moving trim: slip and sideslip are angles against the trim speed, which is zero"
