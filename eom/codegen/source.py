"""Python source of a draft: elements as constructor calls, expressions of parameters as arithmetic."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

from eom.vehicle.draft import ORIGIN, Draft, X, Y, Z
from eom.vehicle.draft_signals import unit_mass
from eom.vehicle.elements import GROUND, Connection, Vector
from eom.vehicle.expression import PRECEDENCE, Binary, Call, Expression, Name, Number, python_text

WIDTH = 110
BODY_FIELDS = ("body", "bodies", "frame")
LOCAL = "local "


def parameter_text(name: str) -> str:
    """How a parameter, or a local variable of the generated function, is read."""
    return name.removeprefix(LOCAL) if name.startswith(LOCAL) else f'p["{name}"]'


def literal(value: object) -> str:
    """A number, text or None as Python source, with double quotes."""
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    return repr(value)


def constant_names(bodies: Sequence[str]) -> list[str]:
    """Names of the constants that hold the bodies' numbers; the prefix is no other constant's of a module."""
    upper = [f"BODY_{body.upper().replace('.', '_')}" for body in bodies]
    return [name if upper.count(name) == 1 else f"{name}_{k}" for k, name in enumerate(upper)]


@dataclass(frozen=True)
class Writer:
    """Writes the values of one draft.

    Attributes
    ----------
    bodies : sequence of str
        Names of the constants of the bodies by number.
    places : mapping
        Places and directions that have a name in the generated module.
    numbers : mapping
        Expressions that have one, as they stand inside others.
    """

    bodies: Sequence[str]
    places: Mapping[Vector, str]
    numbers: Mapping[Expression, Name]

    def text(self, value: object, indent: int = 0, lead: int = 0) -> str:
        """Source of a value, on one line if it fits, else one argument a line.

        *indent* is that of the line on which it starts, *lead* how many more characters stand around it there.
        """
        one_line = self.render(value, lambda part, _: self.text(part, 0, -10_000), None)
        if indent + lead + len(one_line) < WIDTH or value in self.places:
            return one_line
        inner = indent + 4
        if isinstance(value, Binary | Call):
            return f"(\n{' ' * inner}{self.operation(self.with_locals(value), inner)}\n{' ' * indent})"
        if not isinstance(value, tuple):
            return one_line
        return self.render(value, lambda part, before: self.text(part, inner, before + 1), inner)

    def operation(self, value: Expression, indent: int, outer: int = 0) -> str:
        """Source of an expression within parentheses, broken before operators as often as its length asks for."""
        one_line = python_text(value, parameter_text, outer)
        if indent + len(one_line) < WIDTH:
            return one_line
        match value:
            case Binary(operator, left, right):
                own = PRECEDENCE[operator]
                first = self.operation(left, indent, own + (operator == "**"))
                text = f"{first}\n{' ' * indent}{operator} {self.operation(right, indent, own + (operator != '**'))}"
                return f"({text})" if own < outer else text
            case Call(function, argument):
                sign = function == "negative"
                text = self.operation(argument, indent, PRECEDENCE["negative"] if sign else 0)
                return f"-{text}" if sign else f"math.{function}({text})"
        return one_line

    def render(self, value: object, show: Callable[[object, int], str], indent: int | None) -> str:
        """A value with its parts shown by *show*; on lines of their own if an indent is given."""
        if isinstance(value, Expression):
            return python_text(self.with_locals(value), parameter_text)
        if not isinstance(value, tuple):
            return literal(value)
        if value in self.places:
            return self.places[value]
        if hasattr(value, "_fields"):
            fields: tuple[str, ...] = getattr(value, "_fields", ())
            defaults: dict[str, object] = getattr(value, "_field_defaults", {})
            pieces = [
                f"{name}={self.body(part, indent) if name in BODY_FIELDS else show(part, len(name) + 1)}"
                for name, part in zip(fields, value, strict=True)
                if name not in defaults or plain(part) != defaults[name]
            ]
            opening, closing = f"{type(value).__name__}(", ")"
        else:
            pieces, opening, closing = [show(part, 0) for part in value], "(", ")"
        if indent is not None:
            lines = "".join(f"\n{' ' * indent}{piece}," for piece in pieces)
            return f"{opening}{lines}\n{' ' * (indent - 4)}{closing}"
        comma = "," if opening == "(" and len(pieces) == 1 else ""
        return opening + ", ".join(pieces) + comma + closing

    def body(self, value: object, indent: int | None = None) -> str:
        """Body numbers by the names of their constants, on lines of their own if they need to; texts as they are."""
        match value:
            case tuple() if all(isinstance(part, int) for part in value):
                names = [self.body(part) for part in value]
                one_line = f"({', '.join(names)}{',' if len(names) == 1 else ''})"
                if indent is None or indent + len(one_line) < WIDTH:
                    return one_line
                lines = "".join(f"\n{' ' * (indent + 4)}{name}," for name in names)
                return f"({lines}\n{' ' * indent})"
            case int():
                return "GROUND" if value == GROUND else self.bodies[value]
            case _:
                return self.text(value)

    def with_locals(self, expression: Expression) -> Expression:
        """The expression with named parts by their names."""
        if expression in self.numbers:
            return self.numbers[expression]
        match expression:
            case Binary(operator, left, right):
                return Binary(operator, self.with_locals(left), self.with_locals(right))
            case Call(function, argument):
                return Call(function, self.with_locals(argument))
        return expression


def make_writer(draft: Draft) -> tuple[Writer, list[tuple[str, str]]]:
    """A writer for a draft, and the (name, source) of the local variables that it uses, in their order."""
    bodies = constant_names([body.name for body in draft.bodies])
    axes: dict[Vector, str] = {ORIGIN: "ORIGIN", X: "X", Y: "Y", Z: "Z"}
    numbers: dict[Expression, Name] = {}
    variables: list[tuple[str, str]] = []
    for unit in draft.units:
        writer = Writer(bodies, axes, dict(numbers))
        for axis, component in zip("xyz", unit.origin, strict=True):
            if isinstance(component, Binary):
                name = f"{unit.name}_{axis}"
                variables.append((name, writer.text(component, 4, len(name) + 3)))
                numbers[component] = Name(LOCAL + name)
        total = cast("Expression", unit_mass(draft, unit))
        if isinstance(total, Binary):
            name = f"{unit.name}_mass"
            variables.append((name, writer.text(total, 4, len(name) + 3)))
            numbers[total] = Name(LOCAL + name)
    writer = Writer(bodies, axes, numbers)
    places = dict(axes)
    for place, name in named_places(draft):
        if place not in places:
            # a joint's row and another object may share a name once their dots are gone
            while any(name == other for other, _ in variables):
                name += "_"  # noqa: PLW2901
            variables.append((name, writer.text(place, 4, len(name) + 3)))
            places[place] = name
    return Writer(bodies, places, numbers), variables


def plain(value: object) -> object:
    """Numbers of a draft as floats, to compare with an element's defaults."""
    if isinstance(value, Number):
        return value.value
    return tuple(map(plain, value)) if isinstance(value, tuple) else value


def named_places(draft: Draft) -> list[tuple[Vector, str]]:
    """Centres of bodies and places of connections, each with a name."""
    connections: list[Connection] = [
        *(item.connection for item in draft.constraints),
        *draft.rolling,
        *(item.connection for item in draft.elastic),
        *(item.connection for item in draft.slip),
        *(item.connection for item in draft.bushings),
    ]
    named = [(body.centre, f"{body.name.replace('.', '_')}_centre") for body in draft.bodies]
    for item in connections:
        name = item.name.replace(".", "_")
        if item.places[0] != item.places[1]:
            named += [(item.places[0], f"{name}_start"), (item.places[1], f"{name}_end")]
        else:
            named.append((item.places[0], f"{name}_place"))
    return named
