"""Structural connectors: beams and membranes."""

from typing import Literal

from eom.vehicle.connector import LineConnector
from eom.vehicle.parts import Flag, Identifier, Strict
from eom.vehicle.quantity import Axis, BendingStiffness, Length, MassPerLength, Place, Plain, Pressure


class Beam(LineConnector):
    """A slender beam in bending: EI for deflection along ``normal`` and across it, and mass per length.

    It neither stretches nor twists with any force: a link beside it keeps its length.
    """

    type: Literal["beam"]
    bending: tuple[BendingStiffness, BendingStiffness]
    normal: Axis
    mass_per_length: MassPerLength | None = None


class Triangle(Strict):
    """A plane-stress membrane between three bodies; ``drilling``: their rotations about its normal bend its edges."""

    type: Literal["triangle"]
    between: tuple[Identifier, Identifier, Identifier]
    corners: tuple[Place, Place, Place]
    thickness: Length
    modulus: Pressure
    poisson: Plain
    drilling: Flag = False
    mirror: Flag = False
