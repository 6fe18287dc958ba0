"""Modes of a linear model: eigenvalues and what an engineer reads from them."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.model.eigen import Complex, Eigen
from eom.model.instant_centres import InstantCentres, instant_centres

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# of a root's size: a smaller imaginary part is rounding
REAL = 1e-9
# of a mode's largest state: a smaller motion of bodies is rounding
RESTING = 1e-12


@dataclass(frozen=True)
class Modes:
    """Eigenvalues, the slowest first; those of cyclic coordinates are exactly zero and come first of all.

    Attributes
    ----------
    eigenvalues : Complex
        Shape (modes,) [1/s].
    eigenvectors : Complex
        Motion of the states in each mode, (states, modes), in the states' units, scaled as `shapes`:
        (A - eigenvalue) eigenvector = 0. Where a root is exactly zero, A times its vector may move cyclic states: a
        heading that stays leads ever further sideways.
    participation : Array
        Share of each state in each mode, shape (states, modes), columns sum to one: the size of right times left
        eigenvector, entry by entry (I. J. Perez-Arriaga, G. C. Verghese and F. C. Schweppe, Selective modal analysis,
        IEEE Trans. PAS-101 (1982) 3117-3125).
    shapes : Complex
        Motion of the bodies in each mode, (bodies, 6, modes): translation of the centre of mass [m] and rotation [rad]
        in inertial axes that travel with the trim. The largest entry of a mode is one with phase zero, where a radian
        counts as much as a metre: a rotation is judged by what it moves at an arm of one metre. Zero in a mode in which
        no body leaves its place in the trim.
    states, bodies : tuple of str
    centres : Array
        Centres of mass of the bodies at the trim, (bodies, 3) [m].
    cyclic : tuple of int
        States whose modes are the exact zeros, in their order.
    speed : float
        Speed of the trim [m/s].
    """

    eigenvalues: Complex
    eigenvectors: Complex
    participation: Array
    shapes: Complex
    states: tuple[str, ...]
    bodies: tuple[str, ...]
    centres: Array
    cyclic: tuple[int, ...]
    speed: float

    @property
    def oscillates(self) -> NDArray[np.bool_]:
        """Whether each root is one of a conjugate pair, shape (modes,)."""
        return np.asarray(np.abs(self.eigenvalues.imag) > REAL * np.maximum(np.abs(self.eigenvalues), 1e-300))

    @property
    def natural_frequency(self) -> Array:
        """abs(eigenvalue)/(2 pi) [Hz], shape (modes,); zero for real roots."""
        return np.where(self.oscillates, np.abs(self.eigenvalues) / (2.0 * np.pi), 0.0)

    @property
    def damping_ratio(self) -> Array:
        """-Re/abs, shape (modes,); NaN for real roots."""
        size = np.where(self.oscillates, np.abs(self.eigenvalues), np.nan)
        return np.asarray(-self.eigenvalues.real / size)

    @property
    def time_constant(self) -> Array:
        """-1/Re [s], shape (modes,); infinite for undamped roots, negative for unstable ones."""
        real = self.eigenvalues.real
        return np.where(real == 0.0, np.inf, -1.0 / np.where(real == 0.0, 1.0, real))

    @property
    def wavelength(self) -> Array:
        """Way that the trim travels in a damped period, speed 2 pi/Im [m], shape (modes,).

        NaN for real roots, and at rest.
        """
        moving = self.oscillates if self.speed > 0.0 else np.zeros(len(self.eigenvalues), dtype=bool)
        return np.asarray(2.0 * np.pi * self.speed / np.where(moving, np.abs(self.eigenvalues.imag), np.nan))

    def dominant(self, mode: int, count: int = 2) -> tuple[str, ...]:
        """The states that take the largest part in a mode."""
        order = np.argsort(-self.participation[:, mode], kind="stable")
        return tuple(self.states[k] for k in order[:count])

    def instant_centres(self) -> InstantCentres:
        """The points about which the bodies turn in each mode, and the axes; see `InstantCentres`."""
        return instant_centres(self.shapes, self.centres)

    def plot(self) -> "Figure":
        """Roots in the complex plane, and the participation of the states."""
        from eom.model.modes_plot import plot_modes  # noqa: PLC0415  draws with what is slow to import

        return plot_modes(self)


def scaled(result: Eigen, motion: Array) -> tuple[Complex, Complex]:
    """Eigenvectors, and shapes of the bodies that *motion* (6 bodies, states) moves, by the largest entry of a shape.

    A mode that moves no body is scaled by its largest state.
    """
    shapes = motion @ result.vectors
    still = np.max(np.abs(shapes), axis=0, initial=0.0) <= RESTING * np.max(np.abs(result.vectors), axis=0, initial=0.0)
    shapes[:, still] = 0.0
    measured = np.concatenate([shapes, np.where(still, result.vectors, 0.0)])
    sizes = np.abs(measured)
    # of entries that differ by rounding alone the first is taken
    largest = np.argmax(sizes >= (1.0 - 1e-9) * np.max(sizes, axis=0, initial=0.0), axis=0)
    unit = measured[largest, np.arange(measured.shape[1])]
    return result.vectors / unit, (shapes / unit).reshape(len(motion) // 6, 6, len(result.values))
