"""Connectors into a draft: joints, bushings, rods, springs, supports, tyres."""

from typing import cast

from eom.vehicle import parts
from eom.vehicle.connectors import (
    Connector,
    FlexPoint,
    Link,
    PointConnector,
    RigidPoint,
    RollingPoint,
    SlipDamper,
    Spring,
    Support,
    TyreConnector,
)
from eom.vehicle.draft import ZERO, Draft, Site, Y, Z, add, carried_directions
from eom.vehicle.elements import GROUND, Connection, Constraint, Elastic, Input, Slip, Vector
from eom.vehicle.expression import Number
from eom.vehicle.source import Path
from eom.vehicle.validate import did_you_mean


def draft_connector(
    draft: Draft, tyres: dict[str, parts.Tyre], name: str, item: Connector, path: Path, site: Site
) -> None:
    """Add a connector of any type."""
    draft.claim(name, path)
    match item:
        case RigidPoint() | RollingPoint() | FlexPoint():
            draft_point(draft, name, item, path, site)
        case Link() | Spring():
            draft_line(draft, name, item, path, site)
        case Support():
            place, body = standing(draft, name, item, path, site)
            draft_support(draft, name, body, place, item.carries)
        case SlipDamper():
            place, body = standing(draft, name, item, path, site)
            axis = draft.registry.axis(item.axis, (*path, "axis"), site.scope)
            c = draft.registry.number(item.damping, f"{name}.damping", (*path, "damping"), site.scope)
            coefficients = ((c,),) if item.forces == 1 else ((c, ZERO), (ZERO, c))
            connection = draft.connection(name, (body, GROUND), place, forces=item.forces, force_axis=axis)
            draft.slip.append(Slip(connection, coefficients))
        case TyreConnector():
            place, body = standing(draft, name, item, path, site)
            tyre = find_tyre(draft, tyres, item.tyre, (*path, "tyre"))
            draft.radii[name] = (
                None
                if item.radius is None
                else draft.registry.number(item.radius, f"{name}.radius", (*path, "radius"), site.scope)
            )
            if tyre is not None:
                draft_tyre(draft, name, (body, item.tyre, tyre), place, item.wheels, item.steered)


def standing(
    draft: Draft, name: str, item: Support | SlipDamper | TyreConnector, path: Path, site: Site
) -> tuple[Vector, int]:
    """Place and body of a connector that stands on the ground."""
    if item.body == "ground":
        draft.registry.report((*path, "body"), "stands on the ground already: name the body that it belongs to")
    place = add(site.origin, draft.registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
    return place, draft.body(item.body, (*path, "body"), site.bodies)


def draft_point(draft: Draft, name: str, item: RigidPoint | RollingPoint | FlexPoint, path: Path, site: Site) -> None:
    """Add a joint, a rolling joint or a bushing."""
    registry = draft.registry
    connection = point_connection(draft, name, item, path, site)
    match item:
        case RigidPoint():
            draft.constraints.append(Constraint(connection))
        case RollingPoint():
            draft.rolling.append(connection)
        case FlexPoint():
            stiffness, damping, angular_stiffness, angular_damping = (
                ZERO
                if (value := getattr(item, key)) is None
                else registry.number(value, f"{name}.{key}", (*path, key), site.scope)
                for key in ("stiffness", "damping", "angular_stiffness", "angular_damping")
            )
            draft.elastic.append(Elastic(connection, (stiffness, angular_stiffness), (damping, angular_damping)))


def point_connection(draft: Draft, name: str, item: PointConnector, path: Path, site: Site) -> Connection:
    """The connection of a point connector, its counts and axes checked."""
    registry = draft.registry
    if item.forces == item.moments == 0:
        registry.report(path, "acts on nothing: give 'forces', 'moments' or both")
    needs_axis = {item.forces, item.moments} & {1, 2}
    if needs_axis and item.axis is None:
        registry.report(path, "needs 'axis': one direction acts along it, two act normal to it")
    axis = Z if item.axis is None else registry.axis(item.axis, (*path, "axis"), site.scope)
    rolling = getattr(item, "rolling_axis", None)
    first, second = (draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(item.between))
    if item.between[0] == item.between[1]:
        registry.report((*path, "between"), f"connects '{item.between[0]}' with itself")
    return draft.connection(
        name,
        (first, second),
        add(site.origin, registry.place(item.at, f"{name}.at", (*path, "at"), site.scope)),
        forces=item.forces,
        force_axis=axis,
        moments=item.moments,
        moment_axis=axis,
        rolling_axis=rolling and registry.axis(rolling, (*path, "rolling_axis"), site.scope),
    )


def draft_line(draft: Draft, name: str, item: Link | Spring, path: Path, site: Site) -> None:
    """Add a rod, or a spring and damper, between two places."""
    registry = draft.registry
    first, second = (draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(item.between))
    if item.between[0] == item.between[1]:
        registry.report((*path, "between"), f"connects '{item.between[0]}' with itself")
    start, end = (
        add(site.origin, registry.place(place, f"{name}.end_{k + 1}", (*path, "ends", k), site.scope))
        for k, place in enumerate(item.ends)
    )
    connection = Connection(name, (first, second), (start, end), forces=1, line=True)
    if isinstance(item, Link):
        draft.constraints.append(Constraint(connection))
        return
    stiffness, damping = (
        ZERO
        if (value := getattr(item, key)) is None
        else registry.number(value, f"{name}.{key}", (*path, key), site.scope)
        for key in ("stiffness", "damping")
    )
    draft.elastic.append(Elastic(connection, (stiffness, ZERO), (damping, ZERO)))


def draft_support(draft: Draft, name: str, body: int, place: Vector, carries: tuple[str, ...]) -> None:
    """Add a support on the ground; its moments stay normal to the vertical and turn with the body's heading."""
    forces, force_axis = carried_directions(carries, ("x", "y", "z"))
    moments, moment_axis = carried_directions(carries, ("roll", "pitch", "yaw"))
    draft.supports[name] = tuple(carries)
    draft.constraints.append(
        Constraint(
            draft.connection(
                name,
                (body, GROUND),
                place,
                forces=forces,
                force_axis=force_axis,
                moments=moments,
                moment_axis=moment_axis,
                upright=Z,
            )
        )
    )


def find_tyre(draft: Draft, tyres: dict[str, parts.Tyre], name: str, path: Path) -> parts.Tyre | None:
    """The tyre of that name; reported if there is none."""
    if name in tyres:
        return tyres[name]
    if not draft.registry.excuses(name):
        draft.registry.report(path, f"unknown tyre '{name}'{did_you_mean(name, tyres)}")
    return None


def tyre_numbers(draft: Draft, name: str, tyre: parts.Tyre) -> tuple[float, float | None]:
    """Cornering stiffness and trail of a tyre."""
    registry, path = draft.registry, ("tyres", name)
    cornering = registry.number(tyre.cornering, f"{name}.cornering", (*path, "cornering"))
    trail = None if tyre.trail is None else registry.number(tyre.trail, f"{name}.trail", (*path, "trail"))
    return cornering, trail


def draft_tyre(
    draft: Draft, name: str, owner: tuple[int, str, parts.Tyre], place: Vector, wheels: int, steered: bool
) -> None:
    """Add the side force of wheels, their aligning moment if the tyre has a trail, and their steer input.

    F_y = -C (v_y/U - steer) at the contact point; M_z = -trail F_y.
    """
    body, tyre_name, tyre = owner
    cornering, trail = tyre_numbers(draft, tyre_name, tyre)
    count = wheels if tyre.per == "wheel" else wheels / 2
    C = cast("float", Number(float(count))) * cornering
    connection = draft.connection(
        name, (body, GROUND), place, forces=1, force_axis=Y, moments=0 if trail is None else 1
    )
    per_slip = C / draft.speed
    if trail is None:
        coefficients: tuple[tuple[float, ...], ...] = ((per_slip,),)
        gain: tuple[float, ...] = (C,)
    else:
        coefficients, gain = ((per_slip, ZERO), (-(trail * per_slip), ZERO)), (C, -(trail * C))
    draft.slip.append(Slip(connection, coefficients))
    if steered:
        draft.inputs.append(Input(f"{name}.steer", "rad", connection, gain, tuple(ZERO for _ in gain)))
