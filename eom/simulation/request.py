"""What is asked of a run, checked: every mistake at once."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.simulation import memory as of
from eom.simulation.blocks import Block
from eom.simulation.functions import Broken
from eom.simulation.inputs import Input
from eom.simulation.kinds import list_kinds, mapping_kinds, number_kinds
from eom.simulation.sampling_times import multiples
from eom.simulation.signal_pieces import told
from eom.simulation.wiring import Named, Wiring, model_inputs, model_signals, wired
from eom.vehicle.validate import did_you_mean

METHODS = {
    "automatic": of.AUTOMATIC,
    "rk4": of.RUNGE_KUTTA,
    "dormand_prince": of.DORMAND_PRINCE,
    "rosenbrock": of.ROSENBROCK,
}
LARGEST_STEP = 0.5
"""[s]"""
FINEST, COARSEST = 1e-13, 1e-2
"""Tolerances that mean something."""
MOST_SAMPLES = 10_000_000
LARGEST = 4e9
"""Bytes that results may take."""


class Request(NamedTuple):
    """What is asked of a run.

    Attributes
    ----------
    inputs : Mapping
        Constants and pieces.
    duration : float
        [s]
    start : Mapping
        States with their values.
    wiring : Wiring
    times : Array
        Instants of the samples [s].
    method : str
    settings : tuple
        Method, largest or fixed step [s], tolerance.
    """

    inputs: Mapping[str, float | Broken]
    duration: float
    start: Mapping[str, float]
    wiring: Wiring
    times: Array
    method: str
    settings: tuple[int, float, float]


def checked(
    model: Named,
    inputs: Mapping[str, Input],
    duration: float,
    speed: float | None,
    start: Mapping[str, float] | None,
    blocks: Sequence[Block],
    wires: Mapping[str, str],
    sample: float,
    method: str,
    step: float | None,
    tolerance: float,
) -> Request:
    """What is asked of a run; raises `SimulationError` with a sentence for every mistake."""
    numbers, optional = {"duration": duration, "sample": sample, "tolerance": tolerance}, {"speed": speed, "step": step}
    start = {} if start is None else start
    if mistakes := [*number_kinds(numbers, optional), *kind_mistakes(inputs, start, blocks, wires)]:
        raise SimulationError("\n".join(mistakes))
    mistakes = [*unknown("input", inputs, model.inputs), *unknown("state", start, model.states)]
    mistakes += [
        f"input {name} has a signal and a wire: an input follows one of them" for name in wires if name in inputs
    ]
    mistakes += number_mistakes(duration, sample, speed, step, tolerance, start)
    if not (isinstance(method, str) and method in METHODS):
        hint = did_you_mean(str(method), METHODS)
        mistakes.append(f"method = {method!r}: expected {', '.join(METHODS)}{hint}")
    elif method == "rk4" and step is None:
        mistakes.append("method = 'rk4' needs a step, such as step=1e-3")
    usable = np.isfinite(duration) and duration > 0.0
    found: dict[str, float | Broken] = {}
    for name, item in inputs.items():
        try:
            found[name] = told(item, name, duration if usable else 1.0)
        except SimulationError as error:
            mistakes.append(str(error))
    wiring = None
    try:
        wiring = wired(blocks, wires, model_signals(model), model_inputs(model))
    except SimulationError as error:
        mistakes += str(error).splitlines()
    if mistakes or wiring is None:
        raise SimulationError("\n".join(mistakes))
    settings = METHODS[method], LARGEST_STEP if step is None else step, tolerance
    return Request(found, duration, start, wiring, multiples(sample, duration), method, settings)


def kind_mistakes(inputs: object, start: object, blocks: object, wires: object) -> Iterator[str]:
    """Sentences for what is no mapping or no list, or holds no numbers or ports."""
    yield from mapping_kinds({"inputs": inputs, "start": start, "wires": wires})
    yield from list_kinds("blocks", blocks, "blocks")
    if isinstance(start, Mapping):
        yield from number_kinds({f"start of {name}": value for name, value in start.items()}, {})
    for name, port in wires.items() if isinstance(wires, Mapping) else ():
        if not isinstance(port, str):
            yield f"wire {name}: expected a port 'BLOCK.PORT', got {port!r}"


def check_size(cases: int, samples: int, signals: int, remedy: str) -> None:
    """Raise `SimulationError` for results that memory may not hold, with what to do."""
    size = 8.0 * cases * samples * signals
    if size > LARGEST:
        raise SimulationError(f"results of {size / 1e9:.3g} GB, expected at most {LARGEST / 1e9:g}: {remedy}")


def unknown(kind: str, names: Mapping[str, object], known: tuple[str, ...]) -> Iterator[str]:
    """Sentences for names that a model does not have."""
    for name in names:
        if name not in known:
            yield f"{kind} {name}: the model has none of this name{did_you_mean(name, known)}"


def number_mistakes(
    duration: float,
    sample: float,
    speed: float | None,
    step: float | None,
    tolerance: float,
    start: Mapping[str, float],
) -> Iterator[str]:
    """Sentences for numbers that cannot be."""
    usable = True
    for name, value in (("duration", duration), ("sample", sample), ("step", step)):
        if value is not None and not (np.isfinite(value) and value > 0.0):
            usable = False
            yield f"{name} = {value}: expected a time above zero, in s"
    if usable and not duration / sample <= MOST_SAMPLES:
        yield f"sample = {sample:g}: makes {duration / sample:.3g} samples, at most {MOST_SAMPLES} are allowed"
    if speed is not None and not (np.isfinite(speed) and speed > 0.0):
        yield f"speed = {speed}: expected a speed above zero, in m/s"
    if not FINEST <= tolerance <= COARSEST:
        yield f"tolerance = {tolerance}: expected {FINEST:g} to {COARSEST:g}"
    for name, value in start.items():
        if not np.isfinite(value):
            yield f"start of {name} = {value}: expected a finite number"
