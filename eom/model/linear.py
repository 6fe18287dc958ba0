"""The linear model: minimal state space with names and units."""

import functools
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from eom.assembly.cyclic import cyclic_basis, state_coordinates
from eom.assembly.state_space import RateError, state_space
from eom.assembly.vectors import Array
from eom.errors import OutputError, SingularError
from eom.model.assembly import Assembly, assemble
from eom.model.eigen import Complex, eigen
from eom.model.modes import Modes, scaled
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    import control

    from eom.program.make import Ready


class Matrices(NamedTuple):
    """Of a linear model."""

    A: Array
    B: Array
    C: Array
    D: Array


def linear(x: Any, u: Any, numbers: Matrices) -> tuple[Any, Any, Any]:
    """Rates, margins of no limits, and outputs."""
    return numbers.A @ x + numbers.B @ u, np.zeros(0), numbers.C @ x + numbers.D @ u


@dataclass(frozen=True)
class LinearModel:
    """dx/dt = A x + B u, y = C x + D u about the trim, everything named.

    Attributes
    ----------
    A, B, C, D : Array
        Shapes (n, n), (n, m), (k, n), (k, m); SI units and radians.
    states, inputs, outputs : tuple of str
        Displacements first, then velocities. ``a.yaw_from_b`` counts a's yaw from b's.
    state_units, input_units, output_units : tuple of str
    cyclic : tuple of int
        States that change nothing but themselves (position, heading, wheel angle): their columns of A are zero but
        for each other's drift, their eigenvalues exactly zero.
    name : str
    speed : float
        Speed of the trim [m/s].
    bodies : tuple of str
    centres : Array
        Their centres of mass at the trim, (bodies, 3) [m].
    motion : Array
        Displacements of all bodies by the states, (6 bodies, n): per body small translation of its centre [m] and
        rotation [rad] in inertial axes.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    state_units: tuple[str, ...]
    input_units: tuple[str, ...]
    output_units: tuple[str, ...]
    cyclic: tuple[int, ...]
    name: str
    speed: float
    bodies: tuple[str, ...]
    centres: Array
    motion: Array

    @functools.cached_property
    def program(self) -> "Ready":
        """The equations as a program, which runs compiled or over many cases at once."""
        from eom.program.make import ready  # noqa: PLC0415  not needed for analyses

        return ready(linear, Matrices(self.A, self.B, self.C, self.D), len(self.A), self.B.shape[1])

    def modes(self) -> Modes:
        """Eigenvalues with frequency, damping ratio, wavelength, participation, shapes and instant centres."""
        result = eigen(self.A, self.cyclic)
        vectors, shapes = scaled(result, self.motion)
        return Modes(
            eigenvalues=result.values,
            eigenvectors=vectors,
            participation=result.participation,
            shapes=shapes,
            states=self.states,
            bodies=self.bodies,
            centres=self.centres,
            cyclic=self.cyclic,
            speed=self.speed,
        )

    def frequency_response(self, frequency: ArrayLike) -> Complex:
        """C (s I - A)^-1 B + D at s = 2 pi i *frequency* [Hz], shape (frequencies, outputs, inputs).

        Each entry is in the output's unit per the input's; a pole on the imaginary axis makes it singular.
        """
        s = 2j * np.pi * np.atleast_1d(np.asarray(frequency, dtype=float))[:, np.newaxis, np.newaxis]
        resolvent = np.linalg.solve(s * np.eye(len(self.A)) - self.A, self.B.astype(complex))
        return np.asarray(self.C @ resolvent + self.D, dtype=complex)

    def without_cyclic(self) -> "LinearModel":
        """The model without its cyclic states, and without the outputs that measure them."""
        kept = np.setdiff1d(np.arange(len(self.A)), self.cyclic)
        seen = np.flatnonzero(~np.any(self.C[:, list(self.cyclic)] != 0.0, axis=1))
        return replace(
            self,
            A=self.A[np.ix_(kept, kept)],
            B=self.B[kept],
            C=self.C[np.ix_(seen, kept)],
            D=self.D[seen],
            states=tuple(self.states[k] for k in kept),
            state_units=tuple(self.state_units[k] for k in kept),
            outputs=tuple(self.outputs[k] for k in seen),
            output_units=tuple(self.output_units[k] for k in seen),
            cyclic=(),
            motion=self.motion[:, kept],
        )

    def to_control(self) -> "control.StateSpace":
        """The model as python-control's state space, names included; needs python-control installed."""
        import control  # noqa: PLC0415  an optional partner, slow to import

        return control.ss(
            self.A,
            self.B,
            self.C,
            self.D,
            states=[name.replace(".", "_") for name in self.states],
            inputs=[name.replace(".", "_") for name in self.inputs],
            outputs=[name.replace(".", "_") for name in self.outputs],
        )


def linearise(vehicle: Vehicle | Assembly) -> LinearModel:
    """Linear model of a vehicle about its trim.

    Raises
    ------
    OutputError
        If an acceleration would need the rate of an input.
    DescriptionError, EquilibriumError, SingularError
        As `assemble`.
    """
    assembly = vehicle if isinstance(vehicle, Assembly) else assemble(vehicle)
    system = assembly.system
    if assembly.prepared is not None:
        from eom.model.wheeled import with_wheels  # noqa: PLC0415  tyres take a while to import

        return with_wheels(assembly, assembly.prepared)
    try:
        model = state_space(system, assembly.matrices, assembly.pivots, assembly.form)
    except RateError as error:
        raise OutputError(str(assembly.vehicle.mistake(error.output, str(error)))) from None
    except ValueError as error:
        raise SingularError(f"{assembly.vehicle.file}: {error}") from None
    names, units = state_names(assembly)
    return LinearModel(
        *model,
        states=names,
        inputs=tuple(item.name for item in system.inputs),
        outputs=tuple(item.name for item in system.outputs),
        state_units=units,
        input_units=tuple(item.unit for item in system.inputs),
        output_units=tuple(item.unit for item in system.outputs),
        cyclic=assembly.pivots.cyclic,
        name=assembly.vehicle.name,
        speed=assembly.vehicle.speed,
        bodies=tuple(body.name for body in system.bodies),
        centres=np.array([body.centre for body in system.bodies]),
        motion=body_motion(assembly),
    )


def body_motion(assembly: Assembly) -> Array:
    """Displacements of all bodies by the states, (6 bodies, states)."""
    reduction, pivots = assembly.reduction, assembly.pivots
    states = len(assembly.form.rates)
    motion: Array = reduction.T @ assembly.form.q[:, :states]
    if pivots.cyclic:
        own = cyclic_basis(assembly.system.bodies, reduction, pivots)
        motion[:, list(pivots.cyclic)] = motion[:, : len(own)] @ own
    return motion


def state_names(assembly: Assembly) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the states (q, n)."""
    reduction, pivots = assembly.reduction, assembly.pivots
    at, velocities = state_coordinates(reduction, pivots)
    coordinates, rates = assembly.coordinates, assembly.velocities
    names = [coordinates[k] for k in at]
    if pivots.cyclic:
        basis = cyclic_basis(assembly.system.bodies, reduction, pivots)
        for k in range(len(names)):
            moved = np.flatnonzero(np.abs(basis[k]) > 1e-9)
            if k not in pivots.cyclic and moved.size:
                lead = coordinates[at[pivots.cyclic[int(moved[0])]]]
                names[k] += f"_from_{lead.rsplit('.', 1)[0]}"
    names += [rates[k] for k in velocities]
    kinds = [int(k) % 6 < 3 for k in (*at, *velocities)]
    units = [("m" if linear else "rad") + ("" if k < len(at) else "/s") for k, linear in enumerate(kinds)]
    return tuple(names), tuple(units)
