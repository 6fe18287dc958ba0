"""Mass, gyroscopic and centripetal terms, and the kinematic matrix V of the moving trim."""

from collections.abc import Iterator, Sequence

import numpy as np

from eom.assembly.algebra import Entry, square_entry
from eom.assembly.vectors import Array, array, skew, zeros
from eom.vehicle.elements import Body


def mass_entries(bodies: Sequence[Body]) -> Iterator[Entry]:
    """Mass and inertia of all bodies [kg, kg m^2]."""
    for i, body in enumerate(bodies):
        mass, inertia = array(body.mass), array(body.inertia)
        block = zeros((6, 6), mass, inertia)
        block[[0, 1, 2], [0, 1, 2]] = mass
        block[3:, 3:] = inertia
        yield square_entry((i,), block)


def momentum_entries(bodies: Sequence[Body]) -> Iterator[Entry]:
    """Centripetal and gyroscopic terms, that multiply body-axis velocities.

    m w x v0 for the translations and w x h0 for the rotations, h0 the spin's angular momentum.
    """
    for i, body in enumerate(bodies):
        carried = -body.mass * skew(body.velocity)
        gyroscopic = -skew(array(body.inertia) @ array(body.spin))
        block = zeros((6, 6), carried, gyroscopic)
        block[:3, 3:], block[3:, 3:] = carried, gyroscopic
        yield square_entry((i,), block)


def kinematic_entries(bodies: Sequence[Body]) -> Iterator[Entry]:
    """V of dp/dt + V p - w = 0: body axes that turn carry the trim velocity along."""
    for i, body in enumerate(bodies):
        if np.any(body.velocity):
            turning = skew(body.velocity)
            block = zeros((6, 6), turning)
            block[:3, 3:] = turning
            yield square_entry((i,), block)


def trim_velocity(bodies: Sequence[Body]) -> Array:
    """Velocities and spins of the steady motion, shape (6 n,) [m/s, rad/s]."""
    return np.array([component for body in bodies for component in (*body.velocity, *body.spin)], dtype=float)
