"""What every tyre model obeys, over random tyres."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from eom.errors import TyreError
from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula61, Tyre, slips, slopes
from eom.tyre.parameters import Values
from tests.tyre.tyres import (
    angles,
    any_tyre,
    cosine,
    dugoff,
    ellipse,
    leans,
    linear,
    loads,
    nonlinear,
    plain_61,
    ratios,
)

ROUNDING = 1e-13
"""Of the load: a handful of operations."""


def stiffnesses(tyre: Tyre, Fz: float) -> tuple[Values, Values]:
    """Longitudinal and cornering stiffness that the coefficients state, above lift-off."""
    match tyre:
        case Linear() | Dugoff():
            return tyre.longitudinal, tyre.cornering
        case MagicFormula():
            f = Fz / float(tyre.nominal_load) - 1.0
            return (
                Fz * (tyre.k_x + tyre.k_x_load * f + tyre.k_x_load2 * f**2),
                Fz * (tyre.k_y + tyre.k_y_load * f + tyre.k_y_load2 * f**2),
            )
        case MagicFormula61():
            f = Fz / float(tyre.FNOMIN) - 1.0
            return (
                Fz * (tyre.PKX1 + tyre.PKX2 * f) * np.exp(tyre.PKX3 * f),
                -tyre.PKY1 * tyre.FNOMIN * np.sin(tyre.PKY4 * np.arctan(Fz / tyre.FNOMIN / tyre.PKY2)),
            )
    raise AssertionError(tyre)


def frictions(tyre: Tyre, Fz: float) -> tuple[Values, Values]:
    """Longitudinal and lateral friction that the coefficients state."""
    match tyre:
        case Dugoff():
            return tyre.friction, tyre.friction
        case MagicFormula():
            f = Fz / float(tyre.nominal_load) - 1.0
            return tyre.mu_x + tyre.mu_x_load * f, tyre.mu_y + tyre.mu_y_load * f
        case MagicFormula61():
            f = Fz / float(tyre.FNOMIN) - 1.0
            return tyre.PDX1 + tyre.PDX2 * f, tyre.PDY1 + tyre.PDY2 * f
    raise AssertionError(tyre)


@given(any_tyre, loads)
def test_slopes_at_zero_slip_are_the_stated_stiffnesses(tyre: Tyre, Fz: float) -> None:
    found, (K_x, K_y) = slopes(tyre, 0.0, 0.0, Fz), stiffnesses(tyre, Fz)
    assert found.kappa.Fx == pytest.approx(K_x, rel=1e-13)
    assert found.alpha.Fy == pytest.approx(-K_y, rel=1e-13)
    assert [found.kappa.Fy, found.alpha.Fx] == pytest.approx([0.0, 0.0], abs=ROUNDING * Fz)


@given(any_tyre, loads)
def test_the_slope_over_camber_is_the_stated_stiffness(tyre: Tyre, Fz: float) -> None:
    match tyre:
        case Linear():
            stated = -tyre.camber
        case MagicFormula():
            stated = -Fz * tyre.k_gamma
        case MagicFormula61():
            stated = Fz * tyre.PKY6
        case _:
            stated = 0.0
    assert slopes(tyre, 0.0, 0.0, Fz).gamma.Fy == pytest.approx(stated, rel=1e-13)


@given(st.one_of(linear, dugoff, ellipse, cosine), st.floats(-40.0, 40.0), st.floats(-200.0, 200.0), loads)
def test_rolling_resistance_is_against_the_rotation_of_the_wheel(
    tyre: Tyre, v_x: float, omega: float, Fz: float
) -> None:
    radius = 0.3
    kappa = slips(v_x, 0.0, omega, radius)[1]
    found = tyre.forces(0.0, kappa, Fz, speed=v_x).My
    full = -tyre.rolling_resistance * tyre.radius * Fz  # type: ignore[attr-defined]
    tread = np.clip(omega * radius, -1.0, 1.0)
    sense = 1.5 * tread - 0.5 * tread**3
    # the tread's speed is a difference of larger ones
    assert found == pytest.approx(full * sense, abs=1e-11 * Fz)


@given(any_tyre, angles, ratios, loads)
def test_without_shifts_each_force_is_odd_in_its_slip_and_even_in_the_other(
    tyre: Tyre, alpha: float, kappa: float, Fz: float
) -> None:
    if isinstance(tyre, Dugoff):
        kappa = 0.0  # its braking and driving sides differ
    one, other = tyre.forces(alpha, kappa, Fz), tyre.forces(-alpha, -kappa, Fz)
    assert [one.Fx, one.Fy, one.Mz] == pytest.approx([-other.Fx, -other.Fy, -other.Mz], abs=ROUNDING * Fz)
    turned = tyre.forces(-alpha, kappa, Fz)
    assert [one.Fx, one.Fy] == pytest.approx([turned.Fx, -turned.Fy], abs=ROUNDING * Fz)


@given(any_tyre, angles, ratios, loads, leans)
def test_the_mirrored_state_has_the_mirrored_force(
    tyre: Tyre, alpha: float, kappa: float, Fz: float, gamma: float
) -> None:
    one, image = tyre.forces(alpha, kappa, Fz, gamma), tyre.forces(-alpha, kappa, Fz, -gamma)
    mirrored = [image.Fx, -image.Fy, -image.Mx, image.My, -image.Mz]
    assert list(one) == pytest.approx(mirrored, abs=ROUNDING * Fz)


@given(st.one_of(ellipse, cosine, plain_61()), loads)
def test_the_peak_is_friction_times_load(tyre: MagicFormula | MagicFormula61, Fz: float) -> None:
    slip = np.linspace(0.0, 1.5, 20001)
    mu_x, mu_y = frictions(tyre, Fz)
    # where the peak is within reach of slip; its curvature times half a step of the grid squared
    for force, mu in ((tyre.forces(0.0, slip, Fz).Fx, mu_x), (-tyre.forces(slip, 0.0, Fz).Fy, mu_y)):
        assert np.max(force) <= mu * Fz * (1.0 + 1e-14)
        if np.argmax(force) < len(slip) - 1:
            assert np.max(force) == pytest.approx(mu * Fz, rel=1e-5)


@given(st.one_of(dugoff, ellipse), loads)
def test_the_combined_force_stays_inside_the_ellipse_of_its_peaks(tyre: Dugoff | MagicFormula, Fz: float) -> None:
    alpha, kappa = np.meshgrid(np.linspace(-1.5, 1.5, 61), np.linspace(-1.5, 3.0, 91))
    found = tyre.forces(alpha, kappa, Fz)
    mu_x, mu_y = frictions(tyre, Fz)
    assert np.max((found.Fx / (mu_x * Fz)) ** 2 + (found.Fy / (mu_y * Fz)) ** 2) <= 1.0 + 1e-13


def dent(tyre: Tyre, Fz: float) -> float:
    """How far the set of forces that a tyre can give stays inside its convex hull, at most, relative to the hull."""
    alpha = np.concatenate([np.linspace(0.0, 0.3, 120), np.linspace(0.3, 1.5, 60)[1:]])
    kappa = np.concatenate([np.linspace(-0.999, -0.3, 60), np.linspace(-0.3, 0.3, 160)[1:-1], np.linspace(0.3, 3, 60)])
    found = tyre.forces(alpha[:, None], kappa, Fz)
    x, y = np.ravel(found.Fx), -np.ravel(found.Fy)
    hull = ConvexHull(np.column_stack([x, y])).equations
    angle, reach = np.arctan2(y, x), np.hypot(x, y)
    dents = []
    for low in np.arange(0.1, 3.0, 0.1):
        best = np.argmax(np.where((angle >= low) & (angle < low + 0.1), reach, 0.0))
        towards = hull[:, :2] @ [np.cos(angle[best]), np.sin(angle[best])]
        edge = np.min(-hull[towards > 1e-9, 2] / towards[towards > 1e-9])
        dents.append(1.0 - reach[best] / edge)
    return float(max(dents))


@given(nonlinear, loads)
def test_the_forces_that_a_tyre_can_give_make_a_convex_set(tyre: Tyre, Fz: float) -> None:
    # 1 % are gaps that the grid of slips leaves. No formula but Dugoff's is convex by law: curves that peak at
    # different slips, or other weights, dent the set; usual coefficients by no more than 3 %, a square by 29 %
    assert dent(tyre, Fz) <= (0.01 if isinstance(tyre, Dugoff) else 0.03)


def test_forces_that_are_not_combined_make_a_square() -> None:
    tyre = MagicFormula61(
        FNOMIN=4e3, UNLOADED_RADIUS=0.3, PCX1=1.6, PDX1=1, PKX1=25, PCY1=1.4, PDY1=1, PKY1=-20, PKY2=2, use="uncombined"
    )
    found = tyre.forces(0.15, 0.1, 4e3)
    assert np.hypot(found.Fx, found.Fy) > 1.4 * 4e3


@given(nonlinear, st.floats(-0.5, 0.5), st.floats(0.0, 1.0), loads, st.floats(2.0, 40.0))
def test_the_road_never_drives_a_towed_or_braked_wheel(
    tyre: Tyre, drift: float, braking: float, Fz: float, speed: float
) -> None:
    v_y, radius = drift * speed, 0.32
    omega = speed * (1.0 - braking) / radius
    alpha, kappa = slips(speed, v_y, omega, radius)
    found = tyre.forces(alpha, kappa, Fz, speed=speed)
    # force on the tread that slides, resistance moment on the wheel that turns
    power = found.Fx * (speed - omega * radius) + found.Fy * v_y + found.My * omega
    assert power <= ROUNDING * Fz * speed


# with a ratio below -0.94 the tread is slower than 1 m/s, where rolling resistance fades
@given(linear, angles, st.floats(-0.9, 1.0), loads, leans)
def test_the_linear_tyre_is_the_one_of_the_linear_models(
    tyre: Linear, alpha: float, kappa: float, Fz: float, gamma: float
) -> None:
    found = tyre.forces(alpha, kappa, Fz, gamma)
    assert found.Fx == pytest.approx(tyre.longitudinal * kappa, abs=ROUNDING * Fz)
    assert found.Fy == pytest.approx(-tyre.cornering * alpha - tyre.camber * gamma, rel=1e-13, abs=ROUNDING * Fz)
    assert found.Mz == pytest.approx(tyre.trail * tyre.cornering * alpha, rel=1e-13, abs=ROUNDING * Fz)
    assert found.My == pytest.approx(-tyre.rolling_resistance * tyre.radius * Fz, rel=1e-13)


@given(dugoff, st.floats(0.001, 0.5), st.floats(0.0, 0.88), loads)
def test_dugoff_is_the_formula_of_his_paper(tyre: Dugoff, alpha: float, braking: float, Fz: float) -> None:
    """As written for a braked wheel with slip s = -kappa, SAE paper 700377."""
    C_s, C_a, s, slope = tyre.longitudinal, tyre.cornering, braking, np.tan(alpha)
    ratio = tyre.friction * Fz * (1.0 - s) / (2.0 * np.sqrt((C_s * s) ** 2 + (C_a * slope) ** 2))
    share = ratio * (2.0 - ratio) if ratio < 1.0 else 1.0
    found = tyre.forces(alpha, -braking, Fz)
    assert found.Fx == pytest.approx(-C_s * s / (1.0 - s) * share, rel=1e-12)
    assert found.Fy == pytest.approx(-C_a * slope / (1.0 - s) * share, rel=1e-12)


@given(ellipse, st.floats(-0.6, 0.6), loads)
def test_the_magic_formula_is_the_one_of_the_thesis(tyre: MagicFormula, slip: float, Fz: float) -> None:
    """(3.41) of Zhu's thesis, and (3.10), whose slip angle has the other sign."""
    tyre = dataclasses.replace(tyre, rolling_resistance=0.0)
    f = Fz / tyre.nominal_load - 1.0
    for force, K, (C, E), mu in (
        (tyre.forces(0.0, slip, Fz).Fx, 0, (tyre.C_x + tyre.C_x_load * f, tyre.E_x), tyre.mu_x + tyre.mu_x_load * f),
        (
            tyre.forces(-slip, 0.0, Fz).Fy,
            1,
            (tyre.C_y + tyre.C_y_load * f, tyre.E_y + tyre.E_y_load * f),
            tyre.mu_y + tyre.mu_y_load * f,
        ),
    ):
        D = mu * Fz
        B = stiffnesses(tyre, Fz)[K] / (C * D)
        phi = (1.0 - E) * slip + E / B * np.arctan(B * slip)
        assert force == pytest.approx(D * np.sin(C * np.arctan(B * phi)), abs=1e-12 * Fz)


@given(st.one_of(ellipse, cosine), angles, loads)
def test_the_trail_of_the_thesis_formula_falls_as_the_square_of_a_cosine(
    tyre: MagicFormula, alpha: float, Fz: float
) -> None:
    found, slip = tyre.forces(alpha, 0.0, Fz), stiffnesses(tyre, Fz)[1] * alpha / (frictions(tyre, Fz)[1] * Fz)
    assert found.Mz == pytest.approx(-tyre.trail * np.cos(np.arctan(slip)) ** 2 * found.Fy, abs=ROUNDING * Fz)


@given(cosine, angles, ratios, loads)
def test_cosine_weighting_is_the_one_of_the_book(tyre: MagicFormula, alpha: float, kappa: float, Fz: float) -> None:
    """(4.E51) and (4.E59) of Pacejka 2012, without shifts and curvature."""
    G_x = np.cos(tyre.RCX1 * np.arctan(tyre.RBX1 * np.cos(np.arctan(tyre.RBX2 * kappa)) * alpha))
    G_y = np.cos(tyre.RCY1 * np.arctan(tyre.RBY1 * np.cos(np.arctan(tyre.RBY2 * alpha)) * kappa))
    found = tyre.forces(alpha, kappa, Fz)
    assert found.Fx == pytest.approx(G_x * tyre.forces(0.0, kappa, Fz).Fx, rel=1e-12, abs=ROUNDING * Fz)
    assert found.Fy == pytest.approx(G_y * tyre.forces(alpha, 0.0, Fz).Fy, rel=1e-12, abs=ROUNDING * Fz)


def test_friction_that_vanishes_at_a_load_gives_no_force_there() -> None:
    tyre = MagicFormula(nominal_load=4e3, mu_x=1.0, mu_x_load=-0.5, mu_y=1.0, mu_y_load=-0.5, k_x=20, k_y=15, trail=0.1)
    found = tyre.forces([0.02, 0.0], 0.01, 12e3)  # type: ignore[arg-type]
    assert np.array_equal(np.array([*found]), np.zeros((5, 2)))


def test_numbers_of_any_kind_are_taken_as_float64() -> None:
    tyre = MagicFormula(nominal_load=np.int64(4000), mu_x=1, mu_y=np.float32(1), k_x=20, k_y=15)  # type: ignore[arg-type]
    found = tyre.forces(np.float32(0.0), 0, np.int32(4000))  # type: ignore[arg-type]
    assert [float(value) for value in found] == [0.0] * 5


def test_rolling_resistance_needs_a_radius() -> None:
    with pytest.raises(TyreError, match="Linear: rolling_resistance without a radius: expected a rolling radius too"):
        Linear(nominal_load=4e3, cornering=6e4, rolling_resistance=0.01)
