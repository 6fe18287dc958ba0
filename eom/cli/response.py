"""``eom response``."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import typer

from eom.analysis.frequency import frequency_response
from eom.analysis.gains import steady_gains
from eom.analysis.grid import frequency_grid, nested_times, time_grid
from eom.analysis.ride import road_response
from eom.analysis.time_response import TimeResponse
from eom.analysis.transient import impulse_response, sine_response, step_response
from eom.cli.request import Options, Plan, understood
from eom.cli.settings import load_with
from eom.errors import SingularError
from eom.model.linear import LinearModel, linearise
from eom.report import responses as report

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PER_CYCLE = 1001


def run_response(file: Path, settings: list[str], options: Options) -> None:
    """Print a vehicle's responses over frequency, steady, in time, on a random road; write their files."""
    vehicle = load_with(file, settings)
    model = linearise(vehicle)
    plan = understood(model, options)
    names = [item.name for item in plan.channels]
    # everything is computed before the first line is printed: a mistake leaves no half of a report
    grid = frequency_grid(model, plan.first, plan.last)
    told = report.round_values(float(grid[0]), float(grid[-1]))
    response = frequency_response(model, plan.source, names, np.union1d(grid, told))
    heading = report.heading(model, plan.source, response.stable)
    try:
        gains, note = steady_gains(model), ""
    except SingularError as error:
        gains, note = None, f"\n{error}"
    blocks = [f"{heading}\n\n{report.summary_table(response, gains)}{note}"]
    if options.outputs:
        blocks.append(report.frequency_tables(response, told))
    files = [("frequency", report.frequency_columns(response), response.plot())]
    if plan.time is not None:
        motion = in_time(model, plan)
        blocks.append(report.time_table(motion, names))
        files.append(("time", report.time_columns(motion, plan.outputs), motion.plot(plan.outputs)))
    if plan.road is not None:
        ride = road_response(vehicle, plan.road, speed=plan.speed, band=(plan.first, plan.last), outputs=plan.outputs)
        blocks.append(report.road_table(ride))
        files.append(("road", report.road_columns(ride), ride.plot()))
    typer.echo("\n\n".join(blocks))
    if options.out is not None:
        typer.echo()
        options.out.mkdir(parents=True, exist_ok=True)
        for kind, columns, figure in files:
            write(options.out / f"{file.stem}_{kind}", columns, figure)


def in_time(model: LinearModel, plan: Plan) -> TimeResponse:
    """The response in time that the plan asks for."""
    length = plan.duration
    if length is None:
        length = float(time_grid(model)[-1]) + (1.0 / plan.sine if plan.sine else 0.0)
    if plan.sine:
        cycle = np.linspace(0.0, min(1.0 / plan.sine, length), PER_CYCLE)
        time = np.union1d(cycle, cycle[-1] + nested_times(model, length - cycle[-1])) if cycle[-1] < length else cycle
        return sine_response(model, plan.source, plan.sine, time, amplitude=plan.amplitude)
    respond = step_response if plan.time == "step" else impulse_response
    return respond(model, plan.source, nested_times(model, length), amplitude=plan.amplitude)


def write(stem: Path, columns: Sequence[tuple[str, np.ndarray]], figure: "Figure") -> None:
    """Numbers as CSV and the picture as PNG and SVG, and where they are."""
    numbers = stem.with_name(f"{stem.name}.csv")
    report.write_columns(numbers, columns)
    pictures = [stem.with_name(f"{stem.name}.{suffix}") for suffix in ("png", "svg")]
    for picture in pictures:
        figure.savefig(picture, dpi=150)
    typer.echo(f"numbers  {numbers}\npicture  {', '.join(map(str, pictures))}")
