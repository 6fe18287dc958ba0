"""Modes as tables and a file of numbers."""

import csv
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from eom.assembly.matrices import DISPLACEMENTS
from eom.model.modes import Modes
from eom.report.table import table

# of the largest root: what rounding makes of a zero
NEGLIGIBLE = 1e-12
# of a mode's largest motion: smaller ones have no digit to show
SEEN = 5e-4


def listed(modes: Modes) -> list[int]:
    """The modes that tables name: each conjugate pair once."""
    return [k for k, value in enumerate(modes.eigenvalues) if value.imag >= 0.0]


def mode_table(modes: Modes) -> str:
    """One line per real root or conjugate pair."""
    lines = []
    largest = float(np.max(np.abs(modes.eigenvalues), initial=0.0))
    for k in listed(modes):
        value = modes.eigenvalues[k]
        lines.append(
            (
                root(value),
                blank(modes.natural_frequency[k], modes.natural_frequency[k] > 0.0),
                blank(modes.damping_ratio[k], np.isfinite(modes.damping_ratio[k])),
                blank(modes.time_constant[k], abs(value.real) > NEGLIGIBLE * largest),
                blank(modes.wavelength[k], np.isfinite(modes.wavelength[k])),
                ", ".join(modes.dominant(k, 1 if value == 0.0 else 2)),
            )
        )
    header = ("root [1/s]", "frequency [Hz]", "damping ratio", "time constant [s]", "wavelength [m]", "mostly")
    rows = table(header[:5], [line[:5] for line in lines]).splitlines()
    return "\n".join(
        f"{row}  {text}" for row, text in zip(rows, [header[5], *(line[5] for line in lines)], strict=True)
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


def shape_tables(modes: Modes) -> str:
    """Per real root or pair: size and phase of the motion of each body that moves, and the point it turns about."""
    return "\n\n".join(shape_table(modes, k) for k in listed(modes))


def shape_table(modes: Modes, mode: int) -> str:
    """One mode; components and bodies that do not move, to three digits, are left out."""
    shape = modes.shapes[:, :, mode]
    seen: NDArray[np.bool_] = np.abs(shape) >= SEEN
    columns, rows = np.flatnonzero(seen.any(axis=0)), np.flatnonzero(seen.any(axis=1))
    title = f"mode {mode + 1}: {root(modes.eigenvalues[mode])} 1/s"
    if not rows.size:
        return f"{title}\nno body leaves its place"
    points, axes = (values[:, :, mode] for values in modes.instant_centres())
    units = ["m" if k < 3 else "rad" for k in columns]
    header = [f"{DISPLACEMENTS[k]} [{unit}]" for k, unit in zip(columns, units, strict=True)]
    turning: NDArray[np.bool_] = np.any(seen[:, 3:], axis=1)
    lines = [
        (
            modes.bodies[k],
            *(phasor(complex(value)) for value in shape[k, columns]),
            vector(points[k].real) if turning[k] else "-",
            blank(float(np.linalg.norm(points[k].imag)), bool(turning[k])),
            vector(axes[k].real) if turning[k] else "-",
        )
        for k in rows
    ]
    return f"{title}\n{table(('body', *header, 'turns about [m]', 'wanders [m]', 'axis'), lines)}"


def phasor(value: complex) -> str:
    """Size and phase in degrees."""
    if abs(value) < SEEN:
        return "-"
    phase = round(float(np.degrees(np.angle(value))))
    return f"{abs(value):.3f} at {180 if phase == -180 else phase:4d}°"


def vector(values: np.ndarray) -> str:
    """Three numbers."""
    return "(" + ", ".join(f"{round(float(value), 3) + 0.0:.3f}" for value in values) + ")"


def write_modes(path: Path, modes: Modes) -> None:
    """All modes as CSV at full precision, one a line: figures, shares of the states, motion of the bodies."""
    motions = [f"{body}.{name}" for body in modes.bodies for name in DISPLACEMENTS]
    header = ["real [1/s]", "imaginary [1/s]", "frequency [Hz]", "damping ratio", "time constant [s]", "wavelength [m]"]
    header += [f"participation of {name}" for name in modes.states]
    header += [f"{name} {part}" for name in motions for part in ("real", "imaginary")]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows([repr(value) for value in line] for line in numbers(modes))


def numbers(modes: Modes) -> Iterator[list[float]]:
    """What `write_modes` writes, mode by mode."""
    figures = (modes.natural_frequency, modes.damping_ratio, modes.time_constant, modes.wavelength)
    for k, value in enumerate(modes.eigenvalues.tolist()):
        shape = modes.shapes[:, :, k].ravel()
        yield [
            value.real,
            value.imag,
            *(float(figure[k]) for figure in figures),
            *modes.participation[:, k].tolist(),
            *np.column_stack([shape.real, shape.imag]).ravel().tolist(),
        ]
