"""What ``eom check`` prints of a vehicle with wheels: their loads, slips and forces at the trim."""

from collections.abc import Iterator

import numpy as np

from eom.report.table import table
from eom.splice.closure import slopes_at_trim
from eom.splice.prepare import Prepared, input_names
from eom.splice.signals import output_names, spliced_states
from eom.splice.trim import loads_at_rest

ALPHA, KAPPA, FX, FY = 0, 1, 0, 1


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
    if any(wheel.drive_share for wheel in system.wheels):
        yield f"drive torque that holds the speed: {trim.torque + 0.0:.1f} N m"
    different = uneven(prepared)
    if different:
        yield f"fitted at the mean load of the wheels that have it, which differ: tyre {', '.join(different)}"


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
