"""Magic Formula coefficients that meet given stiffnesses at given loads."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from eom.errors import TyreError
from eom.tyre.contact import LIFT
from eom.tyre.magic_formula import MagicFormula

NAMES = ("", "_load", "_load2")
Array = np.ndarray[Any, Any]


def fit_stiffness(loads: ArrayLike, cornering: ArrayLike, longitudinal: ArrayLike, **others: Any) -> MagicFormula:
    """A Magic Formula tyre whose slopes at zero slip are given ones at one to three loads, exactly.

    Stiffness per load is the polynomial of least degree through the given points: constant for one load, a parabola
    for three.

    Parameters
    ----------
    loads : array
        One to three different loads [N].
    cornering : array
        Cornering stiffness -dFy/dalpha [N/rad] at each load.
    longitudinal : array
        Slip stiffness dFx/dkappa [N] at each load.
    **others
        Further coefficients of `MagicFormula`; mu_x and mu_y are needed. The nominal load is the first of the loads
        unless it is among them.

    Raises
    ------
    TyreError
        If the points are none, more than three, at equal loads or not positive, or if a stiffness would vanish
        between them.

    Examples
    --------
    >>> tyre = fit_stiffness([20e3, 30e3], [190e3, 290e3], [100e3, 145e3], mu_x=0.85, mu_y=0.85)
    >>> from eom.tyre import slopes
    >>> print(slopes(tyre, 0.0, 0.0, [20e3, 30e3]).alpha.Fy)
    [-190000. -290000.]
    """
    points = {"loads": loads, "cornering": cornering, "longitudinal": longitudinal}
    Fz, C_y, C_x = columns(points)
    nominal = others.pop("nominal_load", float(Fz[0]))
    if missing := sorted({"mu_x", "mu_y"} - others.keys()):
        raise TyreError(f"fit_stiffness: {', '.join(missing)}: expected the friction too")
    if not isinstance(nominal, (int, float)) or not 0.0 < nominal < np.inf:
        raise TyreError(f"fit_stiffness: nominal_load = {nominal!r}: expected a number above zero, in N")
    if wrong := [
        f"fit_stiffness: {problem}" for problem in problems(Fz, {"cornering": C_y, "longitudinal": C_x}, nominal)
    ]:
        raise TyreError("\n".join(wrong))
    fitted: dict[str, Any] = {}
    for axis, stiffness in (("x", C_x), ("y", C_y)):
        factors = polynomial(Fz / nominal - 1.0, stiffness / Fz, f"k_{axis}")
        fitted |= {f"k_{axis}{name}": float(factor) for name, factor in zip(NAMES, factors, strict=False)}
    if given := sorted(fitted.keys() & others.keys()):
        raise TyreError(f"fit_stiffness: {', '.join(given)} follow from the stiffnesses: leave them out")
    return MagicFormula(nominal_load=nominal, **fitted, **others)


def columns(points: dict[str, ArrayLike]) -> list[Array]:
    """The points as arrays of one length."""
    try:
        arrays = [np.atleast_1d(np.asarray(values, dtype=float)) for values in points.values()]
    except (TypeError, ValueError):
        raise TyreError(f"fit_stiffness: {', '.join(points)}: expected numbers") from None
    shapes = [array.shape for array in arrays]
    if len(set(shapes)) > 1 or arrays[0].ndim > 1 or not 1 <= arrays[0].size <= len(NAMES):
        came = ", ".join(f"{name} {shape}" for name, shape in zip(points, shapes, strict=True))
        raise TyreError(f"fit_stiffness: expected as many stiffnesses as loads, one to three, got shapes {came}")
    return arrays


def problems(Fz: Array, stiffnesses: dict[str, Array], nominal: float) -> list[str]:
    """What is wrong with the points."""
    wrong = [
        f"{name} = {values}: expected finite numbers above zero"
        for name, values in {"loads": Fz, **stiffnesses}.items()
        if not np.all(np.isfinite(values) & (values > 0.0))
    ]
    if len(np.unique(Fz)) < Fz.size:
        wrong.append(f"loads = {Fz}: expected different loads")
    if np.any(Fz < LIFT * nominal):
        wrong.append(f"loads = {Fz}: expected at least {LIFT:g} of the nominal load {nominal:g} N, where contact fades")
    return wrong


def polynomial(f: Array, values: Array, name: str) -> Array:
    """Factors of 1, f, f^2 of the polynomial through points; raises where it is not positive between them."""
    factors = np.linalg.solve(np.vander(f, increasing=True), values)
    between = np.linspace(f.min(), f.max(), 101)
    if np.any(np.polynomial.polynomial.polyval(between, factors) <= 0.0):
        raise TyreError(
            f"fit_stiffness: {name} of the parabola through {values} at relative loads {1.0 + f} is not positive "
            "everywhere between them: expected stiffnesses per load that change less; give fewer loads"
        )
    return factors
