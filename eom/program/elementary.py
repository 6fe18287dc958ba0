"""Elementary functions by arithmetic without branches, for machine code that computes several numbers at once.

They take any values with +, -, *, / and the methods of `Arithmetic`. Errors are a few units in the last place of the
result; `sine`, `cosine` and `tangent` hold for |x| < 1e5, beyond which the reduction by multiples of pi loses digits
one by one.

References
----------
Reductions are those of S. L. Moshier, Methods and Programs for Mathematical Functions, 1989. Coefficients: Taylor
series of sine and exponential, Chebyshev interpolation of the arctangent on its reduced range to 5e-18, series of the
inverse hyperbolic tangent for the logarithm.
"""

import functools
import math
from typing import Any, Protocol

HALF_PI, QUARTER_PI, TAN_EIGHTH, COT_EIGHTH = math.pi / 2.0, math.pi / 4.0, math.sqrt(2.0) - 1.0, math.sqrt(2.0) + 1.0
# pi and ln 2 in parts whose products with whole numbers are exact
PI_1, PI_2, PI_3 = 3.140625, 9.67502593994140625e-4, 1.509957990978376432e-7
LN2_1, LN2_2 = 0.693145751953125, 1.42860682030941723212e-6
ARCTAN = (
    -0.019176887119062259,
    0.0392316582955871913,
    -0.0508544973794025986,
    0.0585814891280220988,
    -0.06664511447381948,
    0.0769218319082608656,
    -0.0909090457812390189,
    0.111111110152563617,
    -0.142857142846665429,
    0.199999999999955207,
    -0.333333333333333302,
)
SINE = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(9, 0, -1))
EXPONENTIAL = tuple(1.0 / math.factorial(k) for k in range(13, 1, -1))
LOGARITHM = tuple(1.0 / k for k in range(21, 1, -2))


class Arithmetic(Protocol):
    """What a value can do besides arithmetic; a test is a value of its own kind."""

    def absolute(self) -> Any:
        """|x|."""

    def floored(self) -> Any:
        """The largest whole number that is not larger."""

    def signed_as(self, other: Any) -> Any:
        """Its size with the sign of another one."""

    def less(self, other: Any) -> Any:
        """A test."""

    def pick(self, then: Any, other: Any) -> Any:
        """Of a test: one of two numbers."""

    def power_of_two(self) -> Any:
        """2 to a whole number."""

    def split(self) -> tuple[Any, Any]:
        """M and e with x = m 2^e and 1 <= m < 2, of x > 0."""


def polynomial(coefficients: tuple[float, ...], x: Any) -> Any:
    """The highest power's coefficient comes first."""
    return functools.reduce(lambda sum_, c: sum_ * x + c, coefficients[1:], coefficients[0])


def arctangent(x: Any) -> Any:
    """|x| is brought below tan(pi/8) by turning it back by pi/4 or pi/2."""
    a = x.absolute()
    near, far = (-a).less(-TAN_EIGHTH), (-a).less(-COT_EIGHTH)
    above = far.pick(-1.0, near.pick(a - 1.0, a))
    below = far.pick(a, near.pick(a + 1.0, 1.0))
    turned = far.pick(HALF_PI, near.pick(QUARTER_PI, 0.0))
    r = above / below
    z = r * r
    return (turned + (r + r * z * polynomial(ARCTAN, z))).signed_as(x)


def sine(x: Any) -> Any:
    """By what is left above a whole multiple of pi."""
    k = (x * (1.0 / math.pi) + 0.5).floored()
    return (1.0 - 2.0 * odd(k)) * sine_of_rest(x, k)


def cosine(x: Any) -> Any:
    """By what is left above an odd multiple of pi/2."""
    k = (x * (1.0 / math.pi)).floored()
    return (2.0 * odd(k) - 1.0) * sine_of_rest(x, k + 0.5)


def odd(k: Any) -> Any:
    """One for an odd whole number, zero for an even one."""
    return k - 2.0 * (0.5 * k).floored()


def sine_of_rest(x: Any, k: Any) -> Any:
    """The sine of x - k pi, which is between -pi/2 and pi/2."""
    r = ((x - k * PI_1) - k * PI_2) - k * PI_3
    z = r * r
    return r + r * z * polynomial(SINE, z)


def tangent(x: Any) -> Any:
    """Sine over cosine."""
    return sine(x) / cosine(x)


def exponential(x: Any) -> Any:
    """Powers of two by their exponent, the rest by a series; constant beyond |x| = 700."""
    x = (x.less(700.0)).pick(x, 700.0)
    x = (x.less(-700.0)).pick(-700.0, x)
    k = (x * (1.0 / math.log(2.0)) + 0.5).floored()
    r = (x - k * LN2_1) - k * LN2_2
    return (1.0 + (r + r * r * polynomial(EXPONENTIAL, r))) * k.power_of_two()


def logarithm(x: Any) -> Any:
    """The exponent of two, and a series for the rest."""
    m, e = x.split()
    upper = (-m).less(-math.sqrt(2.0))
    m, e = upper.pick(0.5 * m, m), upper.pick(e + 1.0, e)
    s = (m - 1.0) / (m + 1.0)
    z = s * s
    return e * LN2_1 + (2.0 * (s + s * z * polynomial(LOGARITHM, z)) + e * LN2_2)
