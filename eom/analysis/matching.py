"""Which root of one model is which of a neighbouring one.

Two things tell. The product of the spectral projectors of root i here and root j there, of which the trace is

    P_ij = (w_i v'_j) (w'_j v_i)

with right eigenvectors v and left ones w, w_i v_i = 1: no change of coordinates changes it, it sums to one over j, and
is zero between parts of a system that know nothing of each other, however close their roots. And the root itself: by
first-order perturbation it moves at the rate w dA v, of which the mean of both ends is a rule of second order.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.analysis.spectrum import Spectrum
from eom.assembly.vectors import Array
from eom.model.eigen import Complex

Indices = NDArray[np.intp]

# |P - 1| up to which a root counts as recognised
RECOGNISED = 0.5
# of the largest root: zero but for rounding, also where a double zero has lost half the digits
NEGLIGIBLE = 1e-7
# of a root's size: closer roots have eigenvectors that mean nothing alone
EQUAL = 1e-6


class Match(NamedTuple):
    """Roots of one model found in another.

    Attributes
    ----------
    order : Indices
        Root ``order[i]`` of the second continues root i of the first.
    clear : bool
        Whether every root is recognised, alone or as one of a group that meets.
    merged : bool
        Whether roots that were apart are equal in the second, so that its eigenvectors cannot tell them.
    """

    order: Indices
    clear: bool
    merged: bool


def match(one: Spectrum, two: Spectrum) -> Match:
    """The roots of *one* in *two*, of which the states must be as many."""
    from scipy.optimize import linear_sum_assignment  # noqa: PLC0415  slow to import

    distance = np.abs(two.roots - one.roots[:, np.newaxis])
    same_states = one.states == two.states
    if same_states:
        P = (one.left @ two.right) * (two.left @ one.right).T
        # infinitesimal changes of the roots by the finite change of A
        first, second = (np.sum((item.left @ (two.A - one.A)) * item.right.T, axis=1) for item in (one, two))
        miss = np.abs(two.roots - one.roots[:, np.newaxis] - 0.5 * (first[:, np.newaxis] + second))
    else:
        # other states: only the roots can tell
        P, miss = np.ones_like(distance, dtype=complex), distance
    largest = float(np.max(np.abs([one.roots, two.roots]), initial=0.0))
    size = np.abs(one.roots)[:, np.newaxis] + np.abs(two.roots) + NEGLIGIBLE * largest + 1e-300
    cost = np.minimum(np.minimum(miss, distance) / size, 1.0) + np.minimum(np.abs(1.0 - P), 1.0)
    # a root of the upper half plane never becomes one of the lower without having been real
    cost += 10.0 * (one.roots.imag[:, np.newaxis] * two.roots.imag < 0.0)
    order = keep_upper(one.roots, two.roots, linear_sum_assignment(cost)[1])
    zero = np.maximum(np.abs(one.roots), np.abs(two.roots[order])) <= NEGLIGIBLE * largest
    unknown = ~zero & ((np.abs(P[np.arange(len(order)), order] - 1.0) > RECOGNISED) | (not same_states))
    apart_here, apart_there = (~equal(roots, largest) for roots in (one.roots, two.roots[order]))
    return Match(
        order,
        not np.any(unknown) or (same_states and in_groups(one.roots, two.roots[order], P[:, order], unknown)),
        bool(np.any(apart_here & ~apart_there)),
    )


def equal(roots: Complex, largest: float) -> NDArray[np.bool_]:
    """Which roots are equal to which but for rounding, (n, n); all zeros are."""
    sizes = np.maximum(np.abs(roots), np.abs(roots)[:, np.newaxis])
    distance = np.abs(roots - roots[:, np.newaxis])
    return np.asarray((distance <= EQUAL * sizes) | (sizes <= NEGLIGIBLE * largest))


def pairs(roots: Complex) -> NDArray[np.bool_]:
    """Which roots are conjugate to which, (n, n)."""
    return np.asarray((roots == roots.conj()[:, np.newaxis]) & (roots.imag != 0.0))


def keep_upper(here: Complex, there: Complex, order: Indices) -> Indices:
    """The order in which a pair's upper root and the larger of two real roots continue one another."""
    order = order.copy()
    for i, k in np.argwhere(pairs(here)):
        ends = there[order[[i, k]]]
        if here[i].imag > 0.0 and not np.any(ends.imag) and ends[0].real < ends[1].real:
            order[[i, k]] = order[[k, i]]
    for i, k in np.argwhere(pairs(there[order])):
        starts = here[[i, k]]
        if there[order[i]].imag < 0.0 and not np.any(starts.imag) and starts[0].real > starts[1].real:
            order[[i, k]] = order[[k, i]]
    return order


def in_groups(here: Complex, there: Complex, P: Array | Complex, unknown: NDArray[np.bool_]) -> bool:
    """Whether the unknown roots are recognised as groups: equal ones, and pairs that become real or were.

    The projector of a group is smooth also where those of its members are not; the trace of its product with that of
    the continued group is the number of members.
    """
    from scipy.sparse.csgraph import connected_components  # noqa: PLC0415  slow to import

    rows = np.flatnonzero(unknown)
    here, there, P = here[rows], there[rows], P[np.ix_(rows, rows)]
    largest = float(np.max(np.abs([here, there])))
    real = [np.logical_and.outer(roots.imag == 0.0, roots.imag == 0.0) for roots in (here, there)]
    linked = equal(here, largest) | equal(there, largest) | (pairs(here) & real[1]) | (pairs(there) & real[0])
    count, labels = connected_components(linked, directed=False)
    groups = [np.flatnonzero(labels == k) for k in range(count)]
    return all(abs(np.sum(P[np.ix_(group, group)]) - len(group)) <= RECOGNISED for group in groups)
