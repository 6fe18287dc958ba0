"""Elementary functions of real numbers without a branch, so that a compiler turns loops over them into vector code.

They replace those of `eom.tyre.elementary` by name. Errors are a few units in the last place of the result; `sin`,
`cos` and `tan` hold for |x| < 1e5, beyond which the reduction by multiples of pi loses digits one by one.

References
----------
Reductions are those of S. L. Moshier, Methods and Programs for Mathematical Functions, 1989. Coefficients: Taylor
series of sine and exponential, Chebyshev interpolation of the arctangent on its reduced range to 5e-18, series of the
inverse hyperbolic tangent for the logarithm.
"""

import math

import numpy as np

HALF_PI, QUARTER_PI, TAN_EIGHTH, COT_EIGHTH = math.pi / 2.0, math.pi / 4.0, math.sqrt(2.0) - 1.0, math.sqrt(2.0) + 1.0
# pi and ln 2 in parts whose products with whole numbers are exact
PI_1, PI_2, PI_3 = 3.140625, 9.67502593994140625e-4, 1.509957990978376432e-7
LN2_1, LN2_2 = 0.693145751953125, 1.42860682030941723212e-6
MANTISSA, ONE = 0x000FFFFFFFFFFFFF, 0x3FF0000000000000


def sense(x: float) -> float:
    """One with the sign of x."""
    return math.copysign(1.0, x)


def magnitude(x: float) -> float:
    """The absolute value."""
    return abs(x)


def maximum(a: float, b: float) -> float:
    """The larger of two numbers; NaN if the first one is."""
    return max(a, b)


def minimum(a: float, b: float) -> float:
    """The smaller of two numbers; NaN if the first one is."""
    return min(a, b)


def sqrt(x: float) -> float:
    """The square root."""
    return math.sqrt(x)


def arctan(x: float) -> float:
    """The arctangent: |x| is brought below tan(pi/8) by turning it back by pi/4 or pi/2."""
    a = abs(x)
    far, near = a > COT_EIGHTH, a > TAN_EIGHTH
    above = -1.0 if far else (a - 1.0 if near else a)
    below = a if far else (a + 1.0 if near else 1.0)
    turned = HALF_PI if far else (QUARTER_PI if near else 0.0)
    r = above / below
    z = r * r
    p = -0.019176887119062259
    p = p * z + 0.0392316582955871913
    p = p * z - 0.0508544973794025986
    p = p * z + 0.0585814891280220988
    p = p * z - 0.06664511447381948
    p = p * z + 0.0769218319082608656
    p = p * z - 0.0909090457812390189
    p = p * z + 0.111111110152563617
    p = p * z - 0.142857142846665429
    p = p * z + 0.199999999999955207
    p = p * z - 0.333333333333333302
    return math.copysign(turned + (r + r * z * p), x)


def sin(x: float) -> float:
    """The sine."""
    k = np.floor(x * (1.0 / math.pi) + 0.5)
    return (1.0 - 2.0 * odd(k)) * sine_of_rest(x, k)


def cos(x: float) -> float:
    """The cosine: the sine of what is left above an odd multiple of pi/2."""
    k = np.floor(x * (1.0 / math.pi))
    return (2.0 * odd(k) - 1.0) * sine_of_rest(x, k + 0.5)


def odd(k: float) -> float:
    """One for an odd whole number, zero for an even one."""
    return float(k - 2.0 * np.floor(0.5 * k))


def sine_of_rest(x: float, k: float) -> float:
    """The sine of x - k pi, which is between -pi/2 and pi/2."""
    r = ((x - k * PI_1) - k * PI_2) - k * PI_3
    z = r * r
    p = -8.2206352466243297170e-18
    p = p * z + 2.8114572543455207632e-15
    p = p * z - 7.6471637318198164759e-13
    p = p * z + 1.6059043836821614599e-10
    p = p * z - 2.5052108385441718775e-8
    p = p * z + 2.7557319223985890653e-6
    p = p * z - 1.9841269841269841270e-4
    p = p * z + 8.3333333333333333333e-3
    p = p * z - 1.6666666666666666667e-1
    return r + r * z * p


def tan(x: float) -> float:
    """The tangent."""
    return sin(x) / cos(x)


def exp(x: float) -> float:
    """The exponential: powers of two by their exponent, the rest by a series; constant beyond |x| = 700."""
    x = minimum(maximum(x, -700.0), 700.0)
    k = np.floor(x * (1.0 / math.log(2.0)) + 0.5)
    r = (x - k * LN2_1) - k * LN2_2
    p = 1.0 / 6227020800.0
    p = p * r + 1.0 / 479001600.0
    p = p * r + 1.0 / 39916800.0
    p = p * r + 1.0 / 3628800.0
    p = p * r + 1.0 / 362880.0
    p = p * r + 1.0 / 40320.0
    p = p * r + 1.0 / 5040.0
    p = p * r + 1.0 / 720.0
    p = p * r + 1.0 / 120.0
    p = p * r + 1.0 / 24.0
    p = p * r + 1.0 / 6.0
    p = p * r + 0.5
    scale = np.int64((np.int64(k) + 1023) << 52).view(np.float64)
    return float((1.0 + (r + r * r * p)) * scale)


def log(x: float) -> float:
    """The natural logarithm of x > 0."""
    bits = np.float64(x).view(np.int64)
    m = np.int64((bits & MANTISSA) | ONE).view(np.float64)
    e = float((bits >> 52) - 1023)
    upper = m > math.sqrt(2.0)
    m = 0.5 * m if upper else m
    e = e + 1.0 if upper else e
    s = (m - 1.0) / (m + 1.0)
    z = s * s
    p = 1.0 / 21.0
    p = p * z + 1.0 / 19.0
    p = p * z + 1.0 / 17.0
    p = p * z + 1.0 / 15.0
    p = p * z + 1.0 / 13.0
    p = p * z + 1.0 / 11.0
    p = p * z + 1.0 / 9.0
    p = p * z + 1.0 / 7.0
    p = p * z + 1.0 / 5.0
    p = p * z + 1.0 / 3.0
    return e * LN2_1 + (2.0 * (s + s * z * p) + e * LN2_2)
