"""``eom modes``."""

import re
import sys
from pathlib import Path

import numpy as np
import typer

from eom.cli.settings import UsageError, load_with, parse_settings
from eom.errors import EomError
from eom.model.linear import linearise
from eom.model.modes import Modes
from eom.report.modes import mode_table, plot_sweep, sweep_table, write_sweep

SWEEP = re.compile(r"\s*([A-Za-z][\w.]*)\s*=\s*([^:]+):([^:]+):\s*([-+\d.eE]+)\s*(.*?)\s*")
MAX_STEPS = 10_000
# sweeps longer than about two seconds show their progress
MANY = 100


def run_modes(file: Path, settings: list[str]) -> None:
    """Print the modes of a vehicle."""
    model = linearise(load_with(file, settings))
    typer.echo(mode_table(model.modes()))


def parse_sweep(text: str) -> tuple[str, list[float], str]:
    """Name, values (both ends included where the step meets them) and unit of ``NAME=FROM:TO:STEPunit``."""
    match = SWEEP.fullmatch(text)
    expected = f"--sweep {text}: expected NAME=FROM:TO:STEP with an optional unit, such as U=10:130:5km/h"
    if match is None:
        raise UsageError(expected)
    try:
        start, stop, step = (float(match[k]) for k in (2, 3, 4))
    except ValueError:
        raise UsageError(expected) from None
    if not np.all(np.isfinite([start, stop, step])) or step == 0.0 or (stop - start) / step < 0.0:
        raise UsageError(f"--sweep {text}: the step does not lead from {start:g} to {stop:g}")
    steps = (stop - start) / step
    if not steps < MAX_STEPS:
        raise UsageError(f"--sweep {text}: has {steps:.0f} steps, at most {MAX_STEPS} are allowed")
    count = int(steps * (1.0 + 1e-12) + 1e-9) + 1
    return match[1], [start + k * step for k in range(count)], match[5]


def run_sweep(file: Path, settings: list[str], sweep: str, out: Path) -> None:
    """Modes over a parameter: a table, all roots as CSV, and a picture of the locus.

    An interrupt, or a value that the vehicle refuses, ends the sweep; what was computed until then is kept.
    """
    name, values, unit = parse_sweep(sweep)
    if name in parse_settings(settings):
        raise UsageError(f"--set {name}: the sweep sets it")
    results: list[Modes] = []
    title = ""
    try:
        with typer.progressbar(values, label=name, hidden=len(values) < MANY, file=sys.stderr) as progress:
            for value in progress:
                vehicle = load_with(file, settings, {name: f"{value!r} {unit}" if unit else value})
                results.append(linearise(vehicle).modes())
                title = f"{vehicle.name}: root locus"
    except (KeyboardInterrupt, EomError) as end:
        if not results:
            raise
        what = "interrupted" if isinstance(end, KeyboardInterrupt) else f"{end}\nstopped"
        typer.echo(f"{what} after {len(results)} of {len(values)} values", err=True)
    done = values[: len(results)]
    typer.echo(sweep_table(name, unit, done, results))
    out.mkdir(parents=True, exist_ok=True)
    stem = f"{file.stem}_{name.replace('.', '_')}"
    roots, locus = out / f"{stem}.csv", out / f"{stem}.png"
    write_sweep(roots, name, unit, done, results)
    plot_sweep(locus, title, f"{name} [{unit}]" if unit else name, done, results)
    typer.echo(f"\nroots  {roots}\nlocus  {locus}")
    if len(done) < len(values):
        raise typer.Exit(2)
