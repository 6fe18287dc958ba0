"""Where branches of a locus pass the imaginary axis."""

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np

from eom.analysis.family import Family, Node
from eom.analysis.matching import Indices
from eom.analysis.stability import sides
from eom.analysis.tracking import Step, step
from eom.analysis.trail import Trail, fine_trail
from eom.model.eigen import Complex


class Crossing(NamedTuple):
    """A branch on the imaginary axis.

    Attributes
    ----------
    value : float
        Of the parameter.
    root : complex
        There [1/s].
    rises : bool
        Whether the real part becomes positive as the parameter grows.
    node : Node
        The model there.
    mode : int
        The branch's mode of it.
    """

    value: float
    root: complex
    rises: bool
    node: Node
    mode: int


def crossings(family: Family, steps: Sequence[Step]) -> list[Crossing]:
    """Crossings of all branches, those of a conjugate pair once, by value."""
    if not steps:
        return []
    trail = fine_trail(family, steps)
    found = [item for branch in range(trail.order.shape[1]) for item in along(family, trail, branch)]
    return sorted((item for item in found if item.root.imag >= 0.0), key=lambda item: (item.value, item.root.imag))


def along(family: Family, trail: Trail, branch: int) -> Iterator[Crossing]:
    """Crossings of one branch."""
    modes = trail.order[:, branch]
    side = [int(sides(node.modes)[mode]) for node, mode in zip(trail.nodes, modes, strict=True)]
    runs = [[k for k, _ in items] for _, items in groupby(enumerate(side), key=lambda item: item[1])]
    for k, run in enumerate(runs[1:], start=1):
        before, here = side[runs[k - 1][0]], side[run[0]]
        over = side[runs[k - 2][0]] if k > 1 else 0
        if before * here == -1:
            yield from passing(family, trail, branch, (run[0] - 1, run[0]))
        elif before == 0 and here * over == -1:
            yield from passing(family, trail, branch, (runs[k - 2][-1], run[0]))
        elif before == 0 and here == 1:
            yield from leaving(family, trail, branch, (run[0] - 1, run[0]))
        elif before == 1 and here == 0 and (k + 1 == len(runs) or side[runs[k + 1][0]] == 1):
            yield from leaving(family, trail, branch, (run[0], run[0] - 1))


def passing(family: Family, trail: Trail, branch: int, ends: tuple[int, int]) -> Iterator[Crossing]:
    """The crossing between two nodes on either side of the axis."""
    a, b = (trail.nodes[k] for k in ends)
    seen = Seen(family, [(trail.nodes[k], trail.order[k]) for k in ends])
    value = solve(lambda value: float(seen.roots(value)[branch].real), a.value, b.value)
    node, order = seen(value)
    root = complex(node.modes.eigenvalues[order[branch]])
    sizes = [abs(trail.nodes[k].modes.eigenvalues[trail.order[k, branch]].real) for k in ends]
    # a jump across the axis is two branches taken for each other
    if abs(root.real) <= 1e-3 * max(sizes):
        rises = bool(trail.nodes[ends[1]].modes.eigenvalues[trail.order[ends[1], branch]].real > 0.0)
        yield Crossing(value, root, rises, node, int(order[branch]))


def leaving(family: Family, trail: Trail, branch: int, ends: tuple[int, int]) -> Iterator[Crossing]:
    """The place where an undamped branch leaves the axis, between a node on it and one to its right.

    There it meets the branch that goes left. The square of their difference is smooth where they meet, and changes
    its sign: from two frequencies, or a pair, to two real parts.
    """
    on, off = ends
    there = trail.nodes[off]
    roots, order = there.modes.eigenvalues, trail.order[off]
    side = sides(there.modes)[order]
    left = [int(k) for k in np.flatnonzero(side == -1) if sides(trail.nodes[on].modes)[trail.order[on, k]] == 0]
    own = roots[order[branch]]
    partners = [k for k in left if abs(roots[order[k]] + own.conjugate()) <= 1e-6 * abs(own)]
    if not partners:
        return
    seen = Seen(family, [(there, order)])

    def split(value: float) -> float:
        now = seen.roots(value)
        return float(((now[branch] - now[partners[0]]) ** 2).real)

    # a node where they all but meet has either sign
    far = min(max(on + (on - off), 0), len(trail.nodes) - 1)
    far = far if split(trail.nodes[on].value) >= 0.0 else on
    value = solve(split, trail.nodes[far].value, there.value)
    node, order = seen(value)
    met = complex(0.5 * (seen.roots(value)[branch] + seen.roots(value)[partners[0]]))
    yield Crossing(value, met if own.imag else 0j, on < off, node, int(order[branch]))


class Seen:
    """Nodes that a search has asked for, with the branches' modes followed from the nearest known one."""

    def __init__(self, family: Family, known: list[tuple[Node, Indices]]) -> None:
        self.family = family
        self.known = known

    def __call__(self, value: float) -> tuple[Node, Indices]:
        """The node at a value and the modes of the branches there."""
        near, order = min(self.known, key=lambda item: abs(item[0].value - value))
        if near.value == value:
            return near, order
        node = Node(value, self.family(value))
        found = node, step(near, node).order[order]
        self.known.append(found)
        return found

    def roots(self, value: float) -> Complex:
        """The branches' roots at a value."""
        node, order = self(value)
        return node.modes.eigenvalues[order]


def solve(function: Callable[[float], float], one: float, two: float) -> float:
    """Zero of a function between two values where it has different signs."""
    from scipy.optimize import brentq  # noqa: PLC0415  slow to import

    return float(brentq(function, one, two, xtol=1e-13 * max(abs(one), abs(two)), rtol=1e-14))
