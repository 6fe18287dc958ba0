"""What is worth knowing of a .tir file and no mistake is noted where it stands."""

import pytest

from eom.tyre import read_tir
from tests.tyre.tir_samples import FORCES, NEWER, OLDER, PASSENGER_CAR, read


def noted(text: str) -> list[str]:
    return [f"{note.line}:{note.column} {note.where}: {note.what}" for note in read(text).notes]


def test_a_zero_stands_for_the_letter_in_the_factor_of_nominal_load() -> None:
    text = NEWER + "[SCALING_COEFFICIENTS]\nLFZ0 = 1.25\n"
    assert read(text).tyre.LFZO == 1.25
    assert noted(text) == ["20:1 SCALING_COEFFICIENTS.LFZ0: read as LFZO"]


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
                "19:1 OPERATING_CONDITIONS: not part of the Magic Formula 5.2 and without effect (INFLPRES)",
                "21:1 OVERTURNING_COEFFICIENTS: not part of the Magic Formula 5.2 and without effect (QSX4)",
            ],
        ),
        (
            OLDER.replace("= 6\n", "= 6\nFE_METHOD = 'YES'\nBELT_DYNAMICS = 'NO'\nMFSAFE3 =\nTYPE = 'CAR'\n"),
            ["3:1 MODEL: not modelled: friction ellipse in place of combined-slip coefficients (FE_METHOD)"],
        ),
        (
            OLDER + "[SCALING_COEFFICIENTS]\nLCZ = 0.44\nLIP = 1\nLGYR = 1\n",
            ["17:1 SCALING_COEFFICIENTS: not modelled: scale of VERTICAL_STIFFNESS, which stays as"],
        ),
        (
            OLDER + "[SCALING_COEFFICIENTS]\nLKG = 1.3\n[ALIGNING_COEFFICIENTS]\nQPZ1 = 0.1\n",
            [
                "17:1 SCALING_COEFFICIENTS: not modelled: PAC2002's own terms, which the forces and",
                "19:1 ALIGNING_COEFFICIENTS: not modelled: PAC2002's own terms, which the forces and",
            ],
        ),
        (OLDER.replace("= 6\n", "= 5\n"), ["2:1 MODEL.FITTYP: read by the equations of the Magic Formula 5.2"]),
        (
            OLDER.replace("FITTYP = 6\n", "PROPERTY_FILE_FORMAT = 'MF_05'\n"),
            ["2:1 MODEL.PROPERTY_FILE_FORMAT: read by the equations of the Magic Formula 5.2"],
        ),
        (OLDER + "[TIRE_CONDITIONS]\nIP = 2.5E5\n", ["17:1 TIRE_CONDITIONS: not part of the Magic Formula 5.2"]),
        (
            OLDER + "PPY1 = 0.1\nPKY4 = 1.8\n[SCALING_COEFFICIENTS]\nLMUV = 0.5\n",
            [
                "16:1 LATERAL_COEFFICIENTS: not part of the Magic Formula 5.2 and without effect (PPY1, PKY4)",
                "19:1 SCALING_COEFFICIENTS: not part of the Magic Formula 5.2 and without effect (LMUV)",
            ],
        ),
        (
            NEWER.replace("PKY2 = 1.5\n", "PKY2 = 1.5\nPHY3 = 0.1\n[SCALING_COEFFICIENTS]\nLGAY = 0\n"),
            [
                "16:1 LATERAL_COEFFICIENTS: not part of the Magic Formula 6.1 and without effect (PHY3)",
                "18:1 SCALING_COEFFICIENTS: not part of the Magic Formula 6.1 and without effect (LGAY)",
            ],
        ),
        (
            NEWER.replace("FNOMIN = 4000\n", "FNOMIN = 4000\nBREFF =\nQ_RE0 = 0\nDREFF = $ 0.2\n"),
            [
                "7:1 VERTICAL: without a value, taken as not given: BREFF, DREFF",
                "8:1 VERTICAL.Q_RE0: is 0, which it cannot be: taken as not given",
            ],
        ),
        (NEWER + "[SCALING_COEFFICIENTS]\nLKYG = 1.07\n", ["20:1 SCALING_COEFFICIENTS.LKYG: read as LKYC"]),
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


@pytest.mark.parametrize(
    ("text", "use", "zero", "section"),
    [
        (NEWER.replace("PCX1 = 1.6\nPDX1 = 1.1\nPKX1 = 20\n", ""), "lateral", "Fx", 7),
        (OLDER.replace("1.6", "0").replace("1.1", "0").replace("= 20\n", "= 0\n"), "lateral", "Fx", 7),
        (NEWER.replace("PCY1 = 1.3\nPDY1 = 1.0\nPKY1 = -20\nPKY2 = 1.5\n", ""), "longitudinal", "Fy", 11),
    ],
)
def test_a_tyre_without_coefficients_of_one_direction_has_the_forces_of_the_other(
    text: str, use: str, zero: str, section: int
) -> None:
    file = read(text)
    forces = file.tyre.forces(0.05, 0.05, 4000.0)._asdict()
    assert file.tyre.use == use
    assert forces[zero] == 0.0
    assert abs(forces[{"Fx": "Fy", "Fy": "Fx"}[zero]]) > 1000.0
    assert [note.line for note in file.notes] == [section]
    assert f"read for {use} use" in file.notes[0].what
