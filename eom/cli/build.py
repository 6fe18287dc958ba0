"""``eom build``."""

from collections.abc import Sequence
from pathlib import Path

import typer

from eom.cli.settings import load_with
from eom.codegen.module import module_name, write_module
from eom.model.assembly import assemble
from eom.model.linear import linearise
from eom.report.matrices import write_mat, write_npz
from eom.report.modes import mode_table
from eom.report.summary import summary
from eom.vehicle.load import Vehicle


def run_build(file: Path, settings: list[str], out: Path, symbols: Sequence[str] | None) -> None:
    """Write module, matrices and summary, with *symbols* the equations too, and say where they are."""
    vehicle = load_with(file, settings)
    assembly = assemble(vehicle)
    model = linearise(assembly)
    equations = document(vehicle, symbols) if symbols else ""
    name = module_name(vehicle)
    module = write_module(assembly, out)
    write_npz(assembly, model, out / f"{name}.npz")
    write_mat(assembly, model, out / f"{name}.mat")
    text = out / f"{name}.txt"
    text.write_text(f"{summary(assembly)}\n{mode_table(model.modes())}\n", encoding="utf-8")
    typer.echo(f"module    {module}")
    typer.echo(f"matrices  {out / name}.npz, {out / name}.mat")
    typer.echo(f"summary   {text}")
    if equations:
        path = out / f"{name}.tex"
        path.write_text(equations, encoding="utf-8")
        typer.echo(f"equations {path}")


def document(vehicle: Vehicle, symbols: Sequence[str]) -> str:
    """The equations in symbols as a LaTeX document."""
    from eom.report.latex import latex_document  # noqa: PLC0415  sympy is slow to import

    return latex_document(assemble(vehicle, symbols=symbols))
