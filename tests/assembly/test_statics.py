"""Equilibrium of the trim: who carries what, and what nobody carries.

Tolerance: the systems solved are small and well scaled, so results are right to some 1e-13 of the loads; 1e-9 of
them is asked for, as the kernel itself does.
"""

import numpy as np
import pytest

from eom.assembly.matrices import Matrices
from eom.assembly.statics import unbalanced
from eom.vehicle.elements import GROUND, Constraint, Elastic, Load, Slip, System, Vector
from tests.assembly.systems import EMPTY, ZERO, X, Y, Z, assembled, body, line, point, spring

G = 9.81
GRAVITY = (0.0, 0.0, -G)
RELATIVE = 1e-9


def balanced(system: System) -> Matrices:
    """The matrices of a system whose loads balance."""
    matrices = assembled(system)
    assert unbalanced(system.bodies, matrices.statics).size == 0
    return matrices


def guide(index: int = 0, place: Vector = ZERO) -> Constraint:
    """A vertical guide: the body keeps its attitude and moves up and down only."""
    return Constraint(point((index, GROUND), place, forces=2, moments=3, axis=Z, name="guide"))


def support(x: float, stiffness: float, *, y: float = 0.0) -> Elastic:
    """A vertical spring to the ground under a place of the first body."""
    return spring(point((0, GROUND), (x, y, 0.0), forces=1, axis=Z, name=f"spring at {x}"), stiffness)


# --- determinate ---------------------------------------------------------------------------------------------


def test_weight_hangs_on_a_line_in_tension() -> None:
    """Positive is tension: the line pulls its first body towards its second end."""
    hanging = body("bob", mass=3.0)
    system = EMPTY._replace(
        bodies=(hanging,), gravity=GRAVITY, constraints=(Constraint(line((0, GROUND), ZERO, (0.0, 0.0, 2.0))),)
    )
    statics = balanced(system).statics
    assert statics.determinate
    np.testing.assert_allclose(statics.reactions, [3.0 * G], rtol=RELATIVE)


def test_two_supports_share_a_weight_by_the_lever_rule() -> None:
    """Supports at a distance of 1 m before and 3 m behind the centre carry three quarters and one quarter."""
    beam = body("beam", mass=8.0)
    held = Constraint(point((0, GROUND), ZERO, forces=1, axis=Y), moving=False)
    system = EMPTY._replace(
        bodies=(beam,), gravity=GRAVITY, constraints=(held,), elastic=(support(1.0, 5.0), support(-3.0, 700.0))
    )
    statics = balanced(system).statics
    assert statics.determinate
    np.testing.assert_allclose(statics.tensions, [6.0 * G, 2.0 * G], rtol=RELATIVE)
    # each spring gives way by its own load over its own stiffness; z + 3 pitch and z - pitch at the two places
    pitch = (6.0 * G / 5.0 - 2.0 * G / 700.0) / 4.0
    z = -6.0 * G / 5.0 + pitch
    np.testing.assert_allclose(statics.deflection, [0.0, 0.0, z, 0.0, pitch, 0.0], rtol=RELATIVE, atol=1e-12)


def test_three_legs_of_a_table_carry_it_whatever_their_stiffness() -> None:
    table = body("table", mass=6.0)
    legs = (support(1.0, 10.0), support(-1.0, 2000.0, y=1.0), support(-1.0, 30.0, y=-1.0))
    system = EMPTY._replace(bodies=(table,), gravity=GRAVITY, elastic=legs)
    statics = balanced(system).statics
    assert statics.determinate
    np.testing.assert_allclose(statics.tensions, 6.0 * G * np.array([0.5, 0.25, 0.25]), rtol=RELATIVE)


def test_a_joint_passes_on_the_weight_and_moment_of_what_it_carries() -> None:
    """A jib welded to a mast welded to the ground: force and moment at each joint, on its first body."""
    mast, jib = body("mast", (0.0, 0.0, 1.0), mass=5.0), body("jib", (2.0, 0.0, 2.0), mass=3.0)
    foot = Constraint(point((0, GROUND), ZERO, forces=3, moments=3, name="foot"))
    head = Constraint(point((1, 0), (0.0, 0.0, 2.0), forces=3, moments=3, name="head"))
    system = EMPTY._replace(bodies=(mast, jib), gravity=GRAVITY, constraints=(foot, head))
    statics = balanced(system).statics
    bending = -2.0 * 3.0 * G  # about +y: the jib's weight turns it nose down, the joint holds against it
    np.testing.assert_allclose(statics.reactions[:6], [0.0, 0.0, 8.0 * G, 0.0, bending, 0.0], atol=RELATIVE * 100)
    np.testing.assert_allclose(statics.reactions[6:], [0.0, 0.0, 3.0 * G, 0.0, bending, 0.0], atol=RELATIVE * 100)


# --- indeterminate by statics, settled by stiffness ----------------------------------------------------------


def test_parallel_springs_share_in_proportion_to_their_stiffness() -> None:
    """k1 : k2 = 1 : 3, and a deflection of weight / (k1 + k2) downwards."""
    mass, k1, k2 = 2.0, 100.0, 300.0
    system = EMPTY._replace(
        bodies=(body("block", mass=mass),),
        gravity=GRAVITY,
        constraints=(guide(),),
        elastic=(support(0.0, k1), support(0.0, k2)),
    )
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.tensions, mass * G * np.array([0.25, 0.75]), rtol=RELATIVE)
    np.testing.assert_allclose(statics.deflection[2], -mass * G / (k1 + k2), rtol=RELATIVE)


@pytest.mark.parametrize("scale", [1.0, 1e6])
def test_a_rigid_beam_on_three_springs_shares_as_its_sinking_and_tilting_say(scale: float) -> None:
    """Sinking z and nose-down tilt b of two equations: sum k (z - x b) = -P, sum x k (z - x b) = -P a."""
    x, k = np.array([-1.0, 0.5, 2.0]), scale * np.array([40.0, 100.0, 70.0])
    P, a = 500.0, 0.3
    beam = body("beam")
    load = Load("load", 0, (a, 0.0, 0.0), (0.0, 0.0, -P), ZERO)
    held = Constraint(point((0, GROUND), ZERO, forces=2, moments=0, axis=Z))
    upright = Constraint(point((0, GROUND), ZERO, moments=1, axis=X))
    system = EMPTY._replace(
        bodies=(beam,),
        constraints=(held, upright),
        elastic=tuple(support(float(at), float(stiffness)) for at, stiffness in zip(x, k, strict=True)),
        loads=(load,),
    )
    z, b = np.linalg.solve([[k.sum(), -(k @ x)], [k @ x, -(k @ x**2)]], [-P, -P * a])
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.tensions, -k * (z - x * b), rtol=RELATIVE)
    np.testing.assert_allclose(statics.deflection[[2, 4]], [z, b], rtol=RELATIVE)


def test_a_rigid_support_beside_a_spring_takes_all_the_load() -> None:
    """What does not give way leaves nothing to what does."""
    system = EMPTY._replace(
        bodies=(body("block"),),
        gravity=GRAVITY,
        constraints=(guide(), Constraint(point((0, GROUND), ZERO, forces=1, axis=Z))),
        elastic=(support(0.0, 100.0),),
    )
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.reactions[-1], G, rtol=RELATIVE)
    np.testing.assert_allclose(statics.tensions, [0.0], atol=RELATIVE * G)


def test_springs_a_million_times_stiffer_beside_soft_ones_are_settled_as_well() -> None:
    """Two stiff springs under one block share evenly while a soft suspension carries another block on top."""
    blocks = (body("lower", mass=10.0), body("upper", (0.0, 0.0, 1.0), mass=2.0))
    soft = spring(line((1, 0), (0.0, 0.0, 1.0), ZERO), 1.0)
    system = EMPTY._replace(
        bodies=blocks,
        gravity=GRAVITY,
        constraints=(guide(), guide(1, (0.0, 0.0, 1.0))),
        elastic=(soft, support(0.0, 1e6), support(0.0, 1e6)),
    )
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.tensions, G * np.array([-2.0, 6.0, 6.0]), rtol=RELATIVE)


# --- redundant rigid supports --------------------------------------------------------------------------------


def test_doubled_rigid_supports_carry_equal_parts() -> None:
    """Nothing can tell them apart: the smallest reactions that balance are equal ones."""
    floor = Constraint(point((0, GROUND), ZERO, forces=1, axis=Z))
    system = EMPTY._replace(bodies=(body("block"),), gravity=GRAVITY, constraints=(floor, floor, guide()))
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.reactions[:2], [G / 2.0, G / 2.0], rtol=RELATIVE)


def test_four_rigid_legs_of_a_square_table_carry_a_quarter_each() -> None:
    corners = [(x, y, 0.0) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
    legs = tuple(Constraint(point((0, GROUND), corner, forces=1, axis=Z)) for corner in corners)
    system = EMPTY._replace(bodies=(body("table", (0.0, 0.0, 0.7)),), gravity=GRAVITY, constraints=legs)
    statics = balanced(system).statics
    assert not statics.determinate
    np.testing.assert_allclose(statics.reactions, np.full(4, G / 4.0), rtol=RELATIVE)


def test_redundancy_elsewhere_does_not_disturb_what_stiffness_settles() -> None:
    """A welded base, doubled, under two unequal springs in parallel."""
    weld = Constraint(point((0, GROUND), ZERO, forces=3, moments=3))
    block = (0.0, 0.0, 1.0)
    springs = tuple(
        spring(point((1, 0), block, forces=1, axis=Z, name=f"{stiffness:g}"), stiffness) for stiffness in (10.0, 40.0)
    )
    system = EMPTY._replace(
        bodies=(body("base", mass=4.0), body("block", block, mass=5.0)),
        gravity=GRAVITY,
        constraints=(weld, weld, guide(1, block)),
        elastic=springs,
    )
    statics = balanced(system).statics
    np.testing.assert_allclose(statics.tensions, 5.0 * G * np.array([0.2, 0.8]), rtol=RELATIVE)
    np.testing.assert_allclose(statics.reactions[[2, 8]], 9.0 * G / 2.0, rtol=RELATIVE)


# --- what carries nothing, and what is not carried -----------------------------------------------------------


def sideways_load(index: int = 0, force: float = 50.0) -> Load:
    """A push to the left."""
    return Load("wind", index, ZERO, (0.0, force, 0.0), ZERO)


def test_a_damper_carries_no_steady_load() -> None:
    """A row without stiffness balances nothing, though its direction is the load's."""
    damper = spring(point((0, GROUND), ZERO, forces=1, axis=Y), 0.0, damping=1e5)
    tyre = Slip(point((0, GROUND), ZERO, forces=1, axis=Y), ((2e4,),))
    system = EMPTY._replace(bodies=(body("block"),), elastic=(damper,), slip=(tyre,), loads=(sideways_load(),))
    statics = assembled(system).statics
    np.testing.assert_array_equal(statics.tensions, [0.0])
    np.testing.assert_allclose(statics.residual, [0.0, 50.0, 0.0, 0.0, 0.0, 0.0], atol=RELATIVE)
    assert unbalanced(system.bodies, statics).tolist() == [1]


def test_the_damper_of_a_supported_body_takes_no_part_in_its_determinacy() -> None:
    """A damper beside the one support leaves statics determinate; the support takes everything."""
    system = EMPTY._replace(
        bodies=(body("block"),),
        gravity=GRAVITY,
        constraints=(guide(),),
        elastic=(spring(point((0, GROUND), ZERO, forces=1, axis=Z), 0.0, damping=30.0), support(0.0, 100.0)),
    )
    statics = balanced(system).statics
    assert statics.determinate
    np.testing.assert_allclose(statics.tensions, [0.0, G], rtol=RELATIVE)


def test_a_bushing_without_angular_stiffness_carries_force_and_no_moment() -> None:
    """Of one element, the rows with stiffness carry and those without do not."""
    bushing = Elastic(point((0, GROUND), ZERO, forces=3, moments=3), (100.0, 0.0), (1.0, 1.0))
    load = Load("push", 0, (0.0, 0.0, 1.0), (0.0, 10.0, 0.0), ZERO)
    system = EMPTY._replace(bodies=(body("block"),), elastic=(bushing,), loads=(load,))
    statics = assembled(system).statics
    np.testing.assert_allclose(statics.tensions, [0.0, -10.0, 0.0, 0.0, 0.0, 0.0], atol=RELATIVE * 10.0)
    assert unbalanced(system.bodies, statics).tolist() == [3]
    np.testing.assert_allclose(statics.residual[3], -10.0, rtol=RELATIVE)


@pytest.mark.parametrize("coordinate", range(12))
def test_an_unbalanced_load_is_found_with_its_body_and_coordinate(coordinate: int) -> None:
    """Two free bodies under a load of one component: exactly this one is named, with the load as residual."""
    bodies = (body("first"), body("second", (5.0, 0.0, 0.0)))
    index, component = divmod(coordinate, 6)
    values = np.zeros(6)
    values[component] = 7.0
    force, moment = (values[0], values[1], values[2]), (values[3], values[4], values[5])
    system = EMPTY._replace(bodies=bodies, loads=(Load("load", index, bodies[index].centre, force, moment),))
    statics = assembled(system).statics
    assert unbalanced(bodies, statics).tolist() == [coordinate]
    np.testing.assert_allclose(statics.residual[coordinate], 7.0, rtol=RELATIVE)


def test_the_largest_of_several_unbalanced_loads_comes_first() -> None:
    bodies = (body("first"), body("second", (0.5, 0.0, 0.0)))
    loads = (sideways_load(0, 3.0), sideways_load(1, 40.0)._replace(place=(0.5, 0.0, 0.0)))
    system = EMPTY._replace(bodies=bodies, loads=loads)
    assert unbalanced(bodies, assembled(system).statics).tolist() == [7, 1]


def test_a_load_along_a_free_direction_is_not_hidden_by_a_heavy_vehicle() -> None:
    """One newton of drag beside 400 kN of weight is no rounding error."""
    system = EMPTY._replace(
        bodies=(body("truck", mass=4e4),),
        gravity=GRAVITY,
        constraints=(Constraint(point((0, GROUND), ZERO, forces=1, moments=2, axis=Z)),),
        loads=(Load("drag", 0, ZERO, (-1.0, 0.0, 0.0), ZERO),),
    )
    statics = assembled(system).statics
    assert unbalanced(system.bodies, statics).tolist() == [0]


def test_loads_that_cancel_on_a_free_coordinate_balance_in_spite_of_rounding() -> None:
    """Drive forces of 0.1 N and 0.2 N against a resistance of 0.3 N: what 0.1 + 0.2 - 0.3 leaves is no load.

    Rounding is measured by the loads that are added up, not by their sum.
    """
    forces = (0.1, 0.2, -0.3)
    assert sum(forces) != 0.0
    loads = tuple(Load(f"{force:g} N", 0, ZERO, (force, 0.0, 0.0), ZERO) for force in forces)
    balanced(EMPTY._replace(bodies=(body("truck"),), loads=loads))


def test_no_load_is_in_equilibrium() -> None:
    statics = balanced(EMPTY._replace(bodies=(body("block"),))).statics
    assert statics.determinate
    assert statics.reactions.size == statics.tensions.size == 0
