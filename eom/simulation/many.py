"""Many runs from one instant to another, one after the other, in a loop for a compiler; cases are the first axis."""

from typing import Any

from eom.simulation.accepted import look
from eom.simulation.advance import advance
from eom.simulation.memory import DONE, INPUTS, LIMITS, OUTPUTS, RESULTS, STATES, TIME, U, X


def advance_many(
    program: Any,
    cases: Any,
    until: Any,
    pause: float,
    closed: Any,
    settings: Any,
    clock: Any,
    counts: Any,
    margins: Any,
    times: Any,
    columns: Any,
    rows: Any,
    events: Any,
    terminal: Any,
    at: Any,
    v: Any,
    work: Any,
    pieces: Any,
    signals: Any,
    stops: Any,
    stops_first: Any,
    implicit: Any,
    pivots: Any,
    status: Any,
) -> None:
    """Go on with those of some *cases* that have not ended, to instants [s] or a pause.

    Everything else is as of `eom.simulation.advance.advance`.
    """
    for k in range(len(cases)):
        c = cases[k]
        if status[c] == DONE and clock[c, TIME] < until[c]:
            status[c] = advance(
                program,
                until[c],
                pause,
                closed[c],
                settings,
                clock[c],
                counts[c],
                margins[c],
                times,
                columns,
                rows[c],
                events[c],
                terminal,
                at,
                v[c],
                work[c],
                pieces,
                signals[c],
                stops[stops_first[c] : stops_first[c + 1]],
                implicit[c, 0],
                implicit[c, 1],
                pivots[c],
            )


def observe_many(
    program: Any, cases: Any, clock: Any, at: Any, v: Any, work: Any, pieces: Any, signals: Any, seen: Any
) -> None:
    """Fill *seen*, (signals, cases), with outputs, inputs and states at the instant of each case."""
    outputs, inputs, n = at[OUTPUTS], at[INPUTS], at[STATES]
    for k in range(len(cases)):
        c = cases[k]
        look(program, clock[c, TIME], at, v[c], work[c], pieces, signals[c])
        for i in range(outputs):
            seen[i, c] = work[c, at[RESULTS] + n + at[LIMITS] + i]
        for i in range(inputs):
            seen[outputs + i, c] = work[c, at[U] + i]
        for i in range(n):
            seen[outputs + inputs + i, c] = v[c, X, i]
