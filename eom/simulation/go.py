"""What the loops of a run are asked for."""

from typing import Any

from eom.simulation.accepted import look
from eom.simulation.advance import advance
from eom.simulation.memory import DONE, TIME


def go(
    looking: bool,
    program: Any,
    until: float,
    pause: float,
    closed: bool,
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
    jacobian: Any,
    factors: Any,
    pivots: Any,
) -> int:
    """Go on as `advance` does, or, just *looking*, set inputs and outputs to those at the instant."""
    if looking:
        look(program, clock[TIME], at, v, work, pieces, signals)
        return DONE
    return advance(
        program,
        until,
        pause,
        closed,
        settings,
        clock,
        counts,
        margins,
        times,
        columns,
        rows,
        events,
        terminal,
        at,
        v,
        work,
        pieces,
        signals,
        stops,
        jacobian,
        factors,
        pivots,
    )
