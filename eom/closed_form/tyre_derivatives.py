"""Derivatives of a unit's tyre forces by sideslip, yaw rate and steer: thesis (3.24)."""

from collections.abc import Sequence
from typing import NamedTuple


class Axle(NamedTuple):
    """An axle: its cornering stiffness C [N/rad] and its place x [m], forward of the whole-mass centre."""

    C: float
    x: float


class TyreDerivatives(NamedTuple):
    """Y = Y_beta beta + Y_psi_dot psi_dot + sum(Y_delta delta) [N], to the right; N the same, a yaw moment [N m].

    N is about the whole-mass centre, clockwise from above; beta, psi_dot and delta are positive to the right (SAE).
    """

    Y_beta: float
    Y_psi_dot: float
    Y_delta: tuple[float, ...]
    N_beta: float
    N_psi_dot: float
    N_delta: tuple[float, ...]


def tyre_derivatives(axles: Sequence[Axle], U: float) -> TyreDerivatives:
    """Derivatives of a unit at forward speed U [m/s], thesis (3.24) with positive C.

    Each axle gives the side force C (delta - beta - x psi_dot / U), (3.35). The thesis writes (3.24) for negative C;
    the numbers of its Appendix B have the signs of this function.
    """
    force = sum(axle.C for axle in axles)
    moment = sum(axle.C * axle.x for axle in axles)
    second = sum(axle.C * axle.x**2 for axle in axles)
    return TyreDerivatives(
        Y_beta=-force,
        Y_psi_dot=-moment / U,
        Y_delta=tuple(axle.C for axle in axles),
        N_beta=-moment,
        N_psi_dot=-second / U,
        N_delta=tuple(axle.C * axle.x for axle in axles),
    )
