"""Picture of a root locus."""

from typing import TYPE_CHECKING

import numpy as np

from eom.analysis.locus import RootLocus

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# roots further left than this many times the fastest oscillation would hide the others
FAR = 1.5


def plot_locus(locus: RootLocus) -> "Figure":
    """Upper half of the complex plane with a line for each branch, and the branches' real parts over the parameter."""
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    # the exact zeros of cyclic coordinates would look like a stability limit
    roots = locus.branches[:, np.any(locus.branches != 0.0, axis=0)]
    label = f"{locus.parameter} [{locus.unit}]" if locus.unit else locus.parameter
    span = max(FAR * float(np.max(np.abs(roots.imag), initial=0.0)), 2.0 * float(np.max(roots.real, initial=0.0)), 1e-9)
    left = max(float(np.min(roots.real, initial=0.0)), -span)
    figure = Figure(figsize=(11.0, 4.8), layout="constrained")
    plane, real = figure.subplots(1, 2)
    upper = np.where(roots.imag >= 0.0, roots, np.nan)
    plane.plot(upper.real, upper.imag, color="0.75", linewidth=0.8, zorder=1)
    points = plane.scatter(
        upper.real, upper.imag, c=np.broadcast_to(locus.values[:, np.newaxis], upper.shape), s=9, cmap="viridis"
    )
    plane.axvline(0.0, color="black", linewidth=0.8)
    right = max(float(np.max(roots.real, initial=0.0)), 0.0)
    plane.set_xlim(left - 0.05 * (right - left) - 1e-9, right + 0.05 * (right - left) + 1e-9)
    hidden = int(np.sum(np.min(roots.real, axis=0) < left))
    note = f"\n(reaching further left: {hidden} of {roots.shape[1]} roots)" if hidden else ""
    plane.set(xlabel=f"real part [1/s]{note}", ylabel="imaginary part [rad/s]")
    figure.colorbar(points, label=label)
    lines = np.where(roots.imag >= 0.0, roots.real, np.nan)
    real.plot(locus.values, roots.real, color="0.75", linewidth=0.8)
    real.plot(locus.values, np.where(upper.imag > 0.0, lines, np.nan), color="tab:blue", linewidth=1.4)
    real.plot(locus.values, np.where(upper.imag == 0.0, lines, np.nan), color="tab:orange", linewidth=1.4)
    real.plot([], [], color="tab:blue", label="oscillation")
    real.plot([], [], color="tab:orange", label="real root")
    real.axhline(0.0, color="black", linewidth=0.8)
    real.set_ylim(plane.get_xlim())
    real.set(xlabel=label, ylabel="real part [1/s]")
    real.legend(fontsize="small")
    for axes in (plane, real):
        axes.grid(alpha=0.3)
    figure.suptitle(f"{locus.title}: root locus")
    return figure
