"""Elastic connectors into a draft: flexible points, springs, torsion springs, bushings."""

from typing import Any

from eom.vehicle.draft import ZERO, Draft, Site, add
from eom.vehicle.draft_places import joined, line_connection, point_connection
from eom.vehicle.elements import Bushing as BushingElement
from eom.vehicle.elements import Elastic
from eom.vehicle.parts import Strict
from eom.vehicle.registry import Registry
from eom.vehicle.source import Path
from eom.vehicle.springs import Bushing, FlexPoint, Matrix6, Spring, TorsionSpring

Rows = tuple[tuple[float, ...], ...]


def number(registry: Registry, item: Strict, owner: str, key: str, path: Path, site: Site) -> float:
    """An optional quantity of a part, zero if it is not given."""
    value: Any = getattr(item, key)
    return ZERO if value is None else registry.number(value, f"{owner}.{key}", (*path, key), site.scope)


def draft_flex_point(draft: Draft, name: str, item: FlexPoint, path: Path, site: Site) -> None:
    """Add a point with stiffness and damping along and about its directions."""
    stiffness, damping, angular_stiffness, angular_damping = (
        number(draft.registry, item, name, key, path, site)
        for key in ("stiffness", "damping", "angular_stiffness", "angular_damping")
    )
    connection = point_connection(draft, name, item, path, site)
    draft.elastic.append(Elastic(connection, (stiffness, angular_stiffness), (damping, angular_damping)))


def draft_spring(draft: Draft, name: str, item: Spring | TorsionSpring, path: Path, site: Site) -> None:
    """Add a spring, damper and inerter along a line, or about it."""
    twist = isinstance(item, TorsionSpring)
    connection = line_connection(draft, name, item, path, site, twist=twist)
    stiffness, damping, inertance = (
        (ZERO, value) if twist else (value, ZERO)
        for value in (
            number(draft.registry, item, name, key, path, site) for key in ("stiffness", "damping", "inertance")
        )
    )
    given = None if item.preload is None else number(draft.registry, item, name, "preload", path, site)
    draft.elastic.append(Elastic(connection, stiffness, damping, inertance, given))


def matrix(registry: Registry, rows: Matrix6 | None, name: str, path: Path, site: Site) -> Rows:
    """Live numbers ``name.rc`` of a matrix, r and c counted from 1; zeros if it is not given."""
    if rows is None:
        return ((ZERO,) * 6,) * 6
    return tuple(
        tuple(
            registry.number(value, f"{name}.{r + 1}{c + 1}", (*path, r, c), site.scope) for c, value in enumerate(row)
        )
        for r, row in enumerate(rows)
    )


def draft_bushing(draft: Draft, name: str, item: Bushing, path: Path, site: Site) -> None:
    """Add a bushing with full matrices."""
    registry = draft.registry
    bodies = joined(draft, item.between, path, site)
    place = add(site.origin, registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
    first, second = (registry.axis(axis, (*path, "axes", k), site.scope) for k, axis in enumerate(item.axes))
    stiffness, damping = (
        matrix(registry, getattr(item, key), f"{name}.{key}", (*path, key), site) for key in ("stiffness", "damping")
    )
    connection = draft.connection(name, bodies, place, forces=3, moments=3)
    draft.bushings.append(BushingElement(connection, (first, second), stiffness, damping))
