"""Numbers that describe something impossible are refused by name, file, line and column."""

import numpy as np
import pytest

import eom
from eom.report.summary import summary
from tests.vehicles.shipped import text

CAR = """\
name: car
gravity: 9.81
trim: {speed: U}
parameters:
  U: {value: 20 m/s, description: speed}
tyres:
  tyre: {per: axle, cornering: 80 kN/rad}
bodies:
  frame: {mass: 1500, at: [0, 0, 0.5], inertia: {xx: 500, yy: 2000, zz: 2200}}
connectors:
  plane: {type: support, body: frame, at: [0, 0, 0], carries: [z, roll, pitch]}
  front: {type: tyre, body: frame, at: [1.2, 0, 0], tyre: tyre, steered: true}
  rear: {type: tyre, body: frame, at: [-1.4, 0, 0], tyre: tyre}
"""

ENDS = "between: [frame, ground], ends: [[0, 0, 0], [5, 0, 0]]"
HERE = "between: [frame, ground], at: [0, 0, 0]"


def refusal(old: str, new: str, error: type[eom.EomError] = eom.DescriptionError) -> str:
    """The message that the changed car is refused with."""
    assert old in CAR
    with pytest.raises(error) as caught:
        eom.assemble(eom.loads(CAR.replace(old, new), "car.yaml"))
    return str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("mass: 1500", "mass: -5", "car.yaml:9:3: bodies.frame: its mass is -5 kg: a mass is not negative"),
        (
            "zz: 2200",
            "zz: 2600",
            "car.yaml:9:3: bodies.frame: no body has principal moments of inertia 500, 2000 and 2600",
        ),
        (
            "zz: 2200}",
            "zz: 2200}, spin: [0, 3, 0]",
            "car.yaml:9:3: bodies.frame: it spins about an axis that is no axis",
        ),
        ("speed: U", "speed: 0*U", "car.yaml:12:3: connectors.front: needs a moving trim"),
        ("80 kN/rad", "-80 kN/rad", "car.yaml:12:3: connectors.front: its coefficient is -4000 N s/m"),
        (
            "rear: {type: tyre,",
            "rod: {type: link, between: [frame, ground], ends: [[0, 0, 0], [0, 0, 0]]}\n  rear: {type: tyre,",
            "car.yaml:13:3: connectors.rod: its two ends are at the same place: a line needs a length",
        ),
        (
            "rear: {type: tyre,",
            f"pin: {{type: rigid_point, {HERE}, forces: 1, axis: [0, 0, 0]}}\n  rear: {{type: tyre,",
            "car.yaml:13:3: connectors.pin: its axis has no direction: all of its components are zero",
        ),
        (
            "rear: {type: tyre,",
            "pin: {type: rigid_point, between: [frame, ground], at: [0, 0, 0], forces: 3}\n  rear: {type: tyre,",
            "connectors.pin: the trim motion violates this joint: its ends move relative to each other at 20 (m/s",
        ),
        (
            "rear: {type: tyre,",
            f"rope: {{type: spring, {ENDS}, damping: 1}}\n  rear: {{type: tyre,",
            "car.yaml:13:3: connectors.rope: the trim motion violates this spring or damper",
        ),
    ],
)
def test_impossible_numbers_are_named_with_their_place(old: str, new: str, sentence: str) -> None:
    assert sentence in refusal(old, new)


AIR = "area: 2 m^2, span: 1, chord: 1, density: 1.2, derivatives: {x_u: 0.2, z_w: -3}"


@pytest.mark.parametrize(
    "air", [f"type: wing, {AIR}", "type: aero, damping: [" + ", ".join(6 * ["[1, 0, 0, 0, 0, 0]"]) + "]"]
)
def test_derivatives_of_a_flow_count_from_the_trim_and_have_any_sign(air: str) -> None:
    """Other than a tyre, a body in a stream of air slides through it at the trim, and may gain thrust by speed."""
    flying = CAR + f"  air: {{{air}, body: frame, at: [0, 0, 1]}}\n"
    eom.assemble(eom.loads(flying))


def test_all_impossible_bodies_are_reported_at_once() -> None:
    message = refusal("connectors:", "  other: {mass: -1, at: [0, 0, 0]}\nconnectors:").splitlines()
    assert len(message) == 1
    both = CAR.replace("mass: 1500", "mass: -1500").replace(
        "connectors:", "  other: {mass: -1, at: [0, 0, 0]}\nconnectors:"
    )
    with pytest.raises(eom.DescriptionError) as caught:
        eom.assemble(eom.loads(both))
    assert [mistake.where for mistake in caught.value.mistakes] == ["bodies.frame", "bodies.other"]


def test_missing_equilibrium_names_body_component_and_remainder() -> None:
    message = refusal("carries: [z, roll, pitch]", "carries: [roll, pitch]", eom.EquilibriumError)
    assert "car.yaml:9:3: bodies.frame: not in equilibrium: a force along z of -14715 N remains on frame" in message


def test_a_tyre_carries_no_dead_load() -> None:
    side = CAR + "loads:\n  wind: {body: frame, force: [0, 300, 0]}\n"
    with pytest.raises(eom.EquilibriumError, match="a force along y of 300 N remains on frame"):
        eom.assemble(eom.loads(side))


def test_a_motion_without_mass_is_named() -> None:
    loose = CAR + "  hook: {type: rigid_point, between: [ring, frame], at: [-2, 0, 0.5], forces: 3}\n"
    loose = loose.replace("bodies:\n", "bodies:\n  ring: {mass: 0, at: [-3, 0, 0.5]}\n")
    with pytest.raises(eom.SingularError, match=r"car.yaml:\d+:3: bodies.ring: nothing determines the motion ring\."):
        eom.assemble(eom.loads(loose, "car.yaml"))


def test_redundant_joints_are_named() -> None:
    doubled = CAR + "  again: {type: support, body: frame, at: [1, 0, 0], carries: [z]}\n"
    report = summary(eom.assemble(eom.loads(doubled)))
    assert "constraints         4, rank 3, 1 redundant (plane with again)" in report
    assert "let one of them carry less" in report


def test_an_acceleration_that_would_need_an_inputs_rate_is_refused() -> None:
    file = text("quarter_car").replace(
        "sensors:", "sensors:\n  axle: {body: unsprung, along: [0, 0, 1], measure: acceleration}"
    )
    with pytest.raises(eom.OutputError, match="output axle would follow the rate of input road"):
        eom.linearise(eom.loads(file))


def test_joints_that_all_but_lock_the_same_motion_are_named() -> None:
    near = "again: {type: support, body: frame, at: [1e-7, 0, 0], carries: [z]}"
    message = refusal("carries: [z, roll, pitch]}", f"carries: [z, roll]}}\n  {near}", eom.SingularError)
    assert "joints all but lock the same motion twice (plane with again)" in message


SPATIAL = """name: Four bars
bodies:
  a: {mass: 1, at: [0, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
  b: {mass: 1, at: [1, 0, 2], inertia: {xx: 1, yy: 1, zz: 1}}
  c: {mass: 1, at: [2, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
connectors:
  one: {type: rigid_point, between: [a, ground], at: [0, 0, 0], forces: 3, moments: 2, axis: [0, 1, 0]}
  two: {type: rigid_point, between: [b, a], at: [0, 0, 2], forces: 3, moments: 2, axis: [0, 1, 0]}
  three: {type: rigid_point, between: [c, b], at: [2, 0, 2], forces: 3, moments: 2, axis: [0, 1, 0]}
  four: {type: rigid_point, between: [c, ground], at: [2, 0, 0], forces: 3, moments: 2, axis: [0, 1, 0]}
"""


def test_redundant_joints_are_shown_as_the_motions_that_they_lock() -> None:
    """The fourth hinge of a plane four-bar locks sideways motion and both tilts again."""
    report = summary(eom.assemble(eom.loads(SPATIAL)))
    assert "constraints         20, rank 17, 3 redundant" in report
    assert report.count("locked more than once:") == 3
    assert "one: rotation about (0, 0, -1)" in report
    assert "rotation about (" in report
    assert "the loads of one, two, three, four" in report


def test_a_loop_that_locks_is_named() -> None:
    """A skew hinge in a plane four-bar: every hinge is free by itself, and none can turn."""
    skew = SPATIAL.replace(
        "at: [2, 0, 0], forces: 3, moments: 2, axis: [0, 1, 0]", "at: [2, 0, 0], forces: 3, moments: 2, axis: [1, 1, 0]"
    )
    report = summary(eom.assemble(eom.loads(skew)))
    assert "locked by loops     one, two, three, four" in report
    assert "no motion is left" in report


def test_motions_without_inertia_are_listed() -> None:
    point_mass = CAR.replace("inertia: {xx: 500, yy: 2000, zz: 2200}", "velocity: [20, 0, 0]")
    report = summary(eom.assemble(eom.loads(point_mass)))
    assert "without inertia     frame.yaw_rate: placed by dampers or stiffness alone" in report


def test_planar_inertia_is_accepted_and_impossible_inertia_is_not() -> None:
    """A moment of zero is one that the user leaves out."""
    planar = CAR.replace("inertia: {xx: 500, yy: 2000, zz: 2200}", "inertia: {xx: 0, yy: 0, zz: 2200}")
    same = eom.linearise(eom.loads(planar))
    np.testing.assert_array_equal(same.A, eom.linearise(eom.loads(CAR)).A)
    message = refusal("inertia: {xx: 500, yy: 2000, zz: 2200}", "inertia: {xx: 1, yy: 1, zz: 2200}")
    assert "no body has principal moments of inertia 1, 1 and 2200 kg m^2" in message


def test_a_spin_too_small_to_square_is_a_spin() -> None:
    """Its axis counts all the same: the wheel's angle is cyclic."""
    bearing = "type: rigid_point, between: [wheel, frame], at: [0, 0, 1], forces: 3, moments: 2"
    wheel = CAR + f"  pivot: {{{bearing}, axis: [0, 1, 0]}}\n"
    disc = "  wheel: {mass: 1, at: [0, 0, 1], inertia: {xx: 1, yy: 2, zz: 1}, spin: [0, 1e-300, 0]}\n"
    model = eom.linearise(eom.loads(wheel.replace("bodies:\n", "bodies:\n" + disc)))
    assert "wheel.pitch" in [model.states[k] for k in model.cyclic]


def test_masses_beyond_comparison_are_refused() -> None:
    """A node of the cantilever drawn a million kilometres off: its turning dwarfs every other mass."""
    far = text("cantilever").replace("at: [3*L/4, 0, 0]", "at: [1e9*L/4, 0, 0]")
    with pytest.raises(eom.SingularError, match="differ too much in size"):
        eom.linearise(eom.loads(far))


def test_a_model_of_numbers_without_value_is_refused() -> None:
    """A side force near the smallest number there is, over a relaxation length."""
    faint = CAR.replace("{per: axle, cornering: 80 kN/rad}", "{per: axle, cornering: 5e-321, relaxation: 0.3 m}")
    with np.errstate(all="ignore"), pytest.raises(eom.SingularError, match="differ too much in size"):
        eom.linearise(eom.loads(faint))
