"""Parts of a description that stand alone: parameters, trim, bodies, loads, signals."""

from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, model_validator

from eom.vehicle.quantity import (
    AngularSpeed,
    Any_,
    Axis,
    Force,
    Inertia,
    Mass,
    Moment,
    Place,
    Plain,
    Speed,
    describe,
)

Identifier = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*$", max_length=60)]
MAX_PARTS = 3000
Flag = Annotated[bool, Field(strict=True)]


def not_a_flag(value: object) -> object:
    """A count, which true and false are not."""
    if isinstance(value, bool):
        message = f"expected a number, got {describe(value)}"
        raise ValueError(message)  # noqa: TRY004  pydantic collects value errors alone
    return value


class Strict(BaseModel):
    """Base of every part: unknown keys are mistakes, values do not change."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Parameter(Strict):
    """A named number that the file's other numbers may refer to."""

    value: Any_
    min: Any_ | None = None
    max: Any_ | None = None
    description: str = ""


class Trim(Strict):
    """The steady motion: every body moves along +x at one speed; ``hold`` keeps the lead body's speed.

    ``grade`` is the road's rise per run.
    """

    speed: Speed
    hold: Flag = False
    grade: Plain | None = None


class InertiaProducts(Strict):
    """Moments of inertia about the centre of mass; products are positive integrals such as that of x y dm."""

    xx: Inertia
    yy: Inertia
    zz: Inertia
    xy: Inertia | None = None
    yz: Inertia | None = None
    xz: Inertia | None = None


class InertiaTensor(Strict):
    """The full tensor about the centre of mass; off its diagonal stand the negative products."""

    tensor: tuple[
        tuple[Inertia, Inertia, Inertia],
        tuple[Inertia, Inertia, Inertia],
        tuple[Inertia, Inertia, Inertia],
    ]


def tells_inertia(value: object) -> str:
    """Which of the two forms of an inertia a mapping has."""
    return "tensor" if isinstance(value, InertiaTensor) or "tensor" in as_mapping(value) else "products"


def as_mapping(value: object) -> dict[str, object]:
    """The value if it is a mapping, else an empty one."""
    return value if isinstance(value, dict) else {}


AnyInertia = Annotated[
    Annotated[InertiaProducts, Tag("products")] | Annotated[InertiaTensor, Tag("tensor")],
    Discriminator(tells_inertia),
]


class Body(Strict):
    """A rigid body, its axes parallel to x, y, z at the trim."""

    mass: Mass
    at: Place
    inertia: AnyInertia | None = None
    velocity: tuple[Speed, Speed, Speed] | None = None
    spin: tuple[AngularSpeed, AngularSpeed, AngularSpeed] | None = None
    mirror: Flag = False


class Load(Strict):
    """A constant force and moment; they keep the direction they have in the axes of ``frame``."""

    body: Identifier
    at: Place | None = None
    force: tuple[Force, Force, Force] | None = None
    moment: tuple[Moment, Moment, Moment] | None = None
    frame: Identifier = "ground"
    mirror: Flag = False

    @model_validator(mode="after")
    def _loads_something(self) -> Self:
        if self.force is None and self.moment is None:
            message = "a load needs 'force' or 'moment'"
            raise ValueError(message)
        return self


class Signal(Strict):
    """One direction at one place: ``along`` an axis (translation, force) or ``about`` it (rotation, moment)."""

    at: Place | None = None
    along: Axis | None = None
    about: Axis | None = None
    gain: Any_ | None = None
    unit: str | None = Field(default=None, max_length=20)
    mirror: Flag = False

    @model_validator(mode="after")
    def _one_direction(self) -> Self:
        if (self.along is None) == (self.about is None):
            message = "give one of 'along' (an axis to move or push along) and 'about' (an axis to turn about)"
            raise ValueError(message)
        return self


class Actuator(Signal):
    """An input: a force or moment on ``body`` along +axis, and its reverse on ``reaction_on``."""

    body: Identifier
    reaction_on: Identifier = "ground"
    rate_gain: Any_ | None = None


class Sensor(Signal):
    """An output: the motion of ``body``, or of a unit's whole-mass centre, relative to another body."""

    body: Identifier | None = None
    centre_of: Identifier | None = None
    relative_to: Identifier = "ground"
    measure: Literal["position", "velocity", "acceleration"]
    frame: Literal["body", "inertial"] = "inertial"
    feedthrough: dict[str, Any_] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _one_target(self) -> Self:
        if (self.body is None) == (self.centre_of is None):
            message = "give one of 'body' and 'centre_of' (a unit, for its whole-mass centre)"
            raise ValueError(message)
        if self.centre_of is not None and (self.at is not None or self.about is not None):
            message = "a unit's whole-mass centre takes no 'at' and is measured 'along' an axis"
            raise ValueError(message)
        if self.measure == "position" and self.frame == "body":
            message = "a position is measured in the inertial frame: body axes have no fixed origin"
            raise ValueError(message)
        return self
