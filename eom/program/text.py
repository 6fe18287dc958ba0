"""A plan as the text of a Python function, of numbers or of arrays over cases."""

import itertools
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from eom.program.lane_text import INTO, lane_lines, number
from eom.program.launch import Launch
from eom.program.names import Names
from eom.program.operations import LEAVES, Op
from eom.program.plan import Plan, needs
from eom.program.tape import Tape

SIGNS = {Op.ADD: "({} + {})", Op.SUB: "({} - {})", Op.MUL: "({} * {})", Op.NEG: "(-{})"}
DEEP = 6
"""Nesting of expressions; names are given to what is used more than once or nested deeper."""


class Statement(NamedTuple):
    """What a level needs first: the value of a place, or of a launch (by its number); and the places that it takes."""

    level: int
    place: int | None
    launch: int
    takes: tuple[int, ...]


def launches(plan: Plan) -> list[Launch]:
    """All launches in order."""
    return [launch for stage in plan.launches for launch in stage]


class Text(ABC):
    """The text of ``program(p, calls, w, x, u, level)`` and of the functions over lanes that it calls.

    It takes parameters; rows of each call, see `lane_lines`; rows for what is between; states and inputs. This is what
    numbers and arrays have in common.
    """

    inlined: frozenset[int] = frozenset()
    """Places that are written where they are used."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.tape = plan, plan.tape
        self.launches = launches(plan)
        self.parameter = {place: k for k, place in reversed(list(enumerate(plan.parameters)))}
        self.result = {pair: (k, lane) for k, item in enumerate(self.launches) for lane, pair in enumerate(item.lanes)}
        self.roots = list(itertools.chain(*plan.roots))
        self.statements = list(self.all_statements())
        # results are taken at the end
        order = [*((item.place, item.takes) for item in self.statements), (None, tuple(self.taken(self.roots)))]
        self.names = Names(order, "v{}", self.own_names())

    def own_names(self) -> dict[int, str]:
        """Names of values that are not as others."""
        return {}

    @abstractmethod
    def assigned(self, place: int) -> str:
        """The statement that computes a value."""

    @abstractmethod
    def beginning(self) -> Iterator[str]:
        """What comes before all statements, asked for when these are written."""

    @abstractmethod
    def end(self) -> Iterator[str]:
        """What comes after all statements."""

    def whole(self) -> str:
        """All of it."""
        calls = (lane_lines(k, launch.call.lane) for k, launch in enumerate(self.launches))
        body = list(self.body())
        return "\n".join((*itertools.chain(*calls), "def program(p, calls, w, x, u, level):", *self.beginning(), *body))

    def body(self) -> Iterator[str]:
        """The statements and what comes after them."""
        level = 0
        for item in self.statements:
            indent = "    " * (1 + (item.level > 0))
            if item.level != level and item.level > 0:
                yield f"    if level >= {item.level}:"
            level = item.level
            if item.place is None:
                yield from (indent + line for line in self.called(item.launch))
            else:
                yield indent + self.assigned(item.place)
        yield from self.end()

    def all_statements(self) -> Iterator[Statement]:
        """All statements in order."""
        count = 0
        for stage, own in enumerate(self.plan.launches):
            for level in range(len(self.plan.roots)):
                for place in self.plan.stages[stage][level]:
                    if place not in self.inlined:
                        yield Statement(level, place, 0, tuple(self.taken(needs(self.tape, place))))
            for launch in own:
                rows = [self.row(launch, row) for row in launch.filled]
                yield Statement(launch.level, None, count, tuple(self.taken(place for row in rows for place in row)))
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
        yield f"c, a, r{count}, rows = calls[{count}]"
        rows = [self.whole_row(place) for place in launch.arguments]
        for k, row in enumerate(launch.filled):
            yield f"fill(a[{k}], [{', '.join(map(self.of, self.row(launch, row)))}])"
            rows[row] = f"a[{k}]"
        yield f"call_{count}(c, [{', '.join(rows)}], r{count}, rows)"
        yield f"s{count} = told(r{count})"

    def whole_row(self, place: int) -> str:
        """The row of results of a launch that begins at a place of the scratch memory, nothing if there is none."""
        for k, item in enumerate(self.launches):
            row, rest = divmod(place - item.results, item.stride)
            if rest == 0 and 0 <= row < item.call.rows:
                return f"r{k}[{row}]"
        return ""

    def of(self, place: int) -> str:
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
        if place not in self.inlined:
            return self.names.of[place]
        return self.written(place)

    def written(self, place: int) -> str:
        """An operation."""
        op, *args = self.tape.ops[place]
        parts = [self.of(arg) for arg in args]
        return SIGNS[Op(op)].format(*parts) if op in SIGNS else f"{Op(op).name}({', '.join(parts)})"


class NumbersText(Text):
    """For numbers: nested expressions; the result is a list."""

    def __init__(self, plan: Plan) -> None:
        self.inlined = inlined(plan)
        super().__init__(plan)

    def assigned(self, place: int) -> str:
        """The statement that computes a value."""
        text = self.written(place)
        return f"{self.names.given(place)} = {text}"

    def beginning(self) -> Iterator[str]:
        """Nothing."""
        return iter(())

    def end(self) -> Iterator[str]:
        """The results are listed."""
        yield "    out = []"
        for level, group in enumerate(self.plan.roots):
            yield f"    if level >= {level}:"
            yield f"        out += [{', '.join(map(self.of, group))}]"
        yield "    return out"


class ArraysText(Text):
    """For arrays over cases: every operation writes to a row of memory; the result is a new array."""

    def own_names(self) -> dict[int, str]:
        """Rows of the result, of values that the level of theirs needs first."""
        levels = {item.place: item.level for item in self.statements}
        rows = [(level, place) for level, group in enumerate(self.plan.roots) for place in group]
        return {place: f"out[{k}]" for k, (level, place) in enumerate(rows) if levels.get(place) == level}

    def assigned(self, place: int) -> str:
        """The statement that computes a value."""
        op, *args = self.tape.ops[place]
        parts = [self.of(arg) for arg in args]
        return f"{Op(op).name}{INTO}({', '.join((*parts, self.names.given(place)))})"

    def beginning(self) -> Iterator[str]:
        """Arrays are taken apart."""
        yield "    x, u, whole = list(x), list(u), empty(level)"
        yield "    out = list(whole)"
        if self.names.made:
            yield f"    {', '.join(f'v{k}' for k in range(self.names.made))}, = w"

    def end(self) -> Iterator[str]:
        """Results are filled in that are not in their place already."""
        first = 0
        for level, group in enumerate(self.plan.roots):
            yield f"    if level >= {level}:"
            yield "        pass"
            for k, place in enumerate(group, first):
                if self.of(place) != f"out[{k}]":
                    yield f"        out[{k}][...] = {self.of(place)}"
            first += len(group)
        yield "    return whole"


def inlined(plan: Plan) -> frozenset[int]:
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
    return frozenset(found)
