"""The linear tyres taken out of the damping matrix, as in Zhu's thesis, (3.46) and (3.47)."""

from dataclasses import dataclass

import numpy as np

from eom.assembly.algebra import DENSE, block_diagonal
from eom.assembly.vectors import Array, array
from eom.errors import DescriptionError
from eom.model.assembly import Assembly, assemble
from eom.vehicle.elements import Slip, System
from eom.vehicle.load import Vehicle

WAYS = ("lateral", "longitudinal")
"""Rows of a wheel, as `eom.splice.linear_tyres` names them."""


@dataclass(frozen=True)
class Reformulation:
    """The multibody part without tyres, which take slip velocities from it and give forces back on the same rows.

    With x = (p, w) = R z all displacements and velocities, dz/dt = A1 x - A2 (0, H' f), where f are the tyres' forces;
    linear ones are f = -coefficients H w, so that Theta = H' coefficients H and dz/dt = (A1 + A2 diag(0, Theta)) R z.
    N = 6 bodies, z independent displacements and velocities, r rows.

    Attributes
    ----------
    C_unity : Array
        Damping matrix with every cornering and slip stiffness set to one, (N, N).
    Theta : Array
        The tyres' part of the damping matrix, (N, N).
    C_rest : Array
        The damping matrix without tyres, C - Theta, (N, N).
    A1, A2 : Array
        Shapes (z, 2 N): rates of z by x, and by what stands on the left of the equations, thesis (3.47).
    R : Array
        x = R z, (2 N, z).
    H : Array
        The tyres' rows (deflection matrix): slip velocities by w and, transposed, forces on w by the tyres', (r, N).
    coefficients : Array
        Force per slip velocity, (r, r) [N s/m].
    rows, coordinates, velocities, independent : tuple of str
        Names of the rows of H, of p, of w and of z.
    """

    C_unity: Array
    Theta: Array
    C_rest: Array
    A1: Array
    A2: Array
    R: Array
    H: Array
    coefficients: Array
    rows: tuple[str, ...]
    coordinates: tuple[str, ...]
    velocities: tuple[str, ...]
    independent: tuple[str, ...]


def reformulate(vehicle: Vehicle | Assembly) -> Reformulation:
    """Take the linear tyres out of a vehicle's damping matrix; raises as `eom.assemble`, and if it has no tyres."""
    assembly = vehicle if isinstance(vehicle, Assembly) else assemble(vehicle)
    tyres = tyre_elements(assembly.system)
    if not tyres:
        raise DescriptionError([assembly.vehicle.mistake("", "has no axles with tyres that could be taken out")])
    matrices, speed = assembly.matrices, assembly.vehicle.speed
    at = [row for _, rows in tyres for row in rows]
    H, coefficients = matrices.H_slip[at], matrices.D_slip[np.ix_(at, at)]
    # the first entry of an element is its stiffness over the speed; others, such as trail, are multiples of it
    own = [array(item.coefficients) for item, _ in tyres]
    unity = block_diagonal([item / (item[0, 0] * speed) if item[0, 0] else 0.0 * item for item in own], DENSE)
    Theta = H.T @ coefficients @ H
    C_rest = assembly.C - Theta
    R, L = assembly.R, assembly.L
    N = len(assembly.M)
    zero, one = np.zeros((N, N)), np.eye(N)
    E = L.T @ np.block([[one, zero], [zero, assembly.M]]) @ R
    # rows of lengths and of masses stand together: elimination keeps the digits of both only if they are of one size
    size = np.max(np.abs(E), axis=1, keepdims=True)
    A2 = -np.linalg.solve(E / size, L.T / size)
    return Reformulation(
        C_unity=C_rest + H.T @ unity @ H,
        Theta=Theta,
        C_rest=C_rest,
        A1=A2 @ np.block([[assembly.V, -one], [assembly.K, C_rest]]),
        A2=A2,
        R=R,
        H=H,
        coefficients=coefficients,
        rows=tuple(assembly.slip_rows[k] for k in at),
        coordinates=assembly.coordinates,
        velocities=assembly.velocities,
        independent=assembly.independent,
    )


def tyre_elements(system: System) -> tuple[tuple[Slip, tuple[int, ...]], ...]:
    """The slip elements that are tyres of axles, each with the places of its rows among all slip rows."""
    names = {name for wheel in system.wheels for name in (wheel.axle, *(f"{wheel.name}.{way}" for way in WAYS))}
    found, row = [], 0
    for item in system.slip:
        rows = tuple(range(row, row + len(item.coefficients)))
        if item.connection.name in names:
            found.append((item, rows))
        row += len(rows)
    return tuple(found)
