"""What a picture of a run shows: panels of curves that belong together."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.channels import STATE, Channels, owner_and_quantity

LEFT, RIGHT = ".left.Fz", ".right.Fz"
COVERED = 0.004
"""Share of a panel's height that a line covers."""
LISTED = 3


class Curve(NamedTuple):
    """A line, or two for left and right: its label, values (n, 1) or (n, 2), the number of the unit that it is of."""

    label: str
    values: Array
    unit: int | None = None


class Panel(NamedTuple):
    """Curves of one unit of measure under one heading."""

    title: str
    measure: str
    curves: tuple[Curve, ...]


NOTHING = 1e-9
"""Size in SI units below which a curve is rounding of none."""


def asked_panels(signals: Channels, names: Iterable[str]) -> list[Panel]:
    """The named signals, a panel for each unit of measure, in the order in which these come."""
    return by_measure(signals, [signals.names.index(name) for name in names])


def usual_panels(inputs: Channels, outputs: Channels) -> list[Panel]:
    """What one looks at first, as far as it is there; see `eom.simulation.Run.plot`."""
    changing = np.flatnonzero(np.any(inputs.values != inputs.values[:1], axis=0))
    acting = np.flatnonzero(np.any(inputs.values != 0.0, axis=0))
    shown = by_measure(inputs, changing if changing.size else acting, "input")
    units = units_in(outputs)
    if units:
        found = [
            panel_of(outputs, units, "ay", "m/s^2", "lateral acceleration", whole=True),
            panel_of(outputs, units, "yaw_rate", "rad/s", "yaw rate"),
            panel_of(outputs, units, "articulation", "rad", "articulation"),
            panel_of(outputs, units, "roll", "rad", "roll"),
            load_panel(outputs) or panel_of(outputs, units, "ltr", "", "load transfer ratio", whole=True),
            panel_of(outputs, units, "speed", "m/s", "speed"),
        ]
        shown += [panel for panel in found if panel is not None]
    else:
        # a suspension or a mechanism: only its author knows what its sensors are for
        shown += by_measure(outputs, range(len(outputs.names)))
    return [covered(panel) for panel in shown]


def by_measure(signals: Channels, chosen: Iterable[int], title: str = "") -> list[Panel]:
    """Chosen signals, a panel for each unit of measure under their quantity if they share one, else under *title*."""
    groups: dict[str, list[int]] = {}
    for k in chosen:
        groups.setdefault(signals.units[k], []).append(k)
    panels = []
    for measure, group in groups.items():
        names = [signals.names[k] for k in group]
        quantities = {owner_and_quantity(name)[1].removeprefix(STATE) for name in names}
        shared = quantities.pop().replace("_", " ") if len(quantities) == 1 else title
        curves = [Curve(name, signals.values[:, [k]]) for name, k in zip(names, group, strict=True)]
        panels.append(Panel(shared, measure, tuple(curves)))
    return panels


def units_in(outputs: Channels) -> tuple[str, ...]:
    """The vehicle's units, which alone have a yaw rate or a speed; empty where nothing has."""
    owners = (owner_and_quantity(name) for name in outputs.names)
    return tuple(dict.fromkeys(owner for owner, quantity in owners if owner and quantity in {"yaw_rate", "speed"}))


def panel_of(
    outputs: Channels, units: Sequence[str], quantity: str, measure: str, title: str, *, whole: bool = False
) -> Panel | None:
    """One quantity of all that have it, of *whole* units only if so; None if it stays zero or nothing has it."""
    curves = []
    for k, name in enumerate(outputs.names):
        owner, own = owner_and_quantity(name)
        if (own, outputs.units[k]) == (quantity, measure) and (owner in units or not whole):
            curves.append(Curve(owner or name, outputs.values[:, [k]], unit_of(owner, units)))
    moves = any(np.any(np.abs(curve.values) > NOTHING) for curve in curves)
    return Panel(title, measure, tuple(curves)) if moves else None


def unit_of(owner: str, units: Sequence[str]) -> int | None:
    """Number of the unit that an object is, or is called after: ``semitrailer_1_frame``; None if of none."""
    of = [k for k, unit in enumerate(units) if owner == unit or owner.startswith(f"{unit}_")]
    return max(of, key=lambda k: len(units[k]), default=None)


def load_panel(outputs: Channels) -> Panel | None:
    """Loads of wheels, a curve of two lines for each axle; None if no axle has a left and a right one."""
    at = {name: k for k, name in enumerate(outputs.names)}
    axles = [name.removesuffix(LEFT) for name in at if name.endswith(LEFT)]
    curves = [
        Curve(axle, outputs.values[:, [at[axle + LEFT], at[axle + RIGHT]]]) for axle in axles if axle + RIGHT in at
    ]
    return Panel("wheel load", "N", tuple(curves)) if curves else None


def covered(panel: Panel) -> Panel:
    """The panel with curves that one line would cover drawn once, under all their names."""
    everything = np.hstack([curve.values for curve in panel.curves])
    finite = everything[np.isfinite(everything)]
    near = COVERED * float(np.ptp(finite)) if finite.size else 0.0
    groups: list[list[Curve]] = []
    for curve in panel.curves:
        alike = (g for g in groups if np.allclose(g[0].values, curve.values, rtol=0.0, atol=near, equal_nan=True))
        group = next(alike, None)
        if group is None:
            groups.append([curve])
        else:
            group.append(curve)
    return panel._replace(curves=tuple(group[0]._replace(label=common_label(group)) for group in groups))


def common_label(group: Sequence[Curve]) -> str:
    """The label of curves drawn as one."""
    labels = [curve.label for curve in group]
    return ", ".join(labels) if len(labels) <= LISTED else f"{labels[0]} and {len(labels) - 1} alike"
