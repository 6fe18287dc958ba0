"""Finite rotations as unit quaternions (w, x, y, z): no singular posture, and continuous through whole turns."""

import numpy as np

from eom.assembly.vectors import Array, skew

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])


def product(p: Array, q: Array) -> Array:
    """Quaternion of the rotation q followed by p."""
    vector = p[0] * q[1:] + q[0] * p[1:] + skew(p[1:]) @ q[1:]
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *vector])


def conjugate(q: Array) -> Array:
    """Quaternion of the reverse rotation."""
    return np.array([q[0], *(-q[1:])])


def exponential(turn: Array) -> Array:
    """Quaternion of a rotation vector [rad], shape (3,)."""
    half = 0.5 * float(np.linalg.norm(turn))
    # np.sinc(x) is sin(pi x)/(pi x), regular at zero
    return np.array([np.cos(half), *(0.5 * np.sinc(half / np.pi) * turn)])


def matrix(q: Array) -> Array:
    """Rotation matrix, shape (3, 3), of a unit quaternion."""
    w, x, y, z = q
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )
