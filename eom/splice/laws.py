"""Tyre laws of a vehicle's wheels as objects of `eom.tyre`, one stack of them per model."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.errors import TyreError
from eom.splice.kinds import KINDS
from eom.splice.lanes import over_lanes
from eom.tyre.interface import Tyre
from eom.tyre.stack import stack
from eom.vehicle.elements import TyreLaw, Wheel

UNLOADED = 1.0
"""Load [N] that stands for one that nothing tells, of wheels whose linear tyre asks for none."""


class LawGroup(NamedTuple):
    """Wheels whose tyres have the same equations: their numbers, and a tyre whose coefficients are arrays."""

    wheels: NDArray[np.intp]
    tyre: Any


class LawError(ValueError):
    """Coefficients that a tyre cannot have; ``owner`` is its law."""

    def __init__(self, owner: str, what: str) -> None:
        self.owner = owner
        super().__init__(what)


def fitted(law: TyreLaw, load: float, radius: float) -> Tyre:
    """The tyre of a law at the load of one wheel [N], on a wheel of a radius [m]."""
    try:
        return KINDS[law.kind](law, load, radius)
    except TyreError as error:
        raise LawError(law.name, str(error)) from None


def law_groups(wheels: Sequence[Wheel], laws: Sequence[TyreLaw], loads: Array) -> tuple[LawGroup, ...]:
    """The tyres of all wheels; each law is fitted at the mean of the loads [N] of the wheels that have it.

    *loads* are those of all that an element stands for.
    """
    made: dict[tuple[int, float], Tyre] = {}
    tyres: list[Tyre] = []
    for wheel in wheels:
        key = wheel.tyre, wheel.radius
        if key not in made:
            same = [load / other.number for load, other in zip(loads, wheels, strict=True) if other.tyre == wheel.tyre]
            made[key] = fitted(laws[wheel.tyre], float(np.mean(same)), wheel.radius)
        on_side = getattr(made[key], "on", None)
        tyres.append(made[key] if on_side is None else on_side("right" if wheel.mirrored else "left"))
    groups: dict[tuple[Any, ...], list[int]] = {}
    for k, tyre in enumerate(tyres):
        form = tuple(getattr(tyre, name, None) for name in ("form", "use", "combined"))
        groups.setdefault((type(tyre), *form), []).append(k)
    return tuple(LawGroup(np.array(own), stack([tyres[k] for k in own])) for own in groups.values())


def forces(groups: tuple[LawGroup, ...], count: Array, alpha: Any, kappa: Any, Fz: Any, gamma: Any, speed: Any) -> Any:
    """Fx, Fy, Mx, My, Mz of all wheels in their own axes, (5, wheels) [N, N m].

    Arguments are arrays over the wheels as for `eom.tyre.Tyre.forces`; they may be complex, to carry a derivative.
    """
    parts = []
    for own, tyre in groups:
        arguments = [value[own] for value in (alpha, kappa, Fz / count, gamma, speed)]
        parts.append(np.stack([count[own] * value for value in over_lanes(tyre.formula, tyre, arguments)]))
    order = np.argsort(np.concatenate([own for own, _ in groups]))
    return np.concatenate(parts, axis=1)[:, order]
