"""A B-train without height, and the same train as the exact referee `planar_train` knows it.

Masses, hitches and supports lie on the ground, so nothing tilts. What is left of load transfer is that of spinning
wheels, whose hubs are above the road: the referee takes loads from the model.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

import eom
from eom.model.tyre import TyreModel, build_tyre_model
from eom.tyre import MagicFormula
from eom.vehicle.elements import Wheel
from tests.referees import planar_train
from tests.referees.planar_parts import Motion, PlanarTrain, PlanarUnit, PlanarWheel, split
from tests.splice.shared import Array, places

HITCHES = ((-5.635, 0.0), (-12.57, 0.0))
"""Place of each pin on the unit ahead and on the unit behind, from the origins of both [m]."""
STIFFNESSES = {"steer": (424, 170), "drive": (420, 180), "first": (582, 290), "second": (347, 190)}
"""Cornering [kN/rad] and longitudinal stiffness [kN] of an axle's tyres, by the names of `TEXT`."""
TEXT = """
name: B-train without height
gravity: 9.8 m/s^2
trim: {speed: 110 km/h}
parameters: {r_w: 0.51 m, I_w: 40 kg*m^2, K_b: 20 kN*m/MPa}
tyres:
  steer:
    {per: axle, cornering: 424 kN/rad, longitudinal: 170 kN, rolling_resistance: 0.01,
     nonlinear: &law {kind: magic_formula, friction: 0.85, C_x: 1.65, E_x: 0, C_y: 1.3, E_y: -1}}
  drive: {per: axle, cornering: 420 kN/rad, longitudinal: 180 kN, rolling_resistance: 0.01, nonlinear: *law}
  first: {per: axle, cornering: 582 kN/rad, longitudinal: 290 kN, rolling_resistance: 0.01, nonlinear: *law}
  second: {per: axle, cornering: 347 kN/rad, longitudinal: 190 kN, rolling_resistance: 0.01, nonlinear: *law}
templates:
  tridem:
    needs: [tyre]
    bodies: {frame: {mass: 17997 kg, at: [-6.973, 0, 0], inertia: {xx: 20000, yy: 490940, zz: 490940}}}
    connectors: {plane: {type: support, body: frame, at: [-6.973, 0, 0], carries: [roll]}}
    axle_groups: {tridem: {body: frame, support: {at: [-11.5, 0, 0]}}}
    axles:
      front: {group: tridem, x: -10.23, tyre: tyre, radius: r_w, spin_inertia: I_w, brake_gain: K_b}
      middle: {like: front, x: -11.50}
      rear: {like: front, x: -12.77}
units:
  tractor:
    bodies: {frame: {mass: 8258 kg, at: [-1.999, 0, 0], inertia: {xx: 8000, yy: 43996, zz: 43996}}}
    connectors: {plane: {type: support, body: frame, at: [-1.999, 0, 0], carries: [roll]}}
    axle_groups:
      front: {body: frame, support: {at: [0, 0, 0]}}
      tandem: {body: frame, support: {at: [-5.635, 0, 0]}}
    axles:
      front: {group: front, x: 0, tyre: steer, steered: true, radius: r_w, spin_inertia: I_w, brake_gain: K_b}
      drive_1: {group: tandem, x: -5.0, tyre: drive, driven: true, radius: r_w, spin_inertia: I_w, brake_gain: K_b}
      drive_2: {like: drive_1, x: -6.27}
  semitrailer_1: {use: tridem, with: {tyre: first}}
  semitrailer_2: {use: tridem, with: {tyre: second}}
couplings:
  hitch_1:
    kind: fifth_wheel
    between: [tractor, semitrailer_1]
    at: {tractor: [-5.635, 0, 0], semitrailer_1: [0, 0, 0]}
    carries: [x, y, z]
  hitch_2:
    kind: fifth_wheel
    between: [semitrailer_1, semitrailer_2]
    at: {semitrailer_1: [-12.57, 0, 0], semitrailer_2: [0, 0, 0]}
    carries: [x, y, z]
"""


@dataclass(frozen=True)
class Pair:
    """The model and its referee: the same state in two vectors, told apart by the order of their parts."""

    model: TyreModel
    train: PlanarTrain

    def of_referee(self, x: ArrayLike) -> Array:
        """The referee's state: place, yaws, velocity, yaw rates, spins."""
        at, x = places(self.model), np.asarray(x, dtype=float)
        n, yaw = x[at["n"]], np.concatenate(([0.0], x[at["q"]]))
        return np.concatenate((x[:2], x[2] + yaw, n[:2], n[2:], x[at["spin"]]))

    def of_model(self, state: ArrayLike) -> Array:
        """The model's state."""
        now = split(self.train, state)
        own = now.yaw[1:] - now.yaw[0]
        return np.concatenate((now.position, now.yaw[:1], own, now.velocity, now.yaw_rate, now.spin))

    def applied(self, u: Array) -> tuple[Array, Array]:
        """Steer angles and torques of each single wheel, as the referee takes them: no brake is near standstill."""
        wheels, names = self.model.prepared.system.wheels, self.model.inputs
        torque = []
        for wheel in wheels:
            brake = wheel.brake_gain * u[names.index(f"{wheel.name}.brake_pressure")]
            torque.append((wheel.drive_share * u[names.index("drive_torque")] - brake) / wheel.number)
        return u[[names.index("axle_1.steer")]], np.array(torque)

    def loaded(self, load: Array) -> PlanarTrain:
        """The referee with loads of its axles [N]."""
        rest, units = iter(load), []
        for unit in self.train.units:
            wheels = tuple(replace(wheel, load=float(next(rest)) / wheel.count) for wheel in unit.wheels)
            units.append(replace(unit, wheels=wheels))
        return PlanarTrain(tuple(units))

    def referee(self, state: Array, u: Array) -> Motion:
        """What the referee says of a state, under the loads that the model has in it."""
        load = self.model.evaluated(self.of_model(state), u).balance.load
        return planar_train.accelerations(self.loaded(load), state, *self.applied(u))

    def referee_rates(self, state: Array, u: Array) -> Array:
        """The referee's rates of its state."""
        load = self.model.evaluated(self.of_model(state), u).balance.load
        return planar_train.rhs(self.loaded(load), state, *self.applied(u))


def pair() -> Pair:
    """The model of `TEXT` and its referee."""
    model = build_tyre_model(eom.loads(TEXT))
    system, origins = model.prepared.system, np.cumsum([0.0, *(ahead - behind for ahead, behind in HITCHES)])
    units = []
    for k, body in enumerate(system.bodies):
        wheels = tuple(
            PlanarWheel(
                x=wheel.place[0] - body.centre[0],
                radius=wheel.radius,
                load=load / wheel.number,
                tyre=tyre_of(model, wheel).forces,
                spin_inertia=wheel.spin_inertia / wheel.number,
                steer_index=0 if wheel.steer else None,
                count=round(wheel.number),
            )
            for wheel, load in zip(system.wheels, model.prepared.trim.load, strict=True)
            if wheel.body == k
        )
        offset = origins[k] - body.centre[0]
        units.append(
            PlanarUnit(
                mass=body.mass,
                yaw_inertia=body.inertia[2][2],
                wheels=wheels,
                front=HITCHES[k - 1][1] + offset if k else None,
                rear=HITCHES[k][0] + offset if k < len(HITCHES) else None,
            )
        )
    return Pair(model, PlanarTrain(tuple(units)))


def tyre_of(model: TyreModel, wheel: Wheel) -> MagicFormula:
    """A wheel's tyre: stiffnesses of `TEXT` at the mean load of one wheel of those that share them."""
    system = model.prepared.system
    same = [other.tyre == wheel.tyre for other in system.wheels]
    load = float(np.mean(model.prepared.trim.load[same])) / 2.0
    cornering, longitudinal = (1e3 * value / 2.0 for value in STIFFNESSES[system.tyres[wheel.tyre].name])
    return MagicFormula(
        nominal_load=load,
        k_y=cornering / load,
        k_x=longitudinal / load,
        mu_x=0.85,
        mu_y=0.85,
        C_x=1.65,
        E_x=0.0,
        C_y=1.3,
        E_y=-1.0,
        rolling_resistance=0.01,
        radius=wheel.radius,
    )
