"""Coefficients of the Magic Formula's forces; each is a pure number in rad, N and m.

Load terms are in dfz = (Fz - LFZO FNOMIN)/(LFZO FNOMIN), pressure terms in dpi = (INFLPRES - NOMPRES)/NOMPRES.
"""

from dataclasses import dataclass

from eom.tyre.parameters import Values, coefficient


@dataclass(frozen=True, kw_only=True)
class Longitudinal:
    """Section [LONGITUDINAL_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    PCX1: Values = coefficient("shape factor C", above=0)
    PDX1: Values = coefficient("peak friction", non_zero=True)
    PDX2: Values = coefficient("peak friction: linear in load", default=0.0)
    PDX3: Values = coefficient("peak friction: loss with camber squared", default=0.0)
    PEX1: Values = coefficient("curvature E", default=0.0)
    PEX2: Values = coefficient("curvature: linear in load", default=0.0)
    PEX3: Values = coefficient("curvature: quadratic in load", default=0.0)
    PEX4: Values = coefficient("curvature: difference of driving and braking", default=0.0)
    PKX1: Values = coefficient("slip stiffness over load", non_zero=True)
    PKX2: Values = coefficient("slip stiffness over load: linear in load", default=0.0)
    PKX3: Values = coefficient("slip stiffness over load: exponent in load", default=0.0)
    PHX1: Values = coefficient("horizontal shift", default=0.0)
    PHX2: Values = coefficient("horizontal shift: linear in load", default=0.0)
    PVX1: Values = coefficient("vertical shift over load", default=0.0)
    PVX2: Values = coefficient("vertical shift over load: linear in load", default=0.0)
    RBX1: Values = coefficient("combined slip: stiffness B of the weighting", default=0.0)
    RBX2: Values = coefficient("combined slip: decline of B with longitudinal slip", default=0.0)
    RCX1: Values = coefficient("combined slip: shape C of the weighting", default=0.0)
    REX1: Values = coefficient("combined slip: curvature E of the weighting", default=0.0)
    REX2: Values = coefficient("combined slip: E, linear in load", default=0.0)
    RHX1: Values = coefficient("combined slip: shift of the slip angle", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Longitudinal61(Longitudinal):
    """Section [LONGITUDINAL_COEFFICIENTS] of MF 6.1."""

    PPX1: Values = coefficient("slip stiffness: linear in pressure", default=0.0)
    PPX2: Values = coefficient("slip stiffness: quadratic in pressure", default=0.0)
    PPX3: Values = coefficient("peak friction: linear in pressure", default=0.0)
    PPX4: Values = coefficient("peak friction: quadratic in pressure", default=0.0)
    RBX3: Values = coefficient("combined slip: B, with camber squared", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Longitudinal52(Longitudinal):
    """Section [LONGITUDINAL_COEFFICIENTS] of MF 5.2."""

    PTX1: Values = coefficient("relaxation length over radius and relative load", default=0.0)
    PTX2: Values = coefficient("relaxation length: linear in load", default=0.0)
    PTX3: Values = coefficient("relaxation length: exponent in load", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Lateral:
    """Section [LATERAL_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    PCY1: Values = coefficient("shape factor C", above=0)
    PDY1: Values = coefficient("peak friction", non_zero=True)
    PDY2: Values = coefficient("peak friction: linear in load", default=0.0)
    PDY3: Values = coefficient("peak friction: loss with camber squared", default=0.0)
    PEY1: Values = coefficient("curvature E", default=0.0)
    PEY2: Values = coefficient("curvature: linear in load", default=0.0)
    PEY3: Values = coefficient("curvature: difference of the signs of slip", default=0.0)
    PEY4: Values = coefficient("curvature: that difference with camber", default=0.0)
    PKY1: Values = coefficient("greatest cornering stiffness over nominal load; negative in ISO axes", non_zero=True)
    PKY2: Values = coefficient("load of greatest cornering stiffness over nominal load", non_zero=True)
    PKY3: Values = coefficient("cornering stiffness: loss with absolute camber", default=0.0)
    PHY1: Values = coefficient("horizontal shift", default=0.0)
    PHY2: Values = coefficient("horizontal shift: linear in load", default=0.0)
    PVY1: Values = coefficient("vertical shift over load", default=0.0)
    PVY2: Values = coefficient("vertical shift over load: linear in load", default=0.0)
    PVY3: Values = coefficient("vertical shift over load: with camber", default=0.0)
    PVY4: Values = coefficient("vertical shift over load: with camber, linear in load", default=0.0)
    RBY1: Values = coefficient("combined slip: stiffness B of the weighting", default=0.0)
    RBY2: Values = coefficient("combined slip: decline of B with the slip angle", default=0.0)
    RBY3: Values = coefficient("combined slip: slip angle of the greatest B", default=0.0)
    RCY1: Values = coefficient("combined slip: shape C of the weighting", default=0.0)
    REY1: Values = coefficient("combined slip: curvature E of the weighting", default=0.0)
    REY2: Values = coefficient("combined slip: E, linear in load", default=0.0)
    RHY1: Values = coefficient("combined slip: shift of the longitudinal slip", default=0.0)
    RHY2: Values = coefficient("combined slip: that shift, linear in load", default=0.0)
    RVY1: Values = coefficient("force by longitudinal slip, over peak force", default=0.0)
    RVY2: Values = coefficient("force by longitudinal slip: linear in load", default=0.0)
    RVY3: Values = coefficient("force by longitudinal slip: with camber", default=0.0)
    RVY4: Values = coefficient("force by longitudinal slip: decline with the slip angle", default=0.0)
    RVY5: Values = coefficient("force by longitudinal slip: factor of the arctangent", default=0.0)
    RVY6: Values = coefficient("force by longitudinal slip: slope of the arctangent", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Lateral61(Lateral):
    """Section [LATERAL_COEFFICIENTS] of MF 6.1."""

    PEY5: Values = coefficient("curvature: with camber squared", default=0.0)
    PKY4: Values = coefficient("cornering stiffness: factor of the arctangent of load", default=2.0)
    PKY5: Values = coefficient("load of greatest cornering stiffness: with camber squared", default=0.0)
    PKY6: Values = coefficient("camber stiffness over load", default=0.0)
    PKY7: Values = coefficient("camber stiffness over load: linear in load", default=0.0)
    PPY1: Values = coefficient("cornering stiffness: linear in pressure", default=0.0)
    PPY2: Values = coefficient("load of greatest cornering stiffness: linear in pressure", default=0.0)
    PPY3: Values = coefficient("peak friction: linear in pressure", default=0.0)
    PPY4: Values = coefficient("peak friction: quadratic in pressure", default=0.0)
    PPY5: Values = coefficient("camber stiffness: linear in pressure", default=0.0)
    RBY4: Values = coefficient("combined slip: B, with camber squared", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Lateral52(Lateral):
    """Section [LATERAL_COEFFICIENTS] of MF 5.2."""

    PHY3: Values = coefficient("horizontal shift: with camber", default=0.0)
    PTY1: Values = coefficient("greatest relaxation length over radius", default=0.0)
    PTY2: Values = coefficient("load of greatest relaxation length over nominal load", default=1.0)
