"""``eom simulate``."""

from dataclasses import replace
from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.cli.simulate_request import Options, Plan, understood
from eom.errors import SimulationError
from eom.model.tyre import build
from eom.report.pictures import FORMATS, save
from eom.report.simulation import report
from eom.simulation import RunInterrupted, simulate
from eom.simulation.equations import Model
from eom.simulation.run import Run

MISTAKE, INTERRUPTED = 2, 130
"""Exit status of a run that cannot go on, and of one that was interrupted from the keyboard."""
NUMBERS = (".csv", ".nc")


def run_simulate(file: Path, settings: list[str], options: Options) -> None:
    """Simulate a vehicle, print what happened, write its files; a run that failed keeps what it has and says so."""
    vehicle = load_with(file, settings)
    model = build(vehicle)
    plan = understood(model, options)
    if options.out is not None:
        # before a long run, not after it
        options.out.mkdir(parents=True, exist_ok=True)
    run, failed, status = simulated(model, plan)
    speed = vehicle.speed if plan.speed is None else plan.speed
    typer.echo(report(run, speed))
    if options.out is not None:
        write(replace(run, identity={**run.identity, **plan.origin}), options.out / f"{file.stem}_run")
    if status:
        typer.echo(failed, err=True)
        raise typer.Exit(status)


def simulated(model: Model, plan: Plan) -> tuple[Run, str, int]:
    """The run as far as it came, why it failed, and the exit status; without any run the error is raised."""
    try:
        run = simulate(
            model,
            plan.inputs,
            plan.duration,
            speed=plan.speed,
            blocks=plan.blocks,
            wires=plan.wires,
            sample=plan.sample,
            method=plan.method,
            step=plan.step,
        )
    except SimulationError as error:
        if not (isinstance(error.partial, Run) and begun(error.partial)):
            raise
        return error.partial, str(error), MISTAKE
    except RunInterrupted as error:
        if not begun(error.partial):
            raise
        return error.partial, str(error), INTERRUPTED
    return run, "", 0


def begun(run: Run) -> bool:
    """Whether there is more of a run than its start."""
    return len(run.time) > 1


def write(run: Run, stem: Path) -> None:
    """Numbers and pictures of a run, and where they are."""
    # a stem may have dots of its own
    numbers = [run.save(stem.with_name(stem.name + suffix)) for suffix in NUMBERS]
    pictures = [stem.with_name(stem.name + suffix) for suffix in FORMATS]
    figure = run.plot()
    for path in pictures:
        save(figure, path)
    typer.echo(f"\nnumbers   {', '.join(map(str, numbers))}\npictures  {', '.join(map(str, pictures))}")
