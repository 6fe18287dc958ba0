"""Magic Formula coefficients that meet given stiffnesses."""

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import fit_stiffness, slopes
from tests.tyre.tyres import between

FRICTION = {"mu_x": 0.85, "mu_y": 0.85}


def test_printed_stiffnesses_of_a_truck_have_the_polynomials_of_that_truck() -> None:
    # Zhu's B-train: C_i and C_si of the trailers' axles per dual wheel, at 29 395.1 N and 17 823.7 N; the
    # polynomials in load itself, K_y = Fz (9.446482 + 1.535719e-5 Fz) and K_x = Fz (5.941779 - 3.432489e-5 Fz), were
    # worked out by hand to seven digits
    tyre = fit_stiffness([29395.1, 17823.7], [290950.0, 173250.0], [145e3, 95e3], **FRICTION)
    assert tyre.nominal_load == 29395.1
    assert np.isclose(tyre.k_y - tyre.k_y_load, 9.446482, rtol=1e-7)
    assert np.isclose(tyre.k_y_load / tyre.nominal_load, 1.535719e-5, rtol=1e-6)
    assert np.isclose(tyre.k_x - tyre.k_x_load, 5.941779, rtol=1e-7)
    assert np.isclose(tyre.k_x_load / tyre.nominal_load, -3.432489e-5, rtol=1e-6)


@given(
    st.lists(between(1e3, 6e4), min_size=1, max_size=3, unique=True),
    st.lists(between(3.0, 30.0), min_size=3, max_size=3),
    st.lists(between(3.0, 30.0), min_size=3, max_size=3),
    st.sampled_from(["ellipse", "cosine"]),
)
def test_the_slopes_at_the_loads_are_the_given_stiffnesses(
    loads: list[float], k_y: list[float], k_x: list[float], combined: str
) -> None:
    Fz = np.array(loads)
    # loads that nearly coincide make the parabola, not the fit, ill-conditioned
    assume(Fz.size == 1 or np.min(np.diff(np.sort(Fz))) > 500.0)
    cornering, longitudinal = Fz * np.array(k_y)[: Fz.size], Fz * np.array(k_x)[: Fz.size]
    try:
        tyre = fit_stiffness(Fz, cornering, longitudinal, **FRICTION, combined=combined)
    except TyreError as error:
        # a parabola through three positive points may dip below zero, and two such may start below
        assert "not positive" in str(error)  # noqa: PT017
        assume(False)
    slope = slopes(tyre, 0.0, 0.0, Fz)
    # the parabola's condition: loads 500 N apart in a range of 60 kN
    assert np.allclose(-np.asarray(slope.alpha.Fy), cornering, rtol=1e-9, atol=0.0)
    assert np.allclose(slope.kappa.Fx, longitudinal, rtol=1e-9, atol=0.0)


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        (([], [], []), "one to three"),
        (([1e4, 2e4, 3e4, 4e4], [1e5] * 4, [1e5] * 4), "one to three"),
        (([1e4, 2e4], [1e5], [1e5, 2e5]), "as many stiffnesses as loads"),
        (([1e4, 1e4], [1e5, 2e5], [1e5, 2e5]), "expected different loads"),
        (([1e4, -2e4], [1e5, 2e5], [1e5, 2e5]), "loads = .*: expected finite numbers above zero"),
        (([1e4], [np.nan], [1e5]), "cornering = .*: expected finite numbers above zero"),
        (([1e4], [1e5], [0.0]), "longitudinal = .*: expected finite numbers above zero"),
        ((["a"], [1e5], [1e5]), "expected numbers"),
        (([1e4, 50.0], [1e5, 500.0], [1e5, 500.0]), "where contact fades"),
        (([1e4, 2e4, 3e4], [2e5, 2e3, 3e5], [1e5] * 3), "k_y of the parabola .* is not positive"),
    ],
)
def test_points_that_cannot_be_met_are_refused(points: tuple[Any, Any, Any], sentence: str) -> None:
    with pytest.raises(TyreError, match=sentence):
        fit_stiffness(*points, **FRICTION)


def test_coefficients_that_follow_from_the_stiffnesses_cannot_be_given() -> None:
    with pytest.raises(TyreError, match="k_y follow from the stiffnesses"):
        fit_stiffness([1e4], [1e5], [1e5], k_y=10.0, **FRICTION)


def test_a_nominal_load_of_its_own_changes_no_slope() -> None:
    Fz = np.array([1e4, 2e4])
    one = fit_stiffness(Fz, [8e4, 1.5e5], [9e4, 1.7e5], **FRICTION)
    other = fit_stiffness(Fz, [8e4, 1.5e5], [9e4, 1.7e5], nominal_load=17e3, **FRICTION)
    loads = np.linspace(5e3, 3e4, 7)
    # the same polynomial about another load: rounding of a few operations
    assert np.allclose(slopes(one, 0, 0, loads).alpha.Fy, slopes(other, 0, 0, loads).alpha.Fy, rtol=1e-12, atol=0.0)


@pytest.mark.parametrize(
    ("others", "sentence"),
    [
        ({"mu_y": 0.9}, "fit_stiffness: mu_x: expected the friction too"),
        ({**FRICTION, "nominal_load": 0.0}, "nominal_load = 0.0: expected a number above zero, in N"),
        ({**FRICTION, "nominal_load": "heavy"}, "nominal_load = 'heavy': expected a number above zero"),
    ],
)
def test_what_a_tyre_needs_besides_is_asked_for(others: dict[str, Any], sentence: str) -> None:
    with pytest.raises(TyreError, match=sentence):
        fit_stiffness([1e4], [1e5], [1e5], **others)
