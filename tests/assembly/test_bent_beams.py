"""What a bent beam's load does when the beam twists: published lateral buckling loads, and conservation.

A deep cantilever under a dead force at its tip twists away at P L^2 = 4.0126 sqrt(EI GJ) (L. Prandtl, 1899), under
its own weight at q L^3 = 12.85 sqrt(EI GJ) (S. P. Timoshenko and J. M. Gere, Theory of Elastic Stability). With s
the distance from the tip, the twist obeys f'' + (P s)^2/(EI GJ) f = 0, or (q s^2/2)^2 in place of (P s)^2; its
solutions are Bessel functions, whose first zeros give the loads.
"""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import jv

from eom.assembly.massless import independent_equations
from eom.vehicle.elements import Beam, Constraint, Elastic, Load, System, Vector
from tests.assembly.structures import chain
from tests.assembly.systems import EMPTY, Array, Z, assembled, body, diagonal, point
from tests.assembly.test_beck import extrapolated

EI, GJ, L = 2.0, 0.5, 1.5
ZERO: Vector = (0.0, 0.0, 0.0)


def deep_beam(count: int) -> System:
    """A cantilever that is stiff upwards and slender sideways, with springs of GJ in its shafts."""
    free = chain(count, (1e4 * EI, EI), 1.0, length=L, normal=Z)
    rods = tuple(item for item in free.constraints if item.connection.line)
    twist = tuple(
        Elastic(item.connection, (0.0, GJ * count / L), (0.0, 0.0)) for item in free.constraints if item not in rods
    )
    bodies = tuple(item._replace(inertia=diagonal(0.01 * L / count, 0.0, 0.0)) for item in free.bodies)
    return free._replace(bodies=bodies, constraints=rods, elastic=twist)


def under_force(count: int, P: float) -> System:
    """The beam under a dead force at its tip."""
    load = Load("tip", count - 1, (L, 0.0, 0.0), (0.0, 0.0, -P), ZERO)
    return deep_beam(count)._replace(loads=(load,))


def under_weight(count: int, q: float) -> System:
    """The beam of one kilogram per metre under a gravity of q."""
    return deep_beam(count)._replace(gravity=(0.0, 0.0, -q))


def equations_of(system: System) -> tuple[Array, Array]:
    """M and K of the independent coordinates."""
    equations = independent_equations(assembled(system))
    return equations.M, equations.K


def lowest(system: System) -> float:
    """The lowest squared frequency."""
    M, K = equations_of(system)
    return float(np.min(np.linalg.eigvals(np.linalg.solve(M, K)).real))


def test_a_tip_force_buckles_a_deep_beam_at_prandtls_load() -> None:
    """Load over sqrt(EI GJ)/L^2: twice the first zero of J(-1/4).

    The powers h^2 and h^4 of the length of the elements are extrapolated away; h^6 = 1e-6 is left.
    """
    unit = np.sqrt(EI * GJ) / L**2
    exact = 2.0 * brentq(lambda z: jv(-0.25, z), 1.5, 2.5)
    assert exact == pytest.approx(4.0126, abs=5e-5)
    loads = [brentq(lambda P, n=n: lowest(under_force(n, P * unit)), 2.0, 6.0, xtol=1e-11) for n in (4, 8, 16)]
    assert extrapolated(loads) == pytest.approx(exact, rel=2e-5)


def test_its_own_weight_buckles_a_deep_beam_at_the_published_load() -> None:
    """Six times the first zero of J(-1/6)."""
    unit = np.sqrt(EI * GJ) / L**3
    exact = 6.0 * brentq(lambda z: jv(-1.0 / 6.0, z), 1.5, 2.5)
    assert exact == pytest.approx(12.85, abs=5e-3)
    loads = [brentq(lambda q, n=n: lowest(under_weight(n, q * unit)), 5.0, 20.0, xtol=1e-11) for n in (4, 8, 16)]
    assert extrapolated(loads) == pytest.approx(exact, rel=2e-4)


@pytest.mark.parametrize("make", [under_force, under_weight])
def test_dead_loads_on_bent_beams_are_conservative(make: Callable[[int, float], System]) -> None:
    """A potential has a symmetric stiffness."""
    _, K = equations_of(make(3, 2.7))
    _, unloaded = equations_of(make(3, 0.0))
    change = K - unloaded
    assert np.max(np.abs(change)) > 0.1
    # what is added is a few units in matrices of 1e5
    np.testing.assert_allclose(change, change.T, atol=1e-10 * np.max(np.abs(K)))


def test_a_bent_beam_turned_as_a_whole_stays_bent() -> None:
    """Between two bodies that a spring bends towards each other: no outside force, so no stiffness of rigid motions."""
    inertia = diagonal(1.0, 1.0, 1.0)
    bodies = (body("a", (0.0, 0.3, 0.1), 1.0, inertia), body("b", (1.0, -0.2, 0.2), 1.0, inertia))
    beam = Beam("beam", (0, 1), ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), (EI, 3.0 * EI), (0.0, 1.0, 0.5))
    rod = Constraint(point((0, 1), ZERO, forces=1, moments=1, axis=(1.0, 0.0, 0.0), name="rod"))
    bent = point((0, 1), (0.4, 0.2, 0.7), forces=1, axis=(0.3, 1.0, 0.4), name="bent")
    turned = point((0, 1), ZERO, moments=1, axis=(0.0, 1.0, 2.0), name="turned")
    system = EMPTY._replace(
        bodies=bodies,
        beams=(beam,),
        constraints=(rod,),
        elastic=(
            Elastic(bent, (0.0, 0.0), (0.0, 0.0), preload=2.0),
            Elastic(turned, (0.0, 0.0), (0.0, 0.0), preload=0.7),
        ),
    )
    matrices = assembled(system)
    assert np.max(np.abs(matrices.statics.tensions[2:])) > 0.1
    assert np.max(np.abs(matrices.statics.residual)) < 1e-12
    for motion in np.eye(6):
        v, turn = motion[:3], motion[3:]
        whole = np.concatenate([np.concatenate([v + np.cross(turn, item.centre), turn]) for item in bodies])
        np.testing.assert_allclose(matrices.K @ whole, 0.0, atol=1e-12 * EI)
