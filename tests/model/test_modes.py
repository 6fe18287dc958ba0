"""Figures, shapes and instant centres of modes against python-control, closed forms and laws of motion."""

import json

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.model.instant_centres import instant_centres
from tests.vehicles.shipped import NAMES, vehicle

# roots that are zero but for the square root of rounding have no vectors of their own
ALL_BUT_ZERO = 1e-7


@pytest.mark.parametrize("name", NAMES)
def test_frequency_and_damping_are_those_of_python_control(name: str) -> None:
    model = eom.linearise(vehicle(name)).without_cyclic()
    modes = model.modes()
    # the referee divides by roots that are zero
    with np.errstate(invalid="ignore"):
        frequency, damping, poles = control.damp(model.to_control(), doprint=False)
    size = ALL_BUT_ZERO * np.max(np.abs(poles))
    for k, root in enumerate(modes.eigenvalues):
        # the same matrix and solver; roots that several share are not told apart
        near = int(np.argmin(np.abs(poles - root)))
        assert abs(poles[near] - root) <= size
        if modes.oscillates[k] and abs(root) > size:
            assert 2.0 * np.pi * modes.natural_frequency[k] == pytest.approx(frequency[near], rel=1e-6)
            assert modes.damping_ratio[k] == pytest.approx(damping[near], rel=1e-6, abs=1e-9)
            assert -1.0 / modes.time_constant[k] == pytest.approx(poles[near].real, rel=1e-6, abs=size)


@pytest.mark.parametrize("name", NAMES)
def test_eigenvectors_satisfy_the_equations_of_motion(name: str) -> None:
    """(A - root) v = 0, but for the exact zeros, whose vectors may drift along cyclic states."""
    model = eom.linearise(vehicle(name))
    modes = model.modes()
    moving = np.abs(modes.eigenvalues) > 1e-9 * np.max(np.abs(modes.eigenvalues))
    v, roots = modes.eigenvectors[:, moving], modes.eigenvalues[moving]
    remainder = np.abs(model.A @ v - v * roots)
    # rounding of the sums
    size = (np.abs(model.A) + np.max(np.abs(roots)) * np.eye(len(model.A))) @ np.abs(v)
    assert np.all(remainder <= 1e-11 * np.max(size, axis=0))


@pytest.mark.parametrize("name", NAMES)
def test_cyclic_modes_are_exact_zeros_of_one_state_each(name: str) -> None:
    model = eom.linearise(vehicle(name))
    modes, count = model.modes(), len(model.cyclic)
    assert not np.any(modes.eigenvalues[:count])
    for k, state in enumerate(model.cyclic):
        np.testing.assert_array_equal(np.flatnonzero(modes.eigenvectors[:, k]), [state])


@pytest.mark.parametrize("name", NAMES)
def test_shares_of_the_states_sum_to_one_in_every_mode(name: str) -> None:
    shares = eom.linearise(vehicle(name)).modes().participation
    assert np.all(shares >= 0.0)
    np.testing.assert_allclose(np.sum(shares, axis=0), 1.0, rtol=1e-13)


@pytest.mark.parametrize("name", NAMES)
def test_shapes_satisfy_the_joints_and_their_largest_entry_is_one(name: str) -> None:
    assembly = eom.assemble(vehicle(name))
    modes = eom.linearise(assembly).modes()
    shapes = modes.shapes.reshape(-1, len(modes.eigenvalues))
    np.testing.assert_allclose(assembly.J @ shapes, 0.0, atol=1e-9)
    largest = np.max(np.abs(shapes), axis=0)
    moves = largest > 0.0
    np.testing.assert_allclose(largest[moves], 1.0, rtol=1e-8)
    # phase zero: the entry itself is one
    assert np.all(np.min(np.abs(shapes[:, moves] - 1.0), axis=0) < 1e-8)


@pytest.mark.parametrize("name", NAMES)
def test_shapes_of_conjugate_roots_are_conjugate(name: str) -> None:
    modes = eom.linearise(vehicle(name)).modes()
    for k in np.flatnonzero(modes.eigenvalues.imag > 0.0):
        pair = np.flatnonzero(modes.eigenvalues == modes.eigenvalues[k].conjugate())
        differences = [np.max(np.abs(modes.shapes[:, :, j] - modes.shapes[:, :, k].conj())) for j in pair]
        # equal pairs of symmetric vehicles have shapes that mix
        assert min(differences) < 1e-9


def hinged(name: str, other: str, at: list[float], axis: list[float]) -> dict[str, object]:
    return {"type": "rigid_point", "between": [name, other], "at": at, "forces": 3, "moments": 2, "axis": axis}


def double_pendulum(length: float, g: float) -> eom.Vehicle:
    y = [0.0, 1.0, 0.0]
    return eom.loads(
        json.dumps(
            {
                "name": "double pendulum",
                "gravity": g,
                "bodies": {
                    "upper": {"mass": 1.0, "at": [0, 0, -length]},
                    "lower": {"mass": 1.0, "at": [0, 0, -2 * length]},
                },
                "connectors": {
                    "top": hinged("upper", "ground", [0, 0, 0], y),
                    "middle": hinged("lower", "upper", [0, 0, -length], y),
                },
            }
        )
    )


@pytest.mark.parametrize(("length", "g"), [(0.4, 9.81), (2.0, 1.6)])
def test_a_double_pendulum_has_the_shapes_of_the_textbooks(length: float, g: float) -> None:
    """Equal rods and masses: frequencies^2 (2 -+ sqrt(2)) g/l, angles in the ratios +-sqrt(2)."""
    modes = eom.linearise(double_pendulum(length, g)).modes()
    squares = (2.0 * np.pi * modes.natural_frequency) ** 2 * length / g
    root = np.sqrt(2.0)
    np.testing.assert_allclose(squares, [2 - root, 2 - root, 2 + root, 2 + root], rtol=1e-12)
    turns = modes.shapes[:, 4]
    np.testing.assert_allclose(turns[1] / turns[0], [root, root, -root, -root], rtol=1e-12)
    # the lower rod turns about the point where the whole of its motion vanishes: above or below the middle hinge
    centres = modes.instant_centres().points[:, 2]
    np.testing.assert_allclose(centres[0], 0.0, atol=1e-12)
    np.testing.assert_allclose(
        centres[1], [-length + length / ratio for ratio in (root, root, -root, -root)], rtol=1e-12
    )


PLACE = st.tuples(*[st.floats(-2.0, 2.0)] * 3)


@settings(max_examples=50, deadline=None)
@given(PLACE, PLACE, st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda axis: np.linalg.norm(axis) > 0.1))
def test_a_body_pinned_to_the_ground_turns_about_its_pin(
    pin: tuple[float, ...], centre: tuple[float, ...], axis: tuple[float, ...]
) -> None:
    spring = {"type": "flex_point", "between": ["body", "ground"], "at": list(pin), "moments": 1, "axis": list(axis)}
    file = {
        "name": "pinned",
        "bodies": {"body": {"mass": 2.0, "at": list(centre), "inertia": {"xx": 0.3, "yy": 0.4, "zz": 0.5}}},
        "connectors": {
            "pin": hinged("body", "ground", list(pin), list(axis)),
            "spring": {**spring, "angular_stiffness": 300.0, "angular_damping": 1.0},
        },
    }
    found = eom.linearise(eom.loads(json.dumps(file))).modes().instant_centres()
    along = np.array(axis) / np.linalg.norm(axis)
    nearest = np.array(pin) + along * (along @ (np.array(centre) - np.array(pin)))
    for k in range(2):
        # of the points on the axis the one nearest to the body's centre; joints hold to 1e-10
        np.testing.assert_allclose(found.points[0, :, k], nearest, atol=1e-9)
        assert abs(along @ found.axes[0, :, k].real) == pytest.approx(1.0, abs=1e-12)
        np.testing.assert_allclose(found.axes[0, :, k].imag, 0.0, atol=1e-12)


COMPLEX = st.builds(complex, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))


@settings(max_examples=100, deadline=None)
@given(st.lists(COMPLEX, min_size=6, max_size=6).filter(lambda shape: np.linalg.norm(shape[3:]) > 0.1))
def test_an_instant_centre_is_the_average_over_a_cycle_weighted_by_squared_rotation(shape: list[complex]) -> None:
    motion = np.array(shape)
    centre = np.array([0.3, -1.0, 2.0])
    phase = np.exp(2j * np.pi * np.arange(64) / 64)
    moved, turned = np.outer(phase, motion[:3]).real, np.outer(phase, motion[3:]).real
    # at each moment: the least-squares solution of turn x arm = -move, by singular values
    arms = [
        np.linalg.lstsq(np.cross(turn, np.eye(3), axisa=0, axisb=0, axisc=0), -move, rcond=1e-12)[0]
        for turn, move in zip(turned, moved, strict=True)
    ]
    weights = np.sum(turned**2, axis=1)
    found = instant_centres(motion.reshape(1, 6, 1), centre[np.newaxis]).points[0, :, 0]
    np.testing.assert_allclose(found.real, centre + weights @ np.array(arms) / np.sum(weights), atol=1e-9)


def test_about_a_fixed_axis_the_centre_wanders_along_a_straight_line() -> None:
    """A phase f after the largest rotation it is at Re - Im tan(f)."""
    motion = np.array([0.2 + 0.5j, -0.3j, 0.0, 0.0, 0.0, 0.8])
    found = instant_centres(motion.reshape(1, 6, 1), np.zeros((1, 3))).points[0, :, 0]
    for f in (-1.0, 0.0, 0.7):
        x, y = (motion[:2] * np.exp(1j * f)).real
        turn = 0.8 * np.cos(f)
        np.testing.assert_allclose((found.real - found.imag * np.tan(f))[:2], [-y / turn, x / turn], atol=1e-12)


def test_a_body_that_does_not_turn_has_no_instant_centre() -> None:
    modes = eom.linearise(vehicle("quarter_car")).modes()
    assert np.all(np.isnan(modes.instant_centres().points))
    assert np.all(np.isnan(modes.instant_centres().axes))


def test_the_wavelength_doubles_with_the_speed_at_the_same_root() -> None:
    """Heave, pitch and roll on springs do not know the speed; the way in a damped period does."""
    slow, fast = (eom.linearise(vehicle("full_car", U=U)).modes() for U in (10.0, 20.0))
    np.testing.assert_allclose(slow.eigenvalues, fast.eigenvalues, rtol=1e-9)
    np.testing.assert_allclose(fast.wavelength, 2.0 * slow.wavelength, rtol=1e-9)
    period = 2.0 * np.pi / np.abs(slow.eigenvalues.imag)
    np.testing.assert_allclose(slow.wavelength, 10.0 * period, rtol=1e-12)


def test_what_stands_or_does_not_oscillate_has_no_wavelength() -> None:
    assert np.all(np.isnan(eom.linearise(vehicle("ziegler_column")).modes().wavelength))
    modes = eom.linearise(vehicle("bicycle")).modes()
    np.testing.assert_array_equal(np.isnan(modes.wavelength), modes.eigenvalues.imag == 0.0)
