"""A car that rolls on its suspension, in the description of `eom` and in Exudyn, with the same tyres.

Its axles stay flat on the road; its frame turns about a roll axis in them. Tyres stand in the middle of each axle. In
Exudyn they are loads that a function of the state gives; loads of the wheels are those at rest.
"""

from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.tyre import MagicFormula, slips

Array = NDArray[np.float64]
A, B, H_ROLL, HEIGHT = 1.3, 1.6, 0.2, 0.75
MASS, UNSPRUNG, GRAVITY, SPEED = 1500.0, 300.0, 9.81, 25.0
ROLL_STIFFNESS, ROLL_DAMPING = 6e4, 4e3
STIFFNESS = (55e3, 65e3)
"""Cornering stiffness of a front and a rear wheel [N/rad]."""
TEXT = f"""
name: car that rolls
gravity: {GRAVITY}
trim: {{speed: {SPEED}}}
tyres:
  front:
    per: wheel
    cornering: {STIFFNESS[0]}
    nonlinear: &law {{kind: magic_formula, friction: 1, C_y: 1.3, E_y: -1}}
  rear: {{per: wheel, cornering: {STIFFNESS[1]}, nonlinear: *law}}
units:
  car:
    bodies:
      frame: {{mass: {MASS}, at: [0, 0, {HEIGHT}], inertia: {{xx: 500, yy: 2000, zz: 2200, xz: 60}}}}
      axles: {{mass: {UNSPRUNG}, at: [-0.1, 0, 0.3], inertia: {{xx: 150, yy: 600, zz: 700}}}}
    connectors:
      plane: {{type: support, body: axles, at: [0, 0, 0], carries: [roll]}}
    suspensions:
      suspension:
        between: [frame, axles]
        roll_axis: {{height: {H_ROLL}}}
        roll_stiffness: {ROLL_STIFFNESS}
        roll_damping: {ROLL_DAMPING}
    axle_groups:
      front: {{body: axles, support: {{at: [{A}, 0, 0]}}}}
      rear: {{body: axles, support: {{at: [-{B}, 0, 0]}}}}
    axles:
      front: {{group: front, x: {A}, tyre: front, steered: true}}
      rear: {{group: rear, x: -{B}, tyre: rear}}
"""


class Motion(NamedTuple):
    """Samples over time: yaw rate, velocities of the axles' centre to the left and forward, roll of the frame."""

    yaw_rate: Array
    sideward: Array
    roll: Array
    speed: Array


def loads() -> tuple[float, float]:
    """Loads of one front and one rear wheel [N], by levers."""
    moment = UNSPRUNG * -0.1
    rear = (A * (MASS + UNSPRUNG) - moment) / (A + B)
    return GRAVITY * (MASS + UNSPRUNG - rear) / 2.0, GRAVITY * rear / 2.0


def straight(_: float) -> float:
    """No steer at any time."""
    return 0.0


def side_force(
    body: int, tyre: MagicFormula, place: tuple[float, float, float], load: float, steer: Callable[[float], float]
) -> Callable[[Any, float, Any], list[float]]:
    """The force of both wheels of an axle on a body [N], in its axes, as Exudyn asks for it."""
    kind = import_module("exudyn").OutputVariableType

    def force(mbs: Any, t: float, _: Any) -> list[float]:
        v = mbs.GetObjectOutputBody(body, kind.Velocity, place)
        forward, left, _up = mbs.GetObjectOutputBody(body, kind.RotationMatrix, place).reshape(3, 3).T @ v
        cos, sin = np.cos(steer(t)), np.sin(steer(t))
        alpha, _kappa = slips(cos * forward + sin * left, cos * left - sin * forward, 1.0, 1.0)
        Fy = 2.0 * float(tyre.forces(float(alpha), 0.0, load, 0.0, SPEED).Fy)
        return [-sin * Fy, cos * Fy, 0.0]

    return force


def simulate(steer: Callable[[float], float], end: float, samples: int, step: float) -> Motion:
    """The motion in Exudyn from a straight run, the front wheels steered by an angle over time [rad]."""
    exu, items = import_module("exudyn"), import_module("exudyn.itemInterface")
    container = exu.SystemContainer()
    mbs = container.AddSystem()

    def body(mass: float, inertia: tuple[float, float, float, float], x: float, z: float) -> int:
        """A rigid body that moves along x; inertia Ixx, Iyy, Izz and the entry xz of the tensor."""
        node = mbs.AddNode(
            items.NodeRigidBodyRxyz(referenceCoordinates=[x, 0, z, 0, 0, 0], initialVelocities=[SPEED, 0, 0, 0, 0, 0])
        )
        xx, yy, zz, xz = inertia
        number = mbs.AddObject(items.ObjectRigidBody(mass=mass, inertia=[xx, yy, zz, 0.0, xz, 0.0], nodeNumber=node))
        marker = mbs.AddMarker(items.MarkerBodyMass(bodyNumber=number))
        mbs.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0.0, 0.0, -GRAVITY]))
        return int(number)

    frame = body(MASS, (500.0, 2000.0, 2200.0, -60.0), 0.0, HEIGHT)
    axles = body(UNSPRUNG, (150.0, 600.0, 700.0, 0.0), -0.1, 0.3)
    ground = mbs.AddObject(items.ObjectGround())

    def marker(number: int, place: tuple[float, float, float]) -> int:
        return int(mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=number, localPosition=list(place))))

    flat = [marker(ground, (0.0, 0.0, 0.0)), marker(axles, (0.1, 0.0, -0.3))]
    mbs.AddObject(items.ObjectJointGeneric(markerNumbers=flat, constrainedAxes=[0, 0, 1, 1, 1, 0]))
    hinge = [marker(axles, (0.1, 0.0, H_ROLL - 0.3)), marker(frame, (0.0, 0.0, H_ROLL - HEIGHT))]
    mbs.AddObject(items.ObjectJointGeneric(markerNumbers=hinge, constrainedAxes=[1, 1, 1, 0, 1, 1]))
    spring, damper = np.zeros((2, 6, 6))
    spring[3, 3], damper[3, 3] = ROLL_STIFFNESS, ROLL_DAMPING
    mbs.AddObject(items.ObjectConnectorRigidBodySpringDamper(markerNumbers=hinge, stiffness=spring, damping=damper))

    for x, stiffness, load, steered in zip((A, -B), STIFFNESS, loads(), (True, False), strict=True):
        tyre = MagicFormula(nominal_load=load, k_y=stiffness / load, k_x=1.0, mu_x=1.0, mu_y=1.0, C_y=1.3, E_y=-1.0)
        place = (x + 0.1, 0.0, -0.3)

        force = side_force(axles, tyre, place, load, steer if steered else straight)
        mbs.AddLoad(
            items.LoadForceVector(markerNumber=marker(axles, place), bodyFixed=True, loadVectorUserFunction=force)
        )

    names = ("AngularVelocityLocal", "VelocityLocal", "Rotation")
    kinds = [getattr(exu.OutputVariableType, name) for name in names]
    sensors = [
        mbs.AddSensor(
            items.SensorBody(bodyNumber=number, localPosition=[0, 0, 0], storeInternal=True, outputVariableType=kind)
        )
        for number, kind in zip((axles, axles, frame), kinds, strict=True)
    ]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(end / step)
    settings.timeIntegration.endTime = end
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = end / samples
    mbs.SolveDynamic(settings)
    turning, moving, rolled = (mbs.GetSensorStoredData(sensor) for sensor in sensors)
    return Motion(turning[:, 3], moving[:, 2], rolled[:, 1], moving[:, 1])
