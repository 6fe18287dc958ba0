"""Picture of modes."""

from typing import TYPE_CHECKING

import numpy as np

from eom.model.modes import Modes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot_modes(modes: Modes) -> "Figure":
    """Roots in the upper half of the complex plane, numbered, and the share of each state in each of them."""
    from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

    shown = np.flatnonzero((modes.eigenvalues.imag >= 0.0) & (modes.eigenvalues != 0.0))
    roots = modes.eigenvalues[shown]
    figure = Figure(figsize=(11.0, 2.5 + 0.2 * len(modes.states)), layout="constrained")
    plane, shares = figure.subplots(1, 2)
    plane.axvline(0.0, color="black", linewidth=0.8)
    plane.scatter(roots.real, roots.imag, s=25, zorder=2)
    numbers = [str(k + 1) for k in shown]
    for number, value in zip(numbers, roots, strict=True):
        plane.annotate(number, (value.real, value.imag), xytext=(4, 4), textcoords="offset points", fontsize=8)
    plane.set(xlabel="real part [1/s]", ylabel="imaginary part [rad/s]")
    plane.set_ylim(bottom=-0.05 * float(np.max(roots.imag, initial=1e-9)))
    plane.grid(alpha=0.3)
    image = shares.imshow(modes.participation[:, shown], aspect="auto", cmap="Blues", vmin=0.0, vmax=1.0)
    shares.set_xticks(range(len(shown)), numbers)
    shares.set_yticks(range(len(modes.states)), modes.states, fontsize=7)
    shares.set_xlabel("mode")
    figure.colorbar(image, label="participation")
    return figure
