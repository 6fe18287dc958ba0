"""Coefficients of any tyre model by least squares to measured points."""

import copy
import dataclasses
import difflib
import math
from collections.abc import Mapping, Sequence
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from eom.errors import TyreError
from eom.tyre.fitting.data import Points, points_of
from eom.tyre.fitting.quality import Residual, at_bounds, residuals_of, scales_of, uncertainty
from eom.tyre.interface import Tyre
from eom.tyre.parameters import coefficients
from eom.tyre.slopes import STEP, derivative

T = TypeVar("T", bound=Tyre)
Array = np.ndarray[Any, Any]

FINE = 1e-15
"""Relative change of cost, step and gradient at which the search ends: at rounding, as exact derivatives allow."""


@dataclasses.dataclass(frozen=True)
class Fit(Generic[T]):
    """A fitted tyre and how well the data determine it.

    Attributes
    ----------
    tyre : Tyre
        With the fitted coefficients.
    names : tuple of str
        The fitted coefficients, in the order of what follows.
    values, errors : array
        Their values and standard errors; an infinite error where the data do not determine a coefficient.
    correlation : array
        Correlation of the errors, shape (n, n); NaN where an error is infinite.
    residuals : dict
        A `Residual` for each measured channel.
    warnings : tuple of str
        A sentence for each coefficient that is not determined or stands at a bound, and for a search that did not
        converge.
    """

    tyre: T
    names: tuple[str, ...]
    values: Array
    errors: Array
    correlation: Array
    residuals: dict[str, Residual]
    warnings: tuple[str, ...]


def fit(tyre: T, data: Mapping[str, ArrayLike], names: Sequence[str]) -> Fit[T]:
    """Fit named coefficients of a tyre to measured points; the others stay as they are.

    Least squares of forces over load and of moments over load times a decimetre, the load being the root mean
    square of all points, so that forces and moments weigh alike. The bounds of the coefficients are kept.
    Derivatives are exact, by complex steps in the coefficients.

    Parameters
    ----------
    tyre : Tyre
        Any model; its coefficients are where the search starts.
    data : mapping
        Columns of one length by name, such as a dict of arrays or a table of pandas: Fz [N]; alpha [rad] or kappa
        or both, gamma [rad], speed [m/s] where they are not zero or the reference speed; any of Fx, Fy [N], Mx, My,
        Mz [N m]. Signs as in `Tyre.forces`.
    names : sequence of str
        Names of the coefficients to fit.

    Raises
    ------
    TyreError
        With a sentence for everything that is wrong with data or names.

    Examples
    --------
    >>> from eom.tyre import MagicFormula, fit
    >>> start = MagicFormula(nominal_load=4000.0, mu_x=1.0, mu_y=1.0, k_x=20.0, k_y=10.0)
    >>> data = {"alpha": [0.01, 0.05, 0.1, 0.2], "Fz": [4000.0] * 4, "Fy": [-590.0, -2560.0, -3580.0, -3660.0]}
    >>> found = fit(start, data, ["mu_y", "k_y", "C_y"])
    >>> print(found.values.round(3), f"{found.residuals['Fy'].value:.1f} N")
    [ 0.938 15.154  1.619] 6.4 N
    """
    from scipy.optimize import least_squares  # noqa: PLC0415  slow to import

    if isinstance(names, str):
        raise TyreError(f"fit: names = {names!r}: expected a list of names, such as [{names!r}]")
    names = tuple(names)
    points = points_of(data)
    fields = fields_of(tyre, names, sum(array.size for array in points.channels.values()))
    scales = scales_of(points)

    def residual(values: Array) -> Array:
        return np.asarray(weighted(tyre_with(tyre, names, values), points, scales) - measured)

    def jacobian(values: Array) -> Array:
        steps = 1j * STEP * np.eye(len(names))
        return np.column_stack(
            [derivative(weighted(tyre_with(tyre, names, values + step), points, scales)) for step in steps]
        )

    measured = np.concatenate([array / scales[name] for name, array in points.channels.items()])
    bounds = np.array([bounds_of(item) for item in fields]).T
    start = np.array([getattr(tyre, name) for name in names], dtype=float)
    # the search shortens a step that leads to no number
    with np.errstate(all="ignore"):
        found = least_squares(
            residual, start, jacobian, (bounds[0], bounds[1]), x_scale="jac", ftol=FINE, xtol=FINE, gtol=FINE
        )
    errors, correlation, weak = uncertainty(jacobian(found.x), found.fun, names)
    warnings = [*weak, *at_bounds(found.x, found.active_mask, names)]
    if not found.success:
        warnings.append(f"the search did not converge in {found.nfev} evaluations: start nearer to the data")
    fitted = dataclasses.replace(tyre, **dict(zip(names, found.x.tolist(), strict=True)))  # type: ignore[type-var]
    residuals = residuals_of(found.fun, points, scales)
    return Fit(fitted, tuple(names), found.x, errors, correlation, residuals, tuple(warnings))


def fields_of(tyre: Tyre, names: Sequence[str], numbers: int) -> "list[dataclasses.Field[Any]]":
    """The fields of the names; raises for names and tyres that cannot be fitted."""
    known = {item.name: item for item in coefficients(tyre)}
    wrong = []
    for name in dict.fromkeys(names):
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"; did you mean {near[0]!r}?" if near else ""
            wrong.append(f"fit: {type(tyre).__name__} has no coefficient {name!r}{hint}")
        elif np.ndim(getattr(tyre, name)):
            wrong.append(f"fit: {name} is that of several tyres: expected one tyre, not a stack")
    wrong += [f"fit: {name} is named twice" for name in dict.fromkeys(names) if names.count(name) > 1]
    if not names:
        wrong.append("fit: no coefficient is named")
    elif numbers < len(names):
        wrong.append(
            f"fit: {numbers} measured numbers cannot give {len(names)} coefficients: expected at least as many"
        )
    if wrong:
        raise TyreError("\n".join(wrong))
    return [known[name] for name in names]


def bounds_of(item: "dataclasses.Field[Any]") -> tuple[float, float]:
    """Least and greatest value of a coefficient."""
    limits = item.metadata
    above = limits["above"]
    least = math.nextafter(above, math.inf) if math.isfinite(above) else above
    return max(least, limits["at_least"]), limits["at_most"]


def tyre_with(tyre: T, names: Sequence[str], values: Array) -> T:
    """The tyre with other coefficients, which may be complex to carry a derivative; their bounds are not checked."""
    changed = copy.copy(tyre)
    for name, value in zip(names, values, strict=True):
        object.__setattr__(changed, name, value)
    return changed


def weighted(tyre: Tyre, points: Points, scales: Mapping[str, float]) -> Array:
    """What the tyre gives for the measured channels, over their scales, in one row."""
    forces = tyre.forces(**points.arguments)
    return np.concatenate([np.asarray(getattr(forces, name)) / scales[name] for name in points.channels])
