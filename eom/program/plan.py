"""A plan of what to compute when: parameters beforehand, then stages of scalar operations and calls over lanes."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.program.arrays import as_nodes
from eom.program.numbers import Numbers, lifted
from eom.program.tape import LEAVES, VALUES, Call, Op, Tape

LANE_BLOCK = 8
"""Lanes are filled up to a multiple of this: two vector registers of four, which hide each other's latency."""


class Launch(NamedTuple):
    """Calls of one function over all their lanes at once.

    ``lanes`` are (call, lane) pairs. Rows of ``arguments`` stand at places of the scratch memory or of the parameters,
    and those in ``filled`` have to be filled in before; the others are there already. Results begin at this place of
    the scratch memory, coefficients at this one of the parameters; their rows are ``stride`` apart.
    """

    call: Call
    lanes: tuple[tuple[int, int], ...]
    stride: int
    arguments: tuple[tuple[str, int], ...]
    filled: tuple[int, ...]
    results: int
    coefficients: int


class Plan(NamedTuple):
    """A program; levels are groups of results, of which a caller may want the first ones only.

    Attributes
    ----------
    tape : Tape
    roots : tuple of tuple of int
        Places of the results, a group a level.
    stages : tuple
        Per stage: the places to compute, per level, and the launches that follow it.
    launches : tuple of Launch
    slots : dict
        Places that later stages need, by their place in the scratch memory.
    scratch : int
        Size of that memory.
    parameters : tuple of int
        Places of what is computed beforehand, in the order of the parameters.
    call_levels : dict
        The first level that needs each call.
    """

    tape: Tape
    roots: tuple[tuple[int, ...], ...]
    stages: tuple[tuple[tuple[int, ...], ...], ...]
    launches: tuple[tuple[Launch, ...], ...]
    slots: dict[int, int]
    scratch: int
    parameters: tuple[int, ...]
    call_levels: dict[int, int]

    def parameter_values(self, numbers: Numbers) -> Array:
        """Values of the parameters, (parameters, cases)."""
        tape, cases = self.tape, numbers.values.shape[1]
        values: dict[int, Any] = {}
        for place in sorted(self.beforehand()):
            op, *args = tape.ops[place]
            if op == Op.CONST:
                values[place] = np.full(cases, tape.constants[args[0]])
            elif op == Op.PARAMETER:
                values[place] = numbers.values[args[0]]
            else:
                values[place] = VALUES[Op(op)](*(values[arg] for arg in args))
        return np.array([values[place] for place in self.parameters]).reshape(-1, cases)

    def beforehand(self) -> set[int]:
        """Places of the parameters and of all that they are made of."""
        return reached(self.tape, self.parameters)


def traced(
    equations: Callable[[Any, Any, Any], Sequence[Any]], numbers: Numbers, states: int, inputs: int
) -> tuple[Tape, tuple[tuple[int, ...], ...]]:
    """The tape of ``equations(x, u, numbers)``, which give groups of results, and the places of these."""
    tape = Tape()
    x, u = (
        as_nodes(np.array([tape.node(op, k) for k in range(count)], dtype=object))
        for op, count in ((Op.STATE, states), (Op.INPUT, inputs))
    )
    groups = equations(x, u, lifted(numbers, tape))

    def places(group: Any) -> tuple[int, ...]:
        return tuple((item if hasattr(item, "place") else tape.constant(float(item))).place for item in np.ravel(group))

    return tape, tuple(places(np.asarray(group, dtype=object)) for group in groups)


def reached(tape: Tape, roots: Sequence[int]) -> set[int]:
    """All places that some are made of."""
    found: set[int] = set()
    left = list(roots)
    while left:
        place = left.pop()
        if place not in found:
            found.add(place)
            left.extend(needs(tape, place))
    return found


def needs(tape: Tape, place: int) -> tuple[int, ...]:
    """What an operation is made of."""
    op, *args = tape.ops[place]
    if op == Op.LANE:
        call = tape.calls[args[0]]
        rows = (*call.coefficients, *call.arguments)
        return tuple(row[args[2]] for row in rows)
    return () if op in LEAVES else tuple(args)


def planned(tape: Tape, roots: tuple[tuple[int, ...], ...]) -> Plan:
    """The plan of a tape."""
    level: dict[int, int] = {}
    for k, group in enumerate(roots):
        for place in reached(tape, group):
            level.setdefault(place, k)
    order = sorted(level)
    varying, stage, call_stage = staged(tape, order)
    early: dict[int, None] = {}
    late: dict[int, int] = {}

    def used(place: int, at: int) -> None:
        """Note that a place is needed in a stage."""
        if place not in varying:
            if tape.ops[place][0] != Op.CONST:
                early.setdefault(place)
        elif tape.ops[place][0] not in LEAVES and stage[place] != at:
            late.setdefault(place, len(late))

    count = 1 + max((stage[place] for place in varying), default=0)
    for place in order:
        if place in varying and tape.ops[place][0] not in LEAVES:
            for arg in needs(tape, place):
                used(arg, stage[place])
    for index, at in call_stage.items():
        for row in tape.calls[index].arguments:
            for place in row:
                if place in varying:
                    used(place, at - 1)
    for group in roots:
        for place in group:
            used(place, count - 1)
    stages = tuple(
        tuple(
            tuple(
                place
                for place in order
                if place in varying and tape.ops[place][0] not in LEAVES and (stage[place], level[place]) == (s, k)
            )
            for k in range(len(roots))
        )
        for s in range(count)
    )
    parameters, memory, launches = list(early), 0, []
    for s in range(count):
        own = []
        for lanes in launched(tape, [index for index, at in call_stage.items() if at == s + 1]):
            call = tape.calls[lanes[0][0]]
            stride = -(-len(lanes) // LANE_BLOCK) * LANE_BLOCK
            filling = [*lanes, *[lanes[-1]] * (stride - len(lanes))]
            begin = len(parameters)
            for row in range(len(call.coefficients)):
                parameters.extend(tape.calls[index].coefficients[row][lane] for index, lane in filling)
            arguments, filled = [], []
            for row in range(len(call.arguments)):
                places = [tape.calls[index].arguments[row][lane] for index, lane in filling]
                there = result_row(
                    tape, places[: len(lanes)], stride, [item for done in (*launches, own) for item in done]
                )
                if there is not None:
                    arguments.append(("scratch", there))
                elif not varying.intersection(places):
                    arguments.append(("parameters", len(parameters)))
                    parameters.extend(places)
                else:
                    arguments.append(("scratch", memory))
                    filled.append(row)
                    memory += stride
            own.append(Launch(call, tuple(lanes), stride, tuple(arguments), tuple(filled), memory, begin))
            memory += stride * call.rows
        launches.append(tuple(own))
    call_levels: dict[int, int] = {}
    for place in order:
        if tape.ops[place][0] == Op.LANE:
            index = tape.ops[place][1]
            call_levels[index] = min(level[place], call_levels.get(index, len(roots)))
    slots = {place: memory + k for place, k in late.items()}
    return Plan(tape, roots, stages, tuple(launches), slots, memory + len(slots), tuple(parameters), call_levels)


def staged(tape: Tape, order: Sequence[int]) -> tuple[set[int], dict[int, int], dict[int, int]]:
    """Which places vary in a run, after how many rounds of calls each can be computed, and each call's round."""
    varying: set[int] = set()
    stage: dict[int, int] = {}
    calls: dict[int, int] = {}
    for place in order:
        op, *args = tape.ops[place]
        if op == Op.LANE:
            if args[0] not in calls:
                calls[args[0]] = 1 + max(stage.get(item, 0) for row in tape.calls[args[0]].arguments for item in row)
            stage[place] = calls[args[0]]
            varying.add(place)
        elif op in {Op.STATE, Op.INPUT} or any(arg in varying for arg in needs(tape, place)):
            varying.add(place)
            stage[place] = max((stage.get(arg, 0) for arg in needs(tape, place)), default=0)
    return varying, stage, calls


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


def launched(tape: Tape, calls: Sequence[int]) -> list[list[tuple[int, int]]]:
    """The lanes of calls, those of the same function together."""
    found: dict[Any, list[tuple[int, int]]] = {}
    for index in calls:
        call = tape.calls[index]
        lanes = [(index, lane) for lane in range(len(call.arguments[0]))]
        found.setdefault((call.function, call.names, call.rows), []).extend(lanes)
    return list(found.values())
