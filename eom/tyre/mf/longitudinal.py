"""Longitudinal force in pure slip, E9 to E18, and its weighting in combined slip, E50 to E57."""

from typing import Any

from eom.tyre.curve import VANISHING, cosine, sine
from eom.tyre.elementary import exp, sense, sqrt
from eom.tyre.mf.state import WorkingPoint
from eom.tyre.parameters import Values


def slip_stiffness(p: Any, s: WorkingPoint, pressure: Values) -> Any:
    """K_xk [N], E15; *pressure* is the factor of inflation."""
    return s.load * (p.PKX1 + p.PKX2 * s.dfz) * exp(p.PKX3 * s.dfz) * pressure * p.LKX


def pure_longitudinal(p: Any, s: WorkingPoint, camber: Values, K: Values, pressure: Values) -> Any:
    """F_x0 [N], E9; *K* is the slip stiffness, *pressure* the factor of inflation in friction.

    In reverse the shifts and the difference between driving and braking change sides.
    """
    C = p.PCX1 * p.LCX
    mu = (p.PDX1 + p.PDX2 * s.dfz) * pressure * (1.0 - p.PDX3 * camber * camber) * s.mu_x
    D = mu * s.load
    slip = s.kappa + (p.PHX1 + p.PHX2 * s.dfz) * p.LHX * s.reverse
    S_V = s.load * (p.PVX1 + p.PVX2 * s.dfz) * p.LVX * s.shift_x * s.reverse
    E = (p.PEX1 + s.dfz * (p.PEX2 + p.PEX3 * s.dfz)) * (1.0 - p.PEX4 * sense(slip) * s.reverse) * p.LEX
    return D * sine(K * slip / (C * D + VANISHING), C, E) + S_V


def longitudinal_weight(p: Any, s: WorkingPoint, alpha: Values, slope: Values) -> Any:
    """G_xa, E51, at a slip angle; *slope* is its stiffness factor B at zero longitudinal slip."""
    kappa = p.RBX2 * s.kappa
    B = slope / sqrt(1.0 + kappa * kappa) * p.LXAL
    E = p.REX1 + p.REX2 * s.dfz
    return cosine(B * (alpha + p.RHX1), p.RCX1, E) / cosine(B * p.RHX1, p.RCX1, E)
