"""The matrices of the linear equations of motion about the trim.

    M dw/dt + C w + K p = F u + G du/dt + J' reactions,   dp/dt + V p - w = 0,   J p = 0,   Jn w = 0

p holds small displacements and rotations of the centres of mass in inertial axes, w velocities and angular
velocities in body axes, six a body.
"""

from typing import NamedTuple

import numpy as np

from eom.assembly.inertia import kinematic_matrix, mass_matrix, momentum_matrix
from eom.assembly.loads import load_resultants, load_stiffness, with_weight
from eom.assembly.rows import rows, stack
from eom.assembly.statics import Statics, elastic_coefficients, equilibrium
from eom.assembly.tangent import tangent_stiffness
from eom.assembly.vectors import Array
from eom.vehicle.elements import System

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
        All that multiplies p: elastic, tangent, load and moving-damper stiffness, (N, N).
    V : Array
        Kinematic matrix, (N, N).
    J, Jn : Array
        Holonomic and nonholonomic constraint rows.
    H : Array
        Elastic rows; their stiffness and damping in ``H_stiffness`` and ``H_damping``.
    H_slip : Array
        Slip rows, kept apart, with their coefficients ``Theta``: C contains H_slip' Theta H_slip.
    F, G : Array
        Generalised force per input and per rate of input, (N, inputs).
    f : Array
        Applied loads and weight, (N,).
    K_elastic, K_tangent, K_load, K_damper, C_momentum, C_damper, C_slip : Array
        The terms that K and C are the sums of.
    statics : Statics
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
    Theta: Array
    F: Array
    G: Array
    f: Array
    K_elastic: Array
    K_tangent: Array
    K_load: Array
    K_damper: Array
    C_momentum: Array
    C_damper: Array
    C_slip: Array
    statics: Statics


def slip_coefficients(system: System) -> Array:
    """Theta: block-diagonal slip coefficients, square, one row per slip row [N s/m, N s]."""
    blocks = [np.array(item.coefficients, dtype=float) for item in system.slip]
    size = sum(len(block) for block in blocks)
    Theta = np.zeros((size, size))
    at = 0
    for block in blocks:
        Theta[at : at + len(block), at : at + len(block)] = block
        at += len(block)
    return Theta


def input_columns(system: System, which: str) -> Array:
    """Generalised forces of the inputs (*which* = ``gain``) or of their rates (``rate_gain``), (N, inputs)."""
    columns = np.zeros((6 * len(system.bodies), len(system.inputs)))
    for k, item in enumerate(system.inputs):
        gain = np.array(item.gain if which == "gain" else item.rate_gain, dtype=float)
        columns[:, k] = rows(system.bodies, item.connection).T @ gain
    return columns


def split(values: Array, counts: list[int]) -> list[Array]:
    """*values* cut into consecutive pieces of the given lengths."""
    return [np.asarray(piece) for piece in np.split(values, np.cumsum(counts)[:-1])] if counts else []


def assemble_matrices(system: System) -> Matrices:
    """Assemble a system's matrices about its trim, statics included."""
    bodies = system.bodies
    joints = [item.connection for item in system.constraints]
    springs = [item.connection for item in system.elastic]
    J, H = stack(bodies, joints), stack(bodies, springs)
    H_slip, Theta = stack(bodies, [item.connection for item in system.slip]), slip_coefficients(system)
    V = kinematic_matrix(bodies)
    k, c = elastic_coefficients(system.elastic, "stiffness"), elastic_coefficients(system.elastic, "damping")
    loads = with_weight(bodies, system.loads, system.gravity)
    resultants = load_resultants(bodies, loads)
    f = np.sum(resultants, axis=0)
    statics = equilibrium(bodies, J, H, k, resultants)
    carried = [
        *split(statics.reactions, [len(rows(bodies, item)) for item in joints]),
        *split(statics.tensions, [len(rows(bodies, item)) for item in springs]),
    ]
    C_damper = (H.T * c) @ H
    K_parts = (
        (H.T * k) @ H,
        tangent_stiffness(bodies, [*joints, *springs], carried),
        load_stiffness(bodies, loads),
        # a damper feels dp/dt = w - V p
        -C_damper @ V,
    )
    C_parts = (momentum_matrix(bodies), C_damper, H_slip.T @ Theta @ H_slip)
    return Matrices(
        mass_matrix(bodies),
        sum(C_parts, np.zeros_like(V)),
        sum(K_parts, np.zeros_like(V)),
        V,
        J,
        stack(bodies, system.rolling),
        H,
        k,
        c,
        H_slip,
        Theta,
        input_columns(system, "gain"),
        input_columns(system, "rate_gain"),
        f,
        *K_parts,
        *C_parts,
        statics,
    )
