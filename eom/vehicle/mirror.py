"""Reflection in the plane y = 0: a part with ``mirror: true`` and 'left' in its name makes the 'right' one too.

Places, axes, forces and velocities are polar vectors (y changes sign); moments and spins are axial (x and z do).
Actuators and sensors are mirrored in place and keep their direction, so that +y is left on both sides.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, TypeVar, cast

from eom.vehicle.aerodynamics import SurfaceDerivatives
from eom.vehicle.parts import InertiaProducts, InertiaTensor, Strict
from eom.vehicle.quantity import Quantity
from eom.vehicle.springs import Matrix6, TorsionSpring

Part = TypeVar("Part", bound=Strict)
Vector3 = tuple[Quantity, Quantity, Quantity]

SIDE = re.compile(r"(?<![A-Za-z])(?:left|right)(?![A-Za-z])")
POLAR = ("at", "axis", "rolling_axis", "force", "velocity", "normal")
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


# which forces and moments change sign; a bushing's third axis is made from the reflected two, which turns it round
MATRIX_SIGNS = {"Bushing": (1, 1, -1, -1, -1, 1), "Aero": (1, -1, 1, -1, 1, -1)}


def reflect_matrix(matrix: Matrix6, signs: tuple[int, ...]) -> Matrix6:
    """Reflection of a matrix of forces and moments by motions."""
    rows: Any = tuple(
        tuple(negative(value) if signs[r] * signs[c] < 0 else value for c, value in enumerate(row))
        for r, row in enumerate(matrix)
    )
    return cast("Matrix6", rows)


def reflect_derivatives(derivatives: Strict) -> Strict:
    """Reflection of a control surface's derivatives; a wing's couple no motion in the plane with one out of it."""
    if not isinstance(derivatives, SurfaceDerivatives):
        return derivatives
    changed = {key: value and negative(value) for key in ("y", "l", "n") if (value := getattr(derivatives, key))}
    return derivatives.model_copy(update=changed)


def reflect(part: Part) -> Part:
    """The part's mirror image, with left and right exchanged in the names of the bodies it refers to."""
    update: dict[str, Any] = {}
    changes: tuple[tuple[tuple[str, ...], Callable[[Any], Any]], ...] = (
        (POLAR, polar),
        (AXIAL, axial),
        (NAMES, other_side),
        (("between",), lambda names: tuple(map(other_side, names))),
        (("ends", "corners", "axes"), lambda places: tuple(map(polar, places))),
        (("inertia",), reflect_inertia),
        (("derivatives",), reflect_derivatives),
        (("feedthrough",), lambda gains: {other_side(name): gain for name, gain in gains.items()}),
    )
    # a moment about a line turns round with its sense, which a place on it does not
    if isinstance(part, TorsionSpring) and part.preload is not None:
        update["preload"] = negative(part.preload)
    signs = MATRIX_SIGNS.get(type(part).__name__)
    if signs is not None:
        update |= {
            field: reflect_matrix(value, signs)
            for field in ("stiffness", "damping", "added_mass")
            if (value := getattr(part, field, None)) is not None
        }
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
