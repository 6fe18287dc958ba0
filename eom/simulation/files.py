"""Files of a run: CSV, netCDF, MATLAB."""

import csv
from collections.abc import Callable, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.simulation.channels import Channels
from eom.simulation.matlab import write_matlab

if TYPE_CHECKING:
    from xarray import Dataset

SUFFIXES = (".csv", ".nc", ".mat")


def write(path: Path, time: Array, signals: Channels, data: Callable[[], "Dataset"], about: Mapping[str, str]) -> Path:
    """Write a file of the kind that its suffix says; see `eom.simulation.Run.save`."""
    kind = path.suffix.lower()
    mistakes = []
    if kind not in SUFFIXES:
        mistakes.append(
            f"{path}: expected a file name that ends in {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]}, "
            f"got {f'the suffix {path.suffix}' if path.suffix else 'no suffix'}"
        )
    if not path.parent.is_dir():
        mistakes.append(f"{path}: there is no folder {path.parent} to write to")
    if mistakes:
        raise AnalysisError("\n".join(mistakes))
    if kind == ".csv":
        write_csv(path, time, signals)
    elif kind == ".mat":
        write_matlab(path, time, signals, about)
    else:
        write_netcdf(path, data())
    return path


def write_csv(path: Path, time: Array, signals: Channels) -> None:
    """Time and signals, a column each, every number in the fewest digits that give it back exactly."""
    header = [f"{name} [{unit or '-'}]" for name, unit in zip(signals.names, signals.units, strict=True)]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time [s]", *header])
        # tolist: Python's own floats, which csv writes by repr
        writer.writerows(row.tolist() for row in np.column_stack((time, signals.values)))


def write_netcdf(path: Path, data: "Dataset") -> None:
    """The data set as netCDF4 where the libraries for it are installed, as netCDF3 by scipy otherwise."""
    engine: Literal["h5netcdf", "scipy"] = "h5netcdf" if find_spec("h5netcdf") and find_spec("h5py") else "scipy"
    # no sample is missing: a value that is not finite is one that was computed
    numbers = [name for name, variable in data.variables.items() if variable.dtype.kind == "f"]
    data.to_netcdf(path, engine=engine, encoding={name: {"_FillValue": None} for name in numbers})
