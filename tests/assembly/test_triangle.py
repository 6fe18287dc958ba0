"""Membrane triangles: patch test, rigid motions, Cook's membrane.

Reference: R. D. Cook, Journal of the Structural Division 100 (1974) 1851-1863; the converged vertical displacement of
the loaded edge's middle is 23.96 (elements of high order on fine meshes). Tolerance of what is exact: 1e-9.
"""

import numpy as np
import pytest

from eom.vehicle.elements import GROUND, Constraint, Load, System, Triangle
from tests.assembly.systems import EMPTY, ZERO, Array, Z, assembled, body, point, vector

E_MODULUS, POISSON = 1.0, 1.0 / 3.0
RELATIVE = 1e-9


def mesh(places: Array, triangles: list[tuple[int, int, int]], *, drilling: bool, held: list[int]) -> System:
    """Nodes in the plane z = 0 that move in it and turn about z; those of *held* do not move."""
    bodies = tuple(body(f"n{k}", (float(x), float(y), 0.0), 0.0) for k, (x, y) in enumerate(places))
    guides = [
        Constraint(
            point((k, GROUND), node.centre, forces=3, moments=3)
            if k in held
            else point((k, GROUND), node.centre, forces=1, moments=2, axis=Z)
        )
        for k, node in enumerate(bodies)
    ]
    items = tuple(
        Triangle(
            f"t{k}",
            (a, b, c),
            (bodies[a].centre, bodies[b].centre, bodies[c].centre),
            1.0,
            E_MODULUS,
            POISSON,
            drilling,
        )
        for k, (a, b, c) in enumerate(triangles)
    )
    if not drilling:
        # nothing resists the turning of a node
        guides += [
            Constraint(point((k, GROUND), bodies[k].centre, moments=1)) for k in range(len(bodies)) if k not in held
        ]
    return EMPTY._replace(bodies=bodies, constraints=tuple(guides), triangles=items)


PATCH = np.array([(0.0, 0.0), (3.0, 0.0), (3.3, 2.0), (-0.2, 2.4), (1.4, 0.8)])
FAN = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]


@pytest.mark.parametrize("drilling", [False, True])
def test_constant_strain_has_its_exact_energy_on_any_mesh(drilling: bool) -> None:
    """The patch test: displacements linear in the place, nodes turned by the mean rotation."""
    gradient = np.array([[0.3, -0.5], [0.2, 0.4]])
    system = mesh(PATCH, FAN, drilling=drilling, held=[])
    K = assembled(system).K_elastic
    p = np.zeros(len(K))
    for k, place in enumerate(PATCH):
        p[6 * k : 6 * k + 2] = gradient @ place
        p[6 * k + 5] = (gradient[1, 0] - gradient[0, 1]) / 2.0
    strain = np.array([gradient[0, 0], gradient[1, 1], gradient[0, 1] + gradient[1, 0]])
    D = E_MODULUS / (1.0 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    x, y = PATCH[:4].T
    area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    np.testing.assert_allclose(p @ K @ p, area * strain @ D @ strain, rtol=RELATIVE)
    inner = (K @ p)[24:26]
    np.testing.assert_allclose(inner, 0.0, atol=1e-12)


@pytest.mark.parametrize(("drilling", "modes"), [(False, 3), (True, 5)])
def test_a_triangle_has_as_many_independent_strains_as_said_and_lets_rigid_motions_be(
    drilling: bool, modes: int
) -> None:
    """In any attitude: the element is drawn skew in space, its nodes beside their places."""
    rng = np.random.default_rng(4)
    centres = [vector(rng.normal(size=3)) for _ in range(3)]
    corners = (vector(rng.normal(size=3)), vector(rng.normal(size=3)), vector(rng.normal(size=3)))
    bodies = tuple(body(f"n{k}", centre) for k, centre in enumerate(centres))
    item = Triangle("t", (0, 1, 2), corners, 0.1, 5.0, 0.3, drilling)
    found = assembled(EMPTY._replace(bodies=bodies, triangles=(item,)))
    assert found.H.shape == (modes, 18)
    assert np.linalg.matrix_rank(found.K_elastic, tol=1e-9 * np.max(np.abs(found.K_elastic))) == modes
    np.testing.assert_allclose(found.K_elastic, found.K_elastic.T, atol=1e-12)
    velocity, spin = rng.normal(size=3), rng.normal(size=3)
    p = np.concatenate([np.concatenate([velocity + np.cross(spin, c), spin]) for c in centres])
    np.testing.assert_allclose(found.K_elastic @ p, 0.0, atol=1e-12)


def cook(divisions: int, *, drilling: bool) -> float:
    """Vertical displacement of the middle of the loaded edge of Cook's membrane."""
    places, triangles = [], []
    n = divisions
    for i in range(n + 1):
        x = 48.0 * i / n
        low, high = 44.0 * i / n, 44.0 + 16.0 * i / n
        places += [(x, low + (high - low) * j / n) for j in range(n + 1)]
    for i in range(n):
        for j in range(n):
            a, b = i * (n + 1) + j, (i + 1) * (n + 1) + j
            # the shorter diagonal
            triangles += [(a, b, a + 1), (b, b + 1, a + 1)]
    system = mesh(np.array(places), triangles, drilling=drilling, held=list(range(n + 1)))
    right = [n * (n + 1) + j for j in range(n + 1)]
    shares = np.full(n + 1, 1.0 / n)
    shares[[0, -1]] /= 2.0
    loads = tuple(
        Load(f"edge {k}", node, system.bodies[node].centre, (0.0, float(share), 0.0), ZERO)
        for k, (node, share) in enumerate(zip(right, shares, strict=True))
    )
    return float(assembled(system._replace(loads=loads)).statics.deflection[6 * right[n // 2] + 1])


def test_cook_s_membrane_converges_from_below_to_its_reference() -> None:
    """Constant strain is stiff (11.99, 18.28 and 22.02 are known for it); drilling rotations bend far better."""
    constant = [cook(n, drilling=False) for n in (2, 4, 8)]
    turning = [cook(n, drilling=True) for n in (2, 4, 8)]
    assert constant[0] < constant[1] < constant[2] < 23.96
    assert turning[0] < turning[1] < turning[2] < 24.1
    assert all(better > worse for better, worse in zip(turning, constant, strict=True))
    np.testing.assert_allclose(constant, [11.99, 18.28, 22.02], atol=0.005)
    # the error of a linear strain falls with the square of the mesh, but for the corner's singularity
    np.testing.assert_allclose((4.0 * turning[2] - turning[1]) / 3.0, 23.96, rtol=0.01)
