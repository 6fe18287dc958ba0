"""The Magic Formula as Zhu's thesis uses it, (3.10) and (3.41): no shifts, coefficients as polynomials of load."""

from dataclasses import dataclass
from typing import Any, Literal

from eom.errors import TyreError
from eom.tyre.contact import contact
from eom.tyre.curve import VANISHING, sine
from eom.tyre.elementary import arctan, cos, sqrt
from eom.tyre.interface import Formula
from eom.tyre.parameters import Values, coefficient
from eom.tyre.simple_tyre import SimpleTyre, resistance_moment, trail_of

AT_REST = 1e-300
"""Square of a slip so small that it changes no number; keeps a ratio of two zeros one."""


@dataclass(frozen=True, kw_only=True)
class MagicFormula(SimpleTyre):
    """The Magic Formula of the thesis. Raises `TyreError` for numbers that cannot be.

    Each coefficient is a polynomial of f = Fz/nominal_load - 1, with ``_load`` before f and ``_load2`` before f^2.
    Friction and stiffness are per load: D = mu Fz, B C D = k Fz. ``combined`` says how forces meet: "ellipse" moves
    along the resultant of both slips, each over its stiffness and peak; "cosine" multiplies each force by the
    cosine weighting of the other slip (Pacejka 2012, 4.E50 and 4.E58 without shifts).
    """

    C_x: Values = coefficient("shape factor of the longitudinal force", default=1.65, above=0.0)
    C_x_load: Values = coefficient("its change with load", default=0.0)
    mu_x: Values = coefficient("longitudinal friction", above=0.0)
    mu_x_load: Values = coefficient("its change with load", default=0.0)
    k_x: Values = coefficient("longitudinal slip stiffness per load", above=0.0)
    k_x_load: Values = coefficient("its change with load", default=0.0)
    k_x_load2: Values = coefficient("its change with load squared", default=0.0)
    E_x: Values = coefficient("curvature factor of the longitudinal force", default=0.0, at_most=1.0)
    E_x_load: Values = coefficient("its change with load", default=0.0)
    C_y: Values = coefficient("shape factor of the side force", default=1.3, above=0.0)
    C_y_load: Values = coefficient("its change with load", default=0.0)
    mu_y: Values = coefficient("lateral friction", above=0.0)
    mu_y_load: Values = coefficient("its change with load", default=0.0)
    k_y: Values = coefficient("cornering stiffness per load", "1/rad", above=0.0)
    k_y_load: Values = coefficient("its change with load", "1/rad", default=0.0)
    k_y_load2: Values = coefficient("its change with load squared", "1/rad", default=0.0)
    E_y: Values = coefficient("curvature factor of the side force", default=0.0, at_most=1.0)
    E_y_load: Values = coefficient("its change with load", default=0.0)
    k_gamma: Values = coefficient("camber stiffness per load", "1/rad", default=0.0)
    RBX1: Values = coefficient("cosine weighting of Fx: slope", "1/rad", default=10.0, at_least=0.0)
    RBX2: Values = coefficient("cosine weighting of Fx: change of slope with kappa", default=8.0)
    RCX1: Values = coefficient("cosine weighting of Fx: shape", default=1.0, at_least=0.0, at_most=1.0)
    RBY1: Values = coefficient("cosine weighting of Fy: slope", default=10.0, at_least=0.0)
    RBY2: Values = coefficient("cosine weighting of Fy: change of slope with alpha", "1/rad", default=8.0)
    RCY1: Values = coefficient("cosine weighting of Fy: shape", default=1.0, at_least=0.0, at_most=1.0)
    combined: Literal["ellipse", "cosine"] = "ellipse"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.combined not in FORMULAS:
            raise TyreError(f"MagicFormula: combined = {self.combined!r}: expected 'ellipse' or 'cosine'")

    @property
    def formula(self) -> Formula:
        """The equations."""
        return FORMULAS[self.combined]


def ellipse_forces(
    p: MagicFormula, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values
) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz with a friction ellipse.

    Both slips are made comparable, u = K_x kappa/D_x and v = (K_y alpha + K_gamma gamma)/D_y, so that every curve
    starts with slope one; the resultant of u and v enters the curves, and the forces keep its direction. With one
    of them zero the other force is the pure one, and (Fx/D_x)^2 + (Fy/D_y)^2 never exceeds one.
    """
    load, share = contact(Fz, p.nominal_load)
    f = load / p.nominal_load - 1.0
    mu_x, mu_y, C_x, C_y = friction_and_shape(p, f)
    u = (p.k_x + f * (p.k_x_load + f * p.k_x_load2)) * kappa / (mu_x + VANISHING)
    v = ((p.k_y + f * (p.k_y_load + f * p.k_y_load2)) * alpha + p.k_gamma * gamma) / (mu_y + VANISHING)
    rho = sqrt(u * u + v * v + AT_REST)
    Fx = share * load * mu_x * (u / rho) * sine(rho / C_x, C_x, p.E_x + p.E_x_load * f)
    Fy = -share * load * mu_y * (v / rho) * sine(rho / C_y, C_y, p.E_y + p.E_y_load * f)
    My = resistance_moment(p, share * load, kappa, speed)
    return Fx, Fy, 0.0 * Fy, My, aligning_moment(p, rho, Fy, speed)


def cosine_forces(
    p: MagicFormula, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values
) -> tuple[Any, ...]:
    """Fx, Fy, Mx, My, Mz with cosine weighting."""
    load, share = contact(Fz, p.nominal_load)
    f = load / p.nominal_load - 1.0
    mu_x, mu_y, C_x, C_y = friction_and_shape(p, f)
    u = (p.k_x + f * (p.k_x_load + f * p.k_x_load2)) * kappa / (mu_x + VANISHING)
    v = ((p.k_y + f * (p.k_y_load + f * p.k_y_load2)) * alpha + p.k_gamma * gamma) / (mu_y + VANISHING)
    # cos(arctan z) = 1/sqrt(1 + z^2)
    B_x = p.RBX1 / sqrt(1.0 + (p.RBX2 * kappa) * (p.RBX2 * kappa))
    B_y = p.RBY1 / sqrt(1.0 + (p.RBY2 * alpha) * (p.RBY2 * alpha))
    G_x = cos(p.RCX1 * arctan(B_x * alpha))
    G_y = cos(p.RCY1 * arctan(B_y * kappa))
    Fx = share * load * mu_x * G_x * sine(u / C_x, C_x, p.E_x + p.E_x_load * f)
    Fy = -share * load * mu_y * G_y * sine(v / C_y, C_y, p.E_y + p.E_y_load * f)
    My = resistance_moment(p, share * load, kappa, speed)
    return Fx, Fy, 0.0 * Fy, My, aligning_moment(p, v, Fy, speed)


def friction_and_shape(p: MagicFormula, f: Values) -> tuple[Any, Any, Any, Any]:
    """mu_x, mu_y, C_x, C_y at the relative change f of load."""
    return p.mu_x + p.mu_x_load * f, p.mu_y + p.mu_y_load * f, p.C_x + p.C_x_load * f, p.C_y + p.C_y_load * f


def aligning_moment(p: MagicFormula, slip: Values, Fy: Values, speed: Values) -> Any:
    """Mz [N m] by a trail that falls as cos^2(arctan slip), that of camber thrust included."""
    return -trail_of(p, speed) * Fy / (1.0 + slip * slip)


FORMULAS = {"ellipse": ellipse_forces, "cosine": cosine_forces}
