"""Whether the roots decay that are not the exact zeros of cyclic coordinates."""

import numpy as np

from eom.analysis.stability import sides_of
from eom.model.eigen import Complex
from eom.model.linear import LinearModel


def moving_roots(model: LinearModel) -> Complex:
    """Roots without the exact zeros of cyclic coordinates [1/s]."""
    kept = np.setdiff1d(np.arange(len(model.A)), model.cyclic)
    return np.linalg.eigvals(model.A[np.ix_(kept, kept)]).astype(complex)


def is_stable(model: LinearModel) -> bool:
    """Whether every motion decays, but for drift along cyclic coordinates.

    Where it does not, a steady gain or a frequency response is formal: no motion settles to it.
    """
    return bool(np.all(sides_of(moving_roots(model)) < 0))
