"""Random roads of ISO 8608: their classes, and how left and right tracks go together."""

import numpy as np
from numpy.typing import ArrayLike

from eom.assembly.vectors import Array

REFERENCE = 0.1
"""Spatial frequency n0 of the classes [1/m]."""
SPATIAL = (0.01, 10.0)
"""Range of spatial frequency over which the classes are commonly drawn [1/m]."""
CLASSES = {name: 16e-6 * 4.0**k for k, name in enumerate("ABCDEFGH")}
"""Geometric mean of the displacement PSD at n0 by class [m^3]."""


def displacement_psd(roughness: float, n: ArrayLike) -> Array:
    """One-sided PSD of a track's height over spatial frequency *n* [1/m]: G_d(n0) (n/n0)^-2 [m^3].

    *roughness* is G_d(n0) [m^3]. Source: ISO 8608, classification by displacement.
    """
    return np.asarray(roughness * (np.asarray(n, dtype=float) / REFERENCE) ** -2)


def track_coherence(n: ArrayLike, distance: float) -> Array:
    """Cross PSD of two parallel tracks over their own PSD, a real number from 0 to 1: z K_1(z), z = 2 pi n *distance*.

    On an isotropic road with the PSD n^-2 of a track, a wave of the vector (n, m) has the density (n^2 + m^2)^(-3/2)/2;
    the waves' sum over m, each with the phase 2 pi m times the distance [m] between the tracks, is Basset's integral of
    the modified Bessel function K_1.

    Source: C. J. Dodds and J. D. Robson, The description of road surface roughness, J. Sound and Vibration 31 (1973).
    """
    from scipy.special import kv  # noqa: PLC0415  slow to import

    z = np.abs(2.0 * np.pi * np.asarray(n, dtype=float) * distance)
    small = z < 1e-8
    # z K_1(z) = 1 + O(z^2 log z)
    return np.asarray(np.where(small, 1.0, z * kv(1, np.where(small, 1.0, z))))
