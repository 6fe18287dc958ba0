"""The usual pictures of a tyre, as numbers: forces over slip for several loads, and the friction ellipse."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from eom.tyre.interface import Forces, Tyre
from eom.tyre.parameters import Values
from eom.tyre.usual_range import inside, range_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = np.ndarray[Any, Any]

POINTS = 161
LOADS = (0.25, 0.5, 1.0, 1.5, 2.0)
"""Loads over the nominal one."""
ELLIPSE = (0.0, 1.0, 2.0, 4.0, 8.0, 15.0)
"""Slip angles [deg] of the friction ellipse, to both sides."""


class Sweep(NamedTuple):
    """Forces and moments over one slip, a row for each curve; all arrays have the shape (curves, points)."""

    alpha: Array
    kappa: Array
    Fz: Array
    forces: Forces


@dataclass(frozen=True)
class Carpet:
    """Curves of an upright tyre at 60 km/h.

    Attributes
    ----------
    title : str
        Name of the tyre.
    side : Sweep
        Over the slip angle, without longitudinal slip, a curve for each load.
    drive : Sweep
        Over longitudinal slip, without slip angle, a curve for each load.
    ellipse : Sweep
        Over longitudinal slip at nominal load, a curve for each slip angle.
    """

    title: str
    side: Sweep
    drive: Sweep
    ellipse: Sweep

    def plot(self) -> "Figure":
        """Fy over slip angle, Fx over slip, friction ellipse and Mz over slip angle: a panel for each that acts."""
        from matplotlib.figure import Figure  # noqa: PLC0415  slow to import

        panels = list(self.panels())
        rows = (len(panels) + 1) // 2
        figure = Figure(figsize=(11.0, 4.0 * rows), layout="constrained")
        for k, panel in enumerate(panels):
            axes = figure.add_subplot(rows, min(2, len(panels)), k + 1)
            draw(axes, panel)
        figure.suptitle(f"{self.title}, upright, at 60 km/h")
        return figure

    def panels(self) -> Iterator["Panel"]:
        """What is drawn; forces that are zero everywhere are not."""
        corners, drives = (bool(np.any(force)) for force in (self.side.forces.Fy, self.drive.forces.Fx))
        degrees, loads = np.rad2deg(self.side.alpha), loads_of(self.side)
        if corners:
            yield Panel(degrees, self.side.forces.Fy * KILO, "slip angle [deg]", "Fy [kN]", "load", loads)
        if drives:
            Fx = self.drive.forces.Fx * KILO
            yield Panel(self.drive.kappa, Fx, "longitudinal slip", "Fx [kN]", "load", loads_of(self.drive))
        if corners and drives:
            angles = [f"±{abs(angle):.3g}°" if angle else "0°" for angle in np.rad2deg(self.ellipse.alpha[:, 0])]
            load = f"at {self.ellipse.Fz[0, 0] * KILO:.3g} kN load [kN]"
            Fx, Fy = self.ellipse.forces.Fx * KILO, self.ellipse.forces.Fy * KILO
            yield Panel(Fx, Fy, f"Fx {load}", f"Fy {load}", "slip angle", angles, "equal")
        if corners:
            yield Panel(degrees, self.side.forces.Mz, "slip angle [deg]", "Mz [N m]", "load", loads)


KILO = 1e-3


class Panel(NamedTuple):
    """Curves of one panel, a row each, and its words; curves of one label have one colour."""

    x: Values
    y: Values
    abscissa: str
    ordinate: str
    legend: str
    labels: list[str]
    aspect: Literal["auto", "equal"] = "auto"


def draw(axes: "Axes", panel: Panel) -> None:
    """Draw a panel."""
    labels = panel.labels
    colours = {label: f"C{k % 10}" for k, label in enumerate(dict.fromkeys(labels))}
    for k, (abscissae, ordinates) in enumerate(zip(np.asarray(panel.x), np.asarray(panel.y), strict=True)):
        label = labels[k] if labels[k] not in labels[:k] else None
        axes.plot(abscissae, ordinates, label=label, color=colours[labels[k]], linewidth=1.2)
    axes.axhline(0.0, color="0.6", linewidth=0.6, zorder=0)
    axes.axvline(0.0, color="0.6", linewidth=0.6, zorder=0)
    axes.grid(alpha=0.3)
    axes.set(xlabel=panel.abscissa, ylabel=panel.ordinate, aspect=panel.aspect)
    axes.legend(
        title=panel.legend, fontsize="small", title_fontsize="small", loc="center left", bbox_to_anchor=(1, 0.5)
    )


def loads_of(sweep: Sweep) -> list[str]:
    """Labels of curves over load."""
    return [f"{load * KILO:.3g} kN" for load in sweep.Fz[:, 0]]


# coefficients beyond all sense divide by zero: such a force is no number
@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def carpet(tyre: Tyre, title: str = "") -> Carpet:
    """Curves of one tyre within its range, as far as that is usual.

    Loads are 0.25, 0.5, 1, 1.5 and 2 of the nominal one, slip angles of the friction ellipse 0, 1, 2, 4, 8 and 15
    degrees to both sides, those of them that the tyre's range has.
    """
    where = range_of(tyre)
    loads = inside(where.nominal * np.array(LOADS), where.Fz)
    degrees = np.array(ELLIPSE)
    angles = inside(np.deg2rad(np.concatenate([-degrees[:0:-1], degrees])), where.alpha)
    alpha, kappa = (spread(ends) for ends in (where.alpha, where.kappa))
    return Carpet(
        title,
        sweep(tyre, alpha, 0.0, loads[:, np.newaxis]),
        sweep(tyre, 0.0, kappa, loads[:, np.newaxis]),
        sweep(tyre, angles[:, np.newaxis], kappa, where.nominal),
    )


def spread(ends: tuple[float, float]) -> Array:
    """Slips from end to end, closer about zero, where curves are steep."""
    t = np.linspace(-1.0, 1.0, POINTS)
    t = 0.2 * t + 0.8 * t**3
    return np.where(t < 0.0, -t * ends[0], t * ends[1])


def sweep(tyre: Tyre, alpha: Values, kappa: Values, Fz: Values) -> Sweep:
    """Forces where all three arguments are combined."""
    slips = np.broadcast_arrays(alpha, kappa, Fz)
    return Sweep(slips[0], slips[1], slips[2], tyre.forces(*slips))
