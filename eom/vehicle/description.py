"""The whole of a vehicle file, as the schema that `eom schema` writes."""

from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag

from eom.vehicle.connectors import Connector
from eom.vehicle.parts import (
    MAX_PARTS,
    Actuator,
    Body,
    Identifier,
    Load,
    Parameter,
    Sensor,
    Strict,
    Trim,
    as_mapping,
)
from eom.vehicle.quantity import Acceleration, Any_, Time
from eom.vehicle.train import Coupling, Template, Unit, UnitUse
from eom.vehicle.tyres import AnyTyre

Vector3 = tuple[Acceleration, Acceleration, Acceleration]
AnyUnit = Annotated[
    Annotated[Unit, Tag("unit")] | Annotated[UnitUse, Tag("use")],
    Discriminator(lambda value: "use" if isinstance(value, UnitUse) or "use" in as_mapping(value) else "unit"),
]
AnyParameter = Annotated[
    Annotated[Parameter, Tag("described")] | Annotated[Any_, Tag("plain")],
    Discriminator(lambda value: "described" if isinstance(value, (dict, Parameter)) else "plain"),
]
Gravity = Annotated[
    Annotated[Acceleration, Tag("down")] | Annotated[Vector3, Tag("vector")],
    Discriminator(lambda value: "vector" if isinstance(value, (list, tuple)) else "down"),
]


MAX_UNITS = 20


class Drive(Strict):
    """How drive torque reaches the driven wheels: equally, or with ``locked`` at equal speeds; ``lag`` [s]."""

    differential: Literal["open", "locked"] = "open"
    lag: Time | None = None


class Brakes(Strict):
    """How brake pressures build up."""

    lag: Time | None = None


class Description(Strict):
    """A mechanical system, above all a road vehicle with trailers."""

    name: str = Field(max_length=200)
    source: str = ""
    gravity: Gravity | None = None
    trim: Trim | None = None
    parameters: dict[Identifier, AnyParameter] = Field(default_factory=dict, max_length=MAX_PARTS)
    bodies: dict[Identifier, Body] = Field(default_factory=dict, max_length=MAX_PARTS)
    connectors: dict[Identifier, Connector] = Field(default_factory=dict, max_length=MAX_PARTS)
    loads: dict[Identifier, Load] = Field(default_factory=dict, max_length=MAX_PARTS)
    actuators: dict[Identifier, Actuator] = Field(default_factory=dict, max_length=MAX_PARTS)
    sensors: dict[Identifier, Sensor] = Field(default_factory=dict, max_length=MAX_PARTS)
    tyres: dict[Identifier, AnyTyre] = Field(default_factory=dict, max_length=MAX_PARTS)
    templates: dict[Identifier, Template] = Field(default_factory=dict, max_length=MAX_PARTS)
    units: dict[Identifier, AnyUnit] = Field(default_factory=dict, max_length=MAX_UNITS)
    couplings: dict[Identifier, Coupling] = Field(default_factory=dict, max_length=MAX_PARTS)
    drive: Drive | None = None
    brakes: Brakes | None = None
