"""A Magic Formula tyre in reverse, mirrored, and with some of its forces only; every coefficient is non-zero."""

import dataclasses
from typing import Any

import numpy as np
import pytest

from eom.tyre import MagicFormula52, MagicFormula61
from tests.tyre.random_sets import random_set_52, random_set_61

FORMS = ("tool", "book", "5.2")
SEEDS = range(6)
ALPHA, KAPPA, LOAD, GAMMA, SPEED = np.array([0.1, -0.03, 0.3]), np.array([0.04, -0.2, 0.5]), 3500.0, 0.08, 20.0
ROUNDING = 1e-12
"""Of the load: some tens of operations."""


def tyre_of(form: str, seed: int, **changes: Any) -> MagicFormula61 | MagicFormula52:
    numbers: dict[str, Any] = (random_set_52(seed) if form == "5.2" else random_set_61(seed)) | changes
    return MagicFormula52(**numbers) if form == "5.2" else MagicFormula61(form=form, **numbers)  # type: ignore[arg-type]


def assert_same(found: Any, expected: Any) -> None:
    np.testing.assert_allclose(np.array([*found]), np.array([*expected]), rtol=0.0, atol=ROUNDING * LOAD)


@pytest.mark.parametrize("form", FORMS)
def test_in_reverse_driving_and_braking_change_places_and_moments_of_the_trail_turn(form: str) -> None:
    """The tool counts longitudinal slip from the speed with its sign, so that its slip turns over in reverse."""
    for seed in SEEDS:
        tyre = tyre_of(form, seed)
        reverse = tyre.forces(ALPHA, KAPPA, LOAD, GAMMA, -SPEED)
        forward = tyre.forces(ALPHA, -KAPPA, LOAD, GAMMA, SPEED)
        pairs = [
            (reverse.Fx, -forward.Fx),
            (reverse.Fy, forward.Fy),
            (reverse.Mx, forward.Mx),
            (reverse.Mz, -forward.Mz),
        ]
        assert_same([found for found, _ in pairs], [expected for _, expected in pairs])


@pytest.mark.parametrize("form", FORMS)
def test_the_mirrored_tyre_has_the_mirrored_forces_of_the_mirrored_state(form: str) -> None:
    for seed in SEEDS:
        tyre = tyre_of(form, seed)
        mirrored = dataclasses.replace(tyre, mirror=True).forces(ALPHA, KAPPA, LOAD, GAMMA, SPEED)
        image = tyre.forces(-ALPHA, KAPPA, LOAD, -GAMMA, SPEED)
        assert_same(mirrored, (image.Fx, -image.Fy, -image.Mx, image.My, -image.Mz))


@pytest.mark.parametrize("form", FORMS)
def test_uses_have_the_forces_of_one_slip_each(form: str) -> None:
    for seed in SEEDS:
        # without its arm the longitudinal force, which is not zero at zero slip, gives no aligning moment; the book's
        # friction falls with the speed of both slips
        slip_speed = {"LMUV": 0.0} if form == "book" else {}
        tyre = tyre_of(form, seed, SSZ1=0.0, SSZ2=0.0, SSZ3=0.0, SSZ4=0.0, **slip_speed)
        along, across, both = (
            dataclasses.replace(tyre, use=use).forces(ALPHA, KAPPA, LOAD, GAMMA, SPEED)
            for use in ("longitudinal", "lateral", "uncombined")
        )
        rolling = tyre.forces(0.0 * ALPHA, KAPPA, LOAD, GAMMA, SPEED)
        cornering = tyre.forces(ALPHA, 0.0 * KAPPA, LOAD, GAMMA, SPEED)
        nothing = np.zeros_like(ALPHA)
        assert_same(along, (rolling.Fx, nothing, nothing, rolling.My, nothing))
        assert_same(across, (nothing, cornering.Fy, cornering.Mx, nothing, cornering.Mz))
        assert_same(both, (rolling.Fx, cornering.Fy, cornering.Mx, rolling.My, cornering.Mz))


@pytest.mark.parametrize("form", FORMS)
def test_without_combined_slip_the_arm_of_the_longitudinal_force_turns_nothing(form: str) -> None:
    for seed in SEEDS:
        moments = [
            tyre_of(form, seed, use=use, SSZ1=arm).forces(ALPHA, KAPPA, LOAD, GAMMA, SPEED).Mz
            for use in ("uncombined", "combined")
            for arm in (0.1, 0.5)
        ]
        assert np.array_equal(moments[0], moments[1])
        assert np.min(np.abs(np.subtract(moments[2], moments[3]))) > 1.0
