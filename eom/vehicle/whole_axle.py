"""An axle with all its keys, those included that it takes from another axle of its unit."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from eom.vehicle.axles import AnyAxle, AxleLike
from eom.vehicle.quantity import Quantity
from eom.vehicle.source import Path
from eom.vehicle.validate import did_you_mean


class WholeAxle(NamedTuple):
    """An axle's keys, and ``home``: which axle of the unit gives each of them."""

    x: Quantity
    tyre: str
    group: str | None
    bodies: tuple[str, str] | None
    steered: bool
    driven: bool
    radius: Quantity | None
    spin_inertia: Quantity | None
    brake_gain: Quantity | None
    track: Quantity | None
    home: Mapping[str, str]

    @property
    def rich(self) -> bool:
        """Whether it has what only wheels of their own can show."""
        told = (self.bodies, self.radius, self.spin_inertia, self.brake_gain, self.track)
        return self.driven or any(value is not None for value in told)


class WrongAxle(NamedTuple):
    """What is wrong with an axle, at a path in its unit; ``missing`` is the name that is not there, if that is it."""

    path: Path
    what: str
    missing: str = ""


def whole_axle(axles: Mapping[str, AnyAxle], key: str) -> WholeAxle | WrongAxle:
    """An axle of a unit with all its keys, or what is wrong with its ``like``."""
    axle = axles[key]
    chosen = {key: axle}
    if isinstance(axle, AxleLike):
        other, path = axles.get(axle.like), ("axles", key, "like")
        if other is None:
            what = f"unknown axle '{axle.like}'{did_you_mean(axle.like, axles)}"
            return WrongAxle(path, what, axle.like)
        if isinstance(other, AxleLike):
            return WrongAxle(path, f"'{axle.like}' is itself like another axle: name one that has its own keys")
        chosen[axle.like] = other
    found: dict[str, Any] = {}
    home: dict[str, str] = {}
    for owner, item in chosen.items():
        given = item.model_fields_set - {"like"} - found.keys()
        # what stands on a group of its own does not stand on the other's bodies
        given -= {"group", "bodies"} if {"group", "bodies"} & found.keys() else set()
        found |= {field: getattr(item, field) for field in given}
        home |= dict.fromkeys(given, owner)
    every: dict[str, Any] = dict.fromkeys(WholeAxle._fields) | {"steered": False, "driven": False}
    return WholeAxle(**{**every, **found, "home": home})
