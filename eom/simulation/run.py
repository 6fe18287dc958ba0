"""What a simulation gives: every signal over time with its unit, the limits it reached, and where it came from."""

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from eom.analysis.signals import unknown
from eom.assembly.vectors import Array
from eom.errors import AnalysisError, SimulationError
from eom.simulation.channels import STATE, Channels, Event, as_states, joined, misshapen, repeated
from eom.simulation.dataset import dataset
from eom.simulation.files import write
from eom.simulation.run_panels import asked_panels, usual_panels
from eom.simulation.run_plot import draw

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

__all__ = ["Channels", "Event", "Run"]


@dataclass(frozen=True)
class Run:
    """A simulated motion. Signals are `Channels`: names, units, descriptions, and values of shape (n, signals).

    Raises `SimulationError` for a run without samples, groups of another number of samples than the time, names that
    stand for two signals.

    Attributes
    ----------
    name : str
        The vehicle's.
    time : Array
        Shape (n,) [s], increasing.
    inputs : Channels
        Inputs of the model; at a jump the value after it.
    states : Channels
    outputs : Channels
    blocks : Channels
        Outputs of sampled blocks, held between samples; may be empty, with values of shape (n, 0).
    events : tuple of Event
        The limits that were reached, in order of time.
    method : str
        Which integrator ran, a sentence.
    ended : str
        Why the run ended before its duration, a sentence; empty if it did not.
    identity : Mapping of str to str
        Where the run came from: vehicle, file and its hash, parameters, versions.
    """

    name: str
    time: Array
    inputs: Channels
    states: Channels
    outputs: Channels
    blocks: Channels
    events: tuple[Event, ...]
    method: str
    ended: str
    identity: Mapping[str, str]

    def __post_init__(self) -> None:
        groups = {"inputs": self.inputs, "states": self.states, "outputs": self.outputs, "blocks": self.blocks}
        mistakes = [] if len(self.time) else ["time: expected samples, got none"]
        mistakes += [what for kind, group in groups.items() for what in misshapen(kind, group, len(self.time))]
        mistakes += repeated(self.names)
        if mistakes:
            raise SimulationError("\n".join(mistakes))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all signals as `of` takes them: inputs, outputs, blocks, and states as ``state:NAME``."""
        return (*self.inputs.names, *self.outputs.names, *self.blocks.names, *as_states(self.states).names)

    def of(self, name: str) -> Array:
        """One signal over time, shape (n,), in its unit: an input, output or block's output, or ``state:NAME``.

        Raises `AnalysisError` for an unknown one.
        """
        for group in (self.inputs, self.outputs, self.blocks, as_states(self.states)):
            if name in group.names:
                return group.values[:, group.names.index(name)]
        raise AnalysisError(self.missing(name))

    def missing(self, name: str) -> str:
        """The sentence for a name that the run does not have."""
        if name in self.states.names:
            return f"signal {name}: there is no such signal; did you mean the state '{STATE}{name}'?"
        return unknown("signal", name, self.names)

    def data(self) -> "Dataset":
        """The run as an xarray data set over the dimension ``time`` [s].

        Inputs, outputs and blocks' outputs are variables of their own names, with the attributes ``units`` and
        ``long_name``. States are one variable ``states`` over ``time`` and ``state``, with the names as coordinate
        ``state`` and their units as ``state_unit``. Identity, method, end and events are attributes, plain text.

        Raises `AnalysisError` for a signal whose name the data set needs for itself, such as ``time``.
        """
        return dataset(self.time, joined((self.inputs, self.outputs, self.blocks)), self.states, self.about())

    def plot(self, names: str | Iterable[str] | None = None) -> "Figure":
        """A picture of signals over time: the named one or ones, a panel for each unit; angles in degrees.

        Without names what one looks at first, as far as the run has it: inputs that change (or, if none does, that
        act), lateral accelerations of units, yaw rates, articulation, roll, wheel loads (right ones dashed) or else
        load transfer ratios, speeds; of a run without any of these all outputs. Curves that one line would cover are
        drawn as one, and its label says so. Events are numbered lines, told below.

        Raises `AnalysisError` for names that the run does not have, or for none.
        """
        told = None if names is None else (names,) if isinstance(names, str) else tuple(dict.fromkeys(names))
        mistakes = [self.missing(name) for name in told or () if name not in self.names]
        if told == ():
            mistakes.append("no signal to plot: expected names of signals, or None for the usual ones")
        if mistakes:
            raise AnalysisError("\n".join(mistakes))
        if told is None:
            panels = usual_panels(self.inputs, self.outputs)
        else:
            panels = asked_panels(joined((self.inputs, self.outputs, self.blocks, as_states(self.states))), told)
        return draw(self.time, panels, self.events, "\n".join(filter(None, (self.name, self.ended))))

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the run to a file, replacing one that is there; its suffix says which kind. Returns the path.

        ``.csv``
            Time and all signals, a column each under ``name [unit]``, dimensionless ones under ``name [-]``, states
            as ``state:NAME``; in full precision. Identity and events do not go with it.
        ``.nc``
            netCDF of `data`: netCDF4 where h5netcdf and h5py are installed, netCDF3 otherwise.
        ``.mat``
            For MATLAB: ``run.time``, ``run.tractor.ay`` and so on, states under ``run.state``, columns of n values;
            units as text in the same places under ``units``; identity, method, end and events under ``about``.
            In a part of a name between dots, characters that MATLAB does not allow become underscores, an ``x`` goes
            before a part that starts with no letter or is a word of its language, and 63 characters are kept.

        Raises `AnalysisError` for another suffix, a folder that does not exist, or names that the file cannot hold
        beside each other; for a name such as ``time`` as `data` does.
        """
        signals = joined((self.inputs, self.outputs, self.blocks, as_states(self.states)))
        return write(Path(path), self.time, signals, self.data, self.about())

    def about(self) -> dict[str, str]:
        """Name, identity, method, end and events as text, a line for each event."""
        events = "\n".join(map(str, self.events))
        return {"name": self.name, **self.identity, "method": self.method, "ended": self.ended, "events": events}
