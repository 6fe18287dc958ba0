"""Small systems to try the kernel on, and how to turn, shift and mirror whole systems."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from hypothesis import Phase
from numpy.typing import NDArray

from eom.assembly.algebra import dense
from eom.assembly.massless import first_order, independent_equations
from eom.assembly.matrices import Matrices, assemble_matrices
from eom.assembly.pivots import choose_coordinates, complete
from eom.assembly.reduction import Pivots
from eom.assembly.state_space import StateSpace, state_space
from eom.assembly.tangent import tangent_entries
from eom.vehicle.elements import (
    GROUND,
    Beam,
    Body,
    Bushing,
    Connection,
    Elastic,
    Input,
    Load,
    Matrix3,
    Output,
    Slip,
    System,
    Triangle,
    Vector,
)

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
ZERO: Vector = (0.0, 0.0, 0.0)
X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
PHASES = (Phase.explicit, Phase.generate, Phase.shrink)
"""What hypothesis does: all but explaining a failure, which takes longer than all the rest."""
EMPTY = System((), ZERO, (), (), (), (), (), (), ())
"""A system of nothing, to be filled by ``_replace``."""


class Linear(NamedTuple):
    """What the kernel makes of a system."""

    matrices: Matrices
    pivots: Pivots
    model: StateSpace


def assembled(system: System) -> Matrices:
    """Matrices of a system, which need not be balanced."""
    return assemble_matrices(system, choose_coordinates(system))


def pivots_of(system: System) -> Pivots:
    """All pivots of a system at its present numbers."""
    matrices = assembled(system)
    return complete(system, matrices, choose_coordinates(system))[0]


def state_space_of(system: System, matrices: Matrices, pivots: Pivots) -> StateSpace:
    """State space of given matrices."""
    return state_space(system, matrices, pivots, first_order(independent_equations(matrices), pivots))


def model_with(system: System, pivots: Pivots) -> StateSpace:
    """State space of a system by given pivots."""
    return state_space_of(system, assemble_matrices(system, pivots), pivots)


def linear(system: System) -> Linear:
    """Matrices, pivots and state space of a system."""
    pivots = pivots_of(system)
    matrices = assemble_matrices(system, pivots)
    return Linear(matrices, pivots, state_space_of(system, matrices, pivots))


def tangent_stiffness(bodies: Sequence[Body], connections: Sequence[Connection], reactions: Sequence[Array]) -> Array:
    """Tangent stiffness of connections with their reactions over all coordinates."""
    size = 6 * len(bodies)
    return dense((size, size), tangent_entries(bodies, list(zip(connections, reactions, strict=True))))


def vector(values: Sequence[float] | Array) -> Vector:
    """Three numbers as the plain tuple that elements hold."""
    x, y, z = (float(value) for value in values)
    return (x, y, z)


def tensor(values: Array) -> Matrix3:
    """A matrix (3, 3) as the plain tuples that bodies hold."""
    return (vector(values[0]), vector(values[1]), vector(values[2]))


def matrix(values: Array) -> tuple[tuple[float, ...], ...]:
    """A matrix of any shape as the plain tuples that elements hold."""
    return tuple(tuple(float(value) for value in row) for row in values)


def diagonal(xx: float, yy: float, zz: float) -> Matrix3:
    """Inertia tensor about principal axes."""
    return ((xx, 0.0, 0.0), (0.0, yy, 0.0), (0.0, 0.0, zz))


def body(
    name: str,
    centre: Vector = ZERO,
    mass: float = 1.0,
    inertia: Matrix3 = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    velocity: Vector = ZERO,
    spin: Vector = ZERO,
) -> Body:
    """A body of one kilogram at rest, unless said otherwise."""
    return Body(name, mass, centre, inertia, velocity, spin)


def point(
    bodies: tuple[int, int],
    place: Vector,
    forces: int = 0,
    moments: int = 0,
    axis: Vector = Z,
    name: str = "point",
) -> Connection:
    """A point whose forces and moments share one axis."""
    return Connection(name, bodies, (place, place), forces, axis, moments, axis)


def line(bodies: tuple[int, int], first: Vector, second: Vector, name: str = "line") -> Connection:
    """A line between two places."""
    return Connection(name, bodies, (first, second), 1, line=True)


def spring(connection: Connection, stiffness: float, damping: float = 0.0) -> Elastic:
    """A spring with a damper along the forces of a connection."""
    return Elastic(connection, (stiffness, 0.0), (damping, 0.0))


def push(index: int, place: Vector, axis: Vector, name: str = "push", gain: float = 1.0) -> Input:
    """A force input on a body."""
    return Input(name, "N", point((index, GROUND), place, forces=1, axis=axis), (gain,), (0.0,))


def measure(
    index: int, place: Vector, axis: Vector, quantity: str = "position", frame: str = "inertial", name: str = "output"
) -> Output:
    """Motion of a body's place along an axis."""
    return Output(name, "", quantity, frame, ((1.0, point((index, GROUND), place, forces=1, axis=axis)),))


def turn(index: int, axis: Vector, quantity: str = "position", frame: str = "inertial", name: str = "output") -> Output:
    """Rotation of a body about an axis."""
    return Output(name, "", quantity, frame, ((1.0, point((index, GROUND), ZERO, moments=1, axis=axis)),))


def transfer(model: StateSpace, s: complex) -> Complex:
    """Transfer function matrix at *s*."""
    states = np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B.astype(complex))
    return np.asarray(model.C @ states + model.D, dtype=np.complex128)


def eigenvalues(model: StateSpace) -> Complex:
    """Roots, sorted by real and imaginary part."""
    return np.sort_complex(np.linalg.eigvals(model.A).astype(np.complex128))


def nonzero(roots: Complex, smallest: float = 1e-9) -> Complex:
    """The roots that are no zeros, sorted; of a pair of tiny imaginary parts none."""
    return np.sort_complex(roots[np.abs(roots) > smallest])


def characteristic(A: Array, s: complex) -> complex:
    """The characteristic polynomial det(s I - A).

    Two matrices of size n share all their roots if these agree at more than n points. Other than the roots
    themselves, which rounding spreads by its n-th root where they coincide, it is a well-conditioned number.
    """
    return complex(np.linalg.det(s * np.eye(len(A)) - A))


class Movement(NamedTuple):
    """Turns by an orthogonal matrix, then shifts."""

    rotation: Array
    shift: Array

    def hand(self) -> float:
        """Minus one for a reflection, else one."""
        return float(np.sign(np.linalg.det(self.rotation)))

    def place(self, a: Vector) -> Vector:
        """A place."""
        return vector(self.rotation @ np.array(a) + self.shift)

    def polar(self, a: Vector) -> Vector:
        """A direction."""
        return vector(self.rotation @ np.array(a))

    def axial(self, a: Vector) -> Vector:
        """An axis of rotation."""
        return vector(self.hand() * self.rotation @ np.array(a))

    def moved_body(self, item: Body) -> Body:
        """A body."""
        return item._replace(
            centre=self.place(item.centre),
            inertia=tensor(self.rotation @ np.array(item.inertia) @ self.rotation.T),
            velocity=self.polar(item.velocity),
            spin=self.axial(item.spin),
        )

    def moved_connection(self, item: Connection) -> Connection:
        """A connection."""
        first, second = item.places
        return item._replace(
            places=(self.place(first), self.place(second)),
            force_axis=self.polar(item.force_axis),
            moment_axis=self.axial(item.moment_axis),
            rolling_axis=None if item.rolling_axis is None else self.axial(item.rolling_axis),
            upright=None if item.upright is None else self.polar(item.upright),
        )

    def moved_load(self, item: Load) -> Load:
        """A load."""
        return item._replace(place=self.place(item.place), force=self.polar(item.force), moment=self.axial(item.moment))

    def moved_output(self, item: Output) -> Output:
        """An output."""
        return item._replace(terms=tuple((weight, self.moved_connection(term)) for weight, term in item.terms))

    def moved_slip(self, item: Slip) -> Slip:
        """A slip element; matrices over all directions refer to inertial axes."""
        camber_axis = self.axial(item.camber_axis)
        result = item._replace(connection=self.moved_connection(item.connection), camber_axis=camber_axis)
        if item.connection.moments != 3:
            return result
        # the mirror image keeps its matrices only in directions that are mirrored too
        six = np.kron(np.diag([1.0, self.hand()]), self.rotation)
        coefficients, added_mass = (
            matrix(six @ np.array(values) @ six.T) if values else () for values in (item.coefficients, item.added_mass)
        )
        return result._replace(coefficients=coefficients, added_mass=added_mass)

    def moved_bushing(self, item: Bushing) -> Bushing:
        """A bushing, whose matrices refer to two stated axes and a third that stays right-handed."""
        first, second = item.axes
        hand = self.hand()
        six = np.diag([1.0, 1.0, hand, hand, hand, 1.0])
        stiffness, damping = (matrix(six @ np.array(values) @ six) for values in (item.stiffness, item.damping))
        return Bushing(
            self.moved_connection(item.connection), (self.polar(first), self.polar(second)), stiffness, damping
        )

    def moved_beam(self, item: Beam) -> Beam:
        """A beam."""
        first, second = item.places
        return item._replace(places=(self.place(first), self.place(second)), normal=self.polar(item.normal))

    def moved_triangle(self, item: Triangle) -> Triangle:
        """A membrane."""
        a, b, c = item.places
        return item._replace(places=(self.place(a), self.place(b), self.place(c)))


def moved(system: System, rotation: Array, shift: Array) -> System:
    """The whole drawing turned by an orthogonal matrix, then shifted: everything in it goes along.

    With a reflection (determinant -1) axes of rotation, moments and spins, being axial vectors, turn round once
    more: the mirror image of a wheel that rolls forward rolls forward.
    """
    go = Movement(rotation, shift)
    return System(
        tuple(go.moved_body(item) for item in system.bodies),
        go.polar(system.gravity),
        tuple(item._replace(connection=go.moved_connection(item.connection)) for item in system.constraints),
        tuple(go.moved_connection(item) for item in system.rolling),
        tuple(item._replace(connection=go.moved_connection(item.connection)) for item in system.elastic),
        tuple(go.moved_slip(item) for item in system.slip),
        tuple(go.moved_load(item) for item in system.loads),
        tuple(item._replace(connection=go.moved_connection(item.connection)) for item in system.inputs),
        tuple(go.moved_output(item) for item in system.outputs),
        tuple(go.moved_bushing(item) for item in system.bushings),
        tuple(go.moved_beam(item) for item in system.beams),
        tuple(go.moved_triangle(item) for item in system.triangles),
    )
