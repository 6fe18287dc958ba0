"""Calls over lanes laid out in memory: those of the same function together, in rows of whole vector registers."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from eom.program.call import Call, Lane
from eom.program.operations import Op
from eom.program.tape import Tape

LANE_BLOCK = 4
"""Lanes are filled up to a multiple of this, a vector register."""


class Launch(NamedTuple):
    """Calls of one function over all their lanes at once.

    ``level`` is the first one that needs them, ``lanes`` are (call, lane) pairs. Rows of ``arguments`` stand at places
    of the scratch memory, and those in ``filled`` have to be filled in before; the others are there already. Results
    begin at this place of the scratch memory, coefficients at this one of the parameters; their rows are ``stride``
    apart.
    """

    call: Call
    level: int
    lanes: tuple[tuple[int, int], ...]
    stride: int
    arguments: tuple[int, ...]
    filled: tuple[int, ...]
    results: int
    coefficients: int


@dataclass
class Layout:
    """Parameters so far, as places of the tape, and the size of the scratch memory so far."""

    parameters: list[int]
    scratch: int

    def room(self, size: int) -> int:
        """Where room in the scratch memory begins."""
        begin, self.scratch = self.scratch, self.scratch + size
        return begin


def launched(
    tape: Tape, lanes: Sequence[tuple[int, int]], level: int, layout: Layout, done: Sequence[Launch]
) -> Launch:
    """The launch of some lanes that a level needs first, after those that are *done*."""
    call = tape.calls[lanes[0][0]]
    stride = -(-len(lanes) // LANE_BLOCK) * LANE_BLOCK
    filling = [*lanes, *[lanes[-1]] * (stride - len(lanes))]
    coefficients = len(layout.parameters)
    for row in range(len(call.coefficients)):
        layout.parameters.extend(tape.calls[index].coefficients[row][lane] for index, lane in filling)
    arguments: list[int] = []
    filled: list[int] = []
    for row in range(len(call.arguments)):
        places = [tape.calls[index].arguments[row][lane] for index, lane in lanes]
        there = result_row(tape, places, stride, done)
        if there is None:
            filled.append(row)
        arguments.append(layout.room(stride) if there is None else there)
    results = layout.room(stride * call.rows)
    return Launch(call, level, tuple(lanes), stride, tuple(arguments), tuple(filled), results, coefficients)


def result_row(tape: Tape, places: Sequence[int], stride: int, done: Sequence[Launch]) -> int | None:
    """Where a row of results stands that is just the one wanted, None if there is none."""
    ops = [tape.ops[place] for place in places]
    if any(op[0] != Op.LANE or op[2] != ops[0][2] for op in ops):
        return None
    wanted = tuple((op[1], op[3]) for op in ops)
    for item in done:
        if item.lanes == wanted and item.stride == stride:
            return item.results + stride * ops[0][2]
    return None


def together(tape: Tape, calls: Sequence[int], levels: Mapping[int, int]) -> list[tuple[int, list[tuple[int, int]]]]:
    """The lanes of calls, those of the same function and level together, with that level."""
    found: dict[tuple[Lane, int], list[tuple[int, int]]] = {}
    for index in calls:
        call = tape.calls[index]
        lanes = [(index, lane) for lane in range(len(call.arguments[0]))]
        found.setdefault((call.lane, levels[index]), []).extend(lanes)
    return [(level, lanes) for (_, level), lanes in found.items()]
