"""Vibration by the heights of a random road: spectral densities of outputs, and their integrals."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from eom.analysis.grid import frequency_grid
from eom.analysis.road import REFERENCE, track_coherence
from eom.analysis.roots import moving_roots
from eom.analysis.signals import Indices
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.linear import LinearModel
from eom.vehicle.elements import GROUND, Input

PRECISION = 1e-8
SUBDIVISIONS = 20_000
PER_WAVE, WAVE_POINTS = 16, 4000


class Contact(NamedTuple):
    """A road input: its column among the model's inputs, and its place [m]: x forward, y to the left."""

    column: int
    x: float
    y: float


def road_contacts(inputs: Sequence[Input]) -> list[Contact]:
    """Those of a system's inputs that are heights of the road."""
    return [
        Contact(k, item.connection.places[0][0], item.connection.places[0][1])
        for k, item in enumerate(inputs)
        if is_road(item)
    ]


def is_road(item: Input) -> bool:
    """Whether an input is a height of the road under a body."""
    joint = item.connection
    vertical = joint.forces == 1 and not joint.line and np.allclose(joint.force_axis, (0.0, 0.0, 1.0))
    return bool(item.unit == "m" and vertical and joint.bodies[1] == GROUND)


def road_grid(model: LinearModel, contacts: list[Contact], speed: float, band: tuple[float, float]) -> Array:
    """The model's grid [Hz], close enough besides to show the waves between the first and the last input.

    These repeat every speed/wheelbase; at most 4000 points are spent on them, from the lowest frequency on.
    """
    grid = frequency_grid(model, *band)
    length = max(item.x for item in contacts) - min(item.x for item in contacts)
    if length == 0.0:
        return grid
    waves = band[0] + speed / (PER_WAVE * length) * np.arange(WAVE_POINTS)
    return np.union1d(grid, waves[waves < band[1]])


def output_psd(
    model: LinearModel, rows: Indices, contacts: list[Contact], road: tuple[float, float], f: Array
) -> Array:
    """One-sided PSDs of outputs at frequencies [Hz], shape (n, outputs); *road* is roughness [m^3] and speed [m/s].

    By frequency f = speed n the road's PSD is G_d(n)/speed; an input at x sees it with the phase 2 pi f x/speed.
    """
    roughness, speed = road
    H = model.frequency_response(f)[:, rows][:, :, [item.column for item in contacts]]
    x, y = (np.array([getattr(item, axis) for item in contacts]) for axis in "xy")
    n = f[:, np.newaxis, np.newaxis] / speed
    apart = np.abs(np.subtract.outer(y, y))
    together = np.stack([[track_coherence(n[:, 0, 0], float(value)) for value in row] for row in apart])
    cross = np.moveaxis(together, 2, 0) * np.exp(2j * np.pi * n * np.subtract.outer(x, x))
    height = roughness * REFERENCE**2 * speed / f**2
    return np.asarray(np.einsum("fki,fij,fkj->fk", H, cross, H.conj()).real * height[:, np.newaxis])


def integral(model: LinearModel, densities: Callable[[Array], Array], first: float, last: float) -> Array:
    """Integrals of the densities over a band, each to a relative error of 1e-8, by adaptive quadrature over log f.

    Raises `AnalysisError` where that is not reached.
    """
    from scipy.integrate import quad_vec  # noqa: PLC0415  slow to import

    grid = frequency_grid(model, first, last)
    coarse = np.trapezoid(densities(grid), grid, axis=0)
    scale = np.where(coarse > 0.0, coarse, 1.0)

    def weighted(log_f: float) -> Array:
        f = np.exp(log_f)
        return np.asarray(densities(np.array([f]))[0] * f / scale)

    own = np.abs(moving_roots(model)) / (2.0 * np.pi)
    breaks = np.log(np.unique(own[(own > first) & (own < last)]))
    total, error, info = quad_vec(
        weighted,
        np.log(first),
        np.log(last),
        epsabs=PRECISION,
        epsrel=PRECISION,
        norm="max",
        limit=SUBDIVISIONS,
        points=breaks,
        full_output=True,
    )
    if not info.success:
        message = f"{model.name}: RMS values over {first:g} to {last:g} Hz reached only a relative error of {error:.1e}"
        raise AnalysisError(message)
    return np.asarray(np.maximum(total, 0.0) * scale)
