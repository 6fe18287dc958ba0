"""Mass, gyroscopic and centripetal terms, and the kinematic matrix V of the moving trim."""

from collections.abc import Sequence

import numpy as np

from eom.assembly.rows import six
from eom.assembly.vectors import Array, skew
from eom.vehicle.elements import Body


def mass_matrix(bodies: Sequence[Body]) -> Array:
    """Mass and inertia of all bodies, shape (6 n, 6 n) [kg, kg m^2]."""
    M = np.zeros((6 * len(bodies), 6 * len(bodies)))
    for i, body in enumerate(bodies):
        block = M[six(i), six(i)]
        block[:3, :3] = body.mass * np.eye(3)
        block[3:, 3:] = np.array(body.inertia, dtype=float)
    return M


def momentum_matrix(bodies: Sequence[Body]) -> Array:
    """Centripetal and gyroscopic terms, shape (6 n, 6 n), that multiply body-axis velocities.

    m w x v0 for the translations and w x h0 for the rotations, h0 the spin's angular momentum.
    """
    P = np.zeros((6 * len(bodies), 6 * len(bodies)))
    for i, body in enumerate(bodies):
        block = P[six(i), six(i)]
        block[:3, 3:] = -body.mass * skew(body.velocity)
        block[3:, 3:] = -skew(np.array(body.inertia, dtype=float) @ np.array(body.spin, dtype=float))
    return P


def kinematic_matrix(bodies: Sequence[Body]) -> Array:
    """V, shape (6 n, 6 n), of dp/dt + V p - w = 0: body axes that turn carry the trim velocity along."""
    V = np.zeros((6 * len(bodies), 6 * len(bodies)))
    for i, body in enumerate(bodies):
        V[six(i), six(i)][:3, 3:] = skew(body.velocity)
    return V


def trim_velocity(bodies: Sequence[Body]) -> Array:
    """Velocities and spins of the steady motion, shape (6 n,) [m/s, rad/s]."""
    return np.array([component for body in bodies for component in (*body.velocity, *body.spin)], dtype=float)
