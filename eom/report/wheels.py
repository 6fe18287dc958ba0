"""What ``eom check`` prints of a vehicle with wheels: their loads, slips and forces at the trim."""

import textwrap
from collections.abc import Iterator

import numpy as np

from eom.report.table import table
from eom.splice.closure import slopes_at_trim
from eom.splice.prepare import Prepared, input_names
from eom.splice.signals import output_names, spliced_states
from eom.splice.trim import loads_at_rest
from eom.vehicle.elements import Wheel

ALPHA, KAPPA, FX, FY = 0, 1, 0, 1
ASTRAY = 1e-3
"""Distance [m] of a support from the middle of its axles that nobody means."""


def wheel_tables(prepared: Prepared) -> Iterator[str]:
    """Loads and stiffnesses of one wheel of each axle, and how the trim is driven."""
    system, trim = prepared.system, prepared.trim
    slopes, at_rest = slopes_at_trim(prepared), loads_at_rest(system, prepared.pivots)
    shown = [k for k, wheel in enumerate(system.wheels) if k == 0 or system.wheels[k - 1].axle != wheel.axle]
    yield table(
        (
            "each wheel of",
            "at rest [N]",
            "load [N]",
            "slip [%]",
            "force x [N]",
            "cornering [N/rad]",
            "slip stiffness [N]",
        ),
        (
            (
                system.wheels[k].axle,
                f"{at_rest[k] / number:.1f}",
                f"{trim.load[k] / number:.1f}",
                f"{100.0 * trim.slip[k] + 0.0:.3f}",
                f"{trim.forces[0, k] / number + 0.0:.1f}",
                f"{-slopes[ALPHA, FY, k] / number:.0f}",
                f"{slopes[KAPPA, FX, k] / number:.0f}" if system.wheels[k].spin_inertia else "-",
            )
            for k, number in ((k, system.wheels[k].number) for k in shown)
        ),
    )
    if any(wheel.drive_share for wheel in system.wheels) and not prepared.model.body.held:
        yield f"drive torque that holds the speed: {trim.torque + 0.0:.1f} N m"
    notes = "\n".join(remarks(prepared))
    if notes:
        yield notes
    different = uneven(prepared)
    if different:
        yield f"fitted at the mean load of the wheels that have it, which differ: tyre {', '.join(different)}"


def remarks(prepared: Prepared) -> Iterator[str]:
    """What a reader of the loads should know of them."""
    system = prepared.system
    no_transfer = dict.fromkeys(wheel.axle for wheel in system.wheels if wheel.support and not wheel.roll_rate)
    if no_transfer:
        text = f"no load goes from left to right, without track and roll stiffness: {', '.join(no_transfer)}"
        yield textwrap.fill(text, 100)
    places = {item.connection.name: item.connection.places[0][0] for item in system.constraints}
    for support in dict.fromkeys(wheel.support for wheel in system.wheels if wheel.support):
        axles = [wheel.place[0] for wheel in system.wheels if wheel.support == support]
        ahead = places[support] - float(np.mean(axles))
        if abs(ahead) > ASTRAY:
            where = "ahead of" if ahead > 0.0 else "behind"
            yield f"{support} stands {abs(ahead):.3g} m {where} the middle of its axles, which share its load equally"
    for wheel, load in zip(system.wheels, prepared.trim.load, strict=True):
        law = system.tyres[wheel.tyre]
        if law.kind == "tir":
            least, most = load_range(prepared, wheel)
            if not least <= load <= most:
                yield f"{wheel.name} carries {load:.0f} N, but {law.name} is measured from {least:g} to {most:g} N"


def load_range(prepared: Prepared, wheel: Wheel) -> tuple[float, float]:
    """Least and greatest load [N] for which a tyre of a file is measured."""
    at = prepared.system.wheels.index(wheel)
    for group in prepared.model.laws:
        if at in group.wheels:
            return float(np.min(group.tyre.FZMIN)), float(np.max(group.tyre.FZMAX))
    return 0.0, np.inf


def signals_of(prepared: Prepared) -> tuple[list[str], int, int]:
    """Names of the states, numbers of inputs and outputs of the nonlinear model."""
    names = [name for name, _ in spliced_states(prepared)]
    return names, len(input_names(prepared.system)), len(output_names(prepared.system))


def uneven(prepared: Prepared) -> list[str]:
    """Tyre laws that stand under different loads, so that they meet their stiffnesses at none of them."""
    names = []
    for k, law in enumerate(prepared.system.tyres):
        loads = [
            load / wheel.number
            for load, wheel in zip(prepared.trim.load, prepared.system.wheels, strict=True)
            if wheel.tyre == k
        ]
        if law.kind == "magic_formula" and np.ptp(loads) > 1e-3 * np.mean(loads):
            names.append(law.name)
    return names
