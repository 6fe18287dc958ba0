"""Ziegler's column: published flutter load, and its derivation.

With absolute angles f1, f2 of the rods, in units of m l^2 and k, and p = P l / k

    [ 3 1 ] f'' + [ 2 - p  p - 1 ] f = 0      2 s^2 + (7 - 2 p) s + 1 = 0 ,   s = root^2
    [ 1 1 ]       [  -1      1   ]

The two s meet, and leave the negative axis, at p = 7/2 - sqrt(2) = 2.0858.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

import eom
from tests.vehicles.shipped import vehicle


def traces(P: float, **changes: float) -> tuple[float, float]:
    """Sum and squared difference of the two squares of roots, each of which A^2 has twice: smooth functions of P."""
    A = eom.linearise(vehicle("ziegler_column", P=P, **changes)).A
    square = A @ A
    total = float(np.trace(square)) / 2.0
    return total, float(np.trace(square @ square)) - total**2


@pytest.mark.parametrize(("length", "k", "m"), [(1.0, 100.0, 1.0), (0.4, 7.0, 3.0)])
def test_the_column_flutters_at_the_published_load(length: float, k: float, m: float) -> None:
    """To 1e-8: (s1 - s2)^2 passes zero with a slope of 2 sqrt(2) per unit of p, so that rounding moves p by 1e-14."""
    unit = k / length
    critical = brentq(lambda p: traces(p * unit, l=length, k=k, m=m)[1], 1.0, 3.0, xtol=1e-13)
    assert critical == pytest.approx(3.5 - np.sqrt(2.0), abs=1e-8)
    assert critical == pytest.approx(2.086, abs=5e-4)


@pytest.mark.parametrize("p", [0.0, 1.0, 2.0, 2.5, 5.5])
def test_sum_and_product_of_the_squared_roots_are_those_of_the_derivation(p: float) -> None:
    total, difference = traces(p * 100.0)
    # in units of k / (m l^2) = 100 1/s^2; the product is 1/2 at any load, so that the column never just gives way
    assert total / 100.0 == pytest.approx(-(7.0 - 2.0 * p) / 2.0, rel=1e-12, abs=1e-12)
    product = (total**2 - difference) / 4.0 / 100.0**2
    assert product == pytest.approx(0.5, rel=1e-11)


def test_a_dead_load_makes_the_column_buckle_instead() -> None:
    """Of the same size but upright in space: it gives way at the Euler load of two springs, p = (3 - sqrt(5)) / 2."""
    from tests.vehicles.shipped import text

    file = text("ziegler_column").replace("frame: upper}", "frame: ground}")

    def stiffness(P: float) -> float:
        return float(np.linalg.det(eom.linearise(eom.loads(file, P=P)).A))

    assert brentq(stiffness, 1.0, 100.0, xtol=1e-12) == pytest.approx(100.0 * (3.0 - np.sqrt(5.0)) / 2.0, rel=1e-10)
