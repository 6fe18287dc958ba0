"""The vectorised Magic Formula against its referee, on random sets with every coefficient non-zero."""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest

from eom.tyre import MagicFormula52, MagicFormula61, relaxation_lengths
from tests.tyre.random_sets import WITHOUT_EFFECT, State, random_set_52, random_set_61, random_states
from tests.tyre.referee_mf import Wrench, book_61, tool_61
from tests.tyre.referee_mf52 import relaxation_52, tool_52
from tests.tyre.referee_mf_forces import book_point, relaxation_61

SEEDS = range(20)


class Form(NamedTuple):
    tyre: Callable[..., Any]
    random_set: Callable[[int], dict[str, float]]
    forces: Callable[..., Wrench]
    relaxation: Callable[..., tuple[float, float]]


FORMS = {
    "tool": Form(MagicFormula61, random_set_61, tool_61, relaxation_61),
    "book": Form(
        partial(MagicFormula61, form="book"), random_set_61, book_61, partial(relaxation_61, point=book_point)
    ),
    "5.2": Form(MagicFormula52, random_set_52, tool_52, relaxation_52),
}


def columns(states: list[State]) -> dict[str, np.ndarray[Any, np.dtype[np.float64]]]:
    """The states as keyword arguments, an array each."""
    return dict(zip(State._fields, np.array(states).T, strict=True))


def scaled(wrenches: Any, states: list[State], radius: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Forces over the load and moments over load times radius, shape (5, states)."""
    loads = np.array([state.Fz for state in states])
    scales: np.ndarray[Any, np.dtype[np.float64]] = loads * np.array([[1.0], [1.0], [radius], [radius], [radius]])
    return np.asarray(wrenches, dtype=np.float64) / scales


@pytest.mark.parametrize("form", FORMS)
def test_forces_and_moments_agree_with_the_referee(form: str) -> None:
    tyre, random_set, forces, _ = FORMS[form]
    for seed in SEEDS:
        coefficients = random_set(seed)
        states, radius = random_states(seed, coefficients["FNOMIN"], 50), coefficients["UNLOADED_RADIUS"]
        found = scaled(tyre(**coefficients).forces(**columns(states)), states, radius)
        expected = scaled(np.transpose([forces(coefficients, *state) for state in states]), states, radius)
        # Some tens of operations, none of which loses digits in these ranges.
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_relaxation_lengths_agree_with_the_referee(form: str) -> None:
    tyre, random_set, _, relaxation = FORMS[form]
    for seed in SEEDS:
        coefficients = random_set(seed)
        for state in random_states(seed, coefficients["FNOMIN"], 10):
            found = relaxation_lengths(tyre(**coefficients), state.Fz, state.gamma)
            assert tuple(found) == pytest.approx(relaxation(coefficients, state.Fz, state.gamma), rel=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_one_percent_of_any_coefficient_moves_the_tyre_but_for_the_named_ones(form: str) -> None:
    tyre, random_set, _, _ = FORMS[form]
    coefficients = random_set(0)
    states = random_states(0, coefficients["FNOMIN"], 30)
    loads, cambers = (np.array([getattr(state, name) for state in states]) for name in ("Fz", "gamma"))

    def outputs(numbers: dict[str, float]) -> np.ndarray[Any, np.dtype[np.float64]]:
        one = tyre(**numbers)
        lengths = np.broadcast_arrays(*relaxation_lengths(one, loads, cambers), loads)[:2]
        return np.vstack([scaled(one.forces(**columns(states)), states, 0.3), *lengths])

    before = outputs(coefficients)
    still = {
        name
        for name, value in coefficients.items()
        if np.max(np.abs(outputs(coefficients | {name: 1.01 * value}) - before)) < 1e-7
    }
    assert still == WITHOUT_EFFECT[form]
