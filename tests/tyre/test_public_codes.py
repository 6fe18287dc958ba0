"""The referee against numbers of public codes, run on the random sets of seed 0.

Tool and 5.2: the lines of Solver.m of MFeval 4.0 (M. Furlan Tassara, File Exchange), which was matched to MF-Tyre
6.1.2, with its guards against zero denominators (1e-6) set to zero. For FITTYP 6 it knows no LGAX, LGAY, LGAZ and takes
SVyk with the friction of the upright wheel, so those are 1 and PDY3 is 0 there.

Book: the lines of the class for MF 6.2 in the tyre library of enve (D. Stocco), which was written from
Pacejka (2012), again without guards. Three of its slips are put right: LKY and LYKA are exchanged on reading, Mzr has a
second cosine, and Mx and My, which leave the book, are not taken.
"""

import pytest

from tests.tyre.random_sets import State, random_set_52, random_set_61
from tests.tyre.referee_mf import book_61, tool_61
from tests.tyre.referee_mf52 import relaxation_52, tool_52
from tests.tyre.referee_mf_forces import relaxation_61

STATES = (
    State(0.05, 0.02, 4200.0, -0.03, 20.0),
    State(-0.12, -0.08, 2500.0, 0.1, 12.0),
    State(0.3, 0.25, 7000.0, 0.2, 35.0),
    State(-0.02, -0.6, 1200.0, -0.15, 8.0),
)
FITTYP_61 = (
    (1914.444884542, -3209.203094942, 15.56096291618, -19.35862041478, 85.27152842272),
    (-1261.144306823, 2754.376994142, -32.06297249686, -9.788691372684, -6.901042504875),
    (2608.120009192, -5803.163288737, -252.262671172, -40.75167636931, -135.0772126357),
    (-1021.91011798, 81.27622553234, 29.73658567858, -4.463906394182, 14.32610551282),
)
FITTYP_6 = (
    (1626.613961753, -2136.288073478, 29.13633871458, -21.94711755023, 18.86181017941),
    (-1579.029585316, 1642.194683018, -63.49690621306, -10.29996062857, 7.811265146722),
    (4856.34441172, -3446.1419863, -254.4112305963, -49.41604194788, -95.6364586704),
    (-1215.471187151, -5.597689388102, 32.39711897158, -4.892261722884, -4.448582916429),
)
LENGTHS_61 = (
    (0.3552973655477, 0.4965476627285),
    (0.2075705815543, 0.3207193246254),
    (0.6034631262128, 0.6068462860596),
    (0.09791035142477, 0.1586228203106),
)
LENGTHS_6 = (
    (0.5432433382268, 0.4742742827612),
    (0.3284955299335, 0.3502508921656),
    (0.8714604320143, 0.565003566394),
    (0.1588697582857, 0.1877093679373),
)
"""Relaxation lengths, longitudinal and lateral."""
BOOK = (
    (1909.247221017, -3200.879286116, 75.28044932123),
    (-1247.357004782, 2731.692619255, -6.560249888097),
    (2348.385159816, -5533.384867216, -118.0367102879),
    (-1000.893896612, 81.70284684619, 13.92601465823),
)
"""Fx, Fy, Mz."""


def same(expected: tuple[float, ...]) -> object:
    """To the thirteen digits that are written above."""
    return pytest.approx(expected, rel=1e-12, abs=0.0)


def test_magic_formula_61_gives_the_numbers_of_mfeval() -> None:
    tyre = random_set_61(0)
    for state, expected in zip(STATES, FITTYP_61, strict=True):
        assert tool_61(tyre, *state) == same(expected)


def test_magic_formula_52_gives_the_numbers_of_mfeval() -> None:
    tyre = random_set_52(0) | {"LGAX": 1.0, "LGAY": 1.0, "LGAZ": 1.0, "PDY3": 0.0}
    for state, expected in zip(STATES, FITTYP_6, strict=True):
        assert tool_52(tyre, *state) == same(expected)


def test_relaxation_lengths_are_those_of_mfeval() -> None:
    new, old = random_set_61(0), random_set_52(0) | {"LGAY": 1.0}
    for state, lengths_61, lengths_6 in zip(STATES, LENGTHS_61, LENGTHS_6, strict=True):
        assert relaxation_61(new, state.Fz, state.gamma) == same(lengths_61)
        assert relaxation_52(old, state.Fz, state.gamma) == same(lengths_6)


def test_magic_formula_61_of_the_book_gives_the_numbers_of_enve() -> None:
    tyre = random_set_61(0)
    for state, expected in zip(STATES, BOOK, strict=True):
        Fx, Fy, _, _, Mz = book_61(tyre, *state)
        assert (Fx, Fy, Mz) == same(expected)
