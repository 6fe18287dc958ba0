"""The compiled equations of vehicles with wheels are those that NumPy runs."""

import numpy as np
import pytest

from eom.model.tyre import build_tyre_model
from eom.splice.compiled import compile_rates
from tests.vehicles.shipped import WHEELED, vehicle

pytest.importorskip("numba")
# elementary functions of tyre formulas differ by a few units in the last place
NEAR = 1e-12
# far from the trim the loads' step counts, in which forces are differences by 1e-6 of the load: they keep so much less
FAR = 1e-10


@pytest.mark.parametrize("name", WHEELED)
def test_compiled_rates_are_those_of_numpy_at_random_states(name: str) -> None:
    model = build_tyre_model(vehicle(name))
    compiled = compile_rates(model.numbers)
    run, rng = model.trim(), np.random.default_rng(7)
    for size, same in ((0.0, NEAR), (1e-3, NEAR), (1e-2, NEAR), (0.1, FAR)):
        expected, found = [], []
        for _ in range(4):
            x = run.x + size * rng.normal(size=len(run.x)) * (1.0 + np.abs(run.x))
            u = run.u + size * rng.normal(size=len(run.u))
            expected.append(model.rhs(0.0, x, u))
            found.append(compiled.rates(x, u, compiled.numbers))
        scale = np.maximum(1.0, np.max(np.abs(expected), axis=0))
        np.testing.assert_array_less(np.abs(np.array(found) - expected) / scale, same)


def test_models_with_the_same_formulas_share_their_code() -> None:
    first, second = (build_tyre_model(vehicle(name)).numbers for name in ("b_train", "tractor_semitrailer"))
    assert compile_rates(first).rates is compile_rates(second).rates
