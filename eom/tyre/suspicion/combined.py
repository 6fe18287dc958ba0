"""Suspicions about how longitudinal and lateral force share the road."""

import dataclasses
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from eom.tyre.branch import Array
from eom.tyre.linear import Linear
from eom.tyre.suspicion.words import Rule, corners, drives, told
from eom.tyre.usual_range import range_of

FINE = 81
SECTORS = 48
FAR = 0.5
"""Slip angle [rad] up to which forces are combined."""
BOUND, DENT, MORE = 1.1, 1.05, 1.1
"""Allowed excess over the ellipse, depth of a dent in the envelope, and weight of a force by the other slip."""

X_WEIGHT = ("RBX1", "RBX2", "RCX1", "REX1", "REX2", "RHX1", "LXAL")
Y_WEIGHT = ("RBY1", "RBY2", "RBY3", "RCY1", "REY1", "REY2", "RHY1", "LYKA")


class Grid(NamedTuple):
    """Slip angles down, longitudinal slips across; forces at nominal load, upright, over their largest pure ones."""

    alpha: Array
    kappa: Array
    x: Array
    y: Array


def grid_of(tyre: Any) -> Grid:
    """Combined forces up to a locked wheel, beyond all peaks, whatever the tyre's range is."""
    steps = np.linspace(-1.0, 1.0, FINE)
    steps = steps * np.abs(steps)
    alpha, kappa, nominal = FAR * steps[:, np.newaxis], steps, range_of(tyre).nominal
    forces, pure = (
        tyre.forces(alpha, kappa, nominal),
        (tyre.forces(0.0, kappa, nominal), tyre.forces(alpha, 0.0, nominal)),
    )
    return Grid(alpha, kappa, forces.Fx / np.abs(pure[0].Fx).max(), forces.Fy / np.abs(pure[1].Fy).max())


def meets(tyre: Any) -> bool:
    """Whether the tyre has both forces, and they are meant to act on each other."""
    return (
        not isinstance(tyre, Linear)
        and drives(tyre)
        and corners(tyre)
        and getattr(tyre, "use", "combined") == "combined"
    )


def weighs(tyre: Any) -> bool:
    """Whether each force is weighted by the other slip."""
    return meets(tyre) and hasattr(tyre, "RBX1") and getattr(tyre, "combined", "cosine") == "cosine"


def uncombined(tyre: Any) -> Iterator[str]:
    """Forces that know nothing of each other."""
    if getattr(tyre, "use", "combined") == "uncombined":
        yield (
            "use = 'uncombined': each force has its full friction whatever the other does, a square instead of an "
            "ellipse; expected 'combined' where slips meet"
        )


def no_weight(tyre: Any) -> Iterator[str]:
    """Coefficients of combined slip that are zero."""
    if not weighs(tyre):
        return
    x, y = ([name for name in names if getattr(tyre, name) == 0.0] for names in (("RBX1", "RCX1"), ("RBY1", "RCY1")))
    if x and y:
        yield f"{told(tyre, *x, *y)}: the slips do not weaken each other's force, together up to 1.4 times the friction"
    elif x:
        yield f"{told(tyre, *x)}: the slip angle takes nothing from the longitudinal force"
    elif y:
        yield f"{told(tyre, *y)}: the longitudinal slip takes nothing from the lateral force"


def bound(tyre: Any) -> Iterator[str]:
    """Forces together beyond the ellipse through both largest ones, although they act on each other."""
    if not meets(tyre) or any(no_weight(tyre)):
        return
    grid = grid_of(tyre)
    reach = np.hypot(grid.x, grid.y)
    i, k = np.unravel_index(np.argmax(reach), reach.shape)
    if reach[i, k] > BOUND:
        yield (
            f"{weights(tyre)}: both forces together exceed the ellipse of the largest ones by "
            f"{100.0 * (reach[i, k] - 1.0):.0f} % at slip angle {grid.alpha[i, 0]:.3f} rad and slip {grid.kappa[k]:.2f}"
        )


def envelope(tyre: Any) -> Iterator[str]:
    """A dent in the outline of all forces: rubber slides in the direction that wastes most, so it has none."""
    if not meets(tyre):
        return
    grid = grid_of(tyre)
    if not np.all(np.isfinite([grid.x, grid.y])):
        return
    depth, direction = deepest_dent(grid)
    if depth > DENT:
        yield (
            f"{weights(tyre)}: the outline of the forces has a dent of {100.0 * (depth - 1.0):.0f} % at "
            f"Fx/Fx_max = {direction[0]:.2f}, Fy/Fy_max = {direction[1]:.2f}; expected a convex one"
        )


def deepest_dent(grid: Grid) -> tuple[float, Array]:
    """Radius of the convex hull over that of the outermost force near by, where it is largest, and that force."""
    from scipy.spatial import ConvexHull  # noqa: PLC0415  slow to import

    points = np.column_stack([grid.x.ravel(), grid.y.ravel()])
    sector = np.floor((np.arctan2(points[:, 1], points[:, 0]) / (2.0 * np.pi) + 0.5) * SECTORS).astype(int) % SECTORS
    outermost = np.lexsort((np.hypot(*points.T), sector))
    last = np.append(np.flatnonzero(np.diff(sector[outermost])), len(points) - 1)
    outer = points[outermost[last]]
    normals, offsets = np.split(ConvexHull(points).equations, [2], axis=1)
    # the hull is where no facet's normal . point + offset is positive; one facet is met first
    depth = 1.0 / np.max(outer @ normals.T / -offsets.T, axis=1)
    k = int(np.argmax(depth))
    return float(depth[k]), outer[k]


def weight(tyre: Any) -> Iterator[str]:
    """Weighting of a force by the other slip that turns its sign or makes it larger."""
    if not weighs(tyre):
        return
    # the side force that longitudinal slip brings of itself is no weighting
    plain = dataclasses.replace(tyre, RVY1=0.0, RVY2=0.0, RVY3=0.0) if hasattr(tyre, "RVY1") else tyre
    where = range_of(plain)
    alpha, kappa = np.linspace(*where.alpha, FINE)[:, np.newaxis], np.linspace(*where.kappa, FINE)
    both = plain.forces(alpha, kappa, where.nominal)
    pure = plain.forces(0.0, kappa, where.nominal).Fx, plain.forces(alpha, 0.0, where.nominal).Fy
    for force, slip, names, share in (
        ("longitudinal", "slip angle", X_WEIGHT, share_of(both.Fx, pure[0])),
        ("lateral", "longitudinal slip", Y_WEIGHT, share_of(both.Fy, pure[1])),
    ):
        if np.min(share) < 0.0:
            yield f"{told(tyre, *names)}: the {slip} turns the {force} force round, to {np.min(share):.2f} of itself"
        if np.max(share) > MORE:
            yield f"{told(tyre, *names)}: the {slip} makes the {force} force larger, {np.max(share):.2f} of itself"


def share_of(both: Array, pure: Array) -> Array:
    """What is left of a force; where it is nearly zero by itself, anything between none and all."""
    large = np.abs(pure) > 0.1 * np.max(np.abs(pure))
    return np.where(large, both / np.where(large, pure, 1.0), 0.5)


def weights(tyre: Any) -> str:
    """The coefficients of combined slip."""
    return told(tyre, "RBX1", "RCX1", "RBY1", "RCY1") or type(tyre).__name__


COMBINED: tuple[Rule, ...] = (uncombined, no_weight, bound, envelope, weight)
