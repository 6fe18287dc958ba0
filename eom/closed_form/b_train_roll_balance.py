"""The four balances of each unit of the B-train with roll, before the coupling forces are eliminated: (3.21) to (3.23).

A balance is a row of numbers. Row times (dx/dt, x, delta_11, u) is what the coupling forces alone must equal.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from eom.closed_form.arrays import Array
from eom.closed_form.b_train_roll_parameters import BTrainYawRoll
from eom.closed_form.tyre_derivatives import TyreDerivatives, tyre_derivatives

STATES = (
    *(f"{name}_{unit}" for unit in (1, 2, 3) for name in ("phi", "phi_dot", "beta", "psi_dot")),
    *(f"{name}_{unit}" for unit in (1, 2, 3) for name in ("phi_t", "phi_t_dot")),
)
INPUTS = ("delta_11", "M_z_2", "M_z_3", "M_x_1f", "M_x_1r", "M_x_2", "M_x_3")
COLUMNS = (*(f"d {name}" for name in STATES), *STATES, *INPUTS)


class Unit(NamedTuple):
    """One unit: the parameters of thesis (3.21) to (3.23) without their number, tractor front and rear summed.

    Attributes
    ----------
    e_s, e_u : float
        Height of the sprung and unsprung mass centres above the roll axis [m].
    x_s : float
        The sprung mass centre's place forward of the whole-mass centre [m].
    steer, roll_moments, yaw_moment : tuple of str, str
        The inputs that act on it.
    """

    m: float
    m_s: float
    m_u: float
    e_s: float
    e_u: float
    x_s: float
    h_r: float
    I_zz: float
    I_sxx: float
    I_sxz: float
    I_uxx: float
    I_uxz: float
    K_r: float
    L_r: float
    K_t: float
    tyres: TyreDerivatives
    steer: tuple[str, ...]
    roll_moments: tuple[str, ...]
    yaw_moment: tuple[str, ...]


class Balances(NamedTuple):
    """Rows (43,) of a unit: lateral [N], yaw, roll of the sprung and roll of the unsprung mass [N m]."""

    lateral: Array
    yaw: Array
    roll: Array
    tyre_roll: Array


def row(entries: Mapping[str, Any]) -> Array:
    """A row of `COLUMNS` from its entries that are not zero."""
    values: list[Any] = [0] * len(COLUMNS)
    for name, value in entries.items():
        values[COLUMNS.index(name)] = value
    return np.array(values)


def units(p: BTrainYawRoll, U: float) -> tuple[Unit, Unit, Unit]:
    """The three units, their parameters by the same names."""
    one, two, three = (tyre_derivatives(axles, U) for axles in p.axles)
    return (
        Unit(
            m=p.m1,
            m_s=p.m_s1,
            m_u=p.m_u1,
            e_s=p.h_s1 - p.h_r1,
            e_u=p.h_u1 - p.h_r1,
            x_s=p.a11 - p.a11s,
            h_r=p.h_r1,
            I_zz=p.I_zz1,
            I_sxx=p.I_sxx1,
            I_sxz=p.I_sxz1,
            I_uxx=p.I_u1xx,
            I_uxz=p.I_u1xz,
            K_r=p.K_r1f + p.K_r1r,
            L_r=p.L_r1f + p.L_r1r,
            K_t=p.K_t1f + p.K_t1r,
            tyres=one,
            steer=("delta_11",),
            roll_moments=("M_x_1f", "M_x_1r"),
            yaw_moment=(),
        ),
        Unit(
            m=p.m2,
            m_s=p.m_s2,
            m_u=p.m_u2,
            e_s=p.h_s2 - p.h_r2,
            e_u=p.h_u2 - p.h_r2,
            x_s=p.l_c21 - p.a2s,
            h_r=p.h_r2,
            I_zz=p.I_zz2,
            I_sxx=p.I_sxx2,
            I_sxz=p.I_sxz2,
            I_uxx=p.I_u2xx,
            I_uxz=p.I_u2xz,
            K_r=p.K_r2,
            L_r=p.L_r2,
            K_t=p.K_t2,
            tyres=two,
            steer=(),
            roll_moments=("M_x_2",),
            yaw_moment=("M_z_2",),
        ),
        Unit(
            m=p.m3,
            m_s=p.m_s3,
            m_u=p.m_u3,
            e_s=p.h_s3 - p.h_r3,
            e_u=p.h_u3 - p.h_r3,
            x_s=p.l_c3 - p.a3s,
            h_r=p.h_r3,
            I_zz=p.I_zz3,
            I_sxx=p.I_sxx3,
            I_sxz=p.I_sxz3,
            I_uxx=p.I_u3xx,
            I_uxz=p.I_u3xz,
            K_r=p.K_r3,
            L_r=p.L_r3,
            K_t=p.K_t3,
            tyres=three,
            steer=(),
            roll_moments=("M_x_3",),
            yaw_moment=("M_z_3",),
        ),
    )


def balances(unit: Unit, i: int, U: float, g: float, *, full: bool) -> Balances:
    """The balances of unit *i*, with the terms that the thesis drops if *full*.

    What is dropped: the unsprung mass's roll in the lateral balance; the products of inertia that come from mass
    centres ahead of or behind the whole-mass centre, with the unsprung mass's own in the yaw balance; the slip of tyres
    whose contact points swing about the roll axis.
    """
    phi, phi_dot, beta, psi_dot, phi_t, phi_t_dot = (
        f"{name}_{i}" for name in ("phi", "phi_dot", "beta", "psi_dot", "phi_t", "phi_t_dot")
    )
    m, m_s, m_u, e_s, e_u, h_r, tyres = unit.m, unit.m_s, unit.m_u, unit.e_s, unit.e_u, unit.h_r, unit.tyres
    kept = 1 if full else 0
    # the unsprung centre lies so that both masses have their common centre at x = 0: m_u x_u = -m_s x_s
    I_sxz = unit.I_sxz - kept * m_s * unit.x_s * e_s
    I_uxz = unit.I_uxz + kept * m_s * unit.x_s * e_u
    # a contact point is h_r below the roll axis: the tyres see beta - h_r d(phi_t)/dt / U
    swing = -kept * h_r / U
    force = row(
        {beta: tyres.Y_beta, psi_dot: tyres.Y_psi_dot, f"d {phi_t}": swing * tyres.Y_beta}
        | dict(zip(unit.steer, tyres.Y_delta, strict=False))
    )
    moment = row(
        {beta: tyres.N_beta, psi_dot: tyres.N_psi_dot, f"d {phi_t}": swing * tyres.N_beta}
        | dict(zip(unit.steer, tyres.N_delta, strict=False))
        | dict.fromkeys(unit.yaw_moment, 1)
    )
    suspension = row(
        {phi: unit.K_r, phi_t: -unit.K_r, f"d {phi}": unit.L_r, f"d {phi_t}": -unit.L_r}
        | dict.fromkeys(unit.roll_moments, -1)
    )
    acceleration = row({f"d {beta}": U, psi_dot: U})
    sprung, unsprung = row({f"d {phi_dot}": m_s * e_s}), row({f"d {phi_t_dot}": m_u * e_u})
    yawing, rolling, tyre_rolling = (row({f"d {name}": 1}) for name in (psi_dot, phi_dot, phi_t_dot))
    weight, tyre_weight = row({phi: m_s * g * e_s}), row({phi_t: m_u * g * e_u - unit.K_t})
    return Balances(
        lateral=m * acceleration + sprung + kept * unsprung - force,
        yaw=unit.I_zz * yawing - I_sxz * rolling - kept * I_uxz * tyre_rolling - moment,
        roll=(unit.I_sxx + m_s * e_s**2) * rolling - I_sxz * yawing + m_s * e_s * acceleration - weight + suspension,
        tyre_roll=(unit.I_uxx + m_u * e_u**2) * tyre_rolling
        - I_uxz * yawing
        + m_u * e_u * acceleration
        - tyre_weight
        - suspension
        + h_r * force,
    )


def coupling_twist(one: int, other: int, stiffness: float) -> Array:
    """The roll moment that a coupling's stiffness takes from a unit: stiffness (phi_one - phi_other)."""
    return row({f"phi_{one}": stiffness, f"phi_{other}": -stiffness})
