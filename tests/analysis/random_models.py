"""Linear models of given or random matrices, to try laws of their analysis on."""

import numpy as np
from hypothesis import strategies as st

import eom
from eom.analysis.signals import indices

Array = np.ndarray


def model_of(A: Array, B: Array, C: Array, D: Array | None = None, cyclic: tuple[int, ...] = ()) -> eom.LinearModel:
    """Matrices with names; the columns of A of *cyclic* states must be zero but for these states themselves."""
    n, m, k = len(A), np.shape(B)[1], len(C)
    through = np.zeros((k, m)) if D is None else np.asarray(D, dtype=float)
    matrices = (np.asarray(A, dtype=float), np.asarray(B, dtype=float), np.asarray(C, dtype=float), through)
    return eom.LinearModel(
        *matrices,
        states=tuple(f"x{j}" for j in range(n)),
        inputs=tuple(f"u{j}" for j in range(m)),
        outputs=tuple(f"y{j}" for j in range(k)),
        state_units=("m",) * n,
        input_units=("N",) * m,
        output_units=("m",) * k,
        cyclic=cyclic,
        name="random",
        speed=0.0,
        bodies=(),
        centres=np.zeros((0, 3)),
        motion=np.zeros((0, n)),
    )


def settled(rng: np.random.Generator, n: int) -> Array:
    """A random matrix whose roots decay with real parts of 0.2 or more."""
    A = rng.normal(size=(n, n))
    return np.asarray(A - (np.max(np.linalg.eigvals(A).real, initial=-1.0) + 0.2) * np.eye(n))


@st.composite
def stable_models(draw: st.DrawFn, largest: int = 7, through: bool = True) -> eom.LinearModel:
    """Stable models of one to *largest* states and up to three inputs and outputs."""
    n, m, k = draw(st.integers(1, largest)), draw(st.integers(1, 3)), draw(st.integers(1, 3))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    D = rng.normal(size=(k, m)) * draw(st.sampled_from([0.0, 1.0])) if through else np.zeros((k, m))
    return model_of(settled(rng, n), rng.normal(size=(n, m)), rng.normal(size=(k, n)), D)


@st.composite
def drifting_models(draw: st.DrawFn) -> eom.LinearModel:
    """Stable models with one or two cyclic states in front, the first of which drifts by the second."""
    inner = draw(stable_models(largest=5))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    c, n = draw(st.integers(1, 2)), len(inner.A)
    N = np.triu(rng.normal(size=(c, c)), 1)
    A = np.block([[N, rng.normal(size=(c, n))], [np.zeros((n, c)), inner.A]])
    B = np.vstack([rng.normal(size=(c, inner.B.shape[1])), inner.B])
    C = np.hstack([rng.normal(size=(len(inner.C), c)) * rng.integers(0, 2, size=(len(inner.C), 1)), inner.C])
    return model_of(A, B, C, inner.D, tuple(range(c)))


def part(model: eom.LinearModel, source: str, output: str) -> tuple[Array, Array, Array, Array]:
    """Matrices between one input and one output."""
    (column,), (row,) = indices(model, [source], [output])
    return model.A, model.B[:, [column]], model.C[[row]], model.D[np.ix_([row], [column])]
