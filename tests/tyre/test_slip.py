"""Definitions of slip."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import slip_of_thesis, slips, thesis_slip

speeds = st.floats(-50.0, 50.0).filter(lambda v: abs(v) >= 1.0)


@given(speeds, st.floats(-20.0, 20.0), st.floats(-200.0, 200.0), st.floats(0.2, 0.6))
def test_above_the_low_speed_slips_are_those_of_iso_8855(v_x: float, v_y: float, omega: float, radius: float) -> None:
    alpha, kappa = slips(v_x, v_y, omega, radius)
    assert np.tan(alpha) * abs(v_x) == pytest.approx(v_y, rel=1e-12, abs=1e-12)
    assert v_x + kappa * abs(v_x) == pytest.approx(omega * radius, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("v_x", [-1.0, 0.0, 1.0])
def test_slips_are_once_continuously_differentiable_through_standstill(v_x: float) -> None:
    step = 1e-7
    for k in (0, 1):
        left, here, right = (float(slips(v_x + d, 0.3, 2.0, 0.3)[k]) for d in (-step, 0.0, step))
        # quotients of a smooth function differ by its second derivative times the step, and rounding over the step
        assert (right - here) / step == pytest.approx((here - left) / step, abs=1e-5)


def test_the_slip_of_the_thesis_is_its_two_formulas() -> None:
    """(3.44): (r omega - U)/(r omega) when accelerating, (r omega - U)/U when braking."""
    U, tread = 20.0, np.array([0.0, 10.0, 19.0, 20.0, 25.0, 60.0])
    kappa = slips(U, 0.0, tread / 0.5, 0.5)[1]
    expected = np.where(tread > U, (tread - U) / np.maximum(tread, 1e-300), (tread - U) / U)
    assert thesis_slip(kappa) == pytest.approx(expected, rel=1e-14)


@given(st.floats(-3.0, 50.0))
def test_the_slip_of_the_thesis_converts_back(kappa: float) -> None:
    assert slip_of_thesis(thesis_slip(kappa)) == pytest.approx(kappa, rel=1e-12, abs=1e-15)


def test_slips_that_cannot_be_are_refused() -> None:
    with pytest.raises(TyreError, match="sigma = 1: expected less than 1"):
        slip_of_thesis(1.0)
    with pytest.raises(TyreError, match="low_speed = 0: expected more than 0 m/s"):
        slips(1.0, 0.0, 1.0, 0.3, low_speed=0)
