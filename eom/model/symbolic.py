"""The matrices of a vehicle in symbols: the same assembly, computed with traced numbers."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
import sympy

from eom.assembly.elastic import elastic_items
from eom.assembly.matrices import Matrices, assemble_matrices
from eom.assembly.vectors import Array
from eom.errors import DescriptionError, EomError, Mistake
from eom.model.assembly import Assembly, assemble, descriptor_of
from eom.model.field import EXACT, rational_field
from eom.model.preloads import SymbolicBalance, significant
from eom.model.traced import Traced, exact, function
from eom.vehicle.elements import System, wheels_alone
from eom.vehicle.expression import FUNCTIONS, Number, compute
from eom.vehicle.expression import names as parameter_names
from eom.vehicle.load import Vehicle
from eom.vehicle.values import in_order, why_unknown, with_entries

FULL = ("M", "C", "K", "V", "J", "Jn", "H", "H_slip", "D_slip", "F", "G")
REDUCTION = ("T", "W", "Z")


@dataclass(frozen=True)
class SymbolicAssembly:
    """Matrices of the equations of motion in symbols, every entry an expanded rational function of them.

    Rows and columns are those of the numeric assembly, whose labels name them. Which coordinates are independent was
    chosen by numbers, at the trim. A parameter of value zero is structure, and a symbol only if asked for by name.

    Attributes
    ----------
    numeric : Assembly
        The same matrices as numbers, with the labels.
    M, C, K, V : sympy.ImmutableMatrix
        (N, N), see `eom.assembly.matrices.Matrices`.
    J, Jn, H, H_slip : sympy.ImmutableMatrix
        Constraint, rolling, elastic and slip rows over the N coordinates.
    D_slip : sympy.ImmutableMatrix
        Slip coefficients.
    F, G : sympy.ImmutableMatrix
        Forces of inputs and of their rates, (N, inputs).
    E, A, B, B_rate : sympy.ImmutableMatrix
        The reduced equations E dz/dt = A z + B u + B_rate du/dt; z is named by ``numeric.independent``.
    symbols : mapping of str to sympy.Symbol
        The symbol of each parameter that has one.
    preloads : mapping of str to sympy.Symbol
        The load that each row of a joint or spring carries at the trim, ``row.preload``, where it is not zero;
        positive along the row on its first body [N, N m].
    equilibrium : tuple of sympy.Eq
        The equations of the preloads, see `eom.model.preloads`.
    """

    numeric: Assembly
    M: sympy.ImmutableMatrix
    C: sympy.ImmutableMatrix
    K: sympy.ImmutableMatrix
    V: sympy.ImmutableMatrix
    J: sympy.ImmutableMatrix
    Jn: sympy.ImmutableMatrix
    H: sympy.ImmutableMatrix
    H_slip: sympy.ImmutableMatrix
    D_slip: sympy.ImmutableMatrix
    F: sympy.ImmutableMatrix
    G: sympy.ImmutableMatrix
    E: sympy.ImmutableMatrix
    A: sympy.ImmutableMatrix
    B: sympy.ImmutableMatrix
    B_rate: sympy.ImmutableMatrix
    symbols: Mapping[str, sympy.Symbol]
    preloads: Mapping[str, sympy.Symbol]
    equilibrium: tuple[sympy.Eq, ...]

    @property
    def formulas(self) -> dict[sympy.Symbol, sympy.Expr]:
        """The formula of each preload, where statics alone tells them all; replacing them cancels what they balance."""
        loads = set(self.preloads.values())
        return {equation.lhs: equation.rhs for equation in self.equilibrium if equation.lhs in loads}

    def numbers(self, matrix: sympy.Matrix, assembly: Assembly | None = None) -> Array:
        """The entries of a matrix of these symbols as floats, parameters and preloads as at the trim.

        Or as in another *assembly* of the same vehicle with other values of its parameters. Raises `EomError` if that
        one has other independent coordinates, or carries a load that was taken for zero here.
        """
        if assembly is not None:
            self.check_same_structure(assembly)
        point = self.point(assembly or self.numeric)
        entries = [float(entry.xreplace(point).evalf(20)) for entry in matrix]
        return np.array(entries).reshape(matrix.shape)

    def check_same_structure(self, other: Assembly) -> None:
        """Raise `EomError` unless these matrices are those of another assembly too."""
        if other.pivots != self.numeric.pivots:
            message = "with these values other coordinates are independent: assemble its symbols anew"
            raise EomError(f"{other.vehicle.file}: {message}")
        statics = other.matrices.statics
        given = [item.preload is not None for item in elastic_items(other.system) for _ in item.rows]
        names = (
            *other.constraint_rows,
            *(name for name, known in zip(other.elastic_rows, given, strict=True) if not known),
        )
        loads = np.concatenate([statics.reactions, statics.tensions[~np.array(given, dtype=bool)]])
        lost = [
            name
            for name, carries in zip(names, significant(statics, loads), strict=True)
            if carries and f"{name}.preload" not in self.preloads
        ]
        if lost:
            message = f"{', '.join(lost[:3])} carry a load with these values, but none at the trim of the symbols"
            raise EomError(f"{other.vehicle.file}: {message}: assemble them at these values")

    def point(self, assembly: Assembly) -> dict[sympy.Symbol, sympy.Rational]:
        """What the symbols stand for in an assembly of the same vehicle."""
        values = {symbol: assembly.vehicle.values[name] for name, symbol in self.symbols.items()}
        statics = assembly.matrices.statics
        loads = [f"{name}.preload" for name in (*assembly.constraint_rows, *assembly.elastic_rows)]
        known = dict(zip(loads, (*statics.reactions, *statics.tensions), strict=True))
        known |= {f"{name}.settling": x for name, x in zip(assembly.coordinates, statics.deflection, strict=True)}
        values |= {symbol: known[name] for name, symbol in self.preloads.items()}
        return {symbol: sympy.Rational(repr(float(value))) for symbol, value in values.items()}


def assemble_symbols(vehicle: Vehicle, names: Sequence[str] | str) -> SymbolicAssembly:
    """Assemble a vehicle's matrices with symbols for some of its parameters, or for ``"all"``; see `assemble`."""
    refuse_numeric_parts(vehicle)
    numeric = assemble(vehicle)
    symbols = chosen_symbols(vehicle, names)
    leaves = traced_parameters(vehicle, symbols)
    functions = cast("Mapping[str, Callable[[float], float]]", {name: function(name) for name in FUNCTIONS})
    system = cast(
        "System",
        with_entries(vehicle.draft.system(), lambda entry, _: exact(compute(entry, leaves, functions))),
    )
    balance = SymbolicBalance(
        numeric.matrices.statics, numeric.constraint_rows, numeric.elastic_rows, numeric.coordinates
    )
    matrices = assemble_matrices(system, numeric.pivots, EXACT, balance)
    return SymbolicAssembly(
        numeric,
        **canonical_matrices(matrices),
        symbols=symbols,
        preloads={name: own.expression for name, own in balance.symbols.items()},
        equilibrium=tuple(balance.equations),
    )


def canonical_matrices(matrices: Matrices) -> dict[str, sympy.ImmutableMatrix]:
    """Traced matrices, and the reduced equations that they give, as matrices of expressions."""
    reduction = matrices.reduction
    traced_ones = {name: getattr(matrices, name) for name in FULL}
    traced_ones |= {name: getattr(reduction, name) for name in REDUCTION}
    field = rational_field(traced_ones.values())
    exact_ones = {name: field.elements(matrix) for name, matrix in traced_ones.items()}
    T, W, Z = (exact_ones.pop(name) for name in REDUCTION)
    in_field = Matrices(**{**matrices._asdict(), **exact_ones, "reduction": reduction._replace(T=T, W=W, Z=Z)})
    reduced = descriptor_of(in_field)
    results = {**exact_ones, **reduced._asdict()}
    return {
        name: sympy.ImmutableMatrix(*matrix.shape, field.expressions(matrix).ravel().tolist())
        for name, matrix in results.items()
    }


def chosen_symbols(vehicle: Vehicle, names: Sequence[str] | str) -> dict[str, sympy.Symbol]:
    """A symbol for each named parameter; for ``"all"`` of those that are numbers and not zero."""
    registry = vehicle.draft.registry
    if names == "all":
        plain = [name for name, live in registry.parameters.items() if isinstance(live.default, Number)]
        names = [name for name in plain if vehicle.values[name] != 0.0]
    names = [names] if isinstance(names, str) else [str(name) for name in names]
    unknown = [name for name in names if name not in registry.parameters]
    if unknown:
        sentences = [f"no symbol for '{name}': {why_unknown(name, registry)}" for name in unknown]
        raise DescriptionError([Mistake(vehicle.file, 0, 0, "", what) for what in sentences])
    return {name: sympy.Symbol(name) for name in names}


def traced_parameters(vehicle: Vehicle, symbols: Mapping[str, sympy.Symbol]) -> dict[str, float]:
    """Every parameter as a traced number, typed as the number that it stands for."""
    live = vehicle.draft.registry.parameters
    functions = cast("Mapping[str, Callable[[float], float]]", {name: function(name) for name in FUNCTIONS})
    order, _ = in_order({name: list(parameter_names(item.default)) for name, item in live.items()})
    leaves: dict[str, float] = {}
    for name in order:
        if name in symbols:
            leaves[name] = cast("float", Traced(vehicle.values[name], symbols[name]))
        else:
            leaves[name] = cast("float", exact(compute(live[name].default, leaves, functions)))
    return leaves


def refuse_numeric_parts(vehicle: Vehicle) -> None:
    """Raise for membranes, found by eigenvalues and least squares, and for wheels, whose tyres' slopes are numbers."""
    what = "has no symbolic form, as no membrane has: leave it out, or take the matrices as numbers"
    mistakes = [vehicle.mistake(item.name, what) for item in vehicle.system.triangles]
    if wheels_alone(vehicle.system):
        what = (
            "has no symbolic form: slopes of its tyre at the trim are numbers; give axles linear tyres without wheels"
        )
        mistakes.append(vehicle.mistake(vehicle.system.wheels[0].axle, what))
    if mistakes:
        raise DescriptionError(mistakes)
