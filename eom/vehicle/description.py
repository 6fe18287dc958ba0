"""The whole of a vehicle file, as the schema that `eom schema` writes."""

from typing import Annotated

from pydantic import Discriminator, Field, Tag

from eom.vehicle.connectors import Connector
from eom.vehicle.parts import (
    Actuator,
    Body,
    Identifier,
    Load,
    Parameter,
    Sensor,
    Strict,
    Trim,
    Tyre,
    as_mapping,
)
from eom.vehicle.quantity import Acceleration
from eom.vehicle.train import Coupling, Template, Unit, UnitUse

Vector3 = tuple[Acceleration, Acceleration, Acceleration]
AnyUnit = Annotated[
    Annotated[Unit, Tag("unit")] | Annotated[UnitUse, Tag("use")],
    Discriminator(lambda value: "use" if isinstance(value, UnitUse) or "use" in as_mapping(value) else "unit"),
]
Gravity = Annotated[
    Annotated[Acceleration, Tag("down")] | Annotated[Vector3, Tag("vector")],
    Discriminator(lambda value: "vector" if isinstance(value, (list, tuple)) else "down"),
]


class Description(Strict):
    """A mechanical system, above all a road vehicle with trailers."""

    name: str = Field(max_length=200)
    source: str = ""
    gravity: Gravity | None = None
    trim: Trim | None = None
    parameters: dict[Identifier, Parameter] = Field(default_factory=dict)
    bodies: dict[Identifier, Body] = Field(default_factory=dict)
    connectors: dict[Identifier, Connector] = Field(default_factory=dict)
    loads: dict[Identifier, Load] = Field(default_factory=dict)
    actuators: dict[Identifier, Actuator] = Field(default_factory=dict)
    sensors: dict[Identifier, Sensor] = Field(default_factory=dict)
    tyres: dict[Identifier, Tyre] = Field(default_factory=dict)
    templates: dict[Identifier, Template] = Field(default_factory=dict)
    units: dict[Identifier, AnyUnit] = Field(default_factory=dict)
    couplings: dict[Identifier, Coupling] = Field(default_factory=dict)
