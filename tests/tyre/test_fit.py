"""Least squares of coefficients."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import curve_fit

from eom.errors import TyreError
from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula52, MagicFormula61, Tyre, fit
from eom.tyre.fitting.least_squares import tyre_with
from eom.tyre.parameters import coefficients
from eom.tyre.slopes import STEP, derivative
from tests.tyre.random_sets import random_set_52, random_set_61
from tests.tyre.tyres import cosine, dugoff, ellipse

NAMES: dict[Any, tuple[str, ...]] = {
    MagicFormula: ("mu_x", "mu_y", "mu_y_load", "k_x", "k_y", "k_y_load", "C_x", "C_y", "E_y", "trail"),
    Dugoff: ("friction", "cornering", "longitudinal", "trail"),
}
CAR = MagicFormula(nominal_load=4000.0, mu_x=1.0, mu_y=0.9, k_x=20.0, k_y=15.0, trail=0.03)


def points(seed: int, count: int) -> dict[str, Any]:
    """Random working points at 60 km/h, up to well beyond the peaks."""
    rng = np.random.default_rng(seed)
    return {
        "alpha": rng.uniform(-0.3, 0.3, count),
        "kappa": rng.uniform(-0.3, 0.3, count),
        "Fz": rng.uniform(1000.0, 8000.0, count),
        "gamma": rng.uniform(-0.1, 0.1, count),
    }


def measured(tyre: Tyre, where: dict[str, Any], noise: float = 0.0) -> dict[str, Any]:
    """What the tyre gives at points, with noise on the forces [N] and a tenth of it on the moments [N m]."""
    rng = np.random.default_rng(7)
    sizes = np.array([1.0, 1.0, 0.1, 0.1, 0.1]) * noise
    channels = tyre.forces(**where)._asdict().items()
    return where | {
        name: value + size * rng.standard_normal(len(where["Fz"]))
        for (name, value), size in zip(channels, sizes, strict=True)
    }


@settings(max_examples=30)
@given(st.one_of(ellipse, cosine, dugoff), st.integers(0, 1000))
def test_the_coefficients_behind_synthetic_data_are_found(tyre: Any, seed: int) -> None:
    names = [name for name in NAMES[type(tyre)] if name != "trail" or tyre.trail > 1e-3]
    rng = np.random.default_rng(seed)
    start = dataclasses.replace(
        tyre, **{name: getattr(tyre, name) * (1.0 + 0.05 * rng.uniform(-1.0, 1.0)) for name in names}
    )
    found = fit(start, measured(tyre, points(seed, 200)), names)
    # data without noise: what is left is rounding, seen through the condition of the problem
    assert np.allclose(found.values, [getattr(tyre, name) for name in names], rtol=1e-7, atol=1e-8)
    assert all(rest.per_load < 1e-9 for rest in found.residuals.values())
    assert [getattr(found.tyre, name) for name in names] == found.values.tolist()


@pytest.mark.parametrize("seed", range(3))
def test_the_magic_formula_61_is_found_among_all_its_terms(seed: int) -> None:
    numbers: dict[str, Any] = random_set_61(seed)
    tyre = MagicFormula61(**numbers)
    names = ("PCX1", "PDX1", "PKX1", "PEX1", "PCY1", "PDY1", "PKY1", "PKY2", "PEY1", "RBX1", "RBY1", "QBZ1", "QDZ1")
    start = dataclasses.replace(tyre, **{name: 1.1 * numbers[name] for name in names})
    found = fit(start, measured(tyre, points(seed, 500)), names)
    assert np.allclose(found.values, [numbers[name] for name in names], rtol=1e-8, atol=0.0)
    assert found.warnings == ()


@pytest.mark.parametrize("tyre", ["6.1", "6.1 book", "5.2", "thesis", "dugoff"])
def test_derivatives_by_complex_coefficients_are_those_of_differences(tyre: str) -> None:
    new: dict[str, Any] = random_set_61(1)
    old: dict[str, Any] = random_set_52(1)
    model: Any = {
        "6.1": MagicFormula61(**new),
        "6.1 book": MagicFormula61(**new, form="book"),
        "5.2": MagicFormula52(**old),
        "thesis": CAR,
        "dugoff": Dugoff(nominal_load=4000.0, cornering=8e4, longitudinal=9e4, friction=0.9, trail=0.03),
    }[tyre]
    where = points(3, 40)
    scale = np.array([4000.0, 4000.0, 400.0, 400.0, 400.0])[:, np.newaxis]
    for item in coefficients(model):
        value = float(getattr(model, item.name))
        step = 1e-5 * max(abs(value), 0.1)
        exact, up, down = (
            np.array(tyre_with(model, [item.name], np.array([value + shift])).forces(**where)) / scale
            for shift in (1j * STEP, step, -step)
        )
        difference = (up - down) / (2.0 * step)
        # central differences err by the step squared; per unit of the relative change of the coefficient
        unit = max(abs(value), 0.1)
        assert np.allclose(derivative(exact) * unit, difference * unit, rtol=1e-6, atol=1e-6), item.name


def test_values_errors_and_correlations_are_those_of_scipy() -> None:
    names = ("mu_y", "k_y", "C_y")
    data = measured(
        CAR, {"alpha": np.linspace(-0.3, 0.3, 61), "kappa": np.zeros(61), "Fz": np.full(61, 4000.0)}, noise=40.0
    )
    data = {name: data[name] for name in ("alpha", "Fz", "Fy")}

    def lateral(alpha: Any, *values: float) -> Any:
        changed: dict[str, Any] = dict(zip(names, values, strict=True))
        return dataclasses.replace(CAR, **changed).forces(alpha, 0.0, 4000.0).Fy

    found = fit(CAR, data, names)
    values, covariance = curve_fit(lateral, data["alpha"], data["Fy"], p0=[0.8, 14.0, 1.4], xtol=1e-12, ftol=1e-12)
    errors = np.sqrt(np.diag(covariance))
    # SciPy's Jacobian is one of differences
    assert np.allclose(found.values, values, rtol=1e-6, atol=0.0)
    assert np.allclose(found.errors, errors, rtol=1e-4, atol=0.0)
    assert np.allclose(found.correlation, covariance / np.outer(errors, errors), rtol=0.0, atol=1e-4)


def test_a_linear_tyre_has_the_textbook_regression() -> None:
    tyre = Linear(nominal_load=4000.0, cornering=6e4, camber=3e3)
    where = {"alpha": points(1, 50)["alpha"], "Fz": np.full(50, 4000.0), "gamma": points(1, 50)["gamma"]}
    data = where | {"Fy": measured(tyre, where | {"kappa": np.zeros(50)}, noise=100.0)["Fy"]}
    found = fit(tyre, data, ["cornering", "camber"])
    X = -np.column_stack([where["alpha"], where["gamma"]])
    best, rest, *_ = np.linalg.lstsq(X, data["Fy"])
    covariance = np.linalg.inv(X.T @ X) * rest[0] / 48.0
    # the sum of squares is flat at its minimum: it tells coefficients to the root of rounding in their errors
    assert np.all(np.abs(found.values - best) < 1e-6 * found.errors)
    assert np.allclose(found.errors, np.sqrt(np.diag(covariance)), rtol=1e-9, atol=0.0)
    assert np.isclose(found.correlation[0, 1], covariance[0, 1] / np.prod(found.errors), rtol=0.0, atol=1e-9)
    assert np.isclose(found.residuals["Fy"].value, np.sqrt(rest[0] / 50.0), rtol=1e-9)
    assert np.isclose(found.residuals["Fy"].per_load, np.sqrt(rest[0] / 50.0) / 4000.0, rtol=1e-9)


def test_the_standard_error_covers_the_truth_as_often_as_it_says() -> None:
    # 200 fits: the share within one standard error is 0.68 with a spread of 0.033; four spreads are allowed
    where = {"alpha": np.linspace(-0.2, 0.2, 41), "Fz": np.full(41, 4000.0)}
    pure = np.asarray(CAR.forces(where["alpha"], 0.0, 4000.0).Fy)
    rng = np.random.default_rng(1)
    fits = [fit(CAR, where | {"Fy": pure + 50.0 * rng.standard_normal(41)}, ["mu_y", "k_y"]) for _ in range(200)]
    inside = np.array([np.abs(found.values - [0.9, 15.0]) < found.errors for found in fits])
    assert np.all(np.abs(inside.mean(axis=0) - 0.683) < 4.0 * 0.033)


def test_bounds_are_kept_and_told() -> None:
    data = {"alpha": np.linspace(-0.3, 0.3, 21), "Fz": np.full(21, 4000.0)}
    tyre = dataclasses.replace(CAR, E_y=0.5)
    steep = np.asarray(tyre_with(tyre, ["E_y"], np.array([1.4])).forces(**data, kappa=0.0).Fy)
    found = fit(tyre, data | {"Fy": steep}, ["E_y"])
    assert np.isclose(found.values[0], 1.0, rtol=0.0, atol=1e-6)
    assert any("E_y = 1 stands at its bound" in sentence for sentence in found.warnings)


def test_coefficients_that_the_data_do_not_determine_are_named() -> None:
    numbers: dict[str, Any] = random_set_61(0)
    tyre = MagicFormula61(**numbers)
    found = fit(tyre, measured(tyre, points(1, 100), noise=20.0), ["PDX1", "LMUX", "PCY1", "LMUV"])
    told = "\n".join(found.warnings)
    # friction is the product of both; LMUV acts only in the book's form
    assert "the data determine LMUV not at all" in told
    assert "PCY1" not in told
    assert np.isfinite(found.errors).tolist() == [True, True, True, False]
    plain = dataclasses.replace(tyre, PDX2=0.0, PVX1=0.0, PVX2=0.0, SSZ1=0.0, SSZ2=0.0, SSZ3=0.0, SSZ4=0.0)
    found = fit(plain, measured(plain, points(1, 100), noise=20.0), ["PDX1", "LMUX", "PCY1"])
    assert "the data determine PDX1 only together with LMUX: its value is one of many" in found.warnings
    assert "the data determine LMUX only together with PDX1: its value is one of many" in found.warnings
    assert np.isfinite(found.errors).tolist() == [False, False, True]
    assert np.isnan(found.correlation).tolist() == [[True] * 3, [True] * 3, [True, True, False]]


def test_nothing_that_is_passed_in_is_changed() -> None:
    data = measured(CAR, points(1, 30))
    before = {name: np.array(values) for name, values in data.items()}
    start = dataclasses.replace(CAR, mu_y=0.7)
    fit(start, data, ["mu_y"])
    assert start == dataclasses.replace(CAR, mu_y=0.7)
    assert all(np.array_equal(before[name], data[name]) for name in data)


GOOD: dict[str, Any] = {"alpha": [0.1, 0.2], "Fz": [4000.0, 4000.0], "Fy": [-3000.0, -3500.0]}


@pytest.mark.parametrize(
    ("changes", "names", "sentences"),
    [
        ({"slip": [1.0, 2.0]}, ["mu_y"], ["column 'slip' is not known: expected some of alpha, kappa, Fz"]),
        ({"Fy": [np.nan, 1.0]}, ["mu_y"], ["column 'Fy': 1 of 2 points are no finite numbers, the first at index 0"]),
        ({"Fy": ["a", "b"]}, ["mu_y"], ["column 'Fy': expected numbers"]),
        ({"Fy": [1.0, 2.0, 3.0]}, ["mu_y"], ["columns of different shapes: alpha (2,), Fz (2,), Fy (3,)"]),
        ({"Fy": [[1.0, 2.0]]}, ["mu_y"], ["column 'Fy': expected one dimension, got shape (1, 2)"]),
        ({"Fz": [4000.0, 0.0]}, ["mu_y"], ["column 'Fz': expected loads above 0 N, got 0 N"]),
        ({"alpha": [], "Fz": [], "Fy": []}, ["mu_y"], ["column 'Fz': has no points"]),
        ({"Fy": None}, ["mu_y"], ["nothing measured: expected at least one of the columns Fx, Fy, Mx, My, Mz"]),
        (
            {"Fz": None, "alpha": None},
            ["mu_y"],
            ["no column 'Fz': expected the load of each point", "no slip: expected a column 'alpha' [rad] or 'kappa'"],
        ),
        ({}, ["mu"], ["MagicFormula has no coefficient 'mu'; did you mean 'mu_y'?"]),
        ({}, ["mu_y", "mu_y"], ["mu_y is named twice"]),
        ({}, [], ["no coefficient is named"]),
        ({}, ["mu_y", "k_y", "C_y"], ["2 measured numbers cannot give 3 coefficients"]),
    ],
)
def test_bad_data_and_names_get_their_sentences(
    changes: dict[str, Any], names: list[str], sentences: list[str]
) -> None:
    data = {name: values for name, values in (GOOD | changes).items() if values is not None}
    with pytest.raises(TyreError) as caught:
        fit(CAR, data, names)
    for sentence in sentences:
        assert f"fit: {sentence}" in str(caught.value)


def test_a_stack_of_tyres_cannot_be_fitted() -> None:
    with pytest.raises(TyreError, match="mu_y is that of several tyres"):
        fit(tyre_with(CAR, ["mu_y"], np.array([[0.9, 0.8]])), GOOD, ["mu_y"])
