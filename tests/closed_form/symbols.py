"""Parameter sets of symbols, and the symbols of the printed matrices by the same parameters."""

from dataclasses import fields
from typing import Any, TypeVar

import sympy as sp

from eom.closed_form import BTrainYawPlane, BTrainYawRoll, tyre_derivatives
from eom.closed_form.parameters import Parameters

P = TypeVar("P", bound=Parameters)
U: Any = sp.Symbol("U", positive=True)


def symbolic(kind: type[P]) -> P:
    """A parameter set whose values are symbols with the names of its fields."""
    return kind(**{field.name: sp.Symbol(field.name) for field in fields(kind)})


def names(p: Parameters) -> dict[str, Any]:
    """What the symbols of the print stand for."""
    found = {field.name: getattr(p, field.name) for field in fields(p)} | {"U": U}
    if isinstance(p, BTrainYawRoll):
        found |= {"m_u1": p.m_u1, "m_u2": p.m_u2, "m_u3": p.m_u3}
    if isinstance(p, BTrainYawPlane):
        found |= derivatives(p, U)
    return found


def derivatives(p: BTrainYawPlane, speed: Any) -> dict[str, Any]:
    """Derivatives of the tyre forces by their names in `printed`."""
    found: dict[str, Any] = {}
    steered = (("d11", "d2", "d3"), ("d4", "d5", "d6"), ("d7", "d8", "d9"))
    for unit, (axles, steer) in enumerate(zip(p.axles, steered, strict=True), start=1):
        d = tyre_derivatives(axles, speed)
        found |= {f"Y_b{unit}": d.Y_beta, f"N_b{unit}": d.N_beta, f"Y_r{unit}": d.Y_psi_dot, f"N_r{unit}": d.N_psi_dot}
        found |= {f"Y_{name}": value for name, value in zip(steer, d.Y_delta, strict=True)}
        found |= {f"N_{name}": value for name, value in zip(steer, d.N_delta, strict=True)}
    return found
