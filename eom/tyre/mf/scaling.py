"""Scaling factors of the Magic Formula, by which users adapt a measured tyre; 1 leaves it as measured."""

from dataclasses import dataclass

from eom.tyre.parameters import Values, coefficient


@dataclass(frozen=True, kw_only=True)
class Scaling:
    """Section [SCALING_COEFFICIENTS]: what MF 5.2 and 6.1 share."""

    LFZO: Values = coefficient("scales the nominal load", default=1.0, above=0)
    LCX: Values = coefficient("scales the shape factor of Fx", default=1.0, above=0)
    LMUX: Values = coefficient("scales the peak friction of Fx", default=1.0, above=0)
    LEX: Values = coefficient("scales the curvature of Fx", default=1.0)
    LKX: Values = coefficient("scales the slip stiffness", default=1.0, above=0)
    LHX: Values = coefficient("scales the horizontal shift of Fx", default=1.0)
    LVX: Values = coefficient("scales the vertical shift of Fx", default=1.0)
    LCY: Values = coefficient("scales the shape factor of Fy", default=1.0, above=0)
    LMUY: Values = coefficient("scales the peak friction of Fy", default=1.0, above=0)
    LEY: Values = coefficient("scales the curvature of Fy", default=1.0)
    LKY: Values = coefficient("scales the cornering stiffness", default=1.0, above=0)
    LHY: Values = coefficient("scales the horizontal shift of Fy", default=1.0)
    LVY: Values = coefficient("scales the vertical shift of Fy", default=1.0)
    LKYC: Values = coefficient("scales the lateral force by camber", default=1.0)
    LTR: Values = coefficient("scales the pneumatic trail", default=1.0)
    LRES: Values = coefficient("scales the residual moment at zero camber", default=1.0)
    LKZC: Values = coefficient("scales the aligning moment by camber", default=1.0)
    LXAL: Values = coefficient("scales the effect of the slip angle on Fx", default=1.0)
    LYKA: Values = coefficient("scales the effect of longitudinal slip on Fy", default=1.0)
    LVYKA: Values = coefficient("scales the lateral force that longitudinal slip causes", default=1.0)
    LS: Values = coefficient("scales the lever arm of Fx about the vertical", default=1.0)
    LMX: Values = coefficient("scales the overturning moment", default=1.0)
    LVMX: Values = coefficient("scales the offset of the overturning moment", default=1.0)
    LMY: Values = coefficient("scales the rolling resistance moment", default=1.0)


@dataclass(frozen=True, kw_only=True)
class Scaling61(Scaling):
    """Section [SCALING_COEFFICIENTS] of MF 6.1."""

    LMUV: Values = coefficient(
        "loss of friction with slip speed over LONGVL, a cone at zero slip; only in the book's form", default=0.0
    )


@dataclass(frozen=True, kw_only=True)
class Scaling52(Scaling):
    """Section [SCALING_COEFFICIENTS] of MF 5.2."""

    LGAX: Values = coefficient("scales camber in Fx", default=1.0)
    LGAY: Values = coefficient("scales camber in Fy", default=1.0)
    LGAZ: Values = coefficient("scales camber in Mz", default=1.0)
    LSGKP: Values = coefficient("scales the longitudinal relaxation length", default=1.0)
    LSGAL: Values = coefficient("scales the lateral relaxation length", default=1.0)
