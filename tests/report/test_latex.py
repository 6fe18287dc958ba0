"""The LaTeX document of a vehicle's equations, read back."""

import re
from collections.abc import Mapping

import numpy as np
import pytest
import sympy

import eom
from eom.report.latex import latex_document, symbol_name, text
from tests.vehicles.shipped import vehicle

MATRIX = re.compile(
    r"\\subsection\*\{\$(\S+)\$, .*?\}\n(No entries\.|\\begin\{align\*\}\n(.*?)\n\\end\{align\*\})", re.DOTALL
)
ENTRY = re.compile(r"\S+?\((\d+), (\d+)\) &= (.*)", re.DOTALL)
ATTRIBUTES = {"J_n": "Jn", "H_s": "H_slip", "D_s": "D_slip", "B_r": "B_rate"}


def group(latex: str, start: int) -> tuple[str, int]:
    """The group in braces that opens at *start*, and where it ends."""
    depth = 0
    for k in range(start, len(latex)):
        depth += (latex[k] == "{") - (latex[k] == "}")
        if depth == 0:
            return latex[start + 1 : k], k + 1
    raise AssertionError(latex)


def value(latex: str, names: Mapping[str, float]) -> float:
    """The number that a formula of the document stands for."""
    latex = re.sub(r"\\bigl|\\bigr|&\\quad|\\\\\n", "", latex)
    known = "|".join(re.escape(name) for name in sorted(names, key=len, reverse=True))
    latex = re.sub(rf"(?<![A-Za-z\\])(?:{known})", lambda match: f"({names[match[0]]!r})", latex)
    while (at := latex.find(r"\frac")) >= 0:
        above, middle = group(latex, at + 5)
        below, end = group(latex, middle)
        latex = f"{latex[:at]}(({above})/({below})){latex[end:]}"
    latex = latex.replace(r"\cdot", "*").replace("^", "**").translate({ord("{"): "(", ord("}"): ")"})
    assert not re.search(r"[A-Za-z\\]", latex.replace("e-", "").replace("e+", "")), latex
    return float(eval(latex))  # noqa: S307  arithmetic of this test's own numbers


@pytest.mark.parametrize("name", ["b_train_yaw_plane", "full_car", "quarter_car", "b_train_yaw_roll"])
def test_the_document_says_what_the_matrices_are(name: str) -> None:
    own = eom.assemble(vehicle(name), symbols="all")
    point = own.point(own.numeric)
    names = {symbol_name(symbol): float(number) for symbol, number in point.items()}
    found = MATRIX.findall(latex_document(own))
    assert [letter for letter, *_ in found] == ["M", "C", "K", "V", "J", "J_n", "H_s", "D_s", *"FGEAB", "B_r"]
    for letter, _, body in found:
        matrix = getattr(own, ATTRIBUTES.get(letter, letter))
        read = np.zeros(matrix.shape)
        for entry in re.split(r" \\\\\n(?!&)", body) if body else []:
            match = ENTRY.fullmatch(entry)
            assert match is not None, entry
            read[int(match[1]) - 1, int(match[2]) - 1] = value(match[3], names)
        expected = own.numbers(matrix)
        # sums of products in double precision, of terms a thousand times larger than their sum at most
        np.testing.assert_allclose(read, expected, rtol=0.0, atol=1e-11 * np.max(np.abs(expected), initial=1.0))


def test_every_parameter_and_preload_is_told() -> None:
    own = eom.assemble(vehicle("b_train_yaw_plane"), symbols="all")
    document = latex_document(own)
    for name in (*own.symbols, *own.preloads):
        assert symbol_name(sympy.Symbol(name)) in document
    assert "trim speed" in document
    assert document.count(r"\begin{") == document.count(r"\end{")


def test_short_names_have_an_index_and_long_ones_stand_upright() -> None:
    assert symbol_name(sympy.Symbol("h_r")) == "h_{r}"
    assert symbol_name(sympy.Symbol("C1")) == r"\mathrm{C1}"
    assert symbol_name(sympy.Symbol("axle_1.x")) == r"\mathrm{axle\_1.x}"


def test_different_parameters_print_differently() -> None:
    names = ("C1", "C_1", "x", "xdot", "xhat", "xbm", "a__b", "ab", "a_b", "pi1", "x_", "axle_1.x", "axle_1_x")
    assert len({symbol_name(sympy.Symbol(name)) for name in names}) == len(names)


def test_text_of_a_file_cannot_be_a_command() -> None:
    assert text(r"50 % of \input{x} & $y$ # ~^_") == (
        r"50 \% of \textbackslash{}input\{x\} \& \$y\$ \# \textasciitilde{}\^{}\_"
    )


def test_a_vehicle_that_carries_nothing_says_so() -> None:
    weightless = vehicle("quarter_car", gravity=0.0)
    assert "Nothing carries a load" in latex_document(eom.assemble(weightless, symbols="k_s"))
