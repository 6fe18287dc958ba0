"""Matrices with their labels as files: NumPy's .npz and MATLAB's .mat."""

from pathlib import Path

import numpy as np

from eom.assembly.reduction import full
from eom.model.assembly import Assembly
from eom.model.linear import LinearModel
from eom.model.reformulation import reformulate, tyre_elements

LABELS = ("coordinates", "velocities", "independent", "constraint_rows", "rolling_rows", "elastic_rows", "slip_rows")


def labelled_matrices(assembly: Assembly, model: LinearModel) -> dict[str, np.ndarray]:
    """Every matrix by name, and the names of rows and columns as arrays of text.

    Full coordinates: M, C, K, V over ``coordinates`` (p) and ``velocities`` (w), their parts, J, Jn, H, H_slip with
    their row names, F, G over ``force_inputs``, complements R and L, the descriptor form over ``independent``. Of axles
    with tyres C_unity, C_rest, Theta, A1, A2 of `eom.reformulate`, H_tyre over ``tyre_rows``. State space: ``ss_A`` to
    ``ss_D`` over ``states``, ``inputs``, ``outputs``, each with its units.
    """
    matrices = assembly.matrices._asdict()
    statics = matrices.pop("statics")
    del matrices["reduction"]
    result = {name: full(value) for name, value in matrices.items()}
    result |= {"R": assembly.R, "L": assembly.L}
    result |= {f"descriptor_{name}": value for name, value in assembly.descriptor._asdict().items()}
    result |= {"reactions": statics.reactions, "tensions": statics.tensions}
    result |= {f"ss_{name}": getattr(model, name) for name in "ABCD"}
    if tyre_elements(assembly.system):
        taken = reformulate(assembly)
        result |= {name: getattr(taken, name) for name in ("C_unity", "C_rest", "Theta", "A1", "A2")}
        result |= {"H_tyre": taken.H, "tyre_rows": np.array(taken.rows, dtype=str)}
    result["force_inputs"] = np.array([item.name for item in assembly.system.inputs], dtype=str)
    for name in LABELS:
        result[name] = np.array(getattr(assembly, name), dtype=str)
    for name in ("states", "inputs", "outputs", "state_units", "input_units", "output_units"):
        result[name] = np.array(getattr(model, name), dtype=str)
    return result


def write_npz(assembly: Assembly, model: LinearModel, path: Path) -> None:
    """Write `labelled_matrices` for NumPy."""
    # a keyword of savez is a boolean, which the type of a mapping cannot exclude
    np.savez(path, **labelled_matrices(assembly, model))  # type: ignore[arg-type]


def write_mat(assembly: Assembly, model: LinearModel, path: Path) -> None:
    """Write `labelled_matrices` for MATLAB, texts as cell arrays."""
    from scipy.io import savemat  # noqa: PLC0415  slow to import

    contents = {
        name: value.astype(object).reshape(-1, 1) if value.dtype.kind == "U" else value
        for name, value in labelled_matrices(assembly, model).items()
    }
    # savemat hides the reason why it cannot open a path
    with path.open("wb") as file:
        savemat(file, contents)  # type: ignore[arg-type]  # the stubs know paths alone
