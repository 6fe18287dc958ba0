"""Relaxation lengths: the way a tyre rolls until its force has followed its slip."""

from typing import NamedTuple, cast

import numpy as np

from eom.errors import TyreError
from eom.tyre.elementary import exp, magnitude
from eom.tyre.interface import as_numbers
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.mf.lateral import cornering_stiffness_61
from eom.tyre.mf.longitudinal import slip_stiffness
from eom.tyre.mf.state import WorkingPoint, book_state, tool_state
from eom.tyre.parameters import Values


class Relaxation(NamedTuple):
    """Relaxation lengths [m] of longitudinal slip and of slip angle."""

    kappa: Values
    alpha: Values


def relaxation_lengths(tyre: MagicFormula61 | MagicFormula52, Fz: Values, gamma: Values = 0.0) -> Relaxation:
    """Relaxation lengths of a Magic Formula tyre at a load [N] and a camber angle [rad].

    Version 6.1: slip stiffness over the carcass's stiffness (Besselink, Schmeitz, Pacejka 2010, (17) to (19));
    version 5.2: formulas of their own, which give zero where the tyre has no coefficients for them: its force follows
    its slip at once. Near lift-off they go to those of half a percent of the nominal load, so that they stay positive.

    Raises
    ------
    TyreError
        If a version 6.1 tyre does not know its carcass's stiffness, or for a tyre of another model.
    """
    if not isinstance(tyre, MagicFormula61 | MagicFormula52):
        raise TyreError(f"a {type(tyre).__name__} has no relaxation lengths; Magic Formula 6.1 and 5.2 tyres have")
    point = 0.0, 0.0, as_numbers("Fz", Fz), tyre.hand * as_numbers("gamma", gamma), tyre.LONGVL
    if isinstance(tyre, MagicFormula52):
        return relaxation_52(tyre, tool_state(tyre, *point))
    return relaxation_61(tyre, (tool_state if tyre.form == "tool" else book_state)(tyre, *point))


def relaxation_61(tyre: MagicFormula61, s: WorkingPoint) -> Relaxation:
    """(19) of the paper."""
    names = ("LONGITUDINAL_STIFFNESS", "LATERAL_STIFFNESS")
    missing = [name for name in names if not np.all(np.asarray(getattr(tyre, name)) > 0.0)]
    if missing:
        raise TyreError(f"relaxation lengths need {' and '.join(missing)}: give them, in [STRUCTURAL] of the .tir file")
    dpi = (tyre.INFLPRES - tyre.NOMPRES) / tyre.NOMPRES
    K_x = slip_stiffness(tyre, s, 1.0 + dpi * (tyre.PPX1 + tyre.PPX2 * dpi))
    K_y = cornering_stiffness_61(tyre, s, s.gamma, dpi)
    C_x = tyre.LONGITUDINAL_STIFFNESS * (1.0 + s.dfz * (tyre.PCFX1 + tyre.PCFX2 * s.dfz)) * (1.0 + tyre.PCFX3 * dpi)
    C_y = tyre.LATERAL_STIFFNESS * (1.0 + s.dfz * (tyre.PCFY1 + tyre.PCFY2 * s.dfz)) * (1.0 + tyre.PCFY3 * dpi)
    return Relaxation(magnitude(K_x / C_x), magnitude(K_y / C_y))


def relaxation_52(tyre: MagicFormula52, s: WorkingPoint) -> Relaxation:
    """The formulas of version 5.2."""
    load = s.load / tyre.FNOMIN
    x = (tyre.PTX1 + tyre.PTX2 * s.dfz) * exp(-tyre.PTX3 * s.dfz) * load * tyre.LSGKP
    # sin(2 arctan(load/greatest)), which is 0 where PTY2 is
    greatest = tyre.PTY2 * s.Fz0
    rise = 2.0 * s.load * greatest / (s.load * s.load + greatest * greatest)
    y = tyre.PTY1 * rise * (1.0 - tyre.PKY3 * magnitude(tyre.LGAY * s.gamma))
    radius = tyre.UNLOADED_RADIUS
    return Relaxation(cast("Values", x * radius), cast("Values", y * radius * tyre.LFZO * tyre.LSGAL))
