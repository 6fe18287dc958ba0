"""Small systems against Exudyn: mass, damping and stiffness matrices and characteristic polynomials.

Tolerance: 1e-10 of the largest entry. Exudyn's equations are differentiated by extrapolated differences, which cost
some 1e-12 (see `tests.referees.exudyn_model`); everything else is rounding. Seen are 7e-12 at most.
"""

import numpy as np
import pytest

from eom.vehicle.elements import GROUND, Constraint, Elastic, Matrix3, System, Vector
from tests.assembly.systems import (
    EMPTY,
    ZERO,
    X,
    Y,
    Z,
    body,
    characteristic,
    diagonal,
    line,
    linear,
    point,
    spring,
    tensor,
    vector,
)
from tests.referees.exudyn_model import Model

pytest.importorskip("exudyn", reason="Exudyn is not installed: pip install 'eom-vehicle[referees]'")
RELATIVE = 1e-10
GRAVITY: Vector = (0.0, 0.0, -9.81)


def inertia(seed: int, mass: float = 1.0) -> Matrix3:
    """An inertia tensor with products, of five equal mass points."""
    points = np.random.default_rng(seed).uniform(-0.6, 0.6, (5, 3))
    return tensor(mass * sum((np.eye(3) * (p @ p) - np.outer(p, p) for p in points), np.zeros((3, 3))))


def double_pendulum() -> System:
    """A body on a ball joint, another on a skew hinge below; only their common centre is below."""
    return EMPTY._replace(
        bodies=(
            body("upper", (-0.15, 0.0, -0.4), 2.0, inertia(1)),
            body("lower", (0.1, 0.0, -1.3), 3.0, inertia(2)),
        ),
        gravity=GRAVITY,
        constraints=(
            Constraint(point((0, GROUND), ZERO, 3, 0, name="ball")),
            Constraint(point((1, 0), (0.1, 0.0, -0.8), 3, 2, (0.6, 0.8, 0.0), name="hinge")),
        ),
    )


def platform() -> System:
    """A heavy body on six inclined, loaded legs with dampers."""
    feet = 1.2 * np.array([[np.cos(a), np.sin(a), -0.8] for a in np.radians([10, 50, 130, 170, 250, 290])])
    tops = 0.7 * np.array([[np.cos(a), np.sin(a), 0.4] for a in np.radians([40, 20, 160, 140, 280, 260])])
    ends = enumerate(zip(tops, feet, strict=True))
    legs = [line((0, GROUND), vector(above), vector(foot), f"leg {k}") for k, (above, foot) in ends]
    return EMPTY._replace(
        bodies=(body("body", (0.1, -0.05, 0.5), 20.0, inertia(3, 4.0)),),
        gravity=GRAVITY,
        elastic=tuple(spring(leg, 3000.0 + 400.0 * k, 20.0 + 3.0 * k) for k, leg in enumerate(legs)),
    )


def four_bar() -> System:
    """Two splayed cranks and a coupler that hangs between them: one freedom, whose stiffness is that of reactions."""
    return EMPTY._replace(
        bodies=(
            body("left", (-0.55, 0.0, -0.4), 1.0, inertia(4)),
            body("coupler", (0.0, 0.0, -0.9), 4.0, inertia(5)),
            body("right", (0.55, 0.0, -0.4), 1.0, inertia(6)),
        ),
        gravity=GRAVITY,
        constraints=(
            Constraint(point((0, GROUND), (-0.7, 0.0, 0.0), 3, 2, Y, name="left pivot")),
            Constraint(point((1, 0), (-0.4, 0.0, -0.8), 3, 2, Y, name="left pin")),
            Constraint(point((1, 2), (0.4, 0.0, -0.8), 2, 0, Y, name="right pin")),
            Constraint(point((2, GROUND), (0.7, 0.0, 0.0), 3, 2, Y, name="right pivot")),
        ),
        elastic=(Elastic(point((1, 0), (-0.4, 0.0, -0.8), 0, 1, Y, name="pin"), (0.0, 6.0), (0.0, 0.3)),),
    )


def top(spin: float) -> System:
    """A top that spins upright on its tip, of whatever speed."""
    return EMPTY._replace(
        bodies=(body("top", (0.0, 0.0, 0.3), 1.5, diagonal(0.02, 0.02, 0.03), spin=(0.0, 0.0, spin)),),
        gravity=GRAVITY,
        constraints=(Constraint(point((0, GROUND), ZERO, 3, 0, name="tip")),),
    )


def rotor() -> System:
    """A spinning rotor in a housing on bushings that it tilts."""
    hung = [
        Elastic(point((0, GROUND), (x, y, -0.4), 3, 0, name=f"bushing {k}"), (900.0, 0.0), (4.0, 0.0))
        for k, (x, y) in enumerate(((0.5, 0.1), (-0.3, 0.4), (-0.2, -0.5)))
    ]
    return EMPTY._replace(
        bodies=(
            body("housing", ZERO, 5.0, inertia(7)),
            body("rotor", (0.0, 0.0, 0.2), 3.0, diagonal(0.1, 0.1, 0.18), spin=(0.0, 0.0, 60.0)),
        ),
        constraints=(Constraint(point((1, 0), (0.0, 0.0, 0.2), 3, 2, Z, name="bearing")),),
        elastic=tuple(hung),
    )


def towed() -> System:
    """Two bodies under way, the towed one on a spring and damper sideways: dampers feel the rate of displacement."""
    velocity = (20.0, 0.0, 0.0)

    def flat(index: int, x: float) -> Constraint:
        return Constraint(point((index, GROUND), (x, 0.0, 0.0), 1, 2, Z, name=f"road {index}"))

    sideways = point((0, 1), (-2.9, 0.0, 0.0), 1, 0, Y, name="hitch")
    steered = Elastic(point((0, 1), (-2.9, 0.0, 0.0), 0, 1, Z, name="twist"), (0.0, 4e5), (0.0, 1e4))
    return EMPTY._replace(
        bodies=(
            body("truck", ZERO, 8000.0, diagonal(1e4, 3e4, 4e4), velocity),
            body("trailer", (-7.6, 0.0, 0.0), 9000.0, diagonal(1e4, 3e4, 5e4), velocity),
        ),
        constraints=(flat(0, 0.0), flat(1, -7.6), Constraint(point((1, 0), (-2.9, 0.0, 0.0), 1, 0, X, name="tow"))),
        elastic=(spring(sideways, 1e5, 2e4), steered),
    )


SYSTEMS = {
    "double pendulum": double_pendulum(),
    "platform on six legs": platform(),
    "four-bar linkage": four_bar(),
    "slow top": top(5.0),
    "sleeping top": top(80.0),
    "rotor in a housing": rotor(),
    "towed body": towed(),
}
AT_REST = ("double pendulum", "platform on six legs", "four-bar linkage")


@pytest.mark.parametrize("name", SYSTEMS)
def test_small_motion_is_that_of_exudyn(name: str) -> None:
    """By characteristic polynomials, which share nothing of coordinates, constraints and null spaces."""
    found = linear(SYSTEMS[name])
    A = Model(SYSTEMS[name], found.matrices.statics.tensions).small_motion().A()
    # scaled to roots of the order of one
    size = float(np.max(np.abs(np.linalg.eigvals(A))))
    assert found.model.A.shape == A.shape
    for s in (1.0 + 2.0j, 0.4 - 0.7j, -0.3 + 0.5j):
        np.testing.assert_allclose(characteristic(found.model.A / size, s), characteristic(A / size, s), rtol=RELATIVE)


@pytest.mark.parametrize("name", AT_REST)
def test_matrices_at_rest_are_those_of_exudyn(name: str) -> None:
    """Entry by entry: mass, damping; stiffness on what the joints leave free, where reactions do no work."""
    ours = linear(SYSTEMS[name]).matrices
    theirs = Model(SYSTEMS[name], ours.statics.tensions).small_motion()
    N = theirs.N
    np.testing.assert_allclose(ours.J @ N, 0.0, atol=1e-12)
    assert np.linalg.matrix_rank(ours.J) == len(N) - N.shape[1]
    for own, other in ((ours.M, theirs.M), (ours.C, theirs.C), (N.T @ ours.K @ N, N.T @ theirs.K @ N)):
        np.testing.assert_allclose(own, other, rtol=0.0, atol=RELATIVE * float(np.max(np.abs(other))))


@pytest.mark.parametrize(("spin", "steady"), [(5.0, False), (80.0, True)])
def test_a_top_sleeps_when_exudyn_says_so(spin: float, steady: bool) -> None:
    """Published: upright spin is stable if (I3 spin)^2 > 4 m g l I1, I1 about the tip (Goldstein, chapter 5)."""
    assert ((0.03 * spin) ** 2 > 4.0 * 1.5 * 9.81 * 0.3 * (0.02 + 1.5 * 0.3**2)) == steady
    for A in (linear(top(spin)).model.A, Model(top(spin), np.zeros(0)).small_motion().A()):
        assert (float(np.max(np.linalg.eigvals(A).real)) < 1e-5) == steady
