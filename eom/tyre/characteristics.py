"""The figures by which tyres are compared: stiffnesses, peaks of friction, trail, relaxation lengths."""

from typing import NamedTuple

import numpy as np

from eom.errors import TyreError
from eom.tyre.branch import Array, Curve, branch
from eom.tyre.interface import Tyre, as_numbers
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.mf.relaxation import Relaxation, relaxation_lengths
from eom.tyre.parameters import Values
from eom.tyre.slopes import slopes
from eom.tyre.usual_range import inside, range_of


class Peak(NamedTuple):
    """The largest force over load, whatever its sign, and the slip at which it is reached; NaN without a peak."""

    friction: Array
    slip: Array


class Characteristics(NamedTuple):
    """Figures of a tyre that runs straight and upright, over load.

    Attributes
    ----------
    Fz : array
        Load [N].
    cornering, longitudinal, camber : array
        Stiffnesses -dFy/dalpha [N/rad], dFx/dkappa [N], -dFy/dgamma [N/rad]; positive for a tyre in ISO axes.
    side, drive : Peak
        Lateral and longitudinal friction, at their slips [rad] and [-].
    trail : array
        Pneumatic trail [m], by which the aligning moment grows with the lateral force; NaN without one.
    relaxation : Relaxation
        Relaxation lengths [m]; NaN where the tyre does not know them.
    """

    Fz: Array
    cornering: Array
    longitudinal: Array
    camber: Array
    side: Peak
    drive: Peak
    trail: Array
    relaxation: Relaxation


# coefficients beyond all sense divide by zero: such a figure is no number
@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def characteristics(tyre: Tyre, Fz: Values) -> Characteristics:
    """Figures of one tyre at loads [N]; raises `TyreError` for loads that are no finite numbers above zero."""
    loads = np.atleast_1d(as_numbers("Fz", Fz))
    if np.any(loads <= 0.0):
        raise TyreError(f"Fz = {np.min(loads):g} N: expected loads above zero")
    slope = slopes(tyre, 0.0, 0.0, loads)
    cornering = -np.asarray(slope.alpha.Fy)
    trail = np.divide(np.asarray(slope.alpha.Mz), cornering, out=np.full(loads.shape, np.nan), where=cornering != 0.0)
    return Characteristics(
        loads,
        cornering,
        np.asarray(slope.kappa.Fx),
        -np.asarray(slope.gamma.Fy),
        peak_of(lambda alpha: np.asarray(tyre.forces(alpha, 0.0, loads).Fy), 0.5 * np.pi, loads),
        peak_of(lambda kappa: np.asarray(tyre.forces(0.0, kappa, loads).Fx), 1.0, loads),
        trail,
        relaxation_of(tyre, loads),
    )


def peak_of(curve: Curve, end: float, loads: Array) -> Peak:
    """The higher of the two peaks of each curve."""
    way = branch(curve, end, loads.shape)
    forces = np.where(way.peaks, np.abs(curve(way.ends)), np.nan)
    slips = np.where(way.peaks, way.ends, np.nan)
    # of two equal ones, which rounding would choose from, the one at positive slip
    second = np.nan_to_num(forces[1]) >= np.nan_to_num(forces[0]) * (1.0 - 1e-9)
    return Peak(np.where(second, forces[1], forces[0]) / loads, np.where(second, slips[1], slips[0]))


def relaxation_of(tyre: Tyre, loads: Array) -> Relaxation:
    """Relaxation lengths of a Magic Formula tyre that knows them."""
    if isinstance(tyre, MagicFormula61 | MagicFormula52):
        try:
            return relaxation_lengths(tyre, loads)
        except TyreError:
            pass
    unknown = np.full(loads.shape, np.nan)
    return Relaxation(unknown, unknown)


SHARES = (0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0)
"""Loads of a table over the nominal one."""


def usual_loads(tyre: Tyre) -> Array:
    """Loads [N] at which tyres are usually told, as far as they are in the tyre's range; or the ends of that."""
    where = range_of(tyre)
    return inside(where.nominal * np.array(SHARES), where.Fz)
