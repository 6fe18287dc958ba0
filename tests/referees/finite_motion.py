"""What two rigid bodies in finite motion do to each other, as functions of their coordinates with exact derivatives.

Coordinates of a body: displacement of its centre of mass from its steadily moving place, in inertial axes, and the
rotation vector of its axes. Axes of a body that spins about its axis of symmetry do not take part in the steady spin.
"""

from typing import NamedTuple

import numpy as np

from eom.vehicle.elements import GROUND, Body, Connection, Vector
from tests.referees.jets import Array, Jet, Jets, cross, reciprocal, rotation, sqrt, variables

ROOM = 12
"""Variables of a body: six coordinates, six rates."""


class Moving(NamedTuple):
    """A body in finite motion, everything in inertial axes but `turning`.

    Attributes
    ----------
    body : Body
    centre, velocity : Jets
        Of its centre of mass, less the steady travel in `centre` alone.
    axes : Jets
        Rotation matrix.
    turning : Jets
        Angular velocity without the steady spin, in body axes.
    """

    body: Body
    centre: Jets
    velocity: Jets
    axes: Jets
    turning: Jets

    def fixed(self, place: Vector) -> Jets:
        """Where a place of the trim, fixed on the body's axes, is now."""
        here: Jets = self.centre + self.axes @ np.subtract(place, self.body.centre)
        return here

    def velocity_at(self, arm: Jets, *, spinning: bool = False) -> Jets:
        """Velocity of the material point at an arm from the centre; without the steady spin that of the axes' point."""
        spin = np.array(self.body.spin) if spinning else np.zeros(3)
        here: Jets = self.velocity + cross(self.axes @ (self.turning + spin), arm)
        return here


GROUND_BODY = Body("ground", 0.0, (0.0, 0.0, 0.0), ((0.0,) * 3,) * 3, (0.0,) * 3, (0.0,) * 3)


def moving(body: Body, of: list[Jet]) -> Moving:
    """A body by its twelve variables."""
    q = np.array(of, dtype=object)
    axes, rate = rotation(q[3:6])
    return Moving(body, np.array(body.centre) + q[:3], np.array(body.velocity) + q[6:9], axes, rate @ q[9:12])


def pair(bodies: tuple[Body, ...], indices: tuple[int, int]) -> tuple[Moving, Moving]:
    """Two bodies, the first by variables 0 to 11, the second by 12 to 23; ground does not move."""
    free = variables(2 * ROOM)
    still = [0.0 * each for each in free[:ROOM]]
    first, second = (
        moving(GROUND_BODY if k == GROUND else bodies[k], still if k == GROUND else free[start : start + ROOM])
        for k, start in zip(indices, (0, ROOM), strict=True)
    )
    return first, second


def basis(count: int, axis: Vector) -> Array:
    """The directions that a count and an axis stand for: the axis, its normal plane, or all of space."""
    a: Array = np.array(axis) / np.sqrt(np.dot(axis, axis))
    if count in {0, 3}:
        return np.eye(3)[:count]
    if count == 1:
        return a[np.newaxis]
    helper = np.eye(3)[np.argmin(np.abs(a))]
    first = basis(1, tuple(helper - a * (a @ helper)))[0]
    return np.array([first, np.cross(a, first)])


def measures(bodies: tuple[Body, ...], item: Connection) -> list[Jet]:
    """What a connection measures in finite motion, one number per direction, first body minus second.

    The force or moment of each is its gradient. A line measures how much shorter it has become, a point the place
    of the first body in the axes of the second, an axis of two moments what the axes have turned apart.
    """
    one, two = pair(bodies, item.bodies)
    if item.line:
        span = two.fixed(item.places[1]) - one.fixed(item.places[0])
        length = sqrt(span @ span)
        return [length.value - length]
    return [*force_measures(one, two, item), *moment_measures(one, two, item)]


def force_measures(one: Moving, two: Moving, item: Connection) -> list[Jet]:
    """Relative displacements of a point in the axes of the second body."""
    touching = one.fixed(item.places[0])
    if item.rolling_axis is not None:
        touching = one.centre + disc_contact(one, two, item, item.rolling_axis)
    apart = two.axes.T @ (touching - two.fixed(item.places[1]))
    return list(basis(item.forces, item.force_axis) @ apart) if item.forces else []


def disc_contact(one: Moving, two: Moving, item: Connection, axle: Vector) -> Jets:
    """Arm from the centre to the point of a thin disc nearest to the second body's plane."""
    a, n = basis(1, axle)[0], basis(1, item.force_axis)[0]
    arm = np.subtract(item.places[0], one.body.centre)
    radius = float(np.linalg.norm(arm - a * (a @ arm)))
    axle_now, normal = one.axes @ a, two.axes @ n
    side = normal - axle_now * (axle_now @ normal)
    down = -1.0 if n @ arm < 0.0 else 1.0
    lowest: Jets = axle_now * float(a @ arm) + side * (reciprocal(sqrt(side @ side)) * (down * radius))
    return lowest


def moment_measures(one: Moving, two: Moving, item: Connection) -> list[Jet]:
    """Relative rotations, or for an upright connection how the first body's arms leave the second one's plane."""
    if item.moments == 0:
        return []
    about = basis(item.moments, item.moment_axis)
    if item.upright is not None:
        z = basis(1, item.upright)[0]
        return [(one.axes @ np.cross(z, d)) @ (two.axes @ z) for d in about]
    relative = two.axes.T @ one.axes
    turned = 0.5 * np.array([relative[k - 1, k - 2] - relative[k - 2, k - 1] for k in range(3)], dtype=object)
    return list(about @ turned)


def hinge_measures(bodies: tuple[Body, ...], item: Connection) -> list[Jet]:
    """The same conditions for a joint; two locked rotations leave the axis free to turn any number of times."""
    if item.moments != 2 or item.line:
        return measures(bodies, item)
    one, two = pair(bodies, item.bodies)
    axis = one.axes @ basis(1, item.moment_axis)[0]
    first, second = (two.axes @ normal for normal in basis(2, item.moment_axis))
    return [*force_measures(one, two, item), -1.0 * (axis @ second), axis @ first]


def sliding(bodies: tuple[Body, ...], item: Connection, *, material: bool) -> list[Jet]:
    """Relative velocities and angular velocities, each body's in its own axes.

    With ``material`` the first body, if it spins, is a disc, whose material at the lowest point is looked at.
    """
    result: list[Jet] = []
    parts = []
    one, two = pair(bodies, item.bodies)
    for each, place in zip((one, two), item.places, strict=True):
        arm = each.axes @ np.subtract(place, each.body.centre)
        disc = material and each is one and any(each.body.spin)
        if disc:
            # one direction of sliding lies in the plane and does not tell its normal: the road's
            plane = item._replace(force_axis=(0.0, 0.0, 1.0)) if item.forces == 1 else item
            arm = disc_contact(one, two, plane, each.body.spin)
        parts.append((each.axes.T @ each.velocity_at(arm, spinning=disc), each.turning))
    (v1, turning1), (v2, turning2) = parts
    if item.forces:
        result += list(basis(item.forces, item.force_axis) @ (v1 - v2))
    if item.moments:
        result += list(basis(item.moments, item.moment_axis) @ (turning1 - turning2))
    return result


def kinetic_energy(body: Body) -> Jet:
    """Kinetic energy in the twelve variables of a body."""
    now = moving(body, variables(ROOM))
    turning = now.turning + np.array(body.spin)
    energy: Jet = body.mass * (now.velocity @ now.velocity) + turning @ (np.array(body.inertia) @ turning)
    return 0.5 * energy
