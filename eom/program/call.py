"""Functions over lanes: what varies in a run is written down once for all lanes, the rest is done beforehand."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from eom.program.operations import Op
from eom.program.tape import Node, Tape


class Lane(NamedTuple):
    """What is done in one lane: operations and constants as of a `Tape`, and the places of the results.

    Coefficients, which do not vary in a run, are parameters; arguments are inputs.
    """

    ops: tuple[tuple[int, ...], ...]
    constants: tuple[float, ...]
    roots: tuple[int, ...]


class Call(NamedTuple):
    """A function over lanes: coefficients and arguments as rows of places on the tape that calls it."""

    lane: Lane
    coefficients: tuple[tuple[int, ...], ...]
    arguments: tuple[tuple[int, ...], ...]

    @property
    def rows(self) -> int:
        """How many results it gives."""
        return len(self.lane.roots)


def called(
    tape: Tape, function: Callable[[Sequence[Node]], Sequence[Node]], given: Sequence[tuple[int, ...]]
) -> list[list[Node]]:
    """The results of a function of nodes over lanes, rows of nodes; *given* are rows of places."""
    return Calling(tape, given).results(function)


class Calling:
    """A function over lanes that is being written down on a tape of its own."""

    def __init__(self, tape: Tape, given: Sequence[tuple[int, ...]]) -> None:
        # a coefficient may be in some lanes what it is not in others
        self.tape, self.given, self.own = tape, given, Tape(vanishing=set(range(len(given))))
        self.ops: list[tuple[int, ...]] = []
        self.constants: list[float] = []
        self.coefficients: list[tuple[int, ...]] = []
        self.arguments: list[tuple[int, ...]] = []
        self.moved: dict[int, int] = {}
        self.known: dict[int, list[Node]] = {}

    def results(self, function: Callable[[Sequence[Node]], Sequence[Node]]) -> list[list[Node]]:
        """The rows of what it gives."""
        found = function([self.one(k) for k in range(len(self.given))])
        varying = [node for node in found if self.own.varying[node.place]]
        rows = iter(self.lanes(varying) if varying else ())
        return [next(rows) if self.own.varying[node.place] else self.beforehand(node.place) for node in found]

    def one(self, k: int) -> Node:
        """The node that stands for a given row: a constant, a coefficient or an argument."""
        row = self.given[k]
        value = Node(self.tape, row[0]).value
        if value is not None and all(place == row[0] for place in row):
            return self.own.constant(value)
        return self.own.node(Op.INPUT if any(self.tape.varying[place] for place in row) else Op.PARAMETER, k)

    def lanes(self, varying: Sequence[Node]) -> list[list[Node]]:
        """What varies, as results of a call; the same call before is the same one."""
        roots = tuple(self.at(node.place) for node in varying)
        call = Call(
            Lane(tuple(self.ops), tuple(self.constants), roots), tuple(self.coefficients), tuple(self.arguments)
        )
        if call not in self.tape.calls:
            self.tape.calls.append(call)
        index, count = self.tape.calls.index(call), len(self.given[0])
        return [[self.tape.node(Op.LANE, index, row, lane) for lane in range(count)] for row in range(call.rows)]

    def at(self, place: int) -> int:
        """Where an operation stands among those of a lane, which it and what it needs are added to."""
        if place not in self.moved:
            key = self.key(place)
            self.moved[place] = len(self.ops)
            self.ops.append(key)
        return self.moved[place]

    def key(self, place: int) -> tuple[int, ...]:
        """An operation among those of a lane; what does not vary is a constant or a coefficient."""
        op, *args = self.own.ops[place]
        if op == Op.CONST:
            self.constants.append(self.own.constants[args[0]])
            return op, len(self.constants) - 1
        if not self.own.varying[place]:
            self.coefficients.append(tuple(node.place for node in self.beforehand(place)))
            return int(Op.PARAMETER), len(self.coefficients) - 1
        if op == Op.INPUT:
            self.arguments.append(self.given[args[0]])
            return op, len(self.arguments) - 1
        return op, *map(self.at, args)

    def beforehand(self, place: int) -> list[Node]:
        """What does not vary, a node of the calling tape for each lane."""
        if place not in self.known:
            op, *args = self.own.ops[place]
            if op == Op.CONST:
                self.known[place] = [self.tape.constant(self.own.constants[args[0]])] * len(self.given[0])
            elif op == Op.PARAMETER:
                self.known[place] = [Node(self.tape, item) for item in self.given[args[0]]]
            else:
                operands = zip(*map(self.beforehand, args), strict=True)
                self.known[place] = [first.apply(Op(op), *others) for first, *others in operands]
        return self.known[place]
