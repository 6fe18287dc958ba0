"""Blocks connected with a model and each other: checked, in the order in which they are evaluated."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from eom.errors import SimulationError
from eom.simulation.blocks import Block, is_direct, port_names
from eom.simulation.wiring_checks import block_mistakes, producers, resolved_units, signal_mistakes, wire_mistakes

Indices = NDArray[np.intp]


class Named(Protocol):
    """What has inputs, outputs and states with names and units, as all models do."""

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of inputs."""

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of outputs."""

    @property
    def states(self) -> tuple[str, ...]:
        """Names of states."""

    @property
    def input_units(self) -> tuple[str, ...]:
        """Units of inputs."""

    @property
    def output_units(self) -> tuple[str, ...]:
        """Units of outputs."""

    @property
    def state_units(self) -> tuple[str, ...]:
        """Units of states."""


class Wiring(NamedTuple):
    """Blocks and their connections; ports are numbered as the blocks were given.

    Attributes
    ----------
    blocks : tuple of Block
        In the order of evaluation: each after those that it needs at the same instant.
    direct : tuple of bool
        Whether what a block's sample gives acts at that sample.
    reads : tuple of Indices
        What each block reads: indices into the model's signals followed by the ports.
    ports : tuple of slice
        The ports of each block.
    signals, units : tuple of str
        Names ``BLOCK.PORT`` of all ports, and their units.
    inputs, sources : Indices
        Indices of the model's inputs that blocks drive, and of the ports that drive them.
    """

    blocks: tuple[Block, ...]
    direct: tuple[bool, ...]
    reads: tuple[Indices, ...]
    ports: tuple[slice, ...]
    signals: tuple[str, ...]
    units: tuple[str, ...]
    inputs: Indices
    sources: Indices


def model_signals(model: Named) -> dict[str, str]:
    """What blocks may read of a model, with units: outputs, inputs, and states as ``state:NAME``, in this order."""
    states = (f"state:{name}" for name in model.states)
    found = dict(zip(model.outputs, model.output_units, strict=True))
    found |= zip(model.inputs, model.input_units, strict=True)
    return found | dict(zip(states, model.state_units, strict=True))


def model_inputs(model: Named) -> dict[str, str]:
    """The inputs of a model with their units."""
    return dict(zip(model.inputs, model.input_units, strict=True))


def wired(
    blocks: Sequence[Block], wires: Mapping[str, str], signals: Mapping[str, str], inputs: Mapping[str, str]
) -> Wiring:
    """Connect blocks with a model.

    Parameters
    ----------
    blocks : sequence of Block
        In any order.
    wires : Mapping
        Input of the model to the port ``BLOCK.PORT`` that drives it.
    signals, inputs : Mapping
        The model's signals and inputs with their units, as `model_signals` and `model_inputs` give them; empty units
        are not compared.

    Raises
    ------
    SimulationError
        With a sentence for every mistake: objects that are no blocks, names that are taken, periods that are not
        positive, unknown signals, inputs and ports, units that differ, direct blocks that wait for each other.
    """
    mistakes = block_mistakes(blocks)
    mistakes = mistakes or [*signal_mistakes(blocks, signals), *wire_mistakes(blocks, wires, signals, inputs)]
    if mistakes:
        raise SimulationError("\n".join(dict.fromkeys(str(item) for item in mistakes)))
    order = evaluation_order(blocks)
    ports = [name for block in blocks for name in port_names(block)]
    known = {name: k for k, name in enumerate([*signals, *ports])}
    ends = np.cumsum([0, *(len(block.outputs) for block in blocks)])
    return Wiring(
        blocks=tuple(blocks[k] for k in order),
        direct=tuple(is_direct(blocks[k]) for k in order),
        reads=tuple(np.array([known[name] for name in blocks[k].inputs], dtype=np.intp) for k in order),
        ports=tuple(slice(int(ends[k]), int(ends[k + 1])) for k in order),
        signals=tuple(ports),
        units=tuple(resolved_units(blocks, signals)[name] for name in ports),
        inputs=np.array([list(inputs).index(name) for name in wires], dtype=np.intp),
        sources=np.array([ports.index(port) for port in wires.values()], dtype=np.intp),
    )


def evaluation_order(blocks: Sequence[Block]) -> list[int]:
    """Numbers of blocks, each after the direct ones that it reads, and where that can be after all that it reads."""
    number = {block.name: k for k, block in enumerate(blocks)}
    needed = [{number[name] for name in producers(block, blocks, direct_only=True)} for block in blocks]
    wanted = [{number[name] for name in producers(block, blocks)} - {k} for k, block in enumerate(blocks)]
    left, order = list(range(len(blocks))), list[int]()
    while left:
        ready = [k for k in left if not needed[k].intersection(left)]
        # the first result of a block that is not direct is there for all that come after it
        order.append(next((k for k in ready if not wanted[k].intersection(left)), ready[0]))
        left.remove(order[-1])
    return order
