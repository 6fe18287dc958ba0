"""Coefficients of the Magic Formula's moments; each is a pure number in rad, N and m."""

from dataclasses import dataclass

from eom.tyre.parameters import Values, coefficient


@dataclass(frozen=True, kw_only=True)
class Overturning:
    """Section [OVERTURNING_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    QSX1: Values = coefficient("offset over load and radius", default=0.0)
    QSX2: Values = coefficient("moment by camber", default=0.0)
    QSX3: Values = coefficient("moment by lateral force", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Overturning61(Overturning):
    """Section [OVERTURNING_COEFFICIENTS] of MF 6.1."""

    QSX4: Values = coefficient("load term: height", default=0.0)
    QSX5: Values = coefficient("load term: factor of the arctangent of load squared", default=0.0)
    QSX6: Values = coefficient("load term: slope of that arctangent", default=0.0)
    QSX7: Values = coefficient("load term: with camber", default=0.0)
    QSX8: Values = coefficient("load term: with the arctangent of lateral force", default=0.0)
    QSX9: Values = coefficient("load term: slope of that arctangent", default=0.0)
    QSX10: Values = coefficient("moment by camber and the arctangent of load", default=0.0)
    QSX11: Values = coefficient("slope of that arctangent", default=0.0)
    QSX12: Values = coefficient("moment by camber times absolute camber", default=0.0)
    QSX13: Values = coefficient("lever arm of lateral force over radius", default=0.0)
    QSX14: Values = coefficient("lever arm of lateral force: with absolute camber", default=0.0)
    PPMX1: Values = coefficient("moment by camber: linear in pressure", default=0.0)


@dataclass(frozen=True, kw_only=True)
class RollingResistance:
    """Section [ROLLING_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    QSY1: Values = coefficient("rolling resistance", default=0.0)
    QSY2: Values = coefficient("rolling resistance: with longitudinal force over nominal load", default=0.0)
    QSY3: Values = coefficient("rolling resistance: with speed over LONGVL", default=0.0)
    QSY4: Values = coefficient("rolling resistance: with its fourth power", default=0.0)


@dataclass(frozen=True, kw_only=True)
class RollingResistance61(RollingResistance):
    """Section [ROLLING_COEFFICIENTS] of MF 6.1."""

    QSY5: Values = coefficient("rolling resistance: with camber squared", default=0.0)
    QSY6: Values = coefficient("rolling resistance: with load and camber squared", default=0.0)
    QSY7: Values = coefficient("exponent of relative load", default=0.0)
    QSY8: Values = coefficient("exponent of relative pressure", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Aligning:
    """Section [ALIGNING_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    QBZ1: Values = coefficient("trail: stiffness B", default=0.0)
    QBZ2: Values = coefficient("trail: B, linear in load", default=0.0)
    QBZ3: Values = coefficient("trail: B, quadratic in load", default=0.0)
    QBZ4: Values = coefficient("trail: B, with camber; not in the book's form", default=0.0)
    QBZ5: Values = coefficient("trail: B, with absolute camber", default=0.0)
    QBZ9: Values = coefficient("residual moment: B", default=0.0)
    QBZ10: Values = coefficient("residual moment: B, with the stiffness factor of lateral force", default=0.0)
    QCZ1: Values = coefficient("trail: shape C", default=0.0)
    QDZ1: Values = coefficient("trail: height over radius and relative load", default=0.0)
    QDZ2: Values = coefficient("trail: height, linear in load", default=0.0)
    QDZ3: Values = coefficient("trail: height, with camber", default=0.0)
    QDZ4: Values = coefficient("trail: height, with camber squared", default=0.0)
    QDZ6: Values = coefficient("residual moment over load and radius", default=0.0)
    QDZ7: Values = coefficient("residual moment: linear in load", default=0.0)
    QDZ8: Values = coefficient("residual moment: with camber", default=0.0)
    QDZ9: Values = coefficient("residual moment: with camber, linear in load", default=0.0)
    QEZ1: Values = coefficient("trail: curvature E", default=0.0)
    QEZ2: Values = coefficient("trail: E, linear in load", default=0.0)
    QEZ3: Values = coefficient("trail: E, quadratic in load", default=0.0)
    QEZ4: Values = coefficient("trail: E, difference of the signs of slip", default=0.0)
    QEZ5: Values = coefficient("trail: E, that difference with camber", default=0.0)
    QHZ1: Values = coefficient("trail: shift", default=0.0)
    QHZ2: Values = coefficient("trail: shift, linear in load", default=0.0)
    QHZ3: Values = coefficient("trail: shift, with camber", default=0.0)
    QHZ4: Values = coefficient("trail: shift, with camber, linear in load", default=0.0)
    SSZ1: Values = coefficient("lever arm of Fx over radius", default=0.0)
    SSZ2: Values = coefficient("lever arm of Fx: with lateral force over nominal load", default=0.0)
    SSZ3: Values = coefficient("lever arm of Fx: with camber", default=0.0)
    SSZ4: Values = coefficient("lever arm of Fx: with camber, linear in load", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Aligning61(Aligning):
    """Section [ALIGNING_COEFFICIENTS] of MF 6.1."""

    QBZ6: Values = coefficient("trail: B, with camber squared; only in the book's form", default=0.0)
    QDZ10: Values = coefficient("residual moment: with camber times absolute camber", default=0.0)
    QDZ11: Values = coefficient("residual moment: with that, linear in load", default=0.0)
    PPZ1: Values = coefficient("trail: loss with pressure", default=0.0)
    PPZ2: Values = coefficient("residual moment by camber: linear in pressure", default=0.0)
