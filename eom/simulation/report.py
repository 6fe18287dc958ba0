"""What a run tells of itself: signals, events, which method ran, why it ended, what it was made of."""

import functools
import platform
from collections.abc import Sequence
from importlib.metadata import version
from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.model.tyre import TyreModel
from eom.program.compiled import installed
from eom.simulation import memory as of
from eom.simulation.channels import Channels, Event
from eom.simulation.descriptions import described
from eom.simulation.engine import Engine
from eom.simulation.equations import Model
from eom.simulation.request import Request
from eom.simulation.run import Run
from eom.simulation.step_choice import STABLE_4
from eom.splice.limits import Limit

NAMES = {
    of.RUNGE_KUTTA: "Runge and Kutta's classical method",
    of.DORMAND_PRINCE: "Dormand and Prince's method of order 5",
    of.ROSENBROCK: "the Rosenbrock method ROS34PW2 of order 3",
}


class Told(NamedTuple):
    """A run and what belongs to it; *held* are instants with what the blocks' ports held from then on."""

    model: Model
    limits: tuple[Limit, ...]
    asked: Request
    engine: Engine
    held: Sequence[tuple[float, Array]]
    diverging: tuple[Event, ...] = ()


def run_of(told: Told, ended: str) -> Run:
    """The run until now."""
    model, own = told.model, told.engine
    count = int(own.counts[of.SAMPLES])
    rows, n, m = own.rows[:count], len(model.states), len(model.inputs)
    wiring = told.asked.wiring
    return Run(
        name=model.vehicle.name if isinstance(model, TyreModel) else model.name,
        time=own.times[:count],
        inputs=channels(model.inputs, model.input_units, rows[:, n : n + m]),
        states=channels(model.states, model.state_units, rows[:, :n]),
        outputs=channels(model.outputs, model.output_units, rows[:, n + m :]),
        blocks=channels(wiring.signals, wiring.units, ports_at(own.times[:count], told)),
        events=(*events(own.events, told.limits), *told.diverging),
        method=method(own),
        ended=ended,
        identity=identity(told),
    )


def channels(names: Sequence[str], units: Sequence[str], values: Array) -> Channels:
    """A group of signals, described in words."""
    return Channels(tuple(names), tuple(units), tuple(map(described, names)), values)


def ports_at(times: Array, told: Told) -> Array:
    """What the blocks' ports hold at some instants, (instants, ports)."""
    if not told.held:
        return np.zeros((len(times), len(told.asked.wiring.signals)))
    instants, values = zip(*told.held, strict=True)
    return np.array(values)[np.searchsorted(instants, times, side="right") - 1]


def events(parts: Sequence[Array], limits: tuple[Limit, ...]) -> tuple[Event, ...]:
    """The limits that were reached, in the order of time, each with when it was left again."""
    found: list[Event] = []
    left: dict[int, float] = {}
    for row in np.concatenate([np.empty((0, of.EVENT_STATE)) if not parts else parts[0], *parts[1:]])[::-1]:
        number, time = int(row[of.EVENT_LIMIT]), float(row[of.EVENT_TIME])
        if row[of.EVENT_REACHED]:
            limit = limits[number]
            until = left.pop(number, None)
            found.append(Event(limit.kind, limit.owner, time, until, limit.sentence, row[of.EVENT_STATE :].copy()))
        else:
            left[number] = time
    found.reverse()
    return tuple(sorted(found, key=lambda event: event.time))


def method(own: Engine) -> str:
    """Which methods ran, and how many steps they took."""
    parts = [f"{int(own.counts[kind])} steps by {name}" for kind, name in NAMES.items() if own.counts[kind]]
    rejected = int(own.counts[of.REJECTED])
    how = "compiled" if installed() else "in Python"
    return f"{' and '.join(parts) or 'no steps'}, {rejected} rejected; {how}"


def sentence(
    status: int,
    clock: Array,
    settings: Array,
    parts: Sequence[Array],
    limits: tuple[Limit, ...],
    diverging: tuple[Event, ...],
) -> str:
    """Why a run ended before its time; *parts* are its events, *diverging* is what follows them."""
    at = f"{clock[of.TIME]:.6g} s"
    root, h = clock[of.ROOT], settings[of.LARGEST]
    match status:
        case of.TERMINAL:
            last = max(
                (row for part in parts for row in part if row[of.EVENT_REACHED] and limits[int(row[1])].ends),
                key=lambda row: row[of.EVENT_TIME],
            )
            limit = limits[int(last[of.EVENT_LIMIT])]
            return f"{at}: {limit.owner}: {limit.sentence}; beyond it the model means nothing"
        case of.UNSTABLE:
            return (
                f"at {at} a step of {h:g} s is unstable: the fastest root is {root:.4g} 1/s, for which rk4 needs steps "
                f"below {STABLE_4 / root:.2g} s; its result would look plausible and be wrong. Take a smaller step, or "
                "method 'automatic'"
            )
        case of.INACCURATE:
            return f"at {at} a step of {h:g} s is too long for rk4 to follow the motion: take a smaller one"
        case of.COLLAPSED:
            return f"at {at} the motion cannot be followed: steps fall below 1e-9 s, and {diverging[0].sentence}"
    return f"at {at} the motion diverges: {diverging[0].sentence}"


@functools.cache
def software(*, compiled: bool) -> str:
    """What computes, with versions; reading them takes longer than a step."""
    packages = ["numpy", *(["numba"] if compiled else [])]
    own = [f"eom {version('eom-vehicle')}", f"Python {platform.python_version()}"]
    return ", ".join(own + [f"{name} {version(name)}" for name in packages])


def identity(told: Told) -> dict[str, str]:
    """What the run was made of: vehicle, parameters, software, how it was integrated."""
    vehicle = told.model.vehicle if isinstance(told.model, TyreModel) else None
    own = told.engine
    found = {} if vehicle is None else {"file": str(vehicle.file), "sha256": vehicle.digest}
    if vehicle is not None:
        found["parameters"] = ", ".join(f"{name} = {value!r}" for name, value in vehicle.values.items())
    found["software"] = software(compiled=installed())
    found["integration"] = (
        f"method {told.asked.method}, tolerance {own.settings[of.TOLERANCE]:g}, "
        f"{'step' if told.asked.method == 'rk4' else 'largest step'} {own.settings[of.LARGEST]:g} s"
    )
    return found
