"""Chains of beams between nodes without mass, for tests."""

import numpy as np

from eom.vehicle.elements import GROUND, Beam, Body, Constraint, System, Vector
from tests.assembly.systems import EMPTY, X, Y, body, diagonal, line, point

ORIGIN: Vector = (0.0, 0.0, 0.0)


def node(name: str, centre: Vector, velocity: Vector = ORIGIN) -> Body:
    """A body without mass and inertia."""
    return body(name, centre, 0.0, diagonal(0.0, 0.0, 0.0), velocity)


def span(k: int, bodies: tuple[int, int], places: tuple[Vector, Vector]) -> tuple[Constraint, Constraint]:
    """What keeps the length and the twist between two nodes."""
    along = tuple(np.subtract(places[1], places[0]).tolist())
    shaft = point(bodies, places[0], moments=1, axis=along, name=f"shaft_{k}")
    return Constraint(line(bodies, *places, name=f"rod_{k}")), Constraint(shaft)


def chain(
    count: int,
    bending: tuple[float, float],
    mass_per_length: float,
    *,
    length: float = 1.0,
    along: Vector = X,
    normal: Vector = Y,
    clamped: bool = True,
    velocity: Vector = ORIGIN,
) -> System:
    """Beams in a line from the origin: a cantilever clamped to the ground there, or free but for roll."""
    places = [tuple((length * k / count * np.array(along)).tolist()) for k in range(count + 1)]
    first = 1 if clamped else 0
    bodies = tuple(node(f"node_{k}", places[k], velocity) for k in range(first, count + 1))
    numbers = [k - first for k in range(count + 1)]
    if clamped:
        numbers[0] = GROUND
    constraints: list[Constraint] = []
    beams = []
    for k in range(count):
        pair, ends = (numbers[k], numbers[k + 1]), (places[k], places[k + 1])
        constraints += span(k, pair, ends)
        beams.append(Beam(f"beam_{k}", pair, ends, bending, normal, mass_per_length))
    if not clamped:
        constraints.append(Constraint(point((0, GROUND), places[0], moments=1, axis=along, name="no_roll")))
    return EMPTY._replace(bodies=bodies, constraints=tuple(constraints), beams=tuple(beams))
