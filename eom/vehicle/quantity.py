"""Numbers as a file states them: plain, with a unit of measure, or an expression of parameters."""

import re
from dataclasses import dataclass
from numbers import Real
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from eom.vehicle.expression import Expression, Number, finite, parse, shorten
from eom.vehicle.units import Dimension, parse_unit, stated_in

NUMBER = r"(?>[-+]?(?:(?:0|[1-9]\d*)(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?)"
MEASURED = re.compile(rf"\s*({NUMBER})\s*((?:[A-Za-z°]|(?<=\s)1/).*?)\s*", re.ASCII)


@dataclass(frozen=True)
class Quantity:
    """A number of the description.

    Attributes
    ----------
    expression : Expression
        Its value in SI units; a `Number` if the file gives a number.
    unit : str
        SI unit of the place where it stands; ``*`` where any will do.
    dimension : tuple of float, optional
        Dimension of the unit that the file gives; None for plain numbers and expressions.
    """

    expression: Expression
    unit: str
    dimension: Dimension | None = None


def parse_quantity(value: object, unit: str) -> Quantity:
    """A file's scalar as a quantity for a place that takes *unit*; ``ValueError`` with a sentence."""
    if isinstance(value, bool) or not isinstance(value, (Real, str)):
        message = f"expected a number{in_unit(unit)}, 'number unit' or an expression, got {describe(value)}"
        raise ValueError(message)  # noqa: TRY004  pydantic collects value errors alone
    if not isinstance(value, str):
        return Quantity(Number(as_float(value)), unit)
    match = MEASURED.fullmatch(value)
    if match is None:
        return Quantity(parse(value), unit)
    factor, dimension = parse_unit(match[2])
    if unit != "*" and dimension != parse_unit(unit)[1]:
        message = f"'{shorten(value)}' is {stated_in(dimension)}, expected {unit or 'a plain number'}"
        raise ValueError(message)
    return Quantity(Number(finite(float(match[1]) * factor, value)), unit, dimension)


def as_float(value: Real) -> float:
    """The number as a float; ``ValueError`` beyond its range."""
    try:
        return finite(float(value), str(value))
    except OverflowError:
        message = "is too large for a number"
        raise ValueError(message) from None


def in_unit(unit: str) -> str:
    """The phrase that names a unit in a sentence."""
    return "" if unit in {"", "*"} else f" in {unit}"


def describe(value: object) -> str:
    """What came, in the words of a file."""
    match value:
        case bool():
            return "true" if value else "false"
        case dict():
            return "a mapping"
        case list() | tuple():
            return f"a list of {len(value)}"
        case None:
            return "nothing"
        case float():
            return f"'{value:g}'"
        case _:
            return f"'{shorten(str(value))}'"


class Slot:
    """Pydantic marker of a place that takes a quantity in one SI unit."""

    def __init__(self, unit: str) -> None:
        self.unit = unit

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate by `parse_quantity`."""
        return core_schema.no_info_plain_validator_function(lambda value: parse_quantity(value, self.unit))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe to editors a number or a text."""
        return {
            "anyOf": [{"type": "number"}, {"type": "string"}],
            "description": f"number{in_unit(self.unit)}, 'number unit', or expression of parameters",
        }


Any_ = Annotated[Quantity, Slot("*")]
Plain = Annotated[Quantity, Slot("")]
Mass = Annotated[Quantity, Slot("kg")]
Length = Annotated[Quantity, Slot("m")]
Inertia = Annotated[Quantity, Slot("kg*m^2")]
Speed = Annotated[Quantity, Slot("m/s")]
AngularSpeed = Annotated[Quantity, Slot("rad/s")]
Acceleration = Annotated[Quantity, Slot("m/s^2")]
Force = Annotated[Quantity, Slot("N")]
Moment = Annotated[Quantity, Slot("N*m")]
Stiffness = Annotated[Quantity, Slot("N/m")]
Damping = Annotated[Quantity, Slot("N*s/m")]
AngularStiffness = Annotated[Quantity, Slot("N*m/rad")]
Impulse = Annotated[Quantity, Slot("N*s")]
MassMoment = Annotated[Quantity, Slot("kg*m")]
AngularDamping = Annotated[Quantity, Slot("N*m*s/rad")]
BendingStiffness = Annotated[Quantity, Slot("N*m^2")]
MassPerLength = Annotated[Quantity, Slot("kg/m")]
Pressure = Annotated[Quantity, Slot("Pa")]
Area = Annotated[Quantity, Slot("m^2")]
Density = Annotated[Quantity, Slot("kg/m^3")]
CorneringStiffness = Annotated[Quantity, Slot("N/rad")]
Time = Annotated[Quantity, Slot("s")]
TorquePerPressure = Annotated[Quantity, Slot("N*m/Pa")]

Place = tuple[Length, Length, Length]
Axis = tuple[Plain, Plain, Plain]
