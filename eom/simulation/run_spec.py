"""What a run file says, in SI units."""

from collections.abc import Mapping
from dataclasses import dataclass

from eom.simulation.blocks import Block
from eom.simulation.run_inputs import Input, Stated
from eom.vehicle.source import Source


@dataclass(frozen=True)
class RunFile:
    """What a run file says, in SI units; None where it says nothing.

    Attributes
    ----------
    file : str
        Its name as given.
    digest : str
        SHA-256 of its text.
    duration : float
        Time to simulate [s].
    speed : float or None
        Speed of the trim to start from [m/s].
    sample : float or None
        Time between samples of the results [s].
    method : str
        ``automatic``, ``rk4``, ``dormand_prince`` or ``rosenbrock``.
    step : float or None
        Step of ``rk4`` [s].
    inputs : Mapping
        Input of the model to how it changes over time.
    blocks : tuple of Block
        In the order of the file.
    wires : Mapping
        Input of the model to the port ``BLOCK.PORT`` that drives it.
    source, stated
        Where everything stands, for `check_against`.
    """

    file: str
    digest: str
    duration: float
    speed: float | None
    sample: float | None
    method: str
    step: float | None
    inputs: Mapping[str, Input]
    blocks: tuple[Block, ...]
    wires: Mapping[str, str]
    source: Source
    stated: tuple[Stated, ...]
