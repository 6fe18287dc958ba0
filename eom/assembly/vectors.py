"""Vectors in space: cross products, unit vectors and the directions that an axis stands for."""

import math

import numpy as np
from numpy.typing import NDArray

from eom.vehicle.elements import Vector

Array = NDArray[np.float64]
NO_DIRECTION, EVERY_DIRECTION = np.zeros((0, 3)), np.eye(3)


def array(values: object) -> Array:
    """Numbers as an array; what stands for a number in symbolic assembly is kept as it is."""
    result = np.asarray(values)
    return result if result.dtype == object else result.astype(float, copy=False)


def zeros(shape: int | tuple[int, ...], *filled: Array) -> Array:
    """Zeros that will be filled with entries of other arrays, of a type that holds them."""
    return np.zeros(shape, dtype=np.result_type(float, *filled))


def skew(a: Vector | Array) -> Array:
    """Matrix S(a), shape (3, 3), with S(a) b = a x b."""
    x, y, z = a
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def unit(a: Vector | Array) -> Array:
    """The vector *a* divided by its length; ``ValueError`` for a zero vector of floats."""
    vector = array(a)
    if vector.dtype == object:
        # one entry alone is its own length, of which roots of symbols would not know the sign
        alone = sum(not isinstance(entry, float) or entry != 0.0 for entry in vector) == 1
        return np.sign(vector).astype(float) if alone else np.asarray(vector / np.sqrt(vector @ vector))
    # squares of small numbers may vanish, hypot knows how to take them
    length = math.hypot(*vector)
    if length == 0.0:
        message = "an axis has no direction: its length is zero"
        raise ValueError(message)
    return np.asarray(vector / length)


def directions(count: int, axis: Vector | Array) -> Array:
    """Unit directions, shape (count, 3), that *count* components about *axis* stand for.

    One direction is the axis itself, two span the plane normal to it, three span space, none is none.
    """
    if count == 0:
        return NO_DIRECTION
    if count == 3:
        return EVERY_DIRECTION
    a = unit(axis)
    if count == 1:
        return a[np.newaxis]
    helper = EVERY_DIRECTION[int(np.argmin(np.abs(a)))]
    first = unit(helper - a * (a @ helper))
    return np.array([first, skew(a) @ first])
