"""``eom check``."""

from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.model.assembly import assemble
from eom.report.summary import summary


def run_check(file: Path, settings: list[str]) -> None:
    """Print the summary of a vehicle."""
    typer.echo(summary(assemble(load_with(file, settings))), nl=False)
