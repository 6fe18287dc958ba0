"""The full car against the seven equations of the textbooks, written down wheel by wheel."""

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import vehicle

Array = np.ndarray
BODY = {"m": 1400.0, "roll": 500.0, "pitch": 2200.0}
# front left, front right, rear left, rear right: x, y, wheel mass, spring, damper
CORNERS = (
    (1.2, 0.75, 40.0, 22e3, 1600.0),
    (1.2, -0.75, 40.0, 22e3, 1600.0),
    (-1.5, 0.74, 44.0, 26e3, 1800.0),
    (-1.5, -0.74, 44.0, 26e3, 1800.0),
)
TYRE, TYRE_DAMPING = 200e3, 100.0
# moment per twist over the arm squared: force per difference of the wheels' travel
BARS = ((0, 1, 700.0 / 0.25**2), (2, 3, 300.0 / 0.25**2))
WHEELS = ("front_left", "front_right", "rear_left", "rear_right")
FREQUENCIES = np.array([0.3, 1.1, 1.5, 4.0, 11.0, 25.0])  # Hz


def textbook() -> tuple[Array, Array, Array, Array, Array]:
    """M, C, K (7 x 7) and the road's F, G (7 x 4) on (bounce, roll, pitch, four wheels), bounce and wheels upwards."""
    travels = np.zeros((4, 7))
    M = np.diag([BODY["m"], BODY["roll"], BODY["pitch"], *(corner[2] for corner in CORNERS)])
    C, K = np.zeros((7, 7)), np.zeros((7, 7))
    for i, (x, y, _, spring, damper) in enumerate(CORNERS):
        # the body's corner rises with bounce, left side with roll, nose against pitch
        travels[i, :3] = 1.0, y, -x
        travels[i, 3 + i] = -1.0
        K += spring * np.outer(travels[i], travels[i])
        C += damper * np.outer(travels[i], travels[i])
    for left, right, stiffness in BARS:
        twist = travels[left] - travels[right]
        K += stiffness * np.outer(twist, twist)
    K[3:, 3:] += TYRE * np.eye(4)
    C[3:, 3:] += TYRE_DAMPING * np.eye(4)
    road = np.vstack([np.zeros((3, 4)), np.eye(4)])
    return M, C, K, TYRE * road, TYRE_DAMPING * road


def textbook_response(frequency: float) -> tuple[Array, Array]:
    """Displacements (7 x 4) per height of the road under each wheel, and suspension travels (4 x 4)."""
    M, C, K, F, G = textbook()
    s = 2j * np.pi * frequency
    motion = np.linalg.solve(M * s**2 + C * s + K, F + G * s)
    travel = [motion[0] + y * motion[1] - x * motion[2] - motion[3 + i] for i, (x, y, *_) in enumerate(CORNERS)]
    return motion, np.array(travel)


def textbook_roots() -> Array:
    M, C, K, _, _ = textbook()
    A = np.block([[np.zeros((7, 7)), np.eye(7)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    return np.linalg.eigvals(A)


def ordered(roots: Array) -> Array:
    return roots[np.lexsort((np.sign(roots.imag), np.round(np.abs(roots), 6)))]


@pytest.mark.parametrize("speed", [0.0, 30.0])
def test_roots_are_those_of_the_seven_textbook_equations_at_any_speed(speed: float) -> None:
    own = np.linalg.eigvals(eom.linearise(vehicle("full_car", U=speed)).A)
    # statics leaves the preloads a rounding of 1e-10 N of 1e4 N
    np.testing.assert_allclose(ordered(own), ordered(textbook_roots()), rtol=1e-9)


@pytest.mark.parametrize("speed", [0.0, 30.0])
def test_the_body_follows_the_road_as_the_textbook_says(speed: float) -> None:
    model = eom.linearise(vehicle("full_car", U=speed))
    own = model.frequency_response(FREQUENCIES)
    columns = [model.inputs.index(f"{wheel}_road") for wheel in WHEELS]
    for k, frequency in enumerate(FREQUENCIES):
        motion, travel = textbook_response(float(frequency))
        expected = {"bounce": motion[0], "roll": motion[1], "pitch": motion[2]}
        expected["bounce_rate"] = 2j * np.pi * frequency * motion[0]
        expected["bounce_acceleration"] = -((2.0 * np.pi * frequency) ** 2) * motion[0]
        for i, wheel in enumerate(WHEELS):
            expected[f"{wheel}_travel"] = travel[i]
            expected[f"{wheel}_tyre_deflection"] = motion[3 + i] - np.eye(4)[i]
        assert set(expected) == set(model.outputs)
        for name, value in expected.items():
            got = own[k, model.outputs.index(name), columns]
            # relative to the largest of the four wheels' responses
            assert np.max(np.abs(got - value)) < 1e-9 * np.max(np.abs(value)), (name, frequency)


def test_the_car_rises_as_a_whole_on_a_higher_road() -> None:
    model = eom.linearise(vehicle("full_car"))
    gain = (model.D - model.C @ np.linalg.solve(model.A, model.B)).sum(axis=1)
    expected = [float(name == "bounce") for name in model.outputs]
    # a rigid motion strains nothing; rounding of the preloads as above
    np.testing.assert_allclose(gain, expected, atol=1e-9)


def test_springs_and_tyres_carry_the_weight_by_the_levers() -> None:
    from eom.analysis.loads import trim_loads

    loads = trim_loads(eom.assemble(vehicle("full_car")))
    front, rear = (1400.0 * 9.81 * lever / 2.7 / 2.0 for lever in (1.5, 1.2))
    expected = {"front": front, "rear": rear}
    for end, wheel in (("front", 40.0), ("rear", 44.0)):
        for side in ("left", "right"):
            spring, tyre = (loads.preloads[f"{end}_{side}_{part}"] for part in ("suspension", "tyre"))
            assert spring == pytest.approx(-expected[end], rel=1e-12)
            assert tyre == pytest.approx(expected[end] + wheel * 9.81, rel=1e-12)
