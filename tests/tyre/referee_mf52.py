"""Magic Formula 5.2 (PAC2002) in plain scalar Python, written from the published equations.

Conventions as in `referee_mf`. Sources: MF-Tyre 5.2 (TNO, 2001) and PAC2002 (MSC) manuals, read through the public
codes that follow them (MFeval, Chrono's ChPac02Tire, OpenTIRE's PAC2002, J. Harty's MF52): where two of them differ
the choice is below. No pressure, no turn slip.

* Camber is scaled per group, LGAX, LGAY, LGAZ (the 5.2 manual); LKYC scales camber in the shifts of Fy and LKZC camber
  in the residual torque (MF-Tyre 6 reading FITTYP 6). A file has one kind or the other, the rest being 1.
* The camber of RVY3, SSZ3, SSZ4 and QSX2 is not scaled.
* Dt stands over FNOMIN, not LFZO FNOMIN (PAC2002, Harty, OpenTIRE; MFeval by a factor LFZO on the trail).
* The force behind the trail is Fy - SVyk with camber, so Gyk Fy0 (manual; MFeval takes SVyk with the friction of the
  upright wheel).
* LMX scales all of Mx (MFeval, Chrono); My is proportional to Fz.
* The exponent of the longitudinal relaxation length is -PTX3 dfz (MFeval from the TNO manual; Chrono has +PTX3 dfz).
"""

from math import atan, cos, exp, pi, sin
from typing import NamedTuple

from tests.tyre.referee_mf import Wrench, equivalent_of_the_paper
from tests.tyre.referee_mf_forces import Coefficients, bent, sign


class State(NamedTuple):
    alpha: float
    kappa: float
    Fz: float
    gamma: float
    speed: float
    dfz: float


class Side(NamedTuple):
    Fy0: float
    mu: float
    BC: float
    K: float
    SH: float
    SV: float


def increment(c: Coefficients, Fz: float) -> float:
    Fz0 = c["LFZO"] * c["FNOMIN"]
    return (Fz - Fz0) / Fz0


def slip_stiffness(c: Coefficients, Fz: float) -> float:
    dfz = increment(c, Fz)
    return Fz * (c["PKX1"] + c["PKX2"] * dfz) * exp(c["PKX3"] * dfz) * c["LKX"]


def cornering_stiffness(c: Coefficients, Fz: float, gamma: float) -> float:
    Fz0 = c["LFZO"] * c["FNOMIN"]
    upright = c["PKY1"] * Fz0 * sin(2 * atan(Fz / (c["PKY2"] * Fz0))) * c["LKY"]
    return upright * (1 - c["PKY3"] * abs(gamma * c["LGAY"]))


def camber_thrust(c: Coefficients, Fz: float) -> float:
    """The part of the camber stiffness in the vertical shift, SVy per camber [N/rad]."""
    return Fz * (c["PVY3"] + c["PVY4"] * increment(c, Fz)) * c["LGAY"] * c["LKYC"] * c["LMUY"]


def longitudinal(c: Coefficients, s: State) -> float:
    """Fx: pure force times weight."""
    C = c["PCX1"] * c["LCX"]
    mu = (c["PDX1"] + c["PDX2"] * s.dfz) * (1 - c["PDX3"] * (s.gamma * c["LGAX"]) ** 2) * c["LMUX"]
    D = mu * s.Fz
    kx = s.kappa + (c["PHX1"] + c["PHX2"] * s.dfz) * c["LHX"]
    E = (c["PEX1"] + c["PEX2"] * s.dfz + c["PEX3"] * s.dfz**2) * (1 - c["PEX4"] * sign(kx)) * c["LEX"]
    SV = s.Fz * (c["PVX1"] + c["PVX2"] * s.dfz) * c["LVX"] * c["LMUX"]
    pure = D * sin(bent(slip_stiffness(c, s.Fz) / (C * D), C, E, kx)) + SV
    B = c["RBX1"] * cos(atan(c["RBX2"] * s.kappa)) * c["LXAL"]
    C, E, SH = c["RCX1"], c["REX1"] + c["REX2"] * s.dfz, c["RHX1"]
    return pure * cos(bent(B, C, E, s.alpha + SH)) / cos(bent(B, C, E, SH))


def pure_lateral(c: Coefficients, s: State) -> Side:
    lean = s.gamma * c["LGAY"]
    K = cornering_stiffness(c, s.Fz, s.gamma)
    C = c["PCY1"] * c["LCY"]
    mu = (c["PDY1"] + c["PDY2"] * s.dfz) * (1 - c["PDY3"] * lean**2) * c["LMUY"]
    D = mu * s.Fz
    SH = (c["PHY1"] + c["PHY2"] * s.dfz) * c["LHY"] + c["PHY3"] * lean * c["LKYC"]
    SV = s.Fz * (c["PVY1"] + c["PVY2"] * s.dfz) * c["LVY"] * c["LMUY"] + camber_thrust(c, s.Fz) * s.gamma
    ay = s.alpha + SH
    E = (c["PEY1"] + c["PEY2"] * s.dfz) * (1 - (c["PEY3"] + c["PEY4"] * lean) * sign(ay)) * c["LEY"]
    B = K / (C * D)
    return Side(D * sin(bent(B, C, E, ay)) + SV, mu, B * C, K, SH, SV)


def lateral_weight(c: Coefficients, s: State) -> float:
    B = c["RBY1"] * cos(atan(c["RBY2"] * (s.alpha - c["RBY3"]))) * c["LYKA"]
    C, E, SH = c["RCY1"], c["REY1"] + c["REY2"] * s.dfz, c["RHY1"] + c["RHY2"] * s.dfz
    return cos(bent(B, C, E, s.kappa + SH)) / cos(bent(B, C, E, SH))


def side_force_of_kappa(c: Coefficients, s: State, mu: float) -> float:
    D = mu * s.Fz * (c["RVY1"] + c["RVY2"] * s.dfz + c["RVY3"] * s.gamma) * cos(atan(c["RVY4"] * s.alpha))
    return D * sin(c["RVY5"] * atan(c["RVY6"] * s.kappa)) * c["LVYKA"]


def trail(c: Coefficients, s: State, ratio: float) -> float:
    lean = s.gamma * c["LGAZ"]
    at = s.alpha + c["QHZ1"] + c["QHZ2"] * s.dfz + (c["QHZ3"] + c["QHZ4"] * s.dfz) * lean
    B = (c["QBZ1"] + c["QBZ2"] * s.dfz + c["QBZ3"] * s.dfz**2) * (1 + c["QBZ4"] * lean + c["QBZ5"] * abs(lean))
    B *= c["LKY"] / c["LMUY"]
    C = c["QCZ1"]
    D = s.Fz * (c["QDZ1"] + c["QDZ2"] * s.dfz) * (1 + c["QDZ3"] * lean + c["QDZ4"] * lean**2)
    D *= c["UNLOADED_RADIUS"] / c["FNOMIN"] * c["LTR"]
    E = c["QEZ1"] + c["QEZ2"] * s.dfz + c["QEZ3"] * s.dfz**2
    E *= 1 + (c["QEZ4"] + c["QEZ5"] * lean) * (2 / pi) * atan(B * C * at)
    return D * cos(bent(B, C, E, equivalent_of_the_paper(at, ratio))) * cos(s.alpha)


def residual_torque(c: Coefficients, s: State, side: Side, ratio: float) -> float:
    ar = s.alpha + side.SH + side.SV / side.K
    B = c["QBZ9"] * c["LKY"] / c["LMUY"] + c["QBZ10"] * side.BC
    camber = (c["QDZ8"] + c["QDZ9"] * s.dfz) * s.gamma * c["LGAZ"] * c["LKZC"]
    share = (c["QDZ6"] + c["QDZ7"] * s.dfz) * c["LRES"] + camber
    D = s.Fz * share * c["UNLOADED_RADIUS"] * c["LMUY"]
    return D * cos(atan(B * equivalent_of_the_paper(ar, ratio))) * cos(s.alpha)


def tool_52(c: Coefficients, alpha: float, kappa: float, Fz: float, gamma: float, speed: float) -> Wrench:
    """What MF-Tyre computes of a file with FITTYP 6, and Adams of one named PAC2002."""
    s = State(alpha, kappa, Fz, gamma, speed, increment(c, Fz))
    side = pure_lateral(c, s)
    weighted = lateral_weight(c, s) * side.Fy0
    Fx, Fy = longitudinal(c, s), weighted + side_force_of_kappa(c, s, side.mu)
    R0, force, fast = c["UNLOADED_RADIUS"], Fy / c["FNOMIN"], speed / c["LONGVL"]
    Mx = R0 * Fz * (c["QSX1"] * c["LVMX"] - c["QSX2"] * gamma + c["QSX3"] * force) * c["LMX"]
    share = c["QSY1"] + c["QSY2"] * Fx / c["FNOMIN"] + c["QSY3"] * abs(fast) + c["QSY4"] * fast**4
    ratio = slip_stiffness(c, Fz) / side.K * kappa
    arm = R0 * (c["SSZ1"] + c["SSZ2"] * force + (c["SSZ3"] + c["SSZ4"] * s.dfz) * gamma) * c["LS"]
    Mz = -trail(c, s, ratio) * weighted + residual_torque(c, s, side, ratio) + arm * Fx
    return Fx, Fy, Mx, -R0 * Fz * share * c["LMY"], Mz


def stiffnesses_52(c: Coefficients, Fz: float) -> tuple[float, float, float]:
    """Kxk [N], Kya [N/rad] and Kyg0 [N/rad] of the upright wheel."""
    K = cornering_stiffness(c, Fz, 0.0)
    return slip_stiffness(c, Fz), K, c["PHY3"] * c["LGAY"] * c["LKYC"] * K + camber_thrust(c, Fz)


def relaxation_52(c: Coefficients, Fz: float, gamma: float) -> tuple[float, float]:
    """Longitudinal and lateral relaxation length [m]."""
    dfz, Fz0, R0 = increment(c, Fz), c["FNOMIN"], c["UNLOADED_RADIUS"]
    along = Fz * (c["PTX1"] + c["PTX2"] * dfz) * exp(-c["PTX3"] * dfz) * R0 / Fz0 * c["LSGKP"]
    load = sin(2 * atan(Fz / (c["PTY2"] * Fz0 * c["LFZO"])))
    across = c["PTY1"] * load * (1 - c["PKY3"] * abs(gamma * c["LGAY"])) * R0 * c["LFZO"] * c["LSGAL"]
    return along, across
