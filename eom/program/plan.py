"""A plan of what to compute when: parameters beforehand, then stages of scalar operations and calls over lanes."""

import itertools
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.program.arrays import as_nodes
from eom.program.launch import Launch, Layout, launched, together
from eom.program.numbers import Numbers, lifted
from eom.program.operations import LEAVES, VALUES, Op
from eom.program.tape import Tape


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
    """

    tape: Tape
    roots: tuple[tuple[int, ...], ...]
    stages: tuple[tuple[tuple[int, ...], ...], ...]
    launches: tuple[tuple[Launch, ...], ...]
    slots: dict[int, int]
    scratch: int
    parameters: tuple[int, ...]

    @property
    def ends(self) -> tuple[int, ...]:
        """How many results there are of the levels up to each."""
        return tuple(itertools.accumulate(map(len, self.roots)))

    def parameter_values(self, numbers: Numbers) -> Array:
        """Values of the parameters, (parameters, cases); ``ValueError`` if cases take other branches."""
        tape, cases = self.tape, numbers.values.shape[1]
        for k in tape.asked:
            if np.any(np.sign(numbers.values[k]) != np.sign(tape.samples[k])):
                raise ValueError("cases differ in structure: a lag or a speed vanishes in some of them")
        values: dict[int, Any] = {}
        for place in sorted(self.beforehand()):
            op, *args = tape.ops[place]
            if op == Op.CONST:
                values[place] = np.full(cases, tape.constants[args[0]])
            elif op == Op.PARAMETER:
                values[place] = numbers.values[args[0]]
            else:
                with np.errstate(all="ignore"):
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
    # a branch that is not taken may hold what is no number
    with np.errstate(all="ignore"):
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
        # all lanes run, also those of which nothing is wanted
        return tuple(place for row in (*call.coefficients, *call.arguments) for place in row)
    return () if op in LEAVES else tuple(args)


def planned(tape: Tape, roots: tuple[tuple[int, ...], ...]) -> Plan:
    """The plan of a tape."""
    level = first_levels(tape, roots)
    times = staged(tape, sorted(level))
    count = 1 + max(times.stage.values(), default=0)
    parameters, late = needed(tape, roots, times, count)
    call_levels = first_call_levels(tape, level, len(roots))
    layout = Layout(list(parameters), 0)
    launches: list[tuple[Launch, ...]] = []
    for s in range(count):
        own: list[Launch] = []
        for own_level, lanes in together(
            tape, [index for index, at in times.calls.items() if at == s + 1], call_levels
        ):
            own.append(launched(tape, lanes, own_level, layout, [*itertools.chain(*launches), *own]))
        launches.append(tuple(own))
    return Plan(
        tape=tape,
        roots=roots,
        stages=tuple(computed(tape, s, level, times, len(roots)) for s in range(count)),
        launches=tuple(launches),
        slots={place: layout.scratch + k for k, place in enumerate(late)},
        scratch=layout.scratch + len(late),
        parameters=tuple(layout.parameters),
    )


def first_levels(tape: Tape, roots: tuple[tuple[int, ...], ...]) -> dict[int, int]:
    """The first level that needs each place."""
    level: dict[int, int] = {}
    for k, group in enumerate(roots):
        for place in reached(tape, group):
            level.setdefault(place, k)
    return level


def first_call_levels(tape: Tape, level: dict[int, int], levels: int) -> dict[int, int]:
    """The first level that needs each call."""
    found: dict[int, int] = {}
    for place, own in level.items():
        if tape.ops[place][0] == Op.LANE:
            index = tape.ops[place][1]
            found[index] = min(own, found.get(index, levels))
    return found


class Times(NamedTuple):
    """When places can be computed: those that vary in a run, after how many rounds of calls, and each call's round."""

    stage: dict[int, int]
    calls: dict[int, int]


def staged(tape: Tape, order: Sequence[int]) -> Times:
    """When the places in *order* can be computed."""
    stage: dict[int, int] = {}
    calls: dict[int, int] = {}
    for place in order:
        op, *args = tape.ops[place]
        if op == Op.LANE:
            if args[0] not in calls:
                calls[args[0]] = 1 + max(stage.get(item, 0) for row in tape.calls[args[0]].arguments for item in row)
            stage[place] = calls[args[0]]
        elif op in {Op.STATE, Op.INPUT}:
            stage[place] = 0
        else:
            varying = [stage[arg] for arg in needs(tape, place) if arg in stage]
            if varying:
                stage[place] = max(varying)
    return Times(stage, calls)


def needed(
    tape: Tape, roots: tuple[tuple[int, ...], ...], times: Times, count: int
) -> tuple[dict[int, None], dict[int, None]]:
    """Places that are to be computed beforehand, and those that a later stage than their own needs."""
    uses = [(arg, at) for place, at in times.stage.items() for arg in operands(tape, place)]
    for index, at in times.calls.items():
        uses += [(place, at - 1) for row in tape.calls[index].arguments for place in row]
    uses += [(place, count - 1) for group in roots for place in group]
    early = {place: None for place, _ in uses if place not in times.stage and tape.ops[place][0] != Op.CONST}
    late = {
        place: None
        for place, at in uses
        if place in times.stage and tape.ops[place][0] not in LEAVES and times.stage[place] != at
    }
    return early, late


def operands(tape: Tape, place: int) -> tuple[int, ...]:
    """What an operation on scalars takes; nothing for what is no operation."""
    return () if tape.ops[place][0] in LEAVES else tape.ops[place][1:]


def computed(tape: Tape, stage: int, level: dict[int, int], times: Times, levels: int) -> tuple[tuple[int, ...], ...]:
    """The operations of a stage, a group for each level that needs them first."""
    own = [place for place in sorted(times.stage) if times.stage[place] == stage and tape.ops[place][0] not in LEAVES]
    return tuple(tuple(place for place in own if level[place] == k) for k in range(levels))
