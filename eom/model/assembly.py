"""A vehicle's matrices with their labels, checked."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, overload

import numpy as np

from eom.assembly.algebra import DENSE, Algebra
from eom.assembly.checks import check_system
from eom.assembly.diagnosis import near_null, redundant_joints
from eom.assembly.elastic import elastic_items
from eom.assembly.massless import FirstOrder, IndexAboveOneError
from eom.assembly.matrices import DISPLACEMENTS, VELOCITIES, Matrices, assemble_matrices, joint_rows
from eom.assembly.pivots import MANY_BODIES, choose_coordinates, complete
from eom.assembly.reduction import Pivots, Reduction
from eom.assembly.rows import row_count
from eom.assembly.statics import unbalanced
from eom.assembly.vectors import Array
from eom.errors import DescriptionError, EquilibriumError, SingularError
from eom.vehicle.elements import Connection, System, wheels_alone
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    from eom.model.symbolic import SymbolicAssembly
    from eom.splice.prepare import Prepared


class Descriptor(NamedTuple):
    """E dz/dt = A z + B u + B_rate du/dt in SI units; z = (q, n), displacements in inertial, velocities in body axes.

    Rows: dq/dt [m/s, rad/s], then forces and moments on the motions n [N, N m].
    """

    E: Array
    A: Array
    B: Array
    B_rate: Array


def descriptor_of(matrices: Matrices) -> Descriptor:
    """The full equations projected onto the motions that the constraints allow."""
    T, W, Z, at = (getattr(matrices.reduction, name) for name in ("T", "W", "Z", "independent"))
    M, C, K, V = matrices.M, matrices.C, matrices.K, matrices.V
    n_q, n_n = T.shape[1], W.shape[1]
    E = np.block([[np.eye(n_q), np.zeros((n_q, n_n))], [W.T @ (M @ Z), W.T @ (M @ W)]])
    A = np.block([[(Z - V @ T)[at], W[at]], [-W.T @ (K @ T + C @ Z), -W.T @ (C @ W)]])
    B, B_rate = (np.vstack([np.zeros((n_q, F.shape[1])), W.T @ F]) for F in (matrices.F, matrices.G))
    return Descriptor(E, A, B, B_rate)


@dataclass(frozen=True)
class Assembly:
    """Matrices of the equations of motion with the names of their rows and columns.

    Attributes
    ----------
    vehicle : Vehicle
    matrices : Matrices
        All of them, statics included; the most used are attributes here too.
    pivots : Pivots
        Which coordinates are dependent, which have no mass, which change nothing.
    form : FirstOrder
        The first-order form of the equations.
    system : System
        The elements that were assembled: the vehicle's; wheels with the slopes of their tyres at the trim.
    prepared : Prepared or None
        Of a vehicle with wheels, the numbers of its nonlinear equations and its trim.
    """

    vehicle: Vehicle
    matrices: Matrices
    pivots: Pivots
    form: FirstOrder
    system: System
    prepared: "Prepared | None" = None

    @property
    def M(self) -> Array:
        """Mass matrix (N, N) over `velocities` [kg, kg m^2]."""
        return self.matrices.M

    @property
    def C(self) -> Array:
        """What multiplies body-axis velocities w: momentum, dampers, slip, (N, N)."""
        return self.matrices.C

    @property
    def K(self) -> Array:
        """What multiplies displacements p: elastic, tangent, load, moving-damper and camber stiffness, (N, N)."""
        return self.matrices.K

    @property
    def V(self) -> Array:
        """Kinematic matrix (N, N) of dp/dt + V p - w = 0."""
        return self.matrices.V

    @property
    def J(self) -> Array:
        """Holonomic constraint rows over `coordinates`; labelled by `constraint_rows`."""
        return self.matrices.J

    @property
    def Jn(self) -> Array:
        """Nonholonomic constraint rows over `velocities`; labelled by `rolling_rows`."""
        return self.matrices.Jn

    @property
    def H_slip(self) -> Array:
        """Slip rows (tyres, slip dampers) over `velocities`; labelled by `slip_rows`."""
        return self.matrices.H_slip

    @property
    def D_slip(self) -> Array:
        """Slip coefficients: force is minus D_slip times slip velocity."""
        return self.matrices.D_slip

    @property
    def reduction(self) -> Reduction:
        """Displacements and velocities by independent ones."""
        return self.matrices.reduction

    @property
    def R(self) -> Array:
        """Right complement, (2 N, states): (p, w) = R (q, n) satisfies every constraint."""
        T, W, Z = self.reduction.T, self.reduction.W, self.reduction.Z
        return np.block([[T, np.zeros_like(W)], [Z, W]])

    @property
    def L(self) -> Array:
        """Left complement, (2 N, states): its transpose picks dq/dt and removes the reactions."""
        W, chosen = self.reduction.W, np.zeros_like(self.reduction.T)
        chosen[self.reduction.independent, np.arange(chosen.shape[1])] = 1.0
        return np.block(
            [[chosen, np.zeros_like(W)], [np.zeros_like(chosen), W]],
        )

    @property
    def descriptor(self) -> Descriptor:
        """E dz/dt = A z + B u + B_rate du/dt with z = (q, n): the projections of the full equations by L and R."""
        return descriptor_of(self.matrices)

    @property
    def independent(self) -> tuple[str, ...]:
        """Names of z = (q, n), the descriptor's columns: independent displacements, then independent velocities."""
        displacements = [self.coordinates[k] for k in self.reduction.independent]
        return (*displacements, *(self.velocities[k] for k in self.reduction.independent_velocities))

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the displacements p: ``body.x`` to ``body.yaw``."""
        return tuple(f"{body.name}.{name}" for body in self.system.bodies for name in DISPLACEMENTS)

    @property
    def velocities(self) -> tuple[str, ...]:
        """Names of the body-axis velocities w: ``body.v_x`` to ``body.yaw_rate``."""
        return tuple(f"{body.name}.{name}" for body in self.system.bodies for name in VELOCITIES)

    @property
    def constraint_rows(self) -> tuple[str, ...]:
        """Names of the rows of J: ``joint[k]``."""
        return self.row_names([item.connection for item in self.system.constraints])

    @property
    def rolling_rows(self) -> tuple[str, ...]:
        """Names of the rows of Jn."""
        return self.row_names(list(self.system.rolling))

    @property
    def elastic_rows(self) -> tuple[str, ...]:
        """Names of the elastic rows H: springs and points, bushings, beams, membranes."""
        return numbered([(item.name, len(item.rows)) for item in elastic_items(self.system)])

    @property
    def slip_rows(self) -> tuple[str, ...]:
        """Names of the slip rows."""
        return self.row_names([item.connection for item in self.system.slip])

    def row_names(self, connections: list[Connection]) -> tuple[str, ...]:
        """One name per row: the connection's, numbered where it has several rows."""
        return numbered([(item.name, row_count(item)) for item in connections])


def numbered(counts: list[tuple[str, int]]) -> tuple[str, ...]:
    """Each name as often as it has rows, numbered where it has several."""
    result: list[str] = []
    for name, count in counts:
        result += [name] if count == 1 else [f"{name}[{k}]" for k in range(count)]
    return tuple(result)


@overload
def assemble(vehicle: Vehicle) -> Assembly: ...


@overload
def assemble(vehicle: Vehicle, *, symbols: Sequence[str] | str) -> "SymbolicAssembly": ...


def assemble(vehicle: Vehicle, *, symbols: Sequence[str] | str | None = None) -> "Assembly | SymbolicAssembly":
    """Assemble a vehicle's matrices about its trim, as numbers or in symbols.

    Parameters
    ----------
    vehicle : Vehicle
    symbols : sequence of str, or "all"
        Parameters that shall stand as symbols in the matrices; ``"all"`` takes every one that is a number and not
        zero.

    Raises
    ------
    DescriptionError
        If its numbers describe something that cannot be: an impossible inertia, a trim that violates a joint; or if
        there is no parameter of a symbol's name.
    EquilibriumError
        If the loads at the trim do not balance; names body and component.
    SingularError
        If nothing determines a motion.
    """
    if symbols is not None:
        from eom.model.symbolic import assemble_symbols  # noqa: PLC0415  sympy is slow to import

        return assemble_symbols(vehicle, symbols)
    system, prepared = vehicle.system, None
    findings = check_system(system)
    if findings:
        raise DescriptionError([vehicle.mistake(name, what) for name, what in findings])
    if wheels_alone(system):
        from eom.splice.linear_tyres import with_linear_tyres  # noqa: PLC0415  tyres take a while to import

        prepared = prepared_for(vehicle)
        system = with_linear_tyres(system, prepared)
    algebra = algebra_for(len(system.bodies))
    try:
        pivots = choose_coordinates(system, algebra)
        matrices = assemble_matrices(system, pivots, algebra)
    except ValueError as error:
        raise SingularError(f"{vehicle.file}: {nearly_redundant(vehicle) or error}") from None
    check_equilibrium(vehicle, matrices)
    try:
        return Assembly(vehicle, matrices, *complete(system, matrices, pivots), system, prepared)
    except IndexAboveOneError as error:
        velocity = int(matrices.reduction.independent_velocities[error.velocity])
        body = system.bodies[velocity // 6].name
        what = (
            f"nothing determines the motion {body}.{VELOCITIES[velocity % 6]}: give the body mass or "
            "inertia, or hold it by a spring or damper of its own"
        )
        raise SingularError(str(vehicle.mistake(body, what))) from None
    except ValueError as error:
        raise SingularError(f"{vehicle.file}: {error}: its masses or dampers differ too much in size") from None


def prepared_for(vehicle: Vehicle) -> "Prepared":
    """The numbers of the nonlinear equations of a vehicle with wheels.

    Raises
    ------
    DescriptionError
        If it describes what those equations do not know.
    EquilibriumError
        If its straight run cannot be held, or a wheel carries nothing.
    SingularError
        If a motion has no mass, or joints repeat each other.
    """
    from eom.splice.checks import SpliceError  # noqa: PLC0415  tyres take a while to import
    from eom.splice.laws import LawError  # noqa: PLC0415
    from eom.splice.prepare import prepare  # noqa: PLC0415
    from eom.splice.trim import TrimError  # noqa: PLC0415

    try:
        return prepare(vehicle.system, vehicle.speed)
    except SpliceError as error:
        raise DescriptionError([vehicle.mistake(owner, what) for owner, what in error.findings]) from None
    except TrimError as error:
        raise EquilibriumError(str(vehicle.mistake(error.owner, str(error)))) from None
    except LawError as error:
        raise DescriptionError([vehicle.mistake(error.owner, what) for what in str(error).splitlines()]) from None
    except ValueError as error:
        raise SingularError(f"{vehicle.file}: {nearly_redundant(vehicle) or error}") from None


def algebra_for(bodies: int) -> Algebra:
    """Dense matrices for few bodies, sparse ones for many."""
    if bodies <= MANY_BODIES:
        return DENSE
    from eom.assembly.sparse import SPARSE  # noqa: PLC0415  slow to import, for many bodies alone

    return SPARSE


def nearly_redundant(vehicle: Vehicle) -> str:
    """The sentence for joints that all but lock the same motion twice, empty if there are none."""
    system = vehicle.system
    J, _ = joint_rows(system)
    # for many joints the search takes minutes
    names = redundant_joints(system, near_null(J, NEARLY)) if J.size <= SEARCHED else ""
    return names and f"joints all but lock the same motion twice ({names}): let one carry less, or move them apart"


NEARLY, SEARCHED = 1e-5, 4_000_000
FORCES = (
    "force along x",
    "force along y",
    "force along z",
    "moment about x",
    "moment about y",
    "moment about z",
)


def check_equilibrium(vehicle: Vehicle, matrices: Matrices) -> None:
    """Raise `EquilibriumError` if anything remains unbalanced, the three largest components named."""
    statics = matrices.statics
    worst = unbalanced(vehicle.system.bodies, statics)
    if worst.size == 0:
        return
    lines = []
    for index in worst[:3]:
        body, component = vehicle.system.bodies[int(index) // 6].name, FORCES[int(index) % 6]
        unit = "N" if index % 6 < 3 else "N m"
        what = (
            f"not in equilibrium: a {component} of {statics.residual[index]:.6g} {unit} remains on {body}; "
            "add what carries it, or a load that balances it"
        )
        lines.append(str(vehicle.mistake(body, what)))
    raise EquilibriumError("\n".join(lines))
