"""Picture of a run: panels over a common time, limits that were reached as numbered lines."""

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.channels import Event
from eom.simulation.run_marks import TOLD, marked, told
from eom.simulation.run_panels import Curve, Panel

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

DEGREE = {"rad": "deg", "rad/s": "deg/s", "rad/s^2": "deg/s^2"}
KILO = {"N": "kN", "N*m": "kN*m", "Pa": "kPa"}
MANY = 1e4
"""From this value on forces, torques and pressures are told in thousands."""
HIGH, QUICK = 6, 50_000
"""Lines of a legend, and points of a panel among which a place is found for it quickly."""
STYLES = ("-", "--", ":", "-.")
COLOURS = 10
NARROW, WIDE, ROW, LINE = 7.5, 11.2, 2.1, 0.165
"""Sizes in inches: width of the figure with one column and with two, height of a panel, of a line of text."""
TITLE, TEXT = 9.5, 13.5
"""Characters that fit into an inch of the title, and of the text below."""


def draw(time: Array, panels: Sequence[Panel], events: Sequence[Event], title: str) -> "Figure":
    """The figure; it belongs to no window: save it by ``savefig``, or let a notebook show it."""
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    marks = marked(events, float(np.ptp(time)))
    columns, width = (1, NARROW) if len(panels) <= 3 else (2, WIDE)
    rows = max(-(-len(panels) // columns), 1)
    heading = [part for line in title.splitlines() for part in textwrap.wrap(line, int(TITLE * width))]
    lines = told(marks, int(TEXT * width))
    height = 0.4 + ROW * rows + LINE * (2 * len(heading) + len(lines))
    figure = Figure(figsize=(width, height), layout="constrained")
    cells = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for axes, panel in zip(cells.flat, panels, strict=False):
        draw_panel(axes, time, panel)
        for mark in marks:
            axes.axvline(mark[0].time, color="0.4", linewidth=0.7, zorder=1)
    for axes in cells[0]:
        for number, mark in enumerate(marks[:TOLD], 1):
            at = {"x": mark[0].time, "y": 1.02, "transform": axes.get_xaxis_transform()}
            axes.text(s=str(number), ha="center", fontsize="x-small", **at)
    for axes in cells[-1]:
        axes.set_xlabel("time [s]")
    if len(panels) % columns:
        cells[-1, -1].remove()
        cells[-2, -1].tick_params(labelbottom=True)
    figure.suptitle("\n".join(heading))
    if lines:
        figure.supxlabel("\n".join(lines), x=0.01, ha="left", fontsize="small")
    return figure


def draw_panel(axes: "Axes", time: Array, panel: Panel) -> None:
    """Curves of one panel, in the unit of measure it is told in."""
    factor, measure = told_in(panel)
    paired = any(curve.values.shape[1] == 2 for curve in panel.curves)
    for curve, (colour, style) in zip(panel.curves, looks(panel.curves), strict=True):
        left, *right = factor * curve.values.T
        axes.plot(time, left, style, color=colour, linewidth=1.3, label=curve.label)
        for values in right:
            axes.plot(time, values, "--", color=colour, linewidth=1.3)
    note = "\nright dashed" if paired else ""
    axes.set_ylabel(f"{panel.title} [{measure or '-'}]{note}".lstrip(), fontsize="small")
    # a place for the legend is looked for only where that is quick
    quick = time.size * len(panel.curves) <= QUICK
    columns = -(-len(panel.curves) // HIGH)
    axes.legend(fontsize="x-small", ncols=columns, loc="best" if quick else "upper right")
    axes.grid(alpha=0.3)
    axes.margins(x=0.0)


def looks(curves: Sequence[Curve]) -> list[tuple[str, str]]:
    """Colour and style of each curve: a unit has the same colour in every panel, its second body is dashed."""
    free = iter(sorted(set(range(len(curves) + COLOURS)) - {curve.unit for curve in curves if curve.unit is not None}))
    found: list[tuple[str, str]] = []
    for curve in curves:
        colour = f"C{(next(free) if curve.unit is None else curve.unit) % COLOURS}"
        before = sum(other == colour for other, _ in found)
        found.append((colour, STYLES[before % len(STYLES)]))
    return found


def told_in(panel: Panel) -> tuple[float, str]:
    """Factor and unit of measure in which a panel's values are told."""
    measure = panel.measure
    largest = max(float(np.max(np.abs(curve.values), initial=0.0)) for curve in panel.curves)
    factor = 1.0
    if measure in DEGREE:
        factor, measure = float(np.degrees(1.0)), DEGREE[measure]
    elif measure in KILO and largest >= MANY:
        factor, measure = 1e-3, KILO[measure]
    return factor, measure.replace("^2", "²").replace("*", "·")
