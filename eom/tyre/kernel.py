"""Tyre formulas as machine code: several tyres at once, a lane of a vector register each."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.errors import TyreError
from eom.program.compiled import installed
from eom.program.make import Ready, ready
from eom.tyre.interface import ARGUMENTS, REFERENCE_SPEED, Forces, Tyre, as_numbers
from eom.tyre.parameters import Values


@dataclass(frozen=True)
class Kernel:
    """The compiled formula of n tyres.

    Attributes
    ----------
    ready : Ready
        The program: alpha, kappa, Fz, gamma, speed of all tyres one after the other are its states, Fx, Fy, Mx, My,
        Mz its results.
    count : int
        Number of tyres.
    """

    ready: Ready
    count: int

    def forces(
        self, alpha: Values, kappa: Values, Fz: Values, gamma: Values = 0.0, speed: Values = REFERENCE_SPEED
    ) -> Forces:
        """Forces and moments as of `Tyre.forces`; each argument is a number or has one element for each tyre."""
        arguments = np.empty((len(ARGUMENTS), self.count))
        for row, name, value in zip(arguments, ARGUMENTS, (alpha, kappa, Fz, gamma, speed), strict=True):
            numbers = as_numbers(name, value)
            if numbers.dtype.kind == "c" or numbers.shape not in {(), (1,), (self.count,)}:
                raise TyreError(f"{name}: expected a real number or {self.count} of them, one for each tyre")
            row[:] = numbers
        return Forces(*self.ready.results(arguments.ravel(), np.empty(0), 0).reshape(len(ARGUMENTS), self.count))


def compile_forces(tyre: Tyre) -> Kernel:
    """Compile a tyre's formula; several tyres are first made one by `stack`.

    The formula is the very one that NumPy evaluates. The first call for each formula takes a second or
    less, later ones find it in the cache.

    Raises
    ------
    TyreError
        If numba is not installed.
    """
    if not installed():
        raise TyreError("compiled tyres need numba: install eom-vehicle[fast]")
    numbers = (value for value in vars(tyre).values() if isinstance(value, np.ndarray))
    count = max((value.size for value in numbers), default=1)
    made = ready(formula_of_all, (tyre,), len(ARGUMENTS) * count, 0)
    _ = made.program.address
    return Kernel(made, count)


def formula_of_all(x: Any, _: Any, numbers: Any) -> tuple[Any]:
    """The formula of a stack of tyres, rows of arguments and of results one after the other."""
    (tyre,) = numbers
    arguments = list(x.reshape(len(ARGUMENTS), -1))
    return (np.ravel(x.over_lanes(tyre.formula, tyre, arguments)),)
