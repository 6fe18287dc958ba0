"""Planar mechanisms in the x-z plane or the y-z plane, written as vehicle files."""

import json
from collections.abc import Mapping
from typing import Any

import eom

Point = tuple[float, float]


def hinge(first: str, second: str, place: list[float], axis: list[float]) -> dict[str, Any]:
    return {
        "type": "rigid_point",
        "between": [first, second],
        "at": place,
        "forces": 3,
        "moments": 2,
        "axis": axis,
    }


def file(name: str, **sections: Mapping[str, Any]) -> eom.Vehicle:
    return eom.loads(json.dumps({"name": name, **sections}))


def xz(point: Point) -> list[float]:
    return [point[0], 0.0, point[1]]


def four_bar(A: Point, B: Point, C: Point, D: Point) -> eom.Vehicle:
    """Crank A-B, coupler B-C, rocker C-D in the x-z plane; A and D on the ground."""
    y = [0.0, 1.0, 0.0]
    return file(
        "four bar",
        bodies={name: {"mass": 1.0, "at": xz(at)} for name, at in (("crank", B), ("coupler", C), ("rocker", D))},
        connectors={
            "a": hinge("crank", "ground", xz(A), y),
            "b": hinge("coupler", "crank", xz(B), y),
            "c": hinge("rocker", "coupler", xz(C), y),
            "d": hinge("rocker", "ground", xz(D), y),
        },
        actuators={"motor": {"body": "crank", "at": xz(A), "about": y}},
        sensors={"rocker_turn": {"body": "rocker", "about": y, "measure": "position"}},
    )


def slider_crank(crank: float, rod: float, angle: tuple[float, float]) -> eom.Vehicle:
    """Crank pin at (x, z) *angle*, slider along x."""
    x, z = angle
    pin, slider = [x, 0.0, z], [x + (rod**2 - z**2) ** 0.5, 0.0, 0.0]
    y = [0.0, 1.0, 0.0]
    guide = {"type": "rigid_point", "between": ["slider", "ground"], "at": slider, "forces": 2, "moments": 3}
    return file(
        f"slider crank {crank}",
        bodies={name: {"mass": 1.0, "at": at} for name, at in (("crank", pin), ("rod", pin), ("slider", slider))},
        connectors={
            "main": hinge("crank", "ground", [0.0, 0.0, 0.0], y),
            "pin": hinge("rod", "crank", pin, y),
            "wrist": hinge("rod", "slider", slider, y),
            "guide": {**guide, "axis": [1.0, 0.0, 0.0]},
        },
        actuators={"motor": {"body": "crank", "at": [0.0, 0.0, 0.0], "about": y}},
        sensors={"stroke": {"body": "slider", "along": [1.0, 0.0, 0.0], "measure": "position"}},
    )


RADIUS, HALF_TRACK = 0.3, 0.8


def wheel_parts(upright: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """A left wheel on an upright, and the actuator that lifts its contact point."""
    at = [0.0, HALF_TRACK, 0.0]
    tyre = {"type": "tyre", "body": upright, "at": at, "tyre": "tyre", "wheels": 1, "radius": RADIUS, "mirror": True}
    return {"left_tyre": tyre}, {"left_lift": {"body": upright, "at": at, "along": [0.0, 0.0, 1.0], "mirror": True}}


def car(bodies: Mapping[str, list[float]], connectors: Mapping[str, Any], upright: str) -> eom.Vehicle:
    """A planar suspension and its mirror image on a chassis."""
    tyre, lift = wheel_parts(upright)
    mirrored = {name: {**item, "mirror": True} for name, item in connectors.items()}
    return file(
        "planar suspension",
        trim={"speed": 10.0},
        tyres={"tyre": {"per": "wheel", "cornering": 1e4}},
        bodies={
            "chassis": {"mass": 1.0, "at": [0.0, 0.0, 0.5]},
            **{name: {"mass": 1.0, "at": at, "mirror": True} for name, at in bodies.items()},
        },
        connectors={**mirrored, **tyre},
        actuators=lift,
    )


def wishbones(lower: tuple[Point, Point], upper: tuple[Point, Point]) -> eom.Vehicle:
    """Double wishbones in the y-z plane, each from its inner to its outer point."""
    x = [1.0, 0.0, 0.0]
    places = {"left_lower": lower, "left_upper": upper}
    bodies = {name: [0.0, *outer] for name, (_, outer) in places.items()}
    joints = {f"{name}_inner": hinge(name, "chassis", [0.0, *inner], x) for name, (inner, _) in places.items()}
    joints |= {f"{name}_outer": hinge("left_upright", name, [0.0, *outer], x) for name, (_, outer) in places.items()}
    return car({**bodies, "left_upright": [0.0, 0.75, 0.3]}, joints, "left_upright")


def strut(inner: Point, outer: Point, top: Point) -> eom.Vehicle:
    """A strut whose axis leads from the arm's outer point to the top mount, in the y-z plane."""
    x, axis = [1.0, 0.0, 0.0], [0.0, top[0] - outer[0], top[1] - outer[1]]
    slide = {"type": "rigid_point", "between": ["left_upright", "left_rod"], "at": [0.0, *outer], "forces": 2}
    return car(
        {"left_arm": [0.0, *outer], "left_rod": [0.0, *top], "left_upright": [0.0, 0.7, 0.3]},
        {
            "left_inner": hinge("left_arm", "chassis", [0.0, *inner], x),
            "left_outer": hinge("left_upright", "left_arm", [0.0, *outer], x),
            "left_slide": {**slide, "moments": 3, "axis": axis},
            "left_top": hinge("left_rod", "chassis", [0.0, *top], x),
        },
        "left_upright",
    )
