"""One vehicle, two descriptions: a file's parameters by those of the hand-derived model, and random sets of both.

In a file, places are in the frame of the unit, x forward from the tractor's front axle or the semitrailer's kingpin.
"""

from dataclasses import replace

import numpy as np

from eom.closed_form import BTrainYawPlane, BTrainYawRoll, TractorSemitrailer

Values = dict[str, float]

AXLES_I_ZZ = 2000.0
"""Yaw inertia given to unsprung masses in files: that of the whole unit is what matters."""


def tractor_semitrailer_values(p: TractorSemitrailer) -> Values:
    """Parameters of ``tractor_semitrailer_yaw_plane.yaml``."""
    rear, axle = -(p.a11 + p.b12), -(p.l_c21 + p.b23)
    return {
        "tractor_frame.mass": p.m1,
        "tractor_frame.at.x": -p.a11,
        "tractor_frame.inertia.zz": p.I_zz1,
        "tractor_frame.inertia.yy": p.I_zz1,
        "axle_2.x": rear,
        "tractor_rear.support.at.x": rear,
        "fifth_wheel.at.tractor.x": -(p.a11 + p.l_c1),
        "semitrailer_frame.mass": p.m2,
        "semitrailer_frame.at.x": -p.l_c21,
        "semitrailer_frame.inertia.zz": p.I_zz2,
        "semitrailer_frame.inertia.yy": p.I_zz2,
        "axle_3.x": axle,
        "semitrailer_rear.support.at.x": axle,
        "front.cornering": p.C_f11,
        "rear.cornering": p.C_r12,
        "trailer.cornering": p.C_r23,
    }


def train_values(p: BTrainYawPlane) -> Values:
    """What both B-train files have in common: axles, couplings and tyres."""
    return {
        "axle_2.x": -(p.a11 + p.b12),
        "axle_3.x": -(p.a11 + p.b13),
        **{f"axle_{k}.x": -(p.l_c21 + b) for k, b in ((4, p.b24), (5, p.b25), (6, p.b26))},
        **{f"axle_{k}.x": -(p.l_c3 + b) for k, b in ((7, p.b37), (8, p.b38), (9, p.b39))},
        "fifth_wheel_1.at.tractor.x": -(p.a11 + p.l_c1),
        "fifth_wheel_2.at.semitrailer_1.x": -(p.l_c21 + p.l_c22),
        "steer.cornering": p.C1,
        "drive.cornering": p.C2,
        "trailer_1.cornering": p.C4,
        "trailer_2.cornering": p.C7,
    }


def yaw_plane_values(p: BTrainYawPlane) -> Values:
    """Parameters of ``b_train_yaw_plane.yaml``."""
    values = train_values(p)
    for unit, m, x, I_zz in (
        ("tractor", p.m1, p.a11, p.I_zz1),
        ("semitrailer_1", p.m2, p.l_c21, p.I_zz2),
        ("semitrailer_2", p.m3, p.l_c3, p.I_zz3),
    ):
        values |= {f"{unit}_frame.mass": m, f"{unit}_frame.at.x": -x}
        values |= {f"{unit}_frame.inertia.zz": I_zz, f"{unit}_frame.inertia.yy": I_zz}
    return values


def yaw_roll_values(p: BTrainYawRoll) -> Values:
    """Parameters of ``b_train_yaw_roll.yaml``, which has one height for all roll axes, and one for all couplings."""
    height = p.h_r1 + p.h_cr1
    values = train_values(p) | {"h_r": p.h_r1, "gravity": p.g}
    for hitch, ahead, behind, K in (
        (1, "tractor", "semitrailer_1", p.K_12),
        (2, "semitrailer_1", "semitrailer_2", p.K_23),
    ):
        values |= {f"fifth_wheel_{hitch}.at.{unit}.z": height for unit in (ahead, behind)}
        values[f"fifth_wheel_{hitch}.roll_stiffness"] = K
    for i, unit, x, x_sprung in (
        (1, "tractor", p.a11, p.a11s),
        (2, "semitrailer_1", p.l_c21, p.a2s),
        (3, "semitrailer_2", p.l_c3, p.a3s),
    ):
        values |= body_values(p, i, unit, x, x_sprung)
    values |= {
        "tractor_suspension.roll_stiffness": p.K_r1f + p.K_r1r,
        "tractor_suspension.roll_damping": p.L_r1f + p.L_r1r,
        "tractor_front.roll_stiffness": p.K_t1f,
        "tractor_tandem.roll_stiffness": p.K_t1r,
        "semitrailer_1.K_r": p.K_r2,
        "semitrailer_1.K_t": p.K_t2,
        "semitrailer_2.K_r": p.K_r3,
        "semitrailer_2.K_t": p.K_t3,
        "semitrailer_1_tridem_suspension.roll_damping": p.L_r2,
        "semitrailer_2_tridem_suspension.roll_damping": p.L_r3,
    }
    return values


def body_values(p: BTrainYawRoll, i: int, unit: str, x: float, x_sprung: float) -> Values:
    """Both bodies of unit *i*, whose whole-mass centre is *x* behind its origin.

    The unsprung mass lies where it makes that so, and the sprung one has what is left of the whole yaw inertia.
    """
    m_s, m_u = getattr(p, f"m_s{i}"), getattr(p, f"m_u{i}")
    ahead_s = x - x_sprung
    ahead_u = -m_s * ahead_s / m_u
    I_szz = getattr(p, f"I_zz{i}") - AXLES_I_ZZ - m_s * ahead_s**2 - m_u * ahead_u**2
    return {
        f"{unit}_frame.mass": m_s,
        f"{unit}_frame.at.x": -x_sprung,
        f"{unit}_frame.at.z": getattr(p, f"h_s{i}"),
        f"{unit}_frame.inertia.zz": I_szz,
        f"{unit}_frame.inertia.yy": I_szz,
        # a product of inertia with z changes its sign with the axes
        f"{unit}_frame.inertia.xx": getattr(p, f"I_sxx{i}"),
        f"{unit}_frame.inertia.xz": -getattr(p, f"I_sxz{i}"),
        f"{unit}_axles.mass": m_u,
        f"{unit}_axles.at.x": ahead_u - x,
        f"{unit}_axles.at.z": getattr(p, f"h_u{i}"),
        f"{unit}_axles.inertia.zz": AXLES_I_ZZ,
        f"{unit}_axles.inertia.yy": AXLES_I_ZZ,
        f"{unit}_axles.inertia.xx": getattr(p, f"I_u{i}xx"),
        f"{unit}_ride.at.x": -x,
    }


SETS = (0, 1, 2, 3)
"""Parameter sets: the nominal one, then random ones."""


def shaken(nominal: dict[str, float], number: int) -> dict[str, float]:
    """Values within 10 % of the nominal ones, always the same for a number; number 0 is the nominal set."""
    if number == 0:
        return nominal
    factors = np.random.default_rng(number).uniform(0.9, 1.1, len(nominal))
    return {name: value * float(factor) for (name, value), factor in zip(nominal.items(), factors, strict=True)}


def tractor_semitrailer(number: int) -> TractorSemitrailer:
    """A parameter set by its number."""
    return TractorSemitrailer(**shaken(vars(TractorSemitrailer()), number))


def yaw_plane(number: int) -> BTrainYawPlane:
    """A parameter set by its number; in the file, axles of a group have the same tyres."""
    p = BTrainYawPlane(**shaken(vars(BTrainYawPlane()), number))
    return replace(p, C3=p.C2, C5=p.C4, C6=p.C4, C8=p.C7, C9=p.C7)


def yaw_roll(number: int) -> BTrainYawRoll:
    """A parameter set by its number; heights of roll axes and couplings are alike, as in the file."""
    p = BTrainYawRoll(**shaken(vars(BTrainYawRoll()), number))
    p = replace(p, C3=p.C2, C5=p.C4, C6=p.C4, C8=p.C7, C9=p.C7)
    return replace(p, h_r2=p.h_r1, h_r3=p.h_r1, h_cr2=p.h_cr1, h_cr3=p.h_cr1)
