"""Membrane triangles: patch test, rigid motions, textbook matrices, Cook's membrane, and a stretched membrane."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.assembly.membranes import MODULUS, POISSON, THICKNESS, membrane, patch, stiffness, stretched, turned_about
from tests.assembly.systems import Array, assembled

ELASTICITY = MODULUS / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
ROTATIONS = [np.eye(3), np.array(Rotation.from_rotvec([0.5, -1.1, 0.3]).as_matrix())]
TRIANGLE = np.array([[0.1, 0.0, 0.0], [1.3, 0.2, 0.0], [0.4, 0.9, 0.0]])


def linear_motion(places: Array, gradient: Array, rotation: Array) -> Array:
    """Motion (6 n,) of bodies whose displacement in the plane is *gradient* times place, each turned with it."""
    flat = places @ rotation
    displacement = np.column_stack([flat[:, :2] @ gradient.T, np.zeros(len(places))])
    spin = 0.5 * (gradient[1, 0] - gradient[0, 1])
    turns = np.tile(rotation @ np.array([0.0, 0.0, spin]), (len(places), 1))
    return np.hstack([displacement @ rotation.T, turns]).ravel()


@pytest.mark.parametrize("drilling", [False, True])
@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize("gradient", [[[1, 0], [0, 0]], [[0, 0], [0, 1]], [[0, 1], [1, 0]], [[0.3, -2], [0.7, 0.1]]])
def test_a_constant_strain_costs_its_energy_and_leaves_inner_corners_without_force(
    gradient: list[list[float]], rotation: Array, *, drilling: bool
) -> None:
    """The patch test: exact but for rounding on any mesh."""
    places, corners = patch()
    places = turned_about(places, rotation)
    K = stiffness(membrane(places, corners, drilling=drilling))
    G = np.array(gradient, dtype=float)
    motion = linear_motion(places, G, rotation)
    force = K @ motion
    strain = np.array([G[0, 0], G[1, 1], G[0, 1] + G[1, 0]])
    first, second = (places[2] - places[0]), (places[3] - places[1])
    area = 0.5 * np.linalg.norm(np.cross(first, second))
    assert motion @ force == pytest.approx(THICKNESS * area * strain @ ELASTICITY @ strain, rel=1e-12)
    inner = force.reshape(-1, 6)[4:]
    np.testing.assert_allclose(inner, 0.0, atol=1e-13 * np.max(np.abs(K)) * np.max(np.abs(motion)))


@pytest.mark.parametrize(("drilling", "strains"), [(False, 3), (True, 5)])
def test_rigid_motions_and_equal_rotations_cost_nothing(strains: int, *, drilling: bool) -> None:
    K = stiffness(membrane(TRIANGLE, [(0, 1, 2)], drilling=drilling))
    values = np.linalg.eigvalsh(K)
    assert np.sum(values > 1e-9 * values[-1]) == strains
    assert values[0] > -1e-12 * values[-1]
    for motion in np.eye(6):
        v, turn = motion[:3], motion[3:]
        whole = np.hstack([v + np.cross(turn, TRIANGLE), np.tile(turn, (3, 1))]).ravel()
        np.testing.assert_allclose(K @ whole, 0.0, atol=1e-12 * np.max(np.abs(K)))


def allman(places: Array) -> Array:
    """Stiffness over (u, v, r) of three corners by its displacement field, integrated by 3-point products.

    Along an edge of length l the normal displacement is linear plus (l/8) (r_j - r_i) 4 s (1 - s), tangential linear;
    with area coordinates the bulge 4 s (1 - s) of edge ij is 4 L_i L_j.
    """
    (x1, y1), (x2, y2), (x3, y3) = places
    double = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)
    grad = np.array([[y2 - y3, x3 - x2], [y3 - y1, x1 - x3], [y1 - y2, x2 - x1]]) / double
    K = np.zeros((9, 9))
    for L in ((2 / 3, 1 / 6, 1 / 6), (1 / 6, 2 / 3, 1 / 6), (1 / 6, 1 / 6, 2 / 3)):
        B = np.zeros((3, 9))

        def add(column: int, du: Array, dv: Array, B: Array = B) -> None:
            B[:, column] += [du[0], dv[1], du[1] + dv[0]]

        for k in range(3):
            add(3 * k, grad[k], np.zeros(2))
            add(3 * k + 1, np.zeros(2), grad[k])
        for i, j in ((0, 1), (1, 2), (2, 0)):
            dx, dy = places[j] - places[i]
            bulge = 4 * (grad[i] * L[j] + grad[j] * L[i])
            # l/8 times the outward normal (dy, -dx)/l, which the edge leaves where its far end turns on
            add(3 * j + 2, bulge * dy / 8, -bulge * dx / 8)
            add(3 * i + 2, -bulge * dy / 8, bulge * dx / 8)
        K += B.T @ ELASTICITY @ B * (THICKNESS * double / 2 / 3)
    return K


@pytest.mark.parametrize("drilling", [False, True])
def test_the_matrix_is_that_of_its_displacement_field(*, drilling: bool) -> None:
    K = stiffness(membrane(TRIANGLE, [(0, 1, 2)], drilling=drilling))
    at = np.array([[6 * k, 6 * k + 1, 6 * k + 5] for k in range(3)]).ravel()
    expected = allman(TRIANGLE[:, :2])
    if not drilling:
        at, expected = at[[0, 1, 3, 4, 6, 7]], constant_strain(TRIANGLE[:, :2])
    np.testing.assert_allclose(K[np.ix_(at, at)], expected, atol=1e-12 * np.max(np.abs(expected)))


def constant_strain(places: Array) -> Array:
    """Textbook stiffness over (u, v) of three corners."""
    (x1, y1), (x2, y2), (x3, y3) = places
    double = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)
    b, c = np.array([y2 - y3, y3 - y1, y1 - y2]), np.array([x3 - x2, x1 - x3, x2 - x1])
    B = np.zeros((3, 6))
    B[0, ::2] = B[2, 1::2] = b / double
    B[1, 1::2] = B[2, ::2] = c / double
    return np.asarray(THICKNESS * double / 2 * B.T @ ELASTICITY @ B)


def cook(count: int, *, drilling: bool) -> float:
    """Deflection of the tip's middle: R. D. Cook, J. Struct. Div. ASCE 100 (1974): 48 by 44 and 16, E 1, nu 1/3."""
    grid = np.linspace(0.0, 1.0, count + 1)
    places = np.array([[48 * s, 44 * s + t * (44 - 28 * s), 0.0] for t in grid for s in grid])
    corners = []
    for j in range(count):
        for i in range(count):
            a = j * (count + 1) + i
            b, c, d = a + 1, a + count + 2, a + count + 1
            # the shorter diagonal
            corners += [(a, b, d), (b, c, d)]
    K = stiffness(membrane(places, corners, drilling=drilling, material=(1.0, 1.0, 1.0 / 3.0)))
    kept = [6 * k + c for k in range(len(places)) if k % (count + 1) for c in ((0, 1, 5) if drilling else (0, 1))]
    right = np.arange(count, len(places), count + 1)
    load = np.zeros(len(K))
    # a load of 1 spread along the edge
    load[6 * right + 1] = np.concatenate([[0.5], np.ones(count - 1), [0.5]]) / count
    motion = np.zeros(len(K))
    motion[kept] = np.linalg.solve(K[np.ix_(kept, kept)], load[kept])
    return float(motion[6 * right[count // 2] + 1])


@pytest.mark.parametrize("drilling", [False, True])
def test_cooks_membrane_converges_from_below(*, drilling: bool) -> None:
    """To 23.96, the value of fine meshes in the literature; rotations are worth one refinement."""
    found = np.array([cook(count, drilling=drilling) for count in (2, 4, 8)])
    assert np.all(np.diff(found) > 0.0)
    assert np.all(found < 23.96)
    left = 23.96 - found
    # halved elements leave less than half of what was missing, in the end about a third
    assert np.all(left[1:] < 0.5 * left[:-1])
    if drilling:
        assert left[2] < 0.6
    else:
        # known of constant strain on these meshes
        np.testing.assert_allclose(found, [11.99, 18.28, 22.02], atol=0.005)


@pytest.mark.parametrize("drilling", [False, True])
@pytest.mark.parametrize("rotation", ROTATIONS)
def test_a_stretched_membrane_resists_deflection_by_the_cotangents_of_its_angles(
    rotation: Array, *, drilling: bool
) -> None:
    """Tension times the Laplacian: an edge's entry is minus half the cotangents of the angles opposite to it.

    R. Duffin, Distributed and lumped networks, J. Math. Mech. 8 (1959). It holds on any mesh.
    """
    places, corners = patch()
    tension = 3.0
    places = turned_about(places, rotation)
    matrices = assembled(stretched(membrane(places, corners, drilling=drilling), tension))
    assert np.max(np.abs(matrices.statics.residual)) < 1e-12 * tension
    normal = rotation[:, 2]
    blocks = matrices.K_tangent.reshape(len(places), 6, len(places), 6)[:, :3, :, :3]
    found = np.einsum("i,aibj,j->ab", normal, blocks, normal)
    expected = np.zeros_like(found)
    for three in corners:
        for k in range(3):
            top, i, j = three[k], three[(k + 1) % 3], three[(k + 2) % 3]
            first, second = places[i] - places[top], places[j] - places[top]
            cotangent = first @ second / np.linalg.norm(np.cross(first, second))
            expected[[i, j, i, j], [i, j, j, i]] += 0.5 * tension * cotangent * np.array([1, 1, -1, -1])
    np.testing.assert_allclose(found, expected, atol=1e-12 * tension)
