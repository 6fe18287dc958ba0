"""Arithmetic of parameters: the same numbers as Python's, and nothing but arithmetic."""

import math
import re

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from eom.vehicle.expression import (
    FUNCTIONS,
    Binary,
    Call,
    Expression,
    Name,
    Number,
    evaluate,
    names,
    parse,
    python_text,
    substitute,
)
from eom.vehicle.quantity import parse_quantity

VALUES = {"a": 0.3, "b": -2.5, "c_1": 7.0}
LEAVES: st.SearchStrategy[Expression] = st.one_of(
    st.floats(-1e3, 1e3).map(Number), st.sampled_from(sorted(VALUES)).map(Name)
)


def grow(children: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    """Trees made of smaller ones."""
    calls = st.builds(Call, st.sampled_from(["negative", *FUNCTIONS]), children)
    return st.one_of(calls, st.builds(Binary, st.sampled_from(["+", "-", "*", "/", "**"]), children, children))


TREES = st.recursive(LEAVES, grow, max_leaves=12)


def python(text: str) -> float:
    """What Python makes of a text; NaN where that is no finite real number."""
    try:
        result = eval(text, {"math": math, **VALUES})  # noqa: S307  the text is our own
    except (ArithmeticError, ValueError, TypeError):
        return math.nan
    return result if isinstance(result, float) and math.isfinite(result) else math.nan


@given(TREES)
def test_printed_trees_mean_the_same_to_python_bit_for_bit(tree: Expression) -> None:
    wanted = python(python_text(tree))
    try:
        result = evaluate(tree, VALUES)
    except ValueError:
        assert math.isnan(wanted)
    else:
        assert result.hex() == float(wanted).hex()


@given(TREES)
@example(Binary("**", Number(-0.0), Number(0.0)))
def test_printed_trees_are_read_back(tree: Expression) -> None:
    text = python_text(tree).replace("math.", "")
    if len(text) > 200:
        return
    again = parse(text)
    assert set(names(again)) == set(names(tree))
    assert python_text(again).replace("math.", "") == text or "-" in text
    try:
        wanted = evaluate(tree, VALUES)
    except ValueError:
        return
    assert evaluate(again, VALUES).hex() == wanted.hex()


@given(st.one_of(st.text(), st.text("0123456789.eE+-*/^() abpi,_sqrtxj'\"[]:", max_size=40)))
def test_any_text_is_an_expression_or_a_value_error(text: str) -> None:
    for read in (parse, lambda text: parse_quantity(text, "kg").expression):
        try:
            tree = read(text)
        except ValueError as error:
            assert str(error)  # noqa: PT017  any text may also be an expression
        else:
            assert isinstance(tree, Expression)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2*3", 7.0),
        ("(1 + 2)*3", 9.0),
        ("-2**2", -4.0),
        ("(-2)**2", 4.0),
        ("2**3**2", 512.0),
        ("(2**3)**2", 64.0),
        ("2**-1", 0.5),
        ("10 - 4 - 3", 3.0),
        ("10 - (4 - 3)", 9.0),
        ("16/4/2", 2.0),
        ("16/(4/2)", 8.0),
        ("6/2*3", 9.0),
        ("--1", 1.0),
        ("+1", 1.0),
        ("2e-3*2", 0.004),
        ("1e3 + 1", 1001.0),
        ("sqrt(16) + sin(0)", 4.0),
        ("2*pi", 2 * math.pi),
        ("cos(pi)", -1.0),
        (" 1 ", 1.0),
    ],
)
def test_order_of_operations(text: str, value: float) -> None:
    assert evaluate(parse(text), {}) == value
    assert evaluate(parse_quantity(text, "kg").expression, {}) == value


@pytest.mark.parametrize("text", ["1e6", "1.0e6", "1E6", "+1e+6", "1000000", "1000000.", "1e6 kg", "1000 t", "1e+3t"])
def test_a_million(text: str) -> None:
    assert parse_quantity(text, "kg").expression == Number(1e6)


def test_signs_of_sums_and_powers_keep_their_parentheses() -> None:
    a, b = Name("a"), Name("b")
    assert python_text(Binary("-", a, Binary("-", a, b))) == "a - (a - b)"
    assert python_text(Binary("**", Call("negative", a), b)) == "(-a) ** b"
    assert python_text(Call("negative", Binary("**", a, b))) == "-a ** b"
    assert python_text(Binary("**", Binary("**", a, b), b)) == "(a ** b) ** b"


def test_operators_leave_out_exact_zeros_and_ones() -> None:
    a = Name("a")
    assert a + 0.0 == a
    assert 0.0 + a == a
    assert a * 1.0 == a
    assert a - 0.0 == a
    assert -Number(2.0) == Number(-2.0)
    assert Number(2.0) * 3.0 == Number(6.0)


def test_substitution_reaches_every_name() -> None:
    tree = substitute(parse("sqrt(a)*(b - a)"), {"a": Number(4.0)})
    assert list(names(tree)) == ["b"]
    assert evaluate(tree, {"b": 5.0}) == 2.0


def test_errors_show_the_expression() -> None:
    with pytest.raises(ValueError, match=re.escape("1.0 / (a - b) divides by zero")):
        evaluate(parse("1/(a - b)"), {"a": 1.0, "b": 1.0})
    with pytest.raises(ValueError, match=re.escape("sqrt(a) has no value")):
        evaluate(parse("sqrt(a)"), {"a": -1.0})
