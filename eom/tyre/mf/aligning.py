"""Aligning moment: pneumatic trail and residual moment, E31 to E49 and E71 to E78."""

from typing import Any, NamedTuple

import numpy as np

from eom.tyre.curve import VANISHING, bend
from eom.tyre.elementary import arctan, cos, magnitude, sqrt, tan
from eom.tyre.mf.lateral import SideForce
from eom.tyre.mf.state import WorkingPoint
from eom.tyre.parameters import Values


class Trail(NamedTuple):
    """Factors of the pneumatic trail.

    Attributes
    ----------
    B, D : float or array
        Stiffness factor, and peak [m].
    """

    B: Any
    D: Any


def tool_trail(p: Any, s: WorkingPoint, gamma: Values, pressure: Values) -> Trail:
    """A58 and A60: both change with camber and its sign; the whole trail is scaled with the nominal load.

    *pressure* is the factor of inflation.
    """
    B = (1.0 + p.QBZ4 * gamma + p.QBZ5 * magnitude(gamma)) * trail_slope(p, s)
    D = (1.0 + gamma * (p.QDZ3 + p.QDZ4 * gamma)) * pressure * trail_peak(p, s)
    return Trail(B, D * p.LFZO)


def book_trail(p: Any, s: WorkingPoint, pressure: Values) -> Trail:
    """E40, E42 and E43: both change with camber whatever its sign."""
    lean = magnitude(s.gamma)
    B = (1.0 + p.QBZ5 * lean + p.QBZ6 * lean * lean) * trail_slope(p, s)
    D = (1.0 + lean * (p.QDZ3 + p.QDZ4 * lean)) * pressure * trail_peak(p, s)
    return Trail(B, D)


def trail_slope(p: Any, s: WorkingPoint) -> Any:
    """Stiffness factor of the trail without camber."""
    return (p.QBZ1 + s.dfz * (p.QBZ2 + p.QBZ3 * s.dfz)) * p.LKY / s.mu_y


def trail_peak(p: Any, s: WorkingPoint) -> Any:
    """Peak of the trail [m] without camber and pressure; behind the wheel's centre also in reverse."""
    return s.load * (p.QDZ1 + p.QDZ2 * s.dfz) * (p.UNLOADED_RADIUS / s.Fz0) * p.LTR * s.reverse


def trail(p: Any, s: WorkingPoint, t: Trail, gamma: Values, slip: Values, combined: Values) -> Any:
    """Pneumatic trail [m], E73: *slip* is the shifted slip angle, *combined* the same with longitudinal slip."""
    E = (p.QEZ1 + s.dfz * (p.QEZ2 + p.QEZ3 * s.dfz)) * (
        1.0 + (p.QEZ4 + p.QEZ5 * gamma) * (2.0 / np.pi) * arctan(t.B * p.QCZ1 * slip)
    )
    return t.D * cos(p.QCZ1 * arctan(bend(t.B * combined, E))) * s.cosine


def residual_moment(p: Any, s: WorkingPoint, y: SideForce, peak: Values, combined: Values) -> Any:
    """M_zr [N m], E75: *peak* is what stands in the braces of E47, *combined* the slip angle of the residual moment."""
    slip = (p.QBZ9 * p.LKY / s.mu_y + p.QBZ10 * y.BC) * combined
    # cos(arctan z) = 1/sqrt(1 + z^2)
    return s.load * p.UNLOADED_RADIUS * peak * s.mu_y * s.cosine * s.reverse / sqrt(1.0 + slip * slip)


def residual_slip(s: WorkingPoint, y: SideForce) -> Any:
    """alpha_r, E37 and E38: slip angle counted from where the lateral force vanishes."""
    return s.alpha + y.S_H + y.S_V / (y.K + VANISHING)


def trail_slip(p: Any, s: WorkingPoint, gamma: Values) -> Any:
    """alpha_t, E34 and E35."""
    return s.alpha + p.QHZ1 + p.QHZ2 * s.dfz + (p.QHZ3 + p.QHZ4 * s.dfz) * gamma


def tool_combined(slip: Values, kappa: Values) -> Any:
    """Slip angle with longitudinal slip [rad], A54 and A55, without its sign, of which the curves do not depend."""
    slope = tan(slip)
    return arctan(sqrt(slope * slope + kappa * kappa))


def book_combined(slip: Values, kappa: Values) -> Any:
    """The same by E77 and E78."""
    return sqrt(slip * slip + kappa * kappa)
