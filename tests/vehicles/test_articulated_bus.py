"""An articulated bus against Lagrange's equations of three coordinates with a damper in the joint."""

import numpy as np
import pytest

import eom
from tests.referees.train import LinearModel
from tests.vehicles.agreement import assert_responses_agree, assert_roots_agree
from tests.vehicles.shipped import vehicle

Array = np.ndarray


def lagrange(speed: float, damping: float) -> LinearModel:
    """The bus in axes that travel ahead: q = (lateral place of the front axle, heading in front, heading at the rear).

    States: lateral velocity of the front axle and both yaw rates in heading axes, and the articulation.
    """
    y, front, rear = np.eye(3)
    joint = y - 7.6 * front
    centres = (y - 3.4 * front, joint - 4.3 * rear)
    M = 9.5e3 * np.outer(centres[0], centres[0]) + 8e3 * np.outer(centres[1], centres[1])
    M += 64e3 * np.outer(front, front) + 45e3 * np.outer(rear, rear)
    bend = rear - front
    L, K = damping * np.outer(bend, bend), np.zeros((3, 3))
    contacts = ((y, front, 320e3), (y - 5.9 * front, front, 520e3), (joint - 5.5 * rear, rear, 560e3))
    for contact, heading, cornering in contacts:
        L += cornering / speed * np.outer(contact, contact)
        K -= cornering * np.outer(contact, heading)
    steer = 320e3 * y
    # only differences of heading matter: q = (0, 0, articulation) and q' = (v, yaw rates) give all forces
    motion = np.zeros((3, 4)), np.eye(3, 4)
    motion[0][2, 3] = 1.0
    per_state = -np.linalg.solve(M, K @ motion[0] + L @ motion[1])
    per_input = np.linalg.solve(M, np.column_stack([steer, rear]))
    turning = np.array([[0.0, speed, 0.0, 0.0], [0.0] * 4, [0.0] * 4])
    A = np.vstack([per_state - turning, [[0.0, -1.0, 1.0, 0.0]]])
    B = np.vstack([per_input, np.zeros((1, 2))])
    C = np.vstack([centres @ per_state, motion[1][1:], np.eye(4)[3:]])
    D = np.vstack([centres @ per_input, np.zeros((3, 2))])
    outputs = ["front.ay", "rear.ay", "front.yaw_rate", "rear.yaw_rate", "rear.articulation"]
    return LinearModel(A, B, ["v_y", "r_1", "r_2", "bend"], ["axle_1.steer", "rear.yaw_moment"], C, D, outputs)


@pytest.mark.parametrize("damping", [0.0, 60e3, 600e3])
@pytest.mark.parametrize("kmh", [20.0, 70.0, 110.0])
def test_roots_and_transfer_functions_are_those_of_lagranges_equations(kmh: float, damping: float) -> None:
    model = eom.linearise(vehicle("articulated_bus", U=kmh / 3.6, c_joint=damping))
    other = lagrange(kmh / 3.6, damping)
    # two derivations in double precision
    assert_roots_agree(model, other, 1e-10)
    assert assert_responses_agree(model, other, 1e-10) == 5 * 5 * 2


def steady_turn(damping: float) -> dict[str, float]:
    model = eom.linearise(vehicle("articulated_bus", c_joint=damping)).without_cyclic()
    gain = model.D - model.C @ np.linalg.solve(model.A, model.B)
    return dict(zip(model.outputs, gain[:, model.inputs.index("axle_1.steer")], strict=True))


def test_the_joints_damper_leaves_the_steady_turn_alone() -> None:
    free, damped = steady_turn(0.0), steady_turn(600e3)
    # rounding of one linear solve
    for name, value in free.items():
        assert damped[name] == pytest.approx(value, rel=1e-10)
    for unit in ("front", "rear"):
        assert damped[f"{unit}.ay"] == pytest.approx(70.0 / 3.6 * damped["front.yaw_rate"], rel=1e-10)


def test_the_joints_damper_takes_power_from_bending_alone() -> None:
    assembly = eom.assemble(vehicle("articulated_bus"))
    yaw = [assembly.velocities.index(f"{unit}_body.yaw_rate") for unit in ("front", "rear")]
    damping = assembly.matrices.C_damper
    assert damping[np.ix_(yaw, yaw)].tolist() == [[60e3, -60e3], [-60e3, 60e3]]
    assert np.count_nonzero(damping) == 4


def test_axles_and_joint_carry_the_weight_by_the_levers() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(vehicle("articulated_bus")))
    g = 9.81
    joint = 8e3 * g * 1.2 / 5.5
    middle = (9.5e3 * g * 3.4 + joint * 7.6) / 5.9
    expected = {"axle_1": 9.5e3 * g + joint - middle, "axle_2": middle, "axle_3": 8e3 * g - joint}
    assert loads.axles == pytest.approx(expected, rel=1e-12)
    assert loads.couplings["joint"][0][2] == pytest.approx(joint, rel=1e-12)
