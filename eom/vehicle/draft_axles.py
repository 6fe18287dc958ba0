"""Axle groups and axles into a draft: supports, roll stiffness of tyres, tyres and wheels."""

from eom.vehicle.description import Description
from eom.vehicle.draft import ORIGIN, ZERO, Draft, UnitDraft, X, Y, add
from eom.vehicle.draft_connectors import draft_support
from eom.vehicle.draft_signals import along, lead_body
from eom.vehicle.draft_tyres import draft_tyre, find_tyre
from eom.vehicle.draft_wheels import Standing, draft_wheels
from eom.vehicle.elements import GROUND, Connection, Elastic
from eom.vehicle.source import Path
from eom.vehicle.train import Suspension, Unit
from eom.vehicle.validate import did_you_mean
from eom.vehicle.whole_axle import WholeAxle, WrongAxle, whole_axle


def draft_axle_group(draft: Draft, unit_draft: UnitDraft, key: str, unit: Unit, path: Path) -> None:
    """Add a group's vertical support and the roll stiffness of its tyres."""
    registry, scope = draft.registry, unit_draft.scope
    group, name = unit.axle_groups[key], f"{unit_draft.name}_{key}"
    draft.claim(name, path)
    body = unit_draft.bodies.get(group.body, GROUND)
    if group.support is not None:
        place = registry.place(group.support.at, f"{name}.support.at", (*path, "support", "at"), scope)
        draft_support(draft, name, body, add(unit_draft.origin, place), ("z",))
    if group.roll_stiffness is not None:
        stiffness = registry.number(group.roll_stiffness, f"{name}.roll_stiffness", (*path, "roll_stiffness"), scope)
        registry.not_negative(stiffness, (*path, "roll_stiffness"), zero=True)
        centre = draft.bodies[body].centre if body != GROUND else ORIGIN
        connection = draft.connection(f"{name}.tyres", (body, GROUND), centre, moments=1, moment_axis=X)
        draft.elastic.append(Elastic(connection, (ZERO, stiffness), (ZERO, ZERO)))


def draft_axle(
    draft: Draft,
    description: Description,
    unit_draft: UnitDraft,
    unit: Unit,
    key: str,
    fronts: list[Connection],
) -> None:
    """Add an axle's tyres and wheels; axles are numbered along the train."""
    registry, scope = draft.registry, unit_draft.scope
    name = f"axle_{len(draft.axles) + 1}"
    draft.claim(name, (*unit_draft.path, "axles", key))
    axle = whole_axle(unit.axles, key)
    if isinstance(axle, WrongAxle):
        draft.axles[name] = ""
        if not (axle.missing and registry.excuses(axle.missing)):
            registry.report((*unit_draft.path, *axle.path), axle.what)
        return
    draft.axles[name] = f"{unit_draft.name}_{axle.group}" if axle.group is not None else ""
    axle_path = (*unit_draft.path, "axles", key)
    bodies = carriers(draft, unit_draft, unit, axle)
    x = registry.number(axle.x, f"{name}.x", (*axle_path, "x"), scope)
    contact = add(unit_draft.origin, (x, ZERO, ZERO))
    # a template's argument may name the tyre
    registry.used.update({axle.tyre} & set(scope))
    tyre_name = getattr(scope.get(axle.tyre), "name", axle.tyre)
    tyre_path = (*unit_draft.path, "axles", axle.home["tyre"], "tyre")
    tyre = find_tyre(draft, description.tyres, tyre_name, tyre_path)
    if tyre is None or bodies is None or GROUND in bodies:
        return
    group = None if axle.group is None else unit.axle_groups[axle.group]
    if group is not None and group.support is not None and tyre.vertical_stiffness is not None:
        what = f"the tyre '{tyre_name}' carries vertically, and so does the 'support' of its group: keep one"
        registry.report(tyre_path, what)
    if not draft.rich:
        owner = (bodies[0], tyre_name, tyre)
        draft_tyre(draft, name, owner, contact, 2, tyre_path[:-1], steered=axle.steered)
    group_path = (*unit_draft.path, "axle_groups", axle.group or "")
    every = [whole_axle(unit.axles, other) for other in unit.axles]
    together = [other for other in every if isinstance(other, WholeAxle) and other.group == axle.group]
    draft_wheels(
        draft,
        Standing(
            name,
            axle,
            unit_draft.path,
            scope,
            bodies,
            contact,
            tyre_name,
            tyre,
            group,
            draft.axles[name],
            group_path,
            len(together),
            any(other.track is not None for other in together),
        ),
    )
    if group is None:
        fronts.append(along(draft, lead_body(unit_draft), Y, contact))
    else:
        height = roll_axis_above(draft, unit_draft, unit, group.body)
        fronts.append(along(draft, bodies[0], Y, add(contact, (ZERO, ZERO, height))))


def carriers(draft: Draft, unit_draft: UnitDraft, unit: Unit, axle: WholeAxle) -> tuple[int, int] | None:
    """Numbers of the left and the right body that carry an axle's wheels; None after a mistake."""
    registry, path = draft.registry, (*unit_draft.path, "axles")
    if axle.bodies is not None:
        here = (*path, axle.home["bodies"], "bodies")
        if "ground" in axle.bodies or axle.bodies[0] == axle.bodies[1]:
            registry.report(here, "names the two bodies that carry the left and the right wheel")
            return None
        left, right = (draft.body(body, (*here, k), unit_draft.bodies) for k, body in enumerate(axle.bodies))
        return left, right
    if axle.group is None:
        return None
    group = unit.axle_groups.get(axle.group)
    if group is None:
        if not registry.excuses(axle.group):
            what = f"unknown axle group '{axle.group}'{did_you_mean(axle.group, unit.axle_groups)}"
            registry.report((*path, axle.home["group"], "group"), what)
        return None
    body = unit_draft.bodies.get(group.body, GROUND)
    return body, body


def roll_axis_above(draft: Draft, unit_draft: UnitDraft, unit: Unit, body: str) -> float:
    """Height of the roll axis of the suspension that stands on a body, zero without one."""
    return next(
        (
            roll_axis_height(draft, unit_draft, key, item)
            for key, item in unit.suspensions.items()
            if item.between[1] == body
        ),
        ZERO,
    )


def roll_axis_height(draft: Draft, unit_draft: UnitDraft, key: str, item: Suspension) -> float:
    """Height of a suspension's roll axis above the ground."""
    name, path = f"{unit_draft.name}_{key}.roll_axis.height", (*unit_draft.path, "suspensions", key)
    return draft.registry.number(item.roll_axis.height, name, (*path, "roll_axis", "height"), unit_draft.scope)
