"""Connectors between bodies: joints, springs, supports, tyres."""

from typing import Annotated, Literal, Self

from pydantic import BeforeValidator, Field, field_validator, model_validator

from eom.vehicle.parts import Flag, Identifier, Strict, not_a_flag
from eom.vehicle.quantity import AngularDamping, AngularStiffness, Axis, Damping, Length, Place, Stiffness

# without the check true would count as 1
Count = Annotated[Literal[0, 1, 2, 3], BeforeValidator(not_a_flag)]
Pair = tuple[Identifier, Identifier]
Carried = Literal["x", "y", "z", "roll", "pitch", "yaw"]


class PointConnector(Strict):
    """A place where two bodies meet; directions are fixed on the second one.

    One force or moment acts along ``axis``, two act normal to it, three in all directions.
    """

    between: Pair
    at: Place
    forces: Count = 0
    moments: Count = 0
    axis: Axis | None = None
    mirror: Flag = False


class RigidPoint(PointConnector):
    """A joint: locks its directions. A wheel that rolls on its contact point names its ``rolling_axis``."""

    type: Literal["rigid_point"]
    rolling_axis: Axis | None = None


class RollingPoint(PointConnector):
    """A nonholonomic joint: no sliding velocity along its directions, in body axes."""

    type: Literal["nh_point"]


class FlexPoint(PointConnector):
    """A bushing: stiffness and damping along its directions of force and of moment."""

    type: Literal["flex_point"]
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


class LineConnector(Strict):
    """A line from a place on the first body to a place on the second one."""

    between: Pair
    ends: tuple[Place, Place]
    mirror: Flag = False


class Link(LineConnector):
    """A massless rigid rod."""

    type: Literal["link"]


class Spring(LineConnector):
    """A spring and damper along their line."""

    type: Literal["spring"]
    stiffness: Stiffness | None = None
    damping: Damping | None = None

    @model_validator(mode="after")
    def _acts(self) -> Self:
        if self.stiffness is None and self.damping is None:
            message = "needs 'stiffness', 'damping' or both"
            raise ValueError(message)
        return self


class Support(Strict):
    """What carries a body on the ground at a place: vertically, and in roll or pitch if said."""

    type: Literal["support"]
    body: Identifier
    at: Place
    carries: tuple[Literal["z", "roll", "pitch"], ...] = Field(default=("z",), min_length=1, max_length=3)
    mirror: Flag = False

    @field_validator("carries")
    @classmethod
    def _each_once(cls, carries: tuple[str, ...]) -> tuple[str, ...]:
        if len(set(carries)) < len(carries):
            message = "names a direction twice"
            raise ValueError(message)
        return carries


class SlipDamper(Strict):
    """Damping of sliding velocity in body axes, along an axis or (2) normal to it."""

    type: Literal["slip_damper"]
    body: Identifier
    at: Place
    axis: Axis
    forces: Annotated[Literal[1, 2], BeforeValidator(not_a_flag)] = 1
    damping: Damping
    mirror: Flag = False


class TyreConnector(Strict):
    """One or two wheels of a body on the ground, without an axle of a train."""

    type: Literal["tyre"]
    body: Identifier
    at: Place
    tyre: Identifier
    wheels: Annotated[Literal[1, 2], BeforeValidator(not_a_flag)] = 2
    steered: Flag = False
    radius: Length | None = None
    mirror: Flag = False


Connector = Annotated[
    RigidPoint | RollingPoint | FlexPoint | Link | Spring | Support | SlipDamper | TyreConnector,
    Field(discriminator="type"),
]
