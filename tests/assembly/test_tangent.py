"""Tangent stiffness against the finite motion of the forces that it comes from.

Each connection follows a law of force for large motion, written out here with large rotations. Its wrench on
either body, resolved in that body's own turned axes about its centre, is differentiated numerically by small
displacements and rotation vectors of both bodies; the tangent stiffness is minus that derivative.

Tolerance: central differences of step h = 5e-4, extrapolated once (Richardson), leave an error of (a h)^4 from
truncation, a = 10 where a long arm turns a short line, and of 1e-16 / h = 2e-13 from rounding, both times the
size of force times arms, up to 100: 1e-8 is asked for. Where a law is itself given as the gradient of a
constraint, two such differences are nested, with h = 4e-3: truncation h^4 = 3e-10, rounding 1e-16 / h^2 = 6e-12,
times the same size, and 1e-7 is asked for.
"""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from eom.assembly.algebra import dense
from eom.assembly.loads import load_stiffness, load_sums
from eom.assembly.rows import rows
from eom.assembly.vectors import skew, unit
from eom.vehicle.elements import GROUND, Bushing, Connection, Load
from tests.assembly.systems import EMPTY, PHASES, Array, X, Y, Z, assembled, body, matrix, tangent_stiffness, vector

TOLERANCE, NESTED_TOLERANCE = 1e-8, 1e-7
STEP, NESTED_STEP = 5e-4, 4e-3
Law = Callable[[Array], Array]

component = st.floats(-2.0, 2.0, allow_subnormal=False)
places = st.tuples(component, component, component)
forces = st.tuples(*[st.floats(-5.0, 5.0, allow_subnormal=False)] * 3)
axes = places.filter(lambda a: float(np.linalg.norm(a)) > 0.3)
examples = settings(max_examples=40, deadline=None, derandomize=True, phases=PHASES)
few_examples = settings(examples, max_examples=12)


def derivative(law: Law, step: float = STEP) -> Array:
    """Derivative of a vector law at zero motion, (components, 12): central differences, extrapolated once."""

    def central(column: int, h: float) -> Array:
        motion = np.zeros(12)
        motion[column] = h
        return (law(motion) - law(-motion)) / (2.0 * h)

    return np.array([(4.0 * central(k, step / 2.0) - central(k, step)) / 3.0 for k in range(12)]).T


def turned(rotation_vector: Array) -> Array:
    """Rotation matrix of a rotation vector."""
    return np.asarray(Rotation.from_rotvec(rotation_vector).as_matrix(), dtype=np.float64)


def rotation_vector(R: Array) -> Array:
    """Rotation vector of a rotation matrix."""
    return np.asarray(Rotation.from_matrix(R).as_rotvec(), dtype=np.float64)


def in_own_axes(motion: Array, centres: tuple[Array, Array], place: tuple[Array, Array], f: Array, m: Array) -> Array:
    """Wrenches (f, m) on the first body and (-f, -m) on the second, acting at two places in space.

    The moments are taken about each body's centre, and both are resolved in the body's turned axes, shape (12,).
    """
    result = []
    for end, sign in ((0, 1.0), (1, -1.0)):
        x, R = motion[6 * end : 6 * end + 3], turned(motion[6 * end + 3 : 6 * end + 6])
        arm = place[end] - (centres[end] + x)
        result += [R.T @ (sign * f), R.T @ (sign * (np.cross(arm, f) + m))]
    return np.concatenate(result)


def carried_place(motion: Array, centres: tuple[Array, Array], place: Array, end: int) -> Array:
    """Where a place that is fixed on the first (0) or second (1) body has gone."""
    x, R = motion[6 * end : 6 * end + 3], turned(motion[6 * end + 3 : 6 * end + 6])
    return np.asarray(centres[end] + x + R @ (place - centres[end]))


def line_law(centres: tuple[Array, Array], first: Array, second: Array, tension: float) -> Law:
    """A constant tension along the line between two places, each fixed on its body."""

    def law(motion: Array) -> Array:
        ends = carried_place(motion, centres, first, 0), carried_place(motion, centres, second, 1)
        f = tension * (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
        return in_own_axes(motion, centres, ends, f, np.zeros(3))

    return law


def elastic_moment(motion: Array, m: Array) -> Array:
    """Moment in space on the first body, of a potential of the relative rotation vector phi.

    The potential is -m . phi: a spring whose moment does not change with the angle, which leaves the turning
    alone. phi = log(R2' R1) changes by Q dtheta as the first body turns by dtheta in its own axes, with
    Q = 1 + S/2 + S^2/12 + ..., S = skew(phi), which is exact to fourth order.
    """
    R1, R2 = turned(motion[3:6]), turned(motion[9:12])
    S = skew(rotation_vector(R2.T @ R1))
    Q = np.eye(3) + S / 2.0 + S @ S / 12.0
    return np.asarray(R1 @ Q.T @ m)


def point_law(centres: tuple[Array, Array], place: Array, f: Array, m: Array) -> Law:
    """A force that turns with body 2 at the place on body 1; a moment that is elastic."""

    def law(motion: Array) -> Array:
        at = carried_place(motion, centres, place, 0)
        return in_own_axes(motion, centres, (at, at), turned(motion[9:12]) @ f, elastic_moment(motion, m))

    return law


def upright_law(centres: tuple[Array, Array], place: Array, f: Array, u: Array, z: Array) -> Law:
    """The same force; a moment u x z with u fixed on body 1 and z on body 2."""

    def law(motion: Array) -> Array:
        at = carried_place(motion, centres, place, 0)
        R1, R2 = turned(motion[3:6]), turned(motion[9:12])
        return in_own_axes(motion, centres, (at, at), R2 @ f, np.cross(R1 @ u, R2 @ z))

    return law


def disc_law(centres: tuple[Array, Array], radius: float, axle: Array, normal: Array, f: Array) -> Law:
    """The same force at the lowest point of a disc on body 1; ``normal`` of the plane turns with body 2."""

    def law(motion: Array) -> Array:
        R1, R2 = turned(motion[3:6]), turned(motion[9:12])
        up, a = R2 @ normal, R1 @ axle
        down = -(up - a * (a @ up))
        lowest = centres[0] + motion[:3] + radius * down / np.linalg.norm(down)
        return in_own_axes(motion, centres, (lowest, lowest), R2 @ f, np.zeros(3))

    return law


def stiffness(connection: Connection, centres: tuple[Array, Array], reactions: Array) -> Array:
    """Tangent stiffness that the kernel assembles, (12, 12)."""
    bodies = [body("first", vector(centres[0])), body("second", vector(centres[1]))]
    return tangent_stiffness(bodies, [connection], [reactions])


def two(first: tuple[float, float, float], second: tuple[float, float, float]) -> tuple[Array, Array]:
    """Two centres as arrays."""
    return np.array(first), np.array(second)


# --- each law, term by term ----------------------------------------------------------------------------------


@examples
@given(places, places, places, places, st.floats(-5.0, 5.0))
def test_a_line_pulls_along_the_line_between_its_ends(
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    a: tuple[float, float, float],
    b: tuple[float, float, float],
    tension: float,
) -> None:
    # the derivatives of 1/L grow as L shrinks: a shorter line would need a smaller step
    assume(float(np.linalg.norm(np.subtract(a, b))) > 1.0)
    centres = two(c1, c2)
    connection = Connection("line", (0, 1), (a, b), 1, line=True)
    found = stiffness(connection, centres, np.array([tension]))
    expected = -derivative(line_law(centres, np.array(a), np.array(b), tension))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=TOLERANCE)


@examples
@given(places, places, places, forces, forces)
def test_force_of_a_point_turns_with_body_2_and_its_moment_half_with_each(
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    place: tuple[float, float, float],
    f: tuple[float, float, float],
    m: tuple[float, float, float],
) -> None:
    centres = two(c1, c2)
    connection = Connection("point", (0, 1), (place, place), 3, Z, 3, Z)
    found = stiffness(connection, centres, np.array([*f, *m]))
    expected = -derivative(point_law(centres, np.array(place), np.array(f), np.array(m)))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=TOLERANCE)


@examples
@given(places, places, places, forces, forces, axes)
def test_moment_of_an_upright_connection_stays_normal_to_the_upright_axis(
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    place: tuple[float, float, float],
    f: tuple[float, float, float],
    sideways: tuple[float, float, float],
    axis: tuple[float, float, float],
) -> None:
    centres, z = two(c1, c2), unit(axis)
    u = np.array(sideways) - z * (z @ np.array(sideways))
    connection = Connection("support", (0, 1), (place, place), 3, Z, 3, Z, upright=axis)
    found = stiffness(connection, centres, np.array([*f, *np.cross(u, z)]))
    expected = -derivative(upright_law(centres, np.array(place), np.array(f), u, z))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=TOLERANCE)


def disc(
    centre: tuple[float, float, float], normal: tuple[float, float, float], ahead: tuple[float, float, float]
) -> tuple[Array, Array, Array]:
    """Unit normal of a plane, the axle of a disc that stands upright on it, and the contact for radius 0.5."""
    up = unit(normal)
    assume(float(np.linalg.norm(np.cross(up, ahead))) > 0.3)
    axle = unit(np.cross(up, ahead))
    return up, axle, np.array(centre) - 0.5 * up


@examples
@given(places, axes, axes, forces)
def test_contact_of_a_disc_rolling_on_the_ground_is_its_lowest_point(
    centre: tuple[float, float, float],
    normal: tuple[float, float, float],
    ahead: tuple[float, float, float],
    f: tuple[float, float, float],
) -> None:
    up, axle, contact = disc(centre, normal, ahead)
    place = vector(contact)
    connection = Connection("contact", (0, GROUND), (place, place), 3, Z, rolling_axis=vector(axle))
    found = tangent_stiffness([body("disc", centre)], [connection], [np.array(f)])
    law = disc_law((np.array(centre), np.zeros(3)), 0.5, axle, up, np.array(f))
    expected = -derivative(law)[:6, :6]
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=TOLERANCE)


@examples
@given(places, places, axes, axes, forces)
def test_contact_of_a_disc_rolling_on_a_body_is_its_lowest_point_there(
    centre: tuple[float, float, float],
    platform: tuple[float, float, float],
    normal: tuple[float, float, float],
    ahead: tuple[float, float, float],
    f: tuple[float, float, float],
) -> None:
    """Turning the plane about the axle moves the lowest point as turning the disc back under it would."""
    up, axle, contact = disc(centre, normal, ahead)
    centres = two(centre, platform)
    place = vector(contact)
    connection = Connection("contact", (0, 1), (place, place), 3, Z, rolling_axis=vector(axle))
    found = stiffness(connection, centres, np.array(f))
    expected = -derivative(disc_law(centres, 0.5, axle, up, np.array(f)))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=TOLERANCE)


@examples
@given(places, places, axes, axes, st.floats(-0.6, 0.6), st.floats(-100.0, 100.0))
def test_a_cambered_disc_touches_with_its_lowest_point(
    centre: tuple[float, float, float],
    platform: tuple[float, float, float],
    normal: tuple[float, float, float],
    ahead: tuple[float, float, float],
    camber: float,
    load: float,
) -> None:
    """The load acts along the plane's normal; up to 34 degrees of camber."""
    up, upright_axle, _ = disc(centre, normal, ahead)
    axle = np.cos(camber) * upright_axle + np.sin(camber) * up
    down = -unit(up - axle * (axle @ up))
    centres, place = two(centre, platform), vector(np.array(centre) + 0.5 * down)
    connection = Connection("contact", (0, 1), (place, place), 1, vector(up), rolling_axis=vector(axle))
    found = stiffness(connection, centres, np.array([load]))
    expected = -derivative(disc_law(centres, 0.5, axle, up, load * up))
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=10.0 * TOLERANCE)


@examples
@given(places, places, places, places, forces, forces, st.sampled_from(("line", "point", "upright")))
def test_ground_is_a_body_that_does_not_move(
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    a: tuple[float, float, float],
    b: tuple[float, float, float],
    f: tuple[float, float, float],
    m: tuple[float, float, float],
    kind: str,
) -> None:
    """On either end: what remains is the block of the other body, wherever ground's centre is thought to be."""
    if kind == "line":
        assume(float(np.linalg.norm(np.subtract(a, b))) > 1.0)
        connection = Connection("line", (0, 1), (a, b), 1, line=True)
        reactions = np.array(f[:1])
    else:
        upright = (0.3, -0.4, 1.2) if kind == "upright" else None
        connection = Connection("point", (0, 1), (a, a), 3, Z, 3, Z, upright=upright)
        reactions = np.array([*f, *m])
    full = stiffness(connection, two(c1, c2), reactions)
    for end, kept, centre in ((1, slice(0, 6), c1), (0, slice(6, 12), c2)):
        ends = (0, GROUND) if end == 1 else (GROUND, 0)
        found = tangent_stiffness([body("only", centre)], [connection._replace(bodies=ends)], [reactions])
        np.testing.assert_allclose(found, full[kept, kept], rtol=0.0, atol=1e-12)


@examples
@given(places, places, places, forces, forces, axes, st.sampled_from(("line", "point", "upright", "rolling")))
def test_moving_both_bodies_as_one_changes_no_force_in_body_axes(
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    a: tuple[float, float, float],
    f: tuple[float, float, float],
    m: tuple[float, float, float],
    axis: tuple[float, float, float],
    kind: str,
) -> None:
    """A connection knows only of relative motion: whatever turns and shifts both bodies alike, it turns with them.

    Exact but for rounding, some 1e-14 for numbers of this size.
    """
    reactions = np.array([*f, *m])
    connection = Connection("point", (0, 1), (a, a), 3, Z, 3, Z)
    if kind == "line":
        b = vector(np.add(a, axis))
        connection, reactions = Connection("line", (0, 1), (a, b), 1, line=True), reactions[:1]
    elif kind == "upright":
        connection = connection._replace(upright=axis)
        # an upright carries no moment about its own axis
        z = unit(axis)
        reactions[3:] -= z * (z @ reactions[3:])
    elif kind == "rolling":
        connection = connection._replace(rolling_axis=axis)
    K = stiffness(connection, two(c1, c2), reactions)
    together = np.zeros((12, 6))
    for k in range(2):
        together[6 * k : 6 * k + 3, :3] = together[6 * k + 3 : 6 * k + 6, 3:] = np.eye(3)
    together[6:9, 3:] = -skew(np.subtract(c2, c1))
    np.testing.assert_allclose(K @ together, 0.0, atol=1e-12)


@examples
@given(axes, st.integers(1, 3), st.integers(1, 3), st.integers(0, 10_000))
def test_reactions_count_along_the_directions_that_the_rows_measure(
    axis: tuple[float, float, float], n_forces: int, n_moments: int, seed: int
) -> None:
    """One reaction per row: the stiffness is that of the resultant force and moment, J' reactions."""
    generator = np.random.default_rng(seed)
    place = (0.3, -0.7, 0.2)
    bodies = [body("first", place), body("second")]
    some = Connection("some", (0, 1), (place, place), n_forces, axis, n_moments, axis)
    reactions = generator.normal(size=n_forces + n_moments)
    resultant = (rows(bodies, some).T @ reactions)[:6]  # the place is the first body's centre
    whole = Connection("all", (0, 1), (place, place), 3, Z, 3, Z)
    found = tangent_stiffness(bodies, [some], [reactions])
    np.testing.assert_allclose(found, tangent_stiffness(bodies, [whole], [resultant]), rtol=0.0, atol=1e-13)


@examples
@given(places, places, places, axes, st.floats(-5.0, 5.0))
def test_moment_of_a_torsion_spring_turns_half_with_each_body_wherever_its_ends_are(
    first: tuple[float, float, float],
    second: tuple[float, float, float],
    start: tuple[float, float, float],
    span: tuple[float, float, float],
    moment: float,
) -> None:
    centres = two(first, second)
    connection = Connection("torsion", (0, 1), (start, vector(np.add(start, span))), moments=1, moment_axis=span)
    law = point_law(centres, np.array(start), np.zeros(3), moment * unit(span))
    found = stiffness(connection, centres, np.array([moment]))
    np.testing.assert_allclose(found, -derivative(law), rtol=0.0, atol=TOLERANCE)


@examples
@given(places, places, axes, axes, forces, forces)
def test_a_full_bushing_between_opposite_loads_turns_them_as_a_point_does(
    centre: tuple[float, float, float],
    place: tuple[float, float, float],
    one: tuple[float, float, float],
    two_: tuple[float, float, float],
    f: tuple[float, float, float],
    m: tuple[float, float, float],
) -> None:
    """Whatever its matrices and their axes are: it carries what the loads leave, as action and reaction."""
    across = np.cross(one, two_)
    assume(float(np.linalg.norm(across)) > 0.1)
    centres = two(centre, (0.4, -1.0, 0.3))
    root = np.random.default_rng(0).normal(size=(6, 6))
    values = matrix(root @ root.T + np.eye(6))
    bushing = Bushing(
        Connection("bushing", (0, 1), (place, place), 3, moments=3), (one, vector(across)), values, matrix(0.0 * root)
    )
    opposite = (-np.array(f), -np.array(m))
    system = EMPTY._replace(
        bodies=(body("first", vector(centres[0])), body("second", vector(centres[1]))),
        loads=(Load("on first", 0, place, f, m), Load("on second", 1, place, vector(opposite[0]), vector(opposite[1]))),
        bushings=(bushing,),
    )
    law = point_law(centres, np.array(place), *opposite)
    # statics solves for the six loads to rounding times the condition of the matrix, 1e2
    np.testing.assert_allclose(assembled(system).K_tangent, -derivative(law), rtol=0.0, atol=TOLERANCE)


# --- loads ---------------------------------------------------------------------------------------------------


@examples
@given(places, places, forces, forces, st.sampled_from(("dead", "follower", "other")))
def test_a_load_keeps_its_direction_in_the_body_that_it_turns_with(
    centre: tuple[float, float, float],
    place: tuple[float, float, float],
    f: tuple[float, float, float],
    m: tuple[float, float, float],
    kind: str,
) -> None:
    frame = {"dead": GROUND, "follower": 0, "other": 1}[kind]
    bodies = [body("loaded", centre), body("other", (0.4, -1.0, 0.3))]
    load = Load("load", 0, place, f, m, frame)
    arm = np.subtract(place, centre)

    def law(motion: Array) -> Array:
        R = turned(motion[3:6])
        carrier = {"dead": np.eye(3), "follower": R, "other": turned(motion[9:12])}[kind]
        force, moment = R.T @ carrier @ np.array(f), R.T @ carrier @ np.array(m)
        return np.concatenate([force, np.cross(arm, force) + moment, np.zeros(6)])

    np.testing.assert_allclose(load_sums(bodies, [load])[0], law(np.zeros(12)), rtol=0.0, atol=1e-13)
    found = dense((12, 12), load_stiffness(bodies, [load]))
    np.testing.assert_allclose(found, -derivative(law), rtol=0.0, atol=TOLERANCE)
    if kind == "follower":
        np.testing.assert_array_equal(found, 0.0)


# --- joints: right where they can move -----------------------------------------------------------------------

Function = Callable[[Array, Array, Array], Array]
"""Constraint on (the vector from the place on body 2 to the place on body 1, R1, R2)."""


def normals(axis: Array) -> Array:
    """The two directions, shape (2, 3), that span the plane normal to an axis."""
    helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
    first = unit(helper - axis * (axis @ helper))
    return np.array([first, np.cross(axis, first)])


def held(directions: Array) -> Function:
    """No relative displacement along directions fixed on body 2."""
    return lambda gap, _, R2: directions @ (R2.T @ gap)


def hinged(axis: Array) -> Function:
    """An axis fixed on body 1 stays normal to two directions fixed on body 2."""
    across = np.cross(normals(axis), axis)
    return lambda _, R1, R2: (R2 @ across.T).T @ (R1 @ axis)


def no_twist(axis: Array) -> Function:
    """Constant-velocity joint: the relative rotation is a pure swing, without a part about the axis."""
    return lambda _, R1, R2: np.array([axis @ rotation_vector(R2.T @ R1)])


def no_rotation() -> Function:
    """No relative rotation at all."""
    return lambda _, R1, R2: rotation_vector(R2.T @ R1)


JOINTS: dict[str, tuple[int, int]] = {
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


def constraint_functions(n_forces: int, n_moments: int, axis: Array) -> list[Function]:
    """The joint's constraints for finite motion, in the order of its rows."""
    force: dict[int, list[Function]] = {
        0: [],
        1: [held(axis[np.newaxis])],
        2: [held(normals(axis))],
        3: [held(np.eye(3))],
    }
    moment: dict[int, list[Function]] = {0: [], 1: [no_twist(axis)], 2: [hinged(axis)], 3: [no_rotation()]}
    return force[n_forces] + moment[n_moments]


def constraint_law(centres: tuple[Array, Array], place: Array, functions: list[Function], size: int) -> Law:
    """The constraints as a function of the motion of both bodies."""

    def law(motion: Array) -> Array:
        gap = carried_place(motion, centres, place, 0) - carried_place(motion, centres, place, 1)
        R1, R2 = turned(motion[3:6]), turned(motion[9:12])
        return np.concatenate([g(gap, R1, R2) for g in functions]).reshape(size)

    return law


def slope(scalar: Callable[[float], Array]) -> Array:
    """Derivative at zero of a function of one number, by the wider step of nested differences."""

    def central(h: float) -> Array:
        return (scalar(h) - scalar(-h)) / (2.0 * h)

    return np.asarray((4.0 * central(NESTED_STEP / 2.0) - central(NESTED_STEP)) / 3.0)


def onward(motion: Array, step: Array) -> Array:
    """A motion, then a small step that is resolved in each body's turned axes."""
    total = np.zeros(12)
    for k in (0, 6):
        R = turned(motion[k + 3 : k + 6])
        total[k : k + 3] = motion[k : k + 3] + R @ step[k : k + 3]
        total[k + 3 : k + 6] = rotation_vector(R @ turned(step[k + 3 : k + 6]))
    return total


def second_variation(law: Law, multipliers: Array, v: Array, n: Array) -> float:
    """Change, as the bodies move along *n*, of the work along *v* of the constraint forces.

    The forces are the constraints' gradient times multipliers held constant; *v* is resolved in body axes.
    """

    def work(along: float) -> Array:
        return multipliers @ slope(lambda h: law(onward(along * n, h * v)))

    return float(slope(work))


@pytest.mark.parametrize("joint", JOINTS)
@few_examples
@given(places, places, places, axes, st.integers(0, 10_000))
def test_a_joint_is_right_in_every_direction_that_it_leaves_free(
    joint: str,
    c1: tuple[float, float, float],
    c2: tuple[float, float, float],
    at: tuple[float, float, float],
    axis: tuple[float, float, float],
    seed: int,
) -> None:
    """Second variation of multipliers times constraints, v' K n, for motions v and n that the joint allows.

    A change of the multipliers adds J' times it, which v' removes: only this projection has a meaning.
    """
    n_forces, n_moments = JOINTS[joint]
    size = n_forces + n_moments
    centres, a, place = two(c1, c2), unit(axis), np.array(at)
    generator = np.random.default_rng(seed)
    multipliers = generator.uniform(-5.0, 5.0, size)
    law = constraint_law(centres, place, constraint_functions(n_forces, n_moments, a), size)
    connection = Connection(joint, (0, 1), (at, at), n_forces, axis, n_moments, axis)
    bodies = [body("first", c1), body("second", c2)]
    J = rows(bodies, connection)
    np.testing.assert_allclose(derivative(law), J, rtol=0.0, atol=TOLERANCE)

    K = tangent_stiffness(bodies, [connection], [multipliers])
    N = np.linalg.svd(J)[2][size:].T
    for _ in range(4):
        v, n = N @ generator.uniform(-1.0, 1.0, 12 - size), N @ generator.uniform(-1.0, 1.0, 12 - size)
        expected = -second_variation(law, multipliers, v, n)
        np.testing.assert_allclose(v @ K @ n, expected, rtol=0.0, atol=NESTED_TOLERANCE)


def test_an_upright_hinge_is_the_same_hinge() -> None:
    """Which way the moment of a hinge is thought to turn makes no difference to what the hinge leaves free."""
    bodies = [body("first", (1.0, 0.2, 0.3)), body("second", (-0.5, 0.4, 0.1))]
    place = (0.2, 0.1, 0.9)
    hinge = Connection("hinge", (0, 1), (place, place), 3, Y, 2, Y)
    multipliers = np.array([1.0, -2.0, 3.0, 0.5, -1.5])
    N = np.linalg.svd(rows(bodies, hinge))[2][5:].T
    half, upright = (
        N.T @ tangent_stiffness(bodies, [item], [multipliers]) @ N for item in (hinge, hinge._replace(upright=Y))
    )
    np.testing.assert_allclose(upright, half, rtol=0.0, atol=1e-13)


def test_bodies_elsewhere_in_the_list_get_the_same_stiffness() -> None:
    """Only the columns of the two bodies that meet are filled."""
    bodies = [body("first", (1.0, 0.2, 0.3)), body("idle", (3.0, 3.0, 3.0)), body("second", (-0.5, 0.4, 0.1))]
    place = (0.2, 0.1, 0.9)
    connection = Connection("bushing", (2, 0), (place, place), 3, X, 3, X)
    preload = np.array([1.0, -2.0, 3.0, 0.5, -1.5, 0.7])
    found = tangent_stiffness(bodies, [connection], [preload])
    alone = tangent_stiffness([bodies[2], bodies[0]], [connection._replace(bodies=(0, 1))], [preload])
    order = [*range(12, 18), *range(6)]
    np.testing.assert_array_equal(found[np.ix_(order, order)], alone)
    found[np.ix_(order, order)] = 0.0
    np.testing.assert_array_equal(found, 0.0)
