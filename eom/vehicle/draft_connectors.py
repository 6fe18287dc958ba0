"""Connectors into a draft: each type to where it belongs; joints, supports, slip dampers."""

from eom.vehicle.aerodynamics import Aero, ControlSurface, Drag, Wing
from eom.vehicle.connectors import (
    Connector,
    Link,
    RigidPoint,
    RollingPoint,
    SlipDamper,
    Support,
    TorsionLink,
    TyreConnector,
)
from eom.vehicle.draft import ZERO, Draft, Site, Z, add, carried_directions
from eom.vehicle.draft_aerodynamics import draft_aerodynamics, draft_drag
from eom.vehicle.draft_places import line_connection, point_connection
from eom.vehicle.draft_springs import draft_bushing, draft_flex_point, draft_spring
from eom.vehicle.draft_structures import draft_beam, draft_triangle
from eom.vehicle.draft_tyres import draft_tyre, find_tyre
from eom.vehicle.elements import GROUND, Constraint, Slip, Vector
from eom.vehicle.source import Path
from eom.vehicle.springs import Bushing, FlexPoint, Spring, TorsionSpring
from eom.vehicle.structures import Beam, Triangle
from eom.vehicle.tyres import Tyre

ElasticConnector = FlexPoint | Spring | TorsionSpring | Bushing | Beam | Triangle
StandingConnector = Support | SlipDamper | TyreConnector | Aero | Drag | Wing | ControlSurface


def draft_connector(draft: Draft, tyres: dict[str, Tyre], name: str, item: Connector, path: Path, site: Site) -> None:
    """Add a connector of any type."""
    draft.claim(name, path)
    match item:
        case RigidPoint():
            draft.constraints.append(Constraint(point_connection(draft, name, item, path, site), item.moving))
        case RollingPoint():
            draft.rolling.append(point_connection(draft, name, item, path, site))
        case Link() | TorsionLink():
            locked = line_connection(draft, name, item, path, site, twist=isinstance(item, TorsionLink))
            draft.constraints.append(Constraint(locked))
        case Support() | SlipDamper() | TyreConnector() | Aero() | Drag() | Wing() | ControlSurface():
            draft_standing(draft, tyres, name, item, path, site)
        case _:
            draft_elastic(draft, name, item, path, site)


def draft_elastic(draft: Draft, name: str, item: ElasticConnector, path: Path, site: Site) -> None:
    """Add a connector that gives way."""
    match item:
        case FlexPoint():
            draft_flex_point(draft, name, item, path, site)
        case Spring() | TorsionSpring():
            draft_spring(draft, name, item, path, site)
        case Bushing():
            draft_bushing(draft, name, item, path, site)
        case Beam():
            draft_beam(draft, name, item, path, site)
        case Triangle():
            draft_triangle(draft, name, item, path, site)


def draft_standing(
    draft: Draft, tyres: dict[str, Tyre], name: str, item: StandingConnector, path: Path, site: Site
) -> None:
    """Add a connector between one body and the ground or the air."""
    place, body = standing(draft, name, item, path, site)
    match item:
        case Support():
            draft_support(draft, name, body, place, item.carries)
        case SlipDamper():
            axis = draft.registry.axis(item.axis, (*path, "axis"), site.scope)
            c = draft.registry.number(item.damping, f"{name}.damping", (*path, "damping"), site.scope)
            coefficients = ((c,),) if item.forces == 1 else ((c, ZERO), (ZERO, c))
            connection = draft.connection(name, (body, GROUND), place, forces=item.forces, force_axis=axis)
            draft.slip.append(Slip(connection, coefficients))
        case TyreConnector():
            tyre = find_tyre(draft, tyres, item.tyre, (*path, "tyre"))
            radius = None
            if item.radius is not None:
                radius = draft.registry.number(item.radius, f"{name}.radius", (*path, "radius"), site.scope)
                draft.registry.not_negative(radius, (*path, "radius"), zero=False)
            draft.wheels[name] = (body, radius)
            if tyre is not None:
                draft_tyre(draft, name, (body, item.tyre, tyre), place, item.wheels, path, steered=item.steered)
        case Drag():
            draft_drag(draft, name, item, (body, place, path, site))
        case Aero() | Wing() | ControlSurface():
            draft_aerodynamics(draft, name, item, (body, place, path, site))


def standing(
    draft: Draft,
    name: str,
    item: StandingConnector,
    path: Path,
    site: Site,
) -> tuple[Vector, int]:
    """Place and body of a connector that stands on the ground."""
    if item.body == "ground":
        draft.registry.report((*path, "body"), "stands on the ground already: name the body that it belongs to")
    place = add(site.origin, draft.registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
    return place, draft.body(item.body, (*path, "body"), site.bodies)


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
