"""Velocities of all bodies at a state.

Every velocity is W(q) n, with W to first order in the displacements q; Kane's equations with these very velocities
keep the balance of power, and turn every force by articulation and roll.
"""

from typing import Any

import numpy as np

from eom.splice.state import Model, Motion, State


def headed(vectors: Any, yaw: Any) -> Any:
    """Translational parts, (N,), turned about z by an angle per body, (bodies,)."""
    result = vectors.reshape(-1, 6) + 0.0 * yaw[:, np.newaxis]
    x, y = vectors[0::6], vectors[1::6]
    cos, sin = np.cos(yaw), np.sin(yaw)
    result[:, 0], result[:, 1] = cos * x - sin * y, sin * x + cos * y
    return result.ravel()


def motion(state: State, p: Model) -> Motion:
    """Velocities of all bodies."""
    body = p.body
    shape = body.W.shape
    W = body.W + (state.q @ body.W_turn).reshape(shape)
    w, dq, displaced = W @ state.n, body.rate @ state.n, body.T @ state.q
    drift = (dq @ body.W_turn).reshape(shape) @ state.n
    i, j = body.pairs
    mass = body.inert + state.q @ body.inert_turn + (state.q[i] * state.q[j]) @ body.inert_pairs
    return Motion(W, w, dq, drift, mass.reshape(shape[1], shape[1]), displaced, headed(w, -displaced[5::6]))


def body_velocity(at: Motion, v_x: Any) -> Any:
    """Velocities in body axes, (N,), of a vehicle that runs at v_x: a pitched body moves along its z too."""
    result = at.local + 0.0
    result[2::6] += v_x * at.displaced[4::6]
    return result


def generalised(found: Any, at: Motion, p: Model) -> Any:
    """Generalised forces on w of wheels' forces along the rows of `Contact`, (6, w), turned by each body's heading."""
    rows = p.contact.rows
    return headed(rows.reshape(-1, rows.shape[2]).T @ found.ravel(), at.displaced[5::6])
