"""The equations of motion in symbols as a LaTeX document."""

import re
from collections.abc import Iterable, Iterator, Sequence

import sympy

from eom.model.symbolic import SymbolicAssembly

# characters of formula that fit on a line, judged by what is printed
WIDTH = 95
COMMAND = re.compile(r"\\(?:mathrm|left|right|frac|sqrt|quad|,|;)|[{}^_\\ ]")
SPECIAL = {**{c: f"\\{c}" for c in "&%$#_{}"}, "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\^{}"}
LETTERS = {"Jn": "J_n", "H_slip": "H_s", "D_slip": "D_s", "B_rate": "B_r"}

HEAD = r"""\documentclass[9pt]{extarticle}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage[a4paper, margin=18mm]{geometry}
\usepackage{amsmath, longtable}
\allowdisplaybreaks[4]
\setlength{\parindent}{0pt}
\begin{document}
"""
EQUATIONS = r"""Displacements $p$ of the centres of mass and rotations, in inertial axes (x forward, y left, z up), and
velocities $w$ in body axes are small, about the trim:
\begin{gather*}
M \dot w + C w + K p = F u + G \dot u + J^{\mathsf T} \lambda, \qquad \dot p + V p - w = 0, \qquad J p = 0,
\qquad J_n w = 0 .
\end{gather*}
Slip rows $H_s$ with their coefficients $D_s$ are part of $C$, which contains $H_s^{\mathsf T} D_s H_s$. Entries
that are not listed are zero. SI units and radians.
"""
REDUCED = r"""The constraints leave the displacements and velocities
$z$ below, with $E \dot z = A z + B u + B_r \dot u$.
"""


def latex_document(assembly: SymbolicAssembly) -> str:
    """The document: parameters, preloads with their equations, all matrices by their entries, reduced equations."""
    numeric = assembly.numeric
    named = {
        "p": numeric.coordinates,
        "w": numeric.velocities,
        "u": [item.name for item in numeric.system.inputs],
        "J": numeric.constraint_rows,
        "J_n": numeric.rolling_rows,
        "H_s": numeric.slip_rows,
    }
    full = ("M", "C", "K", "V", "J", "Jn", "H_slip", "D_slip", "F", "G")
    blocks = [
        HEAD,
        rf"\section*{{{text(numeric.vehicle.name)}}}",
        EQUATIONS,
        *(line for letter, names in named.items() for line in numbered(letter, names)),
        r"\section{Parameters}",
        *parameters(assembly),
        r"\section{Preloads}",
        *preloads(assembly),
        r"\section{Matrices}",
        *(line for name in full for line in entries(LETTERS.get(name, name), getattr(assembly, name))),
        r"\section{Reduced equations}",
        REDUCED,
        *numbered("z", numeric.independent),
        *(
            line
            for name in ("E", "A", "B", "B_rate")
            for line in entries(LETTERS.get(name, name), getattr(assembly, name))
        ),
        r"\end{document}",
    ]
    return "\n".join(blocks) + "\n"


def text(words: str) -> str:
    """Plain text with LaTeX's special characters escaped."""
    return "".join(SPECIAL.get(character, character) for character in words)


def symbol_name(symbol: sympy.Symbol) -> str:
    """A short name with its index; any other, such as that of an object's quantity, upright as it is."""
    short = re.fullmatch(r"([A-Za-z]{1,2})(?:_([A-Za-z0-9]{1,2}))?", symbol.name)
    if short is not None:
        return short[1] if short[2] is None else f"{short[1]}_{{{short[2]}}}"
    return rf"\mathrm{{{text(symbol.name)}}}"


def formula(expression: sympy.Expr) -> str:
    """An expression in LaTeX."""
    names = {symbol: symbol_name(symbol) for symbol in expression.free_symbols}
    return str(sympy.latex(expression, symbol_names=names, mul_symbol="dot"))


def parameters(assembly: SymbolicAssembly) -> Iterator[str]:
    """A table of the symbols: value in SI units, unit, description."""
    registry = assembly.numeric.vehicle.draft.registry.parameters
    yield r"\begin{longtable}{lrll} symbol & value & SI unit & meaning \\ \hline \endhead"
    for name, symbol in assembly.symbols.items():
        live = registry[name]
        value = f"{assembly.numeric.vehicle.values[name]:.10g}"
        described = live.description if live.path[0] == "parameters" else ""
        yield rf"${symbol_name(symbol)}$ & {value} & {text(live.si_unit)} & {text(described)} \\"
    yield r"\end{longtable}"


def preloads(assembly: SymbolicAssembly) -> Iterator[str]:
    """The equations of what joints and springs carry at the trim."""
    if not assembly.equilibrium:
        yield "Nothing carries a load at the trim."
        return
    yield "A preload is positive along its row on the first body."
    formulas = assembly.formulas.items()
    implicit = ((sympy.S.Zero, equation.lhs) for equation in assembly.equilibrium)
    yield from aligned((formula(left), right) for left, right in (formulas or implicit))


def numbered(letter: str, names: Sequence[str]) -> Iterator[str]:
    """The components of a vector, or the rows of a matrix, by name."""
    if names:
        listed = ", ".join(f"{k}~{text(name)}" for k, name in enumerate(names, start=1))
        yield rf"\begin{{flushleft}}${letter}$: {listed}\end{{flushleft}}"


def entries(letter: str, matrix: sympy.ImmutableMatrix) -> Iterator[str]:
    """The entries of a matrix that are not zero, by row and column."""
    yield rf"\subsection*{{${letter}$, ${matrix.rows} \times {matrix.cols}$}}"
    found = [(i, j) for i in range(matrix.rows) for j in range(matrix.cols) if matrix[i, j] != 0]
    if found:
        yield from aligned((f"{letter}({i + 1}, {j + 1})", matrix[i, j]) for i, j in found)
    else:
        yield "No entries."


def aligned(equations: Iterable[tuple[str, sympy.Expr]]) -> Iterator[str]:
    """Equations below each other, each over as many lines as it needs."""
    shown = (rf"{left} &= " + " \\\\\n&\\quad ".join(broken(right)) for left, right in equations)
    yield r"\begin{align*}"
    yield " \\\\\n".join(shown)
    yield r"\end{align*}"


def broken(expression: sympy.Expr) -> list[str]:
    """An expression as lines, broken between the terms of sums; a long quotient as two sums in brackets."""
    numerator, denominator = sympy.fraction(expression)
    if printed_length(formula(expression)) <= WIDTH:
        return [formula(expression)]
    if not denominator.is_Add:
        return terms_on_lines(sympy.expand(expression))
    above, below = in_brackets(terms_on_lines(numerator)), in_brackets(terms_on_lines(denominator))
    return [*above, f"/ {below[0]}", *below[1:]]


def in_brackets(lines: list[str]) -> list[str]:
    """Lines with one pair of brackets around them."""
    opened = [rf"\bigl({lines[0]}", *lines[1:]]
    return [*opened[:-1], rf"{opened[-1]}\bigr)"]


def terms_on_lines(expression: sympy.Expr) -> list[str]:
    """The terms of a sum, on as few lines as hold them."""
    lines = [""]
    for term in expression.as_ordered_terms():
        shown = formula(term)
        signed = shown if shown.startswith("-") or lines == [""] else f"+ {shown}"
        if lines[-1] and printed_length(lines[-1] + signed) > WIDTH:
            lines.append("")
        lines[-1] += f"{signed} "
    return lines


def printed_length(shown: str) -> int:
    """About how many characters of a formula are printed."""
    return len(COMMAND.sub("", shown))
