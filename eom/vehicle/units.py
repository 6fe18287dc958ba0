"""Units of measure at the edge: text such as ``kN*m*s/rad`` to a factor and a dimension.

The grammar is ours and bounded; pint only looks up single names, in a registry that holds the units below.
"""

import re
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pint

Dimension = tuple[float, float, float]
"""Exponents of kilogram, metre and second; angles have none."""

DIMENSIONLESS: Dimension = (0.0, 0.0, 0.0)
MAX_LENGTH = 60
SPACE = re.compile(r" *([*/^]) *")
FACTOR = re.compile(r"([A-Za-z°]+)(?:\^(-?\d))?", re.ASCII)
DEFINITIONS = """
giga- = 1e9 = G-
mega- = 1e6 = M-
kilo- = 1e3 = k-
centi- = 1e-2 = c-
milli- = 1e-3 = m-
meter = [length] = m = metre
second = [time] = s = sec
gram = [mass] = g
radian = [] = rad
tonne = 1000 * kilogram = t
pound = 0.45359237 * kilogram = lb
slug = 14.593902937206365 * kilogram
foot = 0.3048 * meter = ft
inch = 0.0254 * meter = in
minute = 60 * second = min
hour = 3600 * second = h
kph = 1000 / 3600 * meter / second
mph = 0.44704 * meter / second
degree = 0.017453292519943295 * radian = deg = °
revolution = 6.283185307179586 * radian = rev
rpm = 0.10471975511965977 * radian / second
hertz = 1 / second = Hz
newton = kilogram * meter / second ** 2 = N
pound_force = 4.4482216152605 * newton = lbf
pascal = newton / meter ** 2 = Pa
bar = 1e5 * pascal
joule = newton * meter = J
watt = joule / second = W
"""


@cache
def registry() -> "pint.UnitRegistry[float]":
    """The registry of known units, made on first use."""
    import pint  # noqa: PLC0415  costs 0.2 s, and a file without units does not need it

    known: pint.UnitRegistry[float] = pint.UnitRegistry(None)
    for line in DEFINITIONS.strip().splitlines():
        known.define(line)
    return known


@cache
def look_up(name: str) -> tuple[float, Dimension]:
    """SI factor and dimension of one unit name; ``ValueError`` if it is unknown."""
    if not registry().parse_unit_name(name):
        message = f"unknown unit of measure '{name}'"
        raise ValueError(message)
    factor, base = registry().get_base_units(name)
    exponents = base._units  # noqa: SLF001  the only way to the exponents that evaluates no text
    mass, length, time = (float(str(exponents.get(key, 0))) for key in ("gram", "meter", "second"))
    return float(str(factor)) / 1000.0**mass, (mass, length, time)


@cache
def parse_unit(text: str) -> tuple[float, Dimension]:
    """SI factor and dimension of a product of units with whole exponents.

    >>> parse_unit("km/h")
    (0.2777777777777778, (0.0, 1.0, -1.0))
    """
    if not text:
        return 1.0, DIMENSIONLESS
    compact = SPACE.sub(r"\1", text.replace("**", "^").replace("·", "*").replace("²", "^2"))
    if len(text) > MAX_LENGTH:
        message = "the unit of measure is too long"
        raise ValueError(message)
    factor, exponents, sign = 1.0, [0.0, 0.0, 0.0], 1
    for k, piece in enumerate(re.split(r"([*/])", compact)):
        if k % 2:
            sign = -1 if piece == "/" else 1
            continue
        match = FACTOR.fullmatch(piece)
        if piece == "1" and k == 0:
            continue
        if match is None:
            message = f"'{text}' is not a unit of measure such as 'kN*m/rad' or 'm/s^2'"
            raise ValueError(message)
        power = sign * int(match[2] or 1)
        one, dimension = look_up(match[1])
        factor *= one**power
        exponents = [total + power * own for total, own in zip(exponents, dimension, strict=True)]
    return factor, (exponents[0], exponents[1], exponents[2])


def show_dimension(dimension: Dimension) -> str:
    """A dimension in base units, such as ``kg*m^2/s^2``."""

    def product(sign: float) -> str:
        pairs = [(name, sign * power) for name, power in zip(("kg", "m", "s"), dimension, strict=True)]
        return "*".join(name if power == 1 else f"{name}^{power:g}" for name, power in pairs if power > 0)

    above, below = product(1.0), product(-1.0)
    if not above and not below:
        return "a plain number"
    return f"{above or '1'}/{below}" if below else above


def stated_in(dimension: Dimension) -> str:
    """What a number of some dimension is: ``in kg`` or ``a plain number``."""
    return f"in {show_dimension(dimension)}" if any(dimension) else show_dimension(dimension)
