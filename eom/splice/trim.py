"""The straight, steady run: drive torque against resistance, slips, loads, and the forces that tyres then have."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from eom.assembly.matrices import Matrices, assemble_matrices
from eom.assembly.reduction import Pivots
from eom.assembly.vectors import Array
from eom.splice.contact import contacts, on_spring, spring_loads
from eom.splice.laws import UNLOADED, LawGroup, forces, law_groups
from eom.splice.wheels import slip_speed
from eom.vehicle.elements import Load, System, Wheel

PASSES, SETTLED = 50, 1e-14
STEP = 1e-30
"""Imaginary step of derivatives: its square vanishes beside one."""


class Trim(NamedTuple):
    """The straight run of a vehicle at a forward speed; arrays are over its wheels.

    Attributes
    ----------
    speed : float
        [m/s]
    load, slip, spin : Array
        Normal load [N], longitudinal slip, speed of rotation [rad/s].
    forces : Array
        Fx, Fy, Mx, My, Mz of the road on the wheels, (5, wheels) [N, N m].
    torque : float
        Drive torque of all driven wheels together [N m].
    """

    speed: float
    load: Array
    slip: Array
    spin: Array
    forces: Array
    torque: float


class TrimError(ValueError):
    """A straight run that cannot be held; ``owner`` is the object to blame."""

    def __init__(self, owner: str, what: str) -> None:
        self.owner = owner
        super().__init__(what)


def solve_trim(
    system: System, pivots: Pivots, speed: float, *, held: bool
) -> tuple[Trim, tuple[LawGroup, ...], Matrices]:
    """The trim of a system without its wheels' linear forces, the tyres' laws, and the matrices with its forces.

    The laws are fitted at the trim's loads. Raises `TrimError` where there is none.
    """
    wheels = system.wheels
    zero = np.zeros(len(wheels))
    radius = np.array([wheel.radius or 1.0 for wheel in wheels])
    now = Trim(speed, zero + np.nan, zero, zero, np.zeros((5, len(wheels))), 0.0)
    laws: tuple[LawGroup, ...] = ()
    for _ in range(PASSES):
        acting = system._replace(loads=(*system.loads, *road_loads(system, now, held=held)))
        matrices = assemble_matrices(acting, pivots)
        loads = trim_loads(acting, pivots, matrices)
        if np.all(np.abs(loads - now.load) <= SETTLED * np.max(np.abs(loads), initial=1.0)):
            break
        check_loads(wheels, loads)
        laws = law_groups(wheels, system.tyres, loads)
        slip, found, torque = steady_rolling(system, laws, loads, now.slip, speed, held=held)
        now = Trim(speed, loads, slip, (speed + slip * float(slip_speed(speed))) / radius, found, torque)
    else:
        raise TrimError(wheels[0].name, "loads and resistance of the straight run do not settle")
    return now, laws, matrices


def trim_loads(system: System, pivots: Pivots, matrices: Matrices) -> Array:
    """Normal loads [N] by statics, `UNLOADED` where nothing tells."""
    own = contacts(system, pivots, np.zeros(len(system.wheels)), matrices.statics.reactions)
    loads = own.share @ own.carried + spring_loads(system, matrices)
    told = [bool(wheel.support) or on_spring(wheel) for wheel in system.wheels]
    return np.where(told, loads, UNLOADED)


def loads_at_rest(system: System, pivots: Pivots) -> Array:
    """Normal loads [N] of a vehicle without its wheels' linear forces that stands still on the level."""
    system = system._replace(loads=tuple(load for load in system.loads if load.frame != load.body))
    return trim_loads(system, pivots, assemble_matrices(system, pivots))


def check_loads(wheels: Sequence[Wheel], loads: Array) -> None:
    """Raise `TrimError` for a wheel that nothing presses on the road."""
    for wheel, load in zip(wheels, loads, strict=True):
        if not load > 0.0:
            what = (
                f"its normal load at the trim is {load:.6g} N, where a wheel has to press on the road: look at "
                "gravity, masses and the places of supports"
            )
            raise TrimError(wheel.axle, what)


def steady_rolling(
    system: System, laws: tuple[LawGroup, ...], loads: Array, kappa: Array, speed: float, *, held: bool
) -> tuple[Array, Array, float]:
    """Slips, forces (5, wheels) and drive torque with which every wheel and the whole run steadily."""
    wheels = system.wheels
    count, radius, share, spinning = (
        np.array([getattr(wheel, name) for wheel in wheels], dtype=float)
        for name in ("number", "radius", "drive_share", "spin_inertia")
    )
    arm = np.where(radius > 0.0, radius, 1.0)
    zero = np.zeros(len(wheels))
    torque = 0.0
    for _ in range(PASSES):
        at = forces(laws, count, zero, kappa + 1j * STEP, loads + 0j, zero, zero + speed)
        resistance = at[3].real / arm
        if not held:
            torque = drive_torque(float(np.sum(resistance)) - against(system, speed), share / arm)
        wanted = share * torque / arm + resistance
        lacking = np.where(spinning > 0.0, wanted - at[0].real, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            change = np.where(spinning > 0.0, lacking / (at[0].imag / STEP), 0.0)
        if not np.all(np.isfinite(change) & (np.abs(kappa + change) < 1.0)):
            worst = int(np.argmax(np.abs(wanted) / loads))
            what = (
                f"the straight run asks of it {wanted[worst]:.6g} N along the road at {loads[worst]:.6g} N of load, "
                "more than its tyre can give"
            )
            raise TrimError(wheels[worst].axle, what)
        kappa = kappa + change
        if np.all(np.abs(change) <= SETTLED):
            break
    found = at.real.copy()
    found[0] = wanted
    return kappa, found, torque


def against(system: System, speed: float) -> float:
    """What else resists the straight run [N]: drag, and loads along x."""
    drag = sum(item.factor for item in system.drags) * speed * abs(speed)
    return float(drag - sum(load.force[0] for load in system.loads))


def drive_torque(along: float, per_torque: Array) -> float:
    """The drive torque that balances a force *along* the run [N], of which wheels give *per_torque* each [1/m]."""
    per = float(np.sum(per_torque))
    if per == 0.0 and abs(along) > 0.0:
        what = (
            f"{abs(along):.6g} N resist the straight run and nothing drives: give an axle 'driven: true', or the trim "
            "'hold: true'"
        )
        raise TrimError("trim", what)
    return 0.0 if per == 0.0 else -along / per


def road_loads(system: System, trim: Trim, *, held: bool) -> list[Load]:
    """What wheels, air and the hold of the speed do to the bodies at the trim, in axes that turn with them."""
    loads, zero = wheel_forces(system, trim), (0.0, 0.0, 0.0)
    for item in system.drags:
        force = -item.factor * trim.speed * abs(trim.speed)
        loads.append(Load(item.name, item.body, item.place, (force, 0.0, 0.0), zero, item.body))
    if held:
        hold = -sum(load.force[0] for load in (*loads, *system.loads))
        loads.append(Load("trim.hold", 0, system.bodies[0].centre, (hold, 0.0, 0.0), zero, 0))
    return loads


def wheel_forces(system: System, trim: Trim) -> list[Load]:
    """What wheels do to the bodies at the trim."""
    loads: list[Load] = []
    zero = (0.0, 0.0, 0.0)
    for wheel, (Fx, Fy, Mx, My, Mz) in zip(system.wheels, trim.forces.T, strict=True):
        spins = wheel.spin_inertia > 0.0
        place = (wheel.place[0], wheel.place[1], wheel.place[2] + wheel.radius * spins)
        back = -wheel.drive_share * trim.torque if spins else float(My)
        name = f"{wheel.name}.road"
        loads.append(Load(name, wheel.body, place, (float(Fx), 0.0, 0.0), (float(Mx), back, float(Mz)), wheel.body))
        loads.append(Load(name, wheel.body, wheel.place, (0.0, float(Fy), 0.0), zero, wheel.body))
    return loads
