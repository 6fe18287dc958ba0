"""Figures over load, and curves."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings

from eom.errors import TyreError
from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula61, read_tir, relaxation_lengths
from eom.tyre.carpet import carpet
from eom.tyre.characteristics import characteristics, usual_loads
from eom.tyre.usual_range import range_of
from tests.tyre.tyres import ellipse, plain_61

CAR = read_tir(Path(__file__).parents[2] / "vehicles" / "tyres" / "passenger_car.tir").tyre
LOADS = np.array([1000.0, 4000.0, 7000.0])


@settings(max_examples=30)
@given(ellipse)
def test_figures_of_the_thesiss_formula_are_its_coefficients(tyre: MagicFormula) -> None:
    figures = characteristics(tyre, LOADS)
    f = LOADS / tyre.nominal_load - 1.0
    assert np.allclose(figures.cornering, LOADS * (tyre.k_y + f * (tyre.k_y_load + f * tyre.k_y_load2)), rtol=1e-12)
    assert np.allclose(figures.longitudinal, LOADS * (tyre.k_x + f * (tyre.k_x_load + f * tyre.k_x_load2)), rtol=1e-12)
    assert np.allclose(figures.trail, tyre.trail, rtol=1e-12, atol=1e-15)
    alpha, kappa = (np.linspace(0.0, end, 2001)[:, np.newaxis] for end in (0.5 * np.pi, 1.0))
    for peak, mu, forces in (
        (figures.side, tyre.mu_y + tyre.mu_y_load * f, -tyre.forces(alpha, 0.0, LOADS).Fy),
        (figures.drive, tyre.mu_x + tyre.mu_x_load * f, tyre.forces(0.0, kappa, LOADS).Fx),
    ):
        # where the largest of many forces is not the last one there is a peak, and it is D
        there = np.argmax(forces, axis=0) < len(alpha) - 1
        assert np.all(np.isfinite(peak.friction[there]))
        seen = np.isfinite(peak.friction)
        assert np.allclose(peak.friction[seen], mu[seen], rtol=1e-12, atol=0.0)


@settings(max_examples=20)
@given(plain_61())
def test_peaks_of_the_magic_formula_are_pdx1_and_pdy1_at_nominal_load(tyre: MagicFormula61) -> None:
    figures = characteristics(tyre, tyre.FNOMIN)
    # with these shapes and stiffnesses both peaks are well inside
    assert np.isclose(figures.side.friction[0], tyre.PDY1, rtol=1e-12)
    assert np.isclose(figures.drive.friction[0], tyre.PDX1, rtol=1e-12)
    assert np.isclose(figures.longitudinal[0], tyre.PKX1 * tyre.FNOMIN, rtol=1e-12)


def test_a_slip_of_a_peak_has_the_force_of_the_peak() -> None:
    figures = characteristics(CAR, LOADS)
    assert np.allclose(
        np.abs(CAR.forces(figures.side.slip, 0.0, LOADS).Fy) / LOADS, figures.side.friction, rtol=1e-14, atol=0.0
    )
    assert np.allclose(
        np.abs(CAR.forces(0.0, figures.drive.slip, LOADS).Fx) / LOADS, figures.drive.friction, rtol=1e-14, atol=0.0
    )
    every = np.abs(CAR.forces(np.linspace(-1.5, 1.5, 3001)[:, np.newaxis], 0.0, LOADS).Fy).max(axis=0) / LOADS
    # the largest of many forces lies below the peak by the square of their distance
    assert np.all(figures.side.friction >= every)
    assert np.allclose(figures.side.friction, every, rtol=1e-5)


def test_what_a_model_does_not_have_is_no_number() -> None:
    for tyre in (
        Linear(nominal_load=4000.0, cornering=6e4),
        Dugoff(nominal_load=4000.0, cornering=6e4, longitudinal=8e4, friction=0.9),
    ):
        figures = characteristics(tyre, LOADS)
        assert np.all(np.isnan([figures.side.friction, figures.drive.friction, figures.side.slip]))
        assert np.all(np.isnan(figures.relaxation.alpha))
        assert np.all(np.isnan(figures.relaxation.kappa))
    found, expected = characteristics(CAR, LOADS).relaxation, relaxation_lengths(CAR, LOADS)
    assert np.array_equal(found.alpha, expected.alpha)
    assert np.array_equal(found.kappa, expected.kappa)


def test_a_carcass_without_stiffness_has_no_relaxation_length() -> None:
    # the lateral stiffness 1 + PCFY1 dfz vanishes at half the nominal load
    assert isinstance(CAR, MagicFormula61)
    figures = characteristics(dataclasses.replace(CAR, PCFY1=2.0), np.array([2000.0, 4000.0]))
    assert np.isfinite(figures.relaxation.alpha).tolist() == [False, True]


def test_loads_are_those_within_the_range() -> None:
    assert isinstance(CAR, MagicFormula61)
    assert usual_loads(CAR).tolist() == [1000.0, 2000.0, 3000.0, 4000.0, 5000.0, 6000.0, 8000.0]
    narrow = dataclasses.replace(CAR, FZMIN=4100.0, FZMAX=4900.0)
    assert usual_loads(narrow).tolist() == [4100.0, 4900.0]
    assert range_of(narrow).Fz == (4100.0, 4900.0)


@pytest.mark.parametrize("load", [0.0, -1.0])
def test_figures_need_a_load(load: float) -> None:
    with pytest.raises(TyreError, match="expected loads above zero"):
        characteristics(CAR, load)


def test_a_carpet_holds_the_forces_of_its_own_slips() -> None:
    curves = carpet(CAR, "car")
    for sweep in (curves.side, curves.drive, curves.ellipse):
        forces = CAR.forces(sweep.alpha, sweep.kappa, sweep.Fz)
        assert all(np.array_equal(one, other) for one, other in zip(sweep.forces, forces, strict=True))
    assert curves.side.Fz[:, 0].tolist() == [1000.0, 2000.0, 4000.0, 6000.0, 8000.0]
    assert np.allclose(np.rad2deg(curves.ellipse.alpha[:, 0]), [-15, -8, -4, -2, -1, 0, 1, 2, 4, 8, 15], atol=1e-12)
    assert not np.any(curves.side.kappa)
    assert not np.any(curves.drive.alpha)


def test_a_carpet_draws_its_four_panels() -> None:
    figure = carpet(CAR, "car").plot()
    labels = [(axes.get_xlabel(), axes.get_ylabel(), len(axes.lines)) for axes in figure.axes]
    # the two axes through zero are lines as well
    assert labels == [
        ("slip angle [deg]", "Fy [kN]", 7),
        ("longitudinal slip", "Fx [kN]", 7),
        ("Fx at 4 kN load [kN]", "Fy at 4 kN load [kN]", 13),
        ("slip angle [deg]", "Mz [N m]", 7),
    ]


@pytest.mark.parametrize(("use", "panels"), [("longitudinal", ["Fx [kN]"]), ("lateral", ["Fy [kN]", "Mz [N m]"])])
def test_a_carpet_draws_no_panel_of_forces_that_do_not_act(use: str, panels: list[str]) -> None:
    figure = carpet(dataclasses.replace(CAR, use=use), "car").plot()  # type: ignore[arg-type]
    assert [axes.get_ylabel() for axes in figure.axes] == panels
