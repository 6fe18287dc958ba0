"""About which points, and which axes, bodies turn in a mode."""

from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.model.eigen import Complex

# [rad] beside a largest motion of one: a smaller rotation is rounding
TURNS = 1e-9


class InstantCentres(NamedTuple):
    """Instant centres of bodies in modes, in the axes of the drawing; NaN for a body that does not turn.

    A body whose centre of mass c moves by x and which turns by t moves the point p by x + t cross (p - c). The instant
    centre is the point where this is smallest, and of these the one nearest to c:
    p - c = conj(t) cross x / abs(t)^2. A planar motion leaves it at rest; a screw moves it along its axis.

    In a mode in which parts move out of phase no point need rest. The complex point is then read so: its real part is
    the instant centre averaged over a cycle, weighted with the square of the rotation; about a fixed axis that is the
    centre at the moment of the largest rotation, and a phase f later it lies at Re - Im tan(f), on a straight line.

    Attributes
    ----------
    points : Complex
        Shape (bodies, 3, modes) [m].
    axes : Complex
        Directions of the rotations, unit vectors, shape (bodies, 3, modes), with as large a real part as possible; the
        imaginary part is zero where the axis does not turn, half an ellipse away where it does.
    """

    points: Complex
    axes: Complex


def instant_centres(shapes: Complex, centres: Array) -> InstantCentres:
    """Instant centres of shapes (bodies, 6, modes) of bodies with the centres (bodies, 3)."""
    moved, turned = shapes[:, :3], shapes[:, 3:]
    size = np.linalg.norm(turned, axis=1, keepdims=True)
    size = np.where(size > TURNS, size, np.nan)
    arms = np.cross(turned.conj(), moved, axis=1) * size**-2
    # turned to the phase of its largest real part, with a sign that makes the largest component positive
    axes = turned * size**-1 * np.exp(-0.5j * np.angle(np.sum(turned**2, axis=1, keepdims=True)))
    rounded = np.round(np.abs(axes.real), 9)
    lead = np.argmax(np.where(np.isnan(rounded), 0.0, rounded), axis=1)[:, np.newaxis]
    sign = np.sign(np.take_along_axis(axes.real, lead, axis=1))
    return InstantCentres(centres[:, :, np.newaxis] + arms, axes * sign)
