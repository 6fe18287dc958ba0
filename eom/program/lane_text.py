"""Functions over lanes as text: every operation writes to a row of memory."""

from collections.abc import Iterator
from functools import cache

from eom.program.call import Lane
from eom.program.names import Names
from eom.program.operations import LEAVES, Op

INTO = "_TO"
"""Follows the names of operations on arrays that write to the last one given."""


def number(value: float) -> str:
    """A constant."""
    return f"({value!r})".replace("inf", "INFINITE")


def lane_lines(number_: int, lane: Lane) -> Iterator[str]:
    """The function of a call over lanes: of rows of coefficients c and arguments a; results are written to rows r.

    What is between is written to rows w, of which it needs as many as `row_count` says.
    """
    yield f"def call_{number_}(c, a, r, w):"
    inner = [place for place, (op, *_) in enumerate(lane.ops) if op not in LEAVES]
    names = lane_names(lane)

    def of(place: int) -> str:
        op, *args = lane.ops[place]
        if op == Op.CONST:
            return number(lane.constants[args[0]])
        return f"{'c' if op == Op.PARAMETER else 'a'}[{args[0]}]" if op in LEAVES else names.of[place]

    for place in inner:
        op, *args = lane.ops[place]
        parts = [of(arg) for arg in args]
        yield f"    {Op(op).name}{INTO}({', '.join((*parts, names.given(place)))})"
    for row, place in enumerate(lane.roots):
        if of(place) != f"r[{row}]":
            yield f"    r[{row}][...] = {of(place)}"


def lane_names(lane: Lane) -> Names:
    """The rows to which values in lanes are written."""
    inner = [place for place, (op, *_) in enumerate(lane.ops) if op not in LEAVES]
    results = {place: f"r[{row}]" for row, place in reversed(list(enumerate(lane.roots))) if place in inner}
    return Names(((place, lane.ops[place][1:]) for place in inner), "w[{}]", results)


@cache
def row_count(lane: Lane) -> int:
    """How many rows the function of a lane needs for what is between arguments and results."""
    names = lane_names(lane)
    for place, (op, *_) in enumerate(lane.ops):
        if op not in LEAVES:
            names.given(place)
    return names.made
