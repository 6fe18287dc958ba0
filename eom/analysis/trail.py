"""Neighbouring values at which branches are known, fine enough to show which of them cross the imaginary axis."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.analysis.family import Family, Node
from eom.analysis.matching import Indices
from eom.analysis.stability import on_axis, sides_of
from eom.analysis.tracking import Step, composed, link
from eom.assembly.vectors import Array

# how often a step is halved in search of a double crossing
HALVINGS = 8
# of the smaller real part at the ends of a step: a curve that comes closer between them is looked at again
CLOSE = 0.5
SAMPLES = np.linspace(0.0, 1.0, 17)[1:-1]


class Trail(NamedTuple):
    """Nodes of rising value, with the modes that are one branch: order (nodes, branches)."""

    nodes: list[Node]
    order: Indices

    @property
    def real(self) -> Array:
        """Real parts of the branches, (nodes, branches) [1/s]."""
        return np.array([node.modes.eigenvalues.real[order] for node, order in zip(*self, strict=True)])


def fine_trail(family: Family, steps: Sequence[Step]) -> Trail:
    """The nodes of consecutive steps, and others between them wherever a branch may cross twice."""
    current = list(steps)
    for _ in range(HALVINGS):
        again = suspicious(rising(current))
        if current[0].one.value > current[-1].two.value:
            again = again[::-1]
        if not np.any(again):
            break
        current = [
            fine
            for item, doubtful in zip(current, again, strict=True)
            for fine in (halved(family, item) if doubtful else [item])
        ]
    return rising(current)


def halved(family: Family, item: Step) -> list[Step]:
    """A step by its middle."""
    middle = 0.5 * (item.one.value + item.two.value)
    node = Node(middle, family(middle))
    return [*link(family, item.one, node), *link(family, node, item.two)]


def rising(steps: Sequence[Step]) -> Trail:
    """The nodes of consecutive steps in the order of rising values."""
    nodes = [steps[0].one, *(item.two for item in steps)]
    order = [np.arange(len(nodes[0].modes.eigenvalues))]
    for item in steps:
        order.append(composed([item], order[-1]))
    way = 1 if nodes[0].value < nodes[-1].value else -1
    return Trail(nodes[::way], np.array(order)[::way])


def suspicious(trail: Trail) -> NDArray[np.bool_]:
    """In which steps a parabola through three neighbouring points of a branch crosses more often than the ends show.

    Both parabolas that a step is part of are asked. Three points are needed: a step alone is always suspicious.
    """
    result = np.full(len(trail.nodes) - 1, len(trail.nodes) == 2)
    x, real = np.array([node.value for node in trail.nodes]), trail.real
    limits, side = (
        np.array([figure(node.modes.eigenvalues)[order] for node, order in zip(*trail, strict=True)])
        for figure in (on_axis, sides_of)
    )
    for k in range(len(x) - 2):
        for step in (k, k + 1):
            curve = parabola(x[k : k + 3], real[k : k + 3], x[step] + SAMPLES * (x[step + 1] - x[step]))
            ends = slice(step, step + 2)
            result[step] |= crosses_again(curve, real[ends], side[ends], np.max(limits[ends], axis=0))
    return result


def parabola(x: Array, values: Array, at: Array) -> Array:
    """Parabolas through *values* (3, branches) at *x*, at other places: (places, branches)."""
    first = np.diff(values, axis=0) / np.diff(x)[:, np.newaxis]
    second = (first[1] - first[0]) / (x[2] - x[0])
    away = (at - x[0])[:, np.newaxis]
    return np.asarray(values[0] + away * first[0] + away * (at - x[1])[:, np.newaxis] * second)


def crosses_again(curve: Array, ends: Array, side: NDArray[np.intp], limit: Array) -> bool:
    """Whether any branch goes to the axis and back between its *ends* (2, branches), which are on these sides."""
    right, left = np.any(curve > limit, axis=0), np.any(curve < -limit, axis=0)
    both = side[0] * side[1]
    dips = (both == 1) & (np.min(side[0] * curve, axis=0) < CLOSE * np.min(np.abs(ends), axis=0))
    returns = (both == -1) & (np.sum(np.diff(np.sign(curve), axis=0) != 0.0, axis=0) > 1)
    # an end on the axis hides on which side the curve arrives there
    hidden = (both == 0) & np.where(side[0] == side[1], right | left, right & left)
    return bool(np.any(dips | returns | hidden))
