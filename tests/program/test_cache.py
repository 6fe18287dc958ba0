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
