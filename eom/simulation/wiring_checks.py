"""What is wrong with blocks and wires: every mistake, with the block or wire to which it belongs."""

import math
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from eom.simulation.blocks import Block, input_units, is_direct, port_names
from eom.simulation.sampling_times import SMALLEST
from eom.vehicle.units import parse_unit
from eom.vehicle.validate import did_you_mean
from eom.vehicle.values import in_order, show_ring

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
ATTRIBUTES = ("name", "inputs", "outputs", "units", "period", "reset", "update")


class Wrong(NamedTuple):
    """A mistake: ``blocks`` or ``wires``, the name there, the sentence, and the name that is wrong, if one is."""

    kind: str
    owner: str
    what: str
    name: str = ""

    def __str__(self) -> str:
        return f"{self.kind.removesuffix('s')} {self.owner}: {self.what}"


def block_mistakes(blocks: Sequence[Block]) -> list[Wrong]:
    """Mistakes of blocks as such."""
    mistakes: list[Wrong] = []
    names: set[str] = set()
    for number, block in enumerate(blocks, 1):
        missing = [name for name in ATTRIBUTES if not hasattr(block, name)]
        if missing or isinstance(block, type):
            what = f"expected a block with {', '.join(ATTRIBUTES)}"
            came = f"the class {block.__name__}" if isinstance(block, type) else f"a {type(block).__name__}"
            without = f" without {', '.join(missing)}" if missing and not isinstance(block, type) else ""
            mistakes.append(Wrong("blocks", f"number {number}", f"{what}, got {came}{without}"))
            continue
        mistakes += [Wrong("blocks", str(block.name), what) for what in own_mistakes(block)]
        if block.name in names:
            mistakes.append(Wrong("blocks", block.name, "the name is given twice: every block has its own"))
        names.add(block.name)
    return mistakes


def own_mistakes(block: Block) -> Iterator[str]:
    """Sentences for what is wrong with a block by itself."""
    if not (isinstance(block.name, str) and NAME.fullmatch(block.name)):
        yield f"{block.name!r} is no name: a letter, then letters, digits, underscores"
    for key in ("inputs", "outputs"):
        value: object = getattr(block, key)
        if isinstance(value, str) or not (isinstance(value, Sequence) and all(isinstance(name, str) for name in value)):
            yield f"{key}: expected a tuple of names, got {value!r}"
            return
    ports = list(block.outputs)
    yield from (f"has the port '{port}' twice" for port in dict.fromkeys(ports) if ports.count(port) > 1)
    yield from (f"'{port}' is no name of a port" for port in ports if not NAME.fullmatch(port))
    for key, value, count in (
        ("units", block.units, len(ports)),
        ("input_units", input_units(block), len(block.inputs)),
    ):
        if len(value) != count:
            yield f"{key}: expected {count}, got {len(value)}"
    if not (isinstance(block.period, (float, int, np.number)) and SMALLEST <= block.period < math.inf):
        yield f"period: expected a time of at least {SMALLEST:g} s, got {block.period!r}"


def producers(block: Block, blocks: Sequence[Block], *, direct_only: bool = False) -> list[str]:
    """Names of the blocks that a block reads, or of the direct ones alone."""
    named = {name.split(".", maxsplit=1)[0] for name in block.inputs}
    found = [other for other in blocks if other.name in named and (is_direct(other) or not direct_only)]
    return [other.name for other in found if set(block.inputs).intersection(port_names(other))]


def signal_mistakes(
    blocks: Sequence[Block], signals: Mapping[str, str] | None, excused: Collection[str] = ()
) -> list[Wrong]:
    """Mistakes of what blocks read; without the model's signals only whether direct blocks wait for each other.

    Blocks in *excused* are known to be wrong.
    """
    rings = in_order({block.name: producers(block, blocks, direct_only=True) for block in blocks})[1]
    hint = "make one of them 'direct = False', as a sensor with a delay is"
    mistakes = [Wrong("blocks", ring[0], f"waits for itself, {show_ring(ring[::-1])}: {hint}") for ring in rings]
    if signals is None:
        return mistakes
    known = [*signals, *(name for block in blocks for name in port_names(block))]
    for block in blocks:
        for name in dict.fromkeys(block.inputs):
            if name not in known and name.split(".", maxsplit=1)[0] not in excused:
                what = f"reads '{name}': there is no such signal{did_you_mean(name, known)}"
                mistakes.append(Wrong("blocks", block.name, what, name))
        for name in port_names(block):
            if name in signals:
                what = f"its port '{name}' has the name of a signal of the model: give the block another name"
                mistakes.append(Wrong("blocks", block.name, what))
    return mistakes + unit_mistakes(blocks, signals)


def unit_mistakes(blocks: Sequence[Block], signals: Mapping[str, str]) -> list[Wrong]:
    """Mistakes of units in which blocks read signals."""
    units = {**signals, **resolved_units(blocks, signals)}
    return [
        Wrong("blocks", block.name, f"reads '{name}', which is in {units[name]}, expected a signal in {unit}", name)
        for block in blocks
        for name, unit in zip(block.inputs, input_units(block), strict=True)
        if name in units and not same_unit(units[name], unit or "")
    ]


def wire_mistakes(
    blocks: Sequence[Block],
    wires: Mapping[str, str],
    signals: Mapping[str, str],
    inputs: Mapping[str, str] | None,
    excused: Collection[str] = (),
) -> list[Wrong]:
    """Mistakes of wires; without the model's inputs only those of ports. Blocks in *excused* are known to be wrong."""
    ports = [name for block in blocks for name in port_names(block)]
    mistakes = []
    for target, source in wires.items():
        if inputs is not None and target not in inputs:
            what = f"there is no such input{did_you_mean(target, inputs)}"
            mistakes.append(Wrong("wires", target, what))
        if source not in ports and source.split(".", maxsplit=1)[0] not in excused:
            why = "a sensor makes one of it" if source in signals else "there is no such port"
            what = f"expected a port 'BLOCK.PORT', got '{source}': {why}{did_you_mean(source, ports)}"
            mistakes.append(Wrong("wires", target, what, source))
    units = resolved_units(blocks, signals)
    return mistakes + [
        Wrong("wires", target, f"'{source}' is in {units[source]}, expected {inputs[target]}", source)
        for target, source in wires.items()
        if source in units and inputs and target in inputs and not same_unit(units[source], inputs[target])
    ]


def resolved_units(blocks: Sequence[Block], signals: Mapping[str, str]) -> dict[str, str]:
    """Units of all ports, those of first inputs filled in; empty where nothing tells."""
    units: dict[str, str | None] = {
        name: unit for block in blocks for name, unit in zip(port_names(block), block.units, strict=True)
    }
    waiting = [block for block in blocks if None in block.units and block.inputs]
    # a chain of sensors has as many links as there are blocks at most
    for _ in range(len(waiting)):
        for block in waiting:
            told = signals.get(block.inputs[0], units.get(block.inputs[0]))
            units |= {name: told for name in port_names(block) if units[name] is None}
    return {name: unit or "" for name, unit in units.items()}


def same_unit(given: str, wanted: str) -> bool:
    """Whether two units are of one dimension and size, as far as is known."""
    if not given or not wanted or given == wanted:
        return True
    try:
        (one, dimension), (other, expected) = parse_unit(given), parse_unit(wanted)
    except ValueError:
        # a file may call the unit of an actuator or sensor what it likes
        return True
    return dimension == expected and math.isclose(one, other)
