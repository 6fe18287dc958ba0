"""Files of tyres: what is written is read, in any units and spelling, and nothing is lost unsaid."""

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import MagicFormula52, MagicFormula61, read_tir, write_tir
from eom.tyre.mf_ranges import limits
from eom.tyre.tir import TirFile, read_text
from eom.tyre.tir_keys import fields_of
from eom.tyre.tir_write import tir_text

PASSENGER_CAR = Path(__file__).parents[2] / "vehicles" / "tyres" / "passenger_car.tir"
FORCES = """\
[DIMENSION]
UNLOADED_RADIUS = 0.3
[VERTICAL]
FNOMIN = 4000
[LONGITUDINAL_COEFFICIENTS]
PCX1 = 1.6
PDX1 = 1.1
PKX1 = 20
[LATERAL_COEFFICIENTS]
PCY1 = 1.3
PDY1 = 1.0
PKY1 = -20
PKY2 = 1.5
"""
PRESSURES = "[OPERATING_CONDITIONS]\nINFLPRES = 230000\nNOMPRES = 210000\n"
NEWER, OLDER = f"[MODEL]\nFITTYP = 61\n{FORCES}{PRESSURES}", f"[MODEL]\nFITTYP = 6\n{FORCES}"
OTHER_UNITS = """\
[UNITS]
LENGTH = 'mm'
FORCE = 'kN'
ANGLE = 'degrees'
MASS = 'kg'
TIME = 'ms'
PRESSURE = 'bar'
[MODEL]
FITTYP = 61
LONGVL = 16.7      $ mm/ms, that is m/s
VXLOW = 2.
[DIMENSION]
UNLOADED_RADIUS = 313.5
WIDTH = 205
[OPERATING_CONDITIONS]
INFLPRES = 2.2
NOMPRES = 2.1
[VERTICAL]
FNOMIN = 4
VERTICAL_STIFFNESS = 0.2
VERTICAL_DAMPING = 0.05
BREFF = 8.4
[VERTICAL_FORCE_RANGE]
FZMIN = 0.1
FZMAX = 9.9
[SLIP_ANGLE_RANGE]
ALPMIN = -90
ALPMAX = 45
[INFLATION_PRESSURE_RANGE]
PRESMIN = 1.5
PRESMAX = 3
[LONGITUDINAL_COEFFICIENTS]
PCX1 = 1.6
PDX1 = 1.1
PKX1 = 20
[LATERAL_COEFFICIENTS]
PCY1 = 1.3
PDY1 = 1.0
PKY1 = -20
PKY2 = 1.5
PHY1 = 0.01
"""


def read(text: str) -> TirFile:
    return read_text(text, "tyre.tir")


def noted(text: str) -> list[str]:
    return [f"{note.line}:{note.column} {note.where}: {note.what}" for note in read(text).notes]


def values(version: type[MagicFormula61 | MagicFormula52]) -> st.SearchStrategy[dict[str, Any]]:
    """Every field of a version at random, as far as bounds allow."""
    strategies: dict[str, st.SearchStrategy[Any]] = {
        "side": st.sampled_from([None, "left", "right"]),
        "mirror": st.booleans(),
        "use": st.sampled_from(["longitudinal", "lateral", "uncombined", "combined"]),
    }
    if version is MagicFormula61:
        strategies["form"] = st.sampled_from(["tool", "book"])
    for name, item in fields_of(version).items():
        positive = item.metadata.get("above") == 0 or item.metadata.get("at_least") == 0
        numbers = st.floats(min_value=5e-324 if positive else None, allow_nan=False, allow_infinity=False)
        strategies[name] = numbers.filter(bool) if item.metadata.get("non_zero") else numbers
    ends = [item.name for item in limits(version)]
    for low, high in zip(ends[::2], ends[1::2], strict=True):
        strategies[low] = (
            st.sampled_from([-math.inf, -1e3, 0.1, 1.0]) if low not in {"FZMIN", "PRESMIN"} else st.just(0.0)
        )
        strategies[high] = st.sampled_from([math.inf, 1.5, 1e-3 + 1.0])
    return st.fixed_dictionaries(strategies)


@given(values(MagicFormula61).map(lambda given: MagicFormula61(**given)))
def test_a_newer_tyre_that_is_written_is_read_equal(tyre: MagicFormula61) -> None:
    assert read(tir_text(tyre)).tyre == tyre


@given(values(MagicFormula52).map(lambda given: MagicFormula52(**given)))
def test_an_older_tyre_that_is_written_is_read_equal(tyre: MagicFormula52) -> None:
    assert read(tir_text(tyre)).tyre == tyre


def test_a_written_file_needs_no_notes_and_is_replaced_whole(tmp_path: Path) -> None:
    path = tmp_path / "tyre.tir"
    path.write_text("something else")
    tyre = read_tir(PASSENGER_CAR).tyre
    write_tir(tyre, path)
    assert read_tir(path).tyre == tyre
    assert read_tir(path).notes == ()
    assert [file.name for file in tmp_path.iterdir()] == ["tyre.tir"]


def test_a_file_that_cannot_be_written_gets_a_sentence_and_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "taken").mkdir()
    tyre = read_tir(PASSENGER_CAR).tyre
    for path in (tmp_path / "taken", tmp_path / "no" / "folder.tir"):
        with pytest.raises(TyreError, match="cannot be written: "):
            write_tir(tyre, path)
    assert [file.name for file in tmp_path.iterdir()] == ["taken"]


def test_several_tyres_in_one_object_are_no_file() -> None:
    import numpy as np

    tyre = dataclasses.replace(read_tir(PASSENGER_CAR).tyre, PDY1=np.array([0.9, 1.0]))
    with pytest.raises(TyreError, match="holds one tyre: PDY1 should be numbers, not arrays"):
        tir_text(tyre)


def test_other_units_are_converted_where_they_bear() -> None:
    tyre = read(OTHER_UNITS).tyre
    assert isinstance(tyre, MagicFormula61)
    # the nearest floats: decimal factors are applied exactly
    assert (tyre.UNLOADED_RADIUS, tyre.WIDTH, tyre.LONGVL, tyre.VXLOW) == (0.3135, 0.205, 16.7, 2.0)
    assert (tyre.INFLPRES, tyre.NOMPRES, tyre.PRESMIN, tyre.PRESMAX) == (220e3, 210e3, 150e3, 300e3)
    # 0.2 kN/mm is 200 N/mm, 0.05 kN ms/mm is 50 N s/m
    assert (tyre.FNOMIN, tyre.VERTICAL_STIFFNESS, tyre.VERTICAL_DAMPING) == (4000.0, 200e3, 50.0)
    assert (100.0, 9900.0, -math.pi / 2, math.pi / 4) == (tyre.FZMIN, tyre.FZMAX, tyre.ALPMIN, tyre.ALPMAX)
    # pure numbers, and coefficients of the equations, which are in rad, N and m
    assert (tyre.BREFF, tyre.PKX1, tyre.PHY1, tyre.PCX1) == (8.4, 20.0, 0.01, 1.6)


@pytest.mark.parametrize(
    ("quantity", "spelling", "key", "number", "expected"),
    [
        ("LENGTH", "meter", "UNLOADED_RADIUS = 0.3", "0.3", 0.3),
        ("LENGTH", "METRES", "UNLOADED_RADIUS = 0.3", "0.3", 0.3),
        ("LENGTH", "mm", "UNLOADED_RADIUS = 0.3", "300", 0.3),
        ("LENGTH", "cm", "UNLOADED_RADIUS = 0.3", "30", 0.3),
        ("LENGTH", "inch", "UNLOADED_RADIUS = 0.3", "10", 0.254),
        ("LENGTH", "inches", "UNLOADED_RADIUS = 0.3", "10", 0.254),
        ("LENGTH", "foot", "UNLOADED_RADIUS = 0.3", "1", 0.3048),
        ("LENGTH", "feet", "UNLOADED_RADIUS = 0.3", "1", 0.3048),
        ("FORCE", "Newton", "FNOMIN = 4000", "4000", 4000.0),
        ("FORCE", "kN", "FNOMIN = 4000", "4", 4000.0),
        ("FORCE", "pound_force", "FNOMIN = 4000", "1", 4.4482216152605),
        ("FORCE", "lbf", "FNOMIN = 4000", "1", 4.4482216152605),
        ("FORCE", "kilogram_force", "FNOMIN = 4000", "1", 9.80665),
        ("PRESSURE", "psi", "INFLPRES = 230000", "30", 206842.71879504),
        ("PRESSURE", "kPa", "INFLPRES = 230000", "230", 230e3),
        ("PRESSURE", "MPa", "INFLPRES = 230000", "0.23", 230e3),
        ("PRESSURE", "pascals", "INFLPRES = 230000", "230000", 230e3),
    ],
)
def test_usual_spellings_of_units_are_known(
    quantity: str, spelling: str, key: str, number: str, expected: float
) -> None:
    name, plain = key.split(" = ")
    text = f"[UNITS]\n{quantity} = '{spelling}'\n" + NEWER.replace(f"{name} = {plain}", f"{name} = {number}")
    # factors are those of NIST SP 811, table B.8; psi has the rounding of its eleventh digit
    assert getattr(read(text).tyre, name) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    "line",
    [
        "PKX2 = -0.25",
        "pkx2=-.25",
        "\tPkX2\t =\t-2.5E-1\t$ with tabs",
        "  PKX2 = -2.5D-01  ! Fortran",
        "PKX2 = -25.d-2$ close to a comment",
        "PKX2= -00.2500 $ [SECTION] = 'no'",
    ],
)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_usual_spellings_of_numbers_and_lines_are_known(line: str, end: str) -> None:
    text = f"{NEWER}[ longitudinal_coefficients ]  $ again\n{line}".replace("\n", end)
    assert read(text).tyre.PKX2 == -0.25
    assert read("\u00ef\u00bb\u00bf" + text).tyre == read(text).tyre


@pytest.mark.parametrize("spelling", ["'RIGHT'", '"Right"', "right", "'right' $ comment", "  right ! comment"])
def test_quotes_hide_nothing_and_are_not_needed(spelling: str) -> None:
    assert read(NEWER.replace("61\n", f"61\nTYRESIDE = {spelling}\n")).tyre.side == "right"


def test_a_sign_of_a_comment_in_quotes_is_text(tmp_path: Path) -> None:
    path = tmp_path / "tyre.tir"
    # of another encoding, too: only comments and texts have such letters
    path.write_bytes(b"$ Reifen f\xfcr gro\xdfe R\xe4der\n" + f"[MDI_HEADER]\nNAME = 'A $ or !'\n{NEWER}".encode())
    assert read_tir(path).tyre == read(NEWER).tyre


@pytest.mark.parametrize(
    ("model", "version"),
    [
        ("FITTYP = 61", MagicFormula61),
        ("FITTYP = 62", MagicFormula61),
        ("FITTYP = 60", MagicFormula61),
        ("FITTYP = 6", MagicFormula52),
        ("FITTYP = 52", MagicFormula52),
        ("PROPERTY_FILE_FORMAT = 'PAC2002'", MagicFormula52),
        ("FITTYP = 6.0\nPROPERTY_FILE_FORMAT = 'PAC2002'", MagicFormula52),
    ],
)
def test_fittyp_or_the_format_says_the_version(model: str, version: type) -> None:
    assert type(read(f"[MODEL]\n{model}\n{FORCES}").tyre) is version


@pytest.mark.parametrize(
    ("mode", "use", "mirror"),
    [
        ("1", "longitudinal", False),
        ("2", "lateral", False),
        ("3", "uncombined", False),
        ("4", "combined", False),
        ("14", "combined", False),
        ("124", "combined", False),
        ("-12", "lateral", True),
        ("-4", "combined", True),
        ("25", "combined", False),
    ],
)
def test_the_last_digit_of_use_mode_says_the_forces_and_its_sign_the_mirror(mode: str, use: str, mirror: bool) -> None:
    tyre = read(OLDER.replace("= 6\n", f"= 6\nUSE_MODE = {mode}\n")).tyre
    assert (tyre.use, tyre.mirror) == (use, mirror)


@pytest.mark.parametrize(
    ("side", "expected"), [("LEFT", "left"), ("RIGHT", "right"), ("SYMMETRIC", None), ("UNKNOWN", None), ("", None)]
)
def test_tyreside_says_for_which_side_the_coefficients_are(side: str, expected: str | None) -> None:
    assert read(NEWER.replace("61\n", f"61\nTYRESIDE = '{side}'\n")).tyre.side == expected


def test_a_zero_stands_for_the_letter_in_the_factor_of_nominal_load() -> None:
    text = NEWER + "[SCALING_COEFFICIENTS]\nLFZ0 = 1.25\n"
    assert read(text).tyre.LFZO == 1.25
    assert noted(text) == ["20:1 SCALING_COEFFICIENTS.LFZ0: read as LFZO"]


def test_pressures_of_pac2002_have_their_own_names() -> None:
    text = f"[MODEL]\nFITTYP = 61\n{FORCES}[TIRE_CONDITIONS]\nIP = 250000\nIP_NOM = 240000\n"
    tyre = read(text).tyre
    assert isinstance(tyre, MagicFormula61)
    assert (tyre.INFLPRES, tyre.NOMPRES) == (250e3, 240e3)


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        (NEWER, []),
        (OLDER, []),
        (NEWER.replace("= 61", "= 62"), ["2:1 MODEL.FITTYP: read by the equations of the Magic Formula 6.1"]),
        (NEWER.replace("= 61", "= 60"), ["2:1 MODEL.FITTYP: read by the equations of the Magic Formula 6.1"]),
        (OLDER.replace("= 6\n", "= 52\n"), ["2:1 MODEL.FITTYP: read as the Magic Formula 5.2, which FITTYP = 6 says"]),
        (NEWER.replace("61\n", "61\nUSE_MODE = 25\n"), ["3:1 MODEL.USE_MODE: turn slip is not modelled"]),
        (NEWER.replace("61\n", "61\nUSE_MODE = 134\n"), ["3:1 MODEL.USE_MODE: the belt as a body is not modelled"]),
        (NEWER + "NOMPRES = 210000\n", ["19:1 OPERATING_CONDITIONS.NOMPRES: stands in line 18 as well"]),
        (NEWER.replace("61\n", "61\nFITTYP = 61\n"), ["3:1 MODEL.FITTYP: stands in line 2 as well"]),
        (
            f"[MODEL]\nFITTYP = 61\n{FORCES}",
            [
                "1:1 OPERATING_CONDITIONS: INFLPRES is not given: NOMPRES is taken",
                "1:1 OPERATING_CONDITIONS: NOMPRES is not given: 200000 Pa is taken",
            ],
        ),
        (
            NEWER.replace("230000", "2.3").replace("210000", "2.1"),
            [
                "17:1 OPERATING_CONDITIONS.INFLPRES: is 2.3 Pa, which is little",
                "18:1 OPERATING_CONDITIONS.NOMPRES: is 2.1 Pa, which is little",
            ],
        ),
        (
            NEWER + "[ALIGNING_COEFFICIENTS]\nQBZ6 = 1\n[SCALING_COEFFICIENTS]\nLMUV = 0.1\n",
            [
                "20:1 ALIGNING_COEFFICIENTS.QBZ6: acts only in the book's form",
                "22:1 SCALING_COEFFICIENTS.LMUV: acts only in the book's form",
            ],
        ),
        (
            NEWER + "[TURNSLIP_COEFFICIENTS]\nPDXP1 = 0.4\nPDXP2 = 0\nPKYP1 = 1\n[SCALING_COEFFICIENTS]\nLMP = 1\n",
            ["20:1 TURNSLIP_COEFFICIENTS: not modelled: turn slip (PDXP1, PKYP1)"],
        ),
        (
            NEWER + "[INERTIA]\nMASS = 9.3\nIXX = 0.4\n[VERTICAL]\nBOTTOM_OFFST = 0.01\nQ_FCY2 = 0.1\n",
            [
                "20:1 INERTIA: not modelled: mass and inertia (MASS, IXX)",
                "23:1 VERTICAL: not modelled: contact of the rim (BOTTOM_OFFST)",
                "24:1 VERTICAL: not modelled: loaded radius with camber (Q_FCY2)",
            ],
        ),
        (
            NEWER + "[MAKER]\nCOLOUR = 'black'\nWIDTH = 0.2\n[MODEL]\nWEAR_LAW = 3\n",
            [
                "20:1 MAKER: unknown section, not read (COLOUR, WIDTH)",
                "23:1 MODEL: unknown, not read (WEAR_LAW)",
            ],
        ),
        (
            NEWER + "[SHAPE]\n{radial width}\n1.0 0.0\n0.9 1.0\n",
            ["21:1 SHAPE: not modelled: a table of 2 lines"],
        ),
        (
            NEWER + "[DIMENSION]\nBREFF = 8\n",
            ["20:1 DIMENSION: read, though most files have it in another section: BREFF"],
        ),
        (
            OLDER + "PEY5 = 0\nPKY4 = 2\n[OPERATING_CONDITIONS]\nINFLPRES = 80000\n"
            "[OVERTURNING_COEFFICIENTS]\nQSX4 = 5\nQSX7 = 0\nQSX8 = 0\n",
            [
                "19:1 OPERATING_CONDITIONS: not part of the Magic Formula 5.2 (INFLPRES)",
                "21:1 OVERTURNING_COEFFICIENTS: not part of the Magic Formula 5.2 (QSX4)",
            ],
        ),
        (
            OLDER.replace("= 6\n", "= 6\nFE_METHOD = 'YES'\nBELT_DYNAMICS = 'NO'\nMFSAFE3 =\nTYPE = 'CAR'\n"),
            ["3:1 MODEL: not modelled: PAC2002's own additions (FE_METHOD)"],
        ),
        (
            OLDER + "[SCALING_COEFFICIENTS]\nLCZ = 0.44\nLIP = 1\nLGYR = 1\n",
            ["17:1 SCALING_COEFFICIENTS: not modelled: PAC2002's own additions (LCZ)"],
        ),
    ],
)
def test_what_is_worth_knowing_is_noted_at_its_place_and_nothing_else(text: str, notes: list[str]) -> None:
    found = noted(text)
    assert len(found) == len(notes), found
    assert all(note.startswith(words) for note, words in zip(found, notes, strict=True)), found


def test_a_change_replaces_its_number_and_no_other_byte() -> None:
    text = PASSENGER_CAR.read_text(encoding="utf-8").replace("\n", "\r\n").replace("$ m/s", "$ \u00b5 m/s")
    changed = read(text).text_with(FNOMIN=4200.0, PKY1=-22.5)
    expected = text.replace("= 4000 ", "= 4200.0 ").replace("= -21.0", "= -22.5")
    assert changed == expected


def test_a_change_is_made_wherever_the_number_stands() -> None:
    text = NEWER + "NOMPRES = 210000\n"
    assert read(text).text_with(NOMPRES=2e5).count("NOMPRES = 200000.0\n") == 2


@given(
    st.fixed_dictionaries(
        {},
        optional={
            "UNLOADED_RADIUS": st.floats(1e-3, 3.0),
            "VERTICAL_STIFFNESS": st.floats(0.0, 1e7),
            "VERTICAL_DAMPING": st.floats(5e-324, 1e308),
            "FNOMIN": st.floats(1.0, 1e5),
            "INFLPRES": st.floats(1.0, 1e7),
            "ALPMAX": st.floats(0.0, 3.0),
            "PHY1": st.floats(-1e300, 1e300),
        },
    )
)
def test_changes_in_any_units_are_read_back_exactly(changes: dict[str, float]) -> None:
    file = read(OTHER_UNITS)
    assert read(file.text_with(**changes)).tyre == dataclasses.replace(file.tyre, **changes)  # type: ignore[arg-type]


def test_comments_order_and_unknown_keys_survive_a_change(tmp_path: Path) -> None:
    text = NEWER + "! kept\n[MAKER]\nCOLOUR = 'black'   $ kept\n"
    read(text).write(tmp_path / "new.tir", PDY1=0.5)
    written = (tmp_path / "new.tir").read_text(encoding="latin-1")
    assert written == text.replace("PDY1 = 1.0", "PDY1 = 0.5")


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"PDY9": 1.0}, "PDY9 is no coefficient of a MagicFormula61"),
        ({"PEY1": 1.0}, "PEY1 is not in the file: write_tir writes a complete one"),
        ({"FNOMIN": -1.0}, "FNOMIN = -1.0: expected more than 0 N"),
        ({"FNOMIN": math.nan}, "FNOMIN = nan: expected a finite number"),
        ({"FNOMIN": "heavy"}, "FNOMIN = heavy: expected a finite number"),
        ({"FNOMIN": 10**400}, "expected a finite number"),
    ],
)
def test_a_change_that_cannot_be_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(TyreError, match=re.escape(sentence)):
        read(NEWER).text_with(**changes)


def test_a_change_that_would_change_more_is_refused() -> None:
    text = NEWER.replace("INFLPRES = 230000\n", "")
    with pytest.raises(TyreError, match="INFLPRES is not in the file and would follow NOMPRES"):
        read(text).text_with(NOMPRES=2e5)


def test_the_shipped_tyre_is_read_without_notes() -> None:
    file = read_tir(PASSENGER_CAR)
    assert file.notes == ()
    assert (file.tyre.side, file.tyre.use, file.tyre.FNOMIN) == ("left", "combined", 4000.0)
