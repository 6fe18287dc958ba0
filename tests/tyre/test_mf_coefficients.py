"""Coefficients of the Magic Formula: the published ones, their bounds, and the sides of a vehicle."""

import dataclasses
import math
import re
from typing import Any

import numpy as np
import pytest

from eom.errors import TyreError
from eom.tyre import MagicFormula52, MagicFormula61
from eom.tyre.mf.relaxation import relaxation_lengths
from eom.tyre.parameters import coefficients
from eom.tyre.tir.keys import SECTION_OF, fields_of

NEEDED: dict[str, Any] = {
    "FNOMIN": 4000.0,
    "UNLOADED_RADIUS": 0.3,
    "PCX1": 1.6,
    "PDX1": 1.1,
    "PKX1": 20.0,
    "PCY1": 1.3,
    "PDY1": 1.0,
    "PKY1": -20.0,
    "PKY2": 1.5,
}

# Pacejka, Tire and Vehicle Dynamics, 3rd edition 2012, section 4.3.2 and appendix 3, less turn slip; QBZ6 is
# (4.E40) of the book, QBZ4 (A58) and QSX12 to QSX14 (49) of Besselink, Schmeitz and Pacejka 2010 and its preprint
PUBLISHED_61 = """PCX1 PDX1:3 PEX1:4 PKX1:3 PHX1:2 PVX1:2 PPX1:4 RBX1:3 RCX1 REX1:2 RHX1 PCY1 PDY1:3 PEY1:5 PKY1:7
PHY1:2 PVY1:4 PPY1:5 RBY1:4 RCY1 REY1:2 RHY1:2 RVY1:6 QBZ1:6 QBZ9:10 QCZ1 QDZ1:4 QDZ6:11 QEZ1:5 QHZ1:4 PPZ1:2 SSZ1:4
QSX1:14 PPMX1 QSY1:8 LFZO LCX LMUX LEX LKX LHX LVX LCY LMUY LEY LKY LHY LVY LTR LRES LXAL LYKA LVYKA LS LKYC LKZC LMX
LVMX LMY LMUV"""

# MF-Tyre User Manual 5.2, TNO 2001, less turn slip and gyroscopic moment; LKYC and LKZC are what later tools read
# instead of LGAY and LGAZ
PUBLISHED_52 = """PCX1 PDX1:3 PEX1:4 PKX1:3 PHX1:2 PVX1:2 RBX1:2 RCX1 REX1:2 RHX1 PTX1:3 PCY1 PDY1:3 PEY1:4 PKY1:3
PHY1:3 PVY1:4 RBY1:3 RCY1 REY1:2 RHY1:2 RVY1:6 PTY1:2 QBZ1:5 QBZ9:10 QCZ1 QDZ1:4 QDZ6:9 QEZ1:5 QHZ1:4 SSZ1:4 QSX1:3
QSY1:4 LFZO LCX LMUX LEX LKX LHX LVX LGAX LCY LMUY LEY LKY LHY LVY LGAY LTR LRES LGAZ LXAL LYKA LVYKA LS LSGKP LSGAL
LMX LVMX LMY LKYC LKZC"""


def expand(names: str) -> list[str]:
    """Names of a list in which PDX1:3 stands for PDX1, PDX2 and PDX3."""
    found = []
    for name in names.split():
        match = re.fullmatch(r"(\D+)(\d+):(\d+)", name)
        found += [f"{match[1]}{k}" for k in range(int(match[2]), int(match[3]) + 1)] if match else [name]
    return found


@pytest.mark.parametrize(("version", "names"), [(MagicFormula61, PUBLISHED_61), (MagicFormula52, PUBLISHED_52)])
def test_the_coefficients_of_the_equations_are_the_published_ones(
    version: type[MagicFormula61 | MagicFormula52], names: str
) -> None:
    own = {item.name for item in coefficients(version) if SECTION_OF[item.name].endswith("COEFFICIENTS")}
    assert own == set(expand(names))


@pytest.mark.parametrize("version", [MagicFormula61, MagicFormula52])
def test_every_field_has_a_section_or_says_how_the_tyre_is_used(version: type[MagicFormula61 | MagicFormula52]) -> None:
    others = {item.name for item in dataclasses.fields(version)} - fields_of(version).keys()
    assert others - {"form"} == {"side", "mirror", "use"}


def test_without_more_a_tyre_is_scaled_by_one_and_has_no_other_terms() -> None:
    tyre = MagicFormula61(**NEEDED)
    rest = [item for item in coefficients(tyre) if SECTION_OF[item.name].endswith("COEFFICIENTS")]
    for item in rest:
        if item.name not in NEEDED:
            usual = {"PKY4": 2.0, "LMUV": 0.0}.get(item.name, float(item.name.startswith("L")))
            assert getattr(tyre, item.name) == usual, item.name


def test_inflation_pressure_is_the_nominal_one_unless_given() -> None:
    assert MagicFormula61(**NEEDED, NOMPRES=250e3).INFLPRES == 250e3
    assert MagicFormula61(**NEEDED, NOMPRES=250e3, INFLPRES=230e3).INFLPRES == 230e3
    changed = dataclasses.replace(MagicFormula61(**NEEDED), NOMPRES=300e3)
    assert changed.INFLPRES == 200e3


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"FNOMIN": 0.0}, "FNOMIN = 0.0: expected more than 0 N (nominal load)"),
        ({"PDY1": 0.0}, "PDY1 = 0.0: expected a number other than 0 (peak friction)"),
        ({"LMUX": -1.0}, "LMUX = -1.0: expected more than 0 (scales the peak friction of Fx)"),
        ({"PEY1": math.nan}, "PEY1 = nan: expected a finite number (curvature E)"),
        ({"INFLPRES": -1.0}, "INFLPRES = -1.0: expected more than 0 Pa"),
        ({"FZMIN": 5.0, "FZMAX": 4.0}, "FZMAX = 4.0: expected a number above FZMIN = 5.0"),
        ({"ALPMAX": math.nan}, "ALPMAX = nan: expected a number above ALPMIN = -inf"),
        ({"KPUMIN": "low"}, "KPUMIN = low: expected a number of at least -inf"),
        ({"FZMIN": -math.inf}, "FZMIN = -inf: expected a number of at least 0"),
        ({"side": "front"}, "side = 'front': expected one of None, 'left', 'right'"),
        ({"use": "braking"}, "use = 'braking': expected one of 'longitudinal', 'lateral', 'uncombined', 'combined'"),
        ({"form": "paper"}, "form = 'paper': expected one of 'tool', 'book'"),
    ],
)
def test_a_coefficient_out_of_its_bounds_gets_its_sentence(change: dict[str, object], sentence: str) -> None:
    with pytest.raises(TyreError, match=re.escape(f"MagicFormula61: {sentence}")):
        MagicFormula61(**{**NEEDED, **change})


def test_all_wrong_coefficients_are_told_at_once() -> None:
    with pytest.raises(TyreError) as caught:
        MagicFormula52(**{**NEEDED, "PCX1": -1.0, "PTY1": 2.0, "PTY2": 0.0, "FZMAX": -1.0, "side": "top"})
    told = {line.split(" = ")[0] for line in str(caught.value).splitlines()}
    assert told == {f"MagicFormula52: {name}" for name in ("PCX1", "PTY2", "FZMAX", "side")}


def test_on_the_other_side_a_tyre_is_mirrored_and_on_its_own_it_is_not() -> None:
    left = MagicFormula61(**NEEDED, side="left")
    assert left.on("right").mirror
    assert left.on("right").on("right") == left.on("right")
    assert left.on("right").on("left") == left == left.on("left")


def test_a_tyre_for_both_sides_is_the_same_on_each() -> None:
    tyre = MagicFormula52(**NEEDED)
    assert tyre.on("left") is tyre
    assert tyre.on("right") is tyre


def test_there_is_no_third_side() -> None:
    with pytest.raises(TyreError, match="on side 'left' or 'right', not 'front'"):
        MagicFormula61(**NEEDED).on("front")  # type: ignore[arg-type]


def test_a_version_52_tyre_without_a_lateral_relaxation_length_has_zero() -> None:
    tyre = MagicFormula52(**{**NEEDED, "PTX1": 2.0, "PTY1": 0.0, "PTY2": 0.0})
    found = relaxation_lengths(tyre, np.array([0.0, 4000.0]))
    assert np.all(np.asarray(found.kappa) > 0.0)
    assert np.array_equal(found.alpha, [0.0, 0.0])


def test_the_greatest_lateral_relaxation_length_is_at_its_load() -> None:
    tyre = MagicFormula52(**{**NEEDED, "PTY1": 2.0, "PTY2": 1.5})
    loads = np.array([0.5, 1.0, 1.5]) * 1.5 * tyre.FNOMIN
    found = np.asarray(relaxation_lengths(tyre, loads).alpha)
    # PTY1 R0 sin(2 arctan(Fz/(PTY2 FNOMIN))), rounding of a few operations
    expected = 2.0 * tyre.UNLOADED_RADIUS * np.sin(2.0 * np.arctan([0.5, 1.0, 1.5]))
    assert np.allclose(found, expected, rtol=1e-14)
    assert np.argmax(found) == 1
