"""Picture of a stability map."""

from typing import TYPE_CHECKING

import numpy as np

from eom.analysis.maps import StabilityMap
from eom.errors import AnalysisError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEVELS = 14


def plot_map(result: StabilityMap) -> "Figure":
    """Contours of the rightmost real part and of the least damping ratio, the border of stability as a thick line.

    Raises `AnalysisError` for a map without two values along each parameter, which has no contours.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    if min(result.rightmost.shape) < 2:
        shape = " by ".join(map(str, result.rightmost.shape))
        raise AnalysisError(f"map of {result.title}: contours need two values along each parameter, it has {shape}")
    figure = Figure(figsize=(11.0, 4.8), layout="constrained")
    panels = (
        ("largest real part [1/s]", result.rightmost, "coolwarm"),
        ("least damping ratio", result.damping, "viridis"),
    )
    x, y = np.asarray(result.first.values), np.asarray(result.second.values)
    for axes, (label, values, colours) in zip(figure.subplots(1, 2), panels, strict=True):
        if np.any(np.isfinite(values)):
            limit = float(np.nanmax(np.abs(values))) or 1.0
            span = {"vmin": -limit, "vmax": limit} if values is result.rightmost else {}
            filled = axes.contourf(x, y, values.T, levels=LEVELS, cmap=colours, **span)
            figure.colorbar(filled, label=label)
        else:
            axes.text(0.5, 0.5, "nothing oscillates", transform=axes.transAxes, ha="center")
        known = result.rightmost[np.isfinite(result.rightmost)]
        if np.any(known <= 0.0) and np.any(known > 0.0):
            axes.contour(x, y, result.rightmost.T, levels=[0.0], colors="black", linewidths=2.5)
            axes.plot([], [], color="black", linewidth=2.5, label="border of stability")
            axes.legend(fontsize="small", loc="upper right")
        axes.set(xlabel=result.first.label, ylabel=result.second.label)
    figure.suptitle(f"{result.title}: stability")
    return figure
