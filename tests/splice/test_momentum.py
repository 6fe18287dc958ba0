"""Momentum of a whole vehicle: it changes by the forces of road, weight and air alone, gyroscopic terms included.

Power does not see what acts across a velocity; this does. The undisplaced car is looked at, at any velocities of its
body and of its wheel carriers, so that every place is that of the drawing.
"""

import numpy as np
import pytest

from tests.splice.powers import point_velocities
from tests.splice.shared import model, places
from tests.splice.test_power import random_state


@pytest.mark.parametrize("seed", range(4))
def test_a_car_changes_its_momentum_by_external_forces(seed: int) -> None:
    """Forces and moments about the body's centre, in the axes of its heading. Rounding of 1e5 N m; seen are 1e-11."""
    found = model("car")
    x, u = random_state(found, seed)
    x[places(found)["q"]] = 0.0
    now, system = found.evaluated(x, u), found.prepared.system
    at, balance = now.motion, now.balance
    arms = np.array([body.centre for body in system.bodies]) - np.array(system.bodies[0].centre)
    w, dw = at.w.reshape(-1, 6), balance.dw.reshape(-1, 6)
    frame = np.array([0.0, 0.0, w[0, 5]])
    force, moment = np.zeros((2, 3))
    for body, arm, velocity, rate in zip(system.bodies, arms, w, dw, strict=True):
        inertia = np.array(body.inertia)
        gained = body.mass * (rate[:3] + np.cross(frame, velocity[:3]))
        # body axes lie along the heading's, and turn with the body
        turned = inertia @ rate[3:] + np.cross(velocity[3:], inertia @ velocity[3:])
        weight = body.mass * np.array(system.gravity)
        force += gained - weight
        moment += turned + np.cross(arm, gained - weight)
    for k, wheel in enumerate(system.wheels):
        place = np.subtract(wheel.place, system.bodies[0].centre)
        hub = np.add(place, (0.0, 0.0, wheel.radius))
        cos, sin = now.rolling.cos[k], now.rolling.sin[k]
        Fx, Fy, Mx, _, Mz = balance.forces[:, k]
        along = np.array([cos * Fx - sin * Fy, 0.0, 0.0])
        across = np.array([0.0, sin * Fx + cos * Fy, balance.load[k]])
        force -= along + across
        # the wheel turns in its carrier: its hub is pushed, and the torque on it is taken from the carrier
        moment -= np.cross(hub, along) + np.cross(place, across)
        moment -= np.array([cos * Mx, sin * Mx - balance.torque[k], Mz])
    for drag in system.drags:
        place = np.subtract(drag.place, system.bodies[0].centre)
        v = point_velocities(at, [drag.body], place)[0, 0]
        push = np.array([-drag.factor * v * abs(v), 0.0, 0.0])
        force -= push
        moment -= np.cross(place, push)
    np.testing.assert_allclose(force, 0.0, atol=1e-8)
    np.testing.assert_allclose(moment, 0.0, atol=1e-8)
