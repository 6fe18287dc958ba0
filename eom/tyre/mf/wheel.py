"""Overturning and rolling resistance moment, and the arm of the longitudinal force about the vertical axis."""

from typing import Any

from eom.tyre.contact import kept_above, rolling_sense, rolling_speed
from eom.tyre.elementary import arctan, cos, exp, log, magnitude, sin
from eom.tyre.mf.state import WorkingPoint
from eom.tyre.parameters import Values


def overturning_61(p: Any, s: WorkingPoint, Fy: Values, dpi: Values) -> Any:
    """M_x [N m], E69."""
    gamma, force, load = s.camber, Fy / p.FNOMIN, s.load / p.FNOMIN
    squared = p.QSX6 * load * (p.QSX6 * load)
    bracket = (
        p.QSX1 * p.LVMX
        - p.QSX2 * gamma * (1.0 + p.PPMX1 * dpi)
        + p.QSX3 * force
        + p.QSX4 * cos(p.QSX5 * arctan(squared)) * sin(p.QSX7 * gamma + p.QSX8 * arctan(p.QSX9 * force))
        + p.QSX10 * arctan(p.QSX11 * load) * gamma
    )
    return p.UNLOADED_RADIUS * p.LMX * s.load * bracket


def overturning_draft(p: Any, s: WorkingPoint, Fy: Values) -> Any:
    """The terms [N m] that (49) of the draft of Besselink, Schmeitz and Pacejka's paper has beside E69."""
    lean = magnitude(s.camber)
    return p.UNLOADED_RADIUS * p.LMX * (Fy * (p.QSX13 + p.QSX14 * lean) - s.load * p.QSX12 * s.camber * lean)


def overturning_52(p: Any, s: WorkingPoint, Fy: Values) -> Any:
    """M_x [N m] of version 5.2."""
    bracket = p.QSX1 * p.LVMX - p.QSX2 * s.camber + p.QSX3 * Fy / p.FNOMIN
    return p.UNLOADED_RADIUS * p.LMX * s.load * bracket


def resistance(p: Any, Fx: Values, speed: Values) -> Any:
    """Rolling resistance moment over radius and load, the part that both versions have."""
    v = kept_above(magnitude(speed), p.VXLOW) / p.LONGVL
    return p.QSY1 + p.QSY2 * Fx / p.FNOMIN + p.QSY3 * v + p.QSY4 * (v * v) * (v * v)


def rolling_61(p: Any, s: WorkingPoint, Fx: Values, speed: Values, unit: Values) -> Any:
    """M_y [N m], A48 or E70; *unit* is the load [N] that multiplies: nominal in the tool, actual in the book."""
    load = s.load / p.FNOMIN
    lean = (p.QSY5 + p.QSY6 * load) * s.camber * s.camber
    powers = exp(p.QSY7 * log(load) + p.QSY8 * log(p.INFLPRES / p.NOMPRES))
    return -p.UNLOADED_RADIUS * unit * p.LMY * (resistance(p, Fx, speed) + lean) * powers * direction(p, s, speed)


def rolling_52(p: Any, s: WorkingPoint, Fx: Values, speed: Values) -> Any:
    """M_y [N m] of version 5.2."""
    return -p.UNLOADED_RADIUS * s.load * p.LMY * resistance(p, Fx, speed) * direction(p, s, speed)


def direction(p: Any, s: WorkingPoint, speed: Values) -> Any:
    """Sense of the wheel's rotation, through zero at standstill."""
    return rolling_sense(rolling_speed(s.kappa, speed, p.VXLOW), p.VXLOW)


def longitudinal_arm(p: Any, s: WorkingPoint, Fy: Values, gamma: Values, nominal: Values) -> Any:
    """S [m], E76: the lever of F_x about the vertical axis; *nominal* is the load [N] that divides F_y."""
    arm = p.SSZ1 + p.SSZ2 * Fy / nominal + (p.SSZ3 + p.SSZ4 * s.dfz) * gamma
    return p.UNLOADED_RADIUS * arm * p.LS
