"""The commands and their options; each imports what it needs only when it runs."""

from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(
    name="eom",
    help="Equations of motion of road vehicles with trailers, from one YAML file.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

File = Annotated[Path, typer.Argument(metavar="VEHICLE.yaml", help="The vehicle file.", show_default=False)]
Set = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Set a parameter, e.g. U=110km/h; may be repeated."),
]


@app.command()
def check(file: File, settings: Set = None) -> None:
    """Check a vehicle file; report its degrees of freedom, constraints, trim and loads."""
    from eom.cli.check import run_check  # noqa: PLC0415

    run_check(file, settings or [])


@app.command()
def build(
    file: File,
    settings: Set = None,
    out: Annotated[Path, typer.Option("--out", metavar="FOLDER", help="Where the results go.")] = Path("build"),
) -> None:
    """Write a vehicle's importable module, its matrices (.npz, .mat) and a summary."""
    from eom.cli.build import run_build  # noqa: PLC0415

    run_build(file, settings or [], out)


@app.command()
def modes(
    file: File,
    settings: Set = None,
    shapes: Annotated[bool, typer.Option("--shapes", help="Print the motion of the bodies in each mode.")] = False,
    numbers: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write all modes.")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="Draw the modes, as .png or .svg.")] = None,
) -> None:
    """List a vehicle's modes: frequency, damping ratio, time constant, wavelength, and what moves."""
    from eom.cli.modes import run_modes  # noqa: PLC0415

    run_modes(file, settings or [], shapes, (numbers, plot))


@app.command()
def sweep(
    file: File,
    ranges: Annotated[
        list[str],
        typer.Argument(
            metavar="NAME=FROM:TO:STEP...", help="One parameter, e.g. U=10:130:5km/h, or two.", show_default=False
        ),
    ],
    settings: Set = None,
    out: Annotated[Path, typer.Option("--out", metavar="FOLDER", help="Where numbers and pictures go.")] = Path(
        "build"
    ),
) -> None:
    """Follow a vehicle's modes over one parameter, and find its critical values; or map its stability over two."""
    from eom.cli.sweep import run_sweep  # noqa: PLC0415

    run_sweep(file, settings or [], ranges, out)


@app.command()
def kinematics(
    file: File,
    drive: Annotated[
        list[str], typer.Option(metavar="NAME=FROM:TO", help="Drive an actuator, e.g. rack=-40mm:40mm; repeat.")
    ],
    settings: Set = None,
    points: Annotated[int, typer.Option(help="Number of values, both ends included.")] = 33,
    hold: Annotated[
        list[str] | None, typer.Option(metavar="BODY", help="Keep a body where it is drawn; may be repeated.")
    ] = None,
    free: Annotated[
        list[str] | None, typer.Option(metavar="ACTUATOR", help="Do not lock an actuator; may be repeated.")
    ] = None,
    numbers: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write all measures.")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="Draw the curves, as .png or .svg.")] = None,
) -> None:
    """Drive a mechanism through its travel: camber, toe, track, roll centres, sensors."""
    from eom.cli.kinematics import run_kinematics  # noqa: PLC0415

    run_kinematics(file, settings or [], drive, (hold or [], free or [], points), (numbers, plot))


@app.command()
def schema() -> None:
    """Print the JSON Schema of vehicle files, with which an editor completes and checks them."""
    import json  # noqa: PLC0415

    from eom.vehicle.description import Description  # noqa: PLC0415

    text = json.dumps(Description.model_json_schema(by_alias=True), indent=2)
    typer.echo(text)
