"""Constraint rows and partial velocities of a slightly displaced system.

A reaction that is turned by a displacement does work on other motions than at the trim. The tangent stiffness of
unit reactions tells which: the transposed rows on body axes change by minus that stiffness times the displacement.
Here translations are resolved in the axes of the moving frame, where a forward motion of the whole is the same at any
displacement.
"""

from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import square_entry
from eom.assembly.reduction import Pivots, Reduction
from eom.assembly.rows import row_count
from eom.assembly.tangent import connection_tangent
from eom.assembly.vectors import Array, skew
from eom.vehicle.elements import System


class Turning(NamedTuple):
    """First order of J and W, with J W = 0, per independent displacement.

    Attributes
    ----------
    rows : Array
        Change of the independent constraint rows, (q, rows, N).
    motions : Array
        Change of the velocities w per independent velocity n, (q, N, n).
    """

    rows: Array
    motions: Array


def turned_rows(system: System, rows: tuple[int, ...], displacements: Array) -> Array:
    """Change of constraint rows over the velocities, per column of *displacements* (N, q); shape (q, rows, N)."""
    result = np.zeros((displacements.shape[1], len(rows), displacements.shape[0]))
    place = {row: k for k, row in enumerate(rows)}
    row = 0
    for item in system.constraints:
        count = row_count(item.connection)
        for reaction in np.eye(count):
            if row in place:
                tangent = connection_tangent(system.bodies, item.connection, reaction)
                where, columns, stiffness = square_entry(item.connection.bodies, tangent)
                result[:, place[row], where] -= (stiffness @ displacements[columns]).T
            row += 1
    return result


def turning(system: System, pivots: Pivots, J: Array, reduction: Reduction, displacements: Array) -> Turning:
    """Turned rows and motions of a system without rolling constraints; see `Turning`."""
    rows = turned_rows(system, pivots.rows, displacements)
    for k, displacement in enumerate(displacements.T):
        for i in range(len(system.bodies)):
            # body axes see a velocity v of the frame's axes as v - theta x v
            own = slice(6 * i, 6 * i + 3)
            rows[k, :, own] -= J[list(pivots.rows), own] @ skew(displacement[6 * i + 3 : 6 * i + 6])
    motions = np.zeros((displacements.shape[1], *reduction.W.shape))
    if reduction.factor is not None:
        for k, change in enumerate(rows):
            motions[k, list(pivots.dependent)] = -reduction.factor.solve(change @ reduction.W)
    return Turning(rows, motions)
