"""The keys of a run file, part by part."""

from collections.abc import Callable, Mapping
from typing import Annotated, Any, Literal, NamedTuple, NotRequired, TypedDict

from pydantic import BeforeValidator, Field

from eom.simulation.blocks import Block
from eom.simulation.sensors import Sensor
from eom.vehicle.expression import shorten
from eom.vehicle.parts import Identifier
from eom.vehicle.quantity import MEASURED, Any_, Plain, Quantity, Slot, Speed, Time

MAX_PARTS = 500
SignalName = Annotated[str, Field(max_length=200)]


def in_hertz(value: object) -> object:
    """A frequency as it stands; ``ValueError`` for an angular speed, which has the dimension but not the size."""
    match = MEASURED.fullmatch(value) if isinstance(value, str) else None
    if match is not None and match[2] not in {"Hz", "kHz", "1/s"}:
        message = f"'{shorten(str(value))}' is no frequency, expected Hz"
        raise ValueError(message)
    return value


Frequency = Annotated[Quantity, Slot("Hz"), BeforeValidator(in_hertz)]


class RunForm(TypedDict):
    """A run file as a whole; inputs and blocks are looked into one by one."""

    duration: Time
    speed: NotRequired[Speed]
    sample: NotRequired[Time]
    method: NotRequired[Literal["automatic", "rk4", "dormand_prince", "rosenbrock"]]
    step: NotRequired[Time]
    inputs: NotRequired[Annotated[dict[str, Any], Field(max_length=MAX_PARTS)]]
    blocks: NotRequired[Annotated[dict[Identifier, Any], Field(max_length=MAX_PARTS)]]
    wires: NotRequired[Annotated[dict[str, SignalName], Field(max_length=MAX_PARTS)]]


class InputForm(TypedDict):
    """An input that changes, in one of these ways; ``column`` goes with ``file``."""

    sine: NotRequired[Any]
    table: NotRequired[Any]
    steps: NotRequired[Any]
    file: NotRequired[SignalName]
    column: NotRequired[SignalName]


class SineForm(TypedDict):
    """Cycles of a sine from ``start`` on."""

    amplitude: Any_
    frequency: Frequency
    start: NotRequired[Time]
    cycles: NotRequired[Plain]


class TableForm(TypedDict):
    """Values at times."""

    time: tuple[Time, ...]
    value: tuple[Any_, ...]


class SensorForm(TypedDict):
    """A sensor."""

    signal: SignalName
    period: Time
    delay: NotRequired[Time]
    noise: NotRequired[Any_]
    seed: NotRequired[Plain]


class Kind(NamedTuple):
    """A type of block that a run file may name.

    Attributes
    ----------
    form : type
        TypedDict of its keys, besides ``type``.
    block : Callable
        Makes the block from its ``name`` and the values of the keys that are given, numbers in SI units.
    in_unit_of : Mapping
        Keys whose unit is that of the signal that another key names.
    """

    form: type
    block: Callable[..., Block]
    in_unit_of: Mapping[str, str]


SENSOR = Kind(SensorForm, Sensor, {"noise": "signal"})
