"""Run files: what to simulate, read from YAML with every mistake at its place."""

import hashlib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path as FilePath
from typing import Any

from eom.errors import DescriptionError, Mistake
from eom.simulation.blocks import Block
from eom.simulation.run_blocks import read_block
from eom.simulation.run_checks import mistakes_against, own_mistakes
from eom.simulation.run_form import Kind, RunForm
from eom.simulation.run_inputs import Reading, read_input
from eom.simulation.run_reading import positive, read
from eom.simulation.run_spec import RunFile
from eom.simulation.wiring import Named
from eom.vehicle.source import MAX_BYTES, Source, read_source

# what the reader of vehicle files calls what it reads, and what that is here
WORDS = {"a vehicle file": "a run file", "'bodies:' and 'parameters:'": "'duration:' and 'inputs:'"}


def load_run(path: str | FilePath, kinds: Mapping[str, Kind], model: Named | None = None) -> RunFile:
    """Read a run file.

    Parameters
    ----------
    path : str or Path
        The YAML file.
    kinds : Mapping
        The types of blocks that it may name, such as `eom.driver.KINDS`.
    model : model, optional
        What it will run: the file is checked against its signals too, as by `check_against`.

    Raises
    ------
    DescriptionError
        With every mistake.
    """
    try:
        with FilePath(path).open("rb") as file:
            raw = file.read(4 * MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        what = f"cannot be read: {getattr(error, 'strerror', None) or error}"
        raise DescriptionError([Mistake(str(path), 0, 0, "", what)]) from None
    return loads_run(raw, kinds, str(path), model)


def loads_run(
    text: str | bytes, kinds: Mapping[str, Kind], file: str = "<text>", model: Named | None = None
) -> RunFile:
    """The run that a text describes; see `load_run`. Names of files in it start from the folder of *file*."""
    raw = text.encode("utf-8", "surrogatepass") if isinstance(text, str) else text
    source = source_of(raw, file)
    reading = Reading(source, FilePath(file).parent)
    values = read(RunForm, source.data, (), source)
    given = {name: read_input(name, data, reading) for name, data in values.get("inputs", {}).items()}
    blocks = {name: read_block(name, data, kinds, reading) for name, data in values.get("blocks", {}).items()}
    wires = values.get("wires", {})
    wrong = unread(source, blocks, wires)
    run = RunFile(
        file,
        hashlib.sha256(raw).hexdigest(),
        positive(values, "duration", (), source) or 0.0,
        positive(values, "speed", (), source),
        positive(values, "sample", (), source),
        values.get("method", "automatic"),
        positive(values, "step", (), source),
        {name: item for name, item in given.items() if item is not None},
        tuple(block for block in blocks.values() if block is not None),
        wires,
        source,
        tuple(reading.stated),
    )
    source.mistakes += [*own_mistakes(run, tuple(given)), *mistakes_against(run, model, tuple(given), wrong)]
    if source.mistakes:
        raise DescriptionError(source.mistakes)
    return run


def source_of(raw: bytes, file: str) -> Source:
    """The data of a run file's text; raises `DescriptionError` if it is no YAML mapping or too large."""
    try:
        return read_source(raw.decode(), file)
    except UnicodeDecodeError as error:
        what = f"not readable as UTF-8 text: {error.reason} at {error.start}"
        raise DescriptionError([Mistake(file, 0, 0, "", what)]) from None
    except DescriptionError as error:
        # the same reader as that of vehicles, which names what it reads
        raise DescriptionError([replace(item, what=in_words_of_runs(item.what)) for item in error.mistakes]) from None


def in_words_of_runs(what: str) -> str:
    """A sentence of the reader of vehicle files as one about a run file."""
    for of_vehicles, of_runs in WORDS.items():
        what = what.replace(of_vehicles, of_runs)
    return what


def unread(source: Source, blocks: Mapping[str, Block | None], wires: Mapping[str, str]) -> set[str]:
    """Names of blocks that could not be read; all that wires name if the section as a whole could not."""
    written: Any = source.data.get("blocks")
    if source.mistakes and not isinstance(written, dict):
        return {port.split(".", maxsplit=1)[0] for port in wires.values()}
    return {name for name in written or {} if blocks.get(name) is None}
