"""``eom tyre``."""

from pathlib import Path

import typer

from eom.report.pictures import FORMATS, save
from eom.report.tyre import remarks, stiffness_tables, tyre_summary, write_carpet
from eom.tyre import read_tir
from eom.tyre.carpet import carpet
from eom.tyre.characteristics import characteristics, usual_loads


def run_tyre(file: Path, out: Path | None) -> None:
    """Print what a .tir file says and what its tyre does; write its curves."""
    read = read_tir(file)
    figures = characteristics(read.tyre, usual_loads(read.tyre))
    typer.echo(f"{tyre_summary(read)}\n\n{stiffness_tables(figures)}\n")
    typer.echo(remarks(read))
    if out is None:
        return
    out.mkdir(parents=True, exist_ok=True)
    curves = carpet(read.tyre, file.stem)
    numbers = out / f"{file.stem}.csv"
    write_carpet(numbers, curves)
    pictures = [out / f"{file.stem}{ending}" for ending in FORMATS]
    figure = curves.plot()
    for path in pictures:
        save(figure, path)
    typer.echo(f"\nnumbers   {numbers}\npictures  {', '.join(map(str, pictures))}")
