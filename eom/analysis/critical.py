"""Values of a parameter at which a model becomes unstable or stable."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from eom.analysis.crossings import Crossing, crossings
from eom.analysis.locus import RootLocus, root_locus
from eom.analysis.stability import sides
from eom.errors import AnalysisError
from eom.model.modes import Modes
from eom.vehicle.load import Vehicle

# values of the first locus
POINTS = 33
# of a value: what is as good as the same
TOLERANCE = 1e-9
# of the largest motion in the mode: bodies that move less are not named
MOVES = 0.1


@dataclass(frozen=True)
class CriticalValue:
    """A value of a parameter at which a root stands on the imaginary axis on its way across.

    Attributes
    ----------
    value : float
        In the unit of the request.
    kind : str
        ``divergence`` (a real root is zero) or ``flutter`` (a pair is imaginary).
    frequency : float
        Of the oscillation [Hz], zero for divergence.
    becomes : str
        What the mode becomes as the parameter grows: ``unstable`` or ``stable``.
    bodies : tuple of str
        Bodies that move at least a tenth as much as the one that moves most, in that order, measured as `Modes.shapes`.
    modes : Modes
        The modes at this value.
    mode : int
        Which of them it is.
    """

    value: float
    kind: str
    frequency: float
    becomes: str
    bodies: tuple[str, ...]
    modes: Modes = field(repr=False)
    mode: int


def critical_values(
    vehicle: Vehicle, parameter: str, between: tuple[float, float], unit: str = ""
) -> tuple[CriticalValue, ...]:
    """All values between two at which a mode changes its stability, solved for to rounding.

    The roots are followed as branches over 33 values; each branch that changes the side of the imaginary axis is
    solved for by Brent's method. Steps in which a parabola through three neighbouring real parts comes near zero
    are halved up to eight times, so that a branch which crosses twice in one step is seen. An undamped system has its
    roots on the axis itself: there the value is solved for at which two of them meet and leave it.

    Not found are: a double crossing so narrow that its neighbours do not show it; a root that touches the axis without
    crossing, which changes no stability; a crossing where roots were not recognised (`RootLocus.unclear`), of which
    `unexplained` tells; a damped motion that becomes undamped for a whole range of values.

    Parameters
    ----------
    vehicle : Vehicle
    parameter : str
    between : tuple of float
        Lower and upper value.
    unit : str
        Of both values and the results; SI if empty.

    Raises
    ------
    AnalysisError
        If the range is empty, or the number of states changes in it.
    EomError
        As `eom.linearise`, where the vehicle refuses a value.
    """
    low, high = between
    if not low < high:
        raise AnalysisError(
            f"critical values of {parameter}: expected a lower and a higher value, got {low} and {high}"
        )
    return critical_of(root_locus(vehicle, parameter, np.linspace(low, high, POINTS).tolist(), unit))


def critical_of(locus: RootLocus) -> tuple[CriticalValue, ...]:
    """The critical values within a locus, whose own values take the place of the 33 of `critical_values`."""
    return tuple(map(described, crossings(locus.family, locus.steps)))


def unexplained(locus: RootLocus, found: Sequence[CriticalValue]) -> tuple[tuple[float, float], ...]:
    """Neighbouring values of a locus between which more or fewer roots became unstable than *found* says.

    Roots that were taken for each other where they met may hide a crossing; values at which one stands are left out.
    """
    counts = [int(np.sum(sides(modes) > 0)) for modes in locus.modes]
    effect = [
        (item.value, (1 if item.kind == "divergence" else 2) * (1 if item.becomes == "unstable" else -1))
        for item in found
    ]
    gaps = []
    for (a, before), (b, after) in pairwise(sorted(zip(locus.values.tolist(), counts, strict=True))):
        near = [change for value, change in effect if a - TOLERANCE * abs(a) <= value <= b + TOLERANCE * abs(b)]
        at_an_end = any(np.isclose(value, (a, b), rtol=TOLERANCE, atol=0.0).any() for value, _ in effect)
        if not at_an_end and after - before != sum(near):
            gaps.append((a, b))
    return tuple(gaps)


def described(crossing: Crossing) -> CriticalValue:
    """A crossing for people."""
    modes = crossing.node.modes
    moved = np.max(np.abs(modes.shapes[:, :, crossing.mode]), axis=1, initial=0.0)
    order = np.argsort(-moved, kind="stable")
    return CriticalValue(
        value=crossing.value,
        kind="flutter" if crossing.root.imag else "divergence",
        frequency=abs(crossing.root.imag) / (2.0 * np.pi),
        becomes="unstable" if crossing.rises else "stable",
        bodies=tuple(modes.bodies[k] for k in order if moved[k] >= MOVES * moved[order[0]] > 0.0),
        modes=modes,
        mode=crossing.mode,
    )
