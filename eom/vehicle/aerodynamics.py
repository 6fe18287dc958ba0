"""Aerodynamic connectors: drag, derivatives about the trim, wings, control surfaces.

Forces and moments refer to x forward, y left, z up at their place, and to velocities in body axes.
"""

from typing import Literal, Self

from pydantic import model_validator

from eom.vehicle.parts import Flag, Identifier, Strict
from eom.vehicle.quantity import Area, Density, Length, Place, Plain, Speed
from eom.vehicle.springs import DampingMatrix, MassMatrix, acts


class Aero(Strict):
    """Forces and moments at a place: minus ``damping`` times velocity, minus ``added_mass`` times its rate.

    Rows: X, Y, Z, L, M, N; columns: u, v, w, p, q, r; SI units.
    """

    type: Literal["aero"]
    body: Identifier
    at: Place
    damping: DampingMatrix | None = None
    added_mass: MassMatrix | None = None
    mirror: Flag = False

    @model_validator(mode="after")
    def _acts(self) -> Self:
        return acts(self, ("damping", "added_mass"))


class Drag(Strict):
    """Air's resistance along x: half of density times area times coefficient times the square of the speed."""

    type: Literal["drag"]
    body: Identifier
    at: Place
    area: Area
    coefficient: Plain
    density: Density | None = None
    mirror: Flag = False


class Flow(Strict):
    """A surface in a stream of air; ``speed`` is the trim's unless given."""

    body: Identifier
    at: Place
    area: Area
    span: Length
    chord: Length
    density: Density
    speed: Speed | None = None
    mirror: Flag = False


class WingDerivatives(Strict):
    """Derivatives of the coefficients of force and moment by relative velocity.

    C_X, C_Z, C_m by u/U, w/U and q c/(2 U); C_Y, C_l, C_n by v/U, p b/(2 U) and r b/(2 U).
    """

    x_u: Plain | None = None
    x_w: Plain | None = None
    x_q: Plain | None = None
    z_u: Plain | None = None
    z_w: Plain | None = None
    z_q: Plain | None = None
    m_u: Plain | None = None
    m_w: Plain | None = None
    m_q: Plain | None = None
    y_v: Plain | None = None
    y_p: Plain | None = None
    y_r: Plain | None = None
    l_v: Plain | None = None
    l_p: Plain | None = None
    l_r: Plain | None = None
    n_v: Plain | None = None
    n_p: Plain | None = None
    n_r: Plain | None = None


class Wing(Flow):
    """A wing by its eighteen derivatives; what is left out is zero."""

    type: Literal["wing"]
    derivatives: WingDerivatives


class SurfaceDerivatives(Strict):
    """Derivatives of the coefficients C_X, C_Y, C_Z, C_l, C_m, C_n by the deflection [1/rad]."""

    x: Plain | None = None
    y: Plain | None = None
    z: Plain | None = None
    l: Plain | None = None  # noqa: E741  the name that the field uses
    m: Plain | None = None
    n: Plain | None = None


class ControlSurface(Flow):
    """A flap or rudder: its input ``name.deflection`` [rad] makes forces and moments at its place."""

    type: Literal["control_surface"]
    derivatives: SurfaceDerivatives
