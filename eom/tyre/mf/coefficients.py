"""Coefficients of the Magic Formula 6.1 and of its predecessor 5.2, by their names in .tir files."""

import dataclasses
from dataclasses import dataclass
from typing import Literal, Self, get_args

import numpy as np

from eom.errors import TyreError
from eom.tyre.interface import Formula, Tyre
from eom.tyre.mf.conditions import (
    AS_NOMINAL,
    Contact52,
    Dimension,
    ModelSpeeds,
    OperatingConditions,
    Structural,
    Vertical,
    Vertical61,
)
from eom.tyre.mf.force_coefficients import Lateral52, Lateral61, Longitudinal52, Longitudinal61
from eom.tyre.mf.formulas import book_61, tool_52, tool_61
from eom.tyre.mf.moment_coefficients import (
    Aligning,
    Aligning61,
    Overturning,
    Overturning61,
    RollingResistance,
    RollingResistance61,
)
from eom.tyre.mf.ranges import (
    InclinationAngleRange,
    InflationPressureRange,
    LongSlipRange,
    SlipAngleRange,
    VerticalForceRange,
)
from eom.tyre.mf.relations import relation_problems
from eom.tyre.mf.scaling import Scaling52, Scaling61
from eom.tyre.parameters import Values, bound_problems

Form = Literal["tool", "book"]
Side = Literal["left", "right"]
Use = Literal["longitudinal", "lateral", "uncombined", "combined"]

CHOICES = {
    "side": (None, *get_args(Side)),
    "use": get_args(Use),
    "form": get_args(Form),
}


@dataclass(frozen=True, kw_only=True)
class Mounting(Tyre, ModelSpeeds, Dimension, LongSlipRange, SlipAngleRange, InclinationAngleRange, VerticalForceRange):
    """What both versions have beside the coefficients of their equations.

    Attributes
    ----------
    side : "left", "right" or None
        The side of the vehicle that the coefficients are for; None if they are for both, or if it is not known.
    mirror : bool, or array of them
        Whether the forces are those of the mirrored tyre.
    use : "longitudinal", "lateral", "uncombined" or "combined"
        Which forces act: Fx and My; Fy, Mx and Mz; all, without or with interaction of the slips.
    """

    side: Side | None = None
    mirror: bool = False
    use: Use = "combined"

    def __post_init__(self) -> None:
        name = type(self).__name__
        wrong = bound_problems(self)
        wrong += [f"{name}: {key} = {getattr(self, key)}: {what}" for key, what in relation_problems(self, vars(self))]
        wrong += [
            f"{name}: {key} = {getattr(self, key)!r}: expected one of {', '.join(map(repr, known))}"
            for key, known in CHOICES.items()
            if hasattr(self, key) and getattr(self, key) not in known
        ]
        if np.asarray(self.mirror).dtype != bool:
            wrong.append(f"{name}: mirror = {self.mirror!r}: expected True or False")
        if wrong:
            raise TyreError("\n".join(wrong))

    @property
    def hand(self) -> Values:
        """One, or -1 for the mirrored tyre, whose lateral channels change sign."""
        return 1.0 - 2.0 * np.asarray(self.mirror, dtype=float)

    @property
    def meet(self) -> float:
        """Whether both slips act on both forces."""
        return float(self.use == "combined")

    @property
    def drives(self) -> float:
        """Whether Fx and My act."""
        return float(self.use != "lateral")

    @property
    def corners(self) -> float:
        """Whether Fy, Mx and Mz act."""
        return float(self.use != "longitudinal")

    def on(self, side: Side) -> Self:
        """The tyre mounted on a side: mirrored if its coefficients are for the other one, else as they are.

        A tyre whose `side` is None is given back unchanged.

        Raises
        ------
        TyreError
            For a side that is neither "left" nor "right".
        """
        if side not in {"left", "right"}:
            raise TyreError(f"a tyre is on side 'left' or 'right', not {side!r}")
        return self if self.side is None else dataclasses.replace(self, mirror=side != self.side)


@dataclass(frozen=True, kw_only=True)
class MagicFormula61(
    Mounting,
    OperatingConditions,
    Vertical61,
    Structural,
    InflationPressureRange,
    Scaling61,
    Longitudinal61,
    Overturning61,
    Lateral61,
    RollingResistance61,
    Aligning61,
):
    """Tyre of the Magic Formula 6.1 (FITTYP 61).

    The coefficients are those of the equations in H. B. Pacejka, "Tire and Vehicle Dynamics", 3rd edition, 2012,
    chapter 4.3.2, and in I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka, "An improved Magic Formula/Swift tyre
    model that can handle inflation pressure changes", Vehicle System Dynamics 48, 2010.

    Attributes
    ----------
    form : "tool" or "book"
        The equations as the MF-Tyre program computes them, or as the book prints them.

    Raises
    ------
    TyreError
        With a sentence for every coefficient that is no finite number or is out of its bounds.
    """

    form: Form = "tool"

    def __post_init__(self) -> None:
        if self.INFLPRES is AS_NOMINAL:
            object.__setattr__(self, "INFLPRES", self.NOMPRES)
        super().__post_init__()

    @property
    def formula(self) -> Formula:
        """The equations."""
        return tool_61 if self.form == "tool" else book_61


@dataclass(frozen=True, kw_only=True)
class MagicFormula52(
    Mounting, Vertical, Contact52, Scaling52, Longitudinal52, Overturning, Lateral52, RollingResistance, Aligning
):
    """Tyre of the Magic Formula 5.2 (FITTYP 6), which the format PAC2002 has as well.

    It knows no inflation pressure. The coefficients are those of the equations in "MF-Tyre User Manual Version 5.2",
    TNO Automotive, 2001.

    Raises
    ------
    TyreError
        With a sentence for every coefficient that is no finite number or is out of its bounds.
    """

    @property
    def formula(self) -> Formula:
        """The equations."""
        return tool_52
