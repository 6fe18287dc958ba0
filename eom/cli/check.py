"""``eom check``."""

from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.model.assembly import assemble
from eom.model.linear import linearise
from eom.report.summary import summary


def run_check(file: Path, settings: list[str]) -> None:
    """Print the summary of a vehicle."""
    assembly = assemble(load_with(file, settings))
    # what only the state space shows, such as an output that no input may drive
    linearise(assembly)
    typer.echo(summary(assembly), nl=False)
