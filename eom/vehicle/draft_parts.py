"""Parameters, bodies and loads into a draft."""

import keyword

from eom.vehicle import parts
from eom.vehicle.description import Description
from eom.vehicle.draft import ORIGIN, ZERO, Draft, Scope, Site, add
from eom.vehicle.elements import GROUND, Body, Load, Matrix3, Vector
from eom.vehicle.expression import CONSTANTS, FUNCTIONS
from eom.vehicle.quantity import Quantity
from eom.vehicle.registry import Live, Registry
from eom.vehicle.source import Path

RESERVED = {*keyword.kwlist, *CONSTANTS, *FUNCTIONS, "gravity"}


def declare_parameters(registry: Registry, description: Description) -> None:
    """Enter the declared parameters, then check the names in their values."""
    described = {
        name: item if isinstance(item, parts.Parameter) else parts.Parameter.model_construct(value=item)
        for name, item in description.parameters.items()
    }
    for name, item in described.items():
        path: Path = ("parameters", name, "value")
        if name in RESERVED:
            registry.report(path[:2], f"'{name}' has a meaning of its own: give the parameter another name")
        registry.parameters[name] = Live(
            item.value.expression,
            item.value.unit,
            item.description,
            path,
            None if item.min is None else item.min.expression,
            None if item.max is None else item.max.expression,
            item.value.dimension,
        )
    for name, item in described.items():
        for key in ("value", "min", "max"):
            quantity: Quantity | None = getattr(item, key)
            if quantity is None:
                continue
            here = ("parameters", name, key)
            registry.resolve(quantity, here, {})
            own = item.value.dimension
            if own is not None and quantity.dimension not in {None, own}:
                registry.report(here, "has another dimension than the value that it bounds")


def draft_body(draft: Draft, name: str, item: parts.Body, path: Path, site: Site) -> None:
    """Add a body at its place in a unit's frame."""
    scope = site.scope
    registry = draft.registry
    draft.claim(name, path)
    draft.index[name] = len(draft.bodies)
    velocity: Vector = (draft.speed, ZERO, ZERO)
    if item.velocity is not None:
        velocity = registry.place(item.velocity, f"{name}.velocity", (*path, "velocity"), scope)
    spin = ORIGIN
    if item.spin is not None:
        spin = registry.place(item.spin, f"{name}.spin", (*path, "spin"), scope)
    draft.bodies.append(
        Body(
            name,
            registry.number(item.mass, f"{name}.mass", (*path, "mass"), scope),
            add(site.origin, registry.place(item.at, f"{name}.at", (*path, "at"), scope)),
            draft_inertia(draft, name, item, (*path, "inertia"), scope),
            velocity,
            spin,
        )
    )


def draft_inertia(draft: Draft, name: str, item: parts.Body, path: Path, scope: Scope | None) -> Matrix3:
    """The tensor about the centre of mass; without an entry that of a point mass."""
    registry = draft.registry
    match item.inertia:
        case None:
            return ORIGIN, ORIGIN, ORIGIN
        case parts.InertiaTensor(tensor=tensor):
            first, second, third = (
                registry.place(row, f"{name}.inertia.{axis}", (*path, "tensor", k), scope)
                for k, (axis, row) in enumerate(zip("xyz", tensor, strict=True))
            )
            return first, second, third
        case products:
            given = {
                key: registry.number(value, f"{name}.inertia.{key}", (*path, key), scope)
                for key in ("xx", "yy", "zz", "xy", "yz", "xz")
                if (value := getattr(products, key)) is not None
            }
            minus = {key: -given[key] if key in given else ZERO for key in ("xy", "yz", "xz")}
            return (
                (given["xx"], minus["xy"], minus["xz"]),
                (minus["xy"], given["yy"], minus["yz"]),
                (minus["xz"], minus["yz"], given["zz"]),
            )


def draft_load(draft: Draft, name: str, item: parts.Load, path: Path) -> None:
    """Add an applied load."""
    registry = draft.registry
    draft.claim(name, path)
    body = draft.body(item.body, (*path, "body"))
    if body == GROUND:
        if item.body == "ground":
            registry.report((*path, "body"), "a load acts on a body, not on the ground")
        return
    draft.loads.append(
        Load(
            name,
            body,
            draft.bodies[body].centre if item.at is None else registry.place(item.at, f"{name}.at", (*path, "at")),
            ORIGIN if item.force is None else registry.place(item.force, f"{name}.force", (*path, "force")),
            ORIGIN if item.moment is None else registry.place(item.moment, f"{name}.moment", (*path, "moment")),
            draft.body(item.frame, (*path, "frame")),
        )
    )
