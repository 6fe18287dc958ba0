"""What connectors have in common: the bodies that they join, and where."""

from typing import Annotated, Literal

from pydantic import BeforeValidator

from eom.vehicle.parts import Flag, Identifier, Strict, not_a_flag
from eom.vehicle.quantity import Axis, Place

# without the check true would count as 1
Count = Annotated[Literal[0, 1, 2, 3], BeforeValidator(not_a_flag)]
Pair = tuple[Identifier, Identifier]


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


class LineConnector(Strict):
    """A line from a place on the first body to a place on the second one."""

    between: Pair
    ends: tuple[Place, Place]
    mirror: Flag = False
