"""The nonlinear model of a vehicle whose tyres are spliced in: states, inputs, outputs by name, rates, trim, limits."""

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from eom.assembly.vectors import Array
from eom.errors import EquilibriumError
from eom.model.assembly import prepared_for
from eom.model.linear import LinearModel, linearise
from eom.splice.equations import spliced
from eom.splice.limits import Limit, all_margins, happened, limits
from eom.splice.outputs import Signals, all_outputs, body_coordinates
from eom.splice.prepare import Prepared, input_names
from eom.splice.rates import evaluate, rates
from eom.splice.signals import output_names, signals, spliced_states
from eom.splice.state import Evaluation, Model
from eom.splice.steady import steady
from eom.splice.trim import TrimError
from eom.vehicle.load import Vehicle


class Run(NamedTuple):
    """State and inputs of a straight, steady run."""

    x: Array
    u: Array


if TYPE_CHECKING:
    from eom.program.make import Ready


@dataclass(frozen=True)
class TyreModel:
    """dx/dt = rhs(t, x, u), y = outputs(t, x, u): multibody part, nonlinear tyres, wheel spins, drive and brakes.

    The state holds place and heading of the lead body [m, rad], the small displacements counted from it, whole
    velocities [m/s, rad/s], spins of wheels [rad/s], and what lags. The heading is free; articulation and roll are
    small, but forces are turned by articulation and steer exactly.

    Attributes
    ----------
    vehicle : Vehicle
    prepared : Prepared
        The numbers of the equations, and what they were made of.
    signals : Signals
        What the outputs are made of.
    states, inputs, outputs : tuple of str
        Names; ``state_units``, ``input_units`` and ``output_units`` are their units.
    limits : tuple of Limit
        What `reached` watches.
    """

    vehicle: Vehicle
    prepared: Prepared
    signals: Signals
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    state_units: tuple[str, ...]
    input_units: tuple[str, ...]
    output_units: tuple[str, ...]
    limits: tuple[Limit, ...]

    @property
    def numbers(self) -> Model:
        """What the equations compute with."""
        return self.prepared.model

    def rhs(self, t: float, x: ArrayLike, u: ArrayLike) -> Array:
        """Rates of the states x under the inputs u, both arrays in the order of their names; *t* does not matter.

        Complex states or inputs carry derivatives: the imaginary part of the result over that of a step of 1e-30.
        """
        del t
        found: Array = rates(np.asarray(x), np.asarray(u), self.numbers)
        return found

    def output(self, t: float, x: ArrayLike, u: ArrayLike) -> Array:
        """Outputs at a state and inputs, in the order of their names."""
        del t
        found: Array = all_outputs(self.evaluated(x, u), np.asarray(u), self.numbers, self.signals)
        return found

    def evaluated(self, x: ArrayLike, u: ArrayLike) -> Evaluation:
        """All that a state and inputs mean, by part: motion, slips, forces, reactions."""
        return evaluate(np.asarray(x), np.asarray(u), self.numbers)

    def reached(self, x: ArrayLike, u: ArrayLike) -> tuple[Limit, ...]:
        """The limits that are reached at a state: lifted and locked wheels, jackknife, rollover, angles not small."""
        return happened(self.limits, self.margins(x, u))

    def margins(self, x: ArrayLike, u: ArrayLike) -> Array:
        """How far each limit is away, negative beyond it; continuous, so that a solver can find where it is zero."""
        found: Array = all_margins(self.evaluated(x, u), self.numbers, self.signals)
        return found

    @functools.cached_property
    def program(self) -> "Ready":
        """Rates, margins and outputs as a program, which runs compiled or over many cases at once."""
        from eom.program.make import ready  # noqa: PLC0415  not needed for a look at the model

        return ready(spliced, (self.numbers, self.signals), len(self.states), len(self.inputs))

    def trim(self, speed: float | None = None) -> Run:
        """The straight run at a forward speed [m/s], the file's own if none is given; raises `EquilibriumError`."""
        own = self.prepared.trim
        at = own.speed if speed is None else float(speed)
        try:
            if at not in self._runs:
                self._runs[at] = Run(*steady(self.numbers, at, own.slip, own.torque))
        except TrimError as error:
            raise EquilibriumError(str(self.vehicle.mistake(error.owner, str(error)))) from None
        return Run(*(part.copy() for part in self._runs[at]))

    @functools.cached_property
    def _runs(self) -> dict[float, Run]:
        """Straight runs that were found, by speed."""
        return {}

    def coordinates(self, x: ArrayLike) -> Mapping[str, float]:
        """Displacements from the drawing and velocities of all bodies at a state, by name.

        Displacements are in inertial axes, velocities in those of each body's heading: for the B-train the 72
        coordinates of table F1 of Zhu's thesis, from its 40 states.
        """
        found = self.evaluated(x, np.zeros(len(self.inputs)))
        return body_coordinates(found, [body.name for body in self.prepared.system.bodies], self.signals)


def build_tyre_model(vehicle: Vehicle) -> TyreModel:
    """The nonlinear model of a vehicle with wheels.

    Errors as `eom.model.assembly.prepared_for`: without axles with tyres, without forward speed, with wheels as
    bodies or with a run that cannot be held there is no such model.
    """
    prepared = prepared_for(vehicle)
    system = prepared.system
    inputs, outputs = input_names(system), output_names(system)
    own = signals(system, prepared.pivots, [name for name, _ in inputs], vehicle.speed)
    states = spliced_states(prepared)
    return TyreModel(
        vehicle=vehicle,
        prepared=prepared,
        signals=own,
        states=tuple(name for name, _ in states),
        inputs=tuple(name for name, _ in inputs),
        outputs=tuple(name for name, _ in outputs),
        state_units=tuple(unit for _, unit in states),
        input_units=tuple(unit for _, unit in inputs),
        output_units=tuple(unit for _, unit in outputs),
        limits=limits(system),
    )


def build(vehicle: Vehicle, fidelity: str | None = None) -> TyreModel | LinearModel:
    """A vehicle's model: ``tyre``, the default where there are axles with tyres, or ``linear``.

    Raises
    ------
    ValueError
        For another word than these.
    DescriptionError, EquilibriumError, SingularError, OutputError
        As `build_tyre_model` and `eom.linearise`.
    """
    match fidelity or ("tyre" if vehicle.system.wheels else "linear"):
        case "tyre":
            return build_tyre_model(vehicle)
        case "linear":
            return linearise(vehicle)
        case other:
            message = f"fidelity = {other!r}: expected 'tyre' or 'linear'"
            raise ValueError(message)


def tyre_slopes(model: TyreModel, x: ArrayLike, u: ArrayLike) -> tuple[Array, Array]:
    """Exact derivatives of the rates by the states and by the inputs, at any state, by complex steps."""
    step = 1e-30
    at = np.concatenate((np.asarray(x, dtype=complex), np.asarray(u, dtype=complex)))
    n = len(model.states)

    def column(k: int) -> Any:
        """Derivative by one state or input."""
        moved = at + 1j * step * (np.arange(len(at)) == k)
        return model.rhs(0.0, moved[:n], moved[n:]).imag / step

    both = np.array([column(k) for k in range(len(at))]).T
    return both[:, :n], both[:, n:]
