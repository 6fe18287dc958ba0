"""Connectors between bodies: joints, supports, tyres, and the union of all connectors."""

from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, field_validator

from eom.vehicle.aerodynamics import Aero, ControlSurface, Drag, Wing
from eom.vehicle.connector import LineConnector, PointConnector
from eom.vehicle.parts import Flag, Identifier, Strict, not_a_flag
from eom.vehicle.quantity import Axis, Damping, Length, Place
from eom.vehicle.springs import Bushing, FlexPoint, Spring, TorsionSpring
from eom.vehicle.structures import Beam, Triangle

Carried = Literal["x", "y", "z", "roll", "pitch", "yaw"]


class RigidPoint(PointConnector):
    """A joint: locks its directions. A wheel that rolls on its contact point names its ``rolling_axis``.

    A ``moving`` one locks them relative to the frame that moves with the trim: it holds a speed.
    """

    type: Literal["rigid_point"]
    rolling_axis: Axis | None = None
    moving: Flag = False


class RollingPoint(PointConnector):
    """A nonholonomic joint: no sliding velocity along its directions, in body axes."""

    type: Literal["nh_point"]


class Link(LineConnector):
    """A massless rigid rod."""

    type: Literal["link"]


class TorsionLink(LineConnector):
    """A massless shaft: no relative rotation about the line between its ends."""

    type: Literal["torsion_link"]


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
    RigidPoint
    | RollingPoint
    | FlexPoint
    | Link
    | TorsionLink
    | Spring
    | TorsionSpring
    | Bushing
    | Beam
    | Triangle
    | Support
    | SlipDamper
    | TyreConnector
    | Aero
    | Drag
    | Wing
    | ControlSurface,
    Field(discriminator="type"),
]
