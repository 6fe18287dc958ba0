"""A mechanism's loops as one system of equations, and its solution by Newton's method."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from eom.analysis.closure import Posture, equations, scaled
from eom.assembly.rows import arm
from eom.assembly.vectors import Array
from eom.vehicle.elements import GROUND, Body, Connection

# of the largest singular value: below it a row repeats others
RANK = 1e-9
CLOSED = 1e-11
ITERATIONS = 12


class Factors(NamedTuple):
    """Singular value decomposition of the scaled derivatives of all rows on the free motions."""

    U: Array
    sigma: Array
    Vt: Array
    rank: int


@dataclass(frozen=True)
class Mechanism:
    """Bodies with everything that closes their loops.

    Attributes
    ----------
    bodies : sequence of Body
    closed : sequence of Connection
        Joints and locked actuators, which keep the values of the drawing.
    driven : sequence of Connection
        One-directional connections with prescribed values [m or rad].
    held : frozenset of int
        Bodies that stay where they are drawn.
    """

    bodies: Sequence[Body]
    closed: Sequence[Connection]
    driven: Sequence[Connection]
    held: frozenset[int]

    @property
    def length(self) -> float:
        """Size that makes rotations comparable with displacements [m]: the longest arm of a body."""
        arms = [
            float(np.linalg.norm(arm(self.bodies, item, k)))
            for item in (*self.closed, *self.driven)
            for k, body in enumerate(item.bodies)
            if body not in (GROUND, *self.held)
        ]
        return max(arms, default=0.0) or 1.0

    @property
    def free(self) -> Array:
        """Numbers of the coordinates that may move."""
        return np.array([6 * k + j for k in range(len(self.bodies)) if k not in self.held for j in range(6)], dtype=int)

    @property
    def owners(self) -> list[str]:
        """Name of the connection of each row."""
        return [item.name for item in (*self.closed, *self.driven) for _ in range(item.forces + item.moments)]

    def rows(self, posture: Posture, values: Array) -> tuple[Array, Array]:
        """Residuals and scaled derivatives of all rows on all bodies, the driven ones last."""
        length = self.length
        residuals, derivatives = [np.zeros(0)], [np.zeros((0, 6 * len(self.bodies)))]
        targets = (*np.zeros(len(self.closed)), *values)
        for item, value in zip((*self.closed, *self.driven), targets, strict=True):
            residual, derivative = equations(self.bodies, item, posture, float(value))
            residual[item.forces :] *= length
            residuals.append(residual)
            derivatives.append(scaled(derivative, item, length))
        return np.concatenate(residuals), np.vstack(derivatives)

    def factors(self, derivative: Array, rank: int | None = None) -> Factors:
        """The decomposition; its rank by tolerance unless it is known."""
        U, sigma, Vt = np.linalg.svd(derivative[:, self.free])
        counted = int(np.sum(sigma > RANK * sigma[0])) if sigma.size else 0
        return Factors(U, sigma, Vt, counted if rank is None else rank)

    def smallest(self, factors: Factors, wanted: Array) -> Array:
        """The smallest motion (6 bodies,) that changes the rows as wanted, as far as their rank allows."""
        r = factors.rank
        motion = np.zeros(6 * len(self.bodies))
        motion[self.free] = factors.Vt[:r].T @ ((factors.U[:, :r].T @ wanted) / factors.sigma[:r])
        motion.reshape(-1, 2, 3)[:, 1] /= self.length
        return motion

    def velocity(self, posture: Posture, values: Array, rates: Array) -> tuple[Array, Factors]:
        """The smallest motion (6 bodies,) per unit of *rates*, the rates of the driven values."""
        _, derivative = self.rows(posture, values)
        factors = self.factors(derivative)
        # a turn counts as a length in its row
        lengths = np.array([1.0 if item.forces else self.length for item in self.driven])
        wanted = np.zeros(len(derivative))
        wanted[len(wanted) - len(rates) :] = rates * lengths
        return self.smallest(factors, wanted), factors

    def close(self, posture: Posture, values: Array, rank: int) -> tuple[Posture, float]:
        """The nearest posture that satisfies all rows, and its largest residual [m]; infinite if there is none.

        Only as many independent rows as the last closed posture had lead the way; all of them must be satisfied.
        """
        size = self.length
        best = posture, np.inf
        for _ in range(ITERATIONS):
            residual, derivative = self.rows(posture, values)
            worst = float(np.max(np.abs(residual), initial=0.0))
            if worst < best[1]:
                best = posture, worst
            elif best[1] < CLOSED * size:
                break
            if not worst < size:
                break
            posture = posture.moved(self.smallest(self.factors(derivative, rank), -residual))
        return best
