"""What the equations ask for by name, so that a program can be written of them: see `eom.program.arrays`."""

from typing import Any

import numpy as np


def over_lanes(function: Any, coefficients: Any, arguments: list[Any]) -> Any:
    """A function of numbers, applied to arrays of them.

    With *coefficients*, an object whose fields are numbers or arrays too, that is its first argument.
    """
    written = getattr(arguments[0], "over_lanes", None)
    if written is not None:
        return written(function, coefficients, arguments)
    return function(*arguments) if coefficients is None else function(coefficients, *arguments)


def solve_positive(matrix: Any, right: Any) -> Any:
    """Solution of a system whose matrix is symmetric and positive definite."""
    written = getattr(matrix, "solve_positive", None)
    return np.linalg.solve(matrix, right) if written is None else written(right)
