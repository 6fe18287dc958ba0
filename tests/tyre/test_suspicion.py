"""Sentences for suspicious coefficients: each for its defect, none for a sane set."""

import dataclasses
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula52, MagicFormula61, read_tir, stack, suspicions
from eom.tyre.mf.scaling import Scaling61
from eom.tyre.parameters import coefficients
from tests.tyre.tyres import between, ellipse

ROOT = Path(__file__).parents[2]
CAR = read_tir(ROOT / "vehicles" / "tyres" / "passenger_car.tir").tyre
THESIS = MagicFormula(nominal_load=4000.0, mu_x=1.0, mu_y=0.9, k_x=20.0, k_y=15.0, trail=0.03)
SCALES = {item.name for item in coefficients(Scaling61)}


def old_car() -> MagicFormula52:
    """A 5.2 tyre with what the shipped tyre has of its coefficients."""
    names = {item.name for item in coefficients(MagicFormula52)}
    shared = {item.name: getattr(CAR, item.name) for item in coefficients(CAR) if item.name in names}
    return MagicFormula52(**shared, PTX1=2.0, PTY1=2.0, PTY2=1.8)


def test_the_shipped_tyre_has_none() -> None:
    assert suspicions(CAR) == ()


@pytest.mark.parametrize("combined", ["ellipse", "cosine"])
def test_a_car_tyre_of_the_thesiss_formula_has_none(combined: str) -> None:
    assert suspicions(dataclasses.replace(THESIS, combined=combined)) == ()  # type: ignore[arg-type]


def test_a_version_52_car_tyre_has_none() -> None:
    assert suspicions(old_car()) == ()


@settings(max_examples=25)
@given(st.data())
def test_sets_near_the_shipped_one_have_none(data: st.DataObject) -> None:
    assert isinstance(CAR, MagicFormula61)
    names = [item.name for item in coefficients(CAR) if getattr(CAR, item.name) and item.name not in SCALES]
    changes = {name: getattr(CAR, name) * data.draw(between(0.97, 1.03), name) for name in names}
    assert suspicions(dataclasses.replace(CAR, **changes)) == ()


@settings(max_examples=25)
@given(ellipse)
def test_plausible_sets_of_the_thesiss_formula_have_none(tyre: MagicFormula) -> None:
    assert suspicions(tyre) == ()


@given(between(2e4, 1.6e5), between(2e4, 3e5), between(0.25, 1.5), between(0.0, 0.1))
def test_plausible_sets_of_dugoffs_and_the_linear_tyre_have_none(
    cornering: float, longitudinal: float, friction: float, trail: float
) -> None:
    common = {"nominal_load": 4000.0, "cornering": cornering, "longitudinal": longitudinal, "trail": trail}
    assert suspicions(Dugoff(**common, friction=friction)) == ()
    assert suspicions(Linear(**common)) == ()
    assert suspicions(Linear(nominal_load=4000.0, cornering=cornering)) == ()


DEFECTS: list[tuple[dict[str, Any], str]] = [
    ({"PKY1": 21.0}, "PKY1 = 21, PKY2 = 1.6: the lateral force grows with the slip angle"),
    (
        {"PKY1": -1.0},
        "PKY1 = -1, PKY2 = 1.6: cornering stiffness over load is 0.899 1/rad at nominal load; expected 3 to",
    ),
    ({"PKY1": -60.0}, "expected 3 to 40"),
    (
        {"PKX1": 2.0},
        "PKX1 = 2, PKX2 = -0.4, PKX3 = 0.2: slip stiffness over load is 2 at nominal load; expected 3 to 80",
    ),
    ({"PKX1": 100.0}, "slip stiffness over load is 100 at nominal load"),
    ({"PKX1": -22.0}, "PKX1 = -22, PKX2 = -0.4, PKX3 = 0.2: slip stiffness over load is -22"),
    ({"PKX2": -30.0}, "the slip stiffness has another sign at loads from"),
    ({"PKY4": 4.0}, "PKY1 = -21, PKY2 = 1.6, PKY4 = 4: the cornering stiffness has another sign at loads from"),
    ({"PDY1": 3.0}, "PDY1 = 3, PDY2 = -0.16: the lateral force reaches 3.14 of the load at 1000 N; expected 0.2 to 2"),
    ({"PDX2": -1.0}, "PDX1 = 1.15, PDX2 = -1: the longitudinal force reaches 0.15 of the load at 8000 N"),
    ({"LMUX": 0.1}, "LMUX = 0.1: the longitudinal force reaches"),
    ({"QDZ1": -0.1}, "QDZ1 = -0.1: the pneumatic trail is -31.3 mm at nominal load; expected a positive one"),
    ({"QSY1": -0.01}, "QSY1 = -0.01, QSY3 = 0.0004, QSY4 = 4e-05: the rolling resistance moment is 12 N m"),
    (
        {"PEX2": 2.0},
        "the curvature factor E of the longitudinal force is above 1 at loads from 5900 to 8000 N, up to 2.1",
    ),
    (
        {"PEY1": 1.5},
        "PEY1 = 1.5, PEY2 = -0.4, PEY3 = 0.1, PEY4 = 0, PEY5 = 0: the curvature factor E of the lateral force",
    ),
    ({"PEY1": -4.0, "PEY4": 20.0}, "the curvature factor E of the lateral force is above 1"),
    ({"QEZ1": 1.2}, "the curvature factor E of the pneumatic trail is above 1"),
    ({"REX1": 1.4}, "REX1 = 1.4, REX2 = 0: the curvature factor E of the weighting of the longitudinal force"),
    ({"REY2": 2.0}, "REY1 = -0.2, REY2 = 2: the curvature factor E of the weighting of the lateral force is above 1"),
    ({"PCX1": 2.6}, "PCX1 = 2.6: shape factor C is 2.6; expected 0.5 to 2.5"),
    ({"PCY1": 0.4}, "PCY1 = 0.4: shape factor C is 0.4; expected 0.5 to 2.5"),
    ({"QCZ1": 0.2}, "QCZ1 = 0.2: shape factor C of the pneumatic trail"),
    ({"QBZ3": -12.0}, "QBZ1 = 10, QBZ2 = -1.5, QBZ3 = -12: stiffness factor B of the pneumatic trail is not positive"),
    ({"PKY3": 0.3, "QBZ5": 0.1}, "PKY3 = 0.3, QBZ5 = 0.1: multiplies the absolute value of camber"),
    ({"QSX14": 0.3}, "QSX14 = 0.3: multiplies the absolute value of camber"),
    ({"form": "book"}, "QDZ3 = 0.1: multiplies the absolute value of camber"),
    ({"use": "uncombined"}, "use = 'uncombined': each force has its full friction whatever the other does"),
    ({"use": "lateral"}, "use = 'lateral': the tyre has no longitudinal force"),
    ({"use": "longitudinal"}, "use = 'longitudinal': the tyre has no lateral force"),
    ({"LMUY": 0.8, "LEX": 2.0}, "LEX = 2, LMUY = 0.8: scaling factors make this another tyre than the measured one"),
    ({"INFLPRES": 4e5}, "INFLPRES = 400000 Pa is 1.82 of NOMPRES = 220000 Pa; expected 0.7 to 1.3"),
    ({"INFLPRES": 2.5e5, "PRESMAX": 2.4e5}, "INFLPRES = 250000 Pa is outside the range of measurement"),
    ({"QSY7": 0.0}, "QSY7 = 0: the rolling resistance moment is the same at every load"),
    ({"QSY1": 0.0, "QSY3": 0.0, "QSY4": 0.0}, "QSY1 = 0: the tyre has no rolling resistance"),
    ({"QDZ1": 0.0}, "QDZ1 = 0: the tyre has no pneumatic trail and does not align itself"),
    ({"PVY1": 0.5}, "the lateral force is 0.46 of the load without any slip; expected less than 0.15"),
    ({"PHY1": 0.2}, "PHY1 = 0.2, PVY1 = 0.01: the lateral force is -1 of the load without any slip"),
    ({"PVX1": 0.3}, "the longitudinal force is 0.3 of the load without any slip"),
    ({"UNLOADED_RADIUS": 313.5}, "UNLOADED_RADIUS = 313.5 m: expected 0.1 to 2 m; do [UNITS] say what it is in?"),
    ({"FNOMIN": 4.0, "FZMIN": 0.0, "FZMAX": 8.0}, "FNOMIN = 4 N: expected 200 to 200000 N"),
    ({"QSY1": 1.0}, "rolling resistance is 1 of the load; expected less than 0.1"),
    ({"QSY2": 0.1}, "QSY1 = 0.01, QSY2 = 0.1: the rolling resistance moment drives a braked wheel"),
    ({"QDZ1": 5.0}, "of the radius"),
    ({"PKY6": 0.9}, "camber stiffness over load is -0.9 1/rad at nominal load; expected 0 to 5"),
    ({"PKY6": -20.0}, "camber stiffness over load is 20 1/rad at nominal load"),
    ({"PDY3": 80.0}, "PDY3 = 80: camber of"),
    ({"QSX2": 10.0}, "the overturning moment reaches"),
    ({"QDZ8": 5.0}, "the aligning moment reaches"),
    ({"LATERAL_STIFFNESS": 0.0}, "relaxation lengths need LATERAL_STIFFNESS"),
    ({"LATERAL_STIFFNESS": 120.0}, "the lateral relaxation length is"),
    ({"PDX2": -2.0}, "the longitudinal force reaches"),
    ({"ALPMIN": -0.01}, "ALPMIN = -0.01 rad ends before the peak of the force; expected -0.1 rad or less"),
    ({"KPUMIN": -0.01}, "KPUMIN = -0.01 ends before the peak of the force; expected -0.1 or less"),
    ({"FZMAX": 5000.0}, "FZMAX = 5000 N is 1.25 of FNOMIN; expected 1.5 or more"),
    ({"FZMIN": 3000.0}, "FZMIN = 3000 N is 0.75 of FNOMIN; expected 0.5 or less"),
    ({"ALPMAX": 0.05}, "ALPMAX = 0.05 rad ends before the peak of the force; expected 0.1 rad or more"),
    ({"KPUMAX": 0.05}, "KPUMAX = 0.05 ends before the peak of the force; expected 0.1 or more"),
    ({"RBX1": 0.0}, "RBX1 = 0: the slip angle takes nothing from the longitudinal force"),
    ({"RCY1": 0.0}, "RCY1 = 0: the longitudinal slip takes nothing from the lateral force"),
    ({"RBX1": 2.0}, "both forces together exceed the ellipse of the largest ones by 2"),
    ({"RCX1": 1.6}, "the outline of the forces has a dent of 23 %"),
    ({"RCX1": 1.6}, "the slip angle turns the longitudinal force round, to -0.59 of itself"),
    ({"RCY1": 1.6}, "the longitudinal slip turns the lateral force round"),
    ({"RHY1": 0.1}, "the longitudinal slip makes the lateral force larger, 1.60 of itself"),
]


@pytest.mark.parametrize(("changes", "sentence"), DEFECTS)
def test_a_defect_has_its_sentence(changes: dict[str, Any], sentence: str) -> None:
    found = suspicions(dataclasses.replace(CAR, **changes))
    assert any(sentence in text for text in found), found


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"E_y_load": 3.0}, "E_y = 0, E_y_load = 3: the curvature factor E of the lateral force is above 1"),
        ({"C_x_load": 2.0}, "C_x = 1.65, C_x_load = 2: shape factor C runs from 0.15 to 3.65"),
        ({"mu_y": 2.5}, "mu_y = 2.5, mu_y_load = 0: the lateral force reaches 2.5 of the load"),
        ({"k_y": 2.0}, "k_y = 2: cornering stiffness over load is 2 1/rad"),
        ({"k_x_load": -30.0}, "the slip stiffness has another sign at loads from 6"),
        ({"trail": -0.01}, "trail = -0.01: the pneumatic trail is -10 mm"),
        ({"combined": "cosine", "RBX1": 0.0}, "RBX1 = 0: the slip angle takes nothing from the longitudinal force"),
    ],
)
def test_a_defect_of_the_thesiss_formula_has_its_sentence(changes: dict[str, Any], sentence: str) -> None:
    found = suspicions(dataclasses.replace(THESIS, **changes))
    assert any(sentence in text for text in found), found


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"PKY3": 0.3}, "PKY3 = 0.3: multiplies the absolute value of camber"),
        ({"LGAY": 0.5}, "LGAY = 0.5: scaling factors make this another tyre"),
        ({"PEY4": 30.0}, "the curvature factor E of the lateral force is above 1"),
    ],
)
def test_a_defect_of_version_52_has_its_sentence(changes: dict[str, Any], sentence: str) -> None:
    found = suspicions(dataclasses.replace(old_car(), **changes))
    assert any(sentence in text for text in found), found


def test_friction_and_stiffness_of_dugoffs_tyre() -> None:
    tyre = Dugoff(nominal_load=4000.0, cornering=5e3, longitudinal=9e4, friction=3.0, trail=-0.01)
    told = "\n".join(suspicions(tyre))
    for piece in (
        "cornering = 5000: cornering stiffness over load is 1.25",
        "friction = 3: the lateral force",
        "trail",
    ):
        assert piece in told


def test_a_set_beyond_all_sense_has_sentences_and_no_error() -> None:
    # no cornering stiffness at all
    assert isinstance(CAR, MagicFormula61)
    found = suspicions(dataclasses.replace(CAR, PKY4=0.0))
    assert any("1/rad at nominal load; expected 3 to 40" in text for text in found), found


def test_a_stack_of_tyres_is_refused() -> None:
    with pytest.raises(TyreError, match="expected one tyre, not a stack"):
        suspicions(stack([THESIS, THESIS]))
