"""The matrices of the linear equations of motion about the trim.

    M dw/dt + C w + K p = F u + G du/dt + J' reactions,   dp/dt + V p - w = 0,   J p = 0,   Jn w = 0

p holds small displacements and rotations of the centres of mass in inertial axes, w velocities and angular
velocities in body axes, six a body.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import DENSE, Algebra, Entry, block_diagonal, row_entry, square_entry, stacked
from eom.assembly.beam import beam_carried
from eom.assembly.elastic import Strained, damping_entries, elastic_items, inertance_entries, stiffness_entries
from eom.assembly.inertia import kinematic_entries, mass_entries, momentum_entries
from eom.assembly.loads import load_stiffness, load_sums, with_weight
from eom.assembly.reduction import Pivots, Reduction, reduce_coordinates
from eom.assembly.rows import local_rows, row_count
from eom.assembly.statics import Balancing, Statics, equilibrium
from eom.assembly.tangent import tangent_entries
from eom.assembly.triangle import triangle_carried
from eom.assembly.vectors import Array, array, zeros
from eom.vehicle.elements import Connection, System

DISPLACEMENTS = ("x", "y", "z", "roll", "pitch", "yaw")
VELOCITIES = ("v_x", "v_y", "v_z", "roll_rate", "pitch_rate", "yaw_rate")


class Matrices(NamedTuple):
    """Full-coordinate matrices; N = 6 times the number of bodies, rows and columns in their order.

    Attributes
    ----------
    M : Array
        Mass, (N, N).
    C : Array
        All that multiplies w: momentum, dampers and slip, (N, N).
    K : Array
        All that multiplies p: elastic, tangent, load and moving-damper stiffness, camber thrust, (N, N).
    V : Array
        Kinematic matrix, (N, N).
    J, Jn : Array
        Holonomic and nonholonomic constraint rows.
    H : Array
        Elastic rows; their stiffness and damping, block-diagonal, in ``H_stiffness`` and ``H_damping``.
    H_slip : Array
        Slip rows, kept apart, with their coefficients ``D_slip``: C contains H_slip' D_slip H_slip.
    F, G : Array
        Generalised force per input and per rate of input, (N, inputs).
    f : Array
        Applied loads and weight, (N,).
    M_body, M_inertance, M_added : Array
        Terms of M: bodies, inerters and beams (which feel the second rate of p), and fluid (which feels dw/dt).
    K_elastic, K_tangent, K_load, K_damper, K_camber : Array
        Terms of K.
    C_momentum, C_damper, C_inertance, C_slip : Array
        Terms of C.
    statics : Statics
    reduction : Reduction
    """

    M: Array
    C: Array
    K: Array
    V: Array
    J: Array
    Jn: Array
    H: Array
    H_stiffness: Array
    H_damping: Array
    H_slip: Array
    D_slip: Array
    F: Array
    G: Array
    f: Array
    M_body: Array
    M_inertance: Array
    M_added: Array
    K_elastic: Array
    K_tangent: Array
    K_load: Array
    K_damper: Array
    K_camber: Array
    C_momentum: Array
    C_damper: Array
    C_inertance: Array
    C_slip: Array
    statics: Statics
    reduction: Reduction


def connection_stack(system: System, connections: list[Connection], algebra: Algebra = DENSE) -> Array:
    """Rows of several connections, one below the other."""
    blocks = [(item.bodies, local_rows(system.bodies, item)) for item in connections]
    return stacked(blocks, 6 * len(system.bodies), algebra)


def joint_rows(system: System, algebra: Algebra = DENSE) -> tuple[Array, Array]:
    """J and Jn."""
    joints = [item.connection for item in system.constraints]
    return connection_stack(system, joints, algebra), connection_stack(system, list(system.rolling), algebra)


def slip_entries(system: System, which: str) -> Iterator[Entry]:
    """Damping (*which* = ``coefficients``) or mass (``added_mass``) of slip elements, over all coordinates."""
    for item in system.slip:
        matrix = array(getattr(item, which))
        if matrix.size:
            own = local_rows(system.bodies, item.connection)
            yield square_entry(item.connection.bodies, own.T @ matrix @ own)


def camber_entries(system: System) -> Iterator[Entry]:
    """Camber thrust, the force of slip elements by the angle of their first body, over all coordinates."""
    for item in system.slip:
        if item.camber:
            turning = item.connection._replace(forces=0, moments=1, moment_axis=item.camber_axis)
            force = np.outer(item.camber, local_rows(system.bodies, turning)[0])
            yield square_entry(item.connection.bodies, local_rows(system.bodies, item.connection).T @ force)


def input_columns(system: System, which: str) -> Array:
    """Generalised forces of the inputs (*which* = ``gain``) or of their rates (``rate_gain``), (N, inputs)."""
    forces = []
    for item in system.inputs:
        gain = array(item.gain if which == "gain" else item.rate_gain)
        _, where, values = row_entry(0, item.connection.bodies, local_rows(system.bodies, item.connection))
        forces.append((where, values.T @ gain))
    columns = zeros((6 * len(system.bodies), len(forces)), *(force for _, force in forces))
    for k, (where, force) in enumerate(forces):
        columns[where, k] = force
    return columns


def split(values: Array, counts: list[int]) -> list[Array]:
    """*values* cut into consecutive pieces of the given lengths."""
    return [np.asarray(piece) for piece in np.split(values, np.cumsum(counts)[:-1])] if counts else []


def carried_loads(system: System, items: list[Strained], statics: Statics) -> list[tuple[Connection, Array]]:
    """Connections of joints and elastic items with what they carry."""
    joints = [item.connection for item in system.constraints]
    reactions = split(statics.reactions, [row_count(item) for item in joints])
    tensions = split(statics.tensions, [len(item.rows) for item in items])
    carried = list(zip(joints, reactions, strict=True))
    carried += [
        (item.connection, own) for item, own in zip(items, tensions, strict=True) if item.connection is not None
    ]
    structures = [own for item, own in zip(items, tensions, strict=True) if item.connection is None]
    bent, strained = structures[: len(system.beams)], structures[len(system.beams) :]
    for beam, own in zip(system.beams, bent, strict=True):
        carried += beam_carried(system.bodies, beam, own, system.gravity)
    for triangle, own in zip(system.triangles, strained, strict=True):
        carried += triangle_carried(system.bodies, triangle, own)
    return carried


def assemble_matrices(
    system: System, pivots: Pivots, algebra: Algebra = DENSE, balance: Balancing = equilibrium
) -> Matrices:
    """Assemble a system's matrices about its trim, statics included, which *balance* solves.

    Raises ``ValueError`` where the pivots do not fit the joints.
    """
    bodies = system.bodies
    N = 6 * len(bodies)
    square = (N, N)
    J, Jn = joint_rows(system, algebra)
    V = algebra.build(square, kinematic_entries(bodies))
    reduction = reduce_coordinates(J, Jn, V, pivots, algebra)
    items, loads = elastic_items(system), with_weight(system)
    sums = load_sums(bodies, loads)
    H = stacked([(item.bodies, item.rows) for item in items], N, algebra)
    statics = balance(bodies, (items, H), (J, pivots, reduction), sums, algebra)
    M_parts = (
        algebra.build(square, mass_entries(bodies)),
        algebra.build(square, inertance_entries(items)),
        algebra.build(square, slip_entries(system, "added_mass")),
    )
    C_damper = algebra.build(square, damping_entries(items))
    K_parts = (
        algebra.build(square, stiffness_entries(items)),
        algebra.build(square, tangent_entries(bodies, carried_loads(system, items, statics))),
        algebra.build(square, load_stiffness(bodies, loads)),
        # a damper feels dp/dt = w - V p
        -(C_damper @ V),
        algebra.build(square, camber_entries(system)),
    )
    C_parts = (
        algebra.build(square, momentum_entries(bodies)),
        C_damper,
        # an inerter feels the rate of that, dw/dt - V w, as V V = 0
        -(M_parts[1] @ V),
        algebra.build(square, slip_entries(system, "coefficients")),
    )
    return Matrices(
        M_parts[0] + M_parts[1] + M_parts[2],
        C_parts[0] + C_parts[1] + C_parts[2] + C_parts[3],
        K_parts[0] + K_parts[1] + K_parts[2] + K_parts[3] + K_parts[4],
        V,
        J,
        Jn,
        H,
        block_diagonal([item.stiffness for item in items], algebra),
        block_diagonal([item.damping for item in items], algebra),
        connection_stack(system, [item.connection for item in system.slip], algebra),
        block_diagonal([array(item.coefficients) for item in system.slip], algebra),
        input_columns(system, "gain"),
        input_columns(system, "rate_gain"),
        sums[0],
        *M_parts,
        *K_parts,
        *C_parts,
        statics,
        reduction,
    )
