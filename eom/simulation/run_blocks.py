"""Blocks of a run file: of the types that it may name, and nothing that runs code."""

from collections.abc import Mapping
from typing import Any

from eom.simulation.blocks import Block, BlockError
from eom.simulation.run_form import Kind
from eom.simulation.run_inputs import Reading, Stated
from eom.simulation.run_reading import adapters, number, read, required
from eom.vehicle.quantity import Quantity, describe
from eom.vehicle.source import Data, Path, Source
from eom.vehicle.validate import unknown_type


def read_block(name: str, data: Data, kinds: Mapping[str, Kind], reading: Reading) -> Block | None:
    """The block at ``blocks.NAME``, None with mistakes."""
    path: Path = ("blocks", name)
    source = reading.source
    if not isinstance(data, dict):
        if data is not None:
            source.report(path, f"expected a mapping of keys, got {describe(data)}")
        return None
    kind = kind_of(data, kinds, path, source)
    if kind is None:
        return None
    keys = {key: value for key, value in data.items() if key != "type"}
    found = read(kind.form, keys, path, source)
    for key, other in kind.in_unit_of.items():
        quantity = found.get(key)
        if other in found and isinstance(quantity, Quantity) and quantity.dimension is not None:
            reading.stated.append(Stated((*path, key), found[other], quantity.dimension))
    values = {key: block_value(value, (*path, key), reading) for key, value in found.items()}
    # a block without some of its values would make mistakes of its own
    expected = required(kind.form) | set(adapters(kind.form)).intersection(keys)
    if expected <= {key for key, value in values.items() if value is not None}:
        try:
            return kind.block(name=name, **values)
        except BlockError as error:
            for key, what in error.wrong.items():
                source.report((*path, key), what)
    # what it reads can be checked without it
    reading.stated.extend(Stated((*path, key), value, None) for key, value in values.items() if isinstance(value, str))
    return None


def kind_of(data: dict[str, Data], kinds: Mapping[str, Kind], path: Path, source: Source) -> Kind | None:
    """What a block's ``type`` names, None with a mistake."""
    told = data.get("type")
    if isinstance(told, str) and told in kinds:
        return kinds[told]
    if isinstance(told, str):
        context = {"expected_tags": ", ".join(kinds), "tag": told, "discriminator": "type"}
        source.report((*path, "type"), unknown_type(context, ""))
    elif "type" not in data:
        source.report(path, f"needs 'type', one of {', '.join(kinds)}")
    elif told is not None:
        source.report((*path, "type"), f"expected text, got {describe(told)}")
    return None


def block_value(value: Any, path: Path, reading: Reading) -> Any:
    """A value as a block takes it: numbers in SI units, None with a mistake."""
    return number(value, path, reading.source) if isinstance(value, Quantity) else value
