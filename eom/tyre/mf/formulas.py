"""Forces and moments of the Magic Formula: the tool's and the book's form of version 6.1, and version 5.2."""

from typing import Any

from eom.tyre.curve import VANISHING
from eom.tyre.elementary import magnitude
from eom.tyre.mf.aligning import (
    book_combined,
    book_trail,
    residual_moment,
    residual_slip,
    tool_combined,
    tool_trail,
    trail,
    trail_slip,
)
from eom.tyre.mf.lateral import SideForce, lateral_weight, pure_lateral_52, pure_lateral_61, slip_thrust
from eom.tyre.mf.longitudinal import longitudinal_weight, pure_longitudinal, slip_stiffness
from eom.tyre.mf.state import WorkingPoint, book_state, tool_state
from eom.tyre.mf.wheel import (
    longitudinal_arm,
    overturning_52,
    overturning_61,
    overturning_draft,
    rolling_52,
    rolling_61,
)
from eom.tyre.parameters import Values


def tool_61(p: Any, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of version 6.1 as the MF-Tyre tool computes them."""
    s = tool_state(p, p.hand * alpha, kappa, Fz, p.hand * gamma, speed)
    dpi = (p.INFLPRES - p.NOMPRES) / p.NOMPRES
    K, Fx = longitudinal_61(p, s, dpi)
    side, G, Fy = lateral_61(p, s, dpi)
    Fy_upright = pure_lateral_61(p, s, 0.0 * s.gamma, dpi).Fy0
    drag, slip = p.meet * s.kappa * K / (side.K + VANISHING), trail_slip(p, s, s.gamma)
    t = trail(p, s, tool_trail(p, s, s.camber, 1.0 - p.PPZ1 * dpi), s.gamma, slip, tool_combined(slip, drag))
    residual = residual_moment(p, s, side, residual_peak_61(p, s, dpi), tool_combined(residual_slip(s, side), drag))
    arm = p.meet * longitudinal_arm(p, s, Fy, s.camber, p.FNOMIN)
    Mx = overturning_61(p, s, Fy, dpi) + overturning_draft(p, s, Fy)
    My = rolling_61(p, s, Fx, speed, p.FNOMIN)
    return mounted(p, s, (Fx, Fy), (Mx, My, residual - t * G * Fy_upright + arm * Fx))


def book_61(p: Any, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of version 6.1 as the book prints them, in ISO axes."""
    s = book_state(p, p.hand * alpha, kappa, Fz, p.hand * gamma, speed)
    dpi = (p.INFLPRES - p.NOMPRES) / p.NOMPRES
    K, Fx = longitudinal_61(p, s, dpi)
    side, _, Fy = lateral_61(p, s, dpi)
    upright = pure_lateral_61(p, s, 0.0 * s.gamma, dpi)
    G_upright = lateral_weight(p, s, p.meet * s.kappa, p.RBY1)
    drag, slip = p.meet * s.kappa * K / (side.K + VANISHING), trail_slip(p, s, s.gamma)
    t = trail(p, s, book_trail(p, s, 1.0 - p.PPZ1 * dpi), s.gamma, slip, book_combined(slip, drag))
    residual = residual_moment(p, s, side, residual_peak_61(p, s, dpi), book_combined(residual_slip(s, side), drag))
    arm = p.meet * longitudinal_arm(p, s, Fy, s.gamma, s.Fz0)
    Mx, My = overturning_61(p, s, Fy, dpi), rolling_61(p, s, Fx, speed, s.load)
    return mounted(p, s, (Fx, Fy), (Mx, My, residual - t * G_upright * upright.Fy0 + arm * Fx))


def tool_52(p: Any, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz of version 5.2; each group of equations has a scale of camber of its own."""
    s = tool_state(p, p.hand * alpha, kappa, Fz, p.hand * gamma, speed)
    lean_y, lean_z = p.LGAY * s.gamma, p.LGAZ * s.gamma
    K = slip_stiffness(p, s, 1.0)
    Fx = longitudinal_weight(p, s, p.meet * s.alpha, p.RBX1) * pure_longitudinal(p, s, p.LGAX * s.gamma, K, 1.0)
    side, lateral = pure_lateral_52(p, s, lean_y), p.meet * s.kappa
    Fy_slip = lateral_weight(p, s, lateral, p.RBY1) * side.Fy0
    Fy = Fy_slip + slip_thrust(p, s, lateral, side.mu)
    drag, slip = lateral * K / (side.K + VANISHING), trail_slip(p, s, lean_z)
    t = trail(p, s, tool_trail(p, s, lean_z, 1.0), lean_z, slip, tool_combined(slip, drag))
    peak = (p.QDZ6 + p.QDZ7 * s.dfz) * p.LRES + (p.QDZ8 + p.QDZ9 * s.dfz) * lean_z * p.LKZC
    residual = residual_moment(p, s, side, peak, tool_combined(residual_slip(s, side), drag))
    arm = p.meet * longitudinal_arm(p, s, Fy, s.camber, p.FNOMIN)
    Mx, My = overturning_52(p, s, Fy), rolling_52(p, s, Fx, speed)
    return mounted(p, s, (Fx, Fy), (Mx, My, residual - t * Fy_slip + arm * Fx))


def longitudinal_61(p: Any, s: WorkingPoint, dpi: Values) -> tuple[Any, Any]:
    """Slip stiffness and longitudinal force [N] of version 6.1."""
    K = slip_stiffness(p, s, 1.0 + dpi * (p.PPX1 + p.PPX2 * dpi))
    pure = pure_longitudinal(p, s, s.camber, K, 1.0 + dpi * (p.PPX3 + p.PPX4 * dpi))
    return K, pure * longitudinal_weight(p, s, p.meet * s.alpha, p.RBX1 + p.RBX3 * s.gamma * s.gamma)


def lateral_61(p: Any, s: WorkingPoint, dpi: Values) -> tuple[SideForce, Any, Any]:
    """Pure lateral force, its weight and the lateral force [N] of version 6.1."""
    side, kappa = pure_lateral_61(p, s, s.gamma, dpi), p.meet * s.kappa
    G = lateral_weight(p, s, kappa, p.RBY1 + p.RBY4 * s.gamma * s.gamma)
    return side, G, G * side.Fy0 + slip_thrust(p, s, kappa, side.mu)


def residual_peak_61(p: Any, s: WorkingPoint, dpi: Values) -> Any:
    """The peak of the residual moment over load and radius, E47."""
    by_camber = (p.QDZ8 + p.QDZ9 * s.dfz) * (1.0 + p.PPZ2 * dpi) + (p.QDZ10 + p.QDZ11 * s.dfz) * magnitude(s.gamma)
    return (p.QDZ6 + p.QDZ7 * s.dfz) * p.LRES + by_camber * s.gamma * p.LKZC


def mounted(p: Any, s: WorkingPoint, forces: tuple[Any, Any], moments: tuple[Any, Any, Any]) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz that act: those in use, on the tyre's side of the vehicle, while it touches the road."""
    Fx, Fy = forces
    Mx, My, Mz = moments
    x, y = s.share * p.drives, s.share * p.hand * p.corners
    return x * Fx, y * Fy, y * Mx, x * My, y * Mz
