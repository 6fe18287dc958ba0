"""The B-train with roll by Lagrange's method of sympy, linear about straight running, nothing dropped.

Six rigid bodies in SAE axes. Each unit's sprung and unsprung mass roll about one axis, which moves horizontally at its
height and yaws with the unit. At the couplings the horizontal places of both units are the same; no weight passes.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import sympy as sp
import sympy.physics.mechanics as me

from eom.closed_form import BTrainYawRoll
from tests.closed_form.symbols import U, symbolic

t = sp.Symbol("t")
I_UZZ = sp.Integer(3000)
"""Yaw inertia of an unsprung mass: only the unit's whole one can matter."""


class RollLagrange(NamedTuple):
    """mass q'' + damping q' + stiffness q = control u, with q = y, psi_i, phi_i, phi_t_i; matrices of symbols.

    u are the front steer angle, M_z2, M_z3 and roll moments on the units. The rows of *axis* and *centre* give, by q,
    the lateral places of each unit's roll axis below the whole-mass centre and of that centre; *yaw* the headings.
    """

    mass: sp.Matrix
    damping: sp.Matrix
    stiffness: sp.Matrix
    control: sp.Matrix
    axis: sp.Matrix
    centre: sp.Matrix
    yaw: sp.Matrix


class Unit(NamedTuple):
    """Parameters of one unit, as symbols or sums of them."""

    m_s: Any
    m_u: Any
    e_s: Any
    e_u: Any
    x_s: Any
    h_r: Any
    h_cr: Any
    I_zz: Any
    I_sxx: Any
    I_sxz: Any
    I_uxx: Any
    I_uxz: Any
    K_r: Any
    L_r: Any
    K_t: Any
    ahead: Any
    behind: Any
    axles: Sequence[tuple[Any, Any]]


def units_of(p: BTrainYawRoll) -> list[Unit]:
    """The three units of the B-train."""
    found = []
    for i, x_s, ahead, behind in (
        (1, p.a11 - p.a11s, None, p.l_c1),
        (2, p.l_c21 - p.a2s, p.l_c21, p.l_c22),
        (3, p.l_c3 - p.a3s, p.l_c3, None),
    ):
        heights = {name: getattr(p, f"{name}{i}") for name in ("h_s", "h_u", "h_r", "h_cr")}
        springs = {
            name: getattr(p, f"{name}1f") + getattr(p, f"{name}1r") if i == 1 else getattr(p, f"{name}{i}")
            for name in ("K_r", "L_r", "K_t")
        }
        found.append(
            Unit(
                m_s=getattr(p, f"m_s{i}"),
                m_u=getattr(p, f"m{i}") - getattr(p, f"m_s{i}"),
                e_s=heights["h_s"] - heights["h_r"],
                e_u=heights["h_u"] - heights["h_r"],
                x_s=x_s,
                h_r=heights["h_r"],
                h_cr=heights["h_cr"],
                I_zz=getattr(p, f"I_zz{i}"),
                I_sxx=getattr(p, f"I_sxx{i}"),
                I_sxz=getattr(p, f"I_sxz{i}"),
                I_uxx=getattr(p, f"I_u{i}xx"),
                I_uxz=getattr(p, f"I_u{i}xz"),
                ahead=ahead,
                behind=behind,
                axles=p.axles[i - 1],
                **springs,
            )
        )
    return found


class Small:
    """Quantities that are small, such as functions of time; symbols in their place let sympy differentiate faster."""

    def __init__(self, quantities: Sequence[Any]) -> None:
        self.symbols = {quantity: sp.Dummy() for quantity in quantities}
        self.zero = dict.fromkeys(self.symbols.values(), sp.Integer(0))

    def jacobian(self, expressions: Any, by: Sequence[Any]) -> Any:
        """Jacobian of expressions by some of the quantities, where all of them are zero."""
        plain = [sp.sympify(expression).xreplace(self.symbols) for expression in expressions]
        return sp.Matrix([[row.diff(self.symbols[quantity]).xreplace(self.zero) for quantity in by] for row in plain])

    def second_order(self, expression: Any) -> Any:
        """Taylor polynomial of second order about zero: all that linear equations need of an energy."""
        quantities, symbols = list(self.symbols), list(self.symbols.values())
        plain = expression.xreplace(self.symbols)
        taylor = plain.xreplace(self.zero)
        for k, one in enumerate(symbols):
            slope = plain.diff(one)
            taylor += slope.xreplace(self.zero) * quantities[k]
            for other, quantity in zip(symbols[k:], quantities[k:], strict=True):
                twice = slope.diff(other).xreplace(self.zero) * quantities[k] * quantity
                taylor += twice / 2 if other is one else twice
        return taylor


def moving(origin: Any, frame: Any, place: Any) -> Any:
    """A point at a place from the origin, with its velocity."""
    point = origin.locatenew("P", place)
    point.set_vel(frame, place.dt(frame))
    return point


@cache
def b_train_by_lagrange() -> RollLagrange:
    """The equations in symbols, those of `symbolic(BTrainYawRoll)` and the speed U."""
    p = symbolic(BTrainYawRoll)
    units = units_of(p)
    y, *rest = q = me.dynamicsymbols("y psi1:4 phi1:4 phi_t1:4")
    psi, phi, phi_t = rest[:3], rest[3:6], rest[6:]
    steer, *moments = inputs = sp.symbols("steer M_z2 M_z3 M_x1 M_x2 M_x3")
    M_z, M_x = [sp.Integer(0), *moments[:2]], moments[2:]
    places = Small(q)
    N, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(N, 0)

    kinetic, potential, forces = sp.Integer(0), sp.Integer(0), []
    axes, centres, above = [], [], U * t * N.x + y * N.y
    for i, unit in enumerate(units):
        heading = N.orientnew(f"Y{i}", "Axis", (psi[i], N.z))
        sprung = heading.orientnew(f"S{i}", "Axis", (phi[i], heading.x))
        unsprung = heading.orientnew(f"T{i}", "Axis", (phi_t[i], heading.x))
        # the point of the roll axis below the whole-mass centre; heights are from the axis
        axis = above
        if i > 0:
            to_hitch = unit.ahead * heading.x - unit.h_cr * sprung.z
            axis = above - (to_hitch.dot(N.x) * N.x + to_hitch.dot(N.y) * N.y)
        x_u = -unit.m_s * unit.x_s / unit.m_u
        centre_s = axis + unit.x_s * heading.x - unit.e_s * sprung.z
        centre_u = axis + x_u * heading.x - unit.e_u * unsprung.z
        I_szz = unit.I_zz - I_UZZ - unit.m_s * unit.x_s**2 - unit.m_u * x_u**2
        for m, centre, frame, inertia in (
            (unit.m_s, centre_s, sprung, me.inertia(sprung, unit.I_sxx, 0, I_szz, 0, 0, -unit.I_sxz)),
            (unit.m_u, centre_u, unsprung, me.inertia(unsprung, unit.I_uxx, 0, I_UZZ, 0, 0, -unit.I_uxz)),
        ):
            for along in (N.x, N.y, N.z):
                place = places.second_order(centre.dot(along).subs(U * t, 0))
                speed = place.diff(t) + (U if along is N.x else 0)
                kinetic += m * speed**2 / 2
                potential -= m * p.g * place if along is N.z else 0
            omega = frame.ang_vel_in(N)
            kinetic += omega.dot(inertia.dot(omega)) / 2
        potential += (unit.K_r * (phi[i] - phi_t[i]) ** 2 + unit.K_t * phi_t[i] ** 2) / 2
        damping = unit.L_r * (phi[i] - phi_t[i]).diff(t) * heading.x
        forces += [(sprung, M_x[i] * heading.x - damping + M_z[i] * N.z), (unsprung, damping - M_x[i] * heading.x)]
        for k, (C, x) in enumerate(unit.axles):
            contact = moving(origin, N, axis + x * heading.x + unit.h_r * unsprung.z)
            slip = (steer if i == k == 0 else 0) - contact.vel(N).dot(heading.y) / U
            forces.append((contact, C * slip * heading.y))
        axes.append(axis.dot(N.y))
        centres.append((unit.m_s * centre_s.dot(N.y) + unit.m_u * centre_u.dot(N.y)) / (unit.m_s + unit.m_u))
        if i < 2:
            hitch = -unit.behind * heading.x - unit.h_cr * sprung.z
            above = axis + hitch.dot(N.x) * N.x + hitch.dot(N.y) * N.y
    potential += (p.K_12 * (phi[0] - phi[1]) ** 2 + p.K_23 * (phi[1] - phi[2]) ** 2) / 2
    rates = [symbol.diff(t) for symbol in q]
    lagrangian = Small([*rates, *q]).second_order(kinetic) - potential
    method = me.LagrangesMethod(lagrangian, q, forcelist=forces, frame=N)
    equations = method.form_lagranges_equations()

    accelerations = [symbol.diff(t, 2) for symbol in q]
    derivative = Small([*accelerations, *rates, *q, *inputs]).jacobian
    return RollLagrange(
        mass=derivative(equations, accelerations),
        damping=derivative(equations, rates),
        stiffness=derivative(equations, q),
        control=-derivative(equations, inputs),
        axis=derivative(axes, q),
        centre=derivative(centres, q),
        yaw=derivative(psi, q),
    )
