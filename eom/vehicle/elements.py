"""The elements that every description comes down to: bodies, connections, what acts through them.

All positions are in the inertial axes at the trim (ISO 8855: x forward, y left, z up), all quantities in SI
units. A connection measures the motion of its first body relative to its second one, along its directions;
what acts through it pushes the first body along them and the second one the other way. Body ``-1`` is ground.
A draft holds expressions in place of the numbers.
"""

from typing import NamedTuple

GROUND = -1
Vector = tuple[float, float, float]
Matrix3 = tuple[Vector, Vector, Vector]


class Body(NamedTuple):
    """A rigid body in its steady motion.

    Attributes
    ----------
    name : str
    mass : float
        [kg]
    centre : Vector
        Centre of mass [m].
    inertia : Matrix3
        Inertia tensor about the centre of mass, in axes parallel to the inertial ones [kg m^2].
    velocity : Vector
        Trim velocity of the centre of mass [m/s].
    spin : Vector
        Trim angular velocity about an axis of symmetry [rad/s].
    """

    name: str
    mass: float
    centre: Vector
    inertia: Matrix3
    velocity: Vector
    spin: Vector


class Connection(NamedTuple):
    """Where and along which directions two bodies meet.

    Attributes
    ----------
    name : str
    bodies : tuple of int
        First and second body; the directions are fixed on the second one.
    places : tuple of Vector
        End points on the first and on the second body [m]; equal unless ``line``.
    forces, moments : int
        Number of directions of force and of moment, see `eom.assembly.vectors.directions`.
    force_axis, moment_axis : Vector
        The axes that these numbers refer to.
    line : bool
        True where the one force acts along the line from the first to the second place.
    rolling_axis : Vector, optional
        Spin axis of a first body that rolls: turning about it does not carry the contact point along.
    upright : Vector, optional
        Axis fixed on the second body to which the moment stays normal while it turns with the first body
        (support, fifth wheel). Without it the moment turns half with each body.
    """

    name: str
    bodies: tuple[int, int]
    places: tuple[Vector, Vector]
    forces: int = 0
    force_axis: Vector = (0.0, 0.0, 1.0)
    moments: int = 0
    moment_axis: Vector = (0.0, 0.0, 1.0)
    line: bool = False
    rolling_axis: Vector | None = None
    upright: Vector | None = None


class Constraint(NamedTuple):
    """A connection whose directions are locked; ``moving`` if relative to the frame that moves with the trim."""

    connection: Connection
    moving: bool = False


class Elastic(NamedTuple):
    """A spring, damper and inerter along each direction: (force, moment) stiffness, damping, inertance.

    They act on displacement [N/m, N m/rad], on its rate (not on body-axis velocity) and on its second rate
    [kg, kg m^2]. ``preload`` is the given tension of a single direction [N, N m]; without it statics finds it.
    """

    connection: Connection
    stiffness: tuple[float, float]
    damping: tuple[float, float]
    inertance: tuple[float, float] = (0.0, 0.0)
    preload: float | None = None


class Bushing(NamedTuple):
    """An elastic connection in all six directions with full matrices, (6, 6): three forces, then three moments.

    Rows and columns refer to two stated perpendicular axes, fixed on the second body, and the third that makes
    them right-handed.
    """

    connection: Connection
    axes: tuple[Vector, Vector]
    stiffness: tuple[tuple[float, ...], ...]
    damping: tuple[tuple[float, ...], ...]


class Beam(NamedTuple):
    """A slender prismatic beam in bending: EI in its two planes [N m^2] and mass per length [kg/m].

    ``normal`` points, across the line of ``places``, along the first plane's deflection. Stretch and twist are free.
    """

    name: str
    bodies: tuple[int, int]
    places: tuple[Vector, Vector]
    bending: tuple[float, float]
    normal: Vector
    mass_per_length: float = 0.0


class Triangle(NamedTuple):
    """A plane-stress membrane between three bodies, of a thickness [m], Young's modulus [Pa] and Poisson's ratio.

    With ``drilling`` the bodies' rotations about its normal bend its edges; without, its strain is constant.
    """

    name: str
    bodies: tuple[int, int, int]
    places: tuple[Vector, Vector, Vector]
    thickness: float
    modulus: float
    poisson: float
    drilling: bool = False


class Slip(NamedTuple):
    """A force that opposes sliding velocity in body axes: minus ``coefficients`` (square) times slip velocity.

    ``added_mass`` (square, or empty) times the slip velocity's rate is the force of fluid that is carried along.
    ``camber`` (one per direction, or empty) is camber thrust [N/rad, N m/rad]: minus it times the angle by which the
    first body is turned about ``camber_axis``, the right-hand way, relative to the second one. A ``moving`` element
    counts the velocity from that of the trim, whose own force is a load: air, not a road.
    """

    connection: Connection
    coefficients: tuple[tuple[float, ...], ...]
    added_mass: tuple[tuple[float, ...], ...] = ()
    camber: tuple[float, ...] = ()
    camber_axis: Vector = (1.0, 0.0, 0.0)
    moving: bool = False


class Load(NamedTuple):
    """A constant force [N] and moment [N m] at a place of a body; ``frame`` is the body they turn with."""

    name: str
    body: int
    place: Vector
    force: Vector
    moment: Vector
    frame: int = GROUND


class Input(NamedTuple):
    """A signal that acts through a connection: per direction ``gain`` times it plus ``rate_gain`` times its rate."""

    name: str
    unit: str
    connection: Connection
    gain: tuple[float, ...]
    rate_gain: tuple[float, ...]


class Output(NamedTuple):
    """A measured signal: a weighted sum of motions along one-directional connections.

    ``quantity`` is ``position``, ``velocity`` or ``acceleration``; ``frame`` is ``body`` (rate of change of
    body-axis components) or ``inertial``; ``feedthrough`` adds (input name, gain).
    """

    name: str
    unit: str
    quantity: str
    frame: str
    terms: tuple[tuple[float, Connection], ...]
    feedthrough: tuple[tuple[str, float], ...] = ()


class TyreLaw(NamedTuple):
    """How one wheel's tyre answers slip and load.

    Attributes
    ----------
    name : str
    kind : str
        ``linear``, ``magic_formula``, ``dugoff`` or ``tir``.
    cornering, longitudinal : float
        Stiffness of one wheel [N/rad, N]; a nonlinear law is fitted to them at the trim's load, zero where they
        follow from the law.
    camber : float
        Camber thrust of one linear wheel per angle of lean [N/rad].
    trail : float
        Pneumatic trail [m].
    relaxation : float
        Length over which side force builds up [m], zero for at once.
    rolling_resistance : float
        Resisting force per normal load.
    coefficients : tuple
        (name, value) of the law's further coefficients, SI units.
    file : str
        Of coefficients, for ``tir``.
    """

    name: str
    kind: str
    cornering: float
    longitudinal: float
    camber: float
    trail: float
    relaxation: float
    rolling_resistance: float
    coefficients: tuple[tuple[str, float], ...] = ()
    file: str = ""


class Wheel(NamedTuple):
    """A wheel on the road, or all wheels of an axle together in its middle.

    Attributes
    ----------
    name, axle : str
        ``axle_4.left`` of ``axle_4``; equal for wheels taken together.
    body : int
        The body that carries it.
    place : Vector
        Contact point at the trim [m].
    number : float
        How many wheels it stands for.
    tyre : int
        Number of its `TyreLaw`.
    mirrored : bool
        Whether the tyre stands on the other side than its coefficients are for.
    radius : float
        Rolling radius [m], zero where none is given.
    spin_inertia : float
        About the axle [kg m^2], of all it stands for; zero for a wheel whose spin is no state.
    brake_gain : float
        Brake torque per pressure [N m/Pa], of all it stands for.
    drive_share : float
        Its share of the drive torque.
    steer : str
        Name of the steer input, empty for a wheel that is not steered.
    support : str
        Name of the constraint that carries it vertically, with others; empty where ``spring`` does, or nothing.
    share : float
        Its share of that support's load.
    roll_rate : float
        Its load per angle by which its body rolls, besides [N/rad]: of the tyres' springs on its side.
    spring : str
        Name of the elastic element that its tyre is part of: without a support its own vertical spring, with one
        the roll stiffness of its group's tyres.
    """

    name: str
    axle: str
    body: int
    place: Vector
    number: float
    tyre: int
    mirrored: bool
    radius: float
    spin_inertia: float
    brake_gain: float
    drive_share: float
    steer: str
    support: str
    share: float
    roll_rate: float
    spring: str


class Drag(NamedTuple):
    """Air's resistance at a place of a body: minus ``factor`` times v_x |v_x| along the body's x [N s^2/m^2].

    At the trim it is the load, and about it the moving slip element, of the same name.
    """

    name: str
    body: int
    place: Vector
    factor: float


class Drive(NamedTuple):
    """Lags of the drive torque and of brake pressures [s], zero for none; ``locked`` names axles of equal spins."""

    drive_lag: float
    brake_lag: float
    locked: tuple[str, ...]


class Unit(NamedTuple):
    """A vehicle unit: numbers of its bodies, the first one leading; the coupling to the unit ahead, if any."""

    name: str
    bodies: tuple[int, ...]
    coupling: str


class System(NamedTuple):
    """Everything that acts, with numbers: what assembly turns into matrices."""

    bodies: tuple[Body, ...]
    gravity: Vector
    constraints: tuple[Constraint, ...]
    rolling: tuple[Connection, ...]
    elastic: tuple[Elastic, ...]
    slip: tuple[Slip, ...]
    loads: tuple[Load, ...]
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    bushings: tuple[Bushing, ...] = ()
    beams: tuple[Beam, ...] = ()
    triangles: tuple[Triangle, ...] = ()
    wheels: tuple[Wheel, ...] = ()
    tyres: tuple[TyreLaw, ...] = ()
    drags: tuple[Drag, ...] = ()
    drive: Drive = Drive(0.0, 0.0, ())
    units: tuple[Unit, ...] = ()


def wheels_alone(system: System) -> bool:
    """Whether the tyres of axles are wheels alone, and no linear slip elements."""
    slips = {item.connection.name for item in system.slip}
    return any(wheel.axle not in slips for wheel in system.wheels)
