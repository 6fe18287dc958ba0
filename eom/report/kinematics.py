"""Kinematic sweeps as tables, a file of numbers and a picture."""

import csv
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from eom.analysis.kinematics import KinematicSweep
from eom.analysis.measures import Measure
from eom.report.pictures import save
from eom.report.table import table

SHOWN = {"m": ("mm", 1e3, 2), "rad": ("deg", 180.0 / np.pi, 3)}
# smaller motions are not shown [m, rad]
STILL = 1e-9
WHEEL = ("travel", "camber", "toe", "steer", "contact_x", "contact_y")
PAIR = ("track", "roll_centre_height", "roll_centre_y")


def shown(measure: Measure) -> tuple[str, list[str]]:
    """Unit for people, and the values in it; ``-`` where there is none."""
    unit, factor, digits = SHOWN.get(measure.unit, (measure.unit, 1.0, 4))
    # + 0.0 so that rounding leaves no negative zero
    texts = (
        f"{round(float(value) * factor, digits) + 0.0:.{digits}f}" if np.isfinite(value) else "-"
        for value in measure.values
    )
    return unit, list(texts)


def sweep_tables(sweep: KinematicSweep) -> str:
    """A table for each wheel that moves, each pair with such a wheel, and the sensors that move; then notes."""
    blocks, still, told = [], [], set()
    for wheel in sweep.wheels:
        own = {f"{wheel}.{name}" for name in WHEEL}
        told |= own
        if all(np.max(np.abs(sweep.measures[name].values)) < STILL for name in own):
            still.append(wheel)
        else:
            blocks.append(one_table(sweep, wheel, WHEEL))
    for pair in sweep.pairs:
        told |= {f"{pair}.{name}" for name in PAIR}
        if np.ptp(sweep.measures[f"{pair}.track"].values) > STILL or has_centre(sweep, pair):
            blocks.append(one_table(sweep, pair, PAIR))
    sensors = [name for name in sweep.measures if name not in told]
    still += [name for name in sensors if np.max(np.abs(sweep.measures[name].values)) < STILL]
    if sensors := [name for name in sensors if name not in still]:
        blocks.append(one_table(sweep, "", sensors))
    return "\n\n".join([*blocks, "\n".join(notes(sweep, still))])


def has_centre(sweep: KinematicSweep, pair: str) -> bool:
    """Whether a pair has a roll centre anywhere."""
    return bool(np.any(np.isfinite(sweep.measures[f"{pair}.roll_centre_height"].values)))


def one_table(sweep: KinematicSweep, owner: str, names: Sequence[str]) -> str:
    """Measures of one owner over the driven values."""
    columns = {f"{name} [{shown(item)[0]}]": shown(item)[1] for name, item in sweep.drives.items()}
    for name in names:
        unit, texts = shown(sweep.measures[f"{owner}.{name}" if owner else name])
        columns[f"{name} [{unit}]"] = texts
    title = f"{owner}\n" if owner else "sensors\n"
    return title + table(list(columns), zip(*columns.values(), strict=True), 0)


def notes(sweep: KinematicSweep, still: Sequence[str]) -> Iterator[str]:
    """What the tables leave out, and how well the loops close."""
    if still:
        yield f"stand still: {', '.join(still)}"
    if sweep.undriven:
        yield f"driven by nothing, smallest motion taken: {', '.join(sweep.undriven)}"
    yield f"loops close to {float(np.max(sweep.residuals)):.0e} m"


def write_kinematics(path: Path, sweep: KinematicSweep) -> None:
    """Driven values and all measures as CSV: SI units and radians, full precision."""
    columns = {**sweep.drives, **sweep.measures}
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([f"{name} [{item.unit}]" for name, item in columns.items()])
        writer.writerows(zip(*([repr(v) for v in item.values.tolist()] for item in columns.values()), strict=True))


def plot_kinematics(path: Path, sweep: KinematicSweep) -> None:
    """Measures of the wheels and pairs over the first drive that moves, as PNG or SVG."""
    import matplotlib as mpl  # noqa: PLC0415  slow to import

    mpl.use("Agg")
    from matplotlib import pyplot as plt  # noqa: PLC0415

    name = next(name for name, item in sweep.drives.items() if np.ptp(item.values) > 0.0)
    unit, factor, _ = SHOWN[sweep.drives[name].unit]
    x = sweep.drives[name].values * factor
    quantities = ("camber", "toe", "contact_y", "roll_centre_height")
    figure, grid = plt.subplots(2, 2, figsize=(9.0, 6.0), layout="constrained")
    for axes, quantity in zip(grid.flat, quantities, strict=True):
        label = quantity
        for key, item in sweep.measures.items():
            owner, _, own = key.rpartition(".")
            if own == quantity and np.any(np.abs(item.values[np.isfinite(item.values)]) > STILL):
                own_unit, own_factor, _ = SHOWN[item.unit]
                label = f"{quantity} [{own_unit}]"
                axes.plot(x, item.values * own_factor, label=owner)
        axes.set(xlabel=f"{name} [{unit}]", ylabel=label)
        axes.grid(alpha=0.3)
        if axes.lines:
            axes.legend(fontsize="small")
    figure.suptitle(sweep.vehicle.name)
    save(figure, path)
    plt.close(figure)
