"""Bushings with full matrices, from the file, as sums of springs."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import eom
from tests.assembly.systems import Array

ENDS = np.array(
    [[0.1, 0.2, 0.0], [-0.2, 0.1, 0.3], [0.0, -0.3, 0.1], [0.2, 0.2, -0.2], [-0.1, 0.0, -0.3], [0.3, -0.1, 0.2]]
)
ALONG = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.8, 0], [0, 0.6, -0.8], [0.8, 0, 0.6]])
STIFF = np.array([100.0, 250.0, 80.0, 40.0, 300.0, 120.0])
PLACE = np.array([0.4, -0.3, 0.9])
BODIES = """
name: two bodies
bodies:
  a: {mass: 1, at: [0, 0, 1], inertia: {xx: 1, yy: 1, zz: 1}}
  b: {mass: 2, at: [1, 0.5, 0.7], inertia: {xx: 2, yy: 1.5, zz: 1}}
connectors:
"""


def by_springs() -> str:
    """Six springs between the bodies around the place."""
    lines = []
    for k, (end, n, stiffness) in enumerate(zip(PLACE + ENDS, ALONG, STIFF, strict=True)):
        ends = [end.tolist(), (end + n).tolist()]
        lines.append(f"  s{k}: {{type: spring, between: [a, b], ends: {ends}, stiffness: {stiffness}, damping: 1.5}}\n")
    return BODIES + "".join(lines)


def by_bushing(axes: Array, stiffness: Array, damping: Array) -> str:
    """One bushing whose matrices refer to the given axes."""
    return BODIES + (
        f"  bush:\n    type: bushing\n    between: [a, b]\n    at: {PLACE.tolist()}\n    axes: {axes[:2].tolist()}\n"
        f"    stiffness: {stiffness.tolist()}\n    damping: {damping.tolist()}\n"
    )


def resolved(axes: Array, weights: Array) -> Array:
    """Sum of weight times (n, r x n) (n, r x n)' of the springs, along the axes."""
    rows = np.hstack([ALONG, np.cross(ENDS, ALONG)])
    turn = np.kron(np.eye(2), axes)
    return np.asarray(turn @ (rows.T * weights) @ rows @ turn.T)


@pytest.mark.parametrize("rotation", [np.zeros(3), np.array([0.4, -0.9, 1.3]), np.array([0.0, 0.0, np.pi / 2])])
def test_a_bushing_is_the_sum_of_its_springs_on_any_axes(rotation: Array) -> None:
    axes = np.asarray(Rotation.from_rotvec(rotation).as_matrix())
    bushing = eom.assemble(eom.loads(by_bushing(axes, resolved(axes, STIFF), resolved(axes, np.full(6, 1.5)))))
    springs = eom.assemble(eom.loads(by_springs()))
    # text of sixteen digits, six terms each
    np.testing.assert_allclose(bushing.K, springs.K, atol=1e-11 * np.max(np.abs(springs.K)))
    np.testing.assert_allclose(bushing.C, springs.C, atol=1e-11 * np.max(np.abs(springs.C)))


def test_axes_need_no_length() -> None:
    axes = np.eye(3)
    leaning = np.array([[5.0, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 1.0]])
    K = resolved(axes, STIFF)
    one, other = (eom.assemble(eom.loads(by_bushing(pair, K, 0.0 * K))).K for pair in (axes, leaning))
    np.testing.assert_allclose(one, other, atol=1e-12 * np.max(np.abs(one)))


def test_a_bushing_carries_weight_by_any_of_its_couplings() -> None:
    """Held by a matrix with off-diagonal terms alone it deflects by the inverse of the matrix."""
    K = resolved(np.eye(3), STIFF)
    file = f"""
name: hung
gravity: 9.81
bodies:
  a: {{mass: 3, at: {PLACE.tolist()}, inertia: {{xx: 1, yy: 1, zz: 1}}}}
connectors:
  bush: {{type: bushing, between: [a, ground], at: {PLACE.tolist()}, axes: [[1,0,0],[0,1,0]], stiffness: {K.tolist()}}}
"""
    found = eom.assemble(eom.loads(file)).matrices.statics
    np.testing.assert_allclose(found.deflection, np.linalg.solve(K, [0, 0, -3 * 9.81, 0, 0, 0]), rtol=1e-9)
    np.testing.assert_allclose(found.tensions, [0, 0, 3 * 9.81, 0, 0, 0], atol=1e-10)
