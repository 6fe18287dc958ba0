"""What is worth knowing of a .tir file and no mistake is noted where it stands."""

import pytest

from eom.tyre import read_tir
from eom.tyre.tir.write import tir_text
from tests.tyre.tir_samples import FORCES, NEWER, OLDER, PASSENGER_CAR, read

NO_EFFECT_52 = "no effect in the Magic Formula 5.2; change FITTYP if fitted for the Magic Formula 6.1"
NO_EFFECT_61 = "no effect in the Magic Formula 6.1; change FITTYP if fitted for the Magic Formula 5.2"


def noted(text: str) -> list[str]:
    return [f"{note.line}:{note.column} {note.where}: {note.what}" for note in read(text).notes]


def test_a_zero_stands_for_the_letter_in_the_factor_of_nominal_load() -> None:
    text = NEWER + "[SCALING_COEFFICIENTS]\nLFZ0 = 1.25\n"
    assert read(text).tyre.LFZO == 1.25
    assert noted(text) == ["24:1 SCALING_COEFFICIENTS.LFZ0: read as LFZO"]


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
        (NEWER + "NOMPRES = 210000\n", ["23:1 OPERATING_CONDITIONS.NOMPRES: stands in line 22 as well"]),
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
                "21:1 OPERATING_CONDITIONS.INFLPRES: is 2.3 Pa, which is little",
                "22:1 OPERATING_CONDITIONS.NOMPRES: is 2.1 Pa, which is little",
            ],
        ),
        (
            NEWER + "[ALIGNING_COEFFICIENTS]\nQBZ6 = 1\n[SCALING_COEFFICIENTS]\nLMUV = 0.1\n",
            [
                "24:1 ALIGNING_COEFFICIENTS.QBZ6: acts only in the book's form",
                "26:1 SCALING_COEFFICIENTS.LMUV: acts only in the book's form",
            ],
        ),
        (
            NEWER + "[TURNSLIP_COEFFICIENTS]\nPDXP1 = 0.4\nPDXP2 = 0\nPKYP1 = 1\n[SCALING_COEFFICIENTS]\nLMP = 1\n",
            ["24:1 TURNSLIP_COEFFICIENTS: not modelled: turn slip (PDXP1, PKYP1)"],
        ),
        (
            NEWER + "[INERTIA]\nMASS = 9.3\nIXX = 0.4\n[VERTICAL]\nBOTTOM_OFFST = 0.01\nQ_FCY2 = 0.1\n",
            [
                "24:1 INERTIA: not modelled: mass and inertia (MASS, IXX)",
                "27:1 VERTICAL: not modelled: contact of the rim (BOTTOM_OFFST)",
                "28:1 VERTICAL: not modelled: loaded radius with camber (Q_FCY2)",
            ],
        ),
        (
            NEWER + "[MAKER]\nCOLOUR = 'black'\nWIDTH = 0.2\n[MODEL]\nWEAR_LAW = 3\n",
            [
                "24:1 MAKER: unknown section, not read (COLOUR, WIDTH)",
                "27:1 MODEL: unknown, not read (WEAR_LAW)",
            ],
        ),
        (
            NEWER + "[SHAPE]\n{radial width}\n1.0 0.0\n0.9 1.0\n",
            ["25:1 SHAPE: not modelled: a table of 2 lines"],
        ),
        (
            NEWER + "[DIMENSION]\nBREFF = 8\n",
            ["24:1 DIMENSION: read, though most files have it in another section: BREFF"],
        ),
        (
            OLDER + "PEY5 = 0\nPKY4 = 2\n[OPERATING_CONDITIONS]\nINFLPRES = 80000\n[TIRE_CONDITIONS]\nIP = 80000\n"
            "[OVERTURNING_COEFFICIENTS]\nQSX4 = 5\nQSX7 = 0\nQSX8 = 0.1\n[STRUCTURAL]\nLATERAL_STIFFNESS = 1e5\n",
            [
                "23:1 OPERATING_CONDITIONS: the Magic Formula 5.2 has no pressure (INFLPRES)",
                "25:1 TIRE_CONDITIONS: the Magic Formula 5.2 has no pressure (IP)",
                f"27:1 OVERTURNING_COEFFICIENTS: {NO_EFFECT_52} (QSX4 = 5, QSX8 = 0.1)",
                "31:1 STRUCTURAL: not part of the Magic Formula 5.2 (LATERAL_STIFFNESS)",
            ],
        ),
        (
            NEWER + "[LATERAL_COEFFICIENTS]\nPHY3 = 0.1\nPTY1 = 0\n[SCALING_COEFFICIENTS]\nLGAY = 0.5\nLGAX = 1\n",
            [
                f"24:1 LATERAL_COEFFICIENTS: {NO_EFFECT_61} (PHY3 = 0.1)",
                f"27:1 SCALING_COEFFICIENTS: {NO_EFFECT_61} (LGAY = 0.5)",
            ],
        ),
        (
            OLDER.replace("= 6\n", "= 6\nFE_METHOD = 'YES'\nBELT_DYNAMICS = 'NO'\nMFSAFE3 =\nMESSAGES = 'YES'\n"),
            ["3:1 MODEL: not modelled: the friction ellipse in combined slip, which is as the coefficients"],
        ),
        (
            OLDER + "[SCALING_COEFFICIENTS]\nLCZ = 0.44\nLIP = 1\nLGYR = 1\nLKG = 1.3\nLKYG = 0.9\n"
            "[LATERAL_COEFFICIENTS]\nPTY3 = 0.1\n[INERTIA]\nCOLOUR = 3\n",
            [
                "21:1 SCALING_COEFFICIENTS: not modelled: VERTICAL_STIFFNESS is not scaled by it (LCZ)",
                "24:1 SCALING_COEFFICIENTS: not modelled: PAC2002's own, which the forces here lack (LKG = 1.3)",
                "25:1 SCALING_COEFFICIENTS.LKYG: read as LKYC",
                "27:1 LATERAL_COEFFICIENTS: not modelled: PAC2002's own, which the relaxation lengths here lack (PTY3)",
                "29:1 INERTIA: unknown, not read (COLOUR)",
            ],
        ),
        (
            OLDER.replace("FITTYP = 6\n", "FITTYP = 5\n"),
            ["2:1 MODEL.FITTYP: read by the equations of the Magic Formula 5.2; 5.0 and 5.1 have a part"],
        ),
        (
            OLDER.replace("FITTYP = 6\n", "PROPERTY_FILE_FORMAT = 'MF_05'\n"),
            ["2:1 MODEL.PROPERTY_FILE_FORMAT: read by the equations of the Magic Formula 5.2; 5.0 and 5.1"],
        ),
        (
            OLDER.replace("RBX1 = 12\n", "").replace("RCY1 = 1\n", ""),
            [
                "7:1 LONGITUDINAL_COEFFICIENTS: RBX1 = 0, RCY1 = 0: the slips do not weaken each other's force",
            ],
        ),
        (
            OLDER.replace("RCY1 = 1", "RCY1 = 0"),
            ["13:1 LATERAL_COEFFICIENTS: RCY1 = 0: the longitudinal slip takes nothing from the lateral force"],
        ),
        (
            NEWER + "[DIMENSION]\nWIDTH =\nRIM_RADIUS =   $ not measured\n[MODEL]\nUSE_MODE =\n[UNITS]\nTIME =\n",
            [
                "24:1 DIMENSION: without a value, taken as not given: WIDTH, RIM_RADIUS",
                "27:1 MODEL: without a value, taken as not given: USE_MODE",
                "29:1 UNITS: without a value, taken as not given: TIME",
            ],
        ),
        (NEWER + "[VERTICAL]\nQ_RE0 = 0\n", []),
    ],
)
def test_what_is_worth_knowing_is_noted_at_its_place_and_nothing_else(text: str, notes: list[str]) -> None:
    found = noted(text)
    assert len(found) == len(notes), found
    assert all(note.startswith(words) for note, words in zip(found, notes, strict=True)), found


def test_the_shipped_tyre_is_read_without_notes() -> None:
    file = read_tir(PASSENGER_CAR)
    assert file.notes == ()
    assert (file.tyre.side, file.tyre.use, file.tyre.FNOMIN) == ("left", "combined", 4000.0)


LATERAL_ONLY = NEWER[: NEWER.index("PCX1")] + NEWER[NEWER.index("[LATERAL") :]
LATERAL_NOTE = (
    "7:1 LONGITUDINAL_COEFFICIENTS: use = 'lateral': the tyre has no longitudinal force, as {} are missing or zero; "
    "taken in the equations: {}"
)


@pytest.mark.parametrize(
    ("text", "names", "values"),
    [
        (LATERAL_ONLY, "PCX1, PDX1, PKX1", "PCX1 = 1, PDX1 = 1, PKX1 = 1"),
        (
            NEWER.replace("= 1.6", "= 0").replace("= 1.1", "= 0.0").replace("PKX1 = 20", "PKX1 ="),
            "PCX1, PDX1, PKX1",
            "PCX1 = 1, PDX1 = 1, PKX1 = 1",
        ),
        (NEWER.replace("= 1.1", "= 0").replace("PKX1 = 20", "PKX1 = 0"), "PDX1, PKX1", "PDX1 = 1, PKX1 = 1"),
    ],
)
def test_a_tyre_that_was_measured_sideways_has_lateral_forces_alone(text: str, names: str, values: str) -> None:
    file = read(text)
    full = read(NEWER).tyre.forces(0.05, 0.0, 4000.0)
    assert LATERAL_NOTE.format(names, values) in noted(text)
    assert file.tyre.use == "lateral"
    # straight rolling ahead, longitudinal coefficients have no part in the lateral force
    assert file.tyre.forces(0.05, 0.0, 4000.0).Fy == full.Fy
    assert file.tyre.forces(0.05, 0.1, 4000.0).Fx == 0.0
    assert read(tir_text(file.tyre)).tyre == file.tyre


def test_a_tyre_that_was_measured_along_has_longitudinal_forces_alone() -> None:
    file = read(NEWER.replace("PCY1 = 1.3\nPDY1 = 1.0\nPKY1 = -20\nPKY2 = 1.5\n", ""))
    assert (file.tyre.use, file.tyre.PKY1, file.tyre.PKY2) == ("longitudinal", -1.0, 1.0)
    assert file.tyre.forces(0.0, 0.1, 4000.0).Fx == read(NEWER).tyre.forces(0.0, 0.1, 4000.0).Fx
    assert file.tyre.forces(0.1, 0.1, 4000.0).Fy == 0.0
    assert any("use = 'longitudinal': the tyre has no lateral force" in note for note in noted(file.text))
    assert read(tir_text(file.tyre)).tyre == file.tyre


def test_a_zero_where_none_can_be_is_taken_as_not_given() -> None:
    text = NEWER.replace("61\n", "61\nVXLOW = 0\n", 1)
    assert noted(text) == ["3:1 MODEL.VXLOW: is 0, which it cannot be: taken as not given"]
    assert read(text).tyre.VXLOW == 1.0
