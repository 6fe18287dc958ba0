"""States and outputs of a vehicle with wheels: their names and units, and what outputs are made of."""

import numpy as np

from eom.assembly.matrices import DISPLACEMENTS, VELOCITIES
from eom.assembly.reduction import Pivots
from eom.assembly.rows import force_directions, row_count, rows
from eom.assembly.state_space import output_row
from eom.assembly.vectors import Array, array
from eom.splice.multibody import LEAD, frame_motion
from eom.splice.outputs import ACCELERATION, POSITION, VELOCITY, Signals
from eom.splice.prepare import Prepared
from eom.splice.state import Model, sizes
from eom.vehicle.elements import GROUND, System, Unit

SIDES = {"left": 1.0, "right": -1.0}
QUANTITIES = {"position": POSITION, "velocity": VELOCITY, "acceleration": ACCELERATION}
OF_UNITS = (("ax", "m/s^2"), ("speed", "m/s"), ("x", "m"), ("y", "m"), ("yaw", "rad"))
OF_WHEELS = (("alpha", "rad"), ("kappa", ""), ("Fx", "N"), ("Fy", "N"), ("Fz", "N"), ("Mz", "N*m"))
OF_COUPLINGS = (("Fx", "N"), ("Fy", "N"), ("Fz", "N"))


def units_of(system: System) -> tuple[Unit, ...]:
    """The vehicle's units; bodies without units are one."""
    return system.units or (Unit("vehicle", tuple(range(len(system.bodies))), ""),)


def output_names(system: System) -> list[tuple[str, str]]:
    """Names and units of all outputs, in the order of `eom.splice.outputs.all_outputs`."""
    units = units_of(system)
    names = [(item.name, item.unit) for item in system.outputs]
    names += [(f"{unit.name}.{name}", of) for unit in units for name, of in OF_UNITS]
    names += [(f"{wheel.name}.{name}", of) for wheel in system.wheels for name, of in OF_WHEELS]
    names += [(f"{axle}.ltr", "") for axle in dict.fromkeys(wheel.axle for wheel in system.wheels)]
    names += [(f"{unit.name}.ltr", "") for unit in units]
    return names + [(f"{unit.coupling}.{name}", of) for unit in units if unit.coupling for name, of in OF_COUPLINGS]


def signals(system: System, pivots: Pivots, inputs: list[str], speed: float) -> Signals:
    """What the outputs are made of, at a trim speed [m/s] and with the names of the inputs."""
    units = units_of(system)
    centres = np.array([body.centre for body in system.bodies], dtype=float)
    masses = np.array([body.mass for body in system.bodies], dtype=float)
    weights = np.zeros((len(units), len(masses)))
    for k, unit in enumerate(units):
        own = list(unit.bodies)
        weights[k, own] = masses[own] / np.sum(masses[own])
    leads = np.array([unit.bodies[0] for unit in units], dtype=np.intp)
    ahead, own_offset = coupling_offsets(system, units, centres)
    feedthrough = np.zeros((len(system.outputs), len(inputs)))
    for k, item in enumerate(system.outputs):
        for name, gain in item.feedthrough:
            feedthrough[k, inputs.index(name)] = gain
    points, point_at, axis, whole = measured_points(system)
    slips = {f"{unit.name}.sideslip": k for k, unit in enumerate(units)}
    names = list(dict.fromkeys(wheel.axle for wheel in system.wheels))
    return Signals(
        rows=np.array([output_row(system, item) for item in system.outputs]).reshape(-1, 6 * len(masses)),
        quantity=np.array([QUANTITIES[item.quantity] for item in system.outputs], dtype=np.intp),
        inertial=np.array([item.frame == "inertial" for item in system.outputs], dtype=bool),
        feedthrough=feedthrough,
        points=points,
        point_at=point_at,
        axis=axis,
        whole=whole,
        trim_speed=speed,
        slipping=np.array([slips.get(item.name, -1) for item in system.outputs], dtype=np.intp),
        centres=centres[:, :2] - centres[0, :2],
        weights=weights,
        leads=leads,
        ahead=ahead,
        own=own_offset,
        centre=(weights @ centres - centres[leads])[:, :2],
        axles=np.array([[float(wheel.axle == name) for wheel in system.wheels] for name in names]),
        units=np.array([[float(wheel.body in unit.bodies) for wheel in system.wheels] for unit in units]),
        side=np.array([SIDES.get(wheel.name.rsplit(".", maxsplit=1)[-1], 0.0) for wheel in system.wheels]),
        carried=coupling_forces(system, pivots, units),
    )


def measured_points(system: System) -> tuple[Array, Array, Array, Array]:
    """Points whose translation against the ground is measured along one direction; see `Signals`."""
    count, N = len(system.outputs), 6 * len(system.bodies)
    points, at, axis, whole = np.zeros((3, count, N)), np.zeros((count, 2)), np.zeros((count, 3)), np.zeros(count)
    for k, item in enumerate(system.outputs):
        first = item.terms[0][1]
        if first.forces != 1 or any(term.bodies[1] != GROUND for _, term in item.terms):
            continue
        axis[k] = force_directions(first)[0]
        for weight, term in item.terms:
            points[:, k] += weight * rows(system.bodies, term._replace(forces=3))
            at[k] += weight * np.subtract(term.places[0], system.bodies[0].centre)[:2]
            whole[k] += weight
    return points, at, axis, whole


def coupling_offsets(system: System, units: tuple[Unit, ...], centres: Array) -> tuple[Array, Array]:
    """Planar ways from the lead body ahead to the coupling and from there to the own lead body, (units, 2) each."""
    places = {item.connection.name: array(item.connection.places[0]) for item in system.constraints}
    ahead, own = np.zeros((2, len(units), 2))
    # the frame is that of the first body, which may belong to no unit
    ahead[0] = (centres[units[0].bodies[0]] - centres[0])[:2]
    for k, unit in enumerate(units):
        if k:
            place = places[unit.coupling]
            ahead[k] = (place - centres[units[k - 1].bodies[0]])[:2]
            own[k] = (centres[unit.bodies[0]] - place)[:2]
    return ahead, own


def coupling_forces(system: System, pivots: Pivots, units: tuple[Unit, ...]) -> Array:
    """Force on the towed unit of each coupling by the reactions of the independent rows, (3 couplings, rows)."""
    names = [unit.coupling for unit in units if unit.coupling]
    result = np.zeros((3 * len(names), len(pivots.rows)))
    row = 0
    for item in system.constraints:
        connection = item.connection
        for k, direction in enumerate(force_directions(connection)):
            if connection.name in names and row + k in pivots.rows:
                at = 3 * names.index(connection.name)
                result[at : at + 3, pivots.rows.index(row + k)] = direction
        row += row_count(connection)
    return result


def spliced_states(prepared: Prepared) -> list[tuple[str, str]]:
    """Names and units of the states."""
    system, independent = prepared.system, prepared.matrices.reduction.independent
    bodies = [body.name for body in system.bodies]
    own = [int(k) for k in independent if k not in LEAD]
    moved = np.any(frame_motion(system) != 0.0, axis=1)
    names = [(f"{bodies[0]}.{name}", unit) for name, unit in (("x", "m"), ("y", "m"), ("yaw", "rad"))]
    for k in own:
        counted = f"_from_{bodies[0]}" if moved[k] else ""
        names.append((f"{bodies[k // 6]}.{DISPLACEMENTS[k % 6]}{counted}", "m" if k % 6 < 3 else "rad"))
    names += [(f"{bodies[k // 6]}.{VELOCITIES[k % 6]}", "m/s" if k % 6 < 3 else "rad/s") for k in map(int, independent)]
    return names + other_states(system, prepared.model)


def other_states(system: System, p: Model) -> list[tuple[str, str]]:
    """Names and units of spins and of what lags."""
    *_, drive, brake = sizes(p)
    names = [(f"{system.wheels[k].name}.spin", "rad/s") for k in p.contact.spinning]
    names += [(f"{system.wheels[k].name}.slip_angle", "rad") for k in p.contact.relaxing]
    names += [("drive_torque", "N*m")] * drive
    return names + [(f"{wheel.name}.brake_torque", "N*m") for wheel in system.wheels[:brake]]
