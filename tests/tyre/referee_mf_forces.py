"""Forces in the plane of the contact by Magic Formula 6.1: the part of the referee that tool and book share.

Conventions and sources as in `referee_mf`; what tool and book differ in here are the members of `Point`.
"""

from collections.abc import Callable, Mapping
from math import atan, copysign, cos, exp, hypot, sin, tan
from typing import NamedTuple

Coefficients = Mapping[str, float]


class Point(NamedTuple):
    """A state of the wheel and what the equations make of it first."""

    alpha: float
    kappa: float
    Fz: float
    gamma: float
    speed: float
    dfz: float  # 4.E2a
    dpi: float  # 4.E2b
    a: float  # alpha*
    g: float  # gamma*
    lx: float  # lambda*_mu x
    ly: float  # lambda*_mu y
    sx: float  # lambda'_mu x
    sy: float  # lambda'_mu y

    def upright(self) -> "Point":
        """The same state without camber."""
        return self._replace(gamma=0.0, g=0.0)


Pointer = Callable[[Coefficients, float, float, float, float, float], Point]


class Side(NamedTuple):
    """The pure lateral force and the factors that other equations take from it."""

    Fy0: float
    mu: float
    BC: float
    K: float
    SH: float
    SV: float


def sign(x: float) -> float:
    return copysign(1.0, x) if x else 0.0


def bent(B: float, C: float, E: float, x: float) -> float:
    """The argument that sine and cosine form share."""
    return C * atan(B * x - E * (B * x - atan(B * x)))


def increments(c: Coefficients, Fz: float) -> tuple[float, float]:
    Fz0 = c["LFZO"] * c["FNOMIN"]  # 4.E1
    return (Fz - Fz0) / Fz0, (c["INFLPRES"] - c["NOMPRES"]) / c["NOMPRES"]


def tool_point(c: Coefficients, alpha: float, kappa: float, Fz: float, gamma: float, speed: float) -> Point:
    dfz, dpi = increments(c, Fz)
    lx, ly = c["LMUX"], c["LMUY"]
    return Point(alpha, kappa, Fz, gamma, speed, dfz, dpi, alpha, gamma, lx, ly, lx, ly)


def book_point(c: Coefficients, alpha: float, kappa: float, Fz: float, gamma: float, speed: float) -> Point:
    dfz, dpi = increments(c, Fz)
    slip_speed = hypot(kappa * speed, tan(alpha) * speed)  # 3.39 with 4.E5, 2.12
    decay = 1 + c["LMUV"] * slip_speed / c["LONGVL"]
    lx, ly = c["LMUX"] / decay, c["LMUY"] / decay  # 4.E7
    sx, sy = (10 * scale / (1 + 9 * scale) for scale in (lx, ly))  # 4.E8, A_mu = 10
    return Point(alpha, kappa, Fz, gamma, speed, dfz, dpi, tan(alpha), sin(gamma), lx, ly, sx, sy)


def slip_stiffness(c: Coefficients, p: Point) -> float:
    """Kxk (4.E15) [N]."""
    load = (c["PKX1"] + c["PKX2"] * p.dfz) * exp(c["PKX3"] * p.dfz)
    return p.Fz * load * (1 + c["PPX1"] * p.dpi + c["PPX2"] * p.dpi**2) * c["LKX"]


def cornering_stiffness(c: Coefficients, p: Point) -> float:
    """Kya (4.E25) [N/rad], negative in ISO axes."""
    Fz0 = c["LFZO"] * c["FNOMIN"]
    load = (p.Fz / Fz0) / ((c["PKY2"] + c["PKY5"] * p.g**2) * (1 + c["PPY2"] * p.dpi))
    pressure = 1 + c["PPY1"] * p.dpi
    return c["PKY1"] * Fz0 * pressure * (1 - c["PKY3"] * abs(p.g)) * sin(c["PKY4"] * atan(load)) * c["LKY"]


def camber_stiffness(c: Coefficients, p: Point) -> float:
    """Kyg0 (4.E30) [N/rad]."""
    return p.Fz * (c["PKY6"] + c["PKY7"] * p.dfz) * (1 + c["PPY5"] * p.dpi) * c["LKYC"]


def pure_longitudinal(c: Coefficients, p: Point) -> float:
    """Fx0 (4.E9 to 4.E18)."""
    kx = p.kappa + (c["PHX1"] + c["PHX2"] * p.dfz) * c["LHX"]
    C = c["PCX1"] * c["LCX"]
    mu = (c["PDX1"] + c["PDX2"] * p.dfz) * (1 + c["PPX3"] * p.dpi + c["PPX4"] * p.dpi**2)
    D = mu * (1 - c["PDX3"] * p.gamma**2) * p.lx * p.Fz
    E = (c["PEX1"] + c["PEX2"] * p.dfz + c["PEX3"] * p.dfz**2) * (1 - c["PEX4"] * sign(kx)) * c["LEX"]
    SV = p.Fz * (c["PVX1"] + c["PVX2"] * p.dfz) * c["LVX"] * p.sx
    return D * sin(bent(slip_stiffness(c, p) / (C * D), C, E, kx)) + SV


def pure_lateral(c: Coefficients, p: Point) -> Side:
    """Fy0 (4.E19 to 4.E30)."""
    K = cornering_stiffness(c, p)
    camber_thrust = p.Fz * (c["PVY3"] + c["PVY4"] * p.dfz) * p.g * c["LKYC"] * p.sy  # 4.E28
    SH = (c["PHY1"] + c["PHY2"] * p.dfz) * c["LHY"] + (camber_stiffness(c, p) * p.g - camber_thrust) / K  # 4.E27
    SV = p.Fz * (c["PVY1"] + c["PVY2"] * p.dfz) * c["LVY"] * p.sy + camber_thrust  # 4.E29
    ay = p.a + SH
    C = c["PCY1"] * c["LCY"]
    mu = (c["PDY1"] + c["PDY2"] * p.dfz) * (1 + c["PPY3"] * p.dpi + c["PPY4"] * p.dpi**2)
    mu *= (1 - c["PDY3"] * p.g**2) * p.ly  # 4.E23
    D = mu * p.Fz
    lean = 1 + c["PEY5"] * p.g**2 - (c["PEY3"] + c["PEY4"] * p.g) * sign(ay)
    E = (c["PEY1"] + c["PEY2"] * p.dfz) * lean * c["LEY"]  # 4.E24
    B = K / (C * D)
    return Side(D * sin(bent(B, C, E, ay)) + SV, mu, B * C, K, SH, SV)


def longitudinal_weight(c: Coefficients, p: Point) -> float:
    """Gxa (4.E51 to 4.E57)."""
    B = (c["RBX1"] + c["RBX3"] * p.g**2) * cos(atan(c["RBX2"] * p.kappa)) * c["LXAL"]
    C, E, SH = c["RCX1"], c["REX1"] + c["REX2"] * p.dfz, c["RHX1"]
    return cos(bent(B, C, E, p.a + SH)) / cos(bent(B, C, E, SH))


def lateral_weight(c: Coefficients, p: Point) -> float:
    """Gyk (4.E59 to 4.E65)."""
    B = (c["RBY1"] + c["RBY4"] * p.g**2) * cos(atan(c["RBY2"] * (p.a - c["RBY3"]))) * c["LYKA"]
    C, E, SH = c["RCY1"], c["REY1"] + c["REY2"] * p.dfz, c["RHY1"] + c["RHY2"] * p.dfz
    return cos(bent(B, C, E, p.kappa + SH)) / cos(bent(B, C, E, SH))


def side_force_of_kappa(c: Coefficients, p: Point, mu: float) -> float:
    """SVyk (4.E66, 4.E67)."""
    D = mu * p.Fz * (c["RVY1"] + c["RVY2"] * p.dfz + c["RVY3"] * p.g) * cos(atan(c["RVY4"] * p.a))
    return D * sin(c["RVY5"] * atan(c["RVY6"] * p.kappa)) * c["LVYKA"]


def forces_in_plane(c: Coefficients, p: Point, side: Side) -> tuple[float, float]:
    """Fx (4.E50) and Fy (4.E58)."""
    Fx = longitudinal_weight(c, p) * pure_longitudinal(c, p)
    return Fx, lateral_weight(c, p) * side.Fy0 + side_force_of_kappa(c, p, side.mu)


def stiffnesses_61(c: Coefficients, Fz: float) -> tuple[float, float, float]:
    """Kxk [N], Kya [N/rad] and Kyg0 [N/rad] of the upright wheel, the same in both forms."""
    p = tool_point(c, 0.0, 0.0, Fz, 0.0, c["LONGVL"])
    return slip_stiffness(c, p), cornering_stiffness(c, p), camber_stiffness(c, p)


def relaxation_61(c: Coefficients, Fz: float, gamma: float, point: Pointer = tool_point) -> tuple[float, float]:
    """Longitudinal and lateral relaxation length [m] (paper, equations 17 to 19), camber as *point* takes it."""
    p = point(c, 0.0, 0.0, Fz, gamma, c["LONGVL"])
    x, y = (
        c[name] * (1 + c[f"{k}1"] * p.dfz + c[f"{k}2"] * p.dfz**2) * (1 + c[f"{k}3"] * p.dpi)
        for name, k in (("LONGITUDINAL_STIFFNESS", "PCFX"), ("LATERAL_STIFFNESS", "PCFY"))
    )
    return abs(slip_stiffness(c, p) / x), abs(cornering_stiffness(c, p) / y)
