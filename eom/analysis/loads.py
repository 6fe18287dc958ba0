"""Loads of the trim by role: supports, axles, couplings."""

from typing import NamedTuple

from eom.assembly.matrices import split
from eom.assembly.rows import row_count
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
        Vertical load of each axle [N], shared equally in its group; None if the group has no support of its own.
    couplings : dict
        On the towed unit by the one ahead, force and moment by coupling.
    preloads : dict
        Tensions and preloads of springs, bushings and tyres, one per row; those that carry nothing are left out.
    hold : float or None
        Force along x that holds the lead body's speed; None if the speed is free.
    """

    supports: dict[str, tuple[Array, Array]]
    axles: dict[str, float | None]
    couplings: dict[str, tuple[Array, Array]]
    preloads: dict[str, float]
    hold: float | None


def joint_loads(assembly: Assembly) -> dict[str, tuple[Array, Array]]:
    """Force [N] and moment [N m] that each joint exerts on its first body in the trim, along x, y, z.

    The second body gets the opposite.
    """
    joints = [item.connection for item in assembly.system.constraints]
    counts = [row_count(item) for item in joints]
    reactions = split(assembly.matrices.statics.reactions, counts)
    return {joint.name: preload(joint, own) for joint, own in zip(joints, reactions, strict=True)}


def trim_loads(assembly: Assembly) -> TrimLoads:
    """The trim's loads, sorted by the roles that the description gives."""
    draft, joints = assembly.vehicle.draft, joint_loads(assembly)
    groups = list(draft.axles.values())
    return TrimLoads(
        {name: joints[name] for name in draft.supports},
        {
            axle: float(joints[group][0][2]) / groups.count(group) if group in draft.supports else None
            for axle, group in draft.axles.items()
        },
        {name: joints[name] for name in draft.couplings},
        {
            name: float(tension)
            for name, tension in zip(assembly.elastic_rows, assembly.matrices.statics.tensions, strict=True)
            if abs(tension) > assembly.matrices.statics.limit
        },
        float(joints["trim.hold"][0][0]) if "trim.hold" in joints else None,
    )
