"""Where connectors stand: their bodies, places and lines in a draft."""

from eom.vehicle.connector import LineConnector, Pair, PointConnector
from eom.vehicle.draft import Draft, Site, Z, add, subtract
from eom.vehicle.elements import Connection, Vector
from eom.vehicle.source import Path


def joined(draft: Draft, names: Pair, path: Path, site: Site) -> tuple[int, int]:
    """Numbers of two bodies, which must differ."""
    first, second = (draft.body(body, (*path, "between", k), site.bodies) for k, body in enumerate(names))
    if names[0] == names[1]:
        draft.registry.report((*path, "between"), f"connects '{names[0]}' with itself")
    return first, second


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
    first, second = joined(draft, item.between, path, site)
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


def line_ends(draft: Draft, name: str, item: LineConnector, path: Path, site: Site) -> tuple[Vector, Vector]:
    """The places of a line's two ends."""
    start, end = (
        add(site.origin, draft.registry.place(place, f"{name}.end_{k + 1}", (*path, "ends", k), site.scope))
        for k, place in enumerate(item.ends)
    )
    return start, end


def line_connection(draft: Draft, name: str, item: LineConnector, path: Path, site: Site, *, twist: bool) -> Connection:
    """The connection along a line, or with *twist* about it."""
    bodies = joined(draft, item.between, path, site)
    start, end = line_ends(draft, name, item, path, site)
    if not twist:
        return Connection(name, bodies, (start, end), forces=1, line=True)
    return Connection(name, bodies, (start, end), moments=1, moment_axis=subtract(end, start))
