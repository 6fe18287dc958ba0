"""Parts of random systems beyond springs and joints: full matrices, structures, air, bodies without mass."""

from typing import TYPE_CHECKING

import numpy as np

from eom.assembly.vectors import unit
from eom.vehicle.elements import GROUND, Beam, Bushing, Connection, Constraint, Elastic, Slip, System, Triangle
from tests.assembly.systems import body, line, matrix, point, vector

if TYPE_CHECKING:
    from tests.assembly.random_systems import Maker

NOTHING = ((0.0, 0.0, 0.0),) * 3
SINGLE_SPRINGS = ("spring", "inerter", "given preload", "torsion")
AGAIN = ("hinge", "cylindrical", "prismatic", "weld")
"""Joints that lock the same motions wherever along their axis they are."""


def positive(make: "Maker", size: float) -> tuple[tuple[float, ...], ...]:
    """A positive definite matrix (6, 6) whose roots are about *size*, without any zeros."""
    root = np.eye(6) + 0.3 * make.numbers.normal(size=(6, 6))
    return matrix(size * root @ root.T)


def single_spring(make: "Maker", kind: str, ends: tuple[int, int]) -> Elastic:
    """A spring along a line or about it, with damper, inerter or a given tension."""
    start = make.place()
    # the far end is no random place: lines shorter than 1 m make stiff preloads
    end = vector(np.array(start) + 1.5 * make.axis())
    connection = line(ends, start, end, kind)
    if kind == "torsion":
        axis = vector(np.subtract(end, start))
        connection = Connection(kind, ends, (start, end), moments=1, moment_axis=axis)
    spring = make.elastic(connection)
    if kind in {"inerter", "torsion"}:
        b, d = (float(value) for value in make.numbers.uniform(0.1, 0.5, 2))
        spring = spring._replace(inertance=(b, d))
    return spring._replace(preload=float(make.numbers.uniform(-20.0, 20.0))) if kind == "given preload" else spring


def full_bushing(make: "Maker", ends: tuple[int, int]) -> Bushing:
    """A bushing whose matrices couple all directions, in axes of its own."""
    first = make.axis()
    second = np.cross(first, make.axis())
    damping = positive(make, 5.0 * make.recipe.damped)
    connection = point(ends, make.place(), 3, 3, name="full bushing")
    return Bushing(connection, (vector(first), vector(second)), positive(make, 100.0), damping)


def again(make: "Maker", joints: list[Constraint]) -> Constraint | None:
    """A joint that locks what one of the joints locks already, elsewhere along its axis."""
    found = [item.connection for item in joints if item.connection.name in AGAIN]
    if not found:
        return None
    first = found[int(make.numbers.integers(len(found)))]
    there = vector(np.array(first.places[0]) + make.numbers.uniform(0.3, 1.0) * np.array(first.force_axis))
    return Constraint(first._replace(name="again", places=(there, there)))


def beam(make: "Maker", kind: str) -> Beam:
    """A beam between two bodies, with mass if it is heavy."""
    start, along = make.place(), make.axis()
    end = vector(np.array(start) + 1.5 * along)
    first, second = (float(value) for value in make.numbers.uniform(50.0, 200.0, 2))
    normal = vector(np.cross(along, make.axis()) + 0.5 * along)
    return Beam(kind, make.ends(), (start, end), (first, second), normal, 0.4 * (kind == "heavy beam"))


def membrane(make: "Maker", kind: str) -> Triangle | None:
    """A triangle between three bodies, if there are as many."""
    if len(make.bodies) < 3:
        return None
    a, b, c = (int(k) for k in make.numbers.permutation(len(make.bodies))[:3])
    corner = np.array(make.place())
    one = make.axis()
    two = unit(np.cross(one, make.axis())) + 0.3 * one
    places = (vector(corner), vector(corner + one), vector(corner + two))
    return Triangle(kind, (a, b, c), places, 0.01, 1.0e4, 0.3, kind == "drilled membrane")


def flow(make: "Maker") -> Slip:
    """Air about a body: derivatives of any sign, and an added mass."""
    resistance = np.array(positive(make, 5.0)) + make.numbers.normal(size=(6, 6))
    added = positive(make, 0.3)
    return Slip(point((make.last(), GROUND), make.place(), 3, 3, name="air"), matrix(resistance), added)


def held(make: "Maker") -> Constraint:
    """A joint that holds a body's speed, along the trim motion."""
    return Constraint(point((0, GROUND), make.place(), 1, 0, vector(make.heading), "held"), moving=True)


def with_knee(make: "Maker", system: System, kind: str) -> System:
    """The system with a body without mass, that slides on one of its bodies, held as *kind* says."""
    base, other = make.ends()
    axis, place, index = vector(make.axis()), make.place(), len(system.bodies)
    name = f"knee {index}"
    k_own, k_far = (float(value) for value in make.numbers.uniform(300.0, 500.0, 2))
    c_far = float(make.numbers.uniform(5.0, 10.0))
    guide = Constraint(point((index, base), place, 2, 3, axis, name))
    near = Elastic(point((index, base), place, 1, 0, axis, f"{name} near"), (k_own, 0.0), (0.0, 0.0))
    stiffness, damping = {
        "spring": (k_far, 0.0),
        "damper": (0.0, c_far),
        "spring and damper": (k_far, c_far),
        "spring to damper": (0.0, c_far),
    }[kind]
    far = Elastic(point((index, other), place, 1, 0, axis, f"{name} far"), (stiffness, 0.0), (damping, 0.0))
    springs = (far,) if kind in {"damper", "spring and damper"} else (near, far)
    return system._replace(
        bodies=(*system.bodies, body(name, place, 0.0, NOTHING, make.velocity)),
        constraints=(*system.constraints, guide),
        elastic=(*system.elastic, *springs),
    )
