"""The matrices are those of the thesis's appendices but for listed corrections, as symbols; and its printed numbers."""

from typing import Any

import numpy as np
import pytest
import sympy as sp

from eom.closed_form import (
    BTrainYawPlane,
    BTrainYawRoll,
    TractorSemitrailer,
    b_train_nonlinear,
    b_train_yaw_plane,
    b_train_yaw_roll,
    tractor_semitrailer,
    tractor_semitrailer_nonlinear,
)
from tests.closed_form.printed import CORRECTED, DERIVATIVES, PRINTED
from tests.closed_form.symbols import U, derivatives, names, symbolic

Elements = dict[tuple[int, int], Any]


def own_matrices() -> dict[str, tuple[Any, dict[str, Any]]]:
    """Our matrices of symbols, by their names in `printed`, with what the symbols of the print stand for."""
    short, plane, roll = symbolic(TractorSemitrailer), symbolic(BTrainYawPlane), symbolic(BTrainYawRoll)
    made = (
        ("A", short, tractor_semitrailer.matrices(short, U)),
        ("A", short, tractor_semitrailer_nonlinear.matrices(short, U)),
        ("C", roll, b_train_yaw_roll.matrices(roll, U, "thesis")),
        ("D", plane, b_train_yaw_plane.matrices(plane, U)),
        ("E", plane, b_train_nonlinear.matrices(plane, U)),
    )
    found = {}
    for appendix, p, matrices in made:
        for name, matrix in matrices._asdict().items():
            found[f"{appendix}.{name}"] = (matrix, names(p))
    return found


OWN = own_matrices()


def elements(text: str, symbols: dict[str, Any]) -> Elements:
    """The elements that a text lists, with our symbols in place of those of the print."""
    found = {}
    for line in text.strip().splitlines():
        place, expression = line.split(":")
        row, column = map(int, place.split(","))
        found[row, column] = sp.sympify(expression, locals=symbols)
    return found


def own_elements(matrix: Any) -> Elements:
    """The elements of one of our matrices that are not zero; a vector is one column."""
    columns = matrix if matrix.ndim == 2 else matrix[:, np.newaxis]
    return {(i + 1, j + 1): value for (i, j), value in np.ndenumerate(columns) if value != 0}


def equal(one: Any, other: Any) -> bool:
    """Whether two expressions are the same polynomial of the symbols and 1/U."""
    return bool(sp.expand(one - other) == 0)


def test_every_printed_matrix_has_its_function() -> None:
    # J belongs to Appendices D and E
    assert set(PRINTED) == set(OWN) - {"E.J"}
    assert set(CORRECTED) <= set(PRINTED)


@pytest.mark.parametrize("name", PRINTED)
def test_every_element_is_the_printed_one_or_its_correction(name: str) -> None:
    matrix, symbols = OWN[name]
    expected = elements(PRINTED[name], symbols) | elements(CORRECTED.get(name, ""), symbols)
    ours = own_elements(matrix)
    wrong = [place for place in expected.keys() | ours.keys() if not equal(ours.get(place, 0), expected.get(place, 0))]
    assert not wrong


@pytest.mark.parametrize("name", CORRECTED)
def test_every_correction_differs_from_the_print(name: str) -> None:
    _, symbols = OWN[name]
    printed = elements(PRINTED[name], symbols)
    idle = [place for place, value in elements(CORRECTED[name], symbols).items() if equal(value, printed.get(place, 0))]
    assert not idle


@pytest.mark.parametrize("name", DERIVATIVES)
def test_tyre_derivatives_at_10_m_s_are_those_printed_in_appendix_b(name: str) -> None:
    # five printed digits, from places before rounding (3.257 m stands for 3.2566 m): at most 1.4e-4 away
    assert derivatives(BTrainYawPlane(), 10.0)[name] == pytest.approx(DERIVATIVES[name], rel=1.5e-4)


def test_the_yaw_plane_b_train_has_its_published_roots_at_110_kmh() -> None:
    roots = np.linalg.eigvals(b_train_yaw_plane.system(BTrainYawPlane(), 110.0 / 3.6).A_p)
    for published in (-3.1012 + 1.4201j, -1.9230 + 2.7864j, -1.3179 + 2.0835j):
        # four printed decimals
        assert np.min(np.abs(roots - published)) < 0.8e-4


def test_the_tractor_semitrailers_gains_at_150_kmh_are_those_of_table_4_5() -> None:
    model = tractor_semitrailer.state_space(TractorSemitrailer(), 150.0 / 3.6)
    s = 2j * np.pi * 0.01  # the table's first row: measured over one cycle of 0.01 Hz
    response = model.C @ np.linalg.solve(s * np.eye(4) - model.A, model.B[:, 0]) + model.D[:, 0]
    # four printed digits, with what is left of the transient in a single cycle; g = 9.8 m/s^2 as in the thesis
    assert np.abs(response) / 9.8 == pytest.approx([7.478, 7.481], rel=2e-4)


def test_without_the_lost_element_the_yaw_roll_mass_matrix_has_no_inverse() -> None:
    M = b_train_yaw_roll.matrices(BTrainYawRoll(), 30.0, "thesis").M
    assert np.linalg.matrix_rank(M) == 18
    M[2, 13] = 0.0  # M(3, 14) is absent in print
    assert np.linalg.matrix_rank(M) == 17
