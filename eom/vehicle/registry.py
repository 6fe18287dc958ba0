"""The live numbers of a description: declared parameters, and every literal under its object's name."""

from dataclasses import dataclass, field
from typing import cast

from eom.vehicle.elements import Vector
from eom.vehicle.expression import Binary, Call, Expression, Name, Number, names, substitute
from eom.vehicle.quantity import Quantity
from eom.vehicle.source import Path
from eom.vehicle.units import DIMENSIONLESS, Dimension, parse_unit, show_dimension, stated_in
from eom.vehicle.validate import did_you_mean

XYZ = ("x", "y", "z")


@dataclass(frozen=True)
class Live:
    """A number that a user may change: its default, bounds and meaning; ``overridden`` from outside the file."""

    default: Expression
    unit: str
    description: str
    path: Path
    minimum: Expression | None = None
    maximum: Expression | None = None
    dimension: Dimension | None = None
    overridden: bool = False

    @property
    def si_unit(self) -> str:
        """Its SI unit, empty for a plain number and where nothing tells."""
        if self.unit != "*":
            return self.unit
        return "" if self.dimension in {None, DIMENSIONLESS} else show_dimension(self.dimension or DIMENSIONLESS)


@dataclass
class Registry:
    """Collects live numbers, the expressions made of them, and the mistakes made in referring to them.

    ``computed`` tells which parameters a number without a name of its own is made of, ``used`` which arguments of
    templates occur. ``floors`` holds (expression, path, whether zero is allowed) of what must not be negative. Names
    in ``broken`` belong to parts left out because of mistakes: referring to them is no further one.
    """

    parameters: dict[str, Live] = field(default_factory=dict)
    mistakes: list[tuple[Path, str]] = field(default_factory=list)
    broken: set[str] = field(default_factory=set)
    expressions: list[tuple[Expression, Path]] = field(default_factory=list)
    computed: dict[str, tuple[str, ...]] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)
    floors: list[tuple[Expression, Path, bool]] = field(default_factory=list)

    def excuses(self, name: str) -> bool:
        """Whether a name is, or is composed of, one that was left out."""
        return any(f"_{part}_" in f"_{name}_" for part in self.broken)

    def report(self, path: Path, what: str) -> None:
        """Note a mistake at a path of the file."""
        self.mistakes.append((path, what))

    def resolve(self, quantity: Quantity, path: Path, scope: dict[str, Expression]) -> Expression:
        """The quantity's expression with a template's arguments filled in; unknown names are reported."""
        self.used.update(set(names(quantity.expression)) & set(scope))
        expression = substitute(quantity.expression, scope)
        for name in names(expression):
            if name not in self.parameters and not self.excuses(name):
                known = [key for key in (*self.parameters, *scope) if "." not in key]
                self.report(path, f"unknown parameter '{name}'{did_you_mean(name, known)}")
        self.check_dimension(expression, quantity.unit, path)
        self.expressions.append((expression, path))
        return expression

    def check_dimension(self, expression: Expression, unit: str, path: Path) -> None:
        """An expression whose dimension its parameters tell must have that of the place where it stands."""
        own = self.dimension(expression)
        if unit != "*" and own is not None and own != parse_unit(unit)[1]:
            what = f"the parameter '{expression.name}'" if isinstance(expression, Name) else "this expression"
            self.report(path, f"{what} is {stated_in(own)}, expected {unit or 'a plain number'}")

    def dimension(self, expression: Expression) -> Dimension | None:
        """Dimension of a sum or of a parameter; None where plain numbers and factors leave it open."""
        match expression:
            case Name(name) if name in self.parameters:
                return self.parameters[name].dimension
            case Call("negative", argument):
                return self.dimension(argument)
            case Binary("+" | "-", left, right):
                return self.dimension(left) or self.dimension(right)
        return None

    def number(self, quantity: Quantity, name: str, path: Path, scope: dict[str, Expression] | None = None) -> float:
        """What stands for a quantity in the draft: a literal becomes the parameter *name*.

        Typed as the number that it will be once parameters have values.
        """
        if isinstance(quantity.expression, Number):
            self.parameters[name] = Live(
                quantity.expression, quantity.unit, f"{name.replace('.', ' ')}", path, dimension=quantity.dimension
            )
            return cast("float", Name(name))
        expression = self.resolve(quantity, path, scope or {})
        self.computed[name] = tuple(names(expression))
        return cast("float", expression)

    def not_negative(self, value: float, path: Path, *, zero: bool = True) -> float:
        """The same value, which must not be negative, nor without *zero* be zero."""
        self.floors.append((cast("Expression", value), path, zero))
        return value

    def place(
        self,
        values: tuple[Quantity, Quantity, Quantity],
        name: str,
        path: Path,
        scope: dict[str, Expression] | None = None,
    ) -> Vector:
        """Three live numbers ``name.x``, ``name.y``, ``name.z``."""
        x, y, z = (
            self.number(value, f"{name}.{axis}", (*path, k), scope)
            for k, (axis, value) in enumerate(zip(XYZ, values, strict=True))
        )
        return x, y, z

    def axis(
        self,
        values: tuple[Quantity, Quantity, Quantity],
        path: Path,
        scope: dict[str, Expression] | None = None,
    ) -> Vector:
        """A direction: its literals are part of the structure and do not become parameters."""
        x, y, z = (cast("float", self.resolve(value, (*path, k), scope or {})) for k, value in enumerate(values))
        return x, y, z
