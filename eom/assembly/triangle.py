"""Plane-stress membrane triangles: constant strain, or with rotations about the normal at the corners.

The second kind is D. J. Allman's (Computers & Structures 19, 1984): each edge bends in the plane as a parabola
whose end slopes are the corners' rotations. Equal rotations of all corners then cost no energy, so that five
independent strains remain.
"""

from collections.abc import Sequence

import numpy as np

from eom.assembly.rows import arm_of
from eom.assembly.vectors import Array, skew, unit
from eom.vehicle.elements import Body, Connection, Triangle

SPURIOUS = 1e-9
CORNERS = ((0, 1), (1, 2), (2, 0))


def triangle_axes(triangle: Triangle) -> Array:
    """Unit vectors (3, 3): along the first edge, across it in the plane, normal to the plane."""
    a, b, c = (np.asarray(place, dtype=float) for place in triangle.places)
    first, normal = unit(b - a), unit(np.cross(b - a, c - a))
    return np.array([first, np.cross(normal, first), normal])


def corner_motions(bodies: Sequence[Body], triangle: Triangle) -> Array:
    """In-plane displacements and rotation (u, v, r) of the three corners, shape (9, 18)."""
    axes = triangle_axes(triangle)
    motions = np.zeros((9, 18))
    for k, (body, place) in enumerate(zip(triangle.bodies, triangle.places, strict=True)):
        motions[3 * k : 3 * k + 2, 6 * k : 6 * k + 3] = axes[:2]
        motions[3 * k : 3 * k + 2, 6 * k + 3 : 6 * k + 6] = -axes[:2] @ skew(arm_of(bodies, body, place))
        motions[3 * k + 2, 6 * k + 3 : 6 * k + 6] = axes[2]
    return motions


def plane_stress(triangle: Triangle) -> Array:
    """Stress per strain (xx, yy, twice xy), shape (3, 3) [Pa]."""
    E, nu = triangle.modulus, triangle.poisson
    factor = E / (1.0 - nu**2)
    return factor * np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, (1.0 - nu) / 2.0]])


def strain_of(gradients: Array) -> Array:
    """Strain per nodal displacements (u1, v1, u2, v2 ...), from the gradients (2, nodes) of their shapes."""
    strain = np.zeros((3, 2 * gradients.shape[1]))
    strain[0, 0::2] = strain[2, 1::2] = gradients[0]
    strain[1, 1::2] = strain[2, 0::2] = gradients[1]
    return strain


def constant_strain(places: Array) -> tuple[Array, float]:
    """Gradients of the three area coordinates, shape (2, 3), and the area, of corners in the plane (3, 2)."""
    (x1, y1), (x2, y2), (x3, y3) = places
    double = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)
    return np.array([[y2 - y3, y3 - y1, y1 - y2], [x3 - x2, x1 - x3, x2 - x1]]) / double, double / 2.0


def midside_motions(places: Array) -> Array:
    """Displacements of corners and midpoints of the edges, shape (12, 9), by the corners' (u, v, r)."""
    motions = np.zeros((12, 9))
    for corner in range(3):
        motions[2 * corner, 3 * corner] = motions[2 * corner + 1, 3 * corner + 1] = 1.0
    for k, (i, j) in enumerate(CORNERS):
        dx, dy = places[j] - places[i]
        for axis, bulge in ((0, -dy / 8.0), (1, dx / 8.0)):
            row = motions[6 + 2 * k + axis]
            row[3 * i + axis] = row[3 * j + axis] = 0.5
            row[3 * i + 2], row[3 * j + 2] = bulge, -bulge
    return motions


def quadratic_gradients(places: Array, area: Array) -> Array:
    """Gradients of the six quadratic shapes, corners then midpoints, shape (2, 6), at area coordinates (3,)."""
    linear, _ = constant_strain(places)
    corners = linear * (4.0 * area - 1.0)
    midpoints = [4.0 * (linear[:, i] * area[j] + linear[:, j] * area[i]) for i, j in CORNERS]
    return np.column_stack([corners, *midpoints])


def triangle_rows(bodies: Sequence[Body], triangle: Triangle) -> tuple[Array, Array]:
    """Independent strains over the bodies' coordinates, shape (modes, 18), and their stiffness, (modes, modes)."""
    axes, motions = triangle_axes(triangle), corner_motions(bodies, triangle)
    places = (np.array(triangle.places, dtype=float) - np.array(triangle.places[0])) @ axes[:2].T
    gradients, area = constant_strain(places)
    elasticity = plane_stress(triangle) * (area * triangle.thickness)
    if not triangle.drilling:
        corners = motions[[0, 1, 3, 4, 6, 7]]
        return strain_of(gradients) @ corners, elasticity
    mid = midside_motions(places)
    # three points at the middle of the edges integrate the square of a linear strain exactly
    strains = [strain_of(quadratic_gradients(places, (np.eye(3)[i] + np.eye(3)[j]) / 2.0)) @ mid for i, j in CORNERS]
    # rotations in radians and displacements in lengths of the triangle are of one size
    scale = np.tile([1.0, 1.0, 1.0 / np.sqrt(area)], 3)
    stiffness = sum((B.T @ elasticity @ B for B in strains), np.zeros((9, 9))) / 3.0
    values, modes = np.linalg.eigh(stiffness * np.outer(scale, scale))
    kept = values > SPURIOUS * values[-1]
    return (modes[:, kept] / scale[:, np.newaxis]).T @ motions, np.diag(values[kept])


def triangle_carried(bodies: Sequence[Body], triangle: Triangle, tensions: Array) -> list[tuple[Connection, Array]]:
    """What the membrane's load is as that of rods along its edges and of moments between its corners' bodies.

    The second order of a constant strain is that of its edges' lengths. Moments of the rotations add up to zero;
    they turn half with each body.
    """
    rows, _ = triangle_rows(bodies, triangle)
    places = np.array(triangle.places, dtype=float)
    wrenches = (rows.T @ tensions).reshape(3, 6)
    pulls = np.zeros((9, 3))
    for k, (i, j) in enumerate(CORNERS):
        along = unit(places[j] - places[i])
        pulls[3 * i : 3 * i + 3, k], pulls[3 * j : 3 * j + 3, k] = along, -along
    edges = np.asarray(np.linalg.lstsq(pulls, wrenches[:, :3].ravel(), rcond=None)[0], dtype=np.float64)
    normal = triangle_axes(triangle)[2]
    arms = [arm_of(bodies, body, place) for body, place in zip(triangle.bodies, places, strict=True)]
    moments = [normal @ (own[3:] - skew(r) @ own[:3]) for own, r in zip(wrenches, arms, strict=True)]
    carried: list[tuple[Connection, Array]] = []
    for k, (i, j) in enumerate(CORNERS):
        pair, (start, end) = (triangle.bodies[i], triangle.bodies[j]), (triangle.places[i], triangle.places[j])
        carried.append((Connection(triangle.name, pair, (start, end), forces=1, line=True), edges[k : k + 1]))
        if triangle.drilling:
            twist: Array = np.array([(moments[i] - moments[j]) / 3.0])
            axis = tuple(normal.tolist())
            carried.append((Connection(triangle.name, pair, (start, start), moments=1, moment_axis=axis), twist))
    return carried
