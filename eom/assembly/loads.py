"""Applied loads and weight: their resultants, and how they turn relative to the body axes."""

from collections.abc import Iterator, Sequence

import numpy as np

from eom.assembly.algebra import Entry, square_entry
from eom.assembly.beam import beam_weight
from eom.assembly.rows import arm_of, six
from eom.assembly.vectors import Array, array, skew, zeros
from eom.vehicle.elements import Body, Load, System


def with_weight(system: System) -> list[Load]:
    """The loads and each body's weight, a dead load at its centre of mass, and that of beams at their ends."""
    g = array(system.gravity)
    zero = (0.0, 0.0, 0.0)
    weights = []
    for i, body in enumerate(system.bodies):
        x, y, z = body.mass * g
        weights.append(Load(f"{body.name}.weight", i, body.centre, (x, y, z), zero))
    return [*system.loads, *weights, *(load for beam in system.beams for load in beam_weight(beam, system.gravity))]


def load_sums(bodies: Sequence[Body], loads: Sequence[Load]) -> tuple[Array, Array]:
    """Force and moment about each body's centre of mass, shape (6 n,) [N, N m], and the sum of their sizes."""
    wrenches = [
        np.concatenate([load.force, skew(arm_of(bodies, load.body, load.place)) @ load.force + load.moment])
        for load in loads
    ]
    f, size = (zeros(6 * len(bodies), *wrenches) for _ in range(2))
    for load, wrench in zip(loads, wrenches, strict=True):
        f[six(load.body)] += wrench
        size[six(load.body)] += np.abs(wrench)
    return f, size


def load_stiffness(bodies: Sequence[Body], loads: Sequence[Load]) -> Iterator[Entry]:
    """Stiffness of loads that keep their direction in another body's axes, over all coordinates.

    The equations are written in body axes, in which a dead load turns as the body does; a load that turns with
    its own body (a follower load) leaves no term.
    """
    for load in loads:
        if load.frame == load.body or not (np.any(load.force) or np.any(load.moment)):
            continue
        r = arm_of(bodies, load.body, load.place)
        turn = np.vstack([skew(load.force), skew(r) @ skew(load.force) + skew(load.moment)])
        K = zeros((12, 12), turn)
        K[:6, 3:6] -= turn
        K[:6, 9:] += turn
        yield square_entry((load.body, load.frame), K)
