"""Finite constraints: their derivatives, and their agreement with the linear model's rows at the drawing."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from eom.analysis.closure import Posture, equations, measured
from eom.analysis.rotation import exponential, matrix, product
from eom.assembly.rows import rows
from eom.vehicle.elements import Body, Connection

AXIS, OTHER = (0.3, -0.5, 0.8), (0.1, 1.0, 0.2)
PLACE, FAR = (0.4, -0.2, 0.7), (-0.3, 0.5, 0.1)
INERTIA = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
BODIES = [
    Body(name, 1.0, centre, INERTIA, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    for name, centre in (("one", (0.1, 0.2, -0.3)), ("two", (-0.4, 0.3, 0.6)))
]


def at(forces: int, moments: int, bodies: tuple[int, int] = (0, 1), **more: object) -> Connection:
    base = Connection("joint", bodies, (PLACE, PLACE), forces, AXIS, moments, AXIS)
    return base._replace(**more)  # type: ignore[arg-type]


CONNECTIONS = [
    *(at(forces, moments) for forces in range(4) for moments in range(4) if forces + moments),
    at(3, 2, (1, 0)),
    at(3, 2, (0, -1)),
    at(1, 3, (-1, 1)),
    at(1, 0, line=True, places=(PLACE, FAR)),
    at(1, 0, (0, -1), line=True, places=(PLACE, FAR)),
    at(1, 2, upright=AXIS),
    at(0, 1, upright=(0.5, 0.3, 0.0), moment_axis=(-0.3, 0.5, 1.0)),
    at(1, 1, moment_axis=OTHER),
]


def random_posture(seed: int, size: float) -> Posture:
    return Posture.drawn(2).moved(size * np.random.default_rng(seed).standard_normal(12))


@pytest.mark.parametrize("connection", CONNECTIONS)
def test_at_the_drawing_a_finite_constraint_is_closed_and_its_derivative_is_the_linear_models_row(
    connection: Connection,
) -> None:
    residual, derivative = equations(BODIES, connection, Posture.drawn(2))
    assert np.max(np.abs(residual)) < 1e-15
    assert np.max(np.abs(derivative - rows(BODIES, connection))) < 1e-15


DRIVEN = [item for item in CONNECTIONS if item.forces + item.moments == 1 and not item.line and item.upright is None]


@pytest.mark.parametrize(
    ("connection", "value"), [*((item, 0.0) for item in CONNECTIONS), *((item, 0.8) for item in DRIVEN)]
)
def test_derivatives_of_finite_constraints_are_their_central_differences(connection: Connection, value: float) -> None:
    posture, h = random_posture(3, 0.5), 1e-5
    _, derivative = equations(BODIES, connection, posture, value)
    differences = np.array(
        [
            (
                equations(BODIES, connection, posture.moved(h * column), value)[0]
                - equations(BODIES, connection, posture.moved(-h * column), value)[0]
            )
            / (2.0 * h)
            for column in np.eye(12)
        ]
    ).T
    # h^2 of truncation and 1e-16/h of rounding are both near 1e-10
    assert np.max(np.abs(derivative - differences)) < 1e-9


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (1e-9, 0.0, 2e-9), (0.4, -1.1, 0.7), (0.0, 3.0, 0.0)])
def test_quaternions_are_scipys_rotations(turn: tuple[float, float, float]) -> None:
    ours, theirs = exponential(np.array(turn)), Rotation.from_rotvec(turn)
    other = Rotation.from_rotvec([0.3, 0.2, -0.9])
    assert np.max(np.abs(matrix(ours) - theirs.as_matrix())) < 1e-15
    both = product(exponential(np.array([0.3, 0.2, -0.9])), ours)
    assert np.max(np.abs(matrix(both) - (other * theirs).as_matrix())) < 1e-15


@pytest.mark.parametrize("forces", [0, 1])
def test_a_driven_direction_measures_the_value_that_closes_it(forces: int) -> None:
    connection, posture = at(forces, 1 - forces), random_posture(5, 0.4)
    value = measured(BODIES, connection, posture)
    assert abs(equations(BODIES, connection, posture, value)[0][0]) < 1e-15


def test_a_constant_velocity_joint_turns_both_shafts_alike_at_a_bend() -> None:
    # the input turns by alpha, the output by alpha about its own axis, bent by beta: no turn remains between them
    alpha, beta, shaft = 1.3, 0.5, np.array([1.0, 0.0, 0.0])
    bend = Rotation.from_rotvec([0.0, 0.0, beta])
    output = (bend * Rotation.from_rotvec(alpha * shaft)).as_quat(scalar_first=True)
    turned = Rotation.from_rotvec(alpha * shaft).as_quat(scalar_first=True)
    posture = Posture(np.zeros((2, 3)), np.array([turned, output]))
    joint = at(0, 1, moment_axis=(1.0, 0.0, 0.0))
    assert abs(equations(BODIES, joint, posture)[0][0]) < 1e-15
