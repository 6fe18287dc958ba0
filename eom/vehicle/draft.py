"""From a description to a draft: a `System` whose numbers are still expressions of live parameters."""

from dataclasses import dataclass, field
from typing import cast

from eom.vehicle import parts
from eom.vehicle.connectors import (
    Connector,
    FlexPoint,
    Link,
    PointConnector,
    RigidPoint,
    RollingPoint,
    SlipDamper,
    Spring,
    Support,
    TyreConnector,
)
from eom.vehicle.description import Description
from eom.vehicle.elements import (
    GROUND,
    Body,
    Connection,
    Constraint,
    Elastic,
    Input,
    Load,
    Matrix3,
    Output,
    Slip,
    System,
    Vector,
)
from eom.vehicle.expression import Expression, Number
from eom.vehicle.quantity import Quantity
from eom.vehicle.registry import Live, Registry
from eom.vehicle.source import Path
from eom.vehicle.validate import did_you_mean

ZERO = cast("float", Number(0.0))
ONE = cast("float", Number(1.0))
ORIGIN: Vector = (ZERO, ZERO, ZERO)
X: Vector = (ONE, ZERO, ZERO)
Y: Vector = (ZERO, ONE, ZERO)
Z: Vector = (ZERO, ZERO, ONE)
Scope = dict[str, Expression]


@dataclass(frozen=True)
class UnitDraft:
    """What later stages look up by role: a unit's bodies, suspensions and where they stand."""

    name: str
    bodies: dict[str, int]
    origin: Vector
    scope: Scope
    path: Path


@dataclass
class Draft:
    """A system under construction.

    Attributes
    ----------
    registry : Registry
        Live parameters and mistakes.
    speed : float
        Expression of the trim speed [m/s].
    names : dict
        Name of every object to its path in the file.
    index : dict
        Name of every body to its number.
    zeros : list
        (expression that must vanish, path, sentence if it does not).
    """

    registry: Registry
    speed: float
    bodies: list[Body] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    rolling: list[Connection] = field(default_factory=list)
    elastic: list[Elastic] = field(default_factory=list)
    slip: list[Slip] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    inputs: list[Input] = field(default_factory=list)
    outputs: list[Output] = field(default_factory=list)
    gravity: Vector = ORIGIN
    names: dict[str, Path] = field(default_factory=dict)
    index: dict[str, int] = field(default_factory=lambda: {"ground": GROUND})
    units: list[UnitDraft] = field(default_factory=list)
    axles: dict[str, str] = field(default_factory=dict)
    supports: dict[str, tuple[str, ...]] = field(default_factory=dict)
    couplings: dict[str, tuple[str, str]] = field(default_factory=dict)
    zeros: list[tuple[Expression, Path, str]] = field(default_factory=list)

    def system(self) -> System:
        """The finished draft."""
        return System(
            tuple(self.bodies),
            self.gravity,
            tuple(self.constraints),
            tuple(self.rolling),
            tuple(self.elastic),
            tuple(self.slip),
            tuple(self.loads),
            tuple(self.inputs),
            tuple(self.outputs),
        )

    def claim(self, name: str, path: Path) -> None:
        """Enter a name into the one namespace of all objects."""
        if name in self.names or name == "ground":
            where = ".".join(map(str, self.names.get(name, ("the ground",))))
            self.registry.report(path, f"the name '{name}' is taken by {where}: every object has its own name")
        self.names[name] = path

    def body(self, name: str, path: Path, bodies: dict[str, int] | None = None) -> int:
        """Number of a body, by its name in a unit or in the whole; reported if unknown."""
        for known in (bodies or {}, self.index):
            if name in known:
                return known[name]
        if name not in self.registry.broken:
            guess = did_you_mean(name, [*(bodies or {}), *self.index])
            self.registry.report(path, f"unknown body '{name}'{guess}")
        return GROUND

    def connection(
        self,
        name: str,
        bodies: tuple[int, int],
        place: Vector,
        *,
        forces: int = 0,
        force_axis: Vector = Z,
        moments: int = 0,
        moment_axis: Vector = Z,
        rolling_axis: Vector | None = None,
        upright: Vector | None = None,
    ) -> Connection:
        """A connection at one place."""
        return Connection(
            name, bodies, (place, place), forces, force_axis, moments, moment_axis, False, rolling_axis, upright
        )


def add(a: Vector, b: Vector) -> Vector:
    """Sum of two places."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def subtract(a: Vector, b: Vector) -> Vector:
    """Difference of two places."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def declare_parameters(registry: Registry, description: Description) -> None:
    """Enter the declared parameters, then check the names in their values."""
    for name, item in description.parameters.items():
        path = ("parameters", name)
        registry.parameters[name] = Live(
            item.value.expression,
            item.value.unit,
            item.description,
            path,
            item.min and item.min.expression,
            item.max and item.max.expression,
            item.value.dimension,
        )
    for name, item in description.parameters.items():
        for key in ("value", "min", "max"):
            quantity: Quantity | None = getattr(item, key)
            if quantity is None:
                continue
            path = ("parameters", name, key)
            registry.resolve(quantity, path, {})
            own = item.value.dimension
            if own is not None and quantity.dimension not in {None, own}:
                registry.report(path, "has another dimension than the value that it bounds")


def draft_body(
    draft: Draft, name: str, item: parts.Body, path: Path, origin: Vector = ORIGIN, scope: Scope | None = None
) -> None:
    """Add a body at its place in a unit's frame."""
    registry = draft.registry
    draft.claim(name, path)
    draft.index[name] = len(draft.bodies)
    velocity: Vector = (draft.speed, ZERO, ZERO)
    if item.velocity is not None:
        velocity = registry.place(item.velocity, f"{name}.velocity", (*path, "velocity"), scope)
    spin = ORIGIN
    if item.spin is not None:
        spin = registry.place(item.spin, f"{name}.spin", (*path, "spin"), scope)
    draft.bodies.append(
        Body(
            name,
            registry.number(item.mass, f"{name}.mass", (*path, "mass"), scope),
            add(origin, registry.place(item.at, f"{name}.at", (*path, "at"), scope)),
            draft_inertia(draft, name, item, (*path, "inertia"), scope),
            velocity,
            spin,
        )
    )


def draft_inertia(draft: Draft, name: str, item: parts.Body, path: Path, scope: Scope | None) -> Matrix3:
    """The tensor about the centre of mass; without an entry that of a point mass."""
    registry = draft.registry
    match item.inertia:
        case None:
            return ORIGIN, ORIGIN, ORIGIN
        case parts.InertiaTensor(tensor=tensor):
            first, second, third = (
                registry.place(row, f"{name}.inertia.{axis}", (*path, "tensor", k), scope)
                for k, (axis, row) in enumerate(zip("xyz", tensor, strict=True))
            )
            return first, second, third
        case products:
            given = {
                key: registry.number(value, f"{name}.inertia.{key}", (*path, key), scope)
                for key in ("xx", "yy", "zz", "xy", "yz", "xz")
                if (value := getattr(products, key)) is not None
            }
            minus = {key: -given[key] if key in given else ZERO for key in ("xy", "yz", "xz")}
            return (
                (given["xx"], minus["xy"], minus["xz"]),
                (minus["xy"], given["yy"], minus["yz"]),
                (minus["xz"], minus["yz"], given["zz"]),
            )


@dataclass(frozen=True)
class Site:
    """Where a connector stands: in a unit's frame with its bodies, or in the whole."""

    origin: Vector = ORIGIN
    bodies: dict[str, int] | None = None
    scope: Scope | None = None


def draft_connector(
    draft: Draft, tyres: dict[str, parts.Tyre], name: str, item: Connector, path: Path, site: Site
) -> None:
    """Add a connector of any type."""
    draft.claim(name, path)
    match item:
        case RigidPoint() | RollingPoint() | FlexPoint():
            draft_point(draft, name, item, path, site)
        case Link() | Spring():
            draft_line(draft, name, item, path, site)
        case Support():
            place = add(site.origin, draft.registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
            body = draft.body(item.body, (*path, "body"), site.bodies)
            draft_support(draft, name, body, place, item.carries)
        case SlipDamper():
            place = add(site.origin, draft.registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
            body = draft.body(item.body, (*path, "body"), site.bodies)
            axis = draft.registry.axis(item.axis, (*path, "axis"), site.scope)
            c = draft.registry.number(item.damping, f"{name}.damping", (*path, "damping"), site.scope)
            coefficients = ((c,),) if item.forces == 1 else ((c, ZERO), (ZERO, c))
            connection = draft.connection(name, (body, GROUND), place, forces=item.forces, force_axis=axis)
            draft.slip.append(Slip(connection, coefficients))
        case TyreConnector():
            place = add(site.origin, draft.registry.place(item.at, f"{name}.at", (*path, "at"), site.scope))
            body = draft.body(item.body, (*path, "body"), site.bodies)
            tyre = find_tyre(draft, tyres, item.tyre, (*path, "tyre"))
            if tyre is not None:
                draft_tyre(draft, name, (body, item.tyre, tyre), place, item.wheels, item.steered)


def draft_point(
    draft: Draft, name: str, item: RigidPoint | RollingPoint | FlexPoint, path: Path, site: Site
) -> None:
    """Add a joint, a rolling joint or a bushing."""
    registry = draft.registry
    connection = point_connection(draft, name, item, path, site)
    match item:
        case RigidPoint():
            draft.constraints.append(Constraint(connection))
        case RollingPoint():
            draft.rolling.append(connection)
        case FlexPoint():
            stiffness, damping, angular_stiffness, angular_damping = (
                ZERO
                if (value := getattr(item, key)) is None
                else registry.number(value, f"{name}.{key}", (*path, key), site.scope)
                for key in ("stiffness", "damping", "angular_stiffness", "angular_damping")
            )
            draft.elastic.append(
                Elastic(connection, (stiffness, angular_stiffness), (damping, angular_damping))
            )


def point_connection(draft: Draft, name: str, item: PointConnector, path: Path, site: Site) -> Connection:
    """The connection of a point connector, its counts and axes checked."""
    registry = draft.registry
    if item.forces == item.moments == 0:
        registry.report(path, "acts on nothing: give 'forces', 'moments' or both")
    needs_axis = {item.forces, item.moments} & {1, 2}
    if needs_axis and item.axis is None:
        registry.report(path, "needs 'axis': one direction acts along it, two act normal to it")
    axis = Z if item.axis is None else registry.axis(item.axis, (*path, "axis"), site.scope)
    rolling = getattr(item, "rolling_axis", None)
    first, second = (
        draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(item.between)
    )
    if item.between[0] == item.between[1]:
        registry.report((*path, "between"), f"connects '{item.between[0]}' with itself")
    return draft.connection(
        name,
        (first, second),
        add(site.origin, registry.place(item.at, f"{name}.at", (*path, "at"), site.scope)),
        forces=item.forces,
        force_axis=axis,
        moments=item.moments,
        moment_axis=axis,
        rolling_axis=rolling and registry.axis(rolling, (*path, "rolling_axis"), site.scope),
    )


def draft_line(draft: Draft, name: str, item: Link | Spring, path: Path, site: Site) -> None:
    """Add a rod, or a spring and damper, between two places."""
    registry = draft.registry
    first, second = (
        draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(item.between)
    )
    if item.between[0] == item.between[1]:
        registry.report((*path, "between"), f"connects '{item.between[0]}' with itself")
    start, end = (
        add(site.origin, registry.place(place, f"{name}.end_{k + 1}", (*path, "ends", k), site.scope))
        for k, place in enumerate(item.ends)
    )
    connection = Connection(name, (first, second), (start, end), forces=1, line=True)
    if isinstance(item, Link):
        draft.constraints.append(Constraint(connection))
        return
    stiffness, damping = (
        ZERO
        if (value := getattr(item, key)) is None
        else registry.number(value, f"{name}.{key}", (*path, key), site.scope)
        for key in ("stiffness", "damping")
    )
    draft.elastic.append(Elastic(connection, (stiffness, ZERO), (damping, ZERO)))


CARRIED_AXES = {"x": X, "y": Y, "z": Z, "roll": X, "pitch": Y, "yaw": Z}


def carried_directions(carries: tuple[str, ...], names: tuple[str, str, str]) -> tuple[int, Vector]:
    """Number and axis of the directions among *names* that are carried: two act normal to the third."""
    carried = [name for name in names if name in carries]
    left = [name for name in names if name not in carries]
    axis = carried[0] if len(carried) == 1 else left[0] if len(carried) == 2 else names[2]
    return len(carried), CARRIED_AXES[axis]


def draft_support(draft: Draft, name: str, body: int, place: Vector, carries: tuple[str, ...]) -> None:
    """Add a support on the ground; its moments stay normal to the vertical and turn with the body's heading."""
    forces, force_axis = carried_directions(carries, ("x", "y", "z"))
    moments, moment_axis = carried_directions(carries, ("roll", "pitch", "yaw"))
    draft.supports[name] = tuple(carries)
    draft.constraints.append(
        Constraint(
            draft.connection(
                name,
                (body, GROUND),
                place,
                forces=forces,
                force_axis=force_axis,
                moments=moments,
                moment_axis=moment_axis,
                upright=Z,
            )
        )
    )


def find_tyre(draft: Draft, tyres: dict[str, parts.Tyre], name: str, path: Path) -> parts.Tyre | None:
    """The tyre of that name; reported if there is none."""
    if name in tyres:
        return tyres[name]
    if name not in draft.registry.broken:
        draft.registry.report(path, f"unknown tyre '{name}'{did_you_mean(name, tyres)}")
    return None


def draft_tyre(
    draft: Draft, name: str, owner: tuple[int, str, parts.Tyre], place: Vector, wheels: int, steered: bool
) -> None:
    """Add the side force of wheels, their aligning moment if the tyre has a trail, and their steer input.

    F_y = -C (v_y/U - steer) at the contact point; M_z = -trail F_y.
    """
    body, tyre_name, tyre = owner
    registry = draft.registry
    path = ("tyres", tyre_name)
    cornering = registry.number(tyre.cornering, f"{tyre_name}.cornering", (*path, "cornering"))
    count = wheels if tyre.per == "wheel" else wheels / 2
    C = cast("float", Number(float(count))) * cornering
    trail = None if tyre.trail is None else registry.number(tyre.trail, f"{tyre_name}.trail", (*path, "trail"))
    connection = draft.connection(
        name, (body, GROUND), place, forces=1, force_axis=Y, moments=0 if trail is None else 1
    )
    per_slip = C / draft.speed
    if trail is None:
        coefficients: tuple[tuple[float, ...], ...] = ((per_slip,),)
        gain: tuple[float, ...] = (C,)
    else:
        coefficients, gain = ((per_slip, ZERO), (-(trail * per_slip), ZERO)), (C, -(trail * C))
    draft.slip.append(Slip(connection, coefficients))
    if steered:
        draft.inputs.append(Input(f"{name}.steer", "rad", connection, gain, tuple(ZERO for _ in gain)))


def draft_load(draft: Draft, name: str, item: parts.Load, path: Path) -> None:
    """Add an applied load."""
    registry = draft.registry
    draft.claim(name, path)
    body = draft.body(item.body, (*path, "body"))
    if body == GROUND:
        if item.body == "ground":
            registry.report((*path, "body"), "a load acts on a body, not on the ground")
        return
    draft.loads.append(
        Load(
            name,
            body,
            draft.bodies[body].centre
            if item.at is None
            else registry.place(item.at, f"{name}.at", (*path, "at")),
            ORIGIN
            if item.force is None
            else registry.place(item.force, f"{name}.force", (*path, "force")),
            ORIGIN
            if item.moment is None
            else registry.place(item.moment, f"{name}.moment", (*path, "moment")),
            draft.body(item.frame, (*path, "frame")),
        )
    )
