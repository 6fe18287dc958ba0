"""Applied loads and weight: their resultants, and how they turn relative to the body axes."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.rows import six
from eom.assembly.vectors import Array, skew
from eom.vehicle.elements import GROUND, Body, Load, Vector


def with_weight(bodies: Sequence[Body], loads: Sequence[Load], gravity: Vector) -> list[Load]:
    """The loads and each body's weight, a dead load at its centre of mass."""
    g = np.array(gravity, dtype=float)
    zero = (0.0, 0.0, 0.0)
    weights = []
    for i, body in enumerate(bodies):
        x, y, z = body.mass * g
        weights.append(Load(f"{body.name}.weight", i, body.centre, (x, y, z), zero))
    return [*loads, *weights]


def load_resultants(bodies: Sequence[Body], loads: Sequence[Load]) -> Array:
    """Force and moment about the loaded body's centre of mass of each load, shape (loads, 6 n) [N, N m]."""
    f = np.zeros((len(loads), 6 * len(bodies)))
    for row, load in zip(f, loads, strict=True):
        r = np.subtract(load.place, bodies[load.body].centre)
        row[six(load.body)] = np.concatenate([load.force, np.cross(r, load.force) + np.asarray(load.moment)])
    return f


def load_stiffness(bodies: Sequence[Body], loads: Sequence[Load]) -> Array:
    """Stiffness, shape (6 n, 6 n), of loads that keep their direction in another body's axes.

    The equations are written in body axes, in which a dead load turns as the body does; a load that turns with
    its own body (a follower load) leaves no term.
    """
    K = np.zeros((6 * len(bodies), 6 * len(bodies)))
    for load in loads:
        r = np.subtract(load.place, bodies[load.body].centre)
        turn = np.vstack([skew(load.force), skew(r) @ skew(load.force) + skew(load.moment)])
        K[six(load.body), six(load.body)][:, 3:] -= turn
        if load.frame != GROUND:
            K[six(load.body), six(load.frame)][:, 3:] += turn
    return K
