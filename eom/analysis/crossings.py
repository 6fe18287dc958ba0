"""Where branches of a locus pass the imaginary axis."""

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np

from eom.analysis.family import Family, Node
from eom.analysis.matching import Indices
from eom.analysis.stability import sides
from eom.analysis.tracking import Step, step
from eom.analysis.trail import Trail, fine_trail
from eom.model.eigen import Complex

# of the real parts at the ends: a root solved for that is further from the axis is none
JUMP = 1e-3
# of its size: what rounding leaves between a root and the mirror image of another
MIRRORED = 1e-6


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
    """Crossings of one branch: between runs of nodes on one side of the axis, and where it leaves the axis."""
    side = [int(sides(node.modes)[order[branch]]) for node, order in zip(*trail, strict=True)]
    runs = [[k for k, _ in items] for _, items in groupby(enumerate(side), key=lambda item: item[1])]
    off_axis = [run for run in runs if side[run[0]]]
    for one, two in pairwise(off_axis):
        if side[one[0]] != side[two[0]]:
            yield from passing(family, trail, branch, (one[-1], two[0]))
    for run in off_axis:
        for off, way in ((run[0], -1), (run[-1], 1)):
            on = off + way
            if 0 <= on < len(side):
                beyond = next((side[k] for k in range(on, len(side) if way > 0 else -1, way) if side[k]), 0)
                if beyond != -side[off]:
                    yield from leaving(family, trail, branch, (on, off))


def passing(family: Family, trail: Trail, branch: int, ends: tuple[int, int]) -> Iterator[Crossing]:
    """The crossing between two nodes on either side of the axis."""
    before, after = (trail.real[k, branch] for k in ends)
    seen = Seen(family, [(trail.nodes[k], trail.order[k]) for k in ends])
    value = solve(lambda value: float(seen.roots(value)[branch].real), *(trail.nodes[k].value for k in ends))
    root = complex(seen.roots(value)[branch])
    # a jump across the axis is two branches taken for each other
    if abs(root.real) <= JUMP * max(abs(before), abs(after)):
        node, order = seen(value)
        yield Crossing(value, root, bool(after > before), node, int(order[branch]))


def leaving(family: Family, trail: Trail, branch: int, ends: tuple[int, int]) -> Iterator[Crossing]:
    """The place where a branch leaves the axis, between a node on it and one that is not.

    An undamped branch meets its mirror image there. The square of their difference is smooth where they meet, and
    changes its sign: from two frequencies, or a pair, to two real parts. Told once, by the branch that goes right.
    Without an image, the first or last value may itself be critical.
    """
    on, off = ends
    there, order = trail.nodes[off], trail.order[off]
    roots, here = there.modes.eigenvalues[order], trail.nodes[on]
    resting = sides(here.modes)[trail.order[on]] == 0
    images = np.flatnonzero(resting & (np.abs(roots + roots[branch].conjugate()) <= MIRRORED * np.abs(roots[branch])))
    if not images.size:
        if on in {0, len(trail.nodes) - 1}:
            root = complex(0.0, here.modes.eigenvalues[trail.order[on, branch]].imag)
            rises = (roots[branch].real > 0.0) == (on < off)
            yield Crossing(here.value, root, bool(rises), here, int(trail.order[on, branch]))
        return
    if roots[branch].real < 0.0:
        return
    pair = [branch, int(images[0])]
    # followed from where both are told apart
    seen = Seen(family, [(there, order)])

    def split(value: float) -> float:
        one, two = seen.roots(value)[pair]
        return float(((one - two) ** 2).real)

    # such a node has either sign: the next one on the axis has not
    start = min(max(2 * on - off, 0), len(trail.nodes) - 1) if split(here.value) >= 0.0 else on
    start_value = trail.nodes[start].value
    value = solve(split, start_value, there.value) if split(start_value) < 0.0 else here.value
    node, found = seen(value)
    circular = float(np.mean(seen.roots(value)[pair].imag)) if roots[branch].imag else 0.0
    yield Crossing(value, complex(0.0, circular), on < off, node, int(found[branch]))


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
