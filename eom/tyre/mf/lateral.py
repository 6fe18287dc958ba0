"""Lateral force in pure slip, E19 to E30, and its weighting in combined slip, E58 to E67."""

from typing import Any, NamedTuple

from eom.tyre.curve import VANISHING, cosine, sine
from eom.tyre.elementary import arctan, magnitude, sense, sin, sqrt
from eom.tyre.mf.state import WorkingPoint
from eom.tyre.parameters import Values


class SideForce(NamedTuple):
    """The lateral force in pure slip and what else depends on it.

    Attributes
    ----------
    Fy0 : float or array
        Force [N].
    mu : float or array
        Peak friction.
    K : float or array
        Cornering stiffness dF_y/dalpha [N/rad].
    S_H, S_V : float or array
        Horizontal shift [rad] and vertical shift [N].
    BC : float or array
        Product of stiffness and shape factor.
    """

    Fy0: Any
    mu: Any
    K: Any
    S_H: Any
    S_V: Any
    BC: Any


def cornering_stiffness_61(p: Any, s: WorkingPoint, gamma: Values, dpi: Values) -> Any:
    """K_ya [N/rad], E25."""
    peak = p.PKY1 * s.Fz0 * (1.0 + p.PPY1 * dpi) * (1.0 - p.PKY3 * magnitude(gamma))
    load = (s.load / s.Fz0) / ((p.PKY2 + p.PKY5 * gamma * gamma) * (1.0 + p.PPY2 * dpi))
    return peak * sin(p.PKY4 * arctan(load)) * p.LKY


def camber_stiffness_61(p: Any, s: WorkingPoint, dpi: Values) -> Any:
    """K_yg0 [N/rad], E30."""
    return s.load * (p.PKY6 + p.PKY7 * s.dfz) * (1.0 + p.PPY5 * dpi) * p.LKYC


def pure_lateral_61(p: Any, s: WorkingPoint, gamma: Values, dpi: Values) -> SideForce:
    """The lateral force at a camber, E19, version 6.1: camber shifts the curve so that its slope there is K_yg0."""
    K = cornering_stiffness_61(p, s, gamma, dpi)
    thrust = s.load * (p.PVY3 + p.PVY4 * s.dfz) * gamma * p.LKYC * s.shift_y
    shift = (p.PHY1 + p.PHY2 * s.dfz) * p.LHY + (camber_stiffness_61(p, s, dpi) * gamma - thrust) / (K + VANISHING)
    mu = (p.PDY1 + p.PDY2 * s.dfz) * (1.0 + dpi * (p.PPY3 + p.PPY4 * dpi)) * (1.0 - p.PDY3 * gamma * gamma) * s.mu_y
    return pure_lateral(p, s, (shift, thrust), (K, mu), (1.0 + p.PEY5 * gamma * gamma, p.PEY3 + p.PEY4 * gamma))


def cornering_stiffness_52(p: Any, s: WorkingPoint, gamma: Values) -> Any:
    """K_y [N/rad] of version 5.2."""
    return p.PKY1 * s.Fz0 * (1.0 - p.PKY3 * magnitude(gamma)) * sin(2.0 * arctan(s.load / (p.PKY2 * s.Fz0))) * p.LKY


def pure_lateral_52(p: Any, s: WorkingPoint, gamma: Values) -> SideForce:
    """The lateral force at a camber, version 5.2: camber shifts the curve by an angle of its own."""
    K = cornering_stiffness_52(p, s, gamma)
    thrust = s.load * (p.PVY3 + p.PVY4 * s.dfz) * gamma * p.LKYC * s.shift_y
    shift = (p.PHY1 + p.PHY2 * s.dfz) * p.LHY + p.PHY3 * gamma * p.LKYC
    mu = (p.PDY1 + p.PDY2 * s.dfz) * (1.0 - p.PDY3 * gamma * gamma) * s.mu_y
    return pure_lateral(p, s, (shift, thrust), (K, mu), (1.0, p.PEY3 + p.PEY4 * gamma))


def pure_lateral(
    p: Any,
    s: WorkingPoint,
    camber: tuple[Values, Values],
    stiffness: tuple[Values, Values],
    curvature: tuple[Values, Values],
) -> SideForce:
    """What both versions share: *camber* are shift and thrust by it, *stiffness* slope and peak friction.

    *curvature* are the factor of E and its difference between the signs of slip.
    """
    shift, thrust = camber
    K, mu = stiffness
    even, odd = curvature
    S_H = shift * s.fade
    S_V = (s.load * (p.PVY1 + p.PVY2 * s.dfz) * p.LVY * s.shift_y + thrust) * s.fade
    C, D = p.PCY1 * p.LCY, mu * s.load
    slip = s.alpha + S_H
    E = (p.PEY1 + p.PEY2 * s.dfz) * (even - odd * sense(slip)) * p.LEY
    BC = K / (D + VANISHING)
    return SideForce(D * sine(BC / C * slip, C, E) + S_V, mu, K, S_H, S_V, BC)


def lateral_weight(p: Any, s: WorkingPoint, kappa: Values, slope: Values) -> Any:
    """G_yk, E59, at a longitudinal slip; *slope* is its stiffness factor B at the slip angle RBY3."""
    alpha = p.RBY2 * (s.alpha - p.RBY3)
    B = slope / sqrt(1.0 + alpha * alpha) * p.LYKA
    E = p.REY1 + p.REY2 * s.dfz
    S_H = (p.RHY1 + p.RHY2 * s.dfz) * s.reverse
    return cosine(B * (kappa + S_H), p.RCY1, E) / cosine(B * S_H, p.RCY1, E)


def slip_thrust(p: Any, s: WorkingPoint, kappa: Values, mu: Values) -> Any:
    """S_Vyk [N], the side force that longitudinal slip brings, E66; *mu* is the lateral friction."""
    alpha = p.RVY4 * s.alpha
    D = mu * s.load * (p.RVY1 + p.RVY2 * s.dfz + p.RVY3 * s.gamma) / sqrt(1.0 + alpha * alpha)
    return D * sin(p.RVY5 * arctan(p.RVY6 * kappa)) * p.LVYKA * s.reverse
