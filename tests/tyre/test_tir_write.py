"""What is written is read, exactly; a change of a number changes nothing else."""

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import TyreError
from eom.tyre import MagicFormula52, MagicFormula61, read_tir, write_tir
from eom.tyre.mf.ranges import range_ends
from eom.tyre.tir.keys import fields_of
from eom.tyre.tir.write import tir_text
from tests.tyre.tir_samples import NEWER, OTHER_UNITS, PASSENGER_CAR, read


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
        # PTY1 forbids PTY2 to be zero
        strategies[name] = numbers.filter(bool) if item.metadata.get("non_zero") or name == "PTY2" else numbers
    ends = [item.name for item in range_ends(version)]
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
    for path in (tmp_path / "taken", tmp_path / "no" / "folder.tir", "a\0b"):
        with pytest.raises(TyreError, match="cannot be written: "):
            write_tir(tyre, path)
    assert [file.name for file in tmp_path.iterdir()] == ["taken"]


def test_several_tyres_in_one_object_are_no_file() -> None:
    tyre = dataclasses.replace(read_tir(PASSENGER_CAR).tyre, PDY1=np.array([0.9, 1.0]))
    with pytest.raises(TyreError, match="holds one tyre: PDY1 should be numbers, not arrays"):
        tir_text(tyre)


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
        ({"PEY1": 1.0}, "PEY1 is not given in the file: write_tir writes a complete one"),
        ({"FNOMIN": -1.0}, "FNOMIN = -1.0: expected more than 0 N"),
        ({"FNOMIN": math.nan}, "FNOMIN = nan: expected a finite number"),
        ({"FNOMIN": "heavy"}, "FNOMIN = heavy: expected a finite number"),
        ({"FNOMIN": 10**400}, "expected a finite number"),
    ],
)
def test_a_change_that_cannot_be_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(TyreError, match=re.escape(sentence)):
        read(NEWER).text_with(**changes)


@pytest.mark.parametrize(
    ("line", "expected"),
    [("WIDTH =", "WIDTH =0.2"), ("WIDTH =   $ m", "WIDTH = 0.2  $ m"), ("WIDTH = ! m", "WIDTH = 0.2! m")],
)
def test_a_change_fills_a_value_that_was_not_given(line: str, expected: str) -> None:
    text = f"{NEWER}[DIMENSION]\n{line}\nASPECT_RATIO =\n"
    assert read(text).tyre.WIDTH == 0.0
    assert read(text).text_with(WIDTH=0.2) == text.replace(line, expected)


@given(st.integers(1, 10**6), st.integers(0, 4))
def test_a_change_is_written_with_no_more_digits_than_it_has(digits: int, places: int) -> None:
    inch = NEWER.replace("UNLOADED_RADIUS = 0.3", "UNLOADED_RADIUS = 12")
    number = f"{digits / 10**places:.{max(places, 1)}f}"
    file = read(f"[UNITS]\nLENGTH = 'inch'\n{inch}")
    radius = read(file.text.replace("RADIUS = 12", f"RADIUS = {number}")).tyre.UNLOADED_RADIUS
    written = re.search("UNLOADED_RADIUS = (.*)", file.text_with(UNLOADED_RADIUS=float(radius)))
    assert written
    assert float(written[1]) == float(number)


def test_a_change_in_millimetres_is_written_as_people_write_it() -> None:
    assert "UNLOADED_RADIUS = 432.1\n" in read(OTHER_UNITS).text_with(UNLOADED_RADIUS=0.4321)


def test_a_coefficient_of_a_direction_that_the_file_lacks_cannot_be_changed_alone() -> None:
    text = NEWER.replace("= 1.6", "= 0").replace("= 1.1", "= 0").replace("PKX1 = 20", "PKX1 = 0")
    with pytest.raises(TyreError, match="PDX1 is not given in the file: write_tir writes a complete one"):
        read(text).text_with(PDX1=1.2)
    assert read(read(text).text_with(PDY1=0.9)).tyre == dataclasses.replace(read(text).tyre, PDY1=0.9)


def test_a_change_that_would_change_more_is_refused() -> None:
    text = NEWER.replace("INFLPRES = 230000\n", "")
    with pytest.raises(TyreError, match="INFLPRES is not in the file and would change as well"):
        read(text).text_with(NOMPRES=2e5)


def test_a_number_is_written_in_the_unit_of_its_file_as_short_as_it_can_be() -> None:
    changed = read(OTHER_UNITS).text_with(UNLOADED_RADIUS=0.4321, INFLPRES=210e3)
    assert "UNLOADED_RADIUS = 432.1\n" in changed
    assert "INFLPRES = 2.1\n" in changed
