"""Compiled functions that outlive the process: small files that numba caches, named for all that they depend on."""

import contextlib
import hashlib
import importlib.util
import os
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

VARIABLE = "EOM_CACHE"
"""Environment variable that names another folder."""
PACKAGE = Path(__file__).parents[1]


@cache
def folder() -> Path:
    """Where compiled code is kept: the user's cache, or a temporary folder where that cannot be written."""
    import platformdirs  # noqa: PLC0415

    wanted = Path(os.environ.get(VARIABLE) or platformdirs.user_cache_path("eom"))
    try:
        wanted.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=wanted):
            return wanted
    except OSError:
        return Path(tempfile.mkdtemp(prefix="eom"))


@cache
def sources() -> str:
    """Hash of all that compiled code is made from: this package and its compiler."""
    from importlib.metadata import version  # noqa: PLC0415

    result = hashlib.sha256(f"{sys.version} {version('numba')} {version('numpy')}".encode())
    for part in ("program", "simulation", "splice", "tyre"):
        for path in sorted((PACKAGE / part).rglob("*.py")):
            result.update(path.read_bytes())
    return result.hexdigest()


def key(*parts: str) -> str:
    """Short hash of texts and of the sources."""
    return hashlib.sha256("\n".join((sources(), *parts)).encode()).hexdigest()[:24]


def module(name: str, text: str) -> Any:
    """The module of a text, kept in the cache's folder so that numba finds what it compiled of it before."""
    path = folder() / f"{name}.py"
    if not path.exists():
        replace(path, text.encode())
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise ImportError(path)
    found = importlib.util.module_from_spec(spec)
    sys.modules[name] = found
    spec.loader.exec_module(found)
    return found


def replace(path: Path, content: bytes) -> None:
    """Write a file at once: another process sees all of it or nothing."""
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write(content)
    Path(file.name).replace(path)


@contextlib.contextmanager
def straight_lines_in_vectors() -> Iterator[None]:
    """Within it numba's compiler joins like operations of straight lines to vector instructions."""
    config: Any = import_module("numba.core.config")
    before = config.SLP_VECTORIZE
    config.SLP_VECTORIZE = 1
    try:
        yield
    finally:
        config.SLP_VECTORIZE = before
