"""The same mechanical system in Exudyn, a multibody program that nobody here wrote, and its small motion.

A body's coordinates there are the displacement of its centre of mass and three angles about x, y and z, one after the
other: to first order the rotation vector used here. A trim with a spin needs it about z, the last of the three, and a
body symmetric about it: then the angle of the spin is in no equation.

Exudyn evaluates its nonlinear equations; they are differentiated by central differences, extrapolated once. Their
entries are sines, cosines and lengths of some metres: with a step of 1e-3 the fourth-order error is 1e-12, that of
rounding 1e-16 / 1e-3, both relative to the largest force or stiffness in them.
"""

from collections.abc import Callable
from importlib import import_module
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.vehicle.elements import GROUND, Body, Connection, Constraint, Elastic, System, Vector

Array = NDArray[np.float64]
STEP = 1e-3


class Small(NamedTuple):
    """M q'' + C q' + K q = reactions, for motions q = N z that the joints allow, in the coordinates of all bodies."""

    M: Array
    C: Array
    K: Array
    N: Array

    def A(self) -> Array:
        """System matrix in (z, z')."""
        M, C, K = (self.N.T @ matrix @ self.N for matrix in (self.M, self.C, self.K))
        lower = -np.linalg.solve(M, np.hstack([K, C]))
        return np.vstack([np.eye(len(M), 2 * len(M), len(M)), lower])


class Model:
    """A system of elements, built in Exudyn; spring loads of the trim are given, one per direction."""

    def __init__(self, system: System, tensions: Array) -> None:
        exudyn = import_module("exudyn")
        self.placed, self.library = exudyn.HT, import_module("exudyn.itemInterface")
        self.container = exudyn.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.system = system
        self.ground = self.mbs.AddObject(self.library.ObjectGround())
        self.objects = [self.body(item) for item in system.bodies]
        for constraint in system.constraints:
            self.joint(constraint)
        left = list(tensions)
        for elastic in system.elastic:
            self.spring(elastic, left)
        self.mbs.Assemble()
        self.solver = exudyn.MainSolverStatic()
        settings = exudyn.SimulationSettings()
        settings.staticSolver.verboseMode = 0
        settings.solution.file.write = False
        self.solver.InitializeSolver(self.mbs, settings)
        self.size = self.solver.GetODE2size()
        self.trim = np.concatenate([[*item.velocity, *item.spin] for item in system.bodies])

    def body(self, item: Body) -> int:
        """A rigid body under gravity."""
        start = [*item.centre, 0.0, 0.0, 0.0]
        node = self.mbs.AddNode(self.library.NodeRigidBodyRxyz(referenceCoordinates=start))
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = item.inertia
        inertia = [xx, yy, zz, yz, xz, xy]
        number = self.mbs.AddObject(self.library.ObjectRigidBody(mass=item.mass, inertia=inertia, nodeNumber=node))
        marker = self.mbs.AddMarker(self.library.MarkerBodyMass(bodyNumber=number))
        self.mbs.AddLoad(self.library.LoadMassProportional(markerNumber=marker, loadVector=list(self.system.gravity)))
        return int(number)

    def markers(self, item: Connection) -> list[int]:
        """Places on the second and the first body, of axes whose third is the connection's own, on the second first."""
        axes = frame(item.force_axis if item.forces in {1, 2} else item.moment_axis)
        result = []
        for index, place in zip(item.bodies[::-1], item.places[::-1], strict=True):
            centre = (0.0, 0.0, 0.0) if index == GROUND else self.system.bodies[index].centre
            number = self.ground if index == GROUND else self.objects[index]
            local = self.placed(rotation=axes, translation=list(np.subtract(place, centre)))
            result.append(int(self.mbs.AddMarker(self.library.MarkerBodyRigid(bodyNumber=number, localHT=local))))
        return result

    def joint(self, item: Constraint) -> None:
        """A joint whose counts of forces and moments share an axis."""
        markers, connection = self.markers(item.connection), item.connection
        self.mbs.AddObject(self.library.ObjectJointGeneric(markerNumbers=markers, constrainedAxes=chosen(connection)))

    def spring(self, item: Elastic, tensions: list[float]) -> None:
        """A spring and damper along a line, loaded at the trim, or a bushing in the directions of a point, unloaded."""
        connection, (k, k_turn), (c, c_turn) = item.connection, item.stiffness, item.damping
        markers, directions = self.markers(connection), chosen(connection)
        loads = [tensions.pop(0) for _ in range(1 if connection.line else sum(directions))]
        if connection.line:
            length = float(np.linalg.norm(np.subtract(*connection.places)))
            bar = self.library.ObjectConnectorSpringDamper
            self.mbs.AddObject(
                bar(markerNumbers=markers, referenceLength=length, stiffness=k, damping=c, force=loads[0])
            )
            return
        if np.max(np.abs(loads)) > 1e-9:
            raise ValueError(f"{connection.name}: a loaded bushing is not translated")
        stiffness, damping = ([force] * 3 + [moment] * 3 for force, moment in ((k, k_turn), (c, c_turn)))
        self.mbs.AddObject(
            self.library.ObjectConnectorRigidBodySpringDamper(
                markerNumbers=markers,
                stiffness=np.diag(np.multiply(directions, stiffness)),
                damping=np.diag(np.multiply(directions, damping)),
            )
        )

    def move(self, q: Array, rate: Array) -> None:
        """Puts the system into a state."""
        self.mbs.systemData.SetODE2Coordinates(q)
        self.mbs.systemData.SetODE2Coordinates_t(rate)

    def forces(self, q: Array, rate: Array) -> Array:
        """Everything but reactions and mass times acceleration, shape (6 n,)."""
        self.move(q, rate)
        self.solver.ComputeODE2RHS(self.mbs)
        return np.array(self.solver.GetSystemResidual()[: self.size], dtype=np.float64)

    def jacobian(self, q: Array) -> Array:
        """Derivative of the joints' conditions, shape (conditions, 6 n)."""
        self.move(q, self.trim)
        self.solver.SetSystemJacobian(np.zeros_like(self.solver.GetSystemJacobian()))
        self.solver.ComputeJacobianAE(
            self.mbs, scalarFactor_ODE2=1.0, scalarFactor_ODE2_t=0.0, scalarFactor_ODE1=0.0, velocityLevel=False
        )
        return np.array(self.solver.GetSystemJacobian()[self.size :, : self.size], dtype=np.float64)

    def mass(self) -> Array:
        """Mass matrix at the trim."""
        self.move(np.zeros(self.size), self.trim)
        self.solver.ComputeMassMatrix(self.mbs)
        return np.array(self.solver.GetSystemMassMatrix()[: self.size, : self.size], dtype=np.float64)

    def small_motion(self) -> Small:
        """The linear equations about the trim; ``ValueError`` if it is none."""
        still = np.zeros(self.size)
        J, load = self.jacobian(still), self.forces(still, self.trim)
        reactions = np.linalg.lstsq(J.T, -load, rcond=1e-10)[0]
        if np.max(np.abs(load + J.T @ reactions)) > 1e-9 * max(1.0, float(np.max(np.abs(load)))):
            raise ValueError("Exudyn is not in equilibrium")

        def total(q: Array) -> Array:
            return self.forces(q, self.trim) + self.jacobian(q).T @ reactions

        K = -differences(total, still)
        C = -differences(lambda rate: self.forces(still, rate), self.trim)
        _, sizes, right = np.linalg.svd(np.vstack([J, still]))
        return Small(self.mass(), C, K, right[int(np.sum(sizes > 1e-9 * max(1.0, sizes[0]))) :].T)


def chosen(item: Connection) -> list[int]:
    """Which of two normals and the axis the counts of forces and of moments stand for."""
    which = ((0, 0, 0), (0, 0, 1), (1, 1, 0), (1, 1, 1))
    return [*which[item.forces], *which[item.moments]]


def frame(axis: Vector) -> Array:
    """Orthonormal columns, the third along the axis."""
    matrix = np.column_stack([axis, np.eye(3)[:, np.argsort(np.abs(axis))[:2]]])
    q = np.linalg.qr(matrix)[0]
    q *= np.sign(q[:, 0] @ np.array(axis))
    return np.column_stack([q[:, 1], np.cross(q[:, 0], q[:, 1]), q[:, 0]])


def differences(law: Callable[[Array], Array], at: Array) -> Array:
    """Derivative of a law, column by column, by central differences of two steps, extrapolated."""

    def central(direction: Array, step: float) -> Array:
        return (law(at + step * direction) - law(at - step * direction)) / (2.0 * step)

    columns = [(4.0 * central(e, STEP) - central(e, 2.0 * STEP)) / 3.0 for e in np.eye(len(at))]
    return np.array(columns).T
