"""The multibody part: what is left of a vehicle without its tyres, in arrays for the nonlinear equations."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.algebra import DENSE
from eom.assembly.elastic import elastic_items
from eom.assembly.loads import load_sums, with_weight
from eom.assembly.matrices import Matrices, carried_loads
from eom.assembly.reduction import Pivots
from eom.assembly.rows import row_count
from eom.assembly.tangent import tangent_entries
from eom.assembly.vectors import Array, skew
from eom.splice.turning import Turning, turning
from eom.vehicle.elements import System

LEFT_OF_ZERO = 1e-13
"""Of the largest entry of an array: smaller ones are what rounding left of zero, and cost as much as others."""
LEAD = (0, 1, 5)
"""Coordinates of the lead body that locate the moving frame: x, y, yaw."""


class Multibody(NamedTuple):
    """A vehicle without tyres in a frame that moves and yaws with its lead body; N = 6 bodies.

    Displacements q are counted from that frame. Velocities w are whole ones: translations in the frame's axes,
    rotations in body axes; n are the independent ones among them, n[0] the lead's v_x.

    Attributes
    ----------
    M : Array
        Mass matrix (N, N).
    mass, inertia : Array
        Of the bodies, (bodies,) [kg] and (bodies, 3, 3) [kg m^2].
    C : Array
        Damping on w, of what moves parts against each other or the road, (N, N).
    C_slip : Array
        Damping on velocities in body axes less the straight run: slip and air other than wheels and drag, (N, N).
    K : Array
        Stiffness of springs, preloads and weight on displacements, (N, N); what joints carry is not in it.
    T : Array
        Displacements of all bodies by q, (N, q).
    W, W_turn : Array
        w = (W + sum_k q_k W_turn[k]) n, shapes (N, n) and (q, N n), the latter flattened.
    inert, inert_turn, inert_pairs : Array
        Mass on n: W'M W = inert + sum_k q_k inert_turn[k] + sum_p q_i q_j inert_pairs[p], (n, n) each, flattened.
    pairs : NDArray
        The i and j of each p, (2, pairs).
    rate : Array
        dq/dt = rate n.
    react : Array
        Reactions of the independent constraint rows per force on w, (rows, N).
    react_turn : Array
        Their change per displacement and reaction, (q, rows rows), flattened.
    f : Array
        Weight, loads and preloads, (N,).
    planar : Array
        Loads that turn with the heading of their body, (N,).
    B : Array
        Generalised force per input of the multibody part, (N, inputs), at the trim.
    steering : NDArray
        Body with whose heading each of these inputs turns, (inputs,).
    speed : float
        Of the trim [m/s], from which air's forces count.
    lead : Array
        Places of the lead's v_x, v_y and yaw rate in n.
    held : bool
        Whether the lead's speed is held.
    """

    M: Array
    mass: Array
    inertia: Array
    C: Array
    C_slip: Array
    K: Array
    T: Array
    W: Array
    W_turn: Array
    inert: Array
    inert_turn: Array
    inert_pairs: Array
    pairs: NDArray[np.intp]
    rate: Array
    react: Array
    react_turn: Array
    f: Array
    planar: Array
    B: Array
    steering: NDArray[np.intp]
    speed: float
    lead: NDArray[np.intp]
    held: bool


def multibody(system: System, pivots: Pivots, matrices: Matrices, speed: float, *, held: bool) -> Multibody:
    """The multibody part of a system; *matrices* are its own under the forces of the trim."""
    reduction, bodies = matrices.reduction, system.bodies
    own = np.flatnonzero(~np.isin(reduction.independent, LEAD))
    at = reduction.independent[own]
    T, W = reduction.T[:, own], reduction.W
    turned = Turning(*map(rounded, turning(system, pivots, matrices.J, reduction, T)))
    lead = np.searchsorted(reduction.independent, LEAD)
    rate = W[at].copy()
    rate[:, lead] -= frame_motion(system)[at]
    dependent = list(pivots.dependent)
    react = np.zeros((len(pivots.rows), len(matrices.M)))
    react_turn = np.zeros((len(at), react.shape[0], react.shape[0]))
    if reduction.factor is not None:
        react[:, dependent] = rounded(reduction.factor.solve_transposed(np.eye(len(dependent))))
        react_turn = rounded(-react[:, dependent] @ turned.rows[:, :, dependent].transpose(0, 2, 1))
    dead = [load for load in with_weight(system) if load.frame != load.body]
    f = load_sums(bodies, dead)[0] + matrices.H.T @ matrices.statics.tensions
    K = matrices.K_elastic + elastic_tangent(system, matrices) + matrices.K_load + matrices.K_camber
    for i in range(len(bodies)):
        # forces of body axes, resolved in those of the frame
        K[6 * i : 6 * i + 3, 6 * i + 3 : 6 * i + 6] += skew(f[6 * i : 6 * i + 3])
    return Multibody(
        M=matrices.M,
        mass=np.array([body.mass for body in bodies]),
        inertia=np.array([body.inertia for body in bodies]),
        C=matrices.C_damper,
        C_slip=matrices.C_slip,
        K=rounded(K),
        T=T,
        W=W,
        W_turn=turned.motions.reshape(len(at), W.size),
        **inertia(W, turned.motions, matrices.M),
        rate=rate,
        react=react,
        react_turn=react_turn.reshape(len(at), react.shape[0] ** 2),
        f=f,
        planar=load_sums(bodies, [load for load in system.loads if load.frame == load.body])[0],
        B=matrices.F,
        steering=np.array([max(item.connection.bodies[0], 0) for item in system.inputs], dtype=np.intp),
        speed=speed,
        lead=lead,
        held=held,
    )


def inertia(W: Array, turned: Array, M: Array) -> dict[str, Any]:
    """The mass on n as a polynomial of the displacements, see `Multibody`."""
    size = len(turned), W.shape[1] ** 2
    once = turned.transpose(0, 2, 1) @ M @ W
    i, j = np.tril_indices(len(turned))
    twice = turned[i].transpose(0, 2, 1) @ M @ turned[j]
    # a pair stands for both orders
    both = np.where((i == j)[:, np.newaxis, np.newaxis], twice, twice + twice.transpose(0, 2, 1))
    both = rounded(both)
    kept = np.any(both != 0.0, axis=(1, 2))
    return {
        "inert": rounded(W.T @ M @ W).ravel(),
        "inert_turn": rounded(once + once.transpose(0, 2, 1)).reshape(size),
        "inert_pairs": both[kept].reshape(-1, size[1]),
        "pairs": np.array((i[kept], j[kept])),
    }


def rounded(array: Array) -> Array:
    """An array without what is zero but for rounding."""
    return np.where(np.abs(array) > LEFT_OF_ZERO * np.max(np.abs(array), initial=0.0), array, 0.0)


def frame_motion(system: System) -> Array:
    """Displacement of all coordinates when the frame moves along x, along y, or turns about the lead's centre."""
    motion = np.zeros((6 * len(system.bodies), 3))
    for k, body in enumerate(system.bodies):
        x, y, _ = np.subtract(body.centre, system.bodies[0].centre)
        motion[6 * k, (0, 2)] = 1.0, -y
        motion[6 * k + 1, (1, 2)] = 1.0, x
        motion[6 * k + 5, 2] = 1.0
    return motion


def elastic_tangent(system: System, matrices: Matrices) -> Array:
    """Tangent stiffness of the preloads of springs, without that of the joints' reactions."""
    joints = len(system.constraints)
    carried = carried_loads(system, elastic_items(system), matrices.statics)[joints:]
    return DENSE.build(matrices.M.shape, tangent_entries(system.bodies, carried))


def row_of(system: System, pivots: Pivots, name: str) -> int:
    """Place of a constraint's first row among the independent ones; ``ValueError`` if it is not among them."""
    row = 0
    for item in system.constraints:
        if item.connection.name == name:
            break
        row += row_count(item.connection)
    return pivots.rows.index(row)
