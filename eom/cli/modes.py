"""``eom modes``."""

from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.model.linear import linearise
from eom.report.modes import mode_table, shape_tables, write_modes
from eom.report.pictures import check_picture, save


def run_modes(file: Path, settings: list[str], shapes: bool, outputs: tuple[Path | None, Path | None]) -> None:
    """Print the modes of a vehicle; write them as CSV and as a picture if asked."""
    numbers, plot = outputs
    if plot is not None:
        check_picture(plot)
    vehicle = load_with(file, settings)
    modes = linearise(vehicle).modes()
    typer.echo(mode_table(modes))
    if shapes:
        typer.echo(f"\n{shape_tables(modes)}")
    if numbers is not None:
        numbers.parent.mkdir(parents=True, exist_ok=True)
        write_modes(numbers, modes)
        typer.echo(f"numbers  {numbers}")
    if plot is not None:
        plot.parent.mkdir(parents=True, exist_ok=True)
        figure = modes.plot()
        figure.suptitle(f"{vehicle.name}: modes")
        save(figure, plot)
        typer.echo(f"picture  {plot}")
