"""All cases of a batch before their first step: their memory, filled."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from eom.assembly.vectors import Array
from eom.program.calls import Calls, Each
from eom.program.compiled import installed
from eom.program.make import Program
from eom.simulation import memory as of
from eom.simulation.advance import advance
from eom.simulation.engine import beginning, places, python_call, room_of
from eom.simulation.equations import Equations
from eom.simulation.fleet import Fleet
from eom.simulation.pieces import DEGREE, FIRST, INPUT, LAST
from eom.simulation.signal_pieces import Driven


def fleet(
    equations: Equations,
    parameters: Array,
    starts: Sequence[Array],
    inputs: Sequence[Driven],
    times: Array,
    columns: Any,
    settings: tuple[int, float, float],
    threads: int | None,
) -> Fleet:
    """Cases that are about to start; *parameters* are (parameters, cases)."""
    program, cases = equations.ready.program, len(starts)
    at, size = places(program, len(inputs[0].base))
    n, limits, m = (int(at[k]) for k in (of.STATES, of.LIMITS, of.INPUTS))
    work = np.ones((cases, size))
    work[:, :m] = [item.base for item in inputs]
    work[:, m : m + len(parameters)] = parameters.T
    pieces, signals = joined_signals(inputs)
    begun = begun_each(equations, parameters, starts, inputs, settings[1])
    own: dict[str, Any] = {
        "settings": np.array(settings, dtype=float),
        "times": times,
        "columns": columns,
        "terminal": np.array([limit.ends for limit in equations.limits], dtype=bool),
        "at": at,
        "pieces": pieces,
    }
    each: dict[str, Any] = {
        "clock": np.array([clock for clock, _ in begun]),
        "counts": np.zeros((cases, of.COUNTS), dtype=np.int64),
        "margins": np.zeros((cases, 3, limits)),
        "rows": np.full((cases, len(times), len(columns)), np.nan),
        "v": np.array([v for _, v in begun]),
        "work": work,
        "signals": signals,
    }
    room = np.zeros((cases, room_of(limits), of.EVENT_STATE + n))
    stops = [item.stops for item in inputs]
    alone: dict[str, Any] = {
        "events": room,
        "jacobian": np.zeros((cases, n, n)),
        "factors": np.zeros((cases, n, n)),
        "pivots": np.zeros((cases, n), dtype=np.int64),
        "stops": stops,
    }
    program_of = program.address if installed() else Each(Called(program, parameters))
    rest = {"looking": False, "until": 0.0, "pause": 0.0, "closed": False, "program": program_of}
    return Fleet(
        program=program,
        parameters=parameters,
        events=[[] for _ in range(cases)],
        stops=np.concatenate(stops),
        stops_first=np.cumsum([0, *map(len, stops)]),
        status=np.zeros(cases, dtype=np.int64),
        inputs=inputs,
        threads=threads or os.cpu_count() or 1,
        room=room,
        calls=Calls(advance, cases, {**own, **rest, **{name: Each(item) for name, item in {**each, **alone}.items()}}),
        **own,
        **each,
    )


@dataclass(frozen=True)
class Called:
    """What the loops call for the results of a program in each case, made when it is asked for."""

    program: Program
    parameters: Array

    def __getitem__(self, case: int) -> Any:
        return python_call(self.program, self.parameters[:, case])


def begun_each(
    equations: Equations, parameters: Array, starts: Sequence[Array], inputs: Sequence[Driven], largest: float
) -> list[tuple[Array, Array]]:
    """Clock and vectors of each case."""
    result = []
    for own, x, item in zip(parameters.T, starts, inputs, strict=True):
        ready = equations.ready._replace(parameters=np.ascontiguousarray(own))
        result.append(beginning(equations._replace(ready=ready), x, item, largest))
    return result


def joined_signals(inputs: Sequence[Driven]) -> tuple[Array, Any]:
    """The pieces of all cases, and their signals, (cases, signals, 4); what changes in one is a signal in all."""
    changing = sorted({int(signal[INPUT]) for item in inputs for signal in item.signals})
    pieces: list[Array] = []
    signals = np.zeros((len(inputs), len(changing), 4), dtype=np.int64)
    begin = 0
    for c, item in enumerate(inputs):
        own = {int(signal[INPUT]): signal for signal in item.signals}
        for k, place in enumerate(changing):
            rows = np.zeros((1, DEGREE + 2))
            rows[0, 1] = item.base[place]
            if place in own:
                rows = item.pieces[own[place][FIRST] : own[place][LAST] + 1]
            pieces.append(rows)
            signals[c, k] = place, begin, begin + len(rows) - 1, begin
            begin += len(rows)
    return np.concatenate([np.empty((0, DEGREE + 2)), *pieces]), signals
