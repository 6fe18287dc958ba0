"""Meshes of membrane triangles, for tests."""

import numpy as np

from eom.vehicle.elements import Load, System, Triangle
from tests.assembly.systems import EMPTY, Array, assembled, body, vector

THICKNESS, MODULUS, POISSON = 0.02, 7.0, 0.3
Corners = list[tuple[int, int, int]]


def membrane(
    places: Array,
    corners: Corners,
    *,
    drilling: bool,
    material: tuple[float, float, float] = (THICKNESS, MODULUS, POISSON),
) -> System:
    """A body at every place (n, 3) and triangles between them."""
    bodies = tuple(body(f"n{k}", vector(place)) for k, place in enumerate(places))
    triangles = tuple(
        Triangle(
            f"t{k}",
            three,
            (vector(places[three[0]]), vector(places[three[1]]), vector(places[three[2]])),
            *material,
            drilling,
        )
        for k, three in enumerate(corners)
    )
    return EMPTY._replace(bodies=bodies, triangles=triangles)


def patch() -> tuple[Array, Corners]:
    """An irregular mesh of a quadrilateral: five triangles, one corner inside."""
    places = np.array([[0.0, 0, 0], [2.1, 0.2, 0], [2.6, 1.7, 0], [0.3, 1.4, 0], [0.9, 0.6, 0], [1.6, 0.9, 0]])
    corners = [(0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 3, 5), (3, 4, 5), (3, 0, 4)]
    return places, corners


def turned_about(places: Array, rotation: Array) -> Array:
    """Places turned by a rotation."""
    return np.asarray(places @ rotation.T)


def stretched(system: System, tension: float) -> System:
    """The membrane under forces at its corners that hold an equal tension [N/m] in all directions.

    They are the tension times the derivative of the area: by a corner's place, and by its rotation, which makes each
    of its edges a parabola of the area length^2/12.
    """
    loads = []
    for item in system.triangles:
        a = np.array(item.places)
        normal = np.cross(a[1] - a[0], a[2] - a[0])
        normal /= np.linalg.norm(normal)
        for k in range(3):
            before, after = a[k] - a[(k + 2) % 3], a[(k + 1) % 3] - a[k]
            force = 0.5 * tension * np.cross(normal, -before - after)
            moment = tension / 12.0 * (before @ before - after @ after) * normal * item.drilling
            loads.append(Load(f"{item.name}.{k}", item.bodies[k], item.places[k], vector(force), vector(moment)))
    return system._replace(loads=tuple(loads))


def stiffness(system: System) -> Array:
    """Elastic stiffness over all coordinates."""
    return assembled(system).K_elastic
