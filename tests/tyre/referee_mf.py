"""Magic Formula 6.1 in plain scalar Python, written from the published equations, to check the vectorised one against.

Coefficients come as a mapping of .tir names to SI numbers; ISO axes (tan(alpha) = v_y/|v_x|, kappa > 0 drives,
Fz >= 0). Normal forward running only: speed above VXLOW, load above 1 % of FNOMIN, no turn slip, nothing clamped,
no epsilons. Sources: 4.E = Pacejka, Tire and Vehicle Dynamics, 3rd ed. (2012), section 4.3.2; A = appendix of
Besselink, Schmeitz and Pacejka, An improved Magic Formula/Swift tyre model (2010); draft = the manuscript of that
paper (TU Eindhoven), whose Mx has QSX12 to QSX14; solver = what M. Furlan found MF-Tyre to compute (MFeval).

=======================  ==============================================  ========================================
choice                   `tool_61`                                       `book_61`
=======================  ==============================================  ========================================
slip angle               alpha* = alpha (solver)                         alpha* = tan(alpha) (4.E3)
camber                   gamma* = gamma (solver)                         gamma* = sin(gamma) (4.E4), but PDX3,
                                                                         Mx and My take gamma
friction scale           LMUX, LMUY (LMUV = 0; solver)                   divided by 1 + LMUV Vs/LONGVL (4.E7)
scale of vertical shift  LMUX, LMUY (A_mu = 1; solver)                   digressive, A_mu = 10 (4.E8)
trail slope Bt           1 + QBZ4 gamma + QBZ5 |gamma| (A58)             1 + QBZ5 |gamma*| + QBZ6 gamma*^2 (4.E40)
trail peak Dt            1 + QDZ3 gamma + QDZ4 gamma^2 (A60)             1 + QDZ3 |gamma*| + QDZ4 gamma*^2 (4.E43)
nominal load in Dt       FNOMIN (solver: A60 times LFZO)                 LFZO FNOMIN (4.E42)
equivalent slips         atan sqrt(tan^2 + ...) (A54, A55)               sqrt(alpha^2 + ...) (4.E77, 4.E78)
force behind the trail   Gyk at gamma times Fy0 at gamma = 0 (solver)    Gyk and Fy0 at gamma = 0 (4.E74)
arm of Fx                Fy/FNOMIN, gamma (A56)                          Fy/(LFZO FNOMIN), gamma* (4.E76)
residual torque          one cos(alpha), in Dr (solver)                  one cos'(alpha), in Dr (4.E47, 4.E75)
Mx                       with QSX12 to QSX14 (draft 49)                  without (4.E69)
My                       times FNOMIN (A48)                              times Fz (4.E70)
=======================  ==============================================  ========================================

cos'(alpha) = Vcx/Vc (4.E6) is cos(alpha) when rolling forward. The book works in adapted SAE axes, where Fy, My and
Mz point the other way: its positive My resists rolling just as the negative one here does.
"""

from collections.abc import Callable, Mapping
from math import atan, copysign, cos, exp, hypot, pi, pow, sin, sqrt, tan
from typing import NamedTuple

Coefficients = Mapping[str, float]
Wrench = tuple[float, float, float, float, float]
"""Fx, Fy [N], Mx, My, Mz [Nm]."""


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


class Aligning(NamedTuple):
    """What the two forms of the aligning moment differ in."""

    Bt: float
    Dt: float
    Fy_behind: float
    arm: float
    equivalent: Callable[[float, float], float]


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


def overturning(c: Coefficients, p: Point, Fy: float) -> float:
    """Mx (4.E69)."""
    load, force = p.Fz / c["FNOMIN"], Fy / c["FNOMIN"]
    share = c["QSX1"] * c["LVMX"] - c["QSX2"] * p.gamma * (1 + c["PPMX1"] * p.dpi) + c["QSX3"] * force
    wave = sin(c["QSX7"] * p.gamma + c["QSX8"] * atan(c["QSX9"] * force))
    share += c["QSX4"] * cos(c["QSX5"] * atan((c["QSX6"] * load) ** 2)) * wave
    share += c["QSX10"] * atan(c["QSX11"] * load) * p.gamma
    return c["UNLOADED_RADIUS"] * p.Fz * share * c["LMX"]


def overturning_of_the_draft(c: Coefficients, p: Point, Fy: float) -> float:
    """Mx (draft 49): that of the book, and three terms more."""
    more = Fy * (c["QSX13"] + c["QSX14"] * abs(p.gamma)) - p.Fz * c["QSX12"] * p.gamma * abs(p.gamma)
    return overturning(c, p, Fy) + c["UNLOADED_RADIUS"] * more * c["LMX"]


def rolling_resistance(c: Coefficients, p: Point, Fx: float, front: float) -> float:
    """My (A48 with *front* = FNOMIN, 4.E70 with Fz), resisting a wheel that rolls forward."""
    speed, load = p.speed / c["LONGVL"], p.Fz / c["FNOMIN"]
    share = c["QSY1"] + c["QSY2"] * Fx / c["FNOMIN"] + c["QSY3"] * abs(speed) + c["QSY4"] * speed**4
    share += (c["QSY5"] + c["QSY6"] * load) * p.gamma**2
    powers = pow(load, c["QSY7"]) * pow(c["INFLPRES"] / c["NOMPRES"], c["QSY8"])
    return -front * c["UNLOADED_RADIUS"] * share * powers * c["LMY"]


def trail(c: Coefficients, p: Point, own: Aligning, ratio: float) -> float:
    """The trail t (4.E33 to 4.E35, 4.E41, 4.E44, 4.E73)."""
    at = p.a + c["QHZ1"] + c["QHZ2"] * p.dfz + (c["QHZ3"] + c["QHZ4"] * p.dfz) * p.g
    C = c["QCZ1"]
    E = c["QEZ1"] + c["QEZ2"] * p.dfz + c["QEZ3"] * p.dfz**2
    E *= 1 + (c["QEZ4"] + c["QEZ5"] * p.g) * (2 / pi) * atan(own.Bt * C * at)
    return own.Dt * cos(bent(own.Bt, C, E, own.equivalent(at, ratio))) * cos(p.alpha)


def residual_torque(c: Coefficients, p: Point, side: Side, own: Aligning, ratio: float) -> float:
    """Mzr (4.E37, 4.E38, 4.E45 to 4.E47, 4.E75)."""
    ar = p.a + side.SH + side.SV / side.K
    B = c["QBZ9"] * c["LKY"] / p.ly + c["QBZ10"] * side.BC
    camber = (c["QDZ8"] + c["QDZ9"] * p.dfz) * (1 + c["PPZ2"] * p.dpi)
    camber += (c["QDZ10"] + c["QDZ11"] * p.dfz) * abs(p.g)
    share = (c["QDZ6"] + c["QDZ7"] * p.dfz) * c["LRES"] + camber * p.g * c["LKZC"]
    D = p.Fz * c["UNLOADED_RADIUS"] * share * p.ly * cos(p.alpha)
    return D * cos(atan(B * own.equivalent(ar, ratio)))


def aligning(c: Coefficients, p: Point, side: Side, own: Aligning, Fx: float) -> float:
    """Mz (4.E71, 4.E72)."""
    ratio = slip_stiffness(c, p) / side.K * p.kappa
    return -trail(c, p, own, ratio) * own.Fy_behind + residual_torque(c, p, side, own, ratio) + own.arm * Fx


def trail_factors(c: Coefficients, p: Point) -> tuple[float, float]:
    """Bt and Dt but for their camber and the nominal load under Dt (4.E40, 4.E42)."""
    Bt = (c["QBZ1"] + c["QBZ2"] * p.dfz + c["QBZ3"] * p.dfz**2) * c["LKY"] / p.ly
    Dt = p.Fz * c["UNLOADED_RADIUS"] * (c["QDZ1"] + c["QDZ2"] * p.dfz) * (1 - c["PPZ1"] * p.dpi) * c["LTR"]
    return Bt, Dt


def arm(c: Coefficients, p: Point, relative_force: float) -> float:
    """The arm s (A56, 4.E76)."""
    camber = (c["SSZ3"] + c["SSZ4"] * p.dfz) * p.g
    return c["UNLOADED_RADIUS"] * (c["SSZ1"] + c["SSZ2"] * relative_force + camber) * c["LS"]


def equivalent_of_the_paper(slip: float, ratio: float) -> float:
    return atan(sqrt(tan(slip) ** 2 + ratio**2)) * sign(slip)  # A54, A55


def equivalent_of_the_book(slip: float, ratio: float) -> float:
    return hypot(slip, ratio) * sign(slip)  # 4.E77, 4.E78


def tool_61(c: Coefficients, alpha: float, kappa: float, Fz: float, gamma: float, speed: float) -> Wrench:
    """What MF-Tyre computes."""
    p = tool_point(c, alpha, kappa, Fz, gamma, speed)
    side = pure_lateral(c, p)
    Fx, Fy = forces_in_plane(c, p, side)
    Bt, Dt = trail_factors(c, p)
    own = Aligning(
        Bt=Bt * (1 + c["QBZ4"] * gamma + c["QBZ5"] * abs(gamma)),
        Dt=Dt / c["FNOMIN"] * (1 + c["QDZ3"] * gamma + c["QDZ4"] * gamma**2),
        Fy_behind=lateral_weight(c, p) * pure_lateral(c, p.upright()).Fy0,
        arm=arm(c, p, Fy / c["FNOMIN"]),
        equivalent=equivalent_of_the_paper,
    )
    My = rolling_resistance(c, p, Fx, c["FNOMIN"])
    return Fx, Fy, overturning_of_the_draft(c, p, Fy), My, aligning(c, p, side, own, Fx)


def book_61(c: Coefficients, alpha: float, kappa: float, Fz: float, gamma: float, speed: float) -> Wrench:
    """What Pacejka (2012) prints."""
    p = book_point(c, alpha, kappa, Fz, gamma, speed)
    side = pure_lateral(c, p)
    Fx, Fy = forces_in_plane(c, p, side)
    Bt, Dt = trail_factors(c, p)
    Fz0 = c["LFZO"] * c["FNOMIN"]
    own = Aligning(
        Bt=Bt * (1 + c["QBZ5"] * abs(p.g) + c["QBZ6"] * p.g**2),
        Dt=Dt / Fz0 * (1 + c["QDZ3"] * abs(p.g) + c["QDZ4"] * p.g**2),
        Fy_behind=lateral_weight(c, p.upright()) * pure_lateral(c, p.upright()).Fy0,
        arm=arm(c, p, Fy / Fz0),
        equivalent=equivalent_of_the_book,
    )
    return Fx, Fy, overturning(c, p, Fy), rolling_resistance(c, p, Fx, Fz), aligning(c, p, side, own, Fx)


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
