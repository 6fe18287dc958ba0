"""Hand-derived linear models of articulated trains, to judge generated models with.

Frame and signs: ISO 8855. x forward, y left, z up (ground at z = 0); yaw, yaw rate and steer
positive to the left; roll positive right-hand about x (left side up); moments right-hand.
Positions of a unit are in its own frame: origin on the ground under its kingpin (tractor: under
its front axle), so points behind have negative x. SI units and radians throughout.

Two derivations that share nothing but the data:

* `yaw_roll` writes the quadratic Lagrangian of the train in an inertial frame that travels
  straight ahead at the trim speed U. There the train is at rest at trim, so its energies are
  plain quadratic forms of small displacements, without a single speed-dependent inertia term:
  U enters by the slip of the tyres and in the change to heading axes at the end.
* `yaw_plane` balances the lateral force and the yaw moment of each rigid unit in its own heading
  axes (Newton-Euler), with the lateral forces of the hitches as explicit unknowns.

Source of the vehicle data: S. Zhu's thesis, Appendix B (B-train double), and Appendix A with
Table 4.1 (tractor and semitrailer).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Body:
    """A rigid body of a unit, symmetric about the unit's vertical middle plane.

    Attributes
    ----------
    mass : float
        Mass, kg.
    x, z : float
        Centre of mass in the frame of the unit, m (z: height above ground).
    i_zz, i_xx : float
        Yaw and roll moments of inertia about the centre of mass, kg m^2.
    i_xz : float
        The positive integral of x z dm about the centre of mass, kg m^2.
    """

    mass: float
    x: float
    i_zz: float
    z: float = 0.0
    i_xx: float = 0.0
    i_xz: float = 0.0


@dataclass(frozen=True)
class Axle:
    """An axle: its position x, m, and the cornering stiffness of all its tyres, N/rad."""

    x: float
    cornering: float


@dataclass(frozen=True)
class RollParts:
    """Roll springs of a unit whose bodies are (sprung, unsprung).

    Attributes
    ----------
    axis_height : float
        Height above ground of the roll axis that both bodies turn about, m.
    suspension_stiffness, suspension_damping : float
        Between sprung and unsprung body, N m/rad and N m s/rad, all suspensions of the unit.
    tyre_stiffness : float
        Between unsprung body and ground, N m/rad, all axles of the unit.
    """

    axis_height: float
    suspension_stiffness: float
    suspension_damping: float
    tyre_stiffness: float


@dataclass(frozen=True)
class Unit:
    """A unit of the train: its bodies, its axles and, where the data have them, its roll parts."""

    name: str
    bodies: tuple[Body, ...]
    axles: tuple[Axle, ...]
    roll: RollParts | None = None

    @property
    def mass(self) -> float:
        """Whole mass, kg."""
        return sum(body.mass for body in self.bodies)

    @property
    def x(self) -> float:
        """Position of the whole-mass centre in the frame of the unit, m."""
        return sum(body.mass * body.x for body in self.bodies) / self.mass

    @property
    def i_zz(self) -> float:
        """Yaw moment of inertia about the whole-mass centre, kg m^2."""
        return sum(body.i_zz + body.mass * (body.x - self.x) ** 2 for body in self.bodies)


@dataclass(frozen=True)
class Hitch:
    """A pin between a unit and the next one, carrying horizontal force on the sprung bodies.

    Attributes
    ----------
    x_ahead, x_behind : float
        Its position in the frames of the unit ahead and of the unit behind, m.
    height : float
        Height above ground, m.
    roll_stiffness : float
        Between the sprung bodies, N m/rad of difference in roll.
    """

    x_ahead: float
    x_behind: float = 0.0
    height: float = 0.0
    roll_stiffness: float = 0.0


@dataclass(frozen=True)
class TrainParameters:
    """A train: units front to rear, the hitches between them, and gravity, m/s^2."""

    units: tuple[Unit, ...]
    hitches: tuple[Hitch, ...]
    gravity: float = 9.8


class LinearModel(NamedTuple):
    """State space dx/dt = A x + B u, y = C x + D u, with the names of x, u and y."""

    A: FloatArray
    B: FloatArray
    states: list[str]
    inputs: list[str]
    C: FloatArray
    D: FloatArray
    outputs: list[str]


def yaw_roll(parameters: TrainParameters, U: float) -> LinearModel:
    """Linearise a train of rolling units about straight running at constant speed.

    Each unit is a sprung and an unsprung body that turn about one horizontal axis, fixed in the
    heading of the unit, at constant height. Hitches carry horizontal force only, so each unit
    bears its own weight. Tyres give F_y = -C (v_y / U - steer), v_y being the lateral velocity,
    in heading axes, of the point of the unsprung body that touches the ground; the force acts
    there.

    Parameters
    ----------
    parameters : TrainParameters
        A train whose units have bodies (sprung, unsprung) and roll parts, such as `B_TRAIN`.
    U : float
        Forward speed, m/s.

    Returns
    -------
    LinearModel
        For n units, 6 n states: `tractor.v_y`, the lateral velocity in heading axes of the point
        of the roll axis above the origin of the first unit (its front axle), m/s; n yaw rates,
        rad/s; n - 1 articulations (heading less that of the unit ahead), rad; n sprung and n
        unsprung rolls, rad, and their rates, rad/s.

        Inputs: the steer of every axle, rad; on each unit a roll moment, + on the sprung and
        - on the unsprung body, N m; on each unit but the first an external yaw moment, N m.

        Outputs: `ay`, the lateral acceleration of the whole-mass centre of each unit, m/s^2;
        `axle_1.ay`, that of the roll-axis point above the first axle, m/s^2; yaw rates, rad/s;
        `sideslip`, v_y / U of each whole-mass centre, rad; sprung and unsprung rolls, rad.
    """
    units = parameters.units
    n = len(units)
    q = _Displacements.of(parameters)
    M, L, K, H = _second_order(parameters, q, U)

    names = [unit.name for unit in units]
    rolls = [f"{name}.roll" for name in names] + [f"{name}.unsprung_roll" for name in names]
    states = [*_planar_states(names), *rolls, *(f"{roll}_rate" for roll in rolls)]
    inputs = [
        *_steer_names(units),
        *(f"{name}.roll_moment" for name in names),
        *(f"{name}.yaw_moment" for name in names[1:]),
    ]

    # Heading axes: y' = v_y + U yaw_1. Turning the whole train (every yaw by one angle, y' by U
    # times that angle) changes neither slip nor energy, so y and the first unit's yaw drop out:
    # the forces are those of q = q_x x and q' = v_x x.
    x_rows = np.eye(len(states))
    r, articulation = x_rows[1 : 1 + n], x_rows[1 + n : 2 * n]
    roll, roll_rate = x_rows[2 * n : 4 * n], x_rows[4 * n :]
    q_x = np.vstack([np.zeros((2, len(states))), np.cumsum(articulation, axis=0), roll])
    v_x = np.vstack([x_rows[:1], r, roll_rate])
    acceleration_x = -np.linalg.solve(M, K @ q_x + L @ v_x)
    acceleration_u = np.linalg.solve(M, H)

    A = np.vstack(
        [
            acceleration_x[0] - U * r[0],
            acceleration_x[1 : 1 + n],
            np.diff(r, axis=0),
            roll_rate,
            acceleration_x[1 + n :],
        ]
    )
    B = np.zeros((len(states), len(inputs)))
    B[: 1 + n] = acceleration_u[: 1 + n]
    B[4 * n :] = acceleration_u[1 + n :]

    centres = np.array([q.whole_mass_centre(i, unit) for i, unit in enumerate(units)])
    accelerated = np.vstack([centres, q.origin[0] + units[0].axles[0].x * q.yaw[0]])
    sideslip = centres @ v_x / U - q.yaw @ q_x
    C = np.vstack([accelerated @ acceleration_x, r, sideslip, roll])
    D = np.zeros((len(C), len(inputs)))
    D[: 1 + n] = accelerated @ acceleration_u
    return LinearModel(A, B, states, inputs, C, D, [*_planar_outputs(names), *rolls])


class _Displacements(NamedTuple):
    """Small displacements of a train, as row vectors that pick them out of its coordinates.

    The coordinates are (y, yaw_1.., sprung roll_1.., unsprung roll_1..), y being the lateral
    position of the roll axis above the first unit's origin.
    """

    yaw: FloatArray
    sprung_roll: FloatArray
    unsprung_roll: FloatArray
    axis_height: list[float]
    origin: list[FloatArray]
    """Lateral position of each unit's roll axis above the origin of the unit."""

    @classmethod
    def of(cls, parameters: TrainParameters) -> "_Displacements":
        """Fix the coordinates and carry the lateral position from hitch to hitch."""
        n = len(parameters.units)
        y, *rest = np.eye(1 + 3 * n)
        yaw, sprung_roll, unsprung_roll = np.reshape(rest, (3, n, 1 + 3 * n))
        axis_height = [_roll_parts(unit).axis_height for unit in parameters.units]
        q = cls(yaw, sprung_roll, unsprung_roll, axis_height, origin=[y])
        for i, hitch in enumerate(parameters.hitches):
            pin = q.point(i, hitch.x_ahead, hitch.height, sprung_roll[i])
            to_pin = q.offset(i + 1, hitch.x_behind, hitch.height, sprung_roll[i + 1])
            q.origin.append(pin - to_pin)
        return q

    def offset(self, i: int, x: float, z: float, roll: FloatArray) -> FloatArray:
        """Lateral displacement of a point of unit i less that of the roll axis at its origin."""
        row: FloatArray = x * self.yaw[i] - (z - self.axis_height[i]) * roll
        return row

    def point(self, i: int, x: float, z: float, roll: FloatArray) -> FloatArray:
        """Lateral displacement of the point (x, z) of the body of unit i that rolls by `roll`."""
        return self.origin[i] + self.offset(i, x, z, roll)

    def bodies(self, i: int, unit: Unit) -> list[tuple[Body, FloatArray, FloatArray]]:
        """Each body of unit i with its roll and the lateral displacement of its mass centre."""
        rolls = (self.sprung_roll[i], self.unsprung_roll[i])
        return [
            (body, roll, self.point(i, body.x, body.z, roll)) for body, roll in zip(unit.bodies, rolls, strict=True)
        ]

    def whole_mass_centre(self, i: int, unit: Unit) -> FloatArray:
        """Lateral displacement of the common mass centre of the bodies of unit i."""
        rows = [body.mass * lateral for body, _, lateral in self.bodies(i, unit)]
        centre: FloatArray = np.sum(rows, axis=0) / unit.mass
        return centre


def _second_order(
    parameters: TrainParameters, q: _Displacements, U: float
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Matrices of M q'' + L q' + K q = H u in the frame that travels ahead at speed U.

    M is the Hessian of the kinetic energy; K is that of the potential energy less what the tyres
    add, L that of the dissipation. At trim no horizontal force acts anywhere, so no force brings
    a geometric stiffness with it but gravity.
    """
    size = len(q.origin[0])
    M, L, K = (np.zeros((size, size)) for _ in range(3))
    steer, roll_moments, yaw_moments = [], [], []
    for i, unit in enumerate(parameters.units):
        parts, yaw = _roll_parts(unit), q.yaw[i]
        for body, roll, lateral in q.bodies(i, unit):
            M += body.mass * np.outer(lateral, lateral)
            M += body.i_xx * np.outer(roll, roll) + body.i_zz * np.outer(yaw, yaw)
            M -= body.i_xz * (np.outer(roll, yaw) + np.outer(yaw, roll))
            # The mass centre is (z - axis height) cos(roll) above the axis.
            lever = body.z - parts.axis_height
            K -= body.mass * parameters.gravity * lever * np.outer(roll, roll)

        deflection = q.sprung_roll[i] - q.unsprung_roll[i]
        K += parts.suspension_stiffness * np.outer(deflection, deflection)
        L += parts.suspension_damping * np.outer(deflection, deflection)
        K += parts.tyre_stiffness * np.outer(q.unsprung_roll[i], q.unsprung_roll[i])
        for axle in unit.axles:
            # F_y = cornering (yaw + steer - contact' / U) does work on the contact point.
            contact = q.point(i, axle.x, 0.0, q.unsprung_roll[i])
            L += axle.cornering / U * np.outer(contact, contact)
            K -= axle.cornering * np.outer(contact, yaw)
            steer.append(axle.cornering * contact)
        roll_moments.append(deflection)
        yaw_moments.append(yaw)
    for i, hitch in enumerate(parameters.hitches):
        twist = q.sprung_roll[i] - q.sprung_roll[i + 1]
        K += hitch.roll_stiffness * np.outer(twist, twist)
    return M, L, K, np.column_stack([*steer, *roll_moments, *yaw_moments[1:]])


def yaw_plane(parameters: TrainParameters, U: float) -> LinearModel:
    """Linearise a train of units that do not roll about straight running at constant speed.

    Tyres give F_y = -C (v_y / U - steer). Only the whole mass, its centre and its yaw moment of
    inertia are used of each unit.

    Parameters
    ----------
    parameters : TrainParameters
        A train of two or more units.
    U : float
        Forward speed, m/s.

    Returns
    -------
    LinearModel
        For n units, 2 n states: `tractor.v_y`, the lateral velocity in heading axes of the origin
        of the first unit (its front axle), m/s; n yaw rates, rad/s; n - 1 articulations (heading
        less that of the unit ahead), rad.

        Inputs: the steer of every axle, rad; on each unit but the first an external yaw moment,
        N m.

        Outputs: as in `yaw_roll`, without the rolls.
    """
    units, hitches = parameters.units, parameters.hitches
    n = len(units)
    names = [unit.name for unit in units]
    states = _planar_states(names)
    inputs = [*_steer_names(units), *(f"{name}.yaw_moment" for name in names[1:])]
    x_rows, u_rows = np.eye(len(states)), np.eye(len(inputs))
    r, articulation = x_rows[1 : 1 + n], x_rows[1 + n :]

    # Lateral velocity of each unit's origin in its own heading axes: both units of a hitch have
    # the same velocity there, seen from headings that differ by the articulation.
    v = [x_rows[0]]
    for i, hitch in enumerate(hitches):
        v_hitch = v[i] + hitch.x_ahead * r[i] - U * articulation[i]
        v.append(v_hitch - hitch.x_behind * r[i + 1])

    # Unknowns: v_y' of each origin, yaw accelerations, lateral hitch forces on the unit behind.
    # Equations: lateral balance and yaw balance about the mass centre of each unit; equal
    # lateral acceleration v' + x r' + U r of the two units at each hitch.
    unknowns = np.zeros((3 * n - 1, 3 * n - 1))
    by_state = np.zeros((3 * n - 1, len(states)))
    by_input = np.zeros((3 * n - 1, len(inputs)))
    axle_number = 0
    for i, unit in enumerate(units):
        lateral, moment = i, n + i
        unknowns[lateral, i] = unit.mass
        unknowns[lateral, n + i] = unit.mass * unit.x
        by_state[lateral] -= unit.mass * U * r[i]
        unknowns[moment, n + i] = unit.i_zz
        for axle in unit.axles:
            slip = (v[i] + axle.x * r[i]) / U
            by_state[lateral] -= axle.cornering * slip
            by_state[moment] -= (axle.x - unit.x) * axle.cornering * slip
            by_input[lateral] += axle.cornering * u_rows[axle_number]
            by_input[moment] += (axle.x - unit.x) * axle.cornering * u_rows[axle_number]
            axle_number += 1
        if i > 0:
            by_input[moment] += u_rows[len(_steer_names(units)) + i - 1]
    for i, hitch in enumerate(hitches):
        force = equal = 2 * n + i
        for unit_number, x, sign in ((i, hitch.x_ahead, -1.0), (i + 1, hitch.x_behind, 1.0)):
            unknowns[unit_number, force] -= sign
            unknowns[n + unit_number, force] -= sign * (x - units[unit_number].x)
            unknowns[equal, unit_number] += sign
            unknowns[equal, n + unit_number] += sign * x
            by_state[equal] -= sign * U * r[unit_number]
    solved_x = np.linalg.solve(unknowns, by_state)
    solved_u = np.linalg.solve(unknowns, by_input)

    A = np.vstack([solved_x[0], solved_x[n : 2 * n], np.diff(r, axis=0)])
    B = np.vstack([solved_u[0], solved_u[n : 2 * n], np.zeros((n - 1, len(inputs)))])

    points = [(i, unit.x) for i, unit in enumerate(units)] + [(0, units[0].axles[0].x)]
    a_x = [solved_x[i] + x * solved_x[n + i] + U * r[i] for i, x in points]
    a_u = [solved_u[i] + x * solved_u[n + i] for i, x in points]
    sideslip = [(v[i] + unit.x * r[i]) / U for i, unit in enumerate(units)]
    C = np.vstack([*a_x, r, *sideslip])
    D = np.vstack([*a_u, np.zeros((2 * n, len(inputs)))])
    return LinearModel(A, B, states, inputs, C, D, _planar_outputs(names))


def _roll_parts(unit: Unit) -> RollParts:
    if unit.roll is None:
        raise ValueError(f"unit {unit.name!r} has no roll parts")
    return unit.roll


def _steer_names(units: Sequence[Unit]) -> list[str]:
    count = sum(len(unit.axles) for unit in units)
    return [f"axle_{k}.steer" for k in range(1, count + 1)]


def _planar_states(names: Sequence[str]) -> list[str]:
    return [
        f"{names[0]}.v_y",
        *(f"{name}.yaw_rate" for name in names),
        *(f"{name}.articulation" for name in names[1:]),
    ]


def _planar_outputs(names: Sequence[str]) -> list[str]:
    return [
        *(f"{name}.ay" for name in names),
        "axle_1.ay",
        *(f"{name}.yaw_rate" for name in names),
        *(f"{name}.sideslip" for name in names),
    ]


def _tridem_semitrailer(name: str, suspension_stiffness: float, tyre_stiffness: float, cornering: float) -> Unit:
    return Unit(
        name,
        bodies=(
            Body(mass=15_927.0, x=-6.385, z=1.555, i_xx=6_879.0, i_zz=439_990.0, i_xz=-130.0),
            Body(mass=2_070.0, x=-11.49720, z=0.51, i_xx=798.0, i_zz=3_024.0),
        ),
        axles=tuple(Axle(x, cornering) for x in (-10.23, -11.50, -12.77)),
        roll=RollParts(0.705, suspension_stiffness, 120e3, tyre_stiffness),
    )


B_TRAIN = TrainParameters(
    units=(
        Unit(
            "tractor",
            bodies=(
                Body(mass=6_308.0, x=-1.384, z=1.019, i_xx=6_879.0, i_zz=19_665.0, i_xz=-130.0),
                Body(mass=1_950.0, x=-3.98845, z=0.519, i_xx=867.0, i_zz=14_232.0),
            ),
            axles=(Axle(0.0, 424.0e3), Axle(-5.0, 420.2e3), Axle(-6.27, 420.2e3)),
            roll=RollParts(0.705, 700e3 + 1_100e3, 50e3 + 80e3, 900e3 + 1_500e3),
        ),
        _tridem_semitrailer("semitrailer_1", 2.0e6, 6.0e6, 581.9e3),
        _tridem_semitrailer("semitrailer_2", 2.2e6, 5.2e6, 346.5e3),
    ),
    hitches=(
        Hitch(x_ahead=-5.635, height=1.1, roll_stiffness=550e3),
        Hitch(x_ahead=-12.57, height=1.1, roll_stiffness=550e3),
    ),
)
"""B-train double, Zhu's thesis, Appendix B (its product of inertia +130 is SAE: z down).

The unsprung centres are those that give the printed whole-mass centres (1.999 m behind the front
axle, 6.973 m behind the kingpin). The yaw moments of inertia of the bodies are not printed; these
give the printed ones of the whole masses within 0.011 % (44 000.8 for 43 996 and 490 890.2 for
490 940 kg m^2).
"""

B_TRAIN_WHOLE_MASS = TrainParameters(
    units=tuple(
        Unit(unit.name, (Body(unit.mass, x, i_zz),), unit.axles)
        for unit, x, i_zz in zip(B_TRAIN.units, (-1.999, -6.973, -6.973), (43_996.0, 490_940.0, 490_940.0), strict=True)
    ),
    hitches=(Hitch(x_ahead=-5.635), Hitch(x_ahead=-12.57)),
)
"""B-train double without roll, from the whole-mass data printed in Zhu's thesis, Appendix B."""

TRACTOR_SEMITRAILER = TrainParameters(
    units=(
        Unit(
            "tractor",
            bodies=(Body(mass=6_525.0, x=-1.115, i_zz=20_616.0),),
            axles=(Axle(0.0, 242_597.0), Axle(-3.7, 578_760.0)),
        ),
        Unit(
            "semitrailer",
            bodies=(Body(mass=11_665.0, x=-5.493, i_zz=113_580.0),),
            axles=(Axle(-10.0, 554_484.0),),
        ),
    ),
    hitches=(Hitch(x_ahead=-3.074),),
)
"""Tractor and semitrailer without roll, Zhu's thesis, Table A1 and Table 4.1."""
