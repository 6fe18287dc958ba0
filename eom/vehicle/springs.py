"""Elastic connectors: bushings, springs with damper and inerter, torsion springs."""

from typing import Literal, Self, TypeVar

from pydantic import model_validator

from eom.vehicle.connector import LineConnector, Pair, PointConnector
from eom.vehicle.parts import Flag, Strict
from eom.vehicle.quantity import (
    AngularDamping,
    AngularStiffness,
    Any_,
    Axis,
    Damping,
    Force,
    Inertia,
    Mass,
    Moment,
    Place,
    Stiffness,
)

Part = TypeVar("Part", bound=Strict)
Six = tuple[Any_, Any_, Any_, Any_, Any_, Any_]
Matrix6 = tuple[Six, Six, Six, Six, Six, Six]


class FlexPoint(PointConnector):
    """A bushing: stiffness and damping along its directions of force and of moment.

    A wheel that stands on it names its ``rolling_axis``.
    """

    type: Literal["flex_point"]
    rolling_axis: Axis | None = None
    stiffness: Stiffness | None = None
    damping: Damping | None = None
    angular_stiffness: AngularStiffness | None = None
    angular_damping: AngularDamping | None = None

    @model_validator(mode="after")
    def _acts_somewhere(self) -> Self:
        for count, kind, values in (
            (self.forces, "forces", ("stiffness", "damping")),
            (self.moments, "moments", ("angular_stiffness", "angular_damping")),
        ):
            given = [name for name in values if getattr(self, name) is not None]
            if given and not count:
                message = f"has '{given[0]}' but no '{kind}' for it to act along"
                raise ValueError(message)
            if count and not given:
                message = f"has '{kind}' but neither '{values[0]}' nor '{values[1]}'"
                raise ValueError(message)
        return self


class Spring(LineConnector):
    """A spring, damper and inerter along their line; ``preload`` is its tension at the trim where it is known."""

    type: Literal["spring"]
    stiffness: Stiffness | None = None
    damping: Damping | None = None
    inertance: Mass | None = None
    preload: Force | None = None

    @model_validator(mode="after")
    def _acts(self) -> Self:
        return acts(self, ("stiffness", "damping", "inertance", "preload"))


class TorsionSpring(LineConnector):
    """A spring, damper and inerter about the line between its ends; ``preload`` is its moment at the trim."""

    type: Literal["torsion_spring"]
    stiffness: AngularStiffness | None = None
    damping: AngularDamping | None = None
    inertance: Inertia | None = None
    preload: Moment | None = None

    @model_validator(mode="after")
    def _acts(self) -> Self:
        return acts(self, ("stiffness", "damping", "inertance", "preload"))


class Bushing(Strict):
    """An elastic joint with full matrices, three forces then three moments along two stated axes and their third.

    Stiffness in N/m, N/rad, N m/m and N m/rad, damping accordingly; numbers are in SI units.
    """

    type: Literal["bushing"]
    between: Pair
    at: Place
    axes: tuple[Axis, Axis]
    stiffness: Matrix6 | None = None
    damping: Matrix6 | None = None
    mirror: Flag = False

    @model_validator(mode="after")
    def _acts(self) -> Self:
        return acts(self, ("stiffness", "damping"))


def acts(part: Part, values: tuple[str, ...]) -> Part:
    """The part, if at least one of its values is given."""
    if all(getattr(part, name) is None for name in values):
        message = f"does nothing: give at least one of {', '.join(values)}"
        raise ValueError(message)
    return part
