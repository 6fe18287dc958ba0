"""A draft: a `System` under construction, whose numbers are still expressions of live parameters."""

from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import cast

from eom.vehicle.elements import (
    GROUND,
    Beam,
    Body,
    Bushing,
    Connection,
    Constraint,
    Drag,
    Drive,
    Elastic,
    Input,
    Load,
    Output,
    Slip,
    System,
    Triangle,
    TyreLaw,
    Unit,
    Vector,
    Wheel,
)
from eom.vehicle.expression import Expression, Number
from eom.vehicle.registry import Registry
from eom.vehicle.source import Path
from eom.vehicle.validate import did_you_mean

ZERO = cast("float", Number(0.0))
ONE = cast("float", Number(1.0))
ORIGIN: Vector = (ZERO, ZERO, ZERO)
X: Vector = (ONE, ZERO, ZERO)
Y: Vector = (ZERO, ONE, ZERO)
Z: Vector = (ZERO, ZERO, ONE)
NO_DRIVE = Drive(ZERO, ZERO, ())
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
    wheels : dict
        Name of every connector of type ``tyre`` to its body and the expression of its radius [m], None where it has
        none.
    patches : set
        Numbers of the contact patches of tyres with a relaxation length.
    contacts : list
        Wheels of axles.
    laws : dict
        Law of every tyre by its name; ``used`` names those that wheels have, in order.
    rich : bool
        Whether the axles' tyres are wheels alone, and no linear slip.
    driven : int
        Number of driven axles.
    folder : Path
        Where the names of files start from.
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
    bushings: list[Bushing] = field(default_factory=list)
    beams: list[Beam] = field(default_factory=list)
    triangles: list[Triangle] = field(default_factory=list)
    gravity: Vector = ORIGIN
    names: dict[str, Path] = field(default_factory=dict)
    index: dict[str, int] = field(default_factory=lambda: {"ground": GROUND})
    units: list[UnitDraft] = field(default_factory=list)
    axles: dict[str, str] = field(default_factory=dict)
    supports: dict[str, tuple[str, ...]] = field(default_factory=dict)
    couplings: dict[str, tuple[str, str]] = field(default_factory=dict)
    zeros: list[tuple[Expression, Path, str]] = field(default_factory=list)
    wheels: dict[str, tuple[int, float | None]] = field(default_factory=dict)
    patches: set[int] = field(default_factory=set)
    contacts: list[Wheel] = field(default_factory=list)
    laws: dict[str, TyreLaw] = field(default_factory=dict)
    used: list[str] = field(default_factory=list)
    drags: list[Drag] = field(default_factory=list)
    drive: Drive = NO_DRIVE
    rich: bool = False
    driven: int = 0
    folder: FilePath = FilePath()

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
            tuple(self.bushings),
            tuple(self.beams),
            tuple(self.triangles),
            tuple(self.contacts),
            tuple(self.laws[name] for name in self.used),
            tuple(self.drags),
            self.drive,
            tuple(Unit(unit.name, tuple(unit.bodies.values()), self.coupling_of(unit.name)) for unit in self.units),
        )

    def coupling_of(self, towed: str) -> str:
        """Name of the coupling of a unit to the one ahead of it, empty for the first one."""
        return next((name for name, (_, unit) in self.couplings.items() if unit == towed), "")

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
        if not self.registry.excuses(name):
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


@dataclass(frozen=True)
class Site:
    """Where a connector stands: in a unit's frame with its bodies, or in the whole."""

    origin: Vector = ORIGIN
    bodies: dict[str, int] | None = None
    scope: Scope | None = None


CARRIED_AXES = {"x": X, "y": Y, "z": Z, "roll": X, "pitch": Y, "yaw": Z}


def carried_directions(carries: tuple[str, ...], names: tuple[str, str, str]) -> tuple[int, Vector]:
    """Number and axis of the directions among *names* that are carried: two act normal to the third."""
    carried = [name for name in names if name in carries]
    left = [name for name in names if name not in carries]
    axis = carried[0] if len(carried) == 1 else left[0] if len(carried) == 2 else names[2]
    return len(carried), CARRIED_AXES[axis]
