"""Springs, dampers and inerters of the referee `tests.referees.spatial`, and the loads they carry at the trim."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.linalg import block_diag

from eom.vehicle.elements import Body, Bushing, Connection, Elastic, System
from tests.referees.elimination import RANK
from tests.referees.finite_motion import measures
from tests.referees.jets import Array, Jet


class Spring(NamedTuple):
    """What a connection measures, and the matrices (directions, directions) of its linear law; given load or None."""

    connection: Connection
    measures: list[Jet]
    stiffness: Array
    damping: Array
    inertance: Array
    preload: float | None


def springs_of(system: System) -> list[Spring]:
    """All springs and bushings; ``ValueError`` for what is no law of finite motion."""
    if system.beams or system.triangles:
        raise ValueError("beams and membranes are linear elements: finite motion does not judge them")
    return [
        *(simple(system.bodies, item) for item in system.elastic),
        *(full(system.bodies, item) for item in system.bushings),
    ]


def simple(bodies: tuple[Body, ...], item: Elastic) -> Spring:
    """The same law in each direction of force, and in each of moment."""
    connection = item.connection
    counts = (1 if connection.line else connection.forces, connection.moments)
    k, c, b = (np.diag(np.repeat(np.array(pair), counts)) for pair in (item.stiffness, item.damping, item.inertance))
    return Spring(connection, measures(bodies, connection), k, c, b, item.preload)


def full(bodies: tuple[Body, ...], item: Bushing) -> Spring:
    """Matrices in axes of their own: the columns of ``turn``."""
    turn = np.linalg.qr(np.array([*item.axes, np.cross(*item.axes)]).T)
    axes = turn.Q * np.sign(np.diag(turn.R))
    both = block_diag(axes, axes)
    stiffness, damping = (both @ np.array(matrix) @ both.T for matrix in (item.stiffness, item.damping))
    law = measures(bodies, item.connection._replace(forces=3, moments=3))
    return Spring(item.connection, law, stiffness, damping, np.zeros((6, 6)), None)


def statics(J: Array, H: Array, springs: Sequence[Spring], load: Array) -> tuple[Array, Array]:
    """Reactions and spring loads of a structure that statics alone determines.

    A spring's load is in the range of its stiffness, or given; ``ValueError`` where something is left open.
    """
    given = np.concatenate([np.zeros(0), *(np.full(len(item.measures), item.preload or 0.0) for item in springs)])
    carrying = block_diag(np.zeros((0, 0)), *(carried_by(item) for item in springs))
    transposed = np.vstack([J, carrying.T @ H]).T
    solution, _, rank, _ = np.linalg.lstsq(transposed, -load - H.T @ given, rcond=RANK)
    if rank < transposed.shape[1]:
        raise ValueError("statics alone leaves the preloads open")
    return solution[: len(J)], given + carrying @ solution[len(J) :]


def carried_by(spring: Spring) -> Array:
    """Orthonormal columns of the loads that a spring can carry, none if its load is given."""
    left, sizes, _ = np.linalg.svd(spring.stiffness)
    rank = 0 if spring.preload is not None else int(np.sum(sizes > RANK * max(float(sizes[0]), 1e-300)))
    return np.asarray(left[:, :rank], dtype=np.float64)
