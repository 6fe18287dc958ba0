"""The summary of a vehicle that ``eom check`` prints and ``eom build`` writes."""

import textwrap
from collections.abc import Iterator

import numpy as np

from eom.analysis.loads import TrimLoads, trim_loads
from eom.assembly.diagnosis import locked_joints, redundant_joints, redundant_locks, some
from eom.assembly.elastic import elastic_items
from eom.assembly.statics import self_stresses
from eom.assembly.vectors import Array
from eom.model.assembly import Assembly
from eom.model.linear import state_names
from eom.report.table import table

# groups of redundant joints that a reader can take in
SHOWN = 6


def summary(assembly: Assembly) -> str:
    """Degrees of freedom, constraints, trim and loads as text."""
    blocks = [
        "\n".join(heading(assembly)),
        "\n".join(counts(assembly)),
        "\n".join(trim(assembly)),
        *load_tables(trim_loads(assembly), wheels=assembly.prepared is not None),
        *wheels(assembly),
        *deflections(assembly),
    ]
    return "\n\n".join(blocks) + "\n"


def heading(assembly: Assembly) -> Iterator[str]:
    """Name and source."""
    vehicle = assembly.vehicle
    yield vehicle.name
    if vehicle.description.source:
        yield textwrap.fill(f"source: {vehicle.description.source}", 100, subsequent_indent="        ")


def counts(assembly: Assembly) -> Iterator[str]:
    """Bodies, constraints with their rank, degrees of freedom, states."""
    pivots, reduction = assembly.pivots, assembly.reduction
    N, q, n = assembly.M.shape[0], len(reduction.independent), len(reduction.independent_velocities)
    yield f"bodies              {N // 6} ({N} coordinates)"
    rank, total = len(pivots.rows), assembly.J.shape[0]
    yield f"constraints         {total}, rank {rank}, {redundancy(assembly, total - rank)}"
    if assembly.Jn.shape[0]:
        yield f"rolling constraints {assembly.Jn.shape[0]}, rank {len(pivots.rolling_rows)}"
    spins = 0 if assembly.prepared is None else len(assembly.prepared.model.contact.spinning)
    own = f" ({q} of bodies, {spins} wheel spins)" if spins else ""
    yield f"degrees of freedom  {q + spins}{own}" + (f" ({n} in velocity)" if n != q else "")
    locked = locked_joints(assembly.system, reduction)
    if locked:
        yield f"locked by loops     {', '.join(locked)}: free by themselves, but their loops let nothing move there"
    if not q:
        yield "                    no motion is left: the joints lock every body"
    massless = [assembly.velocities[reduction.independent_velocities[k]] for k in (*pivots.damped, *pivots.static)]
    if massless:
        how = "placed by dampers or stiffness alone"
        yield textwrap.fill(f"without inertia     {', '.join(massless)}: {how}", 100, subsequent_indent=" " * 20)
    yield from signal_counts(assembly)


def signal_counts(assembly: Assembly) -> Iterator[str]:
    """States, with the cyclic ones, inputs and outputs."""
    if assembly.prepared is None:
        names, cyclic = list(state_names(assembly)[0]), assembly.pivots.cyclic
        inputs, outputs = len(assembly.system.inputs), len(assembly.system.outputs)
    else:
        from eom.report.wheels import signals_of  # noqa: PLC0415  tyres take a while to import

        names, inputs, outputs = signals_of(assembly.prepared)
        cyclic = (0, 1, 2)
    yield f"states              {len(names)}, of which cyclic: {', '.join(names[k] for k in cyclic) or 'none'}"
    yield f"inputs, outputs     {inputs}, {outputs}"


def redundancy(assembly: Assembly, number: int) -> str:
    """Which joints lock the same motion."""
    if number == 0:
        return "none redundant"
    null = self_stresses(assembly.J, assembly.pivots, assembly.reduction)[:, :SHOWN]
    more = f"; {number - SHOWN} more" if number > SHOWN else ""
    lines = [f"{number} redundant ({redundant_joints(assembly.system, null)}{more})"]
    for group in redundant_locks(assembly.system, null):
        lines.append("locked more than once:")
        lines += [f"  {lock}" for lock in some(list(map(str, group)))]
    indefinite = assembly.matrices.statics.indefinite
    owners = dict.fromkeys(
        name.split("[")[0] for name, open_ in zip(assembly.constraint_rows, indefinite, strict=True) if open_
    )
    lines += textwrap.wrap(f"not unique, the smallest are shown: the loads of {', '.join(some(list(owners)))}", 100)
    lines.append("let one of them carry less")
    return f"\n{' ' * 20}".join(lines)


def trim(assembly: Assembly) -> Iterator[str]:
    """Speed and equilibrium."""
    statics = assembly.matrices.statics
    speed = assembly.system.bodies[0].velocity[0]
    held = any(item.moving for item in assembly.system.constraints)
    how = "held" if held else "free" if speed else "at rest"
    yield f"trim speed          {speed:.6g} m/s ({speed * 3.6:.6g} km/h), {how}"
    worst = float(abs(statics.residual).max(initial=0.0))
    stiff = any(np.any(item.stiffness) for item in elastic_items(assembly.system))
    how = "statics and stiffness" if stiff else "smallest reactions"
    how = "statics alone" if statics.determinate else how
    yield f"equilibrium         by {how}, largest remainder {worst:.1e} N or N m"


def wheels(assembly: Assembly) -> Iterator[str]:
    """Tables of a vehicle with wheels."""
    if assembly.prepared is not None:
        from eom.report.wheels import wheel_tables  # noqa: PLC0415  tyres take a while to import

        yield from wheel_tables(assembly.prepared)


def load_tables(loads: TrimLoads, *, wheels: bool) -> Iterator[str]:
    """Tables of the loads that there are; those of axles where no table of *wheels* tells them."""
    if loads.supports:
        yield table(
            ("support", "force z [N]", "moment x [N m]", "moment y [N m]"),
            ((name, number(f[2]), number(m[0]), number(m[1])) for name, (f, m) in loads.supports.items()),
        )
    if not wheels:
        yield from axle_loads(loads)
    if loads.preloads:
        yield table(
            ("spring, bushing or tyre", "preload [N, N m]"),
            ((name, number(load)) for name, load in loads.preloads.items()),
        )
    if loads.couplings:
        yield table(
            ("coupling, on the towed unit", "force x [N]", "force y [N]", "force z [N]"),
            ((name, *components(f)) for name, (f, _) in loads.couplings.items()),
        )
    if loads.hold is not None:
        yield f"force that holds the speed: {number(loads.hold)} N"


def axle_loads(loads: TrimLoads) -> Iterator[str]:
    """Table of the axles' loads, and a sentence on those that are not known."""
    known = {name: load for name, load in loads.axles.items() if load is not None}
    if known:
        yield table(("axle", "load [N]"), ((name, number(load)) for name, load in known.items()))
    if len(known) < len(loads.axles):
        others = ", ".join(name for name in loads.axles if name not in known)
        yield textwrap.fill(
            f"loads of {others} are not told apart: their axle groups have no 'support' of their own", 100
        )


def deflections(assembly: Assembly) -> Iterator[str]:
    """Table of the displacements, from the state without load, of the bodies that the loads displace."""
    motions = np.round(1e3 * assembly.matrices.statics.deflection.reshape(-1, 6), 3) + 0.0
    bent = np.flatnonzero(np.any(motions, axis=1))
    if bent.size:
        yield table(
            ("static deflection", "x [mm]", "y [mm]", "z [mm]", "roll [mrad]", "pitch [mrad]", "yaw [mrad]"),
            ((assembly.system.bodies[k].name, *(f"{value:.3f}" for value in motions[k])) for k in bent),
        )


def components(vector: Array) -> tuple[str, str, str]:
    """Three numbers as text."""
    x, y, z = vector
    return number(x), number(y), number(z)


def number(value: float) -> str:
    """A load to a tenth, without a negative zero."""
    return f"{round(float(value), 1) + 0.0:.1f}"
