"""What a file says of all its wheels: whether they are rich, how they are driven and braked, the road's grade."""

from collections.abc import Iterable

from eom.vehicle.description import Description
from eom.vehicle.draft import ORIGIN, ZERO, Draft, Scope
from eom.vehicle.elements import Drive, Load
from eom.vehicle.quantity import Quantity
from eom.vehicle.source import Path
from eom.vehicle.train import Unit
from eom.vehicle.whole_axle import WholeAxle, whole_axle

TORQUE = "drive_torque"


def count_wheels(draft: Draft, description: Description, units: Iterable[tuple[Unit, Scope]]) -> None:
    """Find whether any axle or its tyre asks for wheels of their own, and how many axles are driven."""
    for unit, scope in units:
        for key in unit.axles:
            axle = whole_axle(unit.axles, key)
            if not isinstance(axle, WholeAxle):
                continue
            tyre = description.tyres.get(getattr(scope.get(axle.tyre), "name", axle.tyre))
            track = axle.group in unit.axle_groups and unit.axle_groups[axle.group or ""].track is not None
            draft.rich = draft.rich or axle.rich or track or (tyre is not None and tyre.rich)
            draft.driven += axle.driven


def draft_drive(draft: Draft, description: Description) -> None:
    """Add the lags of drive and brakes, and the axles whose wheels turn alike."""
    registry = draft.registry
    driven = tuple(dict.fromkeys(wheel.axle for wheel in draft.contacts if wheel.drive_share is not ZERO))
    if driven:
        draft.claim(TORQUE, ("drive",))
    drive, brakes = description.drive, description.brakes
    if drive is not None and not driven and not registry.broken:
        registry.report(("drive",), "nothing is driven: give an axle 'driven: true'")
    if brakes is not None and all(wheel.brake_gain is ZERO for wheel in draft.contacts) and not registry.broken:
        registry.report(("brakes",), "no axle has brakes: give one its 'brake_gain'")
    draft.drive = Drive(
        lag(draft, "drive", None if drive is None else drive.lag),
        lag(draft, "brakes", None if brakes is None else brakes.lag),
        driven if drive is not None and drive.differential == "locked" else (),
    )


def lag(draft: Draft, key: str, value: Quantity | None) -> float:
    """A lag of the file, zero without one."""
    if value is None:
        return ZERO
    path: Path = (key, "lag")
    return draft.registry.not_negative(draft.registry.number(value, f"{key}.lag", path), path)


def draft_grade(draft: Draft, description: Description) -> None:
    """Add the part of the weight along a road that rises: on every body with mass, backwards along its x."""
    if description.trim is None or description.trim.grade is None:
        return
    registry, path = draft.registry, ("trim", "grade")
    grade = registry.number(description.trim.grade, "trim.grade", path)
    if description.gravity is None or isinstance(description.gravity, tuple):
        registry.report(path, "a grade needs 'gravity' as one number, which acts down")
        return
    down = registry.number(description.gravity, "gravity", ("gravity",))
    for number, body in enumerate(draft.bodies):
        if body.mass is not ZERO:
            force = -(body.mass * down * grade)
            draft.loads.append(Load(f"{body.name}.grade", number, body.centre, (force, ZERO, ZERO), ORIGIN, number))
