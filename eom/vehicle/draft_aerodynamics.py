"""Aerodynamic connectors into a draft: slip elements, the loads of drag, deflections as inputs."""

from typing import cast

from eom.vehicle.aerodynamics import Aero, ControlSurface, Drag, Flow, Wing
from eom.vehicle.draft import ORIGIN, ZERO, Draft, Site, X
from eom.vehicle.draft_springs import Rows, matrix, number
from eom.vehicle.elements import GROUND, Input, Load, Slip, Vector
from eom.vehicle.elements import Drag as DragElement
from eom.vehicle.expression import Number
from eom.vehicle.parts import Strict
from eom.vehicle.quantity import Quantity
from eom.vehicle.source import Path

HALF, TWO = cast("float", Number(0.5)), cast("float", Number(2.0))
AIR = Quantity(Number(1.2), "kg/m^3")
LETTERS = {"x": 0, "y": 1, "z": 2, "l": 3, "m": 4, "n": 5, "u": 0, "v": 1, "w": 2, "p": 3, "q": 4, "r": 5}
Where = tuple[int, Vector, Path, Site]


def draft_aerodynamics(draft: Draft, name: str, item: Aero | Wing | ControlSurface, where: Where) -> None:
    """Add derivatives, a wing or a control surface; *where* is its body, place, path and site."""
    body, place, path, site = where
    connection = draft.connection(name, (body, GROUND), place, forces=3, moments=3)
    match item:
        case Aero():
            damping = matrix(draft.registry, item.damping, f"{name}.damping", (*path, "damping"), site)
            added = (
                ()
                if item.added_mass is None
                else matrix(draft.registry, item.added_mass, f"{name}.added_mass", (*path, "added_mass"), site)
            )
            draft.slip.append(Slip(connection, damping, added, moving=True))
        case Wing():
            draft.slip.append(Slip(connection, wing_damping(draft, name, item, path, site), moving=True))
        case ControlSurface():
            gain = deflection_gain(draft, name, item, path, site)
            draft.inputs.append(Input(f"{name}.deflection", "rad", connection, gain, (ZERO,) * 6))


def draft_drag(draft: Draft, name: str, item: Drag, where: Where) -> None:
    """Add air's resistance: the load at the trim, which turns with the body, and its slope by speed."""
    body, place, path, site = where
    registry = draft.registry
    area, coefficient, density = (
        registry.not_negative(registry.number(value, f"{name}.{key}", (*path, key), site.scope), (*path, key))
        for key, value in (("area", item.area), ("coefficient", item.coefficient), ("density", item.density or AIR))
    )
    factor = HALF * density * area * coefficient
    draft.drags.append(DragElement(name, body, place, factor))
    force = -(factor * draft.speed * draft.speed)
    draft.loads.append(Load(name, body, place, (force, ZERO, ZERO), ORIGIN, body))
    connection = draft.connection(name, (body, GROUND), place, forces=1, force_axis=X)
    draft.slip.append(Slip(connection, ((TWO * factor * draft.speed,),), moving=True))


def stream(draft: Draft, name: str, item: Flow, path: Path, site: Site) -> tuple[float, float, float, float]:
    """Half of density times speed times area [kg/s], speed, and the lengths of span and chord."""
    area, span, chord, density = (
        draft.registry.not_negative(number(draft.registry, item, name, key, path, site), (*path, key))
        for key in ("area", "span", "chord", "density")
    )
    speed = draft.speed
    if item.speed is not None:
        given_speed = number(draft.registry, item, name, "speed", path, site)
        speed = draft.registry.not_negative(given_speed, (*path, "speed"), zero=False)
    elif not draft.registry.broken:
        draft.registry.not_negative(speed, (*path, "speed"), zero=False)
    return HALF * density * speed * area, speed, span, chord


def given(draft: Draft, name: str, item: Strict, path: Path, site: Site) -> dict[str, float]:
    """The derivatives that a part gives, by name."""
    return {
        key: number(draft.registry, item, f"{name}.derivatives", key, path, site)
        for key in type(item).model_fields
        if getattr(item, key) is not None
    }


def wing_damping(draft: Draft, name: str, item: Wing, path: Path, site: Site) -> Rows:
    """Minus the forces and moments per velocity: rates of turn count by half of chord (q) or span (p, r) over speed."""
    flow, _, span, chord = stream(draft, name, item, path, site)
    length = {"l": span, "m": chord, "n": span}
    reach = {"p": HALF * span, "q": HALF * chord, "r": HALF * span}
    rows = [[ZERO] * 6 for _ in range(6)]
    for key, value in given(draft, name, item.derivatives, (*path, "derivatives"), site).items():
        force, velocity = key.split("_")
        term = -(flow * value)
        for factor in (length.get(force), reach.get(velocity)):
            term = term if factor is None else term * factor
        rows[LETTERS[force]][LETTERS[velocity]] = term
    return tuple(map(tuple, rows))


def deflection_gain(draft: Draft, name: str, item: ControlSurface, path: Path, site: Site) -> tuple[float, ...]:
    """Forces and moments per radian of deflection."""
    flow, speed, span, chord = stream(draft, name, item, path, site)
    length = {"l": span, "m": chord, "n": span}
    gain = [ZERO] * 6
    for key, value in given(draft, name, item.derivatives, (*path, "derivatives"), site).items():
        term = flow * speed * value
        gain[LETTERS[key]] = term * length[key] if key in length else term
    return tuple(gain)
