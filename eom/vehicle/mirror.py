"""Reflection in the plane y = 0: a part with ``mirror: true`` and 'left' in its name makes the 'right' one too.

Places, axes, forces and velocities are polar vectors (y changes sign); moments and spins are axial (x and z do).
Actuators and sensors are mirrored in place and keep their direction, so that +y is left on both sides.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

from eom.vehicle.parts import InertiaProducts, InertiaTensor, Strict
from eom.vehicle.quantity import Quantity

Part = TypeVar("Part", bound=Strict)
Vector3 = tuple[Quantity, Quantity, Quantity]

SIDE = re.compile(r"(?<![A-Za-z])(?:left|right)(?![A-Za-z])")
POLAR = ("at", "axis", "rolling_axis", "force", "velocity")
AXIAL = ("moment", "spin")
NAMES = ("body", "frame", "reaction_on", "relative_to")


def other_side(name: str) -> str:
    """The name with the words left and right exchanged, but not within words such as upright."""
    return SIDE.sub(lambda match: "right" if match[0] == "left" else "left", name)


def negative(quantity: Quantity) -> Quantity:
    """The quantity with the other sign."""
    return replace(quantity, expression=-quantity.expression)


def polar(v: Vector3) -> Vector3:
    """Reflection of a place, a direction or a velocity."""
    return v[0], negative(v[1]), v[2]


def axial(v: Vector3) -> Vector3:
    """Reflection of a moment or an angular velocity."""
    return negative(v[0]), v[1], negative(v[2])


def reflect_inertia(inertia: InertiaProducts | InertiaTensor) -> InertiaProducts | InertiaTensor:
    """Reflection of an inertia: products with y change sign."""
    if isinstance(inertia, InertiaTensor):
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = inertia.tensor
        tensor = ((xx, negative(xy), xz), (negative(yx), yy, negative(yz)), (zx, negative(zy), zz))
        return inertia.model_copy(update={"tensor": tensor})
    products = {name: getattr(inertia, name) for name in ("xy", "yz")}
    return inertia.model_copy(update={name: value and negative(value) for name, value in products.items()})


def reflect(part: Part) -> Part:
    """The part's mirror image, with left and right exchanged in the names of the bodies it refers to."""
    update: dict[str, Any] = {}
    changes: tuple[tuple[tuple[str, ...], Callable[[Any], Any]], ...] = (
        (POLAR, polar),
        (AXIAL, axial),
        (NAMES, other_side),
        (("between",), lambda names: tuple(map(other_side, names))),
        (("ends",), lambda ends: tuple(map(polar, ends))),
        (("inertia",), reflect_inertia),
        (("feedthrough",), lambda gains: {other_side(name): gain for name, gain in gains.items()}),
    )
    for fields, change in changes:
        for field in fields:
            value = getattr(part, field, None)
            if value is not None:
                update[field] = change(value)
    return part.model_copy(update=update)


def with_mirror_images(parts: Mapping[str, Part], report: Callable[[str, str], None]) -> dict[str, tuple[str, Part]]:
    """All parts with the mirror images that they ask for: name to (name in the file, part)."""
    result: dict[str, tuple[str, Part]] = {}
    for name, part in parts.items():
        result[name] = (name, part)
        if not getattr(part, "mirror", False):
            continue
        image = other_side(name)
        if image == name:
            report(name, "a mirrored part needs 'left' or 'right' in its name, to name its image")
        elif image in parts:
            report(name, f"its mirror image '{image}' is also described: remove one of the two")
        else:
            result[image] = (name, reflect(part))
    return result
