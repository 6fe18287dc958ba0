"""Tyres into a draft: side force, longitudinal force, vertical spring, relaxation, steer input."""

from typing import NamedTuple, cast

from eom.vehicle.draft import ORIGIN, ZERO, Draft, X, Y, Z
from eom.vehicle.elements import GROUND, Body, Constraint, Elastic, Input, Slip, Vector
from eom.vehicle.expression import Number
from eom.vehicle.source import Path
from eom.vehicle.tyres import Tyre
from eom.vehicle.validate import did_you_mean

HALF = cast("float", Number(0.5))


def find_tyre(draft: Draft, tyres: dict[str, Tyre], name: str, path: Path) -> Tyre | None:
    """The tyre of that name; reported if there is none."""
    if name in tyres:
        return tyres[name]
    if not draft.registry.excuses(name):
        draft.registry.report(path, f"unknown tyre '{name}'{did_you_mean(name, tyres)}")
    return None


class TyreNumbers(NamedTuple):
    """A tyre's live numbers; None for what it does not have."""

    cornering: float | None
    camber: float | None
    trail: float | None
    relaxation: float | None
    longitudinal: float | None
    vertical_stiffness: float | None
    vertical_damping: float | None
    rolling_resistance: float | None


def tyre_numbers(draft: Draft, name: str, tyre: Tyre) -> TyreNumbers:
    """The numbers of a tyre."""
    found: dict[str, float | None] = dict.fromkeys(TyreNumbers._fields)
    for key in TyreNumbers._fields:
        if (value := getattr(tyre, key)) is None:
            continue
        path = ("tyres", name, key)
        found[key] = number = draft.registry.number(value, f"{name}.{key}", path)
        if key not in {"cornering", "trail"}:
            draft.registry.not_negative(number, path, zero=key != "relaxation")
        if key == "cornering" and tyre.relaxation is not None:
            draft.registry.not_negative(number, path, zero=False)
    return TyreNumbers(**found)


def draft_tyre(
    draft: Draft,
    name: str,
    owner: tuple[int, str, Tyre],
    place: Vector,
    wheels: int,
    path: Path,
    *,
    steered: bool,
) -> None:
    """Add the forces of wheels that touch the ground at a place.

    Side force F_y = -C (v_y/U - steer) - C_camber roll, aligning moment M_z = -trail times the force of slip; with a
    relaxation length they act on a patch without mass that the wheel drags along by a spring. Longitudinal force
    F_x = -C_x v_x/U of the wheel's contact point. The vertical spring and damper act on displacement and its rate.
    """
    body, tyre_name, tyre = owner
    numbers = tyre_numbers(draft, tyre_name, tyre)
    count = cast("float", Number(float(wheels if tyre.per == "wheel" else wheels / 2)))
    if numbers.cornering is None:
        what = f"the tyre '{tyre_name}' has no 'cornering', which linear wheels need"
        draft.registry.report((*path, "tyre"), what)
        return
    C = count * numbers.cornering
    carrier = body
    if numbers.relaxation is not None:
        carrier = draft_patch(draft, name, body, place, C / numbers.relaxation)
    camber = None if numbers.camber is None else count * numbers.camber
    draft_side_force(draft, name, (carrier, place), (C, camber, numbers.trail), steered=steered)
    if numbers.longitudinal is not None:
        if body != GROUND and draft.bodies[body].spin == ORIGIN:
            what = f"the tyre '{tyre_name}' has longitudinal slip, which needs a wheel: give its body a 'spin'"
            draft.registry.report((*path, "tyre"), what)
        rolling = draft.connection(f"{name}.longitudinal", (body, GROUND), place, forces=1, force_axis=X)
        draft.slip.append(Slip(rolling, ((count * numbers.longitudinal / draft.speed,),)))
    if numbers.vertical_stiffness is not None or numbers.vertical_damping is not None:
        k, c = (
            ZERO if value is None else count * value for value in (numbers.vertical_stiffness, numbers.vertical_damping)
        )
        # the contact stays below the wheel however that turns about its axis
        standing = draft.connection(f"{name}.vertical", (body, GROUND), place, forces=1, force_axis=Z, rolling_axis=Y)
        draft.elastic.append(Elastic(standing, (k, ZERO), (c, ZERO)))


def draft_patch(draft: Draft, name: str, body: int, place: Vector, stiffness: float) -> int:
    """Add a contact patch that follows the wheel's heading and, by a spring, its side motion; return its number."""
    patch = len(draft.bodies)
    nothing = (ORIGIN, ORIGIN, ORIGIN)
    draft.bodies.append(Body(f"{name}.patch", ZERO, place, nothing, (draft.speed, ZERO, ZERO), ORIGIN))
    draft.index[f"{name}.patch"] = patch
    draft.patches.add(patch)
    on_road = draft.connection(
        f"{name}.patch_on_road", (patch, GROUND), place, forces=2, force_axis=Y, moments=1, moment_axis=Y
    )
    heading = draft.connection(f"{name}.patch_heading", (patch, body), place, moments=2, moment_axis=Y)
    draft.constraints += [Constraint(on_road, moving=True), Constraint(heading)]
    carcass = draft.connection(f"{name}.carcass", (patch, body), place, forces=1, force_axis=Y)
    draft.elastic.append(Elastic(carcass, (stiffness, ZERO), (ZERO, ZERO)))
    return patch


def draft_side_force(
    draft: Draft,
    name: str,
    where: tuple[int, Vector],
    numbers: tuple[float, float | None, float | None],
    *,
    steered: bool,
) -> None:
    """Add side force and aligning moment on a body at a place, and the steer input.

    *numbers* are cornering and camber stiffness of all wheels, and the trail; camber thrust has no trail.
    """
    body, place = where
    C, camber, trail = numbers
    connection = draft.connection(
        name, (body, GROUND), place, forces=1, force_axis=Y, moments=0 if trail is None else 1
    )
    per_slip = C / draft.speed
    if trail is None:
        coefficients: tuple[tuple[float, ...], ...] = ((per_slip,),)
        gain: tuple[float, ...] = (C,)
    else:
        coefficients, gain = ((per_slip, ZERO), (-(trail * per_slip), ZERO)), (C, -(trail * C))
    # its lever is not the trail: of camber thrust alone there is no aligning moment
    thrust: tuple[float, ...] = () if camber is None else (camber, *(ZERO for _ in gain[1:]))
    draft.slip.append(Slip(connection, coefficients, (), thrust))
    if steered:
        draft.inputs.append(Input(f"{name}.steer", "rad", connection, gain, tuple(ZERO for _ in gain)))
