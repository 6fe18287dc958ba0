"""Where a wheel stands and how its contact point moves; roll centres in the front view.

The spin axis is y at the drawing, the contact point is the lowest point of the wheel's disc. Signs: docs/kinematics.md.
"""

from typing import NamedTuple

import numpy as np

from eom.analysis.closure import Posture
from eom.analysis.drives import Wheel
from eom.analysis.rotation import matrix
from eom.assembly.vectors import Array, unit
from eom.vehicle.elements import Body

Y, Z = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
# of contact velocities' slopes: what rounding makes of parallel lines, and what is steering rather than travel
PARALLEL = 1e-9
STEEPEST = 1.0
# rise of a contact point over the whole sweep, below which it does not travel [m]
STILL = 1e-9


class WheelState(NamedTuple):
    """A wheel at one point of a sweep.

    Attributes
    ----------
    travel : float
        Rise of its centre from the drawing [m].
    camber, toe, steer : float
        Angles [rad].
    contact : Array
        Contact point [m].
    velocity : Array
        Velocity of the contact point per unit of the sweep [m].
    """

    travel: float
    camber: float
    toe: float
    steer: float
    contact: Array
    velocity: Array


def wheel_state(bodies: tuple[Body, ...], wheel: Wheel, posture: Posture, motion: Array) -> WheelState:
    """The state of a wheel; *motion* (6 bodies,) holds velocities and angular velocities per unit of the sweep."""
    R = matrix(posture.turns[wheel.body])
    body_centre = np.asarray(bodies[wheel.body].centre)
    drawn = wheel.contact + wheel.radius * Z
    arm = R @ (drawn - body_centre)
    centre = body_centre + posture.offsets[wheel.body] + arm
    own = motion[6 * wheel.body : 6 * wheel.body + 6]
    n = R @ Y
    up_raw = Z - n[2] * n
    up, n_rate = unit(up_raw), np.cross(own[3:], n)
    raw_rate = -(n_rate[2] * n + n[2] * n_rate)
    up_rate = (raw_rate - up * (up @ raw_rate)) / float(np.linalg.norm(up_raw))
    steer = float(np.arctan2(-n[0], n[1]))
    return WheelState(
        travel=float(centre[2] - drawn[2]),
        camber=-wheel.side * float(np.arctan2(n[2], n[1])),
        toe=-wheel.side * steer,
        steer=steer,
        contact=centre - wheel.radius * up,
        velocity=own[:3] + np.cross(own[3:], arm) - wheel.radius * up_rate,
    )


def roll_centre(left: WheelState, right: WheelState) -> tuple[float, float]:
    """Lateral place, and height above the line through both contact points [m]; NaN where there is none.

    In the front view each wheel turns about a point on the line through its contact point normal to that point's
    velocity; the roll centre is where the two lines meet. Where both lie on the ground, its height is zero and its
    lateral place is open.
    """
    slopes = []
    for wheel in (left, right):
        _, y, z = wheel.velocity
        if abs(z) < STILL or abs(y) > STEEPEST * abs(z):
            return np.nan, np.nan
        slopes.append(float(y / z))
    (_, y_1, z_1), (_, y_2, z_2) = left.contact, right.contact
    k_1, k_2 = slopes
    ground = (z_1 - z_2) / (y_1 - y_2)
    if abs(k_1 - k_2) < PARALLEL:
        return np.nan, 0.0 if abs(k_1 + ground) < PARALLEL else np.nan
    y = (z_1 - z_2 + k_1 * y_1 - k_2 * y_2) / (k_1 - k_2)
    z = z_1 - k_1 * (y - y_1)
    return float(y), float(z - z_1 - ground * (y - y_1))
