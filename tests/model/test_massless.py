"""Bodies without mass between springs and dampers, from the file, against closed forms."""

import numpy as np
import pytest

import eom

SERIES = """
name: mass on a chain
bodies:
  mass: {mass: 3, at: [0, 0, 0]}
  joint: {mass: 0, at: [1, 0, 0]}
connectors:
  guide: {type: rigid_point, between: [mass, ground], at: [0, 0, 0], forces: 2, moments: 3, axis: [1, 0, 0]}
  slide: {type: rigid_point, between: [joint, ground], at: [1, 0, 0], forces: 2, moments: 3, axis: [1, 0, 0]}
  near: {type: spring, between: [mass, joint], ends: [[0, 0, 0], [1, 0, 0]], stiffness: 80}
  far: {type: spring, between: [joint, ground], ends: [[1, 0, 0], [2, 0, 0]], FAR}
actuators:
  push: {body: mass, along: [1, 0, 0]}
  pull: {body: joint, along: [1, 0, 0]}
  END
sensors:
  at_mass: {body: mass, along: [1, 0, 0], measure: position}
  at_joint: {body: joint, along: [1, 0, 0], measure: position}
  rate: {body: joint, along: [1, 0, 0], measure: velocity}
  thrust: {body: mass, along: [1, 0, 0], measure: acceleration}
"""
m, k, c = 3.0, 80.0, 7.0
FREQUENCIES = [0.05, 0.6, 4.0]


def chain(far: str, end: str = "") -> str:
    """The file with its far end, and an input at that end."""
    return SERIES.replace("FAR", far).replace("END", end)


def assert_response(file: str, frequency: float, far: complex, inputs: int = 2) -> None:
    """Push and pull to the two positions and two rates, by the dynamic stiffness of the two bodies."""
    s = 2j * np.pi * frequency
    compliance = np.linalg.inv(np.array([[m * s**2 + k, -k], [-k, k + far]]))
    expected = np.vstack([compliance, s * compliance[1], s**2 * compliance[0]])
    found = eom.linearise(eom.loads(file)).frequency_response(frequency)[0, :, :inputs]
    # the same two equations, one of them without rate
    np.testing.assert_allclose(found, expected[:, :inputs], rtol=1e-10)


def test_two_springs_in_series_are_one() -> None:
    file = chain("stiffness: 20").replace("  rate: {body: joint, along: [1, 0, 0], measure: velocity}\n", "")
    model = eom.linearise(eom.loads(file))
    assert model.states == ("mass.x", "mass.v_x")
    assert np.max(model.modes().eigenvalues.imag) == pytest.approx(np.sqrt(80.0 * 20.0 / 100.0 / m), rel=1e-12)
    s = 2j * np.pi * 0.4
    compliance = np.linalg.inv(np.array([[m * s**2 + k, -k], [-k, k + 20.0]]))
    expected = np.vstack([compliance, s**2 * compliance[0]])
    np.testing.assert_allclose(model.frequency_response(0.4)[0], expected, rtol=1e-10)


def test_the_rate_of_a_joint_that_a_force_places_at_once_is_refused() -> None:
    """Between springs the joint jumps with the force on it: its velocity would be an impulse."""
    with pytest.raises(eom.OutputError, match="output rate would follow the rate of input pull"):
        eom.linearise(eom.loads(chain("stiffness: 20")))


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_spring_and_damper_in_series_have_a_state_of_first_order(frequency: float) -> None:
    file = chain(f"damping: {c}")
    assert len(eom.linearise(eom.loads(file)).A) == 3
    assert_response(file, frequency, c * 2j * np.pi * frequency)


def test_the_series_of_spring_and_damper_relaxes_as_maxwells() -> None:
    """M c y'' ... its characteristic polynomial is s (m c s^2/k + m s + c) = 0 with the position of rest."""
    found = np.sort_complex(eom.linearise(eom.loads(chain(f"damping: {c}"))).modes().eigenvalues)
    expected = np.sort_complex(np.append(np.roots([m * c / k, m, c]), 0.0))
    np.testing.assert_allclose(found, expected, atol=1e-10)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_spring_and_damper_side_by_side_place_the_joint(frequency: float) -> None:
    file = chain(f"stiffness: 25, damping: {c}")
    assert_response(file, frequency, 25.0 + c * 2j * np.pi * frequency)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_a_damper_moved_at_its_far_end_moves_the_joint(frequency: float) -> None:
    """The joint feels c du/dt; it follows the input with a jump of one in its position."""
    end = f"end: {{body: joint, along: [1, 0, 0], gain: 0, rate_gain: {c}}}"
    file = chain(f"damping: {c}", end).replace("  rate: {body: joint, along: [1, 0, 0], measure: velocity}\n", "")
    s = 2j * np.pi * frequency
    compliance = np.linalg.inv(np.array([[m * s**2 + k, -k], [-k, k + c * s]]))
    force = compliance @ [0.0, c * s]
    found = eom.linearise(eom.loads(file)).frequency_response(frequency)[0, :, 2]
    np.testing.assert_allclose(found, [*force, s**2 * force[0]], rtol=1e-10)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_a_patch_on_a_slip_damper_is_dragged_by_a_spring(frequency: float) -> None:
    """At speed the slip damper feels the patch's velocity in its own axes, that of the spring's end plus nothing."""
    file = chain("stiffness: 0, damping: 0").replace(
        "  far: {type: spring, between: [joint, ground], ends: [[1, 0, 0], [2, 0, 0]], stiffness: 0, damping: 0}",
        f"  far: {{type: slip_damper, body: joint, at: [1, 0, 0], axis: [1, 0, 0], damping: {c}}}",
    )
    assert "slip_damper" in file
    assert_response(file, frequency, c * 2j * np.pi * frequency)


@pytest.mark.parametrize("far", ["stiffness: 0", "inertance: 0"])
def test_a_joint_held_by_nothing_beyond_still_follows(far: str) -> None:
    """The near spring alone places it where the mass is: no force."""
    file = chain(far).replace("  rate: {body: joint, along: [1, 0, 0], measure: velocity}\n", "")
    model = eom.linearise(eom.loads(file))
    row = model.C[model.outputs.index("at_joint")] - model.C[model.outputs.index("at_mass")]
    np.testing.assert_allclose(row, 0.0, atol=1e-14)


def test_a_body_without_mass_that_nothing_holds_is_named() -> None:
    """Along its free direction there is neither spring nor damper."""
    loose = chain("stiffness: 20").replace(
        "between: [joint, ground], at: [1, 0, 0], forces: 2", "between: [joint, ground], at: [1, 0, 0], forces: 0"
    )
    with pytest.raises(eom.SingularError) as caught:
        eom.assemble(eom.loads(loose, "chain.yaml"))
    assert "chain.yaml:5:3: bodies.joint: nothing determines the motion joint.v_" in str(caught.value)
    assert "give the body mass or inertia, or hold it by a spring or damper of its own" in str(caught.value)


def test_an_inerter_gives_a_body_without_mass_inertia() -> None:
    file = chain("inertance: 2")
    assert len(eom.linearise(eom.loads(file)).A) == 4
    s = 2j * np.pi * 0.6
    assert_response(file, 0.6, 2.0 * s**2)
