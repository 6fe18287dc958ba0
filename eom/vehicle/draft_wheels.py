"""Wheels of axles into a draft: left and right ones, or those of an axle together in its middle."""

from dataclasses import dataclass
from typing import cast

from eom.vehicle.draft import ZERO, Draft, Scope, Y, Z, add
from eom.vehicle.draft_tyres import HALF, tyre_numbers
from eom.vehicle.elements import GROUND, Elastic, Vector, Wheel
from eom.vehicle.expression import Number
from eom.vehicle.source import Path
from eom.vehicle.train import AxleGroup
from eom.vehicle.tyres import FileLaw, Tyre
from eom.vehicle.whole_axle import WholeAxle


@dataclass(frozen=True)
class Standing:
    """An axle in its unit: its number's name, its keys, what carries it and its contact point in the middle.

    ``bodies`` are the left and the right one, equal on a group, of which ``axles`` is the number of axles; ``apart``
    tells whether any of them has a track.
    """

    name: str
    axle: WholeAxle
    unit_path: Path
    scope: Scope
    bodies: tuple[int, int]
    centre: Vector
    tyre_name: str
    tyre: Tyre
    group: AxleGroup | None = None
    group_name: str = ""
    group_path: Path = ()
    axles: int = 1
    apart: bool = False

    def path(self, key: str) -> Path:
        """Where a key of the axle stands in the file."""
        axles = (*self.unit_path, "axles")
        return (*axles, self.axle.home[key], key) if key in self.axle.home else (*axles, self.axle.home["x"])


def count_of(number: float) -> float:
    """A plain number in a draft."""
    return cast("float", Number(number))


def times(count: float, number: float) -> float:
    """A number of one wheel for several; what is not given stays nothing."""
    return number if number is ZERO or count == 1.0 else count_of(count) * number


def draft_wheels(draft: Draft, standing: Standing) -> None:
    """Add an axle's wheels: with a track a left and a right one, else one that stands for both."""
    check_wheels(draft, standing)
    numbers = {key: positive(draft, standing, key) for key in ("radius", "spin_inertia", "brake_gain")}
    half = half_track(draft, standing)
    if half is None:
        draft_wheel(draft, standing, numbers, standing.name, (standing.bodies[0], standing.centre, 2.0, ZERO))
        return
    for side, body, y in zip(("left", "right"), standing.bodies, (half, -half), strict=True):
        name = f"{standing.name}.{side}"
        draft.claim(name, standing.path("x")[:-1])
        place = add(standing.centre, (ZERO, y, ZERO))
        draft_wheel(draft, standing, numbers, name, (body, place, 1.0, y))


def positive(draft: Draft, standing: Standing, key: str) -> float:
    """A number of one wheel, more than zero (brakes may do nothing); zero where it is not given."""
    value = getattr(standing.axle, key)
    if value is None:
        return ZERO
    path = standing.path(key)
    number = draft.registry.number(value, f"{standing.name}.{key}", path, standing.scope)
    return draft.registry.not_negative(number, path, zero=key == "brake_gain")


def half_track(draft: Draft, standing: Standing) -> float | None:
    """Half of the track of the axle, or of its group; None for wheels together in the middle."""
    if standing.axle.track is not None:
        return HALF * positive(draft, standing, "track")
    if standing.group is None or standing.group.track is None:
        return None
    path = (*standing.group_path, "track")
    track = draft.registry.number(standing.group.track, f"{standing.group_name}.track", path, standing.scope)
    return HALF * draft.registry.not_negative(track, path, zero=False)


def draft_wheel(
    draft: Draft, standing: Standing, numbers: dict[str, float], name: str, where: tuple[int, Vector, float, float]
) -> None:
    """Add one wheel; *where* is its body, place, how many it stands for, and its y from the middle (zero for both)."""
    body, place, count, y = where
    axle, group = standing.axle, standing.group
    support = standing.group_name if group is not None and group.support is not None else ""
    spring = draft_vertical(draft, standing, name, where)
    roll_rate = ZERO
    if y is not ZERO and group is not None and group.roll_stiffness is not None:
        # of a moment -K_t roll each axle has its part, and of this each side one half, by its lever y
        path = (*standing.group_path, "roll_stiffness")
        stiffness = draft.registry.number(
            group.roll_stiffness, f"{standing.group_name}.roll_stiffness", path, standing.scope
        )
        roll_rate = -(stiffness / (count_of(2.0 * standing.axles) * y))
        spring = f"{standing.group_name}.tyres"
    if standing.tyre_name not in draft.used:
        draft.used.append(standing.tyre_name)
    draft.contacts.append(
        Wheel(
            name,
            standing.name,
            body,
            place,
            count_of(count),
            draft.used.index(standing.tyre_name),
            name.endswith(".right"),
            numbers["radius"],
            times(count, numbers["spin_inertia"]),
            times(count, numbers["brake_gain"]),
            count_of(count / (2.0 * draft.driven)) if axle.driven else ZERO,
            f"{standing.name}.steer" if axle.steered else "",
            support,
            count_of(count / (2.0 * standing.axles)) if support else ZERO,
            roll_rate,
            spring,
        )
    )


def draft_vertical(draft: Draft, standing: Standing, name: str, where: tuple[int, Vector, float, float]) -> str:
    """Add the vertical spring and damper of a wheel's tyre, if it has them; the element's name or an empty one."""
    body, place, count, _ = where
    numbers = tyre_numbers(draft, standing.tyre_name, standing.tyre)
    if numbers.vertical_stiffness is None and numbers.vertical_damping is None:
        return ""
    vertical = f"{name}.vertical"
    if not draft.rich:
        # the tyre's linear forces have made it
        return vertical
    wheels = count_of(count if standing.tyre.per == "wheel" else count / 2.0)
    k, c = (
        ZERO if value is None else wheels * value for value in (numbers.vertical_stiffness, numbers.vertical_damping)
    )
    connection = draft.connection(vertical, (body, GROUND), place, forces=1, force_axis=Z, rolling_axis=Y)
    draft.elastic.append(Elastic(connection, (k, ZERO), (c, ZERO)))
    return vertical


def check_wheels(draft: Draft, standing: Standing) -> None:
    """Report what the wheels of a rich file lack."""
    if not draft.rich:
        return
    axle, tyre, report = standing.axle, standing.tyre, draft.registry.report
    who = f"the tyre '{standing.tyre_name}'"
    if axle.radius is None:
        for key in ("spin_inertia", "brake_gain", "driven"):
            if getattr(axle, key):
                report(standing.path(key), f"'{key}' on a tyre without a rolling radius: give the axle a 'radius'")
        if tyre.rolling_resistance is not None:
            what = f"{who} has rolling resistance, but no rolling radius: give the axle a 'radius'"
            report(standing.path("tyre"), what)
    from_file = isinstance(tyre.nonlinear, FileLaw)
    if axle.spin_inertia is not None and tyre.longitudinal is None and not from_file:
        what = f"a wheel that spins needs longitudinal slip: give the tyre '{standing.tyre_name}' its 'longitudinal'"
        report(standing.path("spin_inertia"), what)
    if axle.spin_inertia is None and tyre.longitudinal is not None:
        what = f"{who} has longitudinal slip, which needs a wheel that spins: give the axle a 'spin_inertia'"
        report(standing.path("tyre"), what)
    supported = standing.group is not None and standing.group.support is not None
    if tyre.rich and not supported and tyre.vertical_stiffness is None:
        what = f"the load of {who} is not known: give its group a 'support', or the tyre its 'vertical_stiffness'"
        report(standing.path("tyre"), what)
    check_track(draft, standing)
    if tyre.cornering is not None and tyre.nonlinear is None:
        cornering = tyre_numbers(draft, standing.tyre_name, tyre).cornering
        draft.registry.not_negative(cast("float", cornering), ("tyres", standing.tyre_name, "cornering"))


def check_track(draft: Draft, standing: Standing) -> None:
    """Report wheels that need a track, and springs that act twice between left and right."""
    axle, group, report = standing.axle, standing.group, draft.registry.report
    if axle.bodies is not None and axle.track is None:
        report(standing.path("bodies"), "wheels on two bodies need a 'track'")
    if group is not None and group.roll_stiffness is not None:
        track = axle.track if axle.track is not None else group.track
        if track is None and standing.apart:
            what = "needs a 'track' as the other axles of its group have: their 'roll_stiffness' acts left and right"
            report(standing.path("group"), what)
        if track is not None and standing.tyre.vertical_stiffness is not None:
            what = (
                f"the tyre '{standing.tyre_name}' carries vertically left and right, and so does the "
                "'roll_stiffness' of its group: keep one"
            )
            report(standing.path("tyre"), what)
