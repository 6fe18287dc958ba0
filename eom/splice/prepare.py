"""From a system of elements to the numbers that the nonlinear equations need."""

from typing import NamedTuple

import numpy as np

from eom.assembly.algebra import DENSE
from eom.assembly.matrices import Matrices, assemble_matrices
from eom.assembly.pivots import choose_coordinates
from eom.assembly.reduction import Pivots
from eom.assembly.rows import rows
from eom.assembly.vectors import Array
from eom.splice.checks import check_balance, check_free, check_motions, check_supports
from eom.splice.contact import Contact, contacts, spliced
from eom.splice.laws import LawGroup, forces
from eom.splice.multibody import Multibody, multibody, rounded
from eom.splice.state import Control, Model
from eom.splice.trim import STEP, Trim, solve_trim
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
    at_rest = assemble_matrices(rest, pivots)
    check_motions(rest, at_rest)
    check_supports(rest, pivots, at_rest)
    trim, laws, matrices = solve_trim(rest, pivots, speed, held=held)
    check_balance(rest, matrices)
    body = multibody(rest, pivots, matrices, speed, held=held)
    wheels = contacts(rest, pivots, trim.load, matrices.statics.reactions)
    inputs = control(rest, wheels)
    wheeled = len(inputs.demand) - body.B.shape[1]
    body = body._replace(
        B=np.hstack((np.zeros((len(body.M), wheeled)), body.B)),
        steering=np.concatenate((np.zeros(wheeled, dtype=np.intp), body.steering)),
    )
    model = Model(body, wheels, inputs, laws, load_gain(body, wheels), beyond_proportion(wheels, laws, trim))
    return Prepared(model, trim, rest, pivots, matrices)


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
    return rounded((body.react @ (moved - np.eye(len(moved))))[wheels.supports])


def beyond_proportion(wheels: Contact, laws: tuple[LawGroup, ...], trim: Trim) -> Array:
    """What the forces of the road at the trim follow the loads beyond proportion, (5, w)."""
    zero = np.zeros(len(trim.load))
    at = forces(laws, wheels.number, zero, trim.slip, trim.load + 1j * STEP, zero, zero + trim.speed)
    result: Array = at.imag / STEP - at.real / trim.load
    return result
