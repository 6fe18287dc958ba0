"""Where wheels meet the road and what they know of it, in arrays for the nonlinear equations."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.matrices import Matrices
from eom.assembly.reduction import Pivots
from eom.assembly.rows import rows
from eom.assembly.vectors import Array
from eom.splice.multibody import row_of
from eom.vehicle.elements import GROUND, Connection, Elastic, System, Wheel

FORWARD, LATERAL, ROLL, PITCH, YAW, VERTICAL = range(6)
"""What a wheel's rows are for; each measures a velocity and, transposed, distributes the force conjugate to it."""


class Contact(NamedTuple):
    """All wheels of a vehicle; w of them, s supports, N = 6 bodies.

    Attributes
    ----------
    rows : Array
        Velocities by w, shape (6, w, N): forward at the hub (on the ground for a wheel whose spin is no state), to the
        left on the ground, roll, pitch and yaw rates, upward.
    lean : Array
        Camber angles by displacements p, (w, N).
    number, radius : Array
        Wheels that it stands for, rolling radius [m] (1 where none is given).
    lever, heave : Array
        Moment about x [m] and force upward of a load beyond what the multibody part carries: place to the left of
        the support, and 1 for wheels on springs of their own; zero for others.
    nominal, base : Array
        Loads at the trim, and the part of them that comes from no support [N], (w,).
    carried : Array
        Loads of the supports at the trim [N], (s,).
    share : Array
        Loads by the supports' reactions, (w, s); a wheel has one support at most.
    most, alone : Array
        Share of its support's load that it carries when its partner lifts off, (w, s); infinite without one, (w,).
    support : NDArray
        Number of each wheel's support, -1 without one, (w,).
    sprung, damped : Array
        Loads by p, of rolling tyres and of springs of their own, and by dp/dt, (w, N).
    spinning : NDArray
        Numbers of the wheels whose spin is a state.
    passing : NDArray
        Numbers of the wheels whose spin is none, and which have a radius.
    relaxing : NDArray
        Numbers of the wheels whose side force lags, by ``relaxation`` [m].
    supports : NDArray
        Rows of the supports among the independent constraint rows.
    """

    rows: Array
    lean: Array
    number: Array
    radius: Array
    lever: Array
    heave: Array
    nominal: Array
    base: Array
    carried: Array
    share: Array
    most: Array
    alone: Array
    support: NDArray[np.intp]
    sprung: Array
    damped: Array
    spinning: NDArray[np.intp]
    passing: NDArray[np.intp]
    relaxing: NDArray[np.intp]
    relaxation: Array
    supports: NDArray[np.intp]


def spliced(system: System) -> System:
    """The system without what its wheels put in its place: slip of tyres, and drag."""
    names = {wheel.axle for wheel in system.wheels} | {drag.name for drag in system.drags}
    return system._replace(
        constraints=tuple(item for item in system.constraints if not item.moving),
        slip=tuple(item for item in system.slip if item.connection.name not in names),
        loads=tuple(item for item in system.loads if item.name not in {drag.name for drag in system.drags}),
        inputs=tuple(item for item in system.inputs if item.name.rsplit(".", maxsplit=1)[0] not in names),
    )


def contacts(system: System, pivots: Pivots, loads: Array, reactions: Array) -> Contact:
    """The wheels of a system from which their linear forces have been taken out, with their loads at the trim [N].

    *reactions* are those of all constraint rows at the trim.
    """
    wheels = system.wheels
    names = list(dict.fromkeys(wheel.support for wheel in wheels if wheel.support))
    share = np.zeros((len(wheels), len(names)))
    most = np.zeros_like(share)
    for k, wheel in enumerate(wheels):
        if wheel.support:
            share[k, names.index(wheel.support)] = wheel.share
            partners = [other.share for other in wheels if other.axle == wheel.axle]
            most[k, names.index(wheel.support)] = sum(partners)
    places = {item.connection.name: item.connection.places[0] for item in system.constraints}
    springs = {item.connection.name: item for item in system.elastic}
    roll = wheel_rows(system, ROLL)
    spring_rows = np.zeros((2, *roll.shape))
    for k, wheel in enumerate(wheels):
        if wheel.support:
            spring_rows[0, k] = wheel.roll_rate * roll[k]
        elif on_spring(wheel):
            spring_rows[:, k] = spring_forces(system, springs[wheel.spring])
    supports = np.array([row_of(system, pivots, name) for name in names], dtype=np.intp)
    carried = reactions[np.array(pivots.rows, dtype=np.intp)[supports]]
    laws = [system.tyres[wheel.tyre] for wheel in wheels]
    return Contact(
        rows=np.array([wheel_rows(system, kind) for kind in range(6)]),
        lean=roll,
        number=np.array([wheel.number for wheel in wheels]),
        radius=np.array([wheel.radius or 1.0 for wheel in wheels]),
        lever=np.array([wheel.place[1] - places[wheel.support][1] if wheel.support else 0.0 for wheel in wheels]),
        heave=np.array([float(on_spring(wheel)) for wheel in wheels]),
        nominal=loads,
        base=loads - share @ carried,
        carried=carried,
        share=share,
        most=most,
        alone=np.where(np.any(share, axis=1), 0.0, np.inf),
        support=np.array([names.index(wheel.support) if wheel.support else -1 for wheel in wheels], dtype=np.intp),
        sprung=spring_rows[0],
        damped=spring_rows[1],
        spinning=np.flatnonzero([wheel.spin_inertia > 0.0 for wheel in wheels]),
        passing=np.flatnonzero([wheel.spin_inertia == 0.0 and wheel.radius > 0.0 for wheel in wheels]),
        relaxing=np.flatnonzero([law.relaxation > 0.0 for law in laws]),
        relaxation=np.array([law.relaxation for law in laws if law.relaxation > 0.0]),
        supports=supports,
    )


def wheel_rows(system: System, kind: int) -> Array:
    """One row per wheel over all coordinates, (w, N), see `Contact`."""
    result = np.zeros((len(system.wheels), 6 * len(system.bodies)))
    for k, wheel in enumerate(system.wheels):
        result[k] = rows(system.bodies, wheel_connection(wheel, kind))[0]
    return result


def wheel_connection(wheel: Wheel, kind: int) -> Connection:
    """The one direction along or about which a wheel's force of a kind acts on its body."""
    place, pair = wheel.place, (wheel.body, GROUND)
    if kind == FORWARD and wheel.spin_inertia > 0.0:
        place = (place[0], place[1], place[2] + wheel.radius)
    axis = {FORWARD: (1.0, 0.0, 0.0), LATERAL: (0.0, 1.0, 0.0), VERTICAL: (0.0, 0.0, 1.0)}.get(kind)
    if axis is not None:
        return Connection(wheel.name, pair, (place, place), forces=1, force_axis=axis)
    about = {ROLL: (1.0, 0.0, 0.0), PITCH: (0.0, 1.0, 0.0), YAW: (0.0, 0.0, 1.0)}[kind]
    return Connection(wheel.name, pair, (place, place), moments=1, moment_axis=about)


def spring_forces(system: System, item: Elastic) -> tuple[Array, Array]:
    """Load on the wheel by displacements and by their rates, of a vertical spring and damper under a body."""
    row = rows(system.bodies, item.connection)[0]
    return -item.stiffness[0] * row, -item.damping[0] * row


def on_spring(wheel: Wheel) -> bool:
    """Whether a vertical spring carries a wheel alone."""
    return bool(wheel.spring and not (wheel.support or wheel.roll_rate))


def spring_loads(system: System, matrices: Matrices) -> Array:
    """What springs put on the wheels at the trim [N]: their own ones, and rolling tyres under a moment."""
    names = [item.connection.name for item in system.elastic]
    tensions = dict(zip(names, elastic_tensions(system, matrices), strict=True))
    stiffness = {name: item.stiffness[1] for name, item in zip(names, system.elastic, strict=True)}
    result = np.zeros(len(system.wheels))
    for k, wheel in enumerate(system.wheels):
        if on_spring(wheel):
            result[k] = tensions[wheel.spring]
        elif wheel.support and wheel.roll_rate:
            # the angle of roll that the moment stands for
            result[k] = -wheel.roll_rate * tensions[wheel.spring] / stiffness[wheel.spring]
    return result


def elastic_tensions(system: System, matrices: Matrices) -> list[float]:
    """First tension of every spring and flexible point."""
    result, row = [], 0
    for item in system.elastic:
        result.append(float(matrices.statics.tensions[row]))
        row += (1 if item.connection.line else item.connection.forces) + item.connection.moments
    return result
