"""From a system of elements to the numbers that the nonlinear equations need."""

from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import DENSE
from eom.assembly.matrices import Matrices
from eom.assembly.pivots import choose_coordinates
from eom.assembly.reduction import Pivots
from eom.assembly.rows import rows
from eom.assembly.vectors import Array
from eom.splice.contact import Contact, contacts, spliced
from eom.splice.multibody import LEAD, Multibody, multibody
from eom.splice.state import Control, Model
from eom.splice.trim import Trim, solve_trim
from eom.vehicle.elements import GROUND, Connection, System


class Prepared(NamedTuple):
    """A model with what it was made of.

    Attributes
    ----------
    model : Model
    trim : Trim
        The straight run at the speed of the file.
    system : System
        The elements without the wheels' linear forces.
    pivots : Pivots
    matrices : Matrices
        Of that system, under the trim's forces.
    """

    model: Model
    trim: Trim
    system: System
    pivots: Pivots
    matrices: Matrices


class SpliceError(ValueError):
    """A vehicle that has no such model; ``owner`` is the object to blame."""

    def __init__(self, owner: str, what: str) -> None:
        self.owner = owner
        super().__init__(what)


def prepare(system: System, speed: float) -> Prepared:
    """The model of a system at a trim speed [m/s].

    Raises `SpliceError` or `eom.splice.trim.TrimError` where there is none.
    """
    rest = spliced(system)
    check_free(rest, speed)
    return prepare_with(system, speed, choose_coordinates(rest, DENSE))


def prepare_with(system: System, speed: float, pivots: Pivots) -> Prepared:
    """The same in coordinates that were chosen before."""
    held = any(item.moving for item in system.constraints)
    rest = spliced(system)
    check_free(rest, speed)
    trim, laws, matrices = solve_trim(rest, pivots, speed, held=held)
    check_motions(rest, matrices)
    body = multibody(rest, pivots, matrices, held=held)
    wheels = contacts(rest, pivots, trim.load, matrices.statics.reactions)
    inputs = control(rest, wheels)
    others = np.zeros((len(body.M), len(inputs.demand) - body.B.shape[1]))
    body = body._replace(B=np.hstack((others, body.B)))
    model = Model(body, wheels, inputs, laws, load_gain(body, wheels))
    return Prepared(model, trim, rest, pivots, matrices)


def check_free(system: System, speed: float) -> None:
    """Raise `SpliceError` for what these equations do not know."""
    if not system.wheels:
        raise SpliceError("", "has no axles with tyres: its model is linear")
    if not speed > 0.0:
        raise SpliceError("trim", "needs a moving trim: tyres are spliced in at a forward speed")
    if system.rolling:
        raise SpliceError(system.rolling[0].name, "rolls without slip: axles with tyres cannot stand beside it")
    for body in system.bodies:
        if any(body.spin):
            raise SpliceError(body.name, "spins: give its axle 'spin_inertia' instead of a wheel as a body")
    for item in system.inputs:
        if any(item.rate_gain):
            raise SpliceError(item.name, "acts through its rate, which these equations do not take")


def check_motions(system: System, matrices: Matrices) -> None:
    """Raise `SpliceError` where the lead body cannot move freely on the plane, or a motion has no mass."""
    lead = system.bodies[0].name
    if not set(LEAD) <= set(matrices.reduction.independent.tolist()):
        raise SpliceError(lead, "is not free along x, along y and in yaw, as the lead body of a vehicle on a plane is")
    mass = matrices.reduction.W.T @ matrices.M @ matrices.reduction.W
    if not np.linalg.eigvalsh(mass)[0] > 1e-12 * np.max(np.diag(mass)):
        raise SpliceError(lead, "moves with a body without mass, which these equations do not take")


def control(system: System, wheels: Contact) -> Control:
    """What inputs do to the wheels; inputs are those of `input_names`."""
    names = [name for name, _ in input_names(system)]
    steer, brake = np.zeros((2, len(system.wheels), len(names)))
    demand = np.array([float(name == "drive_torque") for name in names])
    for k, wheel in enumerate(system.wheels):
        if wheel.steer:
            steer[k, names.index(wheel.steer)] = 1.0
        if wheel.brake_gain:
            brake[k, names.index(f"{wheel.name}.brake_pressure")] = wheel.brake_gain
    spinning = wheels.spinning
    inertia = np.array([system.wheels[k].spin_inertia for k in spinning])
    axles = [system.wheels[k].axle for k in spinning]
    spin = np.zeros((len(spinning), len(system.wheels)))
    for k, axle in enumerate(axles):
        together = [j for j in range(len(axles)) if j == k or (axle in system.drive.locked and axles[j] == axle)]
        spin[k, spinning[together]] = 1.0 / np.sum(inertia[together])
    drags = [
        rows(system.bodies, Connection(item.name, (item.body, GROUND), (item.place, item.place), 1, (1.0, 0.0, 0.0)))[0]
        for item in system.drags
    ]
    return Control(
        steer=steer,
        brake=brake,
        demand=demand,
        drive=np.array([wheel.drive_share for wheel in system.wheels]),
        drive_lag=system.drive.drive_lag,
        brake_lag=system.drive.brake_lag,
        spin=spin,
        drags=np.array(drags).reshape(len(drags), 6 * len(system.bodies)),
        drag_factor=np.array([item.factor for item in system.drags]),
    )


def input_names(system: System) -> list[tuple[str, str]]:
    """Names and units of the inputs: steer angles, drive torque, brake pressures, and those of the multibody part."""
    steers = dict.fromkeys(wheel.steer for wheel in system.wheels if wheel.steer)
    names = [(name, "rad") for name in steers]
    if any(wheel.drive_share for wheel in system.wheels):
        names.append(("drive_torque", "N*m"))
    names += [(f"{wheel.name}.brake_pressure", "Pa") for wheel in system.wheels if wheel.brake_gain]
    return names + [(item.name, item.unit) for item in system.inputs]


def load_gain(body: Multibody, wheels: Contact) -> Array:
    """Loads of the supports by generalised forces on w about the trim, accelerations included, (s, N)."""
    mass = body.W.T @ body.M @ body.W
    free = slice(1, None) if body.held else slice(None)
    W = body.W[:, free]
    moved = body.M @ W @ np.linalg.solve(mass[free, free], W.T)
    return (body.react @ (moved - np.eye(len(moved))))[wheels.supports]
