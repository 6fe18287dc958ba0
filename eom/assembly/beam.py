"""Slender beams in bending, after Euler and Bernoulli: strains, stiffness, consistent mass, weight.

End motions of one plane are (y1, slope1, y2, slope2); the slope is positive where y grows along the beam.
"""

from collections.abc import Sequence

import numpy as np

from eom.assembly.rows import arm_of
from eom.assembly.vectors import Array, array, skew, unit, zeros
from eom.vehicle.elements import GROUND, Beam, Body, Connection, Load, Vector


def beam_axes(beam: Beam) -> tuple[float, Array]:
    """Length, and unit vectors (3, 3): along the beam, across it in the first plane, across it in the second."""
    span = np.subtract(beam.places[1], beam.places[0])
    along = unit(span)
    normal = array(beam.normal)
    first = unit(normal - along * (along @ normal))
    length: float = np.inner(span, along)
    return length, np.array([along, first, skew(along) @ first])


def end_motions(bodies: Sequence[Body], beam: Beam) -> Array:
    """Displacement and rotation of both ends along the beam's axes, shape (12, 12), over its bodies' coordinates."""
    _, axes = beam_axes(beam)
    turned = [-axes @ skew(arm_of(bodies, *end)) for end in zip(beam.bodies, beam.places, strict=True)]
    motions = zeros((12, 12), axes, *turned)
    for at, turn in zip((0, 6), turned, strict=True):
        motions[at : at + 3, at : at + 3] = axes
        motions[at : at + 3, at + 3 : at + 6] = turn
        motions[at + 3 : at + 6, at + 3 : at + 6] = axes
    return motions


def plane_motions(bodies: Sequence[Body], beam: Beam) -> tuple[Array, Array]:
    """(y1, slope1, y2, slope2) of each of the two planes, shapes (4, 12)."""
    _, v1, w1, _, t1v, t1w, _, v2, w2, _, t2v, t2w = end_motions(bodies, beam)
    # a turn about the second normal tilts the first plane upwards, one about the first tilts the second down
    return np.array([v1, t1w, v2, t2w]), np.array([w1, -t1v, w2, -t2v])


def beam_rows(bodies: Sequence[Body], beam: Beam) -> tuple[Array, Array]:
    """Independent strains, shape (4, 12), and their stiffness, (4, 4): per plane constant and linear curvature.

    Energy of a plane EI/(2 L) ((s2 - s1)^2 + 3 (s1 + s2 - 2 (y2 - y1)/L)^2), s the slopes.
    """
    length, _ = beam_axes(beam)
    strain = np.array([[0.0, -1.0, 0.0, 1.0], [2.0 / length, 1.0, -2.0 / length, 1.0]])
    rows = np.vstack([strain @ plane for plane in plane_motions(bodies, beam)])
    first, second = (bending / length for bending in beam.bending)
    return rows, np.diag([first, 3.0 * first, second, 3.0 * second])


def beam_mass(bodies: Sequence[Body], beam: Beam) -> Array:
    """Consistent mass matrix, shape (12, 12), over the coordinates of the beam's bodies.

    Cubic deflection in each plane, linear motion along the beam (R. D. Cook, Concepts and Applications of Finite
    Element Analysis); its own rotation about its line has no inertia.
    """
    L, _ = beam_axes(beam)
    mass = beam.mass_per_length * L
    across = (mass / 420.0) * np.array(
        [
            [156.0, 22.0 * L, 54.0, -13.0 * L],
            [22.0 * L, 4.0 * L**2, 13.0 * L, -3.0 * L**2],
            [54.0, 13.0 * L, 156.0, -22.0 * L],
            [-13.0 * L, -3.0 * L**2, -22.0 * L, 4.0 * L**2],
        ]
    )
    along = end_motions(bodies, beam)[[0, 6]]
    first, second = plane_motions(bodies, beam)
    stretch = (mass / 6.0) * np.array([[2.0, 1.0], [1.0, 2.0]])
    result: Array = along.T @ stretch @ along + first.T @ across @ first + second.T @ across @ second
    return result


def weight_moment(beam: Beam, gravity: Vector) -> Array:
    """The fixed-end moment of the beam's weight on its first end [N m]; the one on its second end is its opposite."""
    length, axes = beam_axes(beam)
    moment: Array = np.cross(axes[0], array(gravity)) * (beam.mass_per_length * length**2 / 12.0)
    return moment


def beam_carried(
    bodies: Sequence[Body], beam: Beam, tensions: Array, gravity: Vector
) -> list[tuple[Connection, Array]]:
    """What the beam's load is as that of two joints, one at each end with half of it: they turn it along.

    Each keeps the force in the axes of the other end's body and turns the moment half with each end. This is
    conservative, obeys action and reaction, and in a chain of beams tends to the law of a bent line.
    """
    rows, _ = beam_rows(bodies, beam)
    wrenches = (rows.T @ tensions).reshape(2, 6)
    moment = weight_moment(beam, gravity)
    carried: list[tuple[Connection, Array]] = []
    for end, (own, sign) in enumerate(zip(wrenches, (1.0, -1.0), strict=True)):
        pair, place = (beam.bodies[end], beam.bodies[1 - end]), beam.places[end]
        about = own[3:] - skew(arm_of(bodies, beam.bodies[end], place)) @ own[:3] + sign * moment
        joint = Connection(beam.name, pair, (place, place), forces=3, moments=3)
        carried.append((joint, 0.5 * np.concatenate([own[:3], about])))
    return carried


def beam_weight(beam: Beam, gravity: Vector) -> list[Load]:
    """Loads at the ends that do the work of the beam's weight: half of it each, and its fixed-end moments.

    How the moments turn is told by `beam_carried`.
    """
    if beam.mass_per_length == 0.0:
        return []
    length, _ = beam_axes(beam)
    weight = beam.mass_per_length * length * array(gravity)
    moment = weight_moment(beam, gravity)
    zero = (0.0, 0.0, 0.0)
    loads = []
    for body, place, sign in zip(beam.bodies, beam.places, (1.0, -1.0), strict=True):
        if body != GROUND:
            force, couple = (0.5 * weight).tolist(), (sign * moment).tolist()
            loads += [
                Load(f"{beam.name}.weight", body, place, tuple(force), zero),
                Load(f"{beam.name}.weight", body, place, zero, tuple(couple), body),
            ]
    return loads
