"""Elastic connectors: bushings, springs with damper and inerter, torsion springs."""

from typing import Literal, Self, TypeVar

from pydantic import model_validator

from eom.vehicle.connector import LineConnector, Pair, PointConnector
from eom.vehicle.parts import Flag, Strict
from eom.vehicle.quantity import (
    AngularDamping,
    AngularStiffness,
    Axis,
    Damping,
    Force,
    Impulse,
    Inertia,
    Mass,
    MassMoment,
    Moment,
    Place,
    Stiffness,
)

Part = TypeVar("Part", bound=Strict)
# three forces, then three moments, per three displacements, then three rotations (or their rates)
StiffForces = tuple[Stiffness, Stiffness, Stiffness, Force, Force, Force]
StiffMoments = tuple[Force, Force, Force, AngularStiffness, AngularStiffness, AngularStiffness]
StiffnessMatrix = tuple[StiffForces, StiffForces, StiffForces, StiffMoments, StiffMoments, StiffMoments]
DampedForces = tuple[Damping, Damping, Damping, Impulse, Impulse, Impulse]
DampedMoments = tuple[Impulse, Impulse, Impulse, AngularDamping, AngularDamping, AngularDamping]
DampingMatrix = tuple[DampedForces, DampedForces, DampedForces, DampedMoments, DampedMoments, DampedMoments]
MassForces = tuple[Mass, Mass, Mass, MassMoment, MassMoment, MassMoment]
MassMoments = tuple[MassMoment, MassMoment, MassMoment, Inertia, Inertia, Inertia]
MassMatrix = tuple[MassForces, MassForces, MassForces, MassMoments, MassMoments, MassMoments]
Matrix6 = StiffnessMatrix | DampingMatrix | MassMatrix


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

    Stiffness in N/m, N/rad, N m/m and N m/rad, damping accordingly.
    """

    type: Literal["bushing"]
    between: Pair
    at: Place
    axes: tuple[Axis, Axis]
    stiffness: StiffnessMatrix | None = None
    damping: DampingMatrix | None = None
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
