"""Linear models by Lagrange's equations of finite motion, to judge generated models with.

Nothing of the generator is used but its plain elements. Coordinates are displacements q of every body in inertial
axes, so that there is no kinematic matrix and no body-axis velocity but in tyres and rolling:

    d/dt (dT/dq') - dT/dq = forces + J' reactions + Jn' rolling forces

with the kinetic energy T, potentials and constraints of finite rotations. All derivatives are exact: second-order
Taylor arithmetic (`tests.referees.jets`). What each connection does in finite motion is in
`tests.referees.finite_motion`. Dampers act on the rate of what they measure; accelerations are second derivatives of
positions, so that whatever a joint does is in them.
"""

from collections.abc import Sequence

import numpy as np

from eom.vehicle.elements import GROUND, Body, Load, Output, Slip, System
from tests.referees.elimination import RANK, Measured, Spatial
from tests.referees.finite_motion import ROOM, hinge_measures, kinetic_energy, measures, pair, sliding
from tests.referees.jets import Array, Jet
from tests.referees.springs import springs_of, statics

Law = list[tuple[Jet, tuple[int, int]]]
"""What connections measure, each with its two bodies."""


class Sum:
    """Adds what jets of two bodies say to matrices of all bodies."""

    def __init__(self, bodies: tuple[Body, ...]) -> None:
        self.bodies, self.size = bodies, 6 * len(bodies)
        self.M, self.C, self.K = np.zeros((3, self.size, self.size))
        self.load = np.zeros(self.size)

    def spread(self, indices: Sequence[int], rate: int = 0) -> Array:
        """Matrix (variables, 6 n) from the coordinates of all bodies to those of the jets, or to their rates."""
        result = np.zeros((ROOM * len(indices), self.size))
        for k, index in enumerate(indices):
            if index != GROUND:
                start = ROOM * k + 6 * rate
                result[start : start + 6, 6 * index : 6 * index + 6] = np.eye(6)
        return result

    def row(self, jet: Jet, indices: Sequence[int], rate: int = 0) -> Array:
        """Derivative with respect to all coordinates, or to all rates."""
        return jet.gradient @ self.spread(indices, rate)

    def curvature(self, jet: Jet, indices: Sequence[int], rate: int = 0) -> Array:
        """Second derivatives: of coordinates, or of rates (rows) with coordinates (columns)."""
        return self.spread(indices, rate).T @ jet.hessian @ self.spread(indices)

    def stack(self, law: Law, rate: int = 0) -> Array:
        """Rows of derivatives with respect to all coordinates, or to all rates."""
        return np.array([self.row(jet, indices, rate) for jet, indices in law]).reshape(-1, self.size)

    def inertia(self) -> None:
        """The bodies' mass; what changes with velocity goes to C."""
        for k, body in enumerate(self.bodies):
            energy = kinetic_energy(body).hessian
            place, block = slice(6 * k, 6 * k + 6), energy[6:, :6]
            self.M[place, place] += energy[6:, 6:]
            self.C[place, place] += block - block.T
            self.K[place, place] -= energy[:6, :6]

    def potential(self, jet: Jet, indices: Sequence[int]) -> None:
        """A potential: its force at the trim and its stiffness."""
        self.load -= self.row(jet, indices)
        self.K += self.curvature(jet, indices)

    def force(self, components: Sequence[Jet], velocities: Sequence[Jet], indices: Sequence[int]) -> None:
        """A force that does work on a velocity, component by component, wherever the body has gone."""
        for f, v in zip(components, velocities, strict=True):
            self.load += f.value * self.row(v, indices, 1)
            self.K -= f.value * self.curvature(v, indices, 1)
            self.K -= np.outer(self.row(v, indices, 1), self.row(f, indices))

    def slip(self, item: Slip, law: Sequence[Jet]) -> None:
        """A force against sliding velocities, and against their rates."""
        on_q, on_rate = (np.array([self.row(jet, item.connection.bodies, rate) for jet in law]) for rate in (0, 1))
        Theta = np.array(item.coefficients)
        self.K += on_rate.T @ Theta @ on_q
        self.C += on_rate.T @ Theta @ on_rate
        if item.added_mass:
            self.C += on_rate.T @ np.array(item.added_mass) @ on_q
            self.M += on_rate.T @ np.array(item.added_mass) @ on_rate
        if item.camber:
            turning = item.connection._replace(forces=0, moments=1, moment_axis=item.camber_axis)
            angle = self.row(measures(self.bodies, turning)[0], item.connection.bodies)
            self.K += np.outer(on_rate.T @ np.array(item.camber), angle)

    def external(self, item: Load) -> None:
        """A load of constant components in the axes of its frame."""
        indices = (item.body, item.frame)
        body, frame = pair(self.bodies, indices)
        if item.frame == item.body:
            frame = body
        arm = body.axes @ np.subtract(item.place, body.body.centre)
        self.force(list(frame.axes @ np.array(item.force)), list(body.velocity_at(arm)), indices)
        self.force(list(frame.axes @ np.array(item.moment)), list(body.axes @ body.turning), indices)


def linearise(system: System, preloads: tuple[Array, Array] | None = None) -> Spatial:
    """Linear equations of motion about the trim.

    Parameters
    ----------
    system : System
    preloads : tuple of Array, optional
        Reactions and spring loads, one per direction, where statics alone does not give them.

    Raises
    ------
    ValueError
        If the trim is not in equilibrium, or statics leaves preloads open.
    """
    bodies, add = system.bodies, Sum(system.bodies)
    add.inertia()
    for index, body in enumerate(bodies):
        one, _ = pair(bodies, (index, GROUND))
        add.potential(-body.mass * (one.centre @ np.array(system.gravity)), (index, GROUND))
    for load in system.loads:
        add.external(load)
    J, carried = constrain_and_spring(add, system, preloads)
    if np.max(np.abs(add.load), initial=0.0) > RANK * max(1.0, float(np.max(np.abs(carried), initial=0.0))):
        raise ValueError(f"not in equilibrium: {add.load}")
    for slip in system.slip:
        add.slip(slip, sliding(bodies, slip.connection, material=True))
    rolling = [(jet, item.bodies) for item in system.rolling for jet in sliding(bodies, item, material=True)]
    F, G = input_columns(add, system)
    outputs = tuple(measured(add, item, system) for item in system.outputs)
    return Spatial(add.M, add.C, add.K, F, G, J, add.stack(rolling, 1), add.stack(rolling, 0), outputs)


def constrain_and_spring(add: Sum, system: System, preloads: tuple[Array, Array] | None) -> tuple[Array, Array]:
    """Adds springs, dampers, inerters and all preloads; gives J and the preloads of joints and springs."""
    joints, springs = [item.connection for item in system.constraints], springs_of(system)
    locked = [(jet, item.bodies) for item in joints for jet in hinge_measures(system.bodies, item)]
    elastic = [(jet, item.connection.bodies) for item in springs for jet in item.measures]
    J, H = add.stack(locked), add.stack(elastic)
    carried = np.concatenate(preloads or statics(J, H, springs, add.load))
    for item in springs:
        rows = add.stack([(jet, item.connection.bodies) for jet in item.measures])
        add.K += rows.T @ item.stiffness @ rows
        add.C += rows.T @ item.damping @ rows
        add.M += rows.T @ item.inertance @ rows
    for (jet, indices), value in zip(locked + elastic, carried, strict=True):
        add.potential(-value * jet, indices)
    return J, carried


def input_columns(add: Sum, system: System) -> tuple[Array, Array]:
    """F and G: at the trim the direction of an input is that of what it would measure."""
    F, G = np.zeros((2, add.size, len(system.inputs)))
    for column, item in enumerate(system.inputs):
        rows = add.stack([(jet, item.connection.bodies) for jet in measures(system.bodies, item.connection)])
        F[:, column], G[:, column] = rows.T @ np.array(item.gain), rows.T @ np.array(item.rate_gain)
    return F, G


def measured(add: Sum, item: Output, system: System) -> Measured:
    """An output's rows: displacements of the inertial axes, or velocities of the body's own."""
    on_q, on_rate = np.zeros((2, add.size))
    for weight, connection in item.terms:
        if item.frame == "inertial":
            on_q += weight * add.row(measures(system.bodies, connection)[0], connection.bodies)
            continue
        velocity = sliding(system.bodies, connection, material=False)[0]
        on_q += weight * add.row(velocity, connection.bodies)
        on_rate += weight * add.row(velocity, connection.bodies, 1)
    order = ("position", "velocity", "acceleration").index(item.quantity) - (item.frame == "body")
    names = [each.name for each in system.inputs]
    direct = np.zeros(len(names))
    for name, gain in item.feedthrough:
        direct[names.index(name)] += gain
    return Measured(on_q, on_rate, order, direct)
