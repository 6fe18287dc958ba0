"""Partial derivatives at any working point."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import Linear, MagicFormula52, MagicFormula61, Slopes, Tyre, slopes
from tests.tyre.random_sets import random_set_52, random_set_61, random_states
from tests.tyre.tyres import any_tyre


def differences(tyre: Tyre, point: tuple[float, ...], speed: float, k: int, step: float) -> np.ndarray:
    """Central differences of fourth order of all forces by one argument."""
    total = np.zeros(5)
    for multiple, weight in ((-2, 1.0), (-1, -8.0), (1, 8.0), (2, -1.0)):
        alpha, kappa, Fz, gamma = (value + multiple * step if i == k else value for i, value in enumerate(point))
        total += weight * np.array([*tyre.forces(alpha, kappa, Fz, gamma, speed)])
    return total / (12.0 * step)


def assert_slopes_are_differences(tyre: Tyre, point: tuple[float, float, float, float], speed: float) -> None:
    found = slopes(tyre, *point, speed)
    steps = (1e-4, 1e-4, 1e-3 * point[2], 1e-4)
    for k, name in enumerate(Slopes._fields):
        expected = differences(tyre, point, speed, k, steps[k])
        scale = point[2] / (steps[k] * 1e4)
        # truncation, fourth order of a step of 1e-4 in curves that bend over 1e-2, and rounding over the step
        assert np.array([*found[k]]) == pytest.approx(expected, rel=1e-5, abs=2e-6 * scale), name


@given(any_tyre, st.floats(0.01, 0.3), st.floats(-0.5, -0.01), st.floats(0.3, 1.5), st.floats(0.01, 0.1))
def test_slopes_are_the_limits_of_differences(
    tyre: Tyre, alpha: float, kappa: float, share: float, gamma: float
) -> None:
    assert_slopes_are_differences(tyre, (alpha, kappa, 4000.0 * share, gamma), 20.0)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("form", ["tool", "book", "5.2"])
def test_slopes_of_full_magic_formula_sets_are_the_limits_of_differences(form: str, seed: int) -> None:
    versions: dict[str, Callable[[], Tyre]] = {
        "tool": lambda: MagicFormula61(**random_set_61(seed)),  # type: ignore[arg-type]
        "book": lambda: MagicFormula61(form="book", **random_set_61(seed)),  # type: ignore[arg-type]
        "5.2": lambda: MagicFormula52(**random_set_52(seed)),  # type: ignore[arg-type]
    }
    tyre = versions[form]()
    for state in random_states(seed, 4000.0, 6):
        assert_slopes_are_differences(tyre, (state.alpha, state.kappa, state.Fz, state.gamma), state.speed)


def test_slopes_of_arrays_have_their_shape() -> None:
    tyre = Linear(nominal_load=4000.0, cornering=6e4, camber=1e3)
    found = slopes(tyre, np.zeros((3, 1)), 0.0, np.array([2000.0, 4000.0]))
    assert found.alpha.Fy.shape == (3, 2)  # type: ignore[union-attr]
    assert np.all(found.alpha.Fy == -6e4)
    assert np.all(found.gamma.Fy == -1e3)


def test_what_is_no_number_is_refused_by_name() -> None:
    tyre = Linear(nominal_load=4000.0, cornering=6e4)
    with pytest.raises(TyreError, match="Fz: expected finite numbers"):
        slopes(tyre, 0.0, 0.0, np.nan)
    with pytest.raises(TyreError, match="kappa: expected a number or an array of numbers"):
        tyre.forces(0.0, "fast", 4000.0)  # type: ignore[arg-type]
    with pytest.raises(
        TyreError, match=r"shapes that do not fit together, or not the number of tyres: alpha \(2,\), kappa \(3,\)"
    ):
        tyre.forces(np.zeros(2), np.zeros(3), 4000.0)
