"""Steady turns of a model at the speed of its trim: every rate but the path's is zero, by Newton's method."""

import numpy as np

from eom.model.tyre import Run, TyreModel
from tests.splice.shared import STEP, Array, places


class Turns:
    """Turns of ever larger yaw rate; each starts from the one before."""

    def __init__(self, found: TyreModel) -> None:
        self.found, self.straight = found, found.trim()
        at, lead = places(found), found.numbers.body.lead
        n = [k for k in range(at["n"].start, at["n"].stop) if k - at["n"].start not in (lead[0], lead[2])]
        self.free = [*range(at["q"].start, at["q"].stop), *n, *range(at["spin"].start, at["spin"].stop)]
        self.turning = at["n"].start + int(lead[2])
        self.steer, self.drive = found.inputs.index("axle_1.steer"), found.inputs.index("drive_torque")
        self.last = np.concatenate((self.straight.x[self.free], [0.0, 0.0]))

    def run(self, z: Array, yaw_rate: float) -> Run:
        """State and inputs by what is unknown: displacements, velocities, spins, steer [10 mrad], torque [10 kN m]."""
        x, u = self.straight.x.astype(z.dtype), self.straight.u.astype(z.dtype)
        x[self.free], x[self.turning] = z[:-2], yaw_rate
        u[self.steer], u[self.drive] = 1e-2 * z[-2], 1e4 * z[-1]
        return Run(x, u)

    def at(self, yaw_rate: float) -> Run:
        """The steady turn at a yaw rate [rad/s].

        Spins of wheels in the air are whatever they were: the step is the shortest of those that solve.
        """
        z = self.last
        for _ in range(30):
            rate = self.found.rhs(0.0, *self.run(z, yaw_rate))[3:]
            if np.max(np.abs(rate)) < 1e-9:
                self.last = z
                return self.run(z, yaw_rate)
            steps = (self.run(z + 1j * STEP * each, yaw_rate) for each in np.eye(len(z)))
            slopes = np.array([self.found.rhs(0.0, *step)[3:].imag / STEP for step in steps]).T
            z = z - np.linalg.lstsq(slopes, rate, rcond=1e-11)[0]
        raise AssertionError(yaw_rate)
