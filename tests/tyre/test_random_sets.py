"""The random sets hide no coefficient: each one moves what the referee computes."""

from collections.abc import Callable

import pytest

from tests.tyre.random_sets import (
    SCALES_61,
    WITHOUT_EFFECT,
    State,
    random_set_52,
    random_set_61,
    random_states,
)
from tests.tyre.referee_mf import Wrench, book_61, tool_61
from tests.tyre.referee_mf52 import relaxation_52, tool_52
from tests.tyre.referee_mf_forces import Coefficients, relaxation_61

FORMS = {
    "tool": (random_set_61, tool_61, relaxation_61),
    "book": (random_set_61, book_61, relaxation_61),
    "5.2": (random_set_52, tool_52, relaxation_52),
}
VISIBLE = 1e-7
"""Smallest change, relative to load, load times radius or a metre, that counts: 1e5 times what comparisons allow."""


def outputs(
    coefficients: Coefficients,
    states: list[State],
    forces: Callable[..., Wrench],
    relaxation: Callable[..., tuple[float, float]],
) -> list[float]:
    """Forces over the load, moments over load times 0.3 m, and relaxation lengths, of all states."""
    found = []
    for state in states:
        wrench = forces(coefficients, *state)
        scales = (1.0, 1.0, 0.3, 0.3, 0.3)
        found += [value / state.Fz / scale for value, scale in zip(wrench, scales, strict=True)]
        found += relaxation(coefficients, state.Fz, state.gamma)
    return found


@pytest.mark.parametrize("form", FORMS)
def test_one_percent_of_any_coefficient_moves_an_output_but_for_the_named_ones(form: str) -> None:
    random_set, forces, relaxation = FORMS[form]
    for seed in range(4):
        coefficients = random_set(seed)
        states = random_states(seed, coefficients["FNOMIN"], 30)
        before = outputs(coefficients, states, forces, relaxation)
        still = set()
        for name in coefficients:
            changed = outputs(coefficients | {name: 1.01 * coefficients[name]}, states, forces, relaxation)
            if max(abs(new - old) for new, old in zip(changed, before, strict=True)) < VISIBLE:
                still.add(name)
        assert still == WITHOUT_EFFECT[form], f"seed {seed}"


def test_no_coefficient_is_zero_and_no_scale_is_one() -> None:
    for seed in range(50):
        for numbers in (random_set_61(seed), random_set_52(seed)):
            assert all(value != 0 for value in numbers.values())
            assert all(abs(numbers[name] - 1) > 0.04 for name in SCALES_61)


def test_the_same_seed_gives_the_same_set_and_another_gives_another() -> None:
    assert random_set_61(3) == random_set_61(3)
    assert random_set_61(3) != random_set_61(4)
