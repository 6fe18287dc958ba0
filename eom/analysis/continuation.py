"""Following a mechanism from one set of driven values to another in bounded steps."""

from typing import NamedTuple

import numpy as np

from eom.analysis.closed import CLOSED, Mechanism
from eom.analysis.closure import Posture
from eom.assembly.diagnosis import groups_of, near_null
from eom.assembly.vectors import Array

# largest turn of a body in one step [rad], and displacement in lengths of the mechanism
BOUND = 0.2
# what the correction may be of the step, else the step may have led to another branch
CORRECTION = 0.3
# part of a step below which the path counts as ended
SMALLEST = 1e-7
# smallest singular value of unit rows, of the largest: below it the end is where rows become dependent
SINGULAR = 1e-2


class Reached(NamedTuple):
    """Where a path has led: the posture, its driven values and residual [m], and what locks it if it has ended."""

    posture: Posture
    values: Array
    residual: float
    end: str | None = None


def distance(mechanism: Mechanism, start: Posture, end: Posture) -> float:
    """Largest displacement in lengths, or turn [rad], of a body between two postures."""
    offsets = np.linalg.norm(end.offsets - start.offsets, axis=1) / mechanism.length
    # chords of half angles, of the nearer of the two quaternions of a rotation
    turns = 2.0 * np.minimum(
        np.linalg.norm(end.turns - start.turns, axis=1), np.linalg.norm(end.turns + start.turns, axis=1)
    )
    return float(np.max(np.concatenate([offsets, turns]), initial=0.0))


def advance(mechanism: Mechanism, start: Reached, target: Array) -> Reached:
    """Follow the straight line of driven values to *target*; ends early where the loops lock."""
    change = target - start.values
    posture, residual, done, step = start.posture, start.residual, 0.0, 1.0
    while done < 1.0:
        values = start.values + done * change
        motion, factors = mechanism.velocity(posture, values, change)
        speed = distance(mechanism, posture, posture.moved(1e-3 * motion)) / 1e-3
        step = min(step, 1.0 - done, BOUND / speed if speed else 1.0)
        while True:
            if step < SMALLEST:
                return Reached(posture, values, residual, what_locks(mechanism, posture, values, motion))
            ahead = 1.0 if done + step >= 1.0 - SMALLEST else done + step
            predicted = posture.moved((ahead - done) * motion)
            closed, worst = mechanism.close(predicted, start.values + ahead * change, factors.rank)
            near = distance(mechanism, predicted, closed) <= CORRECTION * speed * step + CLOSED
            if worst < CLOSED * mechanism.length and near:
                break
            step *= 0.5
        posture, residual, done, step = closed, worst, ahead, 2.0 * step
    return Reached(posture, target, residual)


def drives_locked(mechanism: Mechanism) -> str:
    """The phrase that names what locks a driven actuator at the drawing; empty if all of them can move."""
    rest = np.zeros(len(mechanism.driven))
    _, derivative = mechanism.rows(Posture.drawn(len(mechanism.bodies)), rest)
    joints = derivative[: len(derivative) - len(rest)]
    if mechanism.factors(derivative).rank == mechanism.factors(joints).rank + len(rest):
        return ""
    return show(groups(mechanism, derivative, 1e-9)) or "the held bodies"


def what_locks(mechanism: Mechanism, posture: Posture, values: Array, motion: Array) -> str:
    """The phrase that names the joints which lock together where a path that wants to go on by *motion* ends."""
    _, derivative = mechanism.rows(posture, values)
    free = derivative[:, mechanism.free]
    sigma = np.linalg.svd(free / np.maximum(np.linalg.norm(free, axis=1), 1e-300)[:, np.newaxis], compute_uv=False)
    rank = mechanism.factors(derivative).rank
    least = float(sigma[rank - 1] / sigma[0])
    if least < SINGULAR:
        return show(groups(mechanism, derivative, 1.01 * least))
    # rows that repeated others here do so no longer
    residual, _ = mechanism.rows(posture.moved(1e-3 * motion / float(np.max(np.abs(motion)))), values)
    count = len(residual) - len(values)
    worst = np.argsort(-np.abs(residual[:count]))[:4]
    return show([tuple(dict.fromkeys(mechanism.owners[int(k)] for k in worst))])


def groups(mechanism: Mechanism, derivative: Array, tolerance: float) -> list[tuple[str, ...]]:
    """Groups of connections that lock the same motion and have a driven one among them."""
    found = groups_of(near_null(derivative[:, mechanism.free], tolerance), mechanism.owners)
    drives = {item.name for item in mechanism.driven}
    return [group for group in found if drives & set(group)] or found


def show(found: list[tuple[str, ...]]) -> str:
    """Groups of names as a phrase."""
    return "; ".join(dict.fromkeys(" with ".join(group) for group in found))
