"""Every mistake in a description is reported, all at once, where it stands, and nothing else is.

Numbers that no system may have are found when it is assembled; all the rest when it is loaded.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import eom
from tests.vehicle.monsters import FOLDER, MONSTERS

FILES = sorted(FOLDER.glob("*.yaml"))
EXPECT = re.compile(r"# expect (\d+):(\d+) (.+)")
KILOBYTES = 300_000


def expected(file: Path) -> list[tuple[int, int, str]]:
    """Line, column and essential words from the comments at the file's head."""
    found = []
    for line in file.read_text(encoding="utf-8").splitlines():
        match = EXPECT.fullmatch(line)
        if match is None:
            break
        found.append((int(match[1]), int(match[2]), match[3]))
    return found


def test_there_is_a_corpus() -> None:
    assert len(FILES) >= 110


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_bad_file_gives_exactly_its_mistakes(file: Path) -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.assemble(eom.load(file))
    mistakes = caught.value.mistakes
    wanted = expected(file)
    assert [(m.line, m.column) for m in mistakes] == [(line, column) for line, column, _ in wanted], str(caught.value)
    for mistake, (_, _, words) in zip(mistakes, wanted, strict=True):
        assert words in mistake.what
        assert str(mistake).startswith(f"{file}:{mistake.line}:{mistake.column}: ")


@pytest.mark.parametrize("name", MONSTERS)
def test_a_monster_is_refused_in_a_short_sentence(name: str) -> None:
    text, words = MONSTERS[name]
    with pytest.raises(eom.DescriptionError, match=re.escape(words)) as caught:
        eom.loads(text)
    assert all(len(str(mistake)) < 500 for mistake in caught.value.mistakes)


def test_bad_files_need_little_memory() -> None:
    script = [sys.executable, "-m", "tests.vehicle.monsters"]
    root = Path(__file__).parents[2]
    # threads of numerical libraries would count as memory
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(script, cwd=root, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert int(done.stdout) < KILOBYTES


@pytest.mark.parametrize("path", ["no/such/file.yaml", ".", "a\0b"])
def test_what_is_no_file_is_said_to_be_none(path: str) -> None:
    with pytest.raises(eom.DescriptionError, match="cannot be read"):
        eom.load(path)


def test_an_endless_file_is_refused() -> None:
    with pytest.raises(eom.DescriptionError):
        eom.load("/dev/zero")


@pytest.mark.parametrize("name", ["type", "kind", "frame"])
def test_a_body_may_be_named_like_a_key_and_its_mistakes_are_told_all_the_same(name: str) -> None:
    with pytest.raises(eom.DescriptionError, match=rf"^<text>:2:\d+: bodies.{name}.mass: unknown unit of measure 'x'$"):
        eom.loads(f"name: n\nbodies: {{{name}: {{mass: 1 x, at: [0, 0, 0]}}}}")
