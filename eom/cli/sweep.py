"""``eom sweep``."""

import sys
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import typer

from eom.analysis.critical import critical_of
from eom.analysis.family import Node, family_of, with_unit
from eom.analysis.locus import locus_of
from eom.analysis.maps import Axis, MapPoint, map_of, map_points
from eom.cli.ranges import Range, parse_ranges
from eom.cli.settings import UsageError, load_with, parse_settings
from eom.errors import EomError
from eom.report.locus import critical_table, locus_table, write_locus
from eom.report.maps import map_table, write_map
from eom.report.pictures import FORMATS, save
from eom.vehicle.load import Vehicle

if TYPE_CHECKING:
    from matplotlib.figure import Figure

T = TypeVar("T")
# sweeps longer than about two seconds show their progress
MANY = 100


def run_sweep(file: Path, settings: list[str], texts: list[str], out: Path) -> None:
    """A root locus over one parameter, or a map over two.

    An interrupt, or a value that the vehicle refuses, ends the sweep; what was computed until then is kept.
    """
    ranges = parse_ranges(texts)
    if fixed := [item.name for item in ranges if item.name in parse_settings(settings)]:
        raise UsageError("\n".join(f"--set {name}: the sweep sets it" for name in fixed))
    # the file's own value may be one that cannot be computed: the sweep starts from its first
    vehicle = load_with(file, settings, {item.name: with_unit(item.values[0], item.unit) for item in ranges})
    stem = out / "_".join([file.stem, *(item.name.replace(".", "_") for item in ranges)])
    out.mkdir(parents=True, exist_ok=True)
    if len(ranges) == 1:
        sweep_one(vehicle, ranges[0], stem)
    else:
        sweep_two(vehicle, ranges[0], ranges[1], stem)


def sweep_one(vehicle: Vehicle, item: Range, stem: Path) -> None:
    """Table, numbers and pictures of a root locus."""
    family = family_of(vehicle, item.name, item.unit)
    nodes: list[Node] = []
    with kept(nodes, len(item.values)), progress(item.values, item.name, len(item.values)) as values:
        for value in values:
            nodes.append(Node(value, family(value)))  # noqa: PERF401  an interrupt keeps what is there
    locus = locus_of(family, nodes, item.name, item.unit, vehicle.name)
    typer.echo(locus_table(locus))
    write_locus(numbers(stem), locus)
    typer.echo(f"\n{critical_table(locus, critical_of(locus))}")
    finish(stem, locus.plot(), len(nodes) < len(item.values))


def sweep_two(vehicle: Vehicle, first: Range, second: Range, stem: Path) -> None:
    """Table, numbers and pictures of a stability map."""
    axes = Axis(*first), Axis(*second)
    points: list[MapPoint] = []
    total = len(first.values) * len(second.values)
    with kept(points, total), progress(map_points(vehicle, *axes), "map", total) as found:
        for point in found:
            points.append(point)  # noqa: PERF402  an interrupt keeps what is there
    result = map_of(vehicle, *axes, points)
    typer.echo(map_table(result))
    write_map(numbers(stem), result)
    finish(stem, result.plot(), len(points) < total)


@contextmanager
def kept(done: list[Any], total: int) -> Iterator[None]:
    """Let an interrupt or a refused value end what is inside, and say so, if anything is done by then."""
    try:
        yield
    except (KeyboardInterrupt, EomError) as end:
        if not done:
            raise
        what = "interrupted" if isinstance(end, KeyboardInterrupt) else f"{end}\nstopped"
        typer.echo(f"{what} after {len(done)} of {total} values", err=True)


def progress(items: Iterable[T], label: str, total: int) -> AbstractContextManager[Iterable[T]]:
    """The items with a bar on standard error, if they are many."""
    return typer.progressbar(items, length=total, label=label, hidden=total < MANY, file=sys.stderr)


def numbers(stem: Path) -> Path:
    """The file of numbers; a name may have dots of its own."""
    return stem.parent / f"{stem.name}.csv"


def finish(stem: Path, figure: "Figure", early: bool) -> None:
    """Write the pictures, say where everything is, and end with status 2 if the sweep ended early."""
    pictures = [stem.parent / f"{stem.name}{ending}" for ending in FORMATS]
    for path in pictures:
        save(figure, path)
    typer.echo(f"\nnumbers   {numbers(stem)}\npictures  {', '.join(map(str, pictures))}")
    if early:
        raise typer.Exit(2)
