"""Functions over lanes: what is zero in all lanes takes no part, what does not vary is done beforehand."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import solve

from eom.program.call import Lane
from eom.program.make import ready
from eom.program.numbers import gathered
from eom.program.operations import Op
from eom.program.plain import OverCases, arrays_code, numbers_code, of_numbers
from eom.program.plan import Plan, planned, traced
from eom.splice.lanes import solve_positive

Array = NDArray[np.float64]
LANES = 5


@dataclass(frozen=True)
class Curve:
    """A curve of two arguments with three coefficients a lane."""

    a: Array
    b: Array
    c: Array

    @property
    def formula(self) -> Callable[..., tuple[Any, ...]]:
        """The equation."""
        return curve


def curve(p: Any, x: Any, y: Any) -> tuple[Any, ...]:
    """Three results: of all, of an argument alone, and of no argument."""
    return np.arctan(p.a * x) / (2.0 + p.b * p.b) + p.c * y, p.b * y, p.a * p.c + 0.0 * x


def over_lanes(x: Any, _u: Any, numbers: Any) -> tuple[Any]:
    """The curve in all lanes."""
    (own,) = numbers
    arguments = list(x.reshape(2, -1))
    return (np.ravel(x.over_lanes(own.formula, own, arguments)),)


def plan_of(own: Curve) -> Plan:
    """The plan of a curve over lanes."""
    return planned(*traced(over_lanes, gathered([(own,)]), 2 * LANES, 0))


def operations(plan: Plan) -> list[Op]:
    """What is done in a lane."""
    lanes: list[Lane] = [launch.call.lane for stage in plan.launches for launch in stage]
    return [Op(op) for lane in lanes for op, *_ in lane.ops if op not in {Op.CONST, Op.PARAMETER, Op.INPUT}]


values = st.sampled_from((0.0, 1.0, -1.0)) | st.floats(-2.0, 2.0)
rows = st.lists(values, min_size=LANES, max_size=LANES).map(np.array)


@given(a=rows, b=rows, c=rows, x=st.lists(st.floats(-3.0, 3.0), min_size=2 * LANES, max_size=2 * LANES))
def test_lanes_give_what_numpy_gives_whatever_is_zero_or_one(a: Array, b: Array, c: Array, x: list[float]) -> None:
    """To rounding of the results, whose terms are below ten: a quotient is a product with a reciprocal."""
    own = Curve(a, b, c)
    plan = plan_of(own)
    parameters = plan.parameter_values(gathered([(own,)]))
    wanted = np.ravel(curve(own, *np.array(x).reshape(2, -1)))
    found = of_numbers(plan, numbers_code(plan), parameters[:, 0])(x, [], 0)
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-14)
    cases = OverCases(plan, arrays_code(plan), np.repeat(parameters, 3, axis=1))
    found = cases(np.repeat(np.array(x)[:, np.newaxis], 3, axis=1), np.empty((0, 3)), 0)
    np.testing.assert_allclose(found, np.repeat(wanted[:, np.newaxis], 3, axis=1), rtol=0.0, atol=1e-14)


def test_a_coefficient_that_is_zero_in_all_lanes_takes_no_part() -> None:
    some = np.linspace(0.3, 0.7, LANES)
    assert Op.ARCTAN in operations(plan_of(Curve(some, some, some)))
    left = operations(plan_of(Curve(np.zeros(LANES), some, some)))
    assert sorted(left) == [Op.MUL, Op.MUL]


def test_a_coefficient_that_is_zero_in_one_lane_stays() -> None:
    some = np.linspace(0.0, 0.7, LANES)
    assert Op.ARCTAN in operations(plan_of(Curve(some, some, some)))


def test_what_does_not_vary_is_done_beforehand_and_divides_nothing() -> None:
    """What is left: a x, arctan, times a reciprocal, c y, their sum, b y."""
    some = np.linspace(0.3, 0.7, LANES)
    found = operations(plan_of(Curve(some, some, some)))
    assert sorted(found) == sorted([Op.MUL, Op.ARCTAN, Op.MUL, Op.MUL, Op.ADD, Op.MUL])


def test_cases_that_share_their_parameters_and_cases_that_do_not_give_the_same_bits() -> None:
    """Of a batch, the first case has the same parameters in both, the others have not."""
    own = [Curve(*(np.linspace(0.3, 0.7, LANES) + shift for _ in range(3))) for shift in (0.0, 0.1, 0.2)]
    plan = planned(*traced(over_lanes, gathered([(item,) for item in own]), 2 * LANES, 0))
    code, x = arrays_code(plan), np.repeat(np.linspace(-1.0, 1.0, 2 * LANES)[:, np.newaxis], 3, axis=1)
    apart = plan.parameter_values(gathered([(item,) for item in own]))
    same = np.repeat(apart[:, :1], 3, axis=1)
    found = [OverCases(plan, code, parameters)(x, np.empty((0, 3)), 0) for parameters in (apart, same)]
    assert np.array_equal(found[0][:, 0], found[1][:, 0])
    assert np.array_equal(found[1], np.repeat(found[1][:, :1], 3, axis=1))
    assert not np.array_equal(found[0][:, 1], found[1][:, 1])


def solution(x: Any, _u: Any, numbers: Any) -> tuple[Any]:
    """Of a system whose matrix and right side vary."""
    (matrix,) = numbers
    return (solve_positive(x[0] * matrix, x[1:]),)


@given(seed=st.integers(0, 10**6), size=st.integers(1, 9), share=st.floats(0.0, 1.0))
def test_a_positive_definite_system_is_solved_as_scipy_solves_it(seed: int, size: int, share: float) -> None:
    """Whatever is zero in its matrix; to rounding times the matrix's condition, which is below a hundred."""
    rng = np.random.default_rng(seed)
    factor = rng.normal(size=(size, size)) * (rng.random((size, size)) < share)
    factor /= max(1.0, float(np.linalg.norm(factor, 2)))
    matrix, x = factor @ factor.T + 0.02 * np.eye(size), rng.normal(size=size + 1)
    x[0] = 1.0 + abs(x[0])
    own = gathered([(matrix,)])
    plan = planned(*traced(solution, own, size + 1, 0))
    found = of_numbers(plan, numbers_code(plan), plan.parameter_values(own)[:, 0])(x.tolist(), [], 0)
    wanted = solve(x[0] * matrix, x[1:], assume_a="pos")
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-12 * (1.0 + float(np.max(np.abs(wanted)))))


def test_a_star_is_solved_leaf_by_leaf() -> None:
    """Its centre comes first: in that order all leaves would be coupled. So each leaf costs the same."""
    counts = []
    for size in (6, 8, 10):
        matrix = np.eye(size) * 2.5
        matrix[0, 1:] = matrix[1:, 0] = 0.3
        plan = planned(*traced(solution, gathered([(matrix,)]), size + 1, 0))
        counts.append(sum(len(places) for stage in plan.stages for places in stage))
    assert counts[2] - counts[1] == counts[1] - counts[0]


def test_calls_of_one_function_at_two_levels_are_computed_when_they_are_wanted() -> None:
    """What only the second level wants has arguments that the first one does not know."""

    def both(x: Any, _u: Any, _p: Any) -> tuple[Any, Any]:
        return np.sin(x[:4]), np.sin(1.0 + 2.0 * x)

    own = gathered([()])
    plan = planned(*traced(both, own, 5, 0))
    x = np.linspace(-1.0, 1.0, 5)
    wanted = np.concatenate(both(x, None, None))
    parameters = plan.parameter_values(own)
    for level, count in ((0, 4), (1, 9)):
        found = of_numbers(plan, numbers_code(plan), parameters[:, 0])(x.tolist(), [], level)
        cases = OverCases(plan, arrays_code(plan), np.repeat(parameters, 2, axis=1))
        lanes = cases(np.stack([x, x], axis=1), np.empty((0, 2)), level)
        np.testing.assert_allclose(found, wanted[:count], rtol=0.0, atol=1e-15)
        np.testing.assert_allclose(lanes, np.stack([wanted[:count]] * 2, axis=1), rtol=0.0, atol=1e-15)


def guarded(p: Any, x: Any, y: Any) -> tuple[Any, ...]:
    """A quotient and a logarithm where there is something to divide by."""
    return np.where(p.a > 0.5, y + x / p.a + np.log(p.a) * x, x + y + p.b), p.c * x


def asked(p: Any, x: Any, y: Any) -> tuple[Any, ...]:
    """A branch on what lanes may differ in."""
    return np.where(p.a == 1.0, x, y), p.c * p.b * x


class Other(Curve):
    """With an equation of its own."""

    formula = property(lambda _: guarded)


class Asking(Curve):
    """With one that asks."""

    formula = property(lambda _: asked)


@pytest.mark.parametrize("a", [np.array([0.3, 0.7, 0.0, 0.6, -0.7]), np.zeros(LANES)])
def test_a_quotient_that_is_not_taken_may_be_by_zero(a: Array) -> None:
    some, x = np.linspace(0.3, 0.7, LANES), np.linspace(-1.0, 1.0, 2 * LANES)
    own = gathered([(Other(a, some, some),)])
    plan = planned(*traced(over_lanes, own, 2 * LANES, 0))
    program = of_numbers(plan, numbers_code(plan), plan.parameter_values(own)[:, 0])
    with np.errstate(all="ignore"):
        found = program(x.tolist(), [], 0)
        wanted = np.ravel(guarded(Other(a, some, some), *x.reshape(2, -1)))
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-14)


def test_a_branch_on_a_coefficient_that_is_one_in_some_lanes_is_refused() -> None:
    some = np.array([0.3, 1.0, 0.5, 0.6, 0.7])
    with pytest.raises(TypeError, match="a branch on a number"):
        plan_of(Asking(some, some, some))


def test_a_program_refuses_vectors_of_other_lengths() -> None:
    made = ready(lambda x, u, _p: (x * u[0],), (), 3, 1)
    for x, u in ((np.zeros(2), np.zeros(1)), (np.zeros(3), np.zeros(2)), (np.zeros(4), np.zeros(0))):
        with pytest.raises(ValueError, match=f"expected 3 states and 1 inputs, got {len(x)} and {len(u)}"):
            made.results(x, u, 0)
