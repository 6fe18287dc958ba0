"""Slip angle of a demanded lateral force."""

import dataclasses
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from eom.errors import TyreError
from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula52, MagicFormula61, Tyre, slip_angle_for, slopes, stack
from tests.tyre.random_sets import random_set_52, random_set_61
from tests.tyre.tyres import any_tyre, between, loads, nonlinear, plain_61

EXACT = 1e-12
"""Of the load: the rounding of a force that is a few hundred operations of its slip angle."""


FORMS: dict[str, Callable[[int], Tyre]] = {
    "tool": lambda seed: tyre_61(random_set_61(seed)),
    "book": lambda seed: dataclasses.replace(tyre_61(random_set_61(seed)), form="book"),
    "5.2": lambda seed: tyre_52(random_set_52(seed)),
}


def tyre_61(numbers: dict[str, Any]) -> MagicFormula61:
    return MagicFormula61(**numbers)


def tyre_52(numbers: dict[str, Any]) -> MagicFormula52:
    return MagicFormula52(**numbers)


class Peak(NamedTuple):
    alpha: float
    Fy: float


def first_peaks(tyre: Tyre, Fz: float, kappa: float, gamma: float) -> tuple[Peak, Peak]:
    """Where the lateral force stops growing on the way from straight running to the right, and to the left.

    By SciPy's search around the first of many slip angles that is followed by a lesser force.
    """

    def found(side: float) -> Peak:
        angles = side * np.linspace(0.0, 1.57, 4001)
        forces = -side * np.asarray(tyre.forces(angles, kappa, Fz, gamma).Fy)
        k = max(int(np.argmax(np.append(np.diff(forces) < 0.0, True))), 1)
        near = angles[k - 1 : k + 2]
        search = minimize_scalar(
            lambda alpha: side * float(tyre.forces(alpha, kappa, Fz, gamma).Fy),
            bounds=(float(near.min()), float(near.max())),
            method="bounded",
            options={"xatol": 1e-10},
        )
        return Peak(float(search.x), side * float(search.fun))

    return found(1.0), found(-1.0)


@given(any_tyre, loads, between(-0.2, 0.2), between(-0.1, 0.1), between(-1.5, 1.5))
def test_the_force_of_the_slip_angle_is_the_demand_or_the_nearest_possible(
    tyre: Tyre, Fz: float, kappa: float, gamma: float, share: float
) -> None:
    alpha, saturated = slip_angle_for(tyre, share * Fz, Fz, kappa, gamma)
    rest = float(tyre.forces(alpha, kappa, Fz, gamma).Fy) - share * Fz
    if saturated:
        angles = np.linspace(-abs(alpha), abs(alpha), 501)
        others = np.asarray(tyre.forces(angles, kappa, Fz, gamma).Fy) - share * Fz
        assert abs(rest) <= np.abs(others).min() + EXACT * Fz
        assert rest * share < 0.0
    else:
        assert abs(rest) <= EXACT * Fz


@given(nonlinear, loads, between(0.02, 0.98), st.booleans(), between(-0.1, 0.1))
def test_the_inverse_of_the_force_is_the_slip_angle_below_the_peak(
    tyre: Tyre, Fz: float, share: float, left: bool, kappa: float
) -> None:
    alpha = share * first_peaks(tyre, Fz, kappa, 0.0)[left].alpha
    Fy = tyre.forces(alpha, kappa, Fz).Fy
    found = slip_angle_for(tyre, Fy, Fz, kappa)
    assert not found.saturated
    # the force is met to rounding, the slip angle as well as the force tells it
    slope = abs(float(np.asarray(slopes(tyre, alpha, kappa, Fz).alpha.Fy)))
    assert abs(found.alpha - alpha) <= 1e-14 + 10.0 * EXACT * Fz / slope


@given(plain_61(), loads, between(-0.1, 0.1), between(-0.1, 0.1))
def test_saturated_is_a_demand_beyond_the_peak_and_no_other(tyre: Tyre, Fz: float, kappa: float, gamma: float) -> None:
    for slip, force in first_peaks(tyre, Fz, kappa, gamma):
        assume(abs(slip) < 1.56)
        beyond = slip_angle_for(tyre, force * (1.0 + 1e-9), Fz, kappa, gamma)
        assert beyond.saturated
        # the force is flat at its peak: a search among forces finds its place to the root of rounding
        assert abs(beyond.alpha - slip) < 1e-5
        assert not slip_angle_for(tyre, force * (1.0 - 1e-9), Fz, kappa, gamma).saturated


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("form", ["tool", "book", "5.2"])
def test_shifts_of_all_kinds_change_nothing_of_that(form: str, seed: int) -> None:
    tyre = FORMS[form](seed)
    Fz, share = np.meshgrid([500.0, 4000.0, 8000.0], np.linspace(-1.4, 1.4, 29))
    for kappa, gamma in ((0.0, 0.0), (0.05, 0.1), (-0.1, -0.1)):
        alpha, saturated = slip_angle_for(tyre, share * Fz, Fz, kappa, gamma)
        forces = np.asarray(tyre.forces(alpha, kappa, Fz, gamma).Fy)
        assert np.all(saturated | (np.abs(forces - share * Fz) <= EXACT * Fz))
        assert np.any(saturated)
        assert not np.all(saturated)
        every = np.asarray(tyre.forces(np.linspace(-1.57, 1.57, 4001)[:, None, None], kappa, Fz, gamma).Fy)
        reached = (share * Fz < every.max(axis=0)) & (share * Fz > every.min(axis=0))
        assert np.array_equal(saturated, ~reached)


@pytest.mark.parametrize("Fy", [2.2e-308, -1e-320, 1e-200])
def test_a_demand_next_to_nothing_needs_no_slip_angle_to_speak_of(Fy: float) -> None:
    tyre = Dugoff(nominal_load=4000.0, cornering=2e4, longitudinal=2e4, friction=1.0)
    alpha, saturated = slip_angle_for(tyre, Fy, 1001.0)
    assert not saturated
    assert abs(alpha) < 1e-16


def test_a_linear_tyre_needs_force_over_stiffness_and_ends_at_a_right_angle() -> None:
    tyre = Linear(nominal_load=4000.0, cornering=6e4, camber=3e3)
    alpha, saturated = slip_angle_for(tyre, np.array([-3000.0, 1e6, -1e6]), 4000.0, gamma=0.1)
    assert np.allclose(alpha, [(3000.0 - 300.0) / 6e4, -0.5 * np.pi, 0.5 * np.pi], rtol=1e-14, atol=0.0)
    assert saturated.tolist() == [False, True, True]


@given(between(0.55, 0.99))
def test_dugoffs_tyre_needs_the_slip_angle_of_its_own_formula(share: float) -> None:
    # |Fy| = mu Fz (1 - mu Fz/(4 C tan alpha)) where it slides
    tyre = Dugoff(nominal_load=4000.0, cornering=8e4, longitudinal=9e4, friction=0.9)
    grip = 0.9 * 4000.0
    alpha, saturated = slip_angle_for(tyre, share * grip, 4000.0)
    assert not saturated
    assert np.isclose(alpha, -np.arctan(grip / (4.0 * 8e4 * (1.0 - share))), rtol=1e-11, atol=0.0)


@pytest.mark.parametrize("Fz", [0.0, -100.0])
def test_a_lifted_wheel_is_saturated_by_any_force_but_none(Fz: float) -> None:
    tyre = MagicFormula(nominal_load=4000.0, mu_x=1.0, mu_y=1.0, k_x=20.0, k_y=15.0)
    alpha, saturated = slip_angle_for(tyre, np.array([-1.0, 0.0, 1e-9]), Fz)
    assert saturated.tolist() == [True, False, True]
    assert alpha.tolist() == [0.0, 0.0, 0.0]


@given(nonlinear, st.floats(1e-9, 1.0), between(-0.4, 0.4))
def test_a_wheel_about_to_lift_obeys_the_same_law(tyre: Tyre, Fz: float, share: float) -> None:
    most = float(tyre.forces(slip_angle_for(tyre, Fz, Fz).alpha, 0.0, Fz).Fy)
    alpha, saturated = slip_angle_for(tyre, share * most, Fz)
    assert not saturated
    assert abs(float(tyre.forces(alpha, 0.0, Fz).Fy) - share * most) <= EXACT * Fz


def test_stacked_tyres_are_each_its_own() -> None:
    tyres = [
        MagicFormula(nominal_load=4000.0, mu_x=1.0, mu_y=mu, k_x=20.0, k_y=k_y)
        for mu, k_y in ((0.3, 8.0), (0.8, 15.0), (1.2, 25.0))
    ]
    demand = np.array([[-900.0, 1500.0, -5000.0], [3000.0, 100.0, 0.0]])
    together = slip_angle_for(stack(tyres), demand, np.array([3000.0, 4000.0, 5000.0]), kappa=0.02)
    for k, (tyre, Fz) in enumerate(zip(tyres, (3000.0, 4000.0, 5000.0), strict=True)):
        alone = slip_angle_for(tyre, demand[:, k], Fz, kappa=0.02)
        # NumPy's vector instructions may round differently in arrays of another length
        assert np.allclose(together.alpha[:, k], alone.alpha, rtol=1e-12, atol=0.0)
        assert np.array_equal(together.saturated[:, k], alone.saturated)


def test_a_side_force_that_grows_with_the_slip_angle_is_refused() -> None:
    tyre = dataclasses.replace(tyre_61(random_set_61(0)), PKY1=15.0)
    with pytest.raises(TyreError, match="the lateral force grows with the slip angle"):
        slip_angle_for(tyre, 1000.0, 4000.0)


@pytest.mark.parametrize(
    ("Fy", "Fz", "sentence"),
    [
        (np.nan, 4000.0, "Fy: expected finite numbers"),
        (1000.0, np.inf, "Fz: expected finite numbers"),
        ([1.0, 2.0], [1.0, 2.0, 3.0], "expected one that fits"),
    ],
)
def test_arguments_that_cannot_be_are_refused(Fy: Any, Fz: Any, sentence: str) -> None:
    with pytest.raises(TyreError, match=sentence):
        slip_angle_for(Linear(nominal_load=4000.0, cornering=6e4), Fy, Fz)


def test_a_wheel_that_spins_too_fast_to_be_steered_is_marked_beside_one_that_is_not() -> None:
    tyre = MagicFormula61(
        FNOMIN=4e3, UNLOADED_RADIUS=0.3, PCX1=1.6, PDX1=1, PKX1=25, PCY1=1.4, PDY1=1, PKY1=-20, PKY2=2,
        RBX1=12, RBX2=10, RCX1=1.05, RBY1=12, RBY2=8, RCY1=1.2,
    )  # fmt: skip
    assert slopes(tyre, 0.0, 3.0, 4e3).alpha.Fy > 0.0
    alpha, saturated = slip_angle_for(tyre, 500.0, 4e3, kappa=np.array([0.0, 3.0]))
    assert saturated.tolist() == [False, True]
    assert alpha[1] == 0.0
    assert tyre.forces(alpha[0], 0.0, 4e3).Fy == pytest.approx(500.0, abs=1e-9)
