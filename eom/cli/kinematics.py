"""``eom kinematics``."""

from pathlib import Path
from typing import cast

import typer

from eom.analysis.kinematics import KinematicSweep, kinematic_sweep
from eom.cli.settings import UsageError, load_with
from eom.errors import MechanismError
from eom.report.kinematics import plot_kinematics, sweep_tables, write_kinematics
from eom.report.pictures import check_picture
from eom.vehicle.quantity import MEASURED


def parse_drives(texts: list[str]) -> dict[str, tuple[str, str]]:
    """``NAME=FROM:TO`` texts as ranges; every malformed one is named."""
    drives: dict[str, tuple[str, str]] = {}
    wrong = []
    for text in texts:
        name, _, ends = text.partition("=")
        first, colon, last = (part.strip() for part in ends.partition(":"))
        measured = [MEASURED.fullmatch(end) is not None for end in (first, last)]
        if not (name.strip() and colon and first and last):
            wrong.append(f"--drive {text}: expected NAME=FROM:TO, such as rack=-40mm:40mm")
        elif measured[0] != measured[1] and "0" not in (first, last):
            wrong.append(f"--drive {text}: give both ends a unit, or neither (m, rad)")
        elif name.strip() in drives:
            wrong.append(f"--drive {name.strip()}: is given twice")
        drives[name.strip()] = first, last
    if wrong:
        raise UsageError("\n".join(wrong))
    return drives


def run_kinematics(
    file: Path,
    settings: list[str],
    drives: list[str],
    request: tuple[list[str], list[str], int],
    outputs: tuple[Path | None, Path | None],
) -> None:
    """Print the tables of a sweep, write its files; a sweep that ended early keeps what it has and says so."""
    hold, free, points = request
    if outputs[1] is not None:
        check_picture(outputs[1])
    ranges = parse_drives(drives)
    vehicle = load_with(file, settings)
    try:
        sweep = kinematic_sweep(vehicle, ranges, hold=hold, free=free, points=points)
        early = None
    except MechanismError as error:
        if error.partial is None:
            raise
        sweep, early = cast("KinematicSweep", error.partial), error
    typer.echo(sweep_tables(sweep))
    for path, write in zip(outputs, (write_kinematics, plot_kinematics), strict=True):
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            write(path, sweep)
            typer.echo(f"{'numbers' if write is write_kinematics else 'picture'}  {path}")
    if early is not None:
        typer.echo(f"{early}\nstopped after {len(sweep.residuals)} of {points} points", err=True)
        raise typer.Exit(2)
