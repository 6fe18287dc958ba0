"""Curves over a common axis, one panel for each unit."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from eom.assembly.vectors import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def panels(
    x: Array,
    curves: Iterable[tuple[str, str, Array]],
    labels: tuple[str, str],
    scales: tuple[str, str] = ("linear", "linear"),
) -> "Figure":
    """Curves (name, unit, values) in panels by unit, in the order in which the units come.

    *labels* are the text of the common axis and the title, *scales* those of both axes. The figure belongs to no
    window: save it by ``savefig``, or let a notebook show it.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    groups: dict[str, list[tuple[str, Array]]] = {}
    for name, unit, values in curves:
        groups.setdefault(unit, []).append((name, values))
    figure = Figure(figsize=(7.5, 1.2 + 2.4 * max(len(groups), 1)), layout="constrained")
    grid = figure.subplots(max(len(groups), 1), 1, sharex=True, squeeze=False)[:, 0]
    for axes, (unit, group) in zip(grid, groups.items(), strict=False):
        for name, values in group:
            axes.plot(x, values, label=name)
        axes.set_ylabel(unit)
        axes.legend(fontsize="small")
        axes.grid(alpha=0.3)
        axes.set(xscale=scales[0], yscale=scales[1])
    if scales[0] == "log":
        grid[-1].xaxis.set_major_formatter("{x:g}")
    grid[0].set_title(labels[1])
    grid[-1].set_xlabel(labels[0])
    return figure
