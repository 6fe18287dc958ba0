"""Parameters, speeds, variants and names that cannot be are refused in a sentence; axes turn there and back."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings

import eom
from eom.closed_form import (
    BTrainBraked,
    BTrainYawPlane,
    BTrainYawRoll,
    StateSpace,
    TractorSemitrailer,
    axes,
    b_train_yaw_plane,
    b_train_yaw_roll,
    brakes,
    tractor_semitrailer,
)
from tests.closed_form.symbols import U, symbolic
from tests.closed_form.varied import in_floats, varied


def test_every_impossible_parameter_is_named() -> None:
    with pytest.raises(eom.EomError) as caught:
        TractorSemitrailer(m1=-1.0, I_zz2=0.0, b12=float("nan"))
    assert str(caught.value).splitlines() == [
        "TractorSemitrailer.b12: expected a finite number, got nan",
        "TractorSemitrailer.m1: expected a positive number, got -1",
        "TractorSemitrailer.I_zz2: expected a positive number, got 0",
    ]


def test_what_is_neither_a_real_number_nor_a_symbol_is_refused() -> None:
    with pytest.raises(eom.EomError, match=r"expected real numbers or symbols, got m1: 'a', m2: None"):
        BTrainYawPlane(m1="a", m2=None)  # type: ignore[arg-type]
    with pytest.raises(eom.EomError, match="speed U: expected a number of m/s or a symbol, got '30'"):
        b_train_yaw_plane.matrices(BTrainYawPlane(), "30")  # type: ignore[arg-type]
    with pytest.raises(eom.EomError, match="yaw moments: expected finite numbers"):
        brakes.brake_pressures(BTrainBraked(), float("nan"), 0.0)


def test_a_sprung_mass_above_the_whole_one_is_refused() -> None:
    with pytest.raises(eom.EomError, match=r"BTrainYawRoll.m_u1: expected a positive number, got -742"):
        BTrainYawRoll(m_s1=9000.0)


@pytest.mark.parametrize("speed", [0.0, -3.0, float("nan"), float("inf"), 0])
def test_a_speed_without_slip_angles_is_refused(speed: float) -> None:
    with pytest.raises(eom.EomError, match="speed U: expected a positive number"):
        b_train_yaw_plane.state_space(BTrainYawPlane(), speed)


def test_an_unknown_variant_is_refused() -> None:
    with pytest.raises(eom.EomError, match="variant: expected 'thesis' or 'full', got 'both'"):
        b_train_yaw_roll.system(BTrainYawRoll(), 20.0, "both")  # type: ignore[arg-type]


def test_symbols_are_refused_where_numbers_are_needed() -> None:
    with pytest.raises(eom.EomError, match="J: expected numbers to solve with, got symbols"):
        b_train_yaw_plane.system(symbolic(BTrainYawPlane), U)


def test_pressures_that_cannot_be_are_named() -> None:
    pressures = np.zeros((6, 2))
    pressures[0, 1], pressures[5, 0] = -2.0, np.nan
    with pytest.raises(eom.EomError, match=r"from zero on, got axle 4 right: -2 Pa, axle 9 left: nan Pa"):
        brakes.brake_moments(BTrainBraked(), pressures)
    with pytest.raises(eom.EomError, match=r"expected shape \(6, 2\).*got \(12,\)"):
        brakes.brake_moments(BTrainBraked(), np.zeros(12))


def test_names_without_a_sign_are_refused() -> None:
    with pytest.raises(eom.EomError, match="got speed, omega_1"):
        axes.signs(["beta_1", "speed", "omega_1"])


def test_matrices_of_numbers_are_floats_whatever_the_numbers_are() -> None:
    p = TractorSemitrailer(m1=6525, m2=11665, I_zz1=20616, I_zz2=113580)
    for own, other in zip(
        tractor_semitrailer.matrices(p, 20), tractor_semitrailer.matrices(TractorSemitrailer(), 20.0), strict=True
    ):
        assert own.dtype == float
        np.testing.assert_array_equal(own, other)


def test_matrices_of_fractions_stay_exact() -> None:
    p = TractorSemitrailer(**{name: sp.Rational(str(value)) for name, value in vars(TractorSemitrailer()).items()})
    M = tractor_semitrailer.matrices(p, sp.Rational(100, 3)).M
    assert M[0, 2] == sp.Rational(100, 3) * 18190


def test_the_sign_of_each_axis_change_is_that_of_a_half_turn_about_x() -> None:
    turn = np.diag([1.0, -1.0, -1.0])
    # vectors, and axial vectors alike as the turn is a rotation: x keeps its sign, y and z change it
    vectors = {"F_x": 0, "M_x": 0, "phi_1": 0, "phi_dot_2": 0, "phi_t_3": 0, "phi_t_dot_1": 0, "U": 0}
    vectors |= {"F_y_3": 1, "a_y_1": 1, "a_y_cg_2": 1, "v_1": 1, "Y_3": 1, "beta_2": 1}
    vectors |= {"psi_1": 2, "psi_dot_1": 2, "M_z_2": 2, "delta_1f": 2, "Delta_psi": 2, "Delta_psi_dot": 2}
    np.testing.assert_array_equal(axes.signs(list(vectors)), [turn[k, k] for k in vectors.values()])


@given(varied(BTrainYawRoll))
@settings(max_examples=10, deadline=None)
def test_turning_the_axes_twice_gives_the_model_back_and_once_keeps_its_roots(p: BTrainYawRoll) -> None:
    sae = b_train_yaw_roll.state_space(in_floats(p), 25.0)
    iso = axes.other_axes(sae)
    back: StateSpace = axes.other_axes(iso)
    for name in ("A", "B", "C", "D"):
        np.testing.assert_array_equal(getattr(back, name), getattr(sae, name))
    steer = sae.inputs.index("delta_11")
    rate, roll = sae.states.index("psi_dot_1"), sae.outputs.index("phi_1")
    # a steer angle and the yaw rate that follows it both change their signs, the roll angle stays
    assert iso.B[rate, steer] == sae.B[rate, steer]
    np.testing.assert_array_equal(iso.C[roll], axes.signs(sae.states) * sae.C[roll])
    # similarity by signs: the same products
    np.testing.assert_allclose(np.poly(iso.A), np.poly(sae.A), rtol=1e-9)
