"""Roots followed from value to value of a parameter."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.analysis.family import Family, Node, check_states
from eom.analysis.matching import Indices, match
from eom.analysis.spectrum import shared_cyclic, spectrum

# models between two values, by which roots that are not recognised at once are followed
EXTRA = 12
# where a step is split: not in the middle, where symmetric things happen
SPLIT = 0.4142


class Step(NamedTuple):
    """Modes of one node found in a neighbouring one.

    Attributes
    ----------
    one, two : Node
    order : Indices
        Mode ``order[i]`` of the second continues mode i of the first.
    clear, merged : bool
        As `Match`.
    """

    one: Node
    two: Node
    order: Indices
    clear: bool
    merged: bool


def step(one: Node, two: Node) -> Step:
    """The modes of one node in another, without values between; those of shared cyclic states stay themselves."""
    shared = shared_cyclic(one, two)
    here, there = spectrum(one, shared), spectrum(two, shared)
    found = match(here, there)
    order = np.empty(len(one.modes.eigenvalues), dtype=np.intp)
    order[here.modes] = there.modes[found.order]
    places = [{node.model.states[s]: k for k, s in enumerate(node.model.cyclic)} for node in (one, two)]
    for name in shared:
        order[places[0][name]] = places[1][name]
    return Step(one, two, order, found.clear, found.merged)


def link(family: Family, one: Node, two: Node) -> list[Step]:
    """Steps from one node to another, by values between them where roots are not recognised, at most `EXTRA`."""
    targets, at, extra = [two], one, EXTRA
    steps: list[Step] = []
    while targets:
        check_states(at, targets[-1])
        found = step(at, targets[-1])
        if found.clear or not extra:
            steps.append(found)
            at = targets.pop()
        else:
            extra -= 1
            value = at.value + SPLIT * (targets[-1].value - at.value)
            targets.append(Node(value, family(value)))
    return steps


def composed(steps: Sequence[Step], start: Indices) -> Indices:
    """Modes *start* of the first node as modes of the last."""
    for item in steps:
        start = item.order[start]
    return start


def follow(family: Family, nodes: Sequence[Node]) -> tuple[list[Indices], list[Step]]:
    """Which mode of each node belongs to which branch (a mode of the first), and the steps that lead through all.

    At a value where roots happen to be equal their eigenvectors tell nothing, so that the next value is reached from
    the one before.
    """
    orders = [np.arange(len(nodes[0].modes.eigenvalues))]
    trail: list[Step] = []
    at = 0
    for k in range(1, len(nodes)):
        steps = link(family, nodes[at], nodes[k])
        orders.append(composed(steps, orders[at]))
        # roots that stay equal stay so however far they are followed
        if not steps[-1].merged or at < k - 1 or k == len(nodes) - 1:
            trail += steps
            at = k
    return orders, trail
