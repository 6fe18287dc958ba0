"""Tyres and limits of a vehicle with wheels as source."""

import dataclasses
from pathlib import Path
from typing import Any

from eom.codegen.source import literal
from eom.model.tyre import TyreModel
from eom.splice.kinds import KINDS
from eom.tyre.tir.file import read_tir
from eom.vehicle.elements import System


def named_files(draft: System) -> tuple[System, dict[str, str]]:
    """The elements with names in place of the paths of tyres' files, and the paths by these names."""
    files: dict[str, str] = {}
    for law in draft.tyres:
        if law.file and law.file not in files.values():
            name, count = Path(law.file).name, 1
            while name in files:
                count += 1
                name = f"{Path(law.file).stem}_{count}{Path(law.file).suffix}"
            files[name] = law.file
    names = {path: name for name, path in files.items()}
    laws = tuple(law._replace(file=names.get(law.file, "")) for law in draft.tyres)
    return draft._replace(tyres=laws), files


def tyre_fields(model: TyreModel, files: dict[str, str]) -> dict[str, Any]:
    """What the module of a vehicle with wheels says of its tyres and limits."""
    kinds = sorted({law.kind for law in model.vehicle.system.tyres})
    return {
        "kinds": [(literal(kind), KINDS[kind].__name__) for kind in kinds],
        "files": [(literal(name), *coefficients(path)) for name, path in files.items()],
        "limits": [tuple(map(literal, limit)) for limit in model.limits],
        "measured": len(model.prepared.system.outputs),
    }


def coefficients(path: str) -> tuple[str, list[tuple[str, str]]]:
    """Class and given coefficients of the tyre of a file."""
    tyre = read_tir(path).tyre
    given = [
        (item.name, literal(getattr(tyre, item.name)))
        for item in dataclasses.fields(tyre)
        if getattr(tyre, item.name) != item.default
    ]
    return type(tyre).__name__, given
