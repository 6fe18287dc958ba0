"""The compiled equations of vehicles with wheels are those that NumPy runs, outputs and limits included."""

import numpy as np
import pytest

from eom.model.tyre import build_tyre_model
from tests.vehicles.shipped import WHEELED, vehicle

pytest.importorskip("numba")
# rates of spins are differences of torques of some kN m over 10 kg m^2, sums are taken in another order
NEAR = 1e-11
FAR = 1e-11


@pytest.mark.parametrize("name", WHEELED)
def test_compiled_equations_are_those_of_numpy_at_random_states(name: str) -> None:
    model = build_tyre_model(vehicle(name))
    run, rng = model.trim(), np.random.default_rng(7)
    for size, same in ((0.0, NEAR), (1e-3, NEAR), (1e-2, NEAR), (0.1, FAR)):
        expected, found = [], []
        for _ in range(4):
            x = run.x + size * rng.normal(size=len(run.x)) * (1.0 + np.abs(run.x))
            u = run.u + size * rng.normal(size=len(run.u))
            expected.append(np.concatenate((model.rhs(0.0, x, u), model.margins(x, u), model.output(0.0, x, u))))
            found.append(model.program.results(x, u, 2))
        scale = np.maximum(1.0, np.max(np.abs(expected), axis=0))
        np.testing.assert_array_less(np.abs(np.array(found) - expected) / scale, same)


def test_vehicles_of_one_structure_share_their_code() -> None:
    first = build_tyre_model(vehicle("b_train"))
    second = build_tyre_model(first.vehicle.with_values(**{"tractor_frame.mass": 7000.0}))
    assert first.program.program is second.program.program
    assert not np.array_equal(first.program.parameters, second.program.parameters)


def test_levels_are_parts_of_the_same_results() -> None:
    model = build_tyre_model(vehicle("b_train"))
    x, u = model.trim()
    every = model.program.results(x, u, 2)
    for level, count in ((0, len(model.states)), (1, len(model.states) + len(model.limits))):
        assert np.array_equal(model.program.results(x, u, level), every[:count])
