"""``eom build``."""

from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.codegen.module import module_name, write_module
from eom.model.assembly import assemble
from eom.model.linear import linearise
from eom.report.matrices import write_mat, write_npz
from eom.report.modes import mode_table
from eom.report.summary import summary


def run_build(file: Path, settings: list[str], out: Path) -> None:
    """Write module, matrices and summary, and say where they are."""
    vehicle = load_with(file, settings)
    assembly = assemble(vehicle)
    model = linearise(assembly)
    name = module_name(vehicle)
    module = write_module(assembly, out)
    write_npz(assembly, model, out / f"{name}.npz")
    write_mat(assembly, model, out / f"{name}.mat")
    text = out / f"{name}.txt"
    text.write_text(f"{summary(assembly)}\n{mode_table(model.modes())}\n", encoding="utf-8")
    typer.echo(f"module    {module}")
    typer.echo(f"matrices  {out / name}.npz, {out / name}.mat")
    typer.echo(f"summary   {text}")
