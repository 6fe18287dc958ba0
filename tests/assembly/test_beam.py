"""Beams against Euler and Bernoulli's closed forms.

Tolerances: static results and what follows from the shapes exactly are met to rounding, 1e-9. Frequencies of consistent
elements of length h are high by (x h / L)^4 / 1440 to leading order, x the wave number (expand the element's two
difference equations in h).
"""

import numpy as np
import pytest
from scipy.optimize import brentq

from eom.vehicle.elements import GROUND, Beam, Connection, Constraint, Load, System, Vector
from tests.assembly.systems import EMPTY, ZERO, Array, Y, Z, assembled, body, eigenvalues, linear, point

EI, MU, LENGTH = 7.0, 0.9, 2.0
RELATIVE = 1e-9
NOTHING = (ZERO, ZERO, ZERO)


def beams(elements: int, *, clamped: bool, speed: float = 0.0, axis: int = 2) -> System:
    """A prismatic beam along x that bends in one plane; its nodes are bodies without mass.

    They deflect along z (*axis* 2) or y (1); all other motion is locked.
    """
    nodes = np.linspace(0.0, LENGTH, elements + 1)[1 if clamped else 0 :]
    up = (ZERO, Y, Z)[axis]
    bodies = tuple(
        body(f"n{k}", (float(x), 0.0, 0.0), 0.0, NOTHING, velocity=(speed, 0.0, 0.0)) for k, x in enumerate(nodes)
    )
    turn = (Z, Z, Y)[axis]
    guides: list[Constraint] = []
    for k, node in enumerate(bodies):
        guides += [
            Constraint(point((k, GROUND), node.centre, forces=2, axis=up, name=f"guide {k}"), moving=True),
            Constraint(point((k, GROUND), node.centre, moments=2, axis=turn, name=f"turn {k}")),
        ]
    first = [(GROUND, 0)] if clamped else []
    pairs = [*first, *((k, k + 1) for k in range(len(bodies) - 1))]
    ends = [0.0, *nodes] if clamped else nodes
    items = tuple(
        Beam(f"beam {k}", pair, ((float(ends[k]), 0.0, 0.0), (float(ends[k + 1]), 0.0, 0.0)), (EI, EI), up, MU)
        for k, pair in enumerate(pairs)
    )
    return EMPTY._replace(bodies=bodies, constraints=tuple(guides), beams=items)


def frequencies(system: System) -> Array:
    """Angular frequencies of the vibrations, ascending."""
    roots = eigenvalues(linear(system).model)
    return np.sort(roots.imag[roots.imag > 1e-3])


def wave_numbers(sign: float, guesses: list[tuple[float, float]]) -> Array:
    """Roots of cos(x) cosh(x) = *sign* within brackets."""
    return np.array([brentq(lambda x: np.cos(x) - sign / np.cosh(x), a, b, xtol=1e-14) for a, b in guesses])


CLAMPED_FREE = wave_numbers(-1.0, [(1.0, 3.0), (4.0, 6.0), (7.0, 9.0)])
FREE_FREE = wave_numbers(1.0, [(4.0, 6.0), (7.0, 9.0), (10.0, 12.0)])


@pytest.mark.parametrize("axis", [1, 2])
@pytest.mark.parametrize(("clamped", "waves"), [(True, CLAMPED_FREE), (False, FREE_FREE)])
def test_frequencies_are_those_of_euler_and_bernoulli(clamped: bool, waves: Array, axis: int) -> None:
    """Omega = x^2 sqrt(EI / mu L^4); x is 1.8751, 4.6941, 7.8548 clamped, 4.7300, 7.8532, 10.9956 free."""
    exact = waves**2 * np.sqrt(EI / (MU * LENGTH**4))
    error = [
        frequencies(beams(elements, clamped=clamped, axis=axis))[: len(exact)] / exact - 1.0 for elements in (10, 20)
    ]
    np.testing.assert_allclose(error[1], (waves / 20.0) ** 4 / 1440.0, rtol=0.1)
    np.testing.assert_allclose(np.log2(error[0] / error[1]), 4.0, atol=0.2)


def test_a_beam_that_travels_along_itself_has_the_same_frequencies() -> None:
    still, moving = (frequencies(beams(4, clamped=False, speed=speed)) for speed in (0.0, 30.0))
    np.testing.assert_allclose(moving, still, rtol=1e-7)


def test_one_element_has_the_tip_deflection_of_a_load_and_of_its_weight() -> None:
    """P L^3 / 3 EI with slope P L^2 / 2 EI, and q L^4 / 8 EI with q L^3 / 6 EI."""
    load = Load("tip", 0, (LENGTH, 0.0, 0.0), (0.0, 0.0, -3.0), ZERO)
    system = beams(1, clamped=True)
    loaded = assembled(system._replace(loads=(load,))).statics
    np.testing.assert_allclose(
        loaded.deflection[[2, 4]], [-3.0 * LENGTH**3 / (3.0 * EI), 3.0 * LENGTH**2 / (2.0 * EI)], rtol=RELATIVE
    )
    q = 9.81 * MU
    hanging = assembled(system._replace(gravity=(0.0, 0.0, -9.81))).statics
    np.testing.assert_allclose(
        hanging.deflection[[2, 4]], [-q * LENGTH**4 / (8.0 * EI), q * LENGTH**3 / (6.0 * EI)], rtol=RELATIVE
    )


def test_the_mass_of_a_beam_is_that_of_its_length_and_its_first_and_second_moment() -> None:
    """Rigid motions of two free ends carry mu L, mu L^2 / 2 and mu L^3 / 3 about the first end, along a skew line."""
    start, along = np.array([0.3, -0.2, 0.5]), np.array([2.0, 1.0, -2.0])
    end = start + along
    bodies = (body("a", ZERO, 0.0, NOTHING), body("b", (1.0, 1.0, 1.0), 0.0, NOTHING))
    beam = Beam("beam", (0, 1), (vector(start), vector(end)), (EI, 2.0 * EI), (0.0, 1.0, 1.0), MU)
    M = assembled(EMPTY._replace(bodies=bodies, beams=(beam,))).M
    velocity, spin = np.array([0.4, -1.0, 0.7]), np.array([0.2, 0.5, -0.3])

    def motion(place: Array) -> Array:
        return velocity + np.cross(spin, place)

    p = np.concatenate([motion(np.zeros(3)), spin, motion(np.ones(3)), spin])
    middle = [motion(start + along * t) for t in (0.5 - np.sqrt(0.6) / 2.0, 0.5, 0.5 + np.sqrt(0.6) / 2.0)]
    energy = MU * 3.0 * np.dot([5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0], [v @ v for v in middle])
    np.testing.assert_allclose(p @ M @ p, energy, rtol=RELATIVE)


def vector(values: Array) -> Vector:
    """Three plain numbers."""
    x, y, z = (float(value) for value in values)
    return x, y, z


def test_bending_in_two_planes_has_its_own_stiffness() -> None:
    """A skew cantilever: along ``normal`` 3 EI1 / L^3, across it 3 EI2 / L^3."""
    along, first = np.array([1.0, 2.0, 2.0]) / 3.0, np.array([2.0, 1.0, -2.0]) / 3.0
    second = np.cross(along, first)
    tip = body("tip", vector(along), 1.0)
    beam = Beam("beam", (GROUND, 0), (ZERO, tip.centre), (5.0, 11.0), vector(first + 0.7 * along))
    system = EMPTY._replace(bodies=(tip,), beams=(beam,))
    K = assembled(system).K
    free = K[:3, :3] - K[:3, 3:] @ np.linalg.pinv(K[3:, 3:]) @ K[3:, :3]
    np.testing.assert_allclose(free, 15.0 * np.outer(first, first) + 33.0 * np.outer(second, second), atol=1e-9)


def test_one_plane_of_a_beam_is_no_hidden_support_in_statics() -> None:
    """A link carries the load along the beam: statics alone tells everything, and the beam carries none."""
    tip = body("tip", (LENGTH, 0.0, 0.0))
    rod = Constraint(Connection("rod", (0, GROUND), (tip.centre, ZERO), 1, line=True))
    stay = Constraint(point((0, GROUND), tip.centre, moments=1, axis=(1.0, 0.0, 0.0), name="stay"))
    beam = Beam("beam", (GROUND, 0), (ZERO, tip.centre), (EI, EI), Z)
    pull = Load("pull", 0, tip.centre, (12.0, 0.0, 0.0), ZERO)
    found = assembled(EMPTY._replace(bodies=(tip,), constraints=(rod, stay), beams=(beam,), loads=(pull,))).statics
    assert found.determinate
    np.testing.assert_allclose(found.tensions, 0.0, atol=1e-9)
    np.testing.assert_allclose(found.reactions[0], 12.0, rtol=RELATIVE)
