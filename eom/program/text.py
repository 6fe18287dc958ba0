"""A plan as the text of a Python function."""

import itertools
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from eom.program.call import Lane
from eom.program.plan import Launch, Plan, needs
from eom.program.tape import LEAVES, Op, Tape

SIGNS = {Op.ADD: "({} + {})", Op.SUB: "({} - {})", Op.MUL: "({} * {})", Op.NEG: "(-{})"}
DEEP = 6
"""Nesting of expressions; names are given to what is used more than once or nested deeper."""
INTO = "_TO"
"""Follows the names of operations on rows over lanes that write to a given one."""


class Statement(NamedTuple):
    """What a level needs first: the value of a place, or of a launch (by its number); and the places that it takes."""

    level: int
    place: int | None
    launch: int
    takes: tuple[int, ...]


def launches(plan: Plan) -> list[Launch]:
    """All launches in order."""
    return [launch for stage in plan.launches for launch in stage]


def program_text(plan: Plan) -> str:
    """The text of ``program(p, calls, x, u, level)`` and of the functions over lanes that it calls.

    It takes parameters; rows of each call, see `lane_lines`; states and inputs.
    """
    calls = (lane_lines(k, launch.call.lane) for k, launch in enumerate(launches(plan)))
    return "\n".join((*itertools.chain(*calls), *Program(plan).lines()))


def written(op: int, parts: Sequence[str]) -> str:
    """An operation."""
    return SIGNS[Op(op)].format(*parts) if op in SIGNS else f"{Op(op).name}({', '.join(parts)})"


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
        yield f"    {Op(op).name}{INTO}({', '.join(parts)}, out={names.given(place)})"
    for row, place in enumerate(lane.roots):
        if of(place) != f"r[{row}]":
            yield f"    r[{row}][...] = {of(place)}"


def lane_names(lane: Lane) -> "Names":
    """The rows to which values in lanes are written."""
    inner = [place for place, (op, *_) in enumerate(lane.ops) if op not in LEAVES]
    results = {place: f"r[{row}]" for row, place in reversed(list(enumerate(lane.roots))) if place in inner}
    return Names(((place, lane.ops[place][1:]) for place in inner), "w[{}]", results)


def row_count(lane: Lane) -> int:
    """How many rows the function of a lane needs for what is between arguments and results."""
    names = lane_names(lane)
    for place, (op, *_) in enumerate(lane.ops):
        if op not in LEAVES:
            names.given(place)
    return names.made


class Names:
    """Names of values; one that is not used any more is given to another, so that its memory is used again soon.

    Made of statements: the place of the value, if it is one, and those that it takes. Values may have names of their
    own.
    """

    def __init__(
        self, statements: Iterable[tuple[int | None, Iterable[int]]], form: str, own: Mapping[int, str]
    ) -> None:
        self.form, self.own, self.made = form, own, 0
        self.of: dict[int, str] = {}
        self.free: list[str] = []
        last: dict[int, int] = {}
        self.order: dict[int, int] = {}
        for k, (place, takes) in enumerate(statements):
            last.update(dict.fromkeys(takes, k))
            if place is not None:
                self.order[place] = k
        self.ends: dict[int, list[int]] = {}
        for place, k in last.items():
            if place in self.order and place not in own:
                self.ends.setdefault(k, []).append(place)
        self.done = 0

    def given(self, place: int) -> str:
        """The name of a value whose statement is next; it may be that of a value which the statement takes."""
        for k in range(self.done, self.order[place] + 1):
            self.free += [self.of[old] for old in self.ends.get(k, ())]
        self.done = self.order[place] + 1
        if place in self.own:
            self.of[place] = self.own[place]
        elif self.free:
            self.of[place] = self.free.pop()
        else:
            self.of[place] = self.form.format(self.made)
            self.made += 1
        return self.of[place]


class Program:
    """The text of a plan's function."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.tape = plan, plan.tape
        self.launches = launches(plan)
        self.parameter = {place: k for k, place in reversed(list(enumerate(plan.parameters)))}
        self.result = {pair: (k, lane) for k, item in enumerate(self.launches) for lane, pair in enumerate(item.lanes)}
        self.inlined = inlined(plan)
        self.statements = list(self.all_statements())
        roots = {place: f"r{place}" for group in plan.roots for place in self.taken(group)}
        self.names = Names(((item.place, item.takes) for item in self.statements), "v{}", roots)

    def lines(self) -> Iterator[str]:
        """All lines."""
        yield "def program(p, calls, x, u, level):"
        yield "    x, u = rows(x), rows(u)"
        level = 0
        for item in self.statements:
            indent = "    " * (1 + (item.level > 0))
            if item.level != level and item.level > 0:
                yield f"    if level >= {item.level}:"
            level = item.level
            if item.place is None:
                yield from (indent + line for line in self.called(item.launch))
            else:
                text = self.of(item.place, whole=True)
                yield f"{indent}{self.names.given(item.place)} = {text}"
        yield "    out = []"
        for level, group in enumerate(self.plan.roots):
            yield f"    if level >= {level}:"
            yield f"        out += [{', '.join(map(self.of, group))}]"
        yield "    return whole(out)"

    def all_statements(self) -> Iterator[Statement]:
        """All statements in order."""
        count = 0
        for stage, own in enumerate(self.plan.launches):
            for level in range(len(self.plan.roots)):
                for place in self.plan.stages[stage][level]:
                    if place not in self.inlined:
                        yield Statement(level, place, 0, tuple(self.taken(needs(self.tape, place))))
            for launch in own:
                level = min(self.plan.call_levels[index] for index, _ in launch.lanes)
                rows = [self.row(launch, row) for row in launch.filled]
                yield Statement(level, None, count, tuple(self.taken(place for row in rows for place in row)))
                count += 1

    def row(self, launch: Launch, row: int) -> list[int]:
        """The places of a row of arguments."""
        return [self.tape.calls[index].arguments[row][lane] for index, lane in launch.lanes]

    def taken(self, places: Iterable[int]) -> Iterator[int]:
        """The values with names that places are written with."""
        for place in places:
            if place in self.inlined:
                yield from self.taken(needs(self.tape, place))
            elif self.tape.ops[place][0] not in LEAVES and place not in self.parameter:
                yield place

    def called(self, count: int) -> Iterator[str]:
        """The lines of a launch: its rows over lanes, and the same to take single ones from."""
        launch = self.launches[count]
        yield f"c, a, r{count}, w = calls[{count}]"
        rows = [self.whole_row(place) for place in launch.arguments]
        for k, row in enumerate(launch.filled):
            yield f"fill(a[{k}], [{', '.join(map(self.of, self.row(launch, row)))}])"
            rows[row] = f"a[{k}]"
        yield f"call_{count}(c, [{', '.join(rows)}], r{count}, w)"
        yield f"s{count} = told(r{count})"

    def whole_row(self, place: int) -> str:
        """The row of results of a launch that begins at a place of the scratch memory, nothing if there is none."""
        for k, item in enumerate(self.launches):
            row, rest = divmod(place - item.results, item.stride)
            if rest == 0 and 0 <= row < item.call.rows:
                return f"r{k}[{row}]"
        return ""

    def of(self, place: int, *, whole: bool = False) -> str:
        """The text of a place: its name, or what is behind it."""
        op, *args = self.tape.ops[place]
        if op == Op.CONST:
            return number(self.tape.constants[args[0]])
        if place in self.parameter:
            return f"p[{self.parameter[place]}]"
        if op in {Op.STATE, Op.INPUT}:
            return f"{'x' if op == Op.STATE else 'u'}[{args[0]}]"
        if op == Op.LANE:
            launch, lane = self.result[args[0], args[2]]
            return f"s{launch}[{args[1]}][{lane}]"
        if not whole and place not in self.inlined:
            return self.names.of[place]
        return written(op, [self.of(arg) for arg in args])


def inlined(plan: Plan) -> set[int]:
    """Places that are written where they are used: once, and soon."""
    tape: Tape = plan.tape
    where = {place: (s, k) for s, groups in enumerate(plan.stages) for k, group in enumerate(groups) for place in group}
    uses = Counter(arg for place in where for arg in tape.ops[place][1:] if tape.ops[place][0] not in LEAVES)
    kept = {place for group in plan.roots for place in group}
    kept |= {place for call in tape.calls for row in call.arguments for place in row}
    user = {arg: place for place in where for arg in needs(tape, place)}
    found: set[int] = set()
    depth: dict[int, int] = {}
    for place in sorted(where):
        args = needs(tape, place)
        depth[place] = 1 + max((depth.get(arg, 0) for arg in args if arg in found), default=0)
        once = uses[place] == 1 and place not in kept and where.get(user[place]) == where[place]
        if once and depth[place] < DEEP:
            found.add(place)
    return found
