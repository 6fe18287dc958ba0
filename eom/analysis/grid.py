"""Frequencies and times at which a model's responses are worth computing."""

import numpy as np

from eom.analysis.roots import moving_roots
from eom.analysis.stability import sides_of
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.linear import LinearModel

PER_DECADE = 60
# around a root, in half-widths of its resonance
NEAR = np.array([-3.0, -2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 3.0])
SAMPLES, RATIO = 1001, 8
# where no root says anything
WIDE = (1e-2, 1e2)
LONG = 1.0


def check_range(first: float, last: float) -> None:
    """Raise `AnalysisError` for ends that are no range of frequencies."""
    if not (np.isfinite([first, last]).all() and 0.0 < first < last):
        message = f"frequencies from {first:g} Hz to {last:g} Hz: expected 0 < from < to"
        raise AnalysisError(message)


def frequency_grid(model: LinearModel, first: float | None = None, last: float | None = None) -> Array:
    """Frequencies [Hz], evenly spaced on a logarithmic scale, closer at each resonance, both ends included.

    An end that is not given is a power of ten, beyond all roots by a factor of five or more.
    """
    roots = moving_roots(model)
    sizes = np.abs(roots[roots != 0.0]) / (2.0 * np.pi)
    low, high = (sizes.min() / 5.0, sizes.max() * 5.0) if sizes.size else WIDE
    first = 10.0 ** np.floor(np.log10(low)) if first is None else first
    last = 10.0 ** np.ceil(np.log10(high)) if last is None else last
    check_range(first, last)
    count = int(np.ceil(PER_DECADE * np.log10(last / first))) + 1
    even = np.geomspace(first, last, max(count, 2))
    swinging = roots[(roots.imag > 0.0) & (sides_of(roots) != 0)]
    near = (swinging.imag[:, np.newaxis] + NEAR * np.abs(swinging.real)[:, np.newaxis]).ravel() / (2.0 * np.pi)
    return np.unique(np.concatenate([even, near[(near > first) & (near < last)]]))


def undamped_frequencies(model: LinearModel) -> Array:
    """Frequencies [Hz] of the roots that oscillate without damping, where a frequency response is infinite."""
    roots = moving_roots(model)
    undamped = roots[(roots.imag > 0.0) & (sides_of(roots) == 0)]
    return np.asarray(np.sort(undamped.imag) / (2.0 * np.pi))


def nested_times(model: LinearModel, until: float) -> Array:
    """Times [s] from zero to *until*, ever closer towards zero: steps grow with the time since the motion began.

    Even grids, each an eighth as long as the next one, the shortest as short as the fastest root's time.
    """
    fastest = np.max(np.abs(moving_roots(model)), initial=0.0)
    levels = max(0, int(np.ceil(np.log(max(fastest * until, 1.0)) / np.log(RATIO))))
    even = np.arange(SAMPLES) / (SAMPLES - 1)
    pieces = [even * (until / RATIO**levels)]
    # what the shorter grid covers is left out of each longer one
    pieces += [even[even > 1.0 / RATIO] * (until / RATIO**k) for k in range(levels - 1, -1, -1)]
    return np.concatenate(pieces)


def time_grid(model: LinearModel) -> Array:
    """Times [s] from zero, evenly spaced, until the slowest motion has decayed or an unstable one has grown.

    Seven time constants of the slowest root that decays, at least; but not beyond a growth of a hundredfold. Undamped
    roots show ten periods.
    """
    roots = moving_roots(model)
    side = sides_of(roots)
    decays, grows, swings = roots[side < 0], roots.real[side > 0], np.abs(roots.imag[side == 0])
    ends = [7.0 / -decays.real.max()] if decays.size else []
    ends += [10.0 * 2.0 * np.pi / swings[swings > 0.0].min()] if np.any(swings > 0.0) else []
    longest = max(ends, default=LONG)
    if grows.size:
        longest = min(longest, np.log(100.0) / grows.max()) if ends else np.log(100.0) / grows.max()
    return np.linspace(0.0, longest, SAMPLES)
