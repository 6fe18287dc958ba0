"""Slender beams against the theory of Euler and Bernoulli, whose characteristic equations are solved here.

A beam of length L, bending stiffness EI and mass per length mu swings at b^2 sqrt(EI/mu)/L^2, where
cos(b) cosh(b) = -1 for a cantilever and +1 for a free beam.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

from eom.vehicle.elements import GROUND, Beam, Constraint, Load, System, Vector
from tests.assembly.structures import chain, node
from tests.assembly.systems import EMPTY, Array, X, Y, Z, assembled, eigenvalues, linear, measure, point, push, transfer

EI, MU, L = 210.0, 0.7, 1.3
ZERO: Vector = (0.0, 0.0, 0.0)
SKEW: Vector = (0.6, 0.48, 0.64)


def roots_of(sign: float, count: int) -> Array:
    """The first roots of cos(b) cosh(b) = sign, one near each odd multiple of pi/2."""
    first = 0 if sign < 0.0 else 1
    return np.array(
        [
            brentq(
                lambda b: np.cos(b) - sign / np.cosh(b), (k + 0.5) * np.pi - 0.4, (k + 0.5) * np.pi + 0.4, xtol=1e-14
            )
            for k in range(first, first + count)
        ]
    )


def frequencies(system: System, count: int) -> Array:
    """The lowest natural frequencies [rad/s] that are not zero."""
    found = eigenvalues(linear(system).model)
    np.testing.assert_allclose(found.real, 0.0, atol=1e-6 * np.max(np.abs(found)))
    # rounding of 1e-16 times the highest square, split over defective zeros of rigid motions
    turning = np.sort(found.imag[found.imag > 0.05 * np.sqrt(EI / MU) / L**2])
    return np.asarray(turning[:count])


def in_units(found: Array, bending: float = EI) -> Array:
    """Frequencies as the roots b."""
    return np.asarray(np.sqrt(found / np.sqrt(bending / MU)) * L)


def test_the_solved_roots_are_the_published_ones() -> None:
    """R. D. Blevins, Formulas for Natural Frequency and Mode Shape (1979)."""
    np.testing.assert_allclose(roots_of(-1.0, 3), [1.87510407, 4.69409113, 7.85475744], atol=5e-9)
    np.testing.assert_allclose(roots_of(1.0, 2), [4.73004074, 7.85320462], atol=5e-9)


@pytest.mark.parametrize(("clamped", "sign"), [(True, -1.0), (False, 1.0)])
def test_frequencies_converge_from_above_with_the_fourth_power_of_the_length(clamped: bool, sign: float) -> None:
    """The consistent mass makes the frequency an upper bound, its error the square of that of the curvature."""
    exact = roots_of(sign, 2)
    errors = []
    for count in (10, 20):
        system = chain(count, (EI, 64.0 * EI), MU, length=L, clamped=clamped)
        errors.append(in_units(frequencies(system, 2)) - exact)
    assert np.all(np.array(errors) > 0.0)
    order = np.log2(errors[0] / errors[1])
    # next terms of the series grow with the square of b/10 at most
    np.testing.assert_allclose(order, 4.0, atol=0.1)
    np.testing.assert_allclose(errors[1] / exact, 0.0, atol=1e-4)


@pytest.mark.parametrize("normal", [Y, Z, (0.3, 0.0, 2.0), (-5.0, 1.0, 0.0)])
def test_both_planes_have_their_own_frequencies_wherever_the_normal_leans(normal: Vector) -> None:
    first = frequencies(chain(4, (EI, 4.0 * EI), MU, length=L, normal=normal), 2)
    alone = frequencies(chain(4, (EI, 400.0 * EI), MU, length=L), 1)
    # twice the frequency for four times the stiffness; the same element in another plane, but for rounding
    np.testing.assert_allclose(first, [alone[0], 2.0 * alone[0]], rtol=1e-9)


@pytest.mark.parametrize("velocity", [(30.0, 0.0, 0.0), (0.0, 30.0, 0.0), (7.0, -5.0, 20.0)])
def test_a_moving_beam_has_the_frequencies_of_one_at_rest(velocity: Vector) -> None:
    still = frequencies(chain(4, (EI, 4.0 * EI), MU, length=L, clamped=False), 4)
    moving = frequencies(chain(4, (EI, 4.0 * EI), MU, length=L, clamped=False, velocity=velocity), 4)
    np.testing.assert_allclose(moving, still, rtol=1e-7)


@pytest.mark.parametrize(("along", "across"), [(X, Y), (X, Z), (SKEW, (0.8, -0.36, -0.48))])
def test_one_element_has_the_exact_deflection_under_a_force_at_its_tip(along: Vector, across: Vector) -> None:
    tip = tuple((L * np.array(along)).tolist())
    system = chain(1, (EI, EI), MU, length=L, along=along, normal=across)._replace(
        inputs=(push(0, tip, across),), outputs=(measure(0, tip, across),)
    )
    # one solution of four equations
    assert transfer(linear(system).model, 0.0)[0, 0].real == pytest.approx(L**3 / (3.0 * EI), rel=1e-10)


def test_one_element_has_the_exact_deflection_and_slope_of_its_own_weight() -> None:
    """The loads at the nodes do the weight's work on cubic deflections, whence nodal values are exact."""
    system = chain(1, (EI, 3.0 * EI), MU, length=L, normal=Z)._replace(gravity=(0.0, 0.0, -9.81))
    deflection = assembled(system).statics.deflection
    q = MU * 9.81
    assert deflection[2] == pytest.approx(-q * L**4 / (8.0 * EI), rel=1e-10)
    # nose down is positive
    assert deflection[4] == pytest.approx(q * L**3 / (6.0 * EI), rel=1e-10)


def test_weight_and_its_moment_are_carried_at_the_clamp() -> None:
    root, tip = node("root", ZERO), node("tip", (L, 0.0, 0.0))
    clamp = Constraint(point((0, GROUND), ZERO, forces=3, moments=3, name="clamp"))
    free = chain(1, (EI, EI), MU, length=L)
    beam = Beam("beam", (0, 1), (ZERO, tip.centre), (EI, 2.0 * EI), (0.2, 1.0, 1.0), MU)
    rods = tuple(item._replace(connection=item.connection._replace(bodies=(0, 1))) for item in free.constraints)
    system = EMPTY._replace(bodies=(root, tip), constraints=(clamp, *rods), beams=(beam,), gravity=(0.0, 0.0, -9.81))
    found = assembled(system).statics
    weight = MU * L * 9.81
    np.testing.assert_allclose(found.reactions[:6], [0, 0, weight, 0, -weight * L / 2.0, 0], atol=1e-9 * weight)
    assert np.max(np.abs(found.residual)) < 1e-12 * weight


def test_a_beam_shifted_as_a_whole_has_its_mass_in_every_direction() -> None:
    M = assembled(chain(1, (EI, EI), MU, length=L, along=SKEW, clamped=False)).M
    for direction in np.eye(3):
        shift = np.tile(np.concatenate([direction, np.zeros(3)]), 2)
        assert shift @ M @ shift == pytest.approx(MU * L, rel=1e-13)


def test_a_beam_turned_as_a_whole_has_the_inertia_of_a_rod_and_costs_no_energy() -> None:
    system = chain(1, (EI, 2.0 * EI), MU, length=L, clamped=False)
    matrices = assembled(system)
    turn = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, L, 0.0, 0.0, 0.0, 1.0])
    assert turn @ matrices.M @ turn == pytest.approx(MU * L**3 / 3.0, rel=1e-13)
    np.testing.assert_allclose(matrices.K_elastic @ turn, 0.0, atol=1e-10 * EI)
    assert np.linalg.matrix_rank(matrices.K_elastic, tol=1e-9 * EI) == 4


def test_bodies_off_the_line_carry_the_beam_on_arms() -> None:
    """The same beam between bodies whose centres lie elsewhere: a change of coordinates and no more."""
    ends = (ZERO, (L, 0.0, 0.0))
    beam = Beam("beam", (0, 1), ends, (EI, 2.0 * EI), Y, MU)
    at_ends = EMPTY._replace(bodies=(node("a", ends[0]), node("b", ends[1])), beams=(beam,))
    centres: tuple[Vector, Vector] = ((0.1, 0.5, -0.2), (1.0, -0.4, 0.3))
    off = at_ends._replace(bodies=(node("a", centres[0]), node("b", centres[1])))
    change = np.eye(12)
    for k in range(2):
        r = np.subtract(ends[k], centres[k])
        # displacement of the end is x + theta x r
        change[6 * k : 6 * k + 3, 6 * k + 3 : 6 * k + 6] = np.cross(np.eye(3), r).T
    one, other = assembled(at_ends), assembled(off)
    for name in ("M", "K_elastic"):
        expected = change.T @ getattr(one, name) @ change
        np.testing.assert_allclose(getattr(other, name), expected, atol=1e-12 * np.max(np.abs(expected)))


def test_a_load_at_the_tip_and_the_weight_add() -> None:
    """Two beams under both: P L^3/(3 EI) + q L^4/(8 EI), exact at the nodes of any mesh."""
    system = chain(3, (EI, EI), MU, length=L)._replace(gravity=(0.0, 0.0, -9.81))
    load = Load("pull", 2, (L, 0.0, 0.0), (0.0, 0.0, -5.0), ZERO)
    found = assembled(system._replace(loads=(load,))).statics.deflection[14]
    assert found == pytest.approx(-(5.0 * L**3 / 3.0 + MU * 9.81 * L**4 / 8.0) / EI, rel=1e-9)
