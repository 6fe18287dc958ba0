"""What ``eom response`` is asked for: options as numbers and signals, every mistake at once."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from eom.analysis.road import CLASSES
from eom.analysis.signals import Channel, signals
from eom.cli.settings import UsageError
from eom.errors import AnalysisError
from eom.model.linear import LinearModel
from eom.vehicle.expression import evaluate
from eom.vehicle.quantity import MEASURED, parse_quantity
from eom.vehicle.validate import did_you_mean

SINE = "sine:"
TIMES = ("step", "impulse", "sine:FREQUENCY")


class Options(NamedTuple):
    """The options as given; None or empty where they are not."""

    source: str | None
    outputs: list[str]
    first: str | None
    last: str | None
    time: str | None
    amplitude: str | None
    duration: str | None
    road: str | None
    speed: str | None
    out: Path | None


class Plan(NamedTuple):
    """Options understood: signals of the model, frequencies [Hz], times [s], speed [m/s].

    ``time`` is ``step``, ``impulse``, ``sine`` or None; ``sine`` its frequency.
    """

    source: str
    channels: tuple[Channel, ...]
    first: float | None
    last: float | None
    time: str | None
    sine: float
    amplitude: float
    duration: float | None
    road: str | None
    speed: float | None

    @property
    def outputs(self) -> tuple[str, ...]:
        """The outputs that the channels are made of."""
        return tuple(dict.fromkeys(part for item in self.channels for part in item.name.split("/")))


def understood(model: LinearModel, options: Options) -> Plan:
    """The plan that options make for a model; raises `UsageError` with every mistake."""
    mistakes = list(contradictions(options))
    source = options.source or next(iter(model.inputs), "")
    if not model.inputs:
        mistakes.append(f"{model.name}: has no inputs, so nothing to respond to: give it actuators or steered axles")
    if not model.outputs:
        mistakes.append(f"{model.name}: has no outputs, so nothing to tell: give it sensors or units")
    channels: tuple[Channel, ...] = ()
    try:
        channels = signals(model, source, options.outputs or None)[1]
    except AnalysisError as error:
        mistakes += str(error).splitlines() if model.inputs else []
    unit = model.input_units[model.inputs.index(source)] if source in model.inputs else "*"
    first, last = (
        frequency(f"--{name}", text, mistakes) for name, text in (("from", options.first), ("to", options.last))
    )
    if first is not None and last is not None and first >= last:
        mistakes.append(f"--from {options.first} --to {options.last}: expected the first one to be smaller")
    time, _, rest = (options.time or "").partition(":")
    sine = frequency(f"--time {SINE}", rest, mistakes) if time == "sine" and rest else None
    amplitude = number("--amplitude", options.amplitude, unit, mistakes)
    plan = Plan(
        source,
        channels,
        first,
        last,
        time or None,
        0.0 if sine is None else sine,
        1.0 if amplitude is None else amplitude,
        positive("--duration", options.duration, "s", mistakes),
        options.road,
        positive("--speed", options.speed, "m/s", mistakes),
    )
    if mistakes:
        raise UsageError("\n".join(mistakes))
    return plan


def contradictions(options: Options) -> Iterator[str]:
    """Sentences for options that name nothing known, or that go with another one which is missing."""
    time, road = options.time, options.road
    if time is not None and time not in {"step", "impulse"} and not (time.startswith(SINE) and time != SINE):
        expected = f"{', '.join(TIMES[:-1])} or {TIMES[-1]}, such as sine:0.4Hz"
        yield f"--time {time}: expected {expected}{did_you_mean(time, TIMES)}"
    if road is not None and road not in CLASSES:
        yield f"--road {road}: expected a class of ISO 8608, {min(CLASSES)} to {max(CLASSES)}"
    for name, value in (("--amplitude", options.amplitude), ("--duration", options.duration)):
        if value is not None and time is None:
            yield f"{name} {value}: goes with --time"
    if options.speed is not None and road is None:
        yield f"--speed {options.speed}: goes with --road; the trim's speed is set in the file or by --set"


def number(option: str, text: str | None, unit: str, mistakes: list[str]) -> float | None:
    """The number of an option in a unit; None if not given, or wrong, with a sentence."""
    if text is None:
        return None
    try:
        return evaluate(parse_quantity(text, unit).expression, {})
    except KeyError:
        mistakes.append(f"{option} {text}: expected a number{f' in {unit}' if unit != '*' else ''}")
    except ValueError as error:
        mistakes.append(f"{option} {text}: {error}")
    return None


def positive(option: str, text: str | None, unit: str, mistakes: list[str]) -> float | None:
    """As `number`, larger than zero."""
    value = number(option, text, unit, mistakes)
    if value is None or value > 0.0:
        return value
    mistakes.append(f"{option} {text}: expected a number larger than zero{f', in {unit}' if unit else ''}")
    return None


def frequency(option: str, text: str | None, mistakes: list[str]) -> float | None:
    """As `positive`, in Hz: a unit of angular speed has the dimension of Hz, but another size."""
    match = MEASURED.fullmatch(text or "")
    if match is not None and match[2] not in {"Hz", "kHz", "1/s"}:
        mistakes.append(f"{option} {text}: expected a frequency in Hz")
        return None
    return positive(option, text, "Hz", mistakes)
