"""A run as a file for MATLAB: dots in names become nested structures."""

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.simulation.channels import STATE, Channels

LONGEST = 63
# fmt: off
WORDS = frozenset({
    "break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for", "function", "global", "if",
    "otherwise", "parfor", "persistent", "return", "spmd", "switch", "try", "while",
})
# fmt: on
"""MATLAB's own words, which cannot be names."""

Tree = dict[str, Any]


def write_matlab(path: Path, time: Array, signals: Channels, about: Mapping[str, str]) -> None:
    """Write signals, their units and what is told about the run; see `eom.simulation.Run.save`.

    Raises `AnalysisError` for names that come to be the same, or one of which is a part of another.
    """
    from scipy.io import savemat  # noqa: PLC0415  slow to import

    names = ("time", *signals.names)
    places = [place(name) for name in names]
    mistakes = clashes(names, places)
    if mistakes:
        raise AnalysisError("\n".join(mistakes))
    content = {
        "run": nested(places, (time, *signals.values.T)),
        "units": nested(places, ("s", *signals.units)),
        "about": {field(key): text for key, text in about.items()},
    }
    savemat(path, content, appendmat=False, long_field_names=True, do_compression=True, oned_as="column")


def place(name: str) -> tuple[str, ...]:
    """The fields, from the outermost in, under which a signal is kept."""
    if name.startswith(STATE):
        return ("state", *place(name.removeprefix(STATE)))
    return tuple(field(part) for part in name.split("."))


def field(part: str) -> str:
    """A name that MATLAB can have."""
    plain = re.sub(r"\W", "_", part, flags=re.ASCII)
    if plain in WORDS or not re.match("[A-Za-z]", plain):
        plain = f"x{plain}"
    return plain[:LONGEST]


def clashes(names: Iterable[str], places: Iterable[tuple[str, ...]]) -> list[str]:
    """Sentences for signals that cannot be kept beside each other."""
    mistakes: list[str] = []
    owners: dict[tuple[str, ...], str] = {}
    told = list(zip(names, places, strict=True))
    for name, where in told:
        if where in owners:
            shown = ".".join(where)
            mistakes.append(f"signal {name}: MATLAB would know it as {shown}, and so it would {owners[where]}")
        owners.setdefault(where, name)
    for name, where in told:
        for k in range(1, len(where)):
            if where[:k] in owners:
                what = "cannot be a number and a structure at once"
                mistakes.append(f"signal {name}: {'.'.join(where[:k])} {what}: signal {owners[where[:k]]}")
    return mistakes


def nested(places: Iterable[tuple[str, ...]], values: Iterable[object]) -> Tree:
    """Values at their places."""
    tree: Tree = {}
    for (*outer, last), value in zip(places, values, strict=True):
        here = tree
        for step in outer:
            here = here.setdefault(step, {})
        here[last] = value
    return tree
