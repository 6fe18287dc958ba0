"""The linear model against Lagrange's equations of finite motion, differentiated exactly.

Tolerance: 1e-9 of the size of what is compared. The derivatives of the referee are exact, so that what is left is
rounding: 6e-13 at most in 210 random systems. Characteristic polynomials are compared instead of roots, which
rounding spreads where they coincide; two different ones do not agree at points chosen without regard to them.
"""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import eom
from eom.assembly.state_space import StateSpace
from eom.assembly.statics import Statics
from eom.vehicle.elements import Bushing, System
from tests.assembly.random_systems import Recipe, build, in_equilibrium, recipes
from tests.assembly.systems import PHASES, Array, characteristic, linear, point, state_space_of, vector
from tests.referees.elimination import Spatial
from tests.referees.jets import reciprocal, rotation, sqrt, variables
from tests.referees.small_vehicles import CAR, CRANE, HALF_CAR, RELAXATION, TRIANGLE, TRUCK_TRAILER
from tests.referees.spatial import linearise
from tests.vehicles.shipped import LINEAR, vehicle

RELATIVE = 1e-9
POINTS = (1.0 + 2.0j, 4.0 - 7.0j, 10.0 + 20.0j)


def assert_same(model: eom.LinearModel | StateSpace, referee: Spatial) -> None:
    """Same number of states, same characteristic polynomial, same transfer functions."""
    A = referee.A()
    assert model.A.shape == A.shape
    for s in POINTS:
        np.testing.assert_allclose(characteristic(model.A, s), characteristic(A, s), rtol=RELATIVE)
        found = model.C @ np.linalg.solve(s * np.eye(len(A)) - model.A, model.B.astype(complex)) + model.D
        expected = referee.transfer(s)
        # an output that answers nothing has rounding alone
        scale = np.max(np.abs(expected), axis=1, keepdims=True, initial=0.0) + 1e-5 * np.max(np.abs(expected))
        assert np.all(np.abs(found - expected) <= RELATIVE * scale)


def open_preloads(statics: Statics) -> tuple[Array, Array] | None:
    """The model's own preloads where statics alone does not give them, else none: the referee then solves them."""
    return None if statics.determinate else (statics.reactions, statics.tensions)


# --- the referee itself --------------------------------------------------------------------------------------


def test_jets_have_the_derivatives_of_calculus() -> None:
    """Of sqrt(1 + x y) / (2 + x): value, gradient and Hessian at zero by hand."""
    x, y = variables(2)
    f = sqrt(1.0 + x * y) * reciprocal(2.0 + x)
    np.testing.assert_allclose(f.value, 0.5)
    np.testing.assert_allclose(f.gradient, [-0.25, 0.0])
    np.testing.assert_allclose(f.hessian, [[0.25, 0.25], [0.25, 0.0]])


def test_rotation_of_jets_is_a_rotation_whose_rate_is_its_angular_velocity() -> None:
    """R'R = 1 to second order, and S(omega) = R' dR/dt to first order for constant theta' (exact chain rule)."""
    free = variables(6)
    R, rate = rotation(np.array(free[:3], dtype=object))
    for row, expected in zip(R.T @ R, np.eye(3), strict=True):
        for jet, value in zip(row, expected, strict=True):
            np.testing.assert_allclose(jet.value, value)
            np.testing.assert_allclose(jet.hessian, 0.0, atol=1e-15)
    omega = rate @ np.array(free[3:], dtype=object)
    for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0))):
        # d/dt of R_ij is its gradient times theta'; entry (i, j) of R' dR/dt, first order in theta
        found = np.zeros((3, 3))
        for m in range(3):
            found += R[m, i].value * R[m, j].hessian[:3, :3] + np.outer(R[m, i].gradient[:3], R[m, j].gradient[:3])
        np.testing.assert_allclose(omega[k].hessian[:3, 3:], found, atol=1e-15)


# --- dampers act on the rate of displacement -----------------------------------------------------------------


@pytest.mark.parametrize("U", [0.0, 10.0, 30.0])
def test_a_car_bounces_and_pitches_at_speed_as_finite_motion_says(U: float) -> None:
    car = eom.loads(CAR, U=U)
    assert_same(eom.linearise(car), linearise(car.system))


def test_bounce_and_pitch_do_not_depend_on_speed() -> None:
    """Nothing of the referee's equations does: springs and dampers of a moving body are those of a body at rest."""
    still, fast = (linearise(eom.loads(CAR, U=U).system) for U in (0.0, 30.0))
    np.testing.assert_allclose(fast.C, still.C, atol=1e-9)
    np.testing.assert_allclose(fast.K, still.K, atol=1e-9)


@pytest.mark.parametrize("U", [10.0, 30.0])
def test_a_half_car_on_tyre_dampers_moves_as_finite_motion_says(U: float) -> None:
    car = eom.loads(HALF_CAR, U=U)
    assert_same(eom.linearise(car), linearise(car.system))


def test_a_truck_and_trailer_with_a_damped_hitch_move_as_finite_motion_says() -> None:
    car = eom.loads(TRUCK_TRAILER)
    assert_same(eom.linearise(car), linearise(car.system))


@pytest.mark.parametrize("text", [CAR, HALF_CAR, TRUCK_TRAILER])
def test_dampers_on_body_axis_velocity_would_be_noticed(text: str) -> None:
    """Leaving out the stiffness -H'cHV that belongs to them is no rounding error."""
    car = eom.loads(text)
    found = linear(car.system)
    wrong = found.matrices._replace(K=found.matrices.K - found.matrices.K_damper)
    A, right = state_space_of(car.system, wrong, found.pivots).A, linearise(car.system).A()
    s = POINTS[0]
    assert abs(characteristic(A, s) / characteristic(right, s) - 1.0) > 1e4 * RELATIVE


# --- accelerations contain what joints do --------------------------------------------------------------------


def test_acceleration_of_bodies_on_joints_is_that_of_finite_motion() -> None:
    crane = eom.loads(CRANE)
    model = eom.linearise(crane)
    assert_same(model, linearise(crane.system))
    # a push meets the trolley and a quarter of the bar; the bar's tip starts backward by half of that
    at_once = 1.0 / (3.0 + 4.0 / 4.0)
    np.testing.assert_allclose(model.D[:, 0], [at_once, -0.5 * at_once], rtol=1e-12)


# --- spin, preloads, everything ------------------------------------------------------------------------------


def test_a_preloaded_loop_is_as_stiff_as_finite_motion_says() -> None:
    triangle = eom.loads(TRIANGLE)
    assert_same(eom.linearise(triangle), linearise(triangle.system))


def test_motions_without_mass_follow_their_forces_as_finite_motion_says() -> None:
    """Contact patches between a spring and slip: one state each, instead of two."""
    car = eom.loads(RELAXATION)
    assert_same_without_mass(eom.linearise(car), linearise(car.system))


def assert_same_without_mass(model: eom.LinearModel, referee: Spatial) -> None:
    """Same transfer functions, and every root one of the referee's pencil, which has more states than the model."""
    for s in POINTS:
        found = model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B.astype(complex)) + model.D
        expected = referee.transfer(s)
        size = np.max(np.abs(expected), axis=1, keepdims=True)
        np.testing.assert_allclose(found / size, expected / size, rtol=0.0, atol=RELATIVE)
    for root in model.modes().eigenvalues:
        sizes = np.linalg.svd(referee.pencil(root), compute_uv=False)
        assert sizes[-1] < RELATIVE * sizes[0]


# beams and membranes are no law of finite motion
FINITE = [name for name in LINEAR if not (vehicle(name).system.beams or vehicle(name).system.triangles)]


@pytest.mark.parametrize("name", FINITE)
def test_shipped_vehicles_move_as_finite_motion_says(name: str) -> None:
    """Among them the rolling disc and the bicycle, whose wheels spin and roll without slipping."""
    car = vehicle(name)
    assembly = eom.assemble(car)
    model, referee = eom.linearise(car), linearise(car.system, open_preloads(assembly.matrices.statics))
    massless = assembly.pivots.damped or assembly.pivots.static
    (assert_same_without_mass if massless else assert_same)(model, referee)


@pytest.mark.parametrize("U", [0.3, 1.0, 4.0])
def test_a_rolling_disc_leans_as_finite_motion_says(U: float) -> None:
    disc = vehicle("disc", U=U)
    assert_same(eom.linearise(disc), linearise(disc.system))


examples = settings(
    max_examples=40,
    deadline=None,
    derandomize=True,
    phases=PHASES,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)


def judge(system: System) -> None:
    """Compares a system of elements with the referee."""
    found = linear(system)
    assert_same(found.model, linearise(system, open_preloads(found.matrices.statics)))


@examples
@given(recipes(linear=False, massless=False))
def test_random_systems_move_as_finite_motion_says(recipe: Recipe) -> None:
    """Trees and loops with every joint, bushings, supports, preloads, loads of all kinds, tyres, wheels that roll."""
    judge(build(recipe))


def enriched(system: System, seed: int) -> System:
    """The system with inerters, springs of given preload, fluid at its tyres, and a bushing of full matrices."""
    numbers = np.random.default_rng(seed)

    def square(size: int) -> tuple[tuple[float, ...], ...]:
        root = numbers.normal(size=(size, size))
        return tuple(tuple(row) for row in root @ root.T)

    elastic = []
    for item in system.elastic:
        given = numbers.uniform(-20.0, 20.0) if item.connection.line and numbers.integers(2) else None
        inertance = (float(numbers.uniform(0.0, 0.5)), float(numbers.uniform(0.0, 0.5)))
        elastic.append(item._replace(inertance=inertance, preload=given))
    slip = [
        item._replace(
            added_mass=square(len(item.coefficients)),
            camber=tuple(numbers.normal(size=len(item.coefficients))),
            camber_axis=vector(numbers.normal(size=3)),
        )
        for item in system.slip
    ]
    axes = vector(numbers.normal(size=3)), vector(numbers.normal(size=3))
    place = point((0, 1), vector(numbers.normal(size=3)), 3, 3, name="bushing of matrices")
    bushing = Bushing(place, axes, square(6), square(6))
    return in_equilibrium(system._replace(elastic=tuple(elastic), slip=tuple(slip), bushings=(bushing,)))


@examples
@given(recipes(linear=False, massless=False), st.integers(0, 1000))
def test_random_systems_of_rarer_parts_move_as_finite_motion_says(recipe: Recipe, seed: int) -> None:
    judge(enriched(build(recipe), seed))
