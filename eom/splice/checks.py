"""What the nonlinear equations ask of a vehicle; what they do not know is refused by name."""

from collections.abc import Iterator

import numpy as np

from eom.assembly.elastic import elastic_items
from eom.assembly.matrices import Matrices
from eom.assembly.reduction import Pivots
from eom.assembly.rows import row_count
from eom.assembly.statics import unbalanced
from eom.splice.multibody import LEAD, frame_motion
from eom.vehicle.elements import System


class SpliceError(ValueError):
    """A vehicle that has no such model; ``findings`` are pairs of an object to blame and what is wrong with it."""

    def __init__(self, *findings: tuple[str, str]) -> None:
        self.findings = findings
        super().__init__("; ".join(f"{owner}: {what}" if owner else what for owner, what in findings))


def check_free(system: System, speed: float) -> None:
    """Raise `SpliceError` for what these equations do not know."""
    findings = tuple(unknown(system, speed))
    if findings:
        raise SpliceError(*findings)


def unknown(system: System, speed: float) -> Iterator[tuple[str, str]]:
    """What these equations do not know, with its owner: what a vehicle with wheels must not have."""
    if not system.wheels:
        yield "", "has no axles with tyres: its model is linear"
    if not speed > 0.0:
        yield "trim", "needs a moving trim: tyres are spliced in at a forward speed"
    if system.rolling:
        yield system.rolling[0].name, "rolls without slip: axles with tyres cannot stand beside it"
    for body in system.bodies:
        if any(body.spin):
            yield body.name, "spins: give its axle 'spin_inertia' instead of a wheel as a body"
    for item in system.inputs:
        if any(item.rate_gain):
            yield item.name, "acts through its rate, which these equations do not take"
    yield from one_sided(system)


def one_sided(system: System) -> Iterator[tuple[str, str]]:
    """Tyres of one side on wheels taken together, and forces that know directions of the ground."""
    for wheel in system.wheels:
        if system.tyres[wheel.tyre].kind == "tir" and wheel.number != 1.0:
            what = "has a tyre file, which is for one side, on wheels taken together: give it or its group a 'track'"
            yield wheel.axle, what
    if system.gravity[0] or system.gravity[1]:
        yield "trim", "needs gravity along z: say a slope by 'grade'"
    for load in system.loads:
        if load.frame != load.body and (load.force[0] or load.force[1]):
            what = "pulls along a direction of the ground, which a free heading does not know: give it a body's 'frame'"
            yield load.name, what


def check_motions(system: System, matrices: Matrices) -> None:
    """Raise `SpliceError` where the lead body cannot move freely on the plane, or a motion has no mass."""
    lead = system.bodies[0].name
    if not set(LEAD) <= set(matrices.reduction.independent.tolist()):
        what = "is not free along x, along y and in yaw, as the lead body of a vehicle on a plane is"
        raise SpliceError((lead, what))
    held = fixed_to_ground(system, matrices)
    if held:
        what = "acts on place or heading of the whole vehicle, which are free: let it act between bodies"
        raise SpliceError((held, what))
    mass = matrices.reduction.W.T @ matrices.M @ matrices.reduction.W
    if not np.linalg.eigvalsh(mass)[0] > 1e-12 * np.max(np.diag(mass)):
        raise SpliceError((lead, "moves with a body without mass, which these equations do not take"))


def fixed_to_ground(system: System, matrices: Matrices) -> str:
    """Name of what a motion of the whole on the plane works against, or of what air it drags along; empty if none."""
    frame = frame_motion(system)
    joints = [name for item in system.constraints for name in [item.connection.name] * row_count(item.connection)]
    springs = [item.name for item in elastic_items(system) for _ in item.rows]
    for names, rows_ in ((joints, matrices.J), (springs, matrices.H)):
        moved = np.abs(rows_ @ frame) > 1e-9 * (np.abs(rows_) @ np.abs(frame) + 1.0)
        if np.any(moved):
            return names[int(np.flatnonzero(np.any(moved, axis=1))[0])]
    added = matrices.M_added.reshape(len(system.bodies), 6, -1)
    heavy = np.flatnonzero(np.any(added != 0.0, axis=(1, 2)))
    return system.bodies[int(heavy[-1])].name if np.any(heavy > 0) else ""


def check_supports(system: System, pivots: Pivots, matrices: Matrices) -> None:
    """Raise `SpliceError` where a support of wheels shares its load with other joints in any proportion."""
    indefinite, row = matrices.statics.indefinite, 0
    supports = {wheel.support for wheel in system.wheels}
    for item in system.constraints:
        count = row_count(item.connection)
        if item.connection.name in supports and (np.any(indefinite[row : row + count]) or row not in pivots.rows):
            what = "shares its load with other joints in any proportion, which leaves wheel loads open: remove one"
            raise SpliceError((item.connection.name, what))
        row += count


def check_balance(system: System, matrices: Matrices) -> None:
    """Raise `SpliceError` if a force or moment remains on a body at the trim."""
    worst = unbalanced(system.bodies, matrices.statics)
    if worst.size:
        body, component = divmod(int(worst[0]), 6)
        kind = ("force along x", "force along y", "force along z", "moment about x", "moment about y", "moment about z")
        unit = "N" if component < 3 else "N m"
        what = (
            f"not in equilibrium in the straight run: a {kind[component]} of "
            f"{matrices.statics.residual[worst[0]]:.6g} {unit} remains; add what carries it, or a load that balances it"
        )
        raise SpliceError((system.bodies[body].name, what))
