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

from collections.abc import Callable
from math import atan, cos, exp, hypot, log, pi, sin, sqrt, tan
from typing import NamedTuple

from tests.tyre.referee_mf_forces import (
    Coefficients,
    Point,
    Side,
    bent,
    book_point,
    forces_in_plane,
    lateral_weight,
    pure_lateral,
    sign,
    slip_stiffness,
    tool_point,
)

Wrench = tuple[float, float, float, float, float]
"""Fx, Fy [N], Mx, My, Mz [Nm]."""


class Aligning(NamedTuple):
    """What the two forms of the aligning moment differ in."""

    Bt: float
    Dt: float
    Fy_behind: float
    arm: float
    equivalent: Callable[[float, float], float]


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
    powers = exp(c["QSY7"] * log(load) + c["QSY8"] * log(c["INFLPRES"] / c["NOMPRES"]))
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
