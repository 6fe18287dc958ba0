"""From full coordinates to states: constraints solved, dampers and inputs acting on what they really feel.

The vehicle here is a truck and trailer in the yaw plane, small enough to be derived by Lagrange's equations on
half a page. Tolerances: matrices agree to 1e-11 of their size, transfer functions and simple roots to 1e-9.
"""

from typing import NamedTuple

import numpy as np
import pytest

from eom.assembly.reduction import complement
from eom.vehicle.elements import (
    GROUND,
    Connection,
    Constraint,
    Elastic,
    Input,
    Output,
    Slip,
    System,
)
from tests.assembly.systems import (
    EMPTY,
    ZERO,
    Array,
    Complex,
    X,
    Y,
    Z,
    assembled,
    body,
    diagonal,
    eigenvalues,
    line,
    linear,
    measure,
    model_with,
    nonzero,
    pivots_of,
    point,
    push,
    spring,
    state_space_of,
    transfer,
    turn,
)

FREQUENCIES = 1j * np.array([0.1, 0.7, 3.0, 12.0])


class Train(NamedTuple):
    """Truck and trailer in the yaw plane; places are distances [m] ahead of the truck's centre of mass."""

    U: float = 20.0
    m1: float = 8000.0
    I1: float = 4e4
    front: float = 2.0
    rear: float = -1.8
    C_front: float = 2e5
    C_rear: float = 4e5
    hitch: float = -2.9
    m2: float = 9000.0
    I2: float = 5e4
    centre: float = -7.6
    axle: float = -8.2
    C_axle: float = 3e5
    k: float = 1e5
    c: float = 2e4


PLANE = Constraint(point((0, GROUND), ZERO, forces=1, moments=2, axis=Z, name="road"))


def flat(index: int, x: float) -> Constraint:
    """Holds a body's height, roll and pitch."""
    return Constraint(point((index, GROUND), (x, 0.0, 0.0), forces=1, moments=2, axis=Z, name=f"road {index}"))


def axle(index: int, x: float, stiffness: float, U: float) -> Slip:
    """Tyres: their force is minus cornering stiffness times the angle of the sliding velocity."""
    return Slip(point((index, GROUND), (x, 0.0, 0.0), forces=1, axis=Y, name=f"axle {x}"), ((stiffness / U,),))


def hitch_place(train: Train) -> tuple[float, float, float]:
    """Where truck and trailer meet."""
    return (train.hitch, 0.0, 0.0)


def system_of(train: Train, *, pinned: bool = False) -> System:
    """Truck and trailer at speed; the hitch is a spring and damper sideways, or a pin."""
    velocity = (train.U, 0.0, 0.0)
    truck = body("truck", ZERO, train.m1, diagonal(1e4, 3e4, train.I1), velocity)
    trailer = body("trailer", (train.centre, 0.0, 0.0), train.m2, diagonal(1e4, 3e4, train.I2), velocity)
    speed = Constraint(point((0, GROUND), ZERO, forces=1, axis=X, name="speed"), moving=True)
    tow = Constraint(point((0, 1), hitch_place(train), forces=1, axis=X, name="drawbar"))
    sideways = point((0, 1), hitch_place(train), forces=1, axis=Y, name="hitch")
    system = EMPTY._replace(
        bodies=(truck, trailer),
        constraints=(flat(0, 0.0), flat(1, train.centre), speed, tow),
        slip=(
            axle(0, train.front, train.C_front, train.U),
            axle(0, train.rear, train.C_rear, train.U),
            axle(1, train.axle, train.C_axle, train.U),
        ),
        # steering the front axle to the left pushes it to the left
        inputs=(push(0, (train.front, 0.0, 0.0), Y, "steer", train.C_front),),
    )
    if pinned:
        return system._replace(constraints=(*system.constraints, Constraint(sideways)))
    return system._replace(elastic=(spring(sideways, train.k, train.c),))


def lagrange(train: Train, *, pinned: bool = False) -> tuple[Array, Array]:
    """First-order matrix and input column of the train, with coordinates (y1, psi1, y2, psi2) in inertial axes.

    There the trim is rest: kinetic energy is m y'^2/2 + I psi'^2/2 of each body. A tyre at distance a slides
    sideways by y' + a psi' - U psi. The hitch stretches by e = (y1 + h1 psi1) - (y2 + h2 psi2), of which the
    spring feels e and the damper e' = de/dt, as any damper does that is fixed to two moving bodies. With a pin,
    e = 0 removes y2.
    """
    t = train
    mass = np.diag([t.m1, t.I1, t.m2, t.I2])
    damping, stiffness = np.zeros((4, 4)), np.zeros((4, 4))
    for first, arm, C in (
        (0, t.front, t.C_front),
        (0, t.rear, t.C_rear),
        (2, t.axle - t.centre, t.C_axle),
    ):
        place, heading = np.zeros(4), np.zeros(4)
        place[first : first + 2] = 1.0, arm
        heading[first + 1] = 1.0
        damping += C / t.U * np.outer(place, place)
        stiffness -= C * np.outer(place, heading)
    force = np.array([t.C_front, t.front * t.C_front, 0.0, 0.0])
    stretch = np.array([1.0, t.hitch, -1.0, -(t.hitch - t.centre)])
    if pinned:
        free = np.zeros((4, 3))
        free[[0, 1, 3], [0, 1, 2]] = 1.0
        free[2] = stretch[[0, 1, 3]]
        mass, damping, stiffness = (free.T @ matrix @ free for matrix in (mass, damping, stiffness))
        force = free.T @ force
    else:
        stiffness += t.k * np.outer(stretch, stretch)
        damping += t.c * np.outer(stretch, stretch)
    n = len(mass)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]])
    return A, np.concatenate([np.zeros(n), np.linalg.solve(mass, force)])


def roots(A: Array) -> Complex:
    """Roots of a matrix without the double zero of position and heading, which rounding of 1e-16 makes 1e-7."""
    return nonzero(np.linalg.eigvals(A).astype(np.complex128), 1e-5)


# --- complements ---------------------------------------------------------------------------------------------


def test_the_complement_annihilates_the_constraints_and_is_an_identity_on_what_stays_free() -> None:
    generator = np.random.default_rng(1)
    J = generator.normal(size=(3, 8))
    independent, T, _ = complement(J, (1, 4, 6))
    assert independent.tolist() == [0, 2, 3, 5, 7]
    np.testing.assert_array_equal(T[independent], np.eye(5))
    np.testing.assert_allclose(J @ T, 0.0, atol=1e-13)


@pytest.mark.parametrize("pinned", [False, True])
def test_displacements_and_velocities_of_the_states_satisfy_every_constraint(pinned: bool) -> None:
    """J T = 0; and J dp/dt = J (w - V p) = 0 for w = W n + Z q, whatever n and q are."""
    system = system_of(Train(), pinned=pinned)
    found = linear(system)
    m, r = found.matrices, found.matrices.reduction
    size = np.max(np.abs(m.V))
    np.testing.assert_allclose(m.J @ r.T, 0.0, atol=1e-12)
    np.testing.assert_allclose(m.J @ r.W, 0.0, atol=1e-12)
    np.testing.assert_allclose(m.J @ (r.Z - m.V @ r.T), 0.0, atol=1e-12 * size)


def rolling_disc(U: float = 2.0) -> System:
    """A disc of 1 kg and radius 0.3 m rolls upright and does not slide."""
    r = 0.3
    contact = Connection("contact", (0, GROUND), (ZERO, ZERO), 1, Z, rolling_axis=Y)
    disc = body("disc", (0.0, 0.0, r), 1.0, diagonal(r**2 / 4, r**2 / 2, r**2 / 4), (U, 0.0, 0.0), (0.0, U / r, 0.0))
    return EMPTY._replace(
        bodies=(disc,),
        gravity=(0.0, 0.0, -9.81),
        constraints=(Constraint(contact),),
        rolling=(point((0, GROUND), ZERO, forces=2, axis=Z, name="rolling"),),
    )


def test_rolling_removes_velocities_and_leaves_displacements() -> None:
    """Jn w = 0 for all states, with one velocity less for each of its rows and no displacement less."""
    found = linear(rolling_disc())
    m, r = found.matrices, found.matrices.reduction
    assert (len(r.independent), len(r.independent_velocities)) == (5, 3)
    np.testing.assert_allclose(m.Jn @ r.W, 0.0, atol=1e-13)
    np.testing.assert_allclose(m.Jn @ r.Z, 0.0, atol=1e-12)
    np.testing.assert_allclose(m.J @ (r.Z - m.V @ r.T), 0.0, atol=1e-12)


# --- dampers between moving bodies ---------------------------------------------------------------------------


@pytest.mark.parametrize("U", [5.0, 20.0, 35.0])
@pytest.mark.parametrize("pinned", [False, True])
def test_truck_and_trailer_have_the_roots_of_their_lagrange_equations(U: float, pinned: bool) -> None:
    """Above all with the damper in the hitch, which acts on the rate of displacement and not on body-axis velocity."""
    train = Train(U=U)
    found = linear(system_of(train, pinned=pinned))
    expected = roots(lagrange(train, pinned=pinned)[0])
    assert len(expected) == (4 if pinned else 6)
    np.testing.assert_allclose(roots(found.model.A), expected, rtol=1e-9)


def test_a_hitch_damper_on_body_axis_velocity_would_be_noticed() -> None:
    """The term that makes the difference, H' c H V in the stiffness, shifts the slowest pair by far more than 1e-9."""
    train = Train()
    system = system_of(train)
    m, pivots = assembled(system), pivots_of(system)
    wrong = state_space_of(system, m._replace(K=m.K - m.K_damper), pivots)
    distance = np.abs(roots(wrong.A)[:, np.newaxis] - roots(lagrange(train)[0]))
    assert np.max(np.min(distance, axis=1)) > 0.1


def test_steering_moves_truck_and_trailer_as_their_lagrange_equations_say() -> None:
    """Sideways position of either body over steer, at several frequencies."""
    train = Train()
    outputs = (measure(0, ZERO, Y), measure(1, (train.centre, 0.0, 0.0), Y))
    found = linear(system_of(train)._replace(outputs=outputs))
    A, b = lagrange(train)
    for s in FREQUENCIES:
        expected = np.linalg.solve(s * np.eye(8) - A, b)[[0, 2]]
        np.testing.assert_allclose(transfer(found.model, s)[:, 0], expected, rtol=1e-9)


# --- accelerations -------------------------------------------------------------------------------------------


def with_motion_outputs(train: Train) -> System:
    """Position, velocity, acceleration of two places, one on the pinned trailer, and both frames."""
    places = ((0, (1.0, 0.4, 0.0)), (1, (train.axle, -0.3, 0.0)))
    outputs = tuple(
        measure(index, place, Y, quantity, frame)
        for index, place in places
        for quantity, frame in (
            ("position", "inertial"),
            ("velocity", "inertial"),
            ("acceleration", "inertial"),
            ("velocity", "body"),
            ("acceleration", "body"),
        )
    )
    return system_of(train, pinned=True)._replace(outputs=outputs)


def test_acceleration_is_the_second_derivative_of_position_constraint_reactions_included() -> None:
    """s^2 times the transfer function of position; and s times that of velocity, in either frame."""
    model = linear(with_motion_outputs(Train())).model
    for s in FREQUENCIES:
        for position, velocity, acceleration, body_velocity, body_acceleration in transfer(model, s)[:, 0].reshape(
            2, 5
        ):
            np.testing.assert_allclose(velocity, s * position, rtol=1e-9)
            np.testing.assert_allclose(acceleration, s**2 * position, rtol=1e-9)
            np.testing.assert_allclose(body_acceleration, s * body_velocity, rtol=1e-9)


def test_acceleration_answers_a_steer_step_at_once_on_both_sides_of_a_pin() -> None:
    """The push passes through the pin: both centres accelerate by their share of the three-coordinate mass matrix."""
    train = Train()
    outputs = (
        measure(0, ZERO, Y, "acceleration"),
        measure(1, (train.centre, 0.0, 0.0), Y, "acceleration"),
    )
    model = linear(system_of(train, pinned=True)._replace(outputs=outputs)).model
    b = lagrange(train, pinned=True)[1][3:]
    trailer = b @ [1.0, train.hitch, -(train.hitch - train.centre)]
    np.testing.assert_allclose(model.D[:, 0], [b[0], trailer], rtol=1e-11)


def test_in_a_steady_turn_every_unit_has_the_centripetal_acceleration_u_r() -> None:
    """Steady yaw rate per steer is the same for both units, and their inertial acceleration is U times it."""
    train = Train()
    outputs = (
        turn(0, Z, "velocity", "body"),
        turn(1, Z, "velocity", "body"),
        measure(0, ZERO, Y, "acceleration"),
        measure(1, (train.centre, 0.0, 0.0), Y, "acceleration"),
    )
    system = system_of(train, pinned=True)._replace(outputs=outputs)
    found = linear(system)
    kept = np.setdiff1d(np.arange(len(found.model.A)), found.pivots.cyclic)
    A, B, C, D = found.model
    steady = D - C[:, kept] @ np.linalg.solve(A[np.ix_(kept, kept)], B[kept])
    r1, r2, a1, a2 = steady[:, 0]
    assert r1 > 0.0
    np.testing.assert_allclose([r2, a1, a2], [r1, train.U * r1, train.U * r1], rtol=1e-9)


# --- inputs that act through their rate ----------------------------------------------------------------------

M_S, M_U, K_S, C_S, K_T, C_T = 300.0, 40.0, 2e4, 1500.0, 2e5, 50.0


def quarter_car(*outputs: Output) -> System:
    """Two masses on a road that moves the far end of the tyre's spring and damper."""
    masses = (body("sprung", (0.0, 0.0, 0.6), M_S), body("unsprung", (0.0, 0.0, 0.3), M_U))
    guides = tuple(
        Constraint(point((k, GROUND), item.centre, forces=2, moments=3, axis=Z)) for k, item in enumerate(masses)
    )
    contact = point((1, GROUND), ZERO, forces=1, axis=Z, name="tyre")
    return EMPTY._replace(
        bodies=masses,
        gravity=(0.0, 0.0, -9.81),
        constraints=guides,
        elastic=(
            spring(line((1, 0), masses[1].centre, masses[0].centre), K_S, C_S),
            Elastic(contact, (K_T, 0.0), (C_T, 0.0)),
        ),
        inputs=(Input("road", "m", contact, (K_T,), (C_T,)),),
        outputs=outputs,
    )


def test_a_road_that_moves_spring_and_damper_gives_the_quarter_car_of_the_textbooks() -> None:
    """Sprung motion per road, G = (k_t + c_t s)(k_s + c_s s) / [..]; its acceleration is s^2 G."""
    system = quarter_car(
        measure(0, ZERO, Z),
        measure(0, ZERO, Z, "velocity"),
        measure(0, ZERO, Z, "acceleration"),
        measure(1, ZERO, Z),
        measure(1, ZERO, Z, "velocity"),
    )
    model = linear(system).model
    for s in FREQUENCIES * 10.0:
        suspension, tyre = K_S + C_S * s, K_T + C_T * s
        sprung = M_S * s**2 + suspension
        bottom = sprung * (M_U * s**2 + suspension + tyre) - suspension**2
        z_s, z_u = tyre * suspension / bottom, tyre * sprung / bottom
        expected = [z_s, s * z_s, s**2 * z_s, z_u, s * z_u]
        np.testing.assert_allclose(transfer(model, s)[:, 0], expected, rtol=1e-9)


def test_a_step_of_the_road_gives_the_unsprung_mass_a_jump_of_velocity() -> None:
    """The damper's impulse c_t u / m_u is direct feedthrough of velocity; the sprung mass feels none of it at once."""
    model = linear(quarter_car(measure(1, ZERO, Z, "velocity"), measure(0, ZERO, Z, "velocity"))).model
    np.testing.assert_allclose(model.D[:, 0], [C_T / M_U, 0.0], rtol=1e-13, atol=1e-13)


def test_an_acceleration_that_would_need_the_rate_of_an_input_is_refused_by_name() -> None:
    """A step of the road would give the unsprung mass an infinite acceleration."""
    refused = measure(1, ZERO, Z, "acceleration", name="hub_acceleration")
    with pytest.raises(ValueError, match=r"hub_acceleration .* rate of input road"):
        linear(quarter_car(refused))
    without_damper = quarter_car(refused)
    contact = without_damper.inputs[0].connection
    linear(without_damper._replace(inputs=(Input("road", "m", contact, (K_T,), (0.0,)),)))


# --- motions that change nothing -----------------------------------------------------------------------------


@pytest.mark.parametrize("pinned", [False, True])
def test_position_and_heading_on_the_road_have_columns_of_exact_zeros(pinned: bool) -> None:
    """Sideways position and heading only lead into one another: two roots are zero to the last bit."""
    found = linear(system_of(Train(), pinned=pinned))
    cyclic = np.array(found.pivots.cyclic)
    assert found.pivots.cyclic_motions == (1, 5)
    A = found.model.A
    others = np.setdiff1d(np.arange(len(A)), cyclic)
    np.testing.assert_array_equal(A[np.ix_(others, cyclic)], 0.0)
    inner = A[np.ix_(cyclic, cyclic)]
    np.testing.assert_array_equal(inner @ inner, 0.0)
    assert np.count_nonzero(np.linalg.eigvals(A) == 0.0) == 2


def test_the_angle_of_a_rolling_disc_and_its_place_on_the_plane_are_exact_zeros() -> None:
    """Place ahead and sideways, heading and turn of the wheel: four displacements of five."""
    found = linear(rolling_disc())
    cyclic = np.array(found.pivots.cyclic)
    assert len(cyclic) == 4
    A = found.model.A
    others = np.setdiff1d(np.arange(len(A)), cyclic)
    np.testing.assert_array_equal(A[np.ix_(others, cyclic)], 0.0)
    np.testing.assert_array_equal(np.linalg.eigvals(A[np.ix_(cyclic, cyclic)]), 0.0)


def test_a_free_body_in_space_has_six_motions_that_change_nothing() -> None:
    found = linear(EMPTY._replace(bodies=(body("body"),)))
    assert len(found.pivots.cyclic) == 6
    np.testing.assert_array_equal(eigenvalues(found.model), np.zeros(12))


def test_a_spring_to_the_ground_makes_position_count() -> None:
    system = EMPTY._replace(
        bodies=(body("block"),), elastic=(spring(point((0, GROUND), ZERO, forces=1, axis=Y), 10.0),)
    )
    found = linear(system)
    assert found.pivots.cyclic_motions == (0, 2, 3, 4, 5)
    np.testing.assert_allclose(eigenvalues(found.model)[[0, -1]], [-1j * np.sqrt(10.0), 1j * np.sqrt(10.0)], atol=1e-12)


def test_outputs_of_cyclic_coordinates_are_kept_and_those_of_relative_motion_do_not_see_them() -> None:
    """Heading follows the cyclic coordinate; articulation has an exact zero there."""
    train = Train()
    articulation = Output(
        "articulation", "rad", "position", "inertial", ((1.0, point((0, 1), ZERO, moments=1, axis=Z)),)
    )
    found = linear(system_of(train, pinned=True)._replace(outputs=(turn(1, Z), articulation)))
    cyclic = np.array(found.pivots.cyclic)
    np.testing.assert_allclose(found.model.C[0, cyclic], [0.0, 1.0], atol=1e-13)
    np.testing.assert_array_equal(found.model.C[1, cyclic], 0.0)


# --- redundant constraints -----------------------------------------------------------------------------------


def loaded_pendulum(copies: int) -> System:
    """Two arms on hinges, each hinge made *copies* times, under their weight."""
    arms = (
        body("upper", (0.5, 0.1, 0.0), 2.0, diagonal(0.1, 0.3, 0.3)),
        body("lower", (1.5, 0.1, -0.2), 1.0, diagonal(0.1, 0.2, 0.2)),
    )
    shoulder = Constraint(point((0, GROUND), ZERO, forces=3, moments=2, axis=Y, name="shoulder"))
    elbow = Constraint(point((1, 0), (1.0, 0.0, 0.0), forces=3, moments=2, axis=Y, name="elbow"))
    springs = (
        spring(line((0, GROUND), (1.0, 0.0, 0.0), (1.0, 0.0, 2.0)), 100.0, 1.0),
        spring(line((1, GROUND), (2.0, 0.0, 0.0), (2.0, 0.3, 2.0)), 50.0, 2.0),
    )
    return EMPTY._replace(
        bodies=arms,
        gravity=(0.0, 0.0, -9.81),
        constraints=(shoulder,) * copies + (elbow,) * copies,
        elastic=springs,
        inputs=(push(1, (2.0, 0.0, 0.0), Z),),
        outputs=(measure(1, (2.0, 0.0, 0.0), Z, "acceleration"),),
    )


@pytest.mark.parametrize("copies", [2, 3])
def test_doubled_joints_change_no_root_and_no_transfer_function(copies: int) -> None:
    """Redundant rows are left out of the pivots; the reactions that they share load the geometry as one joint does."""
    once, often = linear(loaded_pendulum(1)), linear(loaded_pendulum(copies))
    assert len(often.matrices.J) == copies * len(once.matrices.J)
    assert len(often.pivots.rows) == len(once.pivots.rows) == 10
    np.testing.assert_allclose(eigenvalues(often.model), eigenvalues(once.model), rtol=1e-9)
    for s in FREQUENCIES:
        np.testing.assert_allclose(transfer(often.model, s), transfer(once.model, s), rtol=1e-9)


def test_a_rolling_condition_said_twice_removes_nothing_more() -> None:
    system = rolling_disc()
    expected = eigenvalues(linear(system).model)
    found = linear(system._replace(rolling=system.rolling * 2))
    assert len(found.pivots.rolling_rows) == 2
    np.testing.assert_allclose(eigenvalues(found.model), expected, atol=1e-12)


def test_a_rolling_condition_that_contradicts_a_joint_is_refused() -> None:
    """A disc whose contact is held sideways by a joint cannot turn: rolling would move it sideways by U times heading.

    Of the two rows the joint's is kept, and the rolling one, which depends on it, still says that heading is zero.
    """
    system = rolling_disc()
    rail = Constraint(point((0, GROUND), ZERO, forces=1, axis=Y, name="rail"))
    with pytest.raises(ValueError, match="rolling"):
        linear(system._replace(constraints=(*system.constraints, rail)))


# --- pivots chosen once --------------------------------------------------------------------------------------


def rod(angle: float) -> System:
    """A body that only translates in the x-z plane, on a rod towards *angle* above x."""
    end = (float(np.cos(angle)), 0.0, float(np.sin(angle)))
    attitude = Constraint(point((0, GROUND), ZERO, forces=1, moments=3, axis=Y))
    spring_x = spring(point((0, GROUND), ZERO, forces=1, axis=X), 30.0)
    spring_z = spring(point((0, GROUND), ZERO, forces=1, axis=Z), 70.0)
    return EMPTY._replace(
        bodies=(body("block"),),
        constraints=(attitude, Constraint(line((0, GROUND), ZERO, end))),
        elastic=(spring_x, spring_z),
    )


def test_pivots_chosen_once_serve_other_numbers() -> None:
    """At any angle where they still determine what they should, the roots are those of freshly chosen ones."""
    chosen = pivots_of(rod(0.3))
    for angle in (0.0, 0.2, 0.9, 1.4):
        system = rod(angle)
        kept = model_with(system, chosen)
        np.testing.assert_allclose(eigenvalues(kept), eigenvalues(linear(system).model), rtol=1e-9, atol=1e-9)
        # along the rod's normal (-sin, cos) the stiffness is 30 sin^2 + 70 cos^2
        stiffness = 30.0 * np.sin(angle) ** 2 + 70.0 * np.cos(angle) ** 2
        np.testing.assert_allclose(np.max(eigenvalues(kept).imag), np.sqrt(stiffness), rtol=1e-9)


def test_pivots_that_have_become_singular_are_refused() -> None:
    """A rod along x determines x; upright it says nothing of x."""
    system = rod(np.pi / 2.0)
    with pytest.raises(ValueError, match="no longer determine the chosen dependent coordinates"):
        model_with(system, pivots_of(rod(0.0)))


def test_a_motion_that_no_longer_changes_nothing_is_refused() -> None:
    """Pivots of a train on a plane, used for one that a spring ties to the ground."""
    system = system_of(Train())
    tied = system._replace(elastic=(*system.elastic, spring(point((0, GROUND), ZERO, forces=1, axis=Y), 1e4)))
    with pytest.raises(ValueError, match="no longer does"):
        model_with(tied, pivots_of(system))


def test_pivots_keep_the_first_body_and_its_heading() -> None:
    """People steer by the truck: its sideways position, heading and their rates are states."""
    found = linear(system_of(Train(), pinned=True))
    reduction = found.matrices.reduction
    assert {1, 5} <= set(reduction.independent.tolist())
    assert reduction.independent.tolist() == reduction.independent_velocities.tolist()
    assert len(reduction.independent) == 3


@pytest.mark.parametrize("speed", [0.0, 5.0])
def test_a_structure_that_cannot_move_has_no_states(speed: float) -> None:
    """A body welded to the frame that moves along with the trim: outputs are zero, and nothing fails."""
    weld = Constraint(point((0, GROUND), ZERO, forces=3, moments=3), moving=True)
    system = EMPTY._replace(
        bodies=(body("block", velocity=(speed, 0.0, 0.0)),),
        constraints=(weld,),
        inputs=(push(0, ZERO, X),),
        outputs=(measure(0, ZERO, X), measure(0, ZERO, X, "acceleration")),
    )
    model = linear(system).model
    assert model.A.shape == (0, 0)
    np.testing.assert_array_equal(model.D, np.zeros((2, 1)))
