"""Axles: two wheels on a group's body or on bodies of their own, told in full or like another axle."""

from typing import Annotated, Any

from pydantic import Discriminator, Tag, model_validator

from eom.vehicle.parts import Flag, Identifier, Strict, as_mapping
from eom.vehicle.quantity import Inertia, Length, TorquePerPressure


class AxleKeys(Strict):
    """What any axle may tell of its wheels.

    ``spin_inertia`` and ``brake_gain`` are those of one wheel; with a ``track`` the wheels stand apart.
    """

    x: Length
    steered: Flag = False
    driven: Flag = False
    radius: Length | None = None
    spin_inertia: Inertia | None = None
    brake_gain: TorquePerPressure | None = None
    track: Length | None = None

    @model_validator(mode="before")
    @classmethod
    def _on_one_of_two(cls, value: Any) -> Any:
        if {"group", "bodies"} <= as_mapping(value).keys():
            message = "stands on a 'group' or on two 'bodies': give one of the two"
            raise ValueError(message)
        return value


class Axle(AxleKeys):
    """Two wheels on the ground at ``x`` in the unit's frame, on the body of an axle group."""

    group: Identifier
    tyre: Identifier


class WheelAxle(AxleKeys):
    """Two wheels that each have a body of their own, left and right."""

    bodies: tuple[Identifier, Identifier]
    tyre: Identifier


class AxleLike(AxleKeys):
    """An axle that has the keys of another one of its unit, but for those that it gives itself."""

    like: Identifier
    group: Identifier | None = None
    bodies: tuple[Identifier, Identifier] | None = None
    tyre: Identifier | None = None


def tells_axle(value: object) -> str:
    """Which of the forms of an axle a mapping has."""
    if isinstance(value, AxleKeys):
        return "on_group" if isinstance(value, Axle) else "on_bodies" if isinstance(value, WheelAxle) else "as_another"
    given = as_mapping(value)
    return "as_another" if "like" in given else "on_bodies" if "bodies" in given else "on_group"


AnyAxle = Annotated[
    Annotated[Axle, Tag("on_group")] | Annotated[WheelAxle, Tag("on_bodies")] | Annotated[AxleLike, Tag("as_another")],
    Discriminator(tells_axle),
]
