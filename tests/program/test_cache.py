"""What outlives the process is made once, and again where its file is damaged."""

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.program import cache


def making(contents: list[bytes]) -> Callable[[], bytes]:
    """Gives one content after the other."""
    left = iter(contents)
    return lambda: next(left)


@given(content=st.binary(max_size=40))
def test_a_content_is_made_once(content: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    with pytest.MonkeyPatch.context() as patch:
        folder = tmp_path_factory.mktemp("cache")
        patch.setattr(cache, "folder", lambda: folder)
        make = making([content])
        assert [cache.kept("name", make) for _ in range(3)] == [content] * 3
        assert [path.name for path in folder.iterdir()] == ["name"]


@pytest.mark.parametrize("damage", ["cut", "emptied", "changed", "longer"])
def test_a_damaged_file_is_made_again(damage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "folder", lambda: tmp_path)
    make = making([b"machine code", b"machine code again"])
    cache.kept("name", make)
    path = tmp_path / "name"
    whole = path.read_bytes()
    other = {"cut": whole[:-1], "emptied": b"", "changed": whole[:-1] + b"x", "longer": whole + b"x"}
    path.write_bytes(other[damage])
    assert [cache.kept("name", make) for _ in range(2)] == [b"machine code again"] * 2


def test_where_the_folder_cannot_be_written_one_is_used_that_ends_with_the_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A folder below a file can be made by nobody, not even by root."""
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "file" / "folder"))
    found = cache.folder.__wrapped__()
    assert found.is_dir()
    assert tmp_path not in found.parents
    cache.TEMPORARY.pop().cleanup()
    assert not found.exists()
