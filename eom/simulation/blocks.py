"""Blocks: what acts on a model at sample times, such as sensors, drivers and controllers."""

from collections.abc import Mapping, Sequence
from typing import Protocol

from eom.assembly.vectors import Array
from eom.errors import SimulationError


class Block(Protocol):
    """What reads signals and gives others, at the multiples of its period from the start on.

    Besides these a block may have two attributes. ``direct``, True without it: False makes what `update` returns act
    from the block's next sample on, as a computation that takes a period does; the first result acts at once too, as if
    all had been steady before. ``input_units``: the units in which it takes its inputs, None for any.

    Attributes
    ----------
    name : str
        A letter, then letters, digits, underscores.
    inputs : tuple of str
        Signals that it reads: outputs and inputs of the model, its states as ``state:NAME``, ports of blocks as
        ``BLOCK.PORT``. Inputs of the model are read as they are just before the sample.
    outputs : tuple of str
        Names of its ports.
    units : tuple of str or None
        SI units of the ports; None: the unit of the first input.
    period : float
        Time between samples [s].
    """

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def inputs(self) -> tuple[str, ...]:
        """Signals that it reads."""

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of its ports."""

    @property
    def units(self) -> tuple[str | None, ...]:
        """Units of its ports."""

    @property
    def period(self) -> float:
        """Time between samples [s]."""

    def reset(self) -> None:
        """Forget everything: the next sample is the first one."""

    def update(self, t: float, y: Array) -> Array:
        """What the ports give from the sample at *t* [s] on, (outputs,) or (outputs, cases), all finite.

        *y* holds the inputs in SI units, (inputs,), or in a batch (inputs, cases).
        """


class BlockError(SimulationError):
    """Values that a block cannot have: ``wrong`` holds a sentence for each by the name of the value."""

    def __init__(self, block: str, wrong: Mapping[str, str]) -> None:
        self.wrong = dict(wrong)
        super().__init__("\n".join(f"block {block}: {key} {what}" for key, what in wrong.items()))


def port_names(block: Block) -> tuple[str, ...]:
    """A block's ports as signals, ``BLOCK.PORT``."""
    return tuple(f"{block.name}.{port}" for port in block.outputs)


def is_direct(block: Block) -> bool:
    """Whether what a sample gives acts at that sample."""
    return bool(getattr(block, "direct", True))


def input_units(block: Block) -> Sequence[str | None]:
    """The units in which a block takes its inputs, None for any."""
    return getattr(block, "input_units", None) or (None,) * len(block.inputs)
