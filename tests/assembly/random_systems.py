"""Random systems to try laws on: trees and loops of bodies, loaded and in equilibrium.

hypothesis draws what a system is made of, so that a failure shrinks to few parts; its numbers follow from a seed.
"""

from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

from eom.assembly.vectors import unit
from eom.vehicle.elements import (
    GROUND,
    Body,
    Bushing,
    Connection,
    Constraint,
    Elastic,
    Input,
    Load,
    Output,
    Slip,
    System,
    Vector,
)
from tests.assembly.random_elements import (
    SINGLE_SPRINGS,
    again,
    beam,
    flow,
    full_bushing,
    held,
    membrane,
    single_spring,
    with_knee,
)
from tests.assembly.systems import (
    EMPTY,
    ZERO,
    Array,
    assembled,
    body,
    line,
    measure,
    point,
    push,
    tensor,
    turn,
    vector,
)

JOINTS = {
    "ball": (3, 0),
    "hinge": (3, 2),
    "constant velocity": (3, 1),
    "weld": (3, 3),
    "prismatic": (2, 3),
    "cylindrical": (2, 2),
    "point on line": (2, 0),
    "point on plane": (1, 0),
    "plane on plane": (1, 2),
    "no twist": (0, 1),
}
"""Numbers of locked forces and moments."""
LINKS = (*JOINTS, "bushing", "support", "none")
EXTRAS = (
    "spring",
    "inerter",
    "given preload",
    "torsion",
    "bushing",
    "full bushing",
    "support",
    "link",
    "to ground",
    "held by ground",
    "contact",
    "again",
)
STRUCTURES = ("beam", "heavy beam", "membrane", "drilled membrane")
"""Beams and membranes."""
KNEES = ("spring", "damper", "spring and damper", "spring to damper")
"""What holds a body without mass that slides on another."""


class Recipe(NamedTuple):
    """What a random system is made of.

    Attributes
    ----------
    links : tuple of str
        How each body but the first hangs on one of those before it, see `LINKS`.
    extras : tuple of str
        Further connections, which close loops or lead to the ground, see `EXTRAS`.
    loads : tuple of str
        ``dead``, ``follower`` or ``other`` (turning with another body).
    damped : bool
        Whether springs have dampers.
    speed : float
        Common trim speed [m/s].
    tyres : int
        Number of slip elements.
    wheel : bool
        Whether a wheel rolls along, spinning; needs a speed.
    structures : tuple of str
        Beams and membranes, see `STRUCTURES`.
    knees : tuple of str
        Bodies without mass, see `KNEES`.
    flow : bool
        Whether air, with its mass, acts on a body in all directions.
    held : bool
        Whether a joint holds the speed of a body.
    seed : int
        Of all numbers.
    """

    links: tuple[str, ...]
    extras: tuple[str, ...]
    loads: tuple[str, ...]
    damped: bool
    speed: float
    tyres: int
    wheel: bool
    seed: int
    structures: tuple[str, ...] = ()
    knees: tuple[str, ...] = ()
    flow: bool = False
    held: bool = False


@st.composite
def recipes(
    draw: st.DrawFn, *, conservative: bool = False, sliding: bool = True, massless: bool = True, linear: bool = True
) -> Recipe:
    """Any recipe; ``conservative`` ones are at rest without dampers, ``sliding`` ones may have tyres, wheels and air.

    Without ``massless`` all bodies have mass; without ``linear`` there is no element that is no law of finite motion.
    """
    links = tuple(draw(st.lists(st.sampled_from(LINKS), min_size=1, max_size=3)))
    extras = tuple(draw(st.lists(st.sampled_from(EXTRAS), max_size=4)))
    structures = tuple(draw(st.lists(st.sampled_from(STRUCTURES), max_size=2))) if linear else ()
    kinds = ["dead"] if conservative else ["dead", "follower", "other"]
    loads = tuple(draw(st.lists(st.sampled_from(kinds), max_size=3)))
    damped = not conservative and draw(st.booleans())
    speed = 0.0 if conservative else draw(st.sampled_from((0.0, 3.0)))
    tyres = draw(st.integers(0, 2)) if sliding and speed else 0
    wheel, held = (bool(sliding and speed and draw(st.booleans())) for _ in range(2))
    air = bool(sliding and not conservative and draw(st.booleans()))
    holds = KNEES[:1] if conservative else KNEES
    knees = tuple(draw(st.lists(st.sampled_from(holds), max_size=2))) if massless else ()
    seed = draw(st.integers(0, 100_000))
    return Recipe(links, extras, loads, damped, speed, tyres, wheel, seed, structures, knees, air, held)


class Maker:
    """Makes the parts of a random system from the numbers of a generator."""

    def __init__(self, recipe: Recipe) -> None:
        self.recipe = recipe
        self.numbers = np.random.default_rng(recipe.seed)
        self.heading = self.axis()
        self.velocity = vector(recipe.speed * self.heading)
        self.bodies = [self.body(k) for k in range(len(recipe.links) + 1)]

    def axis(self) -> Array:
        """A random direction."""
        return unit(self.numbers.normal(size=3))

    def place(self) -> Vector:
        """A random place."""
        return vector(self.numbers.uniform(-1.0, 1.0, 3))

    def body(self, k: int) -> Body:
        """A body that a cloud of mass points makes possible."""
        points = self.numbers.uniform(-1.0, 1.0, (5, 3))
        inertia = sum((np.eye(3) * (p @ p) - np.outer(p, p) for p in points), np.zeros((3, 3)))
        return body(f"body {k}", self.place(), self.numbers.uniform(1.0, 3.0), tensor(inertia), self.velocity)

    def ends(self, k: int | None = None) -> tuple[int, int]:
        """A body and one before it, or any two."""
        if k is None:
            first, second = self.numbers.permutation(len(self.bodies))[:2]
            return int(first), int(second)
        return k, int(self.numbers.integers(k))

    def last(self) -> int:
        """The body described last."""
        return len(self.bodies) - 1

    def across(self) -> Array:
        """A random direction along which nothing moves at the trim."""
        return unit(np.cross(self.axis(), self.heading)) if self.recipe.speed else self.axis()

    def coefficients(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Stiffness and damping of forces and moments."""
        k, c = self.numbers.uniform(50.0, 200.0, 2), self.numbers.uniform(1.0, 10.0, 2) * self.recipe.damped
        return (float(k[0]), float(k[1])), (float(c[0]), float(c[1]))

    def elastic(self, connection: Connection) -> Elastic:
        """A spring, with a damper if the recipe says so."""
        return Elastic(connection, *self.coefficients())

    def connect(self, kind: str, ends: tuple[int, int]) -> Constraint | Elastic | Bushing | None:
        """A joint or an elastic connection between two bodies."""
        if kind == "none":
            return None
        axis, place = vector(self.axis()), self.place()
        if kind in JOINTS:
            n_forces, n_moments = JOINTS[kind]
            return Constraint(point(ends, place, n_forces, n_moments, axis, name=kind))
        if kind == "bushing":
            forces, moments = (int(count) for count in self.numbers.integers(4, size=2))
            return self.elastic(point(ends, place, max(forces, 1), moments, axis, name=kind))
        return self.elastic(point(ends, place, 1, 2, axis, name=kind)._replace(upright=axis))

    def addition(self, kind: str) -> Constraint | Elastic | Bushing | None:
        """A connection beyond the tree."""
        first, second = self.ends()
        across, place = vector(self.across()), self.place()
        if kind in SINGLE_SPRINGS:
            return single_spring(self, kind, (first, second))
        if kind == "full bushing":
            return full_bushing(self, (first, second))
        if kind == "link":
            return Constraint(line((first, second), place, vector(np.array(place) + 1.5 * self.axis()), name=kind))
        # a joint to the ground may hold what a wheel would have to roll along
        if kind == "to ground" or (kind == "held by ground" and self.recipe.wheel):
            return self.elastic(point((first, GROUND), place, 1, 1, across, name=kind))
        if kind == "held by ground":
            return Constraint(point((first, GROUND), place, 1, int(self.numbers.integers(3)), across, name=kind))
        if kind == "contact":
            return self.elastic(self.contact(first, second))
        return self.connect(kind, (first, second))

    def contact(self, wheel: int, surface: int) -> Connection:
        """Where a disc that stands upright on a plane of the other body touches it."""
        normal, ahead = self.axis(), self.axis()
        lowest = vector(np.array(self.bodies[wheel].centre) - 0.4 * normal)
        axle = vector(unit(np.cross(normal, ahead)))
        return point((wheel, surface), lowest, 1, 0, vector(normal), "contact")._replace(rolling_axis=axle)

    def tyre(self, k: int) -> Slip:
        """Slip across the heading, or in a plane normal to it."""
        first = int(self.numbers.integers(len(self.bodies)))
        c = float(self.numbers.uniform(5.0, 20.0))
        if k % 2:
            return Slip(point((first, GROUND), self.place(), 1, 0, vector(self.across()), f"tyre {k}"), ((c,),))
        plane = point((first, GROUND), self.place(), 2, 0, vector(self.heading), f"tyre {k}")
        return Slip(plane, ((c, 0.0), (0.0, c)))

    def wheel(self, system: System) -> System:
        """The system with a wheel on a hinge of its first body, which rolls on the ground without sliding."""
        up, r, mass = self.across(), 0.4, 1.2
        axle = np.cross(up, self.heading)
        centre = np.array(self.place())
        inertia = mass * r**2 / 4.0 * (np.eye(3) + np.outer(axle, axle))
        spin = vector(self.recipe.speed / r * axle)
        index, lowest = len(system.bodies), vector(centre - r * up)
        contact = point((index, GROUND), lowest, 1, 0, vector(up), "contact")._replace(rolling_axis=vector(axle))
        hub = point((index, 0), vector(centre), 3, 2, vector(axle), "hub")
        return system._replace(
            bodies=(*system.bodies, body("wheel", vector(centre), mass, tensor(inertia), self.velocity, spin)),
            constraints=(*system.constraints, Constraint(hub), Constraint(contact)),
            rolling=(point((index, GROUND), lowest, 2, 0, vector(up), "rolling"),),
        )

    def load(self, kind: str) -> Load:
        """A load of the kind; a dead moment has no potential and is left out."""
        first, second = self.ends()
        force, moment = vector(self.numbers.uniform(-20.0, 20.0, 3)), vector(self.numbers.uniform(-10.0, 10.0, 3))
        frame = {"dead": GROUND, "follower": first, "other": second}[kind]
        return Load(kind, first, self.place(), force, ZERO if kind == "dead" else moment, frame)

    def channels(self) -> tuple[tuple[Input, ...], tuple[Output, ...]]:
        """A force and a moment that drive; displacement, rotation and their rates and accelerations."""
        last = len(self.bodies) - 1
        torque = Input("torque", "N m", point((0, last), ZERO, 0, 1, vector(self.axis())), (1.0,), (0.0,))
        outputs: list[Output] = []
        for quantity, frame in (
            ("position", "inertial"),
            ("velocity", "inertial"),
            ("velocity", "body"),
            ("acceleration", "inertial"),
            ("acceleration", "body"),
        ):
            outputs += [
                measure(last, self.place(), vector(self.axis()), quantity, frame, f"{frame} {quantity}"),
                turn(0, vector(self.axis()), quantity, frame, f"{frame} {quantity} of rotation"),
            ]
        return (push(0, self.place(), vector(self.axis())), torque), tuple(outputs)


def couple(index: int, centre: Vector, moment: Array) -> tuple[Load, ...]:
    """Two opposite dead forces that make a moment: unlike a dead moment they have a potential."""
    size = float(np.linalg.norm(moment))
    if size == 0.0:
        return ()
    helper = np.eye(3)[int(np.argmin(np.abs(moment)))]
    arm = unit(np.cross(moment, helper))
    force = np.cross(moment, arm) / 2.0
    return tuple(
        Load("couple", index, vector(np.array(centre) + sign * arm), vector(sign * force), ZERO) for sign in (1.0, -1.0)
    )


def in_equilibrium(system: System) -> System:
    """The system with dead forces that balance what its connections cannot carry."""
    residual = assembled(system).statics.residual.reshape(-1, 6)
    loads = list(system.loads)
    for k, (item, rest) in enumerate(zip(system.bodies, residual, strict=True)):
        loads.append(Load("balance", k, item.centre, vector(-rest[:3]), ZERO))
        loads += couple(k, item.centre, -rest[3:])
    return system._replace(loads=tuple(loads))


def build(recipe: Recipe) -> System:
    """The system of a recipe, in equilibrium."""
    make = Maker(recipe)
    found = [make.connect(kind, make.ends(k + 1)) for k, kind in enumerate(recipe.links)]
    for kind in recipe.extras:
        joints = [item for item in found if isinstance(item, Constraint)]
        found.append(again(make, joints) if kind == "again" else make.addition(kind))
    inputs, outputs = make.channels()
    sheets = [membrane(make, kind) for kind in recipe.structures if "membrane" in kind]
    constraints = [item for item in found if isinstance(item, Constraint)] + [held(make)] * recipe.held
    system = EMPTY._replace(
        bodies=tuple(make.bodies),
        gravity=vector(9.81 * make.axis()),
        constraints=tuple(constraints),
        elastic=tuple(item for item in found if isinstance(item, Elastic)),
        slip=tuple(make.tyre(k) for k in range(recipe.tyres)) + ((flow(make),) if recipe.flow else ()),
        loads=tuple(make.load(kind) for kind in recipe.loads),
        inputs=inputs,
        outputs=outputs,
        bushings=tuple(item for item in found if isinstance(item, Bushing)),
        beams=tuple(beam(make, kind) for kind in recipe.structures if "beam" in kind),
        triangles=tuple(item for item in sheets if item is not None),
    )
    for kind in recipe.knees:
        system = with_knee(make, system, kind)
    return in_equilibrium(make.wheel(system) if recipe.wheel else system)
