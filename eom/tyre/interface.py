"""What every tyre model takes and gives."""

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

import numpy as np

from eom.errors import TyreError
from eom.tyre.parameters import Values

REFERENCE_SPEED = 16.7
"""Forward speed [m/s] where none is given: 60 km/h, the usual speed of tyre measurements."""


ARGUMENTS = ("alpha", "kappa", "Fz", "gamma", "speed")


class Forces(NamedTuple):
    """Forces [N] and moments [N m] of the road on a wheel at the contact point, in the wheel's ISO axes.

    x points along the wheel plane, y to the left, z up. A positive slip angle gives a negative ``Fy``, positive
    longitudinal slip a positive ``Fx``; ``My`` brakes a rolling wheel, ``Mz`` turns its front end to the left.
    """

    Fx: Values
    Fy: Values
    Mx: Values
    My: Values
    Mz: Values


Formula = Callable[[Any, Any, Any, Any, Any, Any], tuple[Any, ...]]
"""Coefficients, alpha, kappa, Fz, gamma, speed to Fx, Fy, Mx, My, Mz."""


class Tyre(Protocol):
    """A tyre model with its coefficients.

    Attributes
    ----------
    formula : Formula
        The equations, of the coefficients and plain arguments: what `forces` evaluates and `eom.tyre.Kernel` compiles.
    """

    @property
    def formula(self) -> Formula:
        """The equations."""

    def forces(
        self, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
    ) -> Forces:
        """Forces and moments in steady rolling; all arguments are broadcast.

        Parameters
        ----------
        alpha : float or array
            Slip angle [rad]: tan(alpha) = v_y / |v_x| of the contact point, positive when it drifts to the left.
        kappa : float or array
            Longitudinal slip (omega R_e - v_x) / |v_x|: positive drives, -1 is a locked wheel that rolls forward.
        Fz : float or array
            Normal load [N]; a wheel that does not press on the road, Fz <= 0, has no forces.
        gamma : float or array
            Camber (inclination) angle [rad], a turn about x: positive leans the top to the right.
        speed : float or array
            Forward speed v_x [m/s], negative in reverse.

        Returns
        -------
        Forces
            Of the shape of the arguments together.

        Raises
        ------
        TyreError
            For arguments that are no finite numbers, or whose shapes do not fit together.
        """
        return forces_of(self, alpha, kappa, Fz, gamma, speed)


def forces_of(tyre: Tyre, *arguments: Values) -> Forces:
    """A tyre's formula at alpha, kappa, Fz, gamma, speed; raises `TyreError` for what is no finite number."""
    arrays = [as_array(name, value) for name, value in zip(ARGUMENTS, arguments, strict=True)]
    try:
        alpha, kappa, Fz, gamma, speed = arrays
        # one look at the sum is quicker than one at each; an infinite one of finite numbers passes the second look
        if not np.isfinite(alpha + kappa + Fz + gamma + speed).all():
            for name, array in zip(ARGUMENTS, arrays, strict=True):
                check_finite(name, array)
        found = [np.asarray(value) for value in tyre.formula(tyre, *arrays)]
        shape = np.broadcast(*arrays, *found).shape
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(ARGUMENTS, arrays, strict=True))
        raise TyreError(f"shapes that do not fit together, or not the number of tyres: {shapes}") from None
    return Forces(*(value[()] if value.shape == shape else np.broadcast_to(value, shape) for value in found))


def as_numbers(name: str, value: Values) -> "np.ndarray[Any, Any]":
    """An argument as an array of finite numbers, which may be complex."""
    array = as_array(name, value)
    check_finite(name, array)
    return array


def as_array(name: str, value: Values) -> "np.ndarray[Any, Any]":
    """An argument as an array of numbers in double precision, which may be complex."""
    array = np.asarray(value)
    if array.dtype.char not in "dD":
        try:
            return array.astype(np.complex128 if array.dtype.kind == "c" else np.float64)
        except (TypeError, ValueError):
            raise TyreError(f"{name}: expected a number or an array of numbers") from None
    return array


def check_finite(name: str, array: "np.ndarray[Any, Any]") -> None:
    """Raise `TyreError` for an argument that is not finite."""
    if not np.isfinite(array).all():
        raise TyreError(f"{name}: expected finite numbers")
