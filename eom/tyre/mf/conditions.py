"""What a Magic Formula tyre is and how it is used: speeds, size, pressure, vertical and carcass stiffness."""

from dataclasses import dataclass
from typing import Any

from eom.tyre.parameters import Values, coefficient

AS_NOMINAL: Any = object()
"""Default of the inflation pressure: the nominal one."""


@dataclass(frozen=True, kw_only=True)
class ModelSpeeds:
    """Section [MODEL]: the speeds."""

    LONGVL: Values = coefficient("speed of the measurement, reference of all speed terms", "m/s", default=16.7, above=0)
    VXLOW: Values = coefficient("speed below which forces are faded", "m/s", default=1.0, above=0)


@dataclass(frozen=True, kw_only=True)
class Dimension:
    """Section [DIMENSION]: the size."""

    UNLOADED_RADIUS: Values = coefficient("free radius", "m", above=0)
    WIDTH: Values = coefficient("section width", "m", default=0.0, at_least=0)
    ASPECT_RATIO: Values = coefficient("section height over width", default=0.0, at_least=0)
    RIM_RADIUS: Values = coefficient("radius of the rim", "m", default=0.0, at_least=0)
    RIM_WIDTH: Values = coefficient("width of the rim", "m", default=0.0, at_least=0)


@dataclass(frozen=True, kw_only=True)
class OperatingConditions:
    """Section [OPERATING_CONDITIONS]: the pressures."""

    NOMPRES: Values = coefficient("pressure at which pressure terms vanish", "Pa", default=200e3, above=0)
    INFLPRES: Values = coefficient("inflation pressure; NOMPRES unless given", "Pa", default=AS_NOMINAL, above=0)


@dataclass(frozen=True, kw_only=True)
class Vertical:
    """Section [VERTICAL]: nominal load, vertical stiffness and effective rolling radius."""

    FNOMIN: Values = coefficient("nominal load", "N", above=0)
    VERTICAL_STIFFNESS: Values = coefficient("vertical stiffness; 0 if not known", "N/m", default=0.0, at_least=0)
    VERTICAL_DAMPING: Values = coefficient("vertical damping", "N*s/m", default=0.0, at_least=0)
    BREFF: Values = coefficient("effective radius: slope at low load", default=0.0)
    DREFF: Values = coefficient("effective radius: height of the arctangent", default=0.0)
    FREFF: Values = coefficient("effective radius: slope at high load", default=0.0)
    Q_RE0: Values = coefficient(
        "radius of the turning tyre at low speed over UNLOADED_RADIUS; 0 if not known", default=1.0, at_least=0
    )
    Q_V1: Values = coefficient("radius: growth with the square of speed", default=0.0)
    Q_V2: Values = coefficient("vertical stiffness: growth with speed", default=0.0)
    Q_FZ2: Values = coefficient("vertical force: quadratic term in deflection", default=0.0)
    Q_FCX: Values = coefficient("vertical stiffness: loss by longitudinal force", default=0.0)
    Q_FCY: Values = coefficient("vertical stiffness: loss by lateral force", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Vertical61(Vertical):
    """Section [VERTICAL] with pressure."""

    PFZ1: Values = coefficient("vertical stiffness: growth with pressure", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Structural:
    """Section [STRUCTURAL]: stiffnesses of the carcass, by which MF 6.1 has relaxation lengths."""

    LONGITUDINAL_STIFFNESS: Values = coefficient(
        "longitudinal stiffness of carcass and contact; 0 if not known", "N/m", default=0.0, at_least=0
    )
    LATERAL_STIFFNESS: Values = coefficient(
        "lateral stiffness of carcass and contact; 0 if not known", "N/m", default=0.0, at_least=0
    )
    PCFX1: Values = coefficient("longitudinal stiffness: linear in load", default=0.0)
    PCFX2: Values = coefficient("longitudinal stiffness: quadratic in load", default=0.0)
    PCFX3: Values = coefficient("longitudinal stiffness: linear in pressure", default=0.0)
    PCFY1: Values = coefficient("lateral stiffness: linear in load", default=0.0)
    PCFY2: Values = coefficient("lateral stiffness: quadratic in load", default=0.0)
    PCFY3: Values = coefficient("lateral stiffness: linear in pressure", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Contact52:
    """Section [CONTACT_PATCH] of MF 5.2: half length of the contact over radius."""

    Q_A1: Values = coefficient("half length of the contact: with the root of relative load", default=0.0)
    Q_A2: Values = coefficient("half length of the contact: with relative load", default=0.0)
