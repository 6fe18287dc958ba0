"""A folder for what outlives the process: files that are named for all that they depend on."""

import contextlib
import hashlib
import os
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

VARIABLE = "EOM_CACHE"
"""Environment variable that names another folder."""
PACKAGE = Path(__file__).parents[1]
TEMPORARY: list[tempfile.TemporaryDirectory[str]] = []
"""Folders that end with the process."""
DIGEST = 32
"""Bytes before the content of a file that tell whether it is whole."""


@cache
def folder() -> Path:
    """Where compiled code is kept: the user's cache, or a temporary folder where that cannot be written."""
    import platformdirs  # noqa: PLC0415

    wanted = Path(os.environ.get(VARIABLE) or platformdirs.user_cache_path("eom")).absolute()
    try:
        wanted.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=wanted):
            return wanted
    except OSError:
        TEMPORARY.append(tempfile.TemporaryDirectory(prefix="eom"))
        return Path(TEMPORARY[-1].name)


@cache
def sources() -> str:
    """Hash of all that compiled code is made from: this package and its compiler."""
    from importlib.metadata import version  # noqa: PLC0415

    result = hashlib.sha256(f"{sys.version} {version('numba')} {version('llvmlite')} {version('numpy')}".encode())
    for part in ("program", "simulation", "splice", "tyre"):
        for path in sorted((PACKAGE / part).rglob("*.py")):
            result.update(path.read_bytes())
    return result.hexdigest()


def key(*parts: str) -> str:
    """Short hash of texts and of the sources."""
    return hashlib.sha256("\n".join((sources(), *parts)).encode()).hexdigest()[:24]


def kept(name: str, make: Callable[[], bytes]) -> bytes:
    """The content of a file, made if there is none or a damaged one, which machine code must not be."""
    path = folder() / name
    found = path.read_bytes() if path.exists() else b""
    digest, content = found[:DIGEST], found[DIGEST:]
    if digest != hashlib.sha256(content).digest():
        content = make()
        # where it cannot be kept it is there all the same
        with contextlib.suppress(OSError):
            replace(path, hashlib.sha256(content).digest() + content)
    return content


def replace(path: Path, content: bytes) -> None:
    """Write a file at once: another process sees all of it or nothing."""
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write(content)
    Path(file.name).replace(path)
