"""The ends of the range: lift-off, standstill, reversal, a locked wheel; nothing jumps and no slope does."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.tyre import MagicFormula52, MagicFormula61, Tyre, slips
from eom.tyre.contact import LIFT
from tests.tyre.random_sets import random_set_52, random_set_61
from tests.tyre.tyres import LOAD, angles, any_tyre, dugoff, leans, nonlinear, ratios

STEP = 1e-6


def full_sets() -> st.SearchStrategy[Tyre]:
    """Magic Formula tyres with every coefficient non-zero but LMUV, which makes friction a cone at zero slip."""
    seeds = st.integers(0, 10**6)
    tool = seeds.map(lambda seed: MagicFormula61(**random_set_61(seed)))  # type: ignore[arg-type]
    book = seeds.map(lambda seed: MagicFormula61(form="book", **random_set_61(seed) | {"LMUV": 0.0}))  # type: ignore[arg-type]
    return st.one_of(tool, book, seeds.map(lambda seed: MagicFormula52(**random_set_52(seed))))  # type: ignore[arg-type]


every_tyre = st.one_of(any_tyre, full_sets())


def wrench(tyre: Tyre, *arguments: float) -> np.ndarray:
    """Forces and moments as one array."""
    return np.array([*tyre.forces(*arguments)])


def nominal(tyre: Tyre) -> float:
    """The load that a tyre's coefficients are for."""
    return float(getattr(tyre, "FNOMIN", getattr(tyre, "nominal_load", 0.0)))


def assert_smooth(force: Callable[[float], np.ndarray], at: float, scale: float, size: float) -> None:
    """Assert that value and slope of a force are the same on both sides of a point.

    One-sided quotients over steps of 1e-4 and 1e-5 of the scale: a jump of the slope would keep them apart, whereas
    their difference by curvature, which may jump, is ten times smaller with the ten times smaller step.
    """
    gaps = []
    for step in (1e-4 * scale, 1e-5 * scale):
        here = force(at)
        right, left = (force(at + step) - here) / step, (here - force(at - step)) / step
        gaps.append(np.max(np.abs(right - left)) * scale / size)
    # rounding of 1e-15 of the size over a step of 1e-5
    assert gaps[1] <= 0.3 * gaps[0] + 1e-8


@given(every_tyre, angles, ratios, leans)
def test_a_tyre_without_load_has_no_forces(tyre: Tyre, alpha: float, kappa: float, gamma: float) -> None:
    for Fz in (0.0, -1.0, -1e5):
        assert [float(value) for value in tyre.forces(alpha, kappa, Fz, gamma)] == [0.0] * 5
    # the share that acts falls with the square of the load, and all forces with it
    small, smaller = (wrench(tyre, alpha, kappa, share * nominal(tyre), gamma) for share in (1e-5, 1e-6))
    assert np.all(np.abs(smaller) <= 0.0101 * np.abs(small) + 1e-300)


@given(every_tyre, angles, ratios, leans)
def test_forces_are_smooth_in_load_at_lift_off_and_where_contact_is_full(
    tyre: Tyre, alpha: float, kappa: float, gamma: float
) -> None:
    low = LIFT * nominal(tyre)
    size = float(np.max(np.abs(wrench(tyre, alpha, kappa, low, gamma)))) + 1e-3 * low

    def force(Fz: float) -> np.ndarray:
        return wrench(tyre, alpha, kappa, Fz, gamma)

    assert_smooth(force, 0.0, low, size)
    assert_smooth(force, low, low, size)


@given(nonlinear, angles, ratios, st.floats(0.0, 2 * LIFT))
def test_near_lift_off_no_force_exceeds_friction(tyre: Tyre, alpha: float, kappa: float, share: float) -> None:
    Fz = share * nominal(tyre)
    found = tyre.forces(alpha, kappa, Fz)
    # their friction is at most 1.3 at small load, and cosine weighting exceeds the ellipse by a few percent
    assert np.hypot(found.Fx, found.Fy) <= 1.35 * Fz


@given(every_tyre, angles, ratios, leans, st.sampled_from([-1.0, 0.0, 1.0]))
def test_forces_are_smooth_in_speed_at_standstill_and_at_the_low_speed(
    tyre: Tyre, alpha: float, kappa: float, gamma: float, multiple: float
) -> None:
    low = float(getattr(tyre, "VXLOW", 1.0))
    size = float(np.max(np.abs(wrench(tyre, alpha, kappa, LOAD, gamma)))) + 1e-3 * LOAD

    def force(speed: float) -> np.ndarray:
        return wrench(tyre, alpha, kappa, LOAD, gamma, speed)

    assert_smooth(force, multiple * low, low, size)


@given(every_tyre, angles, leans)
def test_forces_are_smooth_in_longitudinal_slip_at_the_locked_wheel(tyre: Tyre, alpha: float, gamma: float) -> None:
    size = float(np.max(np.abs(wrench(tyre, alpha, -1.0, LOAD, gamma)))) + 1e-3 * LOAD

    def force(kappa: float) -> np.ndarray:
        return wrench(tyre, alpha, kappa, LOAD, gamma)

    for at in (-1.1, -1.0, -0.9, 0.0):
        assert_smooth(force, at, 0.1, size)


@given(every_tyre, ratios, leans)
def test_forces_are_smooth_in_slip_angle_straight_ahead(tyre: Tyre, kappa: float, gamma: float) -> None:
    size = float(np.max(np.abs(wrench(tyre, 0.1, kappa, LOAD, gamma)))) + 1e-3 * LOAD

    def force(alpha: float) -> np.ndarray:
        return wrench(tyre, alpha, kappa, LOAD, gamma)

    assert_smooth(force, 0.0, 0.1, size)


@given(dugoff, st.floats(0.0, 0.5))
def test_a_wheel_that_turns_backwards_slides_with_all_its_friction(tyre: Tyre, alpha: float) -> None:
    found = tyre.forces(alpha, -1.5, LOAD)
    assert np.hypot(found.Fx, found.Fy) == pytest.approx(tyre.friction * LOAD, rel=1e-13)  # type: ignore[attr-defined]


@given(any_tyre, st.floats(2.0, 40.0), st.floats(-0.3, 0.3), st.floats(-0.3, 0.3))
def test_in_reverse_a_symmetric_tyre_resists_as_it_does_forward(
    tyre: Tyre, speed: float, drift: float, kappa: float
) -> None:
    """Turning a wheel half round about the vertical axis turns its motion and its horizontal forces with it."""
    radius, omega = 0.32, speed * (1.0 + kappa) / 0.32
    forward = tyre.forces(*slips(speed, drift * speed, omega, radius), LOAD, speed=speed)
    reverse = tyre.forces(*slips(-speed, -drift * speed, -omega, radius), LOAD, speed=-speed)
    turned = [-reverse.Fx, -reverse.Fy, -reverse.My, reverse.Mz]
    assert [forward.Fx, forward.Fy, forward.My, forward.Mz] == pytest.approx(turned, abs=1e-13 * LOAD)


def test_a_standing_wheel_has_no_rolling_resistance_and_a_magic_formula_tyre_no_shifts() -> None:
    tyre = MagicFormula61(**random_set_61(3))  # type: ignore[arg-type]
    found = tyre.forces(0.0, 0.0, LOAD, 0.0, speed=0.0)
    assert [float(value) for value in (found.Fx, found.Fy, found.My, found.Mz)] == [0.0] * 4
