"""Beams and membranes into a draft."""

from eom.vehicle.draft import Draft, Site, add
from eom.vehicle.draft_places import joined, line_ends
from eom.vehicle.draft_springs import number
from eom.vehicle.elements import Beam as BeamElement
from eom.vehicle.elements import Triangle as TriangleElement
from eom.vehicle.source import Path
from eom.vehicle.structures import Beam, Triangle


def draft_beam(draft: Draft, name: str, item: Beam, path: Path, site: Site) -> None:
    """Add a beam."""
    registry = draft.registry
    first, second = (
        registry.number(value, f"{name}.bending_{k + 1}", (*path, "bending", k), site.scope)
        for k, value in enumerate(item.bending)
    )
    draft.beams.append(
        BeamElement(
            name,
            joined(draft, item.between, path, site),
            line_ends(draft, name, item, path, site),
            (first, second),
            registry.axis(item.normal, (*path, "normal"), site.scope),
            number(registry, item, name, "mass_per_length", path, site),
        )
    )


def draft_triangle(draft: Draft, name: str, item: Triangle, path: Path, site: Site) -> None:
    """Add a membrane."""
    registry = draft.registry
    a, b, c = (draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(item.between))
    if len(set(item.between)) < len(item.between):
        registry.report((*path, "between"), "names a body twice: a triangle joins three different ones")
    first, second, third = (
        add(site.origin, registry.place(corner, f"{name}.corner_{k + 1}", (*path, "corners", k), site.scope))
        for k, corner in enumerate(item.corners)
    )
    thickness, modulus, poisson = (
        number(registry, item, name, key, path, site) for key in ("thickness", "modulus", "poisson")
    )
    draft.triangles.append(
        TriangleElement(name, (a, b, c), (first, second, third), thickness, modulus, poisson, item.drilling)
    )
