"""The linear yaw-plane models equal Kane's equations linearised about straight running, exactly."""

from functools import cache
from typing import Any

import sympy as sp
from hypothesis import given, settings

from eom.closed_form import BTrainYawPlane, TractorSemitrailer, b_train_yaw_plane, tractor_semitrailer
from eom.closed_form.parameters import Parameters
from tests.closed_form import symbols
from tests.closed_form.planar_kane import (
    LinearTrain,
    b_train_by_kane,
    b_train_units,
    linear,
    tractor_semitrailer_by_kane,
    tractor_semitrailer_units,
)
from tests.closed_form.symbols import symbolic
from tests.closed_form.varied import SPEEDS, close, in_floats, varied


@cache
def short() -> LinearTrain:
    """The tractor and semitrailer by Kane's method."""
    return linear(tractor_semitrailer_by_kane(), tractor_semitrailer_units(symbolic(TractorSemitrailer)), symbols.U)


@cache
def long() -> LinearTrain:
    """The B-train by Kane's method."""
    return linear(b_train_by_kane(), b_train_units(symbolic(BTrainYawPlane)), symbols.U)


def exact(matrix: Any) -> Any:
    """A matrix of fractions, also where it has no parameter in it."""
    return sp.Matrix(matrix).applyfunc(sp.Rational)


class Numbers:
    """A linear train at given parameters, in fractions: dz/dt = A z + B u and accelerations C z + D u."""

    def __init__(self, train: LinearTrain, p: Parameters, speed: sp.Integer) -> None:
        values = {symbol: getattr(p, symbol.name) for matrix in train for symbol in matrix.free_symbols - {symbols.U}}
        values[symbols.U] = speed
        mass, state, control, self.sideslip, by_rate, by_state = (matrix.xreplace(values) for matrix in train)
        inverse = mass.inv()
        self.A, self.B = inverse * state, inverse * control
        self.C, self.D = by_rate * self.A + by_state, by_rate * self.B


def unit_rows(size: int, *places: int) -> sp.Matrix:
    """Rows of the identity."""
    return sp.eye(size).extract(list(places), list(range(size)))


@settings(max_examples=8, deadline=None)
@given(varied(TractorSemitrailer), SPEEDS)
def test_the_tractor_semitrailer_is_kanes_exactly(p: TractorSemitrailer, speed: sp.Integer) -> None:
    kane = Numbers(short(), p, speed)
    # z = V_1, r_1, r_2, Gamma_2 gives x = r_1, r_2 - r_1, V_1 / U, Gamma_2
    T = sp.Matrix([[0, 1, 0, 0], [0, -1, 1, 0], [1 / speed, 0, 0, 0], [0, 0, 0, 1]])
    M, P, *H = (exact(matrix) for matrix in tractor_semitrailer.matrices(p, speed))
    assert M * T * kane.A == P * T
    # steer of the three axles; Kane's yaw moments are no inputs of the thesis
    assert M * T * kane.B[:, :3] == sp.Matrix.hstack(*H)


@settings(max_examples=8, deadline=None)
@given(varied(BTrainYawPlane), SPEEDS)
def test_the_b_train_is_kanes_exactly(p: BTrainYawPlane, speed: sp.Integer) -> None:
    kane = Numbers(long(), p, speed)
    T = b_train_states(kane)
    J, K, L, Tu, V = (exact(matrix) for matrix in b_train_yaw_plane.matrices(p, speed))
    assert J * T * kane.A == -K * T
    # front axle; axles 4 to 9; moments on the semitrailers, after nine steer angles and the tractor's moment
    assert J * T * kane.B[:, 0] == -L
    assert J * T * kane.B[:, 3:9] == -Tu
    assert J * T * kane.B[:, 10:] == -V


def b_train_states(kane: Numbers) -> Any:
    """The states beta_1, psi_dot_1, beta_2 .. by z = V_1, r_1, r_2, r_3, Gamma_2, Gamma_3."""
    r = unit_rows(6, 1, 2, 3)
    return sp.Matrix.vstack(*(rows[i, :] for i in range(3) for rows in (kane.sideslip, r)))


@settings(max_examples=5, deadline=None)
@given(varied(TractorSemitrailer), SPEEDS)
def test_the_tractor_semitrailers_state_space_is_kanes(p: TractorSemitrailer, speed: sp.Integer) -> None:
    kane, own = Numbers(short(), p, speed), tractor_semitrailer.state_space(in_floats(p), float(speed))
    T = sp.Matrix([[0, 1, 0, 0], [0, -1, 1, 0], [1 / speed, 0, 0, 0], [0, 0, 0, 1]])
    # double precision against fractions; the mass matrix has a condition number of some 1e3 after scaling
    assert close(own.A, T * kane.A * T.inv(), 1e-12)
    assert close(own.B, T * kane.B[:, :3], 1e-12)
    assert close(own.C, kane.C * T.inv(), 1e-12)
    assert close(own.D, kane.D[:, :3], 1e-12)


@settings(max_examples=5, deadline=None)
@given(varied(BTrainYawPlane), SPEEDS)
def test_the_b_trains_state_space_is_kanes(p: BTrainYawPlane, speed: sp.Integer) -> None:
    kane, own = Numbers(long(), p, speed), b_train_yaw_plane.state_space(in_floats(p), float(speed))
    T, inputs = b_train_states(kane), [0, 3, 4, 5, 6, 7, 8, 10, 11]
    back = T.inv()
    B, D = kane.B.extract(list(range(6)), inputs), kane.D.extract([0, 1, 2], inputs)
    # double precision against fractions, as above
    assert close(own.A, T * kane.A * back, 1e-12)
    assert close(own.B, T * B, 1e-12)
    assert close(own.C, kane.C * back, 1e-12)
    assert close(own.D, D, 1e-12)
