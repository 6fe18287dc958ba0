"""Controllability and observability of modes against rank tests and systems whose answer is built in."""

import control
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import eom
from eom.analysis import modal_reach
from eom.analysis.reach import NOTHING
from tests.analysis.random_models import drifting_models, model_of, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import NAMES, vehicle

Array = np.ndarray
RANDOM = settings(max_examples=40, deadline=None, phases=PHASES)


@RANDOM
@given(st.integers(2, 5), st.integers(0, 2**32 - 1), st.data())
def test_the_modes_out_of_reach_are_those_built_so(n: int, seed: int, data: st.DataObject) -> None:
    """Real modes with distinct roots, in mixed coordinates; some without a share of the input or the output."""
    rng = np.random.default_rng(seed)
    roots = -np.cumsum(rng.uniform(0.3, 1.0, n))
    moved = np.array(data.draw(st.lists(st.booleans(), min_size=n, max_size=n)))
    seen = np.array(data.draw(st.lists(st.booleans(), min_size=n, max_size=n)))
    T = np.linalg.qr(rng.normal(size=(n, n)))[0] * rng.uniform(0.5, 2.0, n)
    b, c = moved * rng.uniform(0.5, 1.0, n), seen * rng.uniform(0.5, 1.0, n)
    model = model_of(T @ np.diag(roots) @ np.linalg.inv(T), (T @ b)[:, np.newaxis], (c @ np.linalg.inv(T))[np.newaxis])
    reach = modal_reach(model)
    # the slowest mode first, as the roots were made
    assert reach.eigenvalues.real == pytest.approx(roots, rel=1e-9)
    assert [root for root, _ in reach.unmoved()] == pytest.approx(roots[~moved], rel=1e-9)
    assert [root for root, _ in reach.unseen()] == pytest.approx(roots[~seen], rel=1e-9)
    # the cosine is zero where the distance is, and the other way round
    assert np.array_equal(reach.controllability[:, 0] < 1e-9, ~moved)
    assert np.array_equal(reach.observability[:, 0] < 1e-9, ~seen)


@RANDOM
@given(stable_models(largest=4))
def test_an_input_moves_all_modes_where_the_controllability_matrix_has_full_rank(model: eom.LinearModel) -> None:
    reach = modal_reach(model)
    for k in range(len(model.inputs)):
        # powers up to A^3 of entries of a few units: a well conditioned matrix is far from both rules' limits
        values = np.linalg.svd(control.ctrb(model.A, model.B[:, [k]]), compute_uv=False)
        assume(values[-1] > 1e-6 * values[0])
        assert np.all(reach.input_distance[:, k] > NOTHING)
    for k in range(len(model.outputs)):
        values = np.linalg.svd(control.obsv(model.A, model.C[[k]]), compute_uv=False)
        assume(values[-1] > 1e-6 * values[0])
        assert np.all(reach.output_distance[:, k] > NOTHING)


@RANDOM
@given(drifting_models())
def test_a_mode_is_seen_through_cyclic_states_as_its_full_eigenvector_is(model: eom.LinearModel) -> None:
    reach = modal_reach(model)
    values, vectors = np.linalg.eig(model.A)
    for k, root in enumerate(reach.eigenvalues):
        mode = vectors[:, int(np.argmin(np.abs(values - root)))]
        seen = np.abs(model.C @ mode)
        # proportional but for the lengths of the rows: zero together, to rounding
        assert np.array_equal(reach.observability[k] < 1e-9, seen < 1e-9 * np.linalg.norm(model.C, axis=1))


@pytest.mark.parametrize("name", NAMES)
def test_an_input_with_a_share_in_a_mode_is_not_told_to_be_out_of_reach(name: str) -> None:
    """By the rows of the eigenvectors' inverse, for modes whose root stands alone."""
    model = eom.linearise(vehicle(name))
    reach = modal_reach(model)
    reduced = model.without_cyclic()
    values, vectors = np.linalg.eig(reduced.A)
    left = np.linalg.pinv(vectors)
    for k, root in enumerate(reach.eigenvalues):
        j = int(np.argmin(np.abs(values - root)))
        if np.sum(np.abs(values - root) < 1e-6 * max(np.abs(values))) > 1:
            continue
        moved = np.abs(left[j] @ reduced.B) / (np.linalg.norm(left[j]) * np.linalg.norm(reduced.B, axis=0))
        for column in range(len(model.inputs)):
            if moved[column] > 1e-6:
                assert reach.controllability[k, column] > NOTHING


def test_steering_a_symmetric_car_moves_none_of_its_ride() -> None:
    model = eom.linearise(vehicle("double_wishbone_car"))
    reach = modal_reach(model)
    modes = model.modes()
    unmoved = {root for root, source in reach.unmoved() if source == "rack_travel"}
    rides = [
        complex(root)
        for root, participation in zip(modes.eigenvalues, modes.participation.T, strict=True)
        if root.imag >= 0.0 and participation[model.states.index("chassis.v_z")] > 0.05
    ]
    assert rides
    assert set(rides) <= unmoved
    # and heave sees none of the lateral modes, which yaw sees
    blind = {root for root, output in reach.unseen() if output == "heave"}
    lateral = reach.observability[:, model.outputs.index("yaw_rate")] > 1e-6
    assert lateral.any()
    assert set(map(complex, reach.eigenvalues[lateral])) <= blind
