"""Modes as a table, a file of numbers and a picture of their locus."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from eom.model.modes import Modes
from eom.report.table import table

# of the largest root: what rounding makes of a zero
NEGLIGIBLE = 1e-12


def mode_table(modes: Modes) -> str:
    """One line per real root or conjugate pair."""
    lines = []
    largest = float(np.max(np.abs(modes.eigenvalues), initial=0.0))
    for k, value in enumerate(modes.eigenvalues):
        if value.imag < 0.0:
            continue
        lines.append(
            (
                root(value),
                blank(modes.natural_frequency[k], modes.natural_frequency[k] > 0.0),
                blank(modes.damping_ratio[k], np.isfinite(modes.damping_ratio[k])),
                blank(modes.time_constant[k], abs(value.real) > NEGLIGIBLE * largest),
                ", ".join(modes.dominant(k, 1 if value == 0.0 else 2)),
            )
        )
    header = ("root [1/s]", "frequency [Hz]", "damping ratio", "time constant [s]", "mostly")
    rows = table([*header[:4]], [line[:4] for line in lines]).splitlines()
    return "\n".join(
        f"{row}  {text}" for row, text in zip(rows, [header[4], *(line[4] for line in lines)], strict=True)
    )


def root(value: complex) -> str:
    """A root, or a conjugate pair, to a useful number of digits."""
    if value.imag == 0.0:
        return f"{round(value.real, 4) + 0.0:.4f}"
    return f"{round(value.real, 4) + 0.0:.4f} ± {value.imag:.4f}i"


def blank(value: float, shown: bool) -> str:
    """The value if it means something, else nothing."""
    # + 0.0 so that rounding leaves no negative zero
    return f"{round(float(value), 4) + 0.0:.4f}" if shown else "-"


def sweep_table(name: str, unit: str, values: Sequence[float], sweep: Sequence[Modes]) -> str:
    """Per value of the parameter: stability, and the root with the largest real part."""
    lines = []
    for value, modes in zip(values, sweep, strict=True):
        moving = modes.eigenvalues[modes.eigenvalues != 0.0]
        worst = moving[np.argmax(moving.real)] if moving.size else 0j
        damping = -worst.real / abs(worst) if worst.imag else np.nan
        lines.append(
            (
                f"{value:g}",
                "yes" if worst.real < 0.0 else "no",
                root(complex(worst.real, abs(worst.imag))),
                blank(float(damping), bool(np.isfinite(damping))),
            )
        )
    return table((f"{name} [{unit or '-'}]", "stable", "rightmost root [1/s]", "damping ratio"), lines)


def write_sweep(path: Path, name: str, unit: str, values: Iterable[float], sweep: Iterable[Modes]) -> None:
    """All roots of a sweep as CSV: parameter, real and imaginary part, full precision."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([f"{name} [{unit}]", "real [1/s]", "imaginary [1/s]"])
        for value, modes in zip(values, sweep, strict=True):
            writer.writerows((repr(value), repr(z.real), repr(z.imag)) for z in modes.eigenvalues.tolist())


def plot_sweep(path: Path, title: str, label: str, values: Sequence[float], sweep: Sequence[Modes]) -> None:
    """Root locus over the parameter, coloured by its value, as PNG or SVG."""
    import matplotlib as mpl  # noqa: PLC0415  slow to import

    mpl.use("Agg")
    from matplotlib import pyplot as plt  # noqa: PLC0415

    # the exact zeros of cyclic coordinates would look like a stability limit
    roots = [modes.eigenvalues[modes.eigenvalues != 0.0] for modes in sweep]
    colours = np.repeat(values, [len(own) for own in roots])
    every = np.concatenate(roots)
    # fast roots far to the left would hide the ones that matter
    span = 4.0 * float(np.max(np.abs(every.imag), initial=1.0))
    figure, axes = plt.subplots(figsize=(7.0, 5.0), layout="constrained")
    points = axes.scatter(every.real, every.imag, c=colours, s=14, cmap="viridis")
    axes.axvline(0.0, color="0.6", linewidth=0.8)
    hidden = int(np.sum(every.real < -span))
    axes.set_xlim(left=max(float(every.real.min(initial=0.0)), -span) * 1.05 - 0.1)
    note = f" ({hidden} roots left of {-span:.3g} not shown)" if hidden else ""
    axes.set(xlabel=f"real part [1/s]{note}", ylabel="imaginary part [rad/s]", title=title)
    axes.grid(alpha=0.3)
    figure.colorbar(points, label=label)
    figure.savefig(path, dpi=150)
    plt.close(figure)
