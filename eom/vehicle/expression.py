"""Arithmetic of parameters: a bounded, whitelisted syntax tree that is never evaluated as code.

One tree, several back ends: `evaluate` gives a number, `compute` whatever its values are made of (traced symbols),
`python_text` the same arithmetic as Python source.
"""

import ast
import math
import re
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

MAX_LENGTH, MAX_NODES = 200, 100
# what Python reads and a reader of the file might not: 0x10, 1_000, comments
ODD = re.compile(r"#|(?<![A-Za-z_\d])\d+[_xXoObB]")
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
}
CONSTANTS = {"pi": math.pi}
OPERATORS: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Pow: "**",
}
PRECEDENCE = {"+": 1, "-": 1, "*": 2, "/": 2, "negative": 3, "**": 4}


class Expression:
    """An arithmetic expression; operators build larger ones."""

    def __add__(self, other: "Expression | float") -> "Expression":
        return combine("+", self, as_expression(other))

    def __sub__(self, other: "Expression | float") -> "Expression":
        return combine("-", self, as_expression(other))

    def __mul__(self, other: "Expression | float") -> "Expression":
        return combine("*", self, as_expression(other))

    def __truediv__(self, other: "Expression | float") -> "Expression":
        return combine("/", self, as_expression(other))

    def __radd__(self, other: float) -> "Expression":
        return combine("+", as_expression(other), self)

    def __rtruediv__(self, other: float) -> "Expression":
        return combine("/", as_expression(other), self)

    def __rmul__(self, other: float) -> "Expression":
        return combine("*", as_expression(other), self)

    def __neg__(self) -> "Expression":
        return Number(-self.value) if isinstance(self, Number) else Call("negative", self)


@dataclass(frozen=True)
class Number(Expression):
    """A number in SI units."""

    value: float


@dataclass(frozen=True)
class Name(Expression):
    """A parameter."""

    name: str


@dataclass(frozen=True)
class Call(Expression):
    """A function, or the sign change ``negative``, of one argument."""

    function: str
    argument: Expression


@dataclass(frozen=True)
class Binary(Expression):
    """An operation ``+ - * / **`` on two operands."""

    operator: str
    left: Expression
    right: Expression


def as_expression(value: "Expression | float") -> Expression:
    """A number as an expression; an expression as it is."""
    return value if isinstance(value, Expression) else Number(float(value))


def combine(operator: str, left: Expression, right: Expression) -> Expression:
    """The operation on two operands, without additions of an exact zero and products with an exact one."""
    if operator in "+-" and right == Number(0.0):
        return left
    if operator == "+" and left == Number(0.0):
        return right
    if operator == "*" and Number(1.0) in (left, right):
        return right if left == Number(1.0) else left
    if isinstance(left, Number) and isinstance(right, Number) and (operator, right) != ("/", Number(0.0)):
        return Number(evaluate(Binary(operator, left, right), {}))
    return Binary(operator, left, right)


def parse(text: str) -> Expression:
    """The tree of an expression such as ``(h_c - h_r)*2``; ``ValueError`` with a sentence for anything else."""
    if len(text) > MAX_LENGTH:
        message = f"an expression has at most {MAX_LENGTH} characters"
        raise ValueError(message)
    try:
        tree = syntax_tree(text.strip())
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        hint = "; write ** for powers" if "^" in text else ""
        message = f"'{shorten(text)}' is neither a number with a unit nor an arithmetic expression{hint}"
        raise ValueError(message) from None
    if sum(1 for _ in ast.walk(tree)) > 4 * MAX_NODES:
        message = "the expression is too long: introduce parameters for its parts"
        raise ValueError(message)
    return convert(tree.body, text)


def syntax_tree(text: str) -> ast.Expression:
    """Python's tree of a text; ``SyntaxError`` also where Python would warn."""
    if ODD.search(text):
        raise SyntaxError(text)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return ast.parse(text, mode="eval")
        except Warning as warning:
            raise SyntaxError(text) from warning


def convert(node: ast.expr, text: str) -> Expression:
    """Our tree of Python's tree, for the whitelisted nodes alone."""
    match node:
        case ast.Constant(value=bool()) | ast.Constant(value=complex()):
            pass
        case ast.Constant(value=int() | float() as value):
            return Number(finite(float(value) if abs(value) < 1e308 else math.inf, text))
        case ast.Name(id=name):
            return Number(CONSTANTS[name]) if name in CONSTANTS else Name(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -convert(operand, text)
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return convert(operand, text)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            return Binary(OPERATORS[type(op)], convert(left, text), convert(right, text))
        case ast.Call(func=ast.Name(id=function), args=[argument], keywords=[]) if function in FUNCTIONS:
            return Call(function, convert(argument, text))
        case ast.Call(func=ast.Name(id=function)) if function not in FUNCTIONS:
            message = f"'{shorten(function)}' is not a function here; known are {', '.join(FUNCTIONS)}"
            raise ValueError(message)
        case _:
            pass
    hint = "; write ** for powers" if "^" in text else ""
    message = (
        f"'{shorten(text)}' is not plain arithmetic: numbers, parameters, + - * / **, parentheses and "
        f"{', '.join(FUNCTIONS)} may stand in it{hint}"
    )
    raise ValueError(message)


def shorten(text: str) -> str:
    """Text cut to what a message can show, on one line."""
    text = " ".join(text.split())
    return text if len(text) <= 60 else text[:57] + "..."


def finite(value: float, text: str) -> float:
    """The value; ``ValueError`` if it is not a finite number."""
    if not math.isfinite(value):
        message = f"'{shorten(text)}' is not a finite number"
        raise ValueError(message)
    return value


def names(expression: Expression) -> Iterator[str]:
    """The parameters that occur in an expression."""
    match expression:
        case Name(name):
            yield name
        case Call(_, argument):
            yield from names(argument)
        case Binary(_, left, right):
            yield from names(left)
            yield from names(right)


def substitute(expression: Expression, replacements: Mapping[str, Expression]) -> Expression:
    """The expression with some of its parameters replaced."""
    match expression:
        case Name(name):
            return replacements.get(name, expression)
        case Call(function, argument):
            return Call(function, substitute(argument, replacements))
        case Binary(operator, left, right):
            return Binary(operator, substitute(left, replacements), substitute(right, replacements))
    return expression


def evaluate(expression: Expression, values: Mapping[str, float]) -> float:
    """The number that an expression stands for; ``ValueError`` with a sentence where there is none."""
    try:
        result, problem = compute(expression, values), "is not a finite real number"
    except ZeroDivisionError:
        result, problem = math.nan, "divides by zero"
    except OverflowError:
        result, problem = math.nan, "is too large"
    except ValueError as error:
        result, problem = math.nan, f"has no value: {error}"
    if not math.isfinite(result):
        message = f"{python_text(expression).replace('math.', '')} {problem}"
        raise ValueError(message)
    return result


def real_power(a: float, b: float) -> float:
    """A to the power b; ``ValueError`` where it is not real."""
    result: float = a**b
    if isinstance(result, complex):
        message = f"{a:g} ** {b:g} is not a real number"
        raise ValueError(message)  # noqa: TRY004  the value is at fault, not its type
    return result


def compute(
    expression: Expression,
    values: Mapping[str, float],
    functions: Mapping[str, Callable[[float], float]] = FUNCTIONS,
) -> float:
    """Plain recursion of `evaluate`, for whatever *values* and *functions* compute with."""
    match expression:
        case Number(value):
            return value
        case Name(name):
            return values[name]
        case Call("negative", argument):
            return -compute(argument, values, functions)
        case Call(function, argument):
            return functions[function](compute(argument, values, functions))
        case Binary(operator, left, right):
            a, b = compute(left, values, functions), compute(right, values, functions)
            match operator:
                case "+":
                    return a + b
                case "-":
                    return a - b
                case "*":
                    return a * b
                case "/":
                    return a / b
                case _:
                    return real_power(a, b)
    raise TypeError(expression)


def python_text(expression: Expression, show_name: Callable[[str], str] = str, outer: int = 0) -> str:
    """Python source of an expression, with as few parentheses as keep its order of operations.

    >>> python_text(parse("(a - b)*2/c**2"))
    '(a - b) * 2.0 / c ** 2.0'
    """
    match expression:
        case Number(value):
            text, own = repr(value), PRECEDENCE["negative"] if math.copysign(1.0, value) < 0.0 else 9
        case Name(name):
            text, own = show_name(name), 9
        case Call("negative", argument):
            own = PRECEDENCE["negative"]
            text = "-" + python_text(argument, show_name, own)
        case Call(function, argument):
            text, own = f"math.{function}({python_text(argument, show_name)})", 9
        case Binary(operator, left, right):
            own = PRECEDENCE[operator]
            # a ** b ** c groups to the right, everything else to the left
            first = python_text(left, show_name, own + (operator == "**"))
            second = python_text(right, show_name, own + (operator != "**"))
            text = f"{first} {operator} {second}"
        case _:
            raise TypeError(expression)
    return f"({text})" if own < outer else text
