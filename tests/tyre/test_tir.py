"""Files of tyres as users have them: units, spellings, versions, sides, modes of use."""

import math
from pathlib import Path

import pytest

from eom.tyre import MagicFormula52, MagicFormula61, read_tir
from tests.tyre.tir_samples import FORCES, NEWER, OLDER, OTHER_UNITS, read


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


@pytest.mark.parametrize(
    "spelling", ["'RIGHT'", "' Right '", '"Right"', "right", "'right' $ comment", "  right ! comment"]
)
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


def test_pressures_of_pac2002_have_their_own_names() -> None:
    text = f"[MODEL]\nFITTYP = 61\n{FORCES}[TIRE_CONDITIONS]\nIP = 250000\nIP_NOM = 240000\n"
    tyre = read(text).tyre
    assert isinstance(tyre, MagicFormula61)
    assert (tyre.INFLPRES, tyre.NOMPRES) == (250e3, 240e3)


def test_units_are_read_from_the_header_too() -> None:
    text = NEWER.replace("= 0.3\n", "= 300\n")
    assert read(f"[HEADER]\nFILE_TYPE = 'tir'\nLENGTH = 'mm'\n{text}").tyre.UNLOADED_RADIUS == 0.3
