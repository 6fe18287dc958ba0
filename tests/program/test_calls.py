"""Plain functions as machine code: called for cases, they do what Python does, and are kept without their compiler."""

import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from eom.program.calls import Calls, Each
from eom.program.compiled import without_compiler
from eom.program.make import ready

Array = NDArray[np.float64]
CASES = 4
USE = """
import sys
from tests.program.test_calls import called
print(called()[0].tolist(), "numba" in sys.modules)
"""


def worked(times: int, twice: bool, factor: float, values: Any, table: Any, wanted: Any, counts: Any) -> int:
    """Change values by a table, where they are wanted, and count."""
    for _ in range(times):
        for i in range(len(values)):
            if wanted[i]:
                counts[i] += 1
                for j in range(table.shape[1]):
                    values[i] += factor * table[i, j] * (2.0 if twice else 1.0)
    return int(counts[0])


def called(cases: Any = range(CASES)) -> tuple[NDArray[np.int64], Array, NDArray[np.int64]]:
    """Results, values and counts after calls of some cases, each with numbers and arrays of its own."""
    rng = np.random.default_rng(0)
    values, counts = rng.normal(size=(CASES, 3)), np.zeros((CASES, 3), dtype=np.int64)
    calls = Calls(
        worked,
        CASES,
        {
            "times": Each(np.arange(1, CASES + 1)),
            "twice": False,
            "factor": 1.0,
            "values": Each(values),
            "table": rng.normal(size=(3, 2)),
            "wanted": np.array([True, False, True]),
            "counts": Each(counts),
        },
    )
    calls.set("factor", Each(np.linspace(0.1, 0.4, CASES)))
    calls.set("twice", value=True)
    calls(np.array(cases))
    return calls.results, values, counts


def test_compiled_calls_do_what_python_does() -> None:
    """A product and a sum may be one instruction, so to a unit in the last place of numbers below ten."""
    pytest.importorskip("numba")
    with without_compiler():
        results, values, counts = called()
    found = called()
    assert results.tolist() == found[0].tolist() == [1, 2, 3, 4]
    np.testing.assert_allclose(found[1], values, rtol=0.0, atol=1e-14)
    assert np.array_equal(found[2], counts)


@pytest.mark.parametrize("compiled", [True, False])
def test_cases_that_are_not_called_stay_as_they_are(compiled: bool) -> None:
    untouched = called([])[1]
    if compiled:
        results, values, _ = called([2, 1])
    else:
        with without_compiler():
            results, values, _ = called([2, 1])
    assert results.tolist() == [0, 2, 3, 0]
    assert np.array_equal(values[[0, 3]], untouched[[0, 3]])
    assert not np.any(values[[1, 2]][:, 0] == untouched[[1, 2]][:, 0])


@pytest.mark.parametrize(
    "values", [np.zeros((3, 2))[:, 0], np.zeros(3, dtype=np.float32), np.zeros((3, 1)), np.zeros(3, dtype=np.int64)]
)
def test_an_array_of_another_kind_or_with_elements_apart_is_refused(values: Array) -> None:
    pytest.importorskip("numba")
    flags, counts = np.ones(3, dtype=bool), np.zeros(3, dtype=np.int64)
    arguments = {
        "times": 1,
        "twice": False,
        "factor": 1.0,
        "table": np.zeros((3, 2)),
        "wanted": flags,
        "counts": counts,
    }
    before = np.zeros(3)
    calls = Calls(worked, 1, {**arguments, "values": before})
    with pytest.raises(ValueError, match="another kind"):
        calls.set("values", values)
    with pytest.raises(ValueError, match="times: expected a whole number"):
        calls.set("times", 0.5)
    assert calls.arguments["values"] is before
    assert calls.arguments["times"] == 1


def test_what_was_compiled_is_loaded_without_numba() -> None:
    pytest.importorskip("numba")
    results = called()[0].tolist()
    found = subprocess.run([sys.executable, "-c", USE], capture_output=True, check=True, text=True)
    assert found.stdout.strip() == f"{results} False"


TOGETHER = """
from concurrent.futures import ThreadPoolExecutor
from tests.program.test_calls import called
with ThreadPoolExecutor(4) as pool:
    print({tuple(found[0].tolist()) for found in pool.map(lambda _: called(), range(40))})
"""


def test_threads_that_load_code_at_the_same_time_share_it() -> None:
    pytest.importorskip("numba")
    results = tuple(called()[0].tolist())
    for _ in range(3):
        found = subprocess.run([sys.executable, "-c", TOGETHER], capture_output=True, check=True, text=True)
        assert found.stdout.strip() == str({results})


def test_a_program_that_has_run_is_copied_without_its_address() -> None:
    pytest.importorskip("numba")
    first = ready(lambda x, _u, _p: (np.sin(x),), (), 5, 0)
    x = np.linspace(-1.0, 1.0, 5)
    wanted = first.results(x, np.zeros(0), 0)
    with without_compiler():
        first.results(x, np.zeros(0), 0)
    second = pickle.loads(pickle.dumps(first))  # noqa: S301  our own
    assert sorted(vars(second.program)) == ["inputs", "plan", "signature", "states"]
    assert np.array_equal(second.results(x, np.zeros(0), 0), wanted)
