"""The train: units from front to rear, with their couplings, axle groups, axles and suspensions."""

from typing import Literal, Self

from pydantic import Field, model_validator

from eom.vehicle.axles import AnyAxle
from eom.vehicle.connectors import Carried, Connector
from eom.vehicle.parts import Body, Identifier, Strict
from eom.vehicle.quantity import AngularDamping, AngularStiffness, Any_, Length, Place, Quantity

# a unit's mass and centre are sums over its bodies, which a deep expression would make slow
MAX_UNIT_PARTS = 200
CARRIED_BY_KIND: dict[str, tuple[Carried, ...]] = {
    "fifth_wheel": ("x", "y", "z", "roll"),
    "pintle": ("x", "y", "z"),
    "turntable": ("x", "y", "z", "roll", "pitch"),
    "drawbar": ("x", "y", "z", "roll", "yaw"),
}


class RollAxis(Strict):
    """The axis, parallel to x, about which a body rolls on another."""

    height: Length


class Suspension(Strict):
    """A sprung body on an unsprung one: free in roll about the roll axis, with stiffness and damping."""

    between: tuple[Identifier, Identifier]
    roll_axis: RollAxis
    roll_stiffness: AngularStiffness
    roll_damping: AngularDamping | None = None


class GroupSupport(Strict):
    """Where the ground carries an axle group vertically."""

    at: Place


class AxleGroup(Strict):
    """Axles that share a body; they may carry it vertically and, by their tyres, in roll.

    ``track`` is that of axles that do not give their own.
    """

    body: Identifier
    support: GroupSupport | None = None
    roll_stiffness: AngularStiffness | None = None
    track: Length | None = None


class Unit(Strict):
    """A vehicle unit in its own frame: x forward, y left, z up from the ground."""

    bodies: dict[Identifier, Body] = Field(max_length=MAX_UNIT_PARTS)
    suspensions: dict[Identifier, Suspension] = Field(default_factory=dict, max_length=MAX_UNIT_PARTS)
    axle_groups: dict[Identifier, AxleGroup] = Field(default_factory=dict, max_length=MAX_UNIT_PARTS)
    axles: dict[Identifier, AnyAxle] = Field(default_factory=dict, max_length=MAX_UNIT_PARTS)
    connectors: dict[Identifier, Connector] = Field(default_factory=dict, max_length=MAX_UNIT_PARTS)


class Template(Unit):
    """A unit described once; ``needs`` names what each use fills in: numbers, or names of tyres."""

    needs: tuple[Identifier, ...] = ()


class UnitUse(Strict):
    """A unit made from a template."""

    use: Identifier
    with_: dict[Identifier, Any_] = Field(default_factory=dict, alias="with")


class Coupling(Strict):
    """A joint between two successive units.

    ``carries`` lists the relative motions that it locks; a kind implies a list, less roll where the coupling has
    a roll stiffness. It joins each unit's first body unless ``bodies`` names others.
    """

    kind: Literal["fifth_wheel", "pintle", "turntable", "drawbar"]
    between: tuple[Identifier, Identifier]
    at: dict[Identifier, Place]
    bodies: dict[Identifier, Identifier] = Field(default_factory=dict)
    carries: tuple[Carried, ...] | None = None
    roll_stiffness: AngularStiffness | None = None
    roll_damping: AngularDamping | None = None

    @model_validator(mode="after")
    def _places_of_both(self) -> Self:
        if set(self.at) != set(self.between):
            message = f"'at' gives a place in each of {self.between[0]} and {self.between[1]}"
            raise ValueError(message)
        if self.elastic and "roll" in (self.carries or ()):
            message = "roll is either carried rigidly or has a stiffness and damping: give one of the two"
            raise ValueError(message)
        return self

    @property
    def elastic(self) -> bool:
        """Whether roll is carried by a spring or damper."""
        return self.roll_stiffness is not None or self.roll_damping is not None

    @property
    def locked(self) -> tuple[Carried, ...]:
        """The relative motions that the coupling locks."""
        if self.carries is not None:
            return self.carries
        kind = CARRIED_BY_KIND[self.kind]
        return tuple(name for name in kind if not (name == "roll" and self.elastic))


def argument_name(quantity: Quantity) -> str | None:
    """The bare name that a template's argument consists of, if it is one."""
    return getattr(quantity.expression, "name", None)
