"""Every mistake in a .tir file is reported, all at once, where it stands, and nothing else is."""

import os
import re
from pathlib import Path
from typing import Self

import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import DescriptionError, Mistake
from eom.tyre import read_tir
from eom.tyre.tir.file import MAX_BYTES, read_text
from eom.tyre.tir.tyre import MAX_MISTAKES
from tests.tyre.tir_samples import NEWER, PASSENGER_CAR

FOLDER = Path(__file__).parent / "bad_tir"
FILES = sorted(FOLDER.glob("*.tir"))
EXPECT = re.compile(r"\ufeff?\$ expect (\d+):(\d+) (.+)")


def expected(file: Path) -> list[tuple[int, int, str]]:
    """Line, column and essential words from the comments at the file's head."""
    lines = file.read_text(encoding="utf-8").splitlines()
    found = [match for line in lines if (match := EXPECT.fullmatch(line))]
    return [(int(match[1]), int(match[2]), match[3]) for match in found]


def test_there_is_a_corpus() -> None:
    assert len(FILES) >= 62


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_bad_file_gives_exactly_its_mistakes(file: Path) -> None:
    with pytest.raises(DescriptionError) as caught:
        read_tir(file)
    mistakes, wanted = caught.value.mistakes, expected(file)
    assert [(m.line, m.column) for m in mistakes] == [(line, column) for line, column, _ in wanted], str(caught.value)
    for mistake, (_, _, words) in zip(mistakes, wanted, strict=True):
        assert words in mistake.what
        assert str(mistake).startswith(f"{file}:{mistake.line}:{mistake.column}: ")
        assert len(str(mistake).splitlines()) == 1


def test_a_mistake_names_section_and_key() -> None:
    text = PASSENGER_CAR.read_text(encoding="utf-8").replace("= 4000 ", "= -1 ")
    line = text[: text.index("FNOMIN")].count("\n") + 1
    with pytest.raises(DescriptionError, match=rf"^car:{line}:28: VERTICAL\.FNOMIN: expected more than 0 N"):
        read_text(text, "car")


@pytest.mark.parametrize("path", ["no/such/file.tir", "a\0b"])
def test_what_is_no_file_is_said_to_be_none(path: str) -> None:
    with pytest.raises(DescriptionError, match="cannot be read"):
        read_tir(path)


def test_a_folder_is_said_to_be_one(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match=r"is a folder, expected a \.tir file"):
        read_tir(tmp_path)


def test_what_is_no_regular_file_is_refused_unopened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.tir")
    # opening a pipe that nobody writes to would wait for ever
    for path in (tmp_path / "pipe.tir", Path("/dev/zero")):
        with pytest.raises(DescriptionError, match="is no regular file"):
            read_tir(path)


def test_a_file_of_50_megabytes_is_refused_unopened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "large.tir"
    path.touch()
    os.truncate(path, 50_000_000)
    monkeypatch.setattr(Path, "open", lambda *_: pytest.fail("opened"))
    with pytest.raises(DescriptionError, match=f"has 50000000 bytes; a .tir file has at most {MAX_BYTES}"):
        read_tir(path)


def test_of_a_binary_file_no_more_than_its_head_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "binary.tir"
    path.write_bytes(b"PK\3\4\0\0" + b"x" * 500_000)
    asked = []
    plain_open = Path.open

    class Counting:
        def __init__(self) -> None:
            self.stream = plain_open(path, "rb")

        def __enter__(self) -> Self:
            return self

        def __exit__(self, *_: object) -> None:
            self.stream.close()

        def read(self, count: int) -> bytes:
            asked.append(count)
            return self.stream.read(count)

    monkeypatch.setattr(Path, "open", lambda *_: Counting())
    with pytest.raises(DescriptionError, match="is a binary file"):
        read_tir(path)
    assert sum(asked) <= 4096


def test_text_of_two_bytes_per_letter_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "wide.tir"
    path.write_text("[MODEL]\nFITTYP = 61\n", encoding="utf-16")
    with pytest.raises(DescriptionError, match="two bytes per letter"):
        read_tir(path)


MONSTERS = {
    "one long line": "x" * 900_000,
    "one long key": "[LATERAL_COEFFICIENTS]\n" + "P" * 900_000 + " = 1",
    "one long number": "[MODEL]\nFITTYP = 61\n[LATERAL_COEFFICIENTS]\nPKY1 = " + "9" * 900_000,
    "one long section": "[" + "A" * 900_000 + "]\n",
    "blanks in a section": "[" + " " * 450_000 + "A" + " " * 450_000,
    "blanks after a value": "[MODEL]\nFITTYP = 61" + " " * 900_000 + "'",
    "equals signs": "[MODEL]\n" + "=" * 900_000,
    "quotes": "[MODEL]\nTYRESIDE = " + "'" * 900_000,
    "unknown coefficients": "[MODEL]\nFITTYP=61\n[LATERAL_COEFFICIENTS]\n"
    + "".join(f"PKY1{k:05} = 1\n" for k in range(50_000)),
    "unknown keys": "[MODEL]\nFITTYP=61\n" + "".join(f"UNLOADED_RAD{k:05} = 1\n" for k in range(40_000)),
    "one key again and again": "[MODEL]\nFITTYP=61\n[LATERAL_COEFFICIENTS]\n"
    + "".join(f"PKY1 = {k}\n" for k in range(60_000)),
    "sections": "".join(f"[S{k}]\nA = 1\n" for k in range(60_000)),
    "terms of the other version": "[MODEL]\nFITTYP=6\n[OVERTURNING_COEFFICIENTS]\n" + "QSX4 = 1\n" * 80_000,
    "rows": "[MODEL]\n" + "1 2\n" * 200_000,
    "letters of all kinds": "".join(map(chr, range(1, 256))) * 3_000,
}


@pytest.mark.parametrize("name", MONSTERS)
def test_a_monster_is_refused_in_a_few_short_sentences(name: str) -> None:
    with pytest.raises(DescriptionError) as caught:
        read_text(MONSTERS[name], "monster")
    assert len(caught.value.mistakes) <= MAX_MISTAKES + 1
    assert all(len(str(mistake)) < 500 for mistake in caught.value.mistakes)


def test_of_very_many_mistakes_the_number_is_told() -> None:
    text = "[MODEL]\nFITTYP=61\n[LATERAL_COEFFICIENTS]\n" + "".join(f"XYZ{k} = 1\n" for k in range(500))
    with pytest.raises(DescriptionError, match=r"and 404 more mistakes from here on"):
        # 500 unknown keys, and four sections that lack coefficients, of which the first 100 are told
        read_text(text, "many")


PIECES = """[MODEL] [UNITS] [VERTICAL] [LATERAL_COEFFICIENTS] [ [] ] = $ ! { ' " 61 6 1.5 -2D3 1e399 nan mm kN FITTYP
USE_MODE TYRESIDE LENGTH FNOMIN PKY1 PKY2 PHY3 LFZ0 QSX4 FZMAX INFLPRES PAC2002 FORM book"""


@given(st.lists(st.sampled_from([*PIECES.split(), "\n", "\n", " = "]) | st.characters(max_codepoint=255), max_size=60))
def test_any_text_is_a_tyre_or_a_list_of_mistakes(pieces: list[str]) -> None:
    for text in (" ".join(pieces), NEWER + "\n".join(pieces)):
        mistakes: tuple[Mistake, ...] = ()
        try:
            assert read_text(text, "any").tyre.FNOMIN > 0
        except DescriptionError as error:
            mistakes = error.mistakes
        assert all(0 < mistake.line <= len(text) + 1 for mistake in mistakes)
