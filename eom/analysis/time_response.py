"""Motion of a model over time: what every response in time gives."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from eom.analysis.figures import panels
from eom.analysis.roots import is_stable
from eom.analysis.signals import unknown
from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.model.linear import LinearModel

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class TimeResponse:
    """Motion of a model over time, from rest unless an initial state is given.

    Attributes
    ----------
    model : LinearModel
    time : Array
        Shape (n,) [s].
    inputs : Array
        Shape (n, inputs of the model), in their units; at a jump the value after it.
    states : Array
        Shape (n, states).
    outputs : Array
        Shape (n, outputs), in their units; at a jump the value after it.
    delta : Array
        Shape (outputs,): area of the Dirac impulse at the first sample that each output holds besides
        ``outputs`` [output's unit times s]; zero but for an impulse through D.
    what : str
        The input in words.
    stable : bool
        False: the motion does not settle.
    """

    model: LinearModel
    time: Array
    inputs: Array
    states: Array
    outputs: Array
    delta: Array
    what: str
    stable: bool

    def of(self, name: str) -> Array:
        """One output over time, shape (n,); raises `AnalysisError` for an unknown one."""
        if name not in self.model.outputs:
            raise AnalysisError(unknown("output", name, self.model.outputs))
        return self.outputs[:, self.model.outputs.index(name)]

    def plot(self, outputs: Iterable[str] | None = None) -> "Figure":
        """Inputs that act and outputs (all by default) over time, a panel for each unit."""
        model = self.model
        acting = np.flatnonzero(np.any(self.inputs != 0.0, axis=0))
        curves = [(model.inputs[k], f"input [{model.input_units[k]}]", self.inputs[:, k]) for k in acting]
        for name in model.outputs if outputs is None else outputs:
            unit = model.output_units[model.outputs.index(name)] if name in model.outputs else ""
            curves.append((name, f"[{unit}]", self.of(name)))
        note = "" if self.stable else " (unstable or undamped)"
        return panels(self.time, curves, ("time [s]", f"{model.name}: {self.what}{note}"))


def finished(
    model: LinearModel, time: Array, u: Array, x: Array, what: str, delta: Array | None = None
) -> TimeResponse:
    """The result from states and inputs."""
    outputs = x @ model.C.T + u @ model.D.T
    none = np.zeros(len(model.outputs))
    return TimeResponse(model, time, u, x, outputs, none if delta is None else delta, what, is_stable(model))
