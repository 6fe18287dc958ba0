"""Loads of the trim by role: supports, axles, couplings."""

from typing import NamedTuple

from eom.assembly.matrices import split
from eom.assembly.rows import rows
from eom.assembly.tangent import preload
from eom.assembly.vectors import Array
from eom.model.assembly import Assembly


class TrimLoads(NamedTuple):
    """Forces [N] and moments [N m] in the trim, along x, y, z.

    Attributes
    ----------
    supports : dict
        On the body by the ground, force and moment by support.
    axles : dict
        Vertical load of each axle [N] whose group has a support of its own, shared equally in the group.
    couplings : dict
        On the towed unit by the one ahead, force and moment by coupling.
    hold : float or None
        Force along x that holds the lead body's speed; None if the speed is free.
    """

    supports: dict[str, tuple[Array, Array]]
    axles: dict[str, float]
    couplings: dict[str, tuple[Array, Array]]
    hold: float | None


def joint_loads(assembly: Assembly) -> dict[str, tuple[Array, Array]]:
    """Force and moment that each joint exerts on its first body in the trim."""
    joints = [item.connection for item in assembly.system.constraints]
    counts = [len(rows(assembly.system.bodies, item)) for item in joints]
    reactions = split(assembly.matrices.statics.reactions, counts)
    return {joint.name: preload(joint, own) for joint, own in zip(joints, reactions, strict=True)}


def trim_loads(assembly: Assembly) -> TrimLoads:
    """The trim's loads, sorted by the roles that the description gives."""
    draft, joints = assembly.vehicle.draft, joint_loads(assembly)
    groups = list(draft.axles.values())
    return TrimLoads(
        {name: joints[name] for name in draft.supports},
        {
            axle: float(joints[group][0][2]) / groups.count(group)
            for axle, group in draft.axles.items()
            if group in draft.supports
        },
        {name: joints[name] for name in draft.couplings},
        float(joints["trim.hold"][0][0]) if "trim.hold" in joints else None,
    )
