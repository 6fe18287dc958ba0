"""State, motion and forces of the nonlinear equations: what they are made of, by name."""

from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.splice.contact import Contact
from eom.splice.laws import LawGroup
from eom.splice.multibody import Multibody


class Control(NamedTuple):
    """What inputs do to wheels, and how late; u inputs, w wheels.

    Attributes
    ----------
    steer, brake : Array
        Steer angle and brake torque of each wheel by the inputs, (w, u).
    demand, drive : Array
        Drive torque by the inputs, (u,), and each wheel's share of it, (w,).
    drive_lag, brake_lag : float
        Time constants [s], zero for none.
    spin : Array
        Rates of the spins that are states by torques on the wheels, (spins, w) [1/(kg m^2)].
    drags : Array
        Rows of velocity along each drag's place, (drags, N), and their ``drag_factor`` [N s^2/m^2].
    """

    steer: Array
    brake: Array
    demand: Array
    drive: Array
    drive_lag: float
    brake_lag: float
    spin: Array
    drags: Array
    drag_factor: Array


class Model(NamedTuple):
    """Everything that the equations need, in numbers.

    ``load_gain`` is of supports' loads by forces on w, (s, N). ``bend`` is what the road's forces at the trim follow
    the loads beyond proportion, (5, w).
    """

    body: Multibody
    contact: Contact
    control: Control
    laws: tuple[LawGroup, ...]
    load_gain: Array
    bend: Array


class State(NamedTuple):
    """Parts of the state.

    Place of the frame (x, y, yaw), displacements, velocities, spins, and what lags: slip angles, drive torque, brake
    torques.
    """

    frame: Any
    q: Any
    n: Any
    spin: Any
    side: Any
    drive: Any
    brake: Any


class Motion(NamedTuple):
    """Velocities at a state: W(q), w = W n, dq/dt, the part of dw/dt that does not follow from dn/dt, the mass on n.

    ``displaced`` are the displacements of all bodies, ``local`` the velocities w with translations along each body's
    own heading.
    """

    W: Any
    w: Any
    dq: Any
    drift: Any
    mass: Any
    displaced: Any
    local: Any


class Rolling(NamedTuple):
    """Slips of the wheels and what else their tyres need; arrays over the wheels.

    ``side`` is the slip angle by kinematics, ``alpha`` the one that acts; ``cos`` and ``sin`` are of the steer angle.
    """

    forward: Any
    side: Any
    alpha: Any
    kappa: Any
    camber: Any
    cos: Any
    sin: Any
    omega: Any


class Balance(NamedTuple):
    """Accelerations and forces.

    dn/dt, dw/dt, reactions of the independent constraint rows, forces of the wheels on their bodies (6, w) and in wheel
    axes (5, w), loads, torques of drive and brakes on the wheels, loads of the supports for which the tyres were
    evaluated.
    """

    dn: Any
    dw: Any
    reactions: Any
    body_forces: Any
    forces: Any
    load: Any
    torque: Any
    assumed: Any


class Evaluation(NamedTuple):
    """All that a state and inputs mean."""

    state: State
    motion: Motion
    rolling: Rolling
    balance: Balance


def sizes(p: Model) -> tuple[int, ...]:
    """Lengths of the parts of the state."""
    wheels = len(p.contact.number)
    return (
        3,
        p.body.T.shape[1],
        p.body.W.shape[1],
        len(p.contact.spinning),
        len(p.contact.relaxing),
        int(p.control.drive_lag > 0.0),
        wheels if p.control.brake_lag > 0.0 else 0,
    )


def split_state(x: Any, p: Model) -> State:
    """The parts of a state."""
    a, b, c, d, e, f, g = np.cumsum(np.array(sizes(p)))
    return State(x[:a], x[a:b], x[b:c], x[c:d], x[d:e], x[e:f], x[f:g])
