"""Root locus over one parameter, its roots tracked as branches."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from eom.analysis.family import Family, Node, check_values, family_of, nodes_at
from eom.analysis.tracking import Step, follow
from eom.assembly.vectors import Array
from eom.model.eigen import Complex
from eom.model.modes import Modes
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class RootLocus:
    """Roots of a model over the values of a parameter, each column of `branches` one branch.

    A branch is followed by its eigenvectors and its rate of change, with models between the values where these do not
    suffice; so branches of motions that know nothing of each other cross without change. Where roots meet and become
    others (a pair that becomes two real roots, two pairs that flutter) nothing tells which is which beyond. There the
    upper root of a pair and the larger of two real roots are one branch, by convention: a pair that becomes real
    and a pair again keeps its branches. Roots that avoid each other by less than the values and the models between them
    show are taken to cross.

    Attributes
    ----------
    parameter, unit, title : str
        The parameter's name, the unit of its values (SI if empty), the vehicle's name.
    values : Array
        Shape (values,).
    branches : Complex
        Roots, shape (values, branches) [1/s]; the exact zeros of cyclic coordinates come first.
    order : Array
        Which of each value's modes are the branches, shape (values, branches).
    nodes : tuple of Node
        The linear model and its modes at each value.
    steps : tuple of Step
        How the modes were followed from the first value to the last, values between included.
    family : callable
        Gives the linear model at a value.
    """

    parameter: str
    unit: str
    title: str
    values: Array
    branches: Complex
    order: Array
    nodes: tuple[Node, ...] = field(repr=False)
    steps: tuple[Step, ...] = field(repr=False)
    family: Family = field(repr=False, compare=False)

    @property
    def modes(self) -> tuple[Modes, ...]:
        """The modes at each value."""
        return tuple(node.modes for node in self.nodes)

    @property
    def unclear(self) -> tuple[tuple[float, float], ...]:
        """Intervals in which roots were not recognised, so that their branches are a guess beyond."""
        return tuple((item.one.value, item.two.value) for item in self.steps if not item.clear)

    def plot(self) -> "Figure":
        """The branches in the complex plane, coloured by the parameter, and their real parts over it."""
        from eom.analysis.locus_plot import plot_locus  # noqa: PLC0415  draws with what is slow to import

        return plot_locus(self)


def root_locus(vehicle: Vehicle, parameter: str, values: Sequence[float], unit: str = "") -> RootLocus:
    """Roots of a vehicle over a parameter, as branches.

    Parameters
    ----------
    vehicle : Vehicle
    parameter : str
        A declared parameter, or a literal as ``object.quantity``.
    values : sequence of float
        Rising or falling.
    unit : str
        Of the values, such as ``"km/h"``; SI if empty.

    Raises
    ------
    AnalysisError
        If the values do not go one way, or the number of states changes between them.
    EomError
        As `eom.linearise`, at the first value that the vehicle refuses.
    """
    check_values(parameter, values)
    family = family_of(vehicle, parameter, unit)
    return locus_of(family, nodes_at(family, values), parameter, unit, vehicle.name)


def locus_of(
    family: Family, nodes: Sequence[Node], parameter: str = "parameter", unit: str = "", title: str = ""
) -> RootLocus:
    """The locus of models that are there already; further ones are asked of the *family*."""
    orders, steps = follow(family, nodes)
    return RootLocus(
        parameter=parameter,
        unit=unit,
        title=title,
        values=np.array([node.value for node in nodes]),
        branches=np.array([node.modes.eigenvalues[order] for node, order in zip(nodes, orders, strict=True)]),
        order=np.array(orders),
        nodes=tuple(nodes),
        steps=tuple(steps),
        family=family,
    )
