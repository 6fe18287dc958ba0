"""Preloads as symbols: what joints and springs carry at the trim, and the equations that say how much it is.

Where statics alone tells every load, each has its formula, ``load = ...``. Elsewhere the equations are implicit and
linear: the balance of every body's forces and moments; the law of each spring, whose ends have settled by
``coordinate.settling`` from where they carry nothing; and for joints that repeat each other the demand that their
loads against each other vanish.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import sympy
from numpy.typing import NDArray

from eom.assembly.algebra import Algebra, block_diagonal
from eom.assembly.elastic import Strained
from eom.assembly.pivots import pivoted_elimination
from eom.assembly.reduction import Pivots, Reduction
from eom.assembly.statics import Statics, self_stresses
from eom.assembly.vectors import Array
from eom.model.field import EXACT, canonical, shaped
from eom.model.traced import Traced, expression_of, value_of, values
from eom.vehicle.elements import Body

# of the largest load: what rounding leaves of none
NEGLIGIBLE = 1e-9


class Unsolved(NamedTuple):
    """What an equilibrium is made of: f + J' reactions + H' tensions = 0 with traced numbers.

    ``given`` holds the tensions that the file gives and zeros, ``carries`` the rows of H whose tension is unknown,
    ``stiffness`` that of all rows.
    """

    f: Array
    J: Array
    pivots: Pivots
    reduction: Reduction
    H: Array
    given: Array
    carries: list[int]
    stiffness: Array


@dataclass
class SymbolicBalance:
    """Gives the loads of a solved equilibrium symbols, in place of `eom.assembly.statics.equilibrium`.

    Attributes
    ----------
    solved : Statics
        The equilibrium in numbers.
    joints, springs, coordinates : sequence of str
        Names of its rows and of the bodies' coordinates.
    symbols : dict of str to Traced
        Filled with the loads, and with the settling of coordinates where the equations need it.
    equations : list of sympy.Eq
        Filled with their equations.
    """

    solved: Statics
    joints: Sequence[str]
    springs: Sequence[str]
    coordinates: Sequence[str]
    symbols: dict[str, Traced] = field(default_factory=dict)
    equations: list[sympy.Eq] = field(default_factory=list)

    def __call__(
        self,
        bodies: Sequence[Body],  # noqa: ARG002  the arguments are those of `equilibrium`
        elastic: tuple[Sequence[Strained], Array],
        constraints: tuple[Array, Pivots, Reduction],
        loads: tuple[Array, Array],
        algebra: Algebra,
    ) -> Statics:
        """The equilibrium with symbols for its loads; arguments as of `eom.assembly.statics.equilibrium`."""
        items, H = elastic
        stiffness = block_diagonal([item.stiffness for item in items], algebra)
        carries, given, free = carrying_rows(items), given_tensions(items), constraints[2].T
        if not np.any(canonical(free.T @ (loads[0] + H.T @ given)) != 0):
            # no load reaches the springs, whatever the values
            carries = []
        unsolved = Unsolved(loads[0], *constraints, H, given, carries, stiffness)
        separate = all(np.array_equal(item.stiffness, np.diag(np.diag(item.stiffness))) for item in items)
        told_by_statics = (self.solved.determinate and separate) or not carries
        explicit = told_by_statics and not np.any(self.solved.indefinite)
        reactions, tensions = self.explicit(unsolved) if explicit else self.implicit(unsolved)
        return self.solved._replace(reactions=reactions, tensions=tensions)

    def explicit(self, unsolved: Unsolved) -> tuple[Array, Array]:
        """Symbols of the loads, each with its formula."""
        f, J, pivots, reduction, H, given, carries, _ = unsolved
        free, tensions = reduction.T, given.copy()
        if carries:
            work = free.T @ H[carries].T
            chosen, _ = pivoted_elimination(values(work), np.ones(len(carries)))
            tensions[carries] = -EXACT.factor(work[chosen]).solve(free.T[chosen] @ (f + H.T @ given))
        reactions = np.full(len(J), 0.0, dtype=object)
        if reduction.factor is not None:
            wanted = -(f + H.T @ tensions)[list(pivots.dependent)]
            reactions[list(pivots.rows)] = reduction.factor.solve_transposed(wanted)
        named = given.copy()
        named[carries] = self.named([self.springs[k] for k in carries], tensions[carries])
        return self.named(self.joints, reactions), named

    def named(self, names: Sequence[str], formulas: Array) -> Array:
        """Loads with a symbol in place of each formula that is not zero."""
        entries: list[object] = []
        for name, formula, own in zip(names, canonical(formulas), formulas, strict=True):
            entries.append(0.0)
            if formula != 0:
                entries[-1] = self.symbol(f"{name}.preload", value_of(own))
                self.equations.append(sympy.Eq(expression_of(entries[-1]), formula))
        return shaped(entries, formulas.shape)

    def implicit(self, unsolved: Unsolved) -> tuple[Array, Array]:
        """Symbols of the loads that are not zero at the trim, with equations that they satisfy together."""
        f, J, pivots, reduction, H, given, carries, stiffness = unsolved
        reactions = self.unknown(self.joints, self.solved.reactions, self.significant(self.solved.reactions))
        tensions, own = given.copy(), self.solved.tensions[carries]
        tensions[carries] = self.unknown([self.springs[k] for k in carries], own, self.significant(own))
        at = reduction.independent
        deflection = self.solved.deflection[at]
        moved = np.abs(deflection) > NEGLIGIBLE * np.max(np.abs(deflection), initial=0.0)
        settled = self.unknown([self.coordinates[k] for k in at], deflection, moved & bool(carries), "settling")
        balance = f + J.T @ reactions + H.T @ tensions
        law = (tensions - given + stiffness @ (H @ (reduction.T @ settled)))[carries]
        against_each_other = self_stresses(J, pivots, reduction).T @ reactions
        for expression in canonical(np.concatenate([balance, law, against_each_other])):
            if expression != 0:
                self.equations.append(sympy.Eq(expression, 0))
        return reactions, tensions

    def significant(self, loads: Array) -> NDArray[np.bool_]:
        """Which loads are not zero at the trim."""
        return significant(self.solved, loads)

    def unknown(self, names: Sequence[str], numbers: Array, chosen: NDArray[np.bool_], kind: str = "preload") -> Array:
        """Symbols of the chosen ones of some quantities, zeros for the others."""
        entries = [
            self.symbol(f"{name}.{kind}", number) if wanted else 0.0
            for name, number, wanted in zip(names, numbers, chosen, strict=True)
        ]
        return shaped(entries, (len(names),))

    def symbol(self, name: str, value: float) -> Traced:
        """The symbol of a load or a settling."""
        self.symbols[name] = Traced(value, sympy.Symbol(name))
        return self.symbols[name]


def significant(solved: Statics, loads: Array) -> NDArray[np.bool_]:
    """Which loads are not zero beside the largest one of an equilibrium."""
    largest = np.max(np.abs(np.concatenate([solved.reactions, solved.tensions])), initial=0.0)
    return np.asarray(np.abs(loads) > NEGLIGIBLE * largest)


def given_tensions(items: Sequence[Strained]) -> Array:
    """Tensions that the file gives, zero elsewhere, one per elastic row."""
    entries = [0.0 if item.preload is None else item.preload for item in items for _ in item.rows]
    return shaped(entries, (len(entries),))


def carrying_rows(items: Sequence[Strained]) -> list[int]:
    """Elastic rows that can carry a load which is not given; dampers carry none."""
    able = [item.preload is None and bool(np.any(row)) for item in items for row in item.stiffness]
    return [k for k, carries in enumerate(able) if carries]
