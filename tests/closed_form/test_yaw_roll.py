"""The yaw-roll model equals Lagrange's equations, exactly; what the thesis drops of them is three kinds of terms."""

from dataclasses import fields, replace
from typing import Any

import numpy as np
import sympy as sp
from hypothesis import given, settings

from eom.closed_form import BTrainYawRoll, b_train_yaw_plane, b_train_yaw_roll
from eom.closed_form.b_train_roll_balance import STATES
from tests.closed_form import dropped, symbols
from tests.closed_form.roll_lagrange import b_train_by_lagrange
from tests.closed_form.symbols import names, symbolic
from tests.closed_form.test_printed import elements, equal, own_elements
from tests.closed_form.varied import SPEEDS, close, in_floats, varied


class Numbers:
    """Lagrange's equations at given parameters, in fractions, as dz/dt = A z + B u with z = q, dq/dt.

    The rows of T give the thesis's states by z, and C z + D u the accelerations of the points of the roll axes and of
    the whole-mass centres.
    """

    def __init__(self, p: BTrainYawRoll, speed: sp.Integer) -> None:
        values = {sp.Symbol(name): value for name, value in vars(p).items()} | {symbols.U: speed}
        mass, damping, stiffness, control, axis, centre, yaw = (
            matrix.xreplace(values) for matrix in b_train_by_lagrange()
        )
        size = mass.rows
        eye, none = sp.eye(size), sp.zeros(size)
        inverse = mass.inv()
        self.A = sp.Matrix.vstack(sp.Matrix.hstack(none, eye), inverse * sp.Matrix.hstack(-stiffness, -damping))
        self.B = sp.Matrix.vstack(sp.zeros(size, control.cols), inverse * control)
        rate = sp.Matrix.hstack(none, eye)
        place = sp.Matrix.hstack(eye, none)
        rows: dict[str, Any] = {}
        for i in range(3):
            rows[f"phi_{i + 1}"], rows[f"phi_t_{i + 1}"] = place[4 + i, :], place[7 + i, :]
            rows[f"phi_dot_{i + 1}"], rows[f"phi_t_dot_{i + 1}"] = rate[4 + i, :], rate[7 + i, :]
            rows[f"psi_dot_{i + 1}"] = yaw[i, :] * rate
            # lateral velocity in the unit's own axes, over U
            rows[f"beta_{i + 1}"] = axis[i, :] * rate / speed - yaw[i, :] * place
        self.T = sp.Matrix.vstack(*(rows[name] for name in STATES))
        accelerated = sp.Matrix.vstack(axis, centre) * rate
        self.C, self.D = accelerated * self.A, accelerated * self.B


def exact(matrix: Any) -> Any:
    """A matrix of fractions, also where it has no parameter in it."""
    return sp.Matrix(matrix).applyfunc(sp.Rational)


@settings(max_examples=5, deadline=None)
@given(varied(BTrainYawRoll), SPEEDS)
def test_the_full_variant_is_lagranges_exactly(p: BTrainYawRoll, speed: sp.Integer) -> None:
    lagrange = Numbers(p, speed)
    M, N, Q, R, W = (exact(matrix) for matrix in b_train_yaw_roll.matrices(p, speed, "full"))
    assert M * lagrange.T * lagrange.A == -N * lagrange.T
    assert M * lagrange.T * lagrange.B[:, 0] == -Q
    assert M * lagrange.T * lagrange.B[:, 1:3] == -W
    # both roll moments of the tractor act on the same pair of bodies
    assert M * lagrange.T * lagrange.B.extract(list(range(20)), [3, 3, 4, 5]) == -R


@settings(max_examples=5, deadline=None)
@given(varied(BTrainYawRoll), SPEEDS)
def test_the_full_variants_accelerations_are_lagranges(p: BTrainYawRoll, speed: sp.Integer) -> None:
    lagrange, own = Numbers(p, speed), b_train_yaw_roll.state_space(in_floats(p), float(speed), "full")
    rows = [*range(3), *range(9, 12)]
    inputs = [0, 1, 2, 3, 3, 4, 5]
    # double precision against fractions, through an inverse of 18 by 18
    assert close(own.C[rows] @ np.array(lagrange.T, dtype=float), lagrange.C, 1e-11)
    assert close(own.D[rows], lagrange.D.extract(list(range(6)), inputs), 1e-11)


def test_the_thesis_is_the_full_variant_less_three_kinds_of_terms() -> None:
    p = symbolic(BTrainYawRoll)
    full, thesis = (b_train_yaw_roll.matrices(p, symbols.U, variant) for variant in ("full", "thesis"))
    kinds = (
        dropped.UNSPRUNG_ROLL_IN_THE_SIDE_BALANCE,
        dropped.ROLL_YAW_PRODUCTS,
        dropped.TYRES_SWING_ABOUT_THE_ROLL_AXIS,
    )
    expected: dict[tuple[int, int], Any] = {}
    for kind in kinds:
        for place, value in elements(kind, names(p)).items():
            expected[place] = expected.get(place, 0) + value
    difference = own_elements(full.M - thesis.M)
    assert {place for place, value in difference.items() if not equal(value, 0)} == set(expected)
    assert all(equal(difference[place], value) for place, value in expected.items())
    # all else is the same, and with it every steady turn, -N^-1 (Q delta_11 + ..)
    for name in ("N", "Q", "R", "W"):
        assert all(equal(value, 0) for value in np.ravel(getattr(full, name) - getattr(thesis, name))), name


def test_the_dropped_terms_move_the_dominant_root_by_a_third_of_a_percent_at_110_kmh() -> None:
    roots = []
    for variant in ("full", "thesis"):
        values = np.linalg.eigvals(b_train_yaw_roll.system(BTrainYawRoll(), 110.0 / 3.6, variant).A)
        roots.append(values[np.argmax(values.real + 1e-6 * values.imag)])
    # the errata of the thesis say 0.3 %, one digit
    assert 0.0025 < abs(roots[1] - roots[0]) / abs(roots[0]) < 0.0035


@settings(max_examples=10, deadline=None)
@given(varied(BTrainYawRoll), SPEEDS)
def test_with_stiff_suspensions_and_tyres_it_becomes_the_yaw_plane_model(p: BTrainYawRoll, speed: sp.Integer) -> None:
    roll_stiffness = [field.name for field in fields(p) if field.name.startswith(("K_r", "K_t", "L_r"))]
    stiff = replace(in_floats(p), **dict.fromkeys(roll_stiffness, 1e12))
    plane = b_train_yaw_plane.state_space(stiff, float(speed))
    roll = b_train_yaw_roll.state_space(stiff, float(speed))
    s = 2j * np.pi * 0.4  # a lane change

    def response(model: Any) -> Any:
        return (model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B) + model.D)[:3, :1]

    # roll angles are some 1e5 N m / 1e12 N m/rad
    np.testing.assert_allclose(response(roll), response(plane), rtol=1e-5)
