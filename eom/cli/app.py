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
    latex: Annotated[bool, typer.Option("--latex", help="Write the equations in symbols too, as LaTeX.")] = False,
    symbols: Annotated[
        list[str] | None,
        typer.Option("--symbol", metavar="NAME", help="With --latex: a parameter to keep as a symbol; all without."),
    ] = None,
) -> None:
    """Write a vehicle's importable module, its matrices (.npz, .mat) and a summary."""
    from eom.cli.build import run_build  # noqa: PLC0415

    if symbols and not latex:
        message = "--symbol goes with --latex: without it nothing is written in symbols"
        raise typer.BadParameter(message)
    run_build(file, settings or [], out, (symbols or "all") if latex else None)


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
def response(
    file: File,
    settings: Set = None,
    source: Annotated[
        str | None, typer.Option("--input", metavar="INPUT", help="The input; the vehicle's first one by default.")
    ] = None,
    outputs: Annotated[
        list[str] | None,
        typer.Option("--output", metavar="OUTPUT[/OUTPUT]", help="An output, or the ratio of two; may be repeated."),
    ] = None,
    first: Annotated[str | None, typer.Option("--from", metavar="FREQUENCY", help="Lowest frequency, in Hz.")] = None,
    last: Annotated[str | None, typer.Option("--to", metavar="FREQUENCY", help="Highest frequency, in Hz.")] = None,
    time: Annotated[
        str | None, typer.Option(metavar="KIND", help="Also in time: step, impulse or one sine, e.g. sine:0.4Hz.")
    ] = None,
    amplitude: Annotated[
        str | None, typer.Option(metavar="VALUE", help="Of the input in time, e.g. 2deg; 1 in SI units by default.")
    ] = None,
    duration: Annotated[str | None, typer.Option(metavar="TIME", help="Of the response in time, e.g. 8s.")] = None,
    road: Annotated[
        str | None, typer.Option(metavar="CLASS", help="Also on a random road of ISO 8608, A to H.")
    ] = None,
    speed: Annotated[
        str | None, typer.Option(metavar="SPEED", help="On the road, for a vehicle without trim speed, e.g. 20m/s.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FOLDER", help="Write numbers (.csv) and pictures (.png, .svg).")
    ] = None,
) -> None:
    """Respond to an input: over frequency, steady, in time, on a random road."""
    from eom.cli.request import Options  # noqa: PLC0415
    from eom.cli.response import run_response  # noqa: PLC0415

    options = Options(source, outputs or [], first, last, time, amplitude, duration, road, speed, out)
    run_response(file, settings or [], options)


@app.command()
def simulate(
    file: File,
    settings: Set = None,
    run: Annotated[
        Path | None, typer.Option(metavar="RUN.yaml", help="A run file; what options say goes before it.")
    ] = None,
    inputs: Annotated[
        list[str] | None,
        typer.Option(
            "--input",
            metavar="NAME=KIND",
            help="An input: a value, sine:AMPLITUDE:FREQUENCY[:START[:CYCLES]] or step:VALUE[:START]; repeat.",
        ),
    ] = None,
    duration: Annotated[str | None, typer.Option(metavar="TIME", help="How long, e.g. 8s.")] = None,
    speed: Annotated[
        str | None, typer.Option(metavar="SPEED", help="To start from, e.g. 110km/h; the file's own by default.")
    ] = None,
    sample: Annotated[
        str | None, typer.Option(metavar="TIME", help="Between samples of the results; 10ms by default.")
    ] = None,
    method: Annotated[
        str | None,
        typer.Option(metavar="METHOD", help="automatic (default), dormand_prince, rosenbrock, or rk4 with --step."),
    ] = None,
    step: Annotated[str | None, typer.Option(metavar="TIME", help="Step of rk4, e.g. 1ms.")] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FOLDER", help="Write numbers (.csv, .nc) and pictures (.png, .svg)."),
    ] = None,
) -> None:
    """Simulate a vehicle over time, from its straight run on: inputs, drivers, events."""
    from eom.cli.simulate import run_simulate  # noqa: PLC0415
    from eom.cli.simulate_request import Options  # noqa: PLC0415

    run_simulate(file, settings or [], Options(run, inputs or [], duration, speed, sample, method, step, out))


@app.command()
def tyre(
    file: Annotated[Path, typer.Argument(metavar="FILE.tir", help="The tyre file.", show_default=False)],
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FOLDER", help="Write curves (.csv) and pictures (.png, .svg).")
    ] = None,
) -> None:
    """Read a .tir file: stiffnesses, friction, trail and relaxation over load, and what is suspicious."""
    from eom.cli.tyre import run_tyre  # noqa: PLC0415

    run_tyre(file, out)


@app.command()
def schema() -> None:
    """Print the JSON Schema of vehicle files, with which an editor completes and checks them."""
    import json  # noqa: PLC0415

    from eom.vehicle.description import Description  # noqa: PLC0415

    text = json.dumps(Description.model_json_schema(by_alias=True), indent=2)
    typer.echo(text)
