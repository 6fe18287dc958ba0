"""Elementary functions of compiled programs: error against numbers of forty digits."""

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.program.make import Ready, ready

pytest.importorskip("numba")
UFUNCS = (np.arctan, np.sin, np.cos, np.tan, np.exp, np.log)


def every_function(x: Any, _: Any, __: Any) -> tuple[Any]:
    """All of them of one number alone, and of eight at once, which are computed in lanes."""
    return (np.concatenate([np.concatenate((function(x[:1]), function(x[1:]))) for function in UFUNCS]),)


@pytest.fixture(scope="module")
def program() -> Ready:
    return ready(every_function, (), 9, 0)


def value(program: Ready, function: np.ufunc, x: float) -> float:
    """A function of x as compiled, the same alone and in lanes."""
    found = program.results(np.full(9, x), np.empty(0), 0).reshape(len(UFUNCS), -1)[UFUNCS.index(function)]
    assert np.all(found == found[0])
    return float(found[0])


def ulps(found: float, exact: Callable[[Any], Any], x: float) -> float:
    """Error in units of the last place of the result."""
    with mpmath.workdps(40):
        wanted = exact(mpmath.mpf(x))
        return float(abs(mpmath.mpf(found) - wanted)) / math.ulp(float(wanted))


@given(x=st.floats(-1e6, 1e6))
def test_arctangent_is_exact_to_two_units_in_the_last_place(program: Ready, x: float) -> None:
    assert ulps(value(program, np.arctan, x), mpmath.atan, x) <= 2.0


@given(x=st.floats(-1e3, 1e3))
def test_sine_and_cosine_are_exact_to_rounding_of_one(program: Ready, x: float) -> None:
    # near a zero the error of the reduction by multiples of pi is that of x times 1e-19, and of the result 1e-16
    assert abs(value(program, np.sin, x) - math.sin(x)) <= 5e-16
    assert abs(value(program, np.cos, x) - math.cos(x)) <= 5e-16


@given(x=st.floats(-1.5, 1.5))
def test_tangent_is_exact_to_rounding(program: Ready, x: float) -> None:
    assert value(program, np.tan, x) == pytest.approx(math.tan(x), rel=1e-14, abs=1e-300)


@given(x=st.floats(-700.0, 700.0))
def test_exponential_is_exact_to_four_units_in_the_last_place(program: Ready, x: float) -> None:
    assert ulps(value(program, np.exp, x), mpmath.exp, x) <= 4.0


@given(x=st.floats(1e-300, 1e300))
def test_logarithm_is_exact_to_four_units_in_the_last_place(program: Ready, x: float) -> None:
    # next to one the result is of the size of x - 1, which is exact
    assert ulps(value(program, np.log, x), mpmath.log, x) <= 4.0
