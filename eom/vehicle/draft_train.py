"""The train in a draft: units placed behind each other, their suspensions, axle groups, axles and couplings."""

from dataclasses import replace
from typing import cast

from eom.vehicle.description import Description
from eom.vehicle.draft import (
    ONE,
    ORIGIN,
    ZERO,
    Draft,
    Scope,
    Site,
    UnitDraft,
    X,
    Z,
    add,
    carried_directions,
    subtract,
)
from eom.vehicle.draft_axles import draft_axle, draft_axle_group, roll_axis_height
from eom.vehicle.draft_connectors import draft_connector
from eom.vehicle.draft_drive import count_wheels
from eom.vehicle.draft_parts import draft_body
from eom.vehicle.draft_signals import draft_train_outputs
from eom.vehicle.elements import GROUND, Connection, Constraint, Elastic, Input, Vector
from eom.vehicle.expression import Expression, Name
from eom.vehicle.mirror import with_mirror_images
from eom.vehicle.source import Path
from eom.vehicle.train import Coupling, Suspension, Unit, UnitUse, argument_name
from eom.vehicle.validate import did_you_mean


def draft_train(draft: Draft, description: Description) -> None:
    """Add all units and couplings, and the signals that follow from them."""
    units = {name: resolve_use(draft, description, name, item) for name, item in description.units.items()}
    places = coupling_places(draft, description, list(units))
    origin: Vector = ORIGIN
    for name, (unit, scope, path) in units.items():
        if name in places:
            ahead, own = places[name]
            origin = subtract(add(origin, ahead), own)
        draft_unit_bodies(draft, name, unit, UnitDraft(name, {}, origin, scope, path))
    for name, coupling in description.couplings.items():
        draft_coupling(draft, name, coupling, places)
    count_wheels(draft, description, [(unit, scope) for unit, scope, _ in units.values()])
    rolling: list[str] = []
    fronts: list[Connection] = []
    for unit_draft, (unit, _, _) in zip(draft.units, units.values(), strict=True):
        draft_unit(draft, description, unit_draft, unit, fronts)
        for key, item in unit.suspensions.items():
            rolling += draft_suspension(draft, unit_draft, key, item)
    moments = [
        signal
        for unit_draft, (unit, _, _) in zip(draft.units, units.values(), strict=True)
        for signal in roll_moments(draft, unit_draft, unit)
    ]
    draft.inputs += [*moments, *yaw_moments(draft, [unit for unit, _, _ in units.values()])]
    check_templates(draft, description)
    if draft.units and all(unit.bodies for unit in draft.units):
        draft_train_outputs(draft, dict.fromkeys(rolling), fronts[0] if fronts else None)


def check_templates(draft: Draft, description: Description) -> None:
    """Find needs that a template does not use, and, by drafting each for itself, mistakes of unused templates."""
    used = {item.use for item in description.units.values() if isinstance(item, UnitUse)}
    for name, template in description.templates.items():
        if name in used:
            for k, need in enumerate(template.needs):
                if need not in draft.registry.used and not draft.registry.broken:
                    draft.registry.report(("templates", name, "needs", k), f"nothing in the template uses '{need}'")
            continue
        registry = replace(
            draft.registry,
            parameters=dict(draft.registry.parameters),
            broken={*draft.registry.broken, *template.needs},
        )
        alone = Draft(registry, draft.speed, folder=draft.folder)
        count_wheels(alone, description, [(template, {})])
        unit_draft = UnitDraft(name, {}, ORIGIN, {}, ("templates", name))
        draft_unit_bodies(alone, name, template, unit_draft)
        draft_unit(alone, description, unit_draft, template, [])
        for key, item in template.suspensions.items():
            draft_suspension(alone, unit_draft, key, item)


def resolve_use(draft: Draft, description: Description, name: str, item: Unit | UnitUse) -> tuple[Unit, Scope, Path]:
    """A unit's own description, or its template with the arguments that it is used with."""
    if isinstance(item, Unit):
        return item, {}, ("units", name)
    registry, path = draft.registry, ("units", name)
    template = description.templates.get(item.use)
    if template is None:
        if not registry.excuses(item.use):
            known = description.templates
            registry.report((*path, "use"), f"unknown template '{item.use}'{did_you_mean(item.use, known)}")
            registry.broken.add(item.use)
        return Unit.model_construct(bodies={}), {}, path
    for need in template.needs:
        if need not in item.with_:
            registry.report((*path, "with"), f"needs '{need}', which the template '{item.use}' asks for")
            registry.broken.add(need)
    scope: Scope = {}
    for key, quantity in item.with_.items():
        here = (*path, "with", key)
        if key not in template.needs:
            guess = did_you_mean(key, template.needs)
            registry.report(here, f"the template '{item.use}' does not ask for '{key}'{guess}")
        bare = argument_name(quantity)
        if bare is not None and bare not in registry.parameters:
            scope[key] = Name(bare)
            choice = {*description.tyres, *registry.parameters}
            if bare not in description.tyres and not registry.excuses(bare):
                registry.report(here, f"unknown parameter or tyre '{bare}'{did_you_mean(bare, choice)}")
                registry.broken.add(bare)
        else:
            scope[key] = cast("Expression", registry.number(quantity, f"{name}.{key}", here))
    return template, scope, ("templates", item.use)


def coupling_places(draft: Draft, description: Description, order: list[str]) -> dict[str, tuple[Vector, Vector]]:
    """Per following unit its coupling's place in the frame of the unit ahead and in its own frame."""
    registry = draft.registry
    places: dict[str, tuple[Vector, Vector]] = {}
    for name, item in description.couplings.items():
        path: Path = ("couplings", name)
        draft.claim(name, path)
        unknown = [unit for unit in item.between if unit not in order]
        for unit in unknown:
            if not registry.excuses(unit):
                registry.report((*path, "between"), f"unknown unit '{unit}'{did_you_mean(unit, order)}")
        if unknown:
            continue
        ahead, following = item.between
        if order.index(following) != order.index(ahead) + 1:
            registry.report((*path, "between"), "a coupling joins a unit to the next one, named front to rear")
            continue
        if following in places:
            registry.report(path, f"'{following}' is coupled to '{ahead}' already")
        places[following] = (
            registry.place(item.at[ahead], f"{name}.at.{ahead}", (*path, "at", ahead)),
            registry.place(item.at[following], f"{name}.at.{following}", (*path, "at", following)),
        )
        difference = cast("Expression", places[following][0][2] - places[following][1][2])
        what = f"its places in {ahead} and {following} must be equally high above the ground"
        draft.zeros.append((difference, (*path, "at"), what))
    # a coupling that was refused may be the one that is missing
    complete = len(places) == len(description.couplings) and not registry.broken
    for unit in order[1:]:
        if unit not in places and complete:
            registry.report(("units", unit), "is not coupled to the unit ahead of it: add it to 'couplings'")
    return places


def draft_unit_bodies(draft: Draft, name: str, unit: Unit, unit_draft: UnitDraft) -> None:
    """Add a unit's bodies, named ``unit_body``."""
    draft.claim(name, ("units", name))
    if not (unit.bodies or draft.registry.broken):
        draft.registry.report((*unit_draft.path, "bodies"), "a unit has at least one body")
    path = (*unit_draft.path, "bodies")
    images = with_mirror_images(unit.bodies, lambda key, what: draft.registry.report((*path, key), what))
    for key, (written, body) in images.items():
        unit_draft.bodies[key] = len(draft.bodies)
        draft_body(draft, f"{name}_{key}", body, (*path, written), Site(unit_draft.origin, scope=unit_draft.scope))
    draft.units.append(unit_draft)


def draft_unit(
    draft: Draft, description: Description, unit_draft: UnitDraft, unit: Unit, fronts: list[Connection]
) -> None:
    """Add what stands between a unit and the ground: connectors, axle groups, axles."""
    site = Site(unit_draft.origin, unit_draft.bodies, unit_draft.scope)
    path = unit_draft.path
    images = with_mirror_images(
        unit.connectors, lambda key, what: draft.registry.report((*path, "connectors", key), what)
    )
    for key, (written, item) in images.items():
        name = f"{unit_draft.name}_{key}"
        draft_connector(draft, description.tyres, name, item, (*path, "connectors", written), site)
    for key, group in unit.axle_groups.items():
        draft_axle_group(draft, unit_draft, key, unit, (*path, "axle_groups", key))
        draft.body(group.body, (*path, "axle_groups", key, "body"), unit_draft.bodies)
    for key in unit.axles:
        draft_axle(draft, description, unit_draft, unit, key, fronts)


def suspension_bodies(draft: Draft, unit_draft: UnitDraft, key: str, item: Suspension) -> tuple[int, int]:
    """Numbers of the sprung and the unsprung body."""
    path = (*unit_draft.path, "suspensions", key, "between")
    sprung, unsprung = (draft.body(name, (*path, k), unit_draft.bodies) for k, name in enumerate(item.between))
    return sprung, unsprung


def draft_suspension(draft: Draft, unit_draft: UnitDraft, key: str, item: Suspension) -> list[str]:
    """Add a suspension: a hinge along the roll axis with roll stiffness and damping. Names its two bodies."""
    registry, scope, name = draft.registry, unit_draft.scope, f"{unit_draft.name}_{key}"
    path = (*unit_draft.path, "suspensions", key)
    draft.claim(name, path)
    bodies = suspension_bodies(draft, unit_draft, key, item)
    if "ground" in item.between or item.between[0] == item.between[1]:
        registry.report((*path, "between"), "a suspension stands between two bodies of its unit")
    if GROUND in bodies:
        return []
    height = roll_axis_height(draft, unit_draft, key, item)
    place = (draft.bodies[bodies[1]].centre[0], unit_draft.origin[1], height)
    hinge = draft.connection(name, bodies, place, forces=3, moments=2, moment_axis=X)
    draft.constraints.append(Constraint(hinge))
    k = registry.number(item.roll_stiffness, f"{name}.roll_stiffness", (*path, "roll_stiffness"), scope)
    c = (
        ZERO
        if item.roll_damping is None
        else registry.number(item.roll_damping, f"{name}.roll_damping", (*path, "roll_damping"), scope)
    )
    roll = draft.connection(f"{name}.roll", bodies, place, moments=1, moment_axis=X)
    draft.elastic.append(Elastic(roll, (ZERO, k), (ZERO, c)))
    return [draft.bodies[body].name for body in bodies]


def roll_moments(draft: Draft, unit_draft: UnitDraft, unit: Unit) -> list[Input]:
    """Active roll moment of each suspension, on the sprung body about +x and back on the unsprung one.

    Called ``unit.roll_moment``, or ``unit_suspension.roll_moment`` where the unit has several suspensions.
    """
    inputs = []
    for key, item in unit.suspensions.items():
        owner = unit_draft.name if len(unit.suspensions) == 1 else f"{unit_draft.name}_{key}"
        bodies = tuple(unit_draft.bodies.get(name, GROUND) for name in item.between)
        if GROUND not in bodies:
            pair = (bodies[0], bodies[1])
            place = draft.bodies[pair[0]].centre
            connection = draft.connection("", pair, place, moments=1, moment_axis=X)
            inputs.append(Input(f"{owner}.roll_moment", "N*m", connection, (ONE,), (ZERO,)))
    return inputs


def yaw_moments(draft: Draft, units: list[Unit]) -> list[Input]:
    """External yaw moment on each towed unit, on the body of its first axle group, positive to the left."""
    inputs = []
    for unit_draft, unit in list(zip(draft.units, units, strict=True))[1:]:
        carrier = next((group.body for group in unit.axle_groups.values()), next(iter(unit_draft.bodies), ""))
        body = unit_draft.bodies.get(carrier, GROUND)
        if body != GROUND:
            place = draft.bodies[body].centre
            connection = draft.connection("", (body, GROUND), place, moments=1, moment_axis=Z)
            inputs.append(Input(f"{unit_draft.name}.yaw_moment", "N*m", connection, (ONE,), (ZERO,)))
    return inputs


def draft_coupling(draft: Draft, name: str, item: Coupling, places: dict[str, tuple[Vector, Vector]]) -> None:
    """Add a coupling: what it locks, and its roll stiffness and damping. The first body is the towed one."""
    path: Path = ("couplings", name)
    by_name = {unit.name: unit for unit in draft.units}
    if item.between[1] not in places:
        return
    for unit in item.bodies:
        if unit not in item.between:
            draft.registry.report((*path, "bodies", unit), f"'{unit}' is not one of the coupled units")
    ahead, towed = (by_name[unit] for unit in item.between)
    bodies = tuple(
        draft.body(item.bodies[unit.name], (*path, "bodies", unit.name), unit.bodies)
        if unit.name in item.bodies
        else next(iter(unit.bodies.values()), GROUND)
        for unit in (towed, ahead)
    )
    pair = (bodies[0], bodies[1])
    place = add(towed.origin, places[towed.name][1])
    forces, force_axis = carried_directions(item.locked, ("x", "y", "z"))
    moments, moment_axis = carried_directions(item.locked, ("roll", "pitch", "yaw"))
    draft.couplings[name] = item.between
    locked = draft.connection(
        name,
        pair,
        place,
        forces=forces,
        force_axis=force_axis,
        moments=moments,
        moment_axis=moment_axis,
        upright=None if "yaw" in item.locked else Z,
    )
    draft.constraints.append(Constraint(locked))
    if item.elastic:
        k, c = (
            ZERO
            if (value := getattr(item, key)) is None
            else draft.registry.number(value, f"{name}.{key}", (*path, key))
            for key in ("roll_stiffness", "roll_damping")
        )
        roll = draft.connection(f"{name}.roll", pair, place, moments=1, moment_axis=X)
        draft.elastic.append(Elastic(roll, (ZERO, k), (ZERO, c)))
