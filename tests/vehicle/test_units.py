"""Units of measure, with pint's own registry as the referee."""

import math

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.vehicle.units import DIMENSIONLESS, parse_unit, show_dimension

REFEREE: "pint.UnitRegistry[float]" = pint.UnitRegistry()
# our name to pint's, which calls some units otherwise
SAME = """
m kg g s rad N Pa bar J W Hz deg rpm lb ft lbf h min slug mph kph km mm cm ms kN MN GPa MPa kPa kJ kW mN metre meter sec
degree tonne hour foot inch newton pound
"""
NAMES = {
    **{name: name for name in SAME.split()},
    "in": "inch",
    "t": "tonne",
    "rev": "revolution",
    "°": "degree",
    "Mg": "megagram",
}
FACTORS = st.tuples(st.sampled_from(sorted(NAMES)), st.integers(-3, 3).filter(bool))


def referee(factors: list[tuple[str, int]]) -> tuple[float, tuple[float, float, float]]:
    """SI factor and exponents of a product of units, by pint."""
    product = REFEREE.Quantity(1.0, "")
    for name, power in factors:
        # hertz is one per second here, and not an angle of a whole turn
        product *= REFEREE.Quantity(1.0, NAMES[name]) ** power
    base = product.to_base_units()
    units = base.unit_items()
    exponents = {name: float(str(power)) for name, power in units if name != "radian"}
    assert set(exponents) <= {"kilogram", "meter", "second"}
    return float(str(base.magnitude)), (
        exponents.get("kilogram", 0),
        exponents.get("meter", 0),
        exponents.get("second", 0),
    )


@given(st.lists(FACTORS, min_size=1, max_size=5), st.booleans(), st.sampled_from(["*", " * ", "·"]))
def test_products_are_what_pint_makes_of_them(factors: list[tuple[str, int]], quotient: bool, times: str) -> None:
    text = times.join(f"{name}^{power}" for name, power in factors)
    if quotient:
        text = f"1/{factors[0][0]}/{text}"
        factors = [(factors[0][0], -1), (factors[0][0], -factors[0][1]), *factors[1:]]
    if len(text) > 60:
        return
    factor, dimension = parse_unit(text)
    wanted, exponents = referee(factors)
    assert dimension == exponents
    assert math.isclose(factor, wanted, rel_tol=1e-12)


@pytest.mark.parametrize(
    ("text", "factor", "dimension"),
    [
        ("kN*m*s/rad", 1000.0, (1, 2, -1)),
        ("km/h", 1 / 3.6, (0, 1, -1)),
        ("m/s/s", 1.0, (0, 1, -2)),
        ("m/s²", 1.0, (0, 1, -2)),
        ("m/s**2", 1.0, (0, 1, -2)),
        ("1/s", 1.0, (0, 0, -1)),
        ("deg", math.pi / 180, DIMENSIONLESS),
        ("t", 1000.0, (1, 0, 0)),
        ("min", 60.0, (0, 0, 1)),
        ("Hz", 1.0, (0, 0, -1)),
        ("", 1.0, DIMENSIONLESS),
        ("lbf/in", 4.4482216152605 / 0.0254, (1, 0, -2)),
    ],
)
def test_units_in_use(text: str, factor: float, dimension: tuple[float, float, float]) -> None:
    assert parse_unit(text)[0] == pytest.approx(factor, rel=1e-14)
    assert parse_unit(text)[1] == dimension


@given(st.one_of(st.text(max_size=70), st.text("mkgsNtrad°*/^-123 ", max_size=20)))
def test_any_other_text_is_refused_in_a_sentence(text: str) -> None:
    sentence = ""
    try:
        parse_unit(text)
    except ValueError as error:
        sentence = str(error)
    assert not sentence or "unit of measure" in sentence


@pytest.mark.parametrize("name", ["nan", "NaN", "inf", "dimensionless", "per", "pi", "degC", "K", "delta_degC"])
def test_names_with_a_meaning_to_pint_alone_are_unknown(name: str) -> None:
    with pytest.raises(ValueError, match="unit of measure"):
        parse_unit(name)


def test_dimensions_are_shown_in_base_units() -> None:
    assert show_dimension((1.0, 2.0, -1.0)) == "kg*m^2/s"
    assert show_dimension((0.0, 0.0, -2.0)) == "1/s^2"
    assert show_dimension(DIMENSIONLESS) == "a plain number"
