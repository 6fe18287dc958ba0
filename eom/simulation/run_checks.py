"""What does not go together in a run file, and what does not go with a model."""

from collections.abc import Collection, Iterator
from typing import Any

from eom.errors import DescriptionError, Mistake
from eom.simulation.blocks import port_names
from eom.simulation.run_spec import RunFile
from eom.simulation.wiring import Named, model_inputs, model_signals
from eom.simulation.wiring_checks import Wrong, signal_mistakes, wire_mistakes
from eom.vehicle.source import Path, Source
from eom.vehicle.units import Dimension, parse_unit, show_dimension, stated_in
from eom.vehicle.validate import did_you_mean


def own_mistakes(run: RunFile, inputs: tuple[str, ...]) -> Iterator[Mistake]:
    """Mistakes of a run that need no model: what does not go together."""
    source = run.source
    if run.step is not None and run.method != "rk4":
        yield source.mistake(("step",), "goes with 'method: rk4': other methods find their steps themselves")
    if run.sample is not None and run.duration and run.sample > run.duration:
        yield source.mistake(("sample",), f"is {run.sample:g} s: longer than the duration of {run.duration:g} s")
    for name in run.wires:
        if name in inputs:
            what = "stands under 'inputs' too: an input follows a signal over time or a block, not both"
            yield source.mistake_at(source.keys[("wires", name)], ("wires", name), what)


def check_against(run: RunFile, model: Named) -> None:
    """Raise `DescriptionError` with every input, signal and unit of a run file that a model does not have."""
    if mistakes := mistakes_against(run, model, tuple(run.inputs)):
        raise DescriptionError(mistakes)


def mistakes_against(
    run: RunFile, model: Named | None, inputs: tuple[str, ...], wrong: Collection[str] = ()
) -> list[Mistake]:
    """What does not go with a model, or without one what does not go together; blocks in *wrong* are reported."""
    source = run.source
    if model is None:
        found = [*signal_mistakes(run.blocks, None), *wire_mistakes(run.blocks, run.wires, {}, None, wrong)]
        return [placed(item, source) for item in found]
    known, signals = model_inputs(model), model_signals(model)
    found = [*signal_mistakes(run.blocks, signals, wrong), *wire_mistakes(run.blocks, run.wires, signals, known, wrong)]
    mistakes = [placed(item, source) for item in found]
    for name in inputs:
        if name not in known:
            place = source.keys[("inputs", name)]
            what = f"there is no such input{did_you_mean(name, known)}"
            mistakes.append(source.mistake_at(place, ("inputs", name), what))
    ports = [port for block in run.blocks for port in port_names(block)]
    for path, signal, dimension in run.stated:
        if dimension is not None and signal in signals:
            expected = dimension_of(signals[signal], dimension)
            if dimension != expected:
                what = f"is {stated_in(dimension)}, expected {signals[signal] or show_dimension(expected)}"
                mistakes.append(source.mistake(path, what))
        elif dimension is None and signal not in {*signals, *ports} and signal.split(".", maxsplit=1)[0] not in wrong:
            what = f"there is no such signal{did_you_mean(signal, [*signals, *ports])}"
            mistakes.append(source.mistake(path, what))
    return mistakes


def dimension_of(unit: str, otherwise: Dimension) -> Dimension:
    """The dimension of a signal's unit; *otherwise* where the unit is a word of the file's own."""
    try:
        return parse_unit(unit)[1]
    except ValueError:
        return otherwise


def placed(item: Wrong, source: Source) -> Mistake:
    """A mistake of blocks and wires at its place in the file."""
    path: Path = (item.kind, item.owner)
    part: Any = source.data[item.kind]
    entry = part[item.owner]
    if isinstance(entry, dict):
        key = next((key for key, value in entry.items() if item.name and value == item.name), None)
        return source.mistake(path if key is None else (*path, key), item.what)
    return source.mistake(path, item.what) if item.name else source.mistake_at(source.keys[path], path, item.what)
