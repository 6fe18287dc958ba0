"""Programs: what is written down on the tape is what NumPy computes, compiled, in plain Python, and over cases."""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from eom.program import compiled, make
from eom.program.make import Ready, program, ready
from eom.program.numbers import gathered
from eom.program.operations import Op
from eom.program.plain import OverCases, arrays_code, numbers_code, of_numbers
from eom.program.plan import Plan, planned, traced
from eom.program.tape import Node, Tape

Array = NDArray[np.float64]
Function = Callable[[Any, Any, Any], Sequence[Any]]
N, M = 4, 2
ULPS = 1e-12
"""Sums are taken in another order, elementary functions differ in the last places."""


def plan_of(function: Function, numbers: Any = (), states: int = N, inputs: int = M) -> Plan:
    """The plan of a function, from no cache."""
    return planned(*traced(function, gathered([numbers]), states, inputs))


def in_python(plan: Plan, x: Array, u: Array, parameters: Array, level: int = 0) -> Array:
    """Results in plain Python."""
    return of_numbers(plan, numbers_code(plan), parameters)(x.tolist(), u.tolist(), level)


def in_lanes(plan: Plan, x: Array, u: Array, parameters: Array, level: int = 0) -> Array:
    """Results over cases, (results, cases)."""
    return OverCases(plan, arrays_code(plan), parameters)(x, u, level)


def assert_near(found: Any, wanted: Any, size: float = 1.0) -> None:
    """Equal to rounding over the size of what they are made of."""
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    assert found.shape == wanted.shape
    np.testing.assert_array_less(np.abs(found - wanted), ULPS * (size + np.abs(wanted)))


# expressions: functions of the vectors x, u and of numbers p, which keep their size of one or so

Expression = Callable[[Any, Any, Any], Any]


def joined(*parts: Any) -> Any:
    """Parts one after the other, put into an array of what they are together."""
    result = np.zeros(N) + sum(0.0 * part[:1] for part in parts)
    begin = 0
    for part in parts:
        result[begin : begin + len(part)] = part
        begin += len(part)
    return result


P = (0.7, np.array([1.5, -0.4, 0.0, 2.5]), np.array([[1.0, 0.0, 0.3, 0.0], [0.0, -1.0, 0.0, 2.0]]))
LEAVES: dict[str, Expression] = {
    "x": lambda x, _u, _p: x,
    "p1": lambda _x, _u, p: p[1],
    "p0": lambda x, _u, p: p[0] + 0.0 * x,
    "u": lambda _x, u, _p: joined(u, u),
    "0": lambda _x, _u, _p: np.zeros(N),
    "1": lambda _x, _u, _p: np.ones(N),
    "2.5": lambda _x, _u, _p: np.full(N, 2.5),
    "P x": lambda x, _u, p: joined(p[2] @ x, x[:2]),
}


def assigned(a: Any, b: Any) -> Any:
    """Parts of one put into the other, in place and by index."""
    result = a + 0.0 * b
    result[1:3] = b[:2]
    result[-1] = a[0] - b[0]
    result[[0, 2]] += b[[3, 1]]
    return result


ONE: dict[str, Callable[[Any], Any]] = {
    "-": lambda a: -a,
    "sin": np.sin,
    "cos": np.cos,
    "arctan": np.arctan,
    "sin of one": lambda a: joined(np.sin(a[:1]), a[1:2], np.cos(a[2:3]), a[3:]),
    "abs": np.abs,
    "sqrt": lambda a: np.sqrt(np.abs(a) + 0.5),
    "exp": lambda a: np.exp(-np.abs(a)),
    "turned": lambda a: a[::-1],
    "reshaped": lambda a: a.reshape(2, 2).T.reshape(-1),
    "summed": lambda a: a - 0.25 * np.sum(a),
    "columns": lambda a: joined(np.sum(a.reshape(2, 2), axis=0), np.sum(a.reshape(2, 2), axis=1)) / 2.0,
    "spread": lambda a: (a[:, np.newaxis] * a[np.newaxis, :])[1] / (1.0 + np.abs(a)),
}
TWO: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / (1.0 + np.abs(b)),
    "maximum": np.maximum,
    "minimum": np.minimum,
    "copysign": lambda a, b: np.copysign(a, b + 1e-3),
    "where <": lambda a, b: np.where(a < b, a, 2.0 * b),
    "where >": lambda a, b: np.where(a > 0.1, b, 0.0),
    "matmul": lambda a, b: joined(a.reshape(2, 2) @ b[:2], b.reshape(2, 2) @ a.reshape(2, 2)[:, 0]) / 4.0,
    "dot": lambda a, b: (a @ b) * np.ones(N) / 4.0,
    "assigned": assigned,
}


def grown(inner: st.SearchStrategy[tuple[str, Expression]]) -> st.SearchStrategy[tuple[str, Expression]]:
    """Expressions of expressions."""

    def one(name: str, a: tuple[str, Expression]) -> tuple[str, Expression]:
        return f"{name}({a[0]})", lambda x, u, p: ONE[name](a[1](x, u, p))

    def two(name: str, a: tuple[str, Expression], b: tuple[str, Expression]) -> tuple[str, Expression]:
        return f"({a[0]} {name} {b[0]})", lambda x, u, p: TWO[name](a[1](x, u, p), b[1](x, u, p))

    return st.builds(one, st.sampled_from(sorted(ONE)), inner) | st.builds(
        two, st.sampled_from(sorted(TWO)), inner, inner
    )


EXPRESSIONS = st.recursive(st.sampled_from(sorted(LEAVES.items())), grown, max_leaves=12)


def points(seed: int, count: int) -> tuple[Array, Array]:
    """States and inputs, (N, count) and (M, count); some are the same, so that comparisons are close."""
    rng = np.random.default_rng(seed)
    x, u = rng.normal(size=(N, count)), rng.normal(size=(M, count))
    x[:, 0], u[:, 0] = 0.5, 0.5
    return x, u


def far_from_ties(expression: Expression, x: Array, u: Array) -> bool:
    """Whether NumPy gives nearly the same close by: no comparison that rounding may turn."""
    here = expression(x, u, P)
    near = [expression(x + sign * 1e-11, u - sign * 0.7e-11, P) for sign in (1.0, -1.0)]
    return bool(np.all(np.abs(np.array(near) - here) < 1e-6 * (1.0 + np.abs(here))))


@settings(max_examples=150, report_multiple_bugs=False)
@given(expression=EXPRESSIONS, seed=st.integers(0, 9))
def test_what_is_traced_is_what_numpy_computes_in_python_and_over_cases(
    expression: tuple[str, Expression], seed: int
) -> None:
    own = expression[1]
    found = gathered([P])
    plan = planned(*traced(lambda x, u, p: (own(x, u, p),), found, N, M))
    parameters = plan.parameter_values(found)
    x, u = points(seed, 5)
    lanes = in_lanes(plan, x, u, np.repeat(parameters, 5, axis=1))
    for k in range(5):
        if not far_from_ties(own, x[:, k], u[:, k]):
            continue
        wanted = own(x[:, k], u[:, k], P)
        size = float(np.max(np.abs(wanted)))
        assert_near(in_python(plan, x[:, k], u[:, k], parameters[:, 0]), wanted, 10.0 + size)
        assert_near(lanes[:, k], wanted, 10.0 + size)


def every_expression(x: Any, u: Any, p: Any) -> tuple[Any, Any]:
    """All operations of all leaves, and of each other, on two levels."""
    leaves = [leaf(x, u, p) for leaf in LEAVES.values()]
    ones = [np.concatenate([one(leaf) for leaf in leaves]) for one in ONE.values()]
    twos = [np.concatenate([two(a, b) for a in leaves for b in leaves]) for two in TWO.values()]
    deep = [two(one(np.sin(a)), one(b * 0.3)) for one in ONE.values() for two in TWO.values() for a, b in ((x, p[1]),)]
    return np.concatenate(ones), np.concatenate([*twos, *deep])


@cache
def everything() -> Ready:
    """The program of it."""
    pytest.importorskip("numba")
    return ready(every_expression, P, N, M)


@given(seed=st.integers(1, 10**6), scale=st.sampled_from([1.0, 30.0, 1e-3]))
def test_compiled_is_what_numpy_computes(seed: int, scale: float) -> None:
    own = everything()
    x, u = (scale * item[:, 1] for item in points(seed, 2))
    wanted = np.concatenate(every_expression(x, u, P))
    found = own.results(x, u, 1)
    assert_near(found, wanted, 10.0 * (1.0 + scale) ** 2)
    assert_near(in_python(own.program.plan, x, u, own.parameters, 1), wanted, 10.0 * (1.0 + scale) ** 2)


def test_levels_are_the_first_of_the_same_results() -> None:
    found, x, u = everything(), *(own[:, 1] for own in points(5, 2))
    every, first = found.results(x, u, 1), found.results(x, u, 0)
    assert np.array_equal(every[: len(first)], first)
    plan = found.program.plan
    assert len(first) == len(plan.roots[0])
    assert np.array_equal(
        in_python(plan, x, u, found.parameters, 1)[: len(first)], in_python(plan, x, u, found.parameters, 0)
    )


def joins(x: Any, u: Any, _p: Any) -> tuple[Any]:
    """Joined and stacked arrays, in functions that are no operators."""
    both = np.concatenate((x, u))
    return (np.concatenate((np.maximum(both, 0.1), np.exp(np.stack([x[0], u[1]])), np.where(both < 0.2, both, 1.0))),)


def test_what_is_joined_or_stacked_is_an_array_as_any_other() -> None:
    x, u = (own[:, 1] for own in points(1, 2))
    assert_near(in_python(plan_of(joins), x, u, np.zeros(0)), joins(x, u, None)[0])


def wasted(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    """Four exponentials at once, of which two are wanted."""
    return (np.exp(2.0 * x)[:2],)


def test_results_of_a_call_that_nobody_wants_are_left_out_in_python() -> None:
    x = np.array([0.1, -0.2, 0.3, 0.4])
    wanted = wasted(x, None, None)[0]
    plan = plan_of(wasted, inputs=0)
    assert_near(in_python(plan, x, np.zeros(0), np.zeros(0)), wanted)
    assert_near(in_lanes(plan, x[:, np.newaxis], np.zeros((0, 1)), np.zeros((0, 1)))[:, 0], wanted)


def test_results_of_a_call_that_nobody_wants_are_left_out_in_compiled_code() -> None:
    pytest.importorskip("numba")
    x = np.array([0.1, -0.2, 0.3, 0.4])
    assert_near(ready(wasted, (), N, 0).results(x, np.zeros(0), 0), wasted(x, None, None)[0])


def put(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    """Numbers among what is not known."""
    result = 2.0 * x
    result[1:3] = 0.25, -0.5
    return (np.abs(result) + np.arctan(result),)


def test_numbers_may_be_put_into_an_array_of_what_is_not_known() -> None:
    x = np.array([0.1, -0.2, 0.3, 0.4])
    assert_near(in_python(plan_of(put, inputs=0), x, np.zeros(0), np.zeros(0)), put(x, None, None)[0])


# numbers that are none, and branches that are not taken


def guarded(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    """Quotients and roots that nobody wants, next to a number that is fine, and infinite bounds."""
    safe = np.where(np.abs(x[:2]) > 0.0, 1.0 / x[:2], 0.0)
    root = np.where(x[2:] > 0.0, np.sqrt(x[2:]), -1.0)
    return (np.concatenate((safe, root, np.minimum(x, np.array([np.inf, 0.5, np.inf, 0.5])), 2.0 * x[:1])),)


def test_a_branch_that_is_not_taken_may_be_no_number() -> None:
    plan = plan_of(guarded, inputs=0)
    x = np.array([[0.0, 0.5], [2.0, 0.0], [-1.0, 4.0], [0.25, -3.0]])
    with np.errstate(all="ignore"):
        wanted = np.array([guarded(own, None, None)[0] for own in x.T]).T
        assert_near(in_lanes(plan, x, np.zeros((0, 2)), np.zeros((0, 2))), wanted)
    for k in range(2):
        assert_near(in_python(plan, x[:, k], np.zeros(0), np.zeros(0)), wanted[:, k])


def infinite(x: Any, _u: Any, p: Any) -> tuple[Any]:
    """Bounds that are none."""
    return (np.concatenate((np.minimum(x, p[0]), np.where(x > 0.0, p[1], x), x / p[0])),)


def test_infinite_numbers_are_numbers() -> None:
    numbers = (np.inf, -np.inf)
    plan = plan_of(infinite, numbers, inputs=0)
    x = np.array([1.0, -2.0, 0.0, 3.0])
    wanted = infinite(x, None, numbers)[0]
    assert np.array_equal(in_lanes(plan, x[:, np.newaxis], np.zeros((0, 1)), np.zeros((0, 1)))[:, 0], wanted)
    assert np.array_equal(in_python(plan, x, np.zeros(0), np.zeros(0)), wanted)


# branches


def on_array(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x if np.any(x > 0.0) else 2.0 * x,)


def on_scalar(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x if x[0] > 0.0 else 2.0 * x,)


def on_less(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x if x[0] < 0.0 else 2.0 * x,)


def on_itself(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x if x[0] else 2.0 * x,)


def on_larger(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (max(x[0], x[1]) * x,)


def on_equal_arrays(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x if np.all(x == 0.0) else 2.0 * x,)


def on_equal(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (x + 1.0 if x[0] == 0.0 else 2.0 * x,)


def on_unequal(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (2.0 * x if x[0] != 0.0 else x + 1.0,)


def on_number(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (float(x[0]) * x,)


def on_sorted(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (np.sort(x),)


def on_parameter_size(x: Any, _u: Any, p: Any) -> tuple[Any]:
    return (x if p[0] > 0.5 else 2.0 * x,)


BRANCHES = (
    on_array,
    on_scalar,
    on_less,
    on_itself,
    on_larger,
    on_equal_arrays,
    on_equal,
    on_unequal,
    on_number,
    on_sorted,
    on_parameter_size,
)


@pytest.mark.parametrize("function", BRANCHES)
def test_a_branch_on_a_number_that_is_not_known_is_refused(function: Function) -> None:
    """The size of a parameter is not known either: cases of the same structure share the program."""
    with pytest.raises(TypeError):
        plan_of(function, (0.7,))


def by_sign(x: Any, _u: Any, p: Any) -> tuple[Any]:
    return (2.0 * x if p[0] > 0.0 else 3.0 * x,)


@pytest.mark.parametrize("values", [(0.7, -0.7), (-0.7, 0.7), (0.0, 0.7), (0.7, 0.0)])
def test_programs_that_a_sign_decides_are_told_apart_by_it(values: tuple[float, float]) -> None:
    """Each for itself is right; together they are right too, or refused."""
    x = np.array([1.0, 2.0, 3.0, 4.0])
    found = []
    for value in values:
        numbers = gathered([(value,)])
        made = program(by_sign, numbers, N, 0)
        found.append(made)
        got = in_python(made.plan, x, np.zeros(0), made.plan.parameter_values(numbers)[:, 0])
        assert np.array_equal(got, by_sign(x, None, (value,))[0])
    assert found[0].signature != found[1].signature
    both = gathered([(value,) for value in values])
    made = program(by_sign, both, N, 0)
    try:
        parameters = made.plan.parameter_values(both)
    except ValueError:
        return
    for k, value in enumerate(values):
        got = in_python(made.plan, x, np.zeros(0), parameters[:, k])
        assert np.array_equal(got, by_sign(x, None, (value,))[0])


# structure


def shaped(x: Any, _u: Any, p: Any) -> tuple[Any]:
    return (p[0] @ x + p[1] * x,)


def test_zeros_and_ones_are_no_operations() -> None:
    def trivial(x: Any, _u: Any, p: Any) -> tuple[Any]:
        zero, one, full = p
        return (np.concatenate((zero * x + x * one - zero, (x - x) + x / one, -(0.0 - x), full @ x, x * -one + x)),)

    plan = plan_of(trivial, (0.0, 1.0, np.eye(N)), inputs=0)
    states = [plan.tape.places[int(Op.STATE), k] for k in range(N)]
    assert list(plan.roots[0][: 4 * N]) == states * 4
    assert {plan.tape.ops[place][0] for place in plan.roots[0][4 * N :]} == {Op.CONST}
    assert plan.parameters == ()
    assert not any(place for stage in plan.stages for level in stage for place in level)


def test_equal_operations_are_done_once() -> None:
    def twice(x: Any, _u: Any, p: Any) -> tuple[Any]:
        a, b = np.sin(x * p[0]) + x, x + np.sin(p[0] * x)
        return (np.concatenate((a, b)),)

    plan = plan_of(twice, (0.3,), inputs=0)
    assert plan.roots[0][:N] == plan.roots[0][N:]
    assert len(plan.tape.calls) == 1


def test_what_is_made_of_parameters_alone_is_computed_beforehand() -> None:
    def slow(x: Any, _u: Any, p: Any) -> tuple[Any]:
        return (x * (np.sqrt(p[0]) + np.sin(p[0]) / p[1]),)

    numbers = gathered([(2.0, 3.0), (5.0, -7.0)])
    plan = planned(*traced(slow, numbers, N, 0))
    values = plan.parameter_values(numbers)
    np.testing.assert_allclose(values, [np.sqrt([2.0, 5.0]) + np.sin([2.0, 5.0]) / [3.0, -7.0]], rtol=1e-14)
    assert sum(len(level) for stage in plan.stages for level in stage) == N


def test_same_structure_shares_code_and_another_one_does_not() -> None:
    square = np.array([[0.5, 0.0, 1.0, 0.0], [0.0, 2.0, 0.0, 0.0], [3.0, 0.0, 4.0, 0.0], [0.0, 0.0, 0.0, -1.0]])
    other = np.where(np.isin(square, (0.0, 1.0, -1.0)), square, 7.7 * square)
    made = [program(shaped, gathered([(own, 0.3)]), N, 0) for own in (square, other, square + 0.1, np.eye(N))]
    assert made[0] is made[1]
    assert len({own.signature for own in made}) == 3
    with pytest.raises(ValueError, match="structure"):
        gathered([(square, 0.3), (square[:2], 0.3)])


def test_numbers_that_are_zero_in_some_cases_only_are_parameters() -> None:
    cases = [(np.diag([1.0, 2.0, 0.0, 3.0]), 0.0), (np.diag([1.0, 0.0, 0.0, 5.0]), 2.0)]
    numbers = gathered(cases)
    plan = planned(*traced(shaped, numbers, N, 0))
    x = np.array([1.0, 2.0, 3.0, 4.0])
    values = plan.parameter_values(numbers)
    lanes = in_lanes(plan, np.repeat(x[:, np.newaxis], 2, axis=1), np.zeros((0, 2)), values)
    for k, case in enumerate(cases):
        wanted = shaped(x, None, case)[0]
        assert np.array_equal(in_python(plan, x, np.zeros(0), values[:, k]), wanted)
        assert np.array_equal(lanes[:, k], wanted)


def by_zero(x: Any, _u: Any, p: Any) -> tuple[Any]:
    return (np.where(p[0] == 0.0, 0.0, x / np.where(p[0] == 0.0, 1.0, p[0])),)


def test_a_number_that_is_zero_in_some_cases_only_is_told_from_zero_in_each() -> None:
    """Or the cases are refused."""
    cases = [(np.array([0.0, 1.0, 2.0, 0.0]),), (np.array([3.0, 1.0, 0.0, 0.0]),)]
    try:
        numbers = gathered(cases)
        plan = planned(*traced(by_zero, numbers, N, 0))
    except (ValueError, TypeError):
        return
    x = np.ones((N, 2))
    with np.errstate(all="ignore"):
        lanes = in_lanes(plan, x, np.zeros((0, 2)), plan.parameter_values(numbers))
    for k, case in enumerate(cases):
        assert np.array_equal(lanes[:, k], by_zero(x[:, k], None, case)[0])


def test_functions_of_the_same_name_that_differ_in_a_number_are_told_apart() -> None:
    def made(factor: float) -> Function:
        space: dict[str, Any] = {}
        exec(f"def scaled(x, u, p):\n    return (x * {factor},)", space)  # noqa: S102  two texts of one name
        found: Function = space["scaled"]
        found.__module__ = __name__
        return found

    first, second = (program(made(factor), gathered([()]), N, 0) for factor in (2.0, 3.0))
    assert first.signature != second.signature


def test_a_program_is_planned_again_without_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    """And gives the same without it."""
    numbers = gathered([P])
    monkeypatch.setattr(make, "MADE", {})
    monkeypatch.setattr(compiled, "there", lambda: False)
    found = ready(every_expression, P, N, M)
    x, u = (own[:, 2] for own in points(8, 3))
    assert_near(found.results(x, u, 1), np.concatenate(every_expression(x, u, P)), 40.0)
    assert numbers.signature in found.program.signature


def test_a_node_belongs_to_its_tape_once() -> None:
    tape = Tape()
    a, b = (tape.node(Op.STATE, k) for k in range(2))
    assert (a + b).place == (b + a).place
    assert (a * b).place == (b * a).place
    assert (a - b).place != (b - a).place
    assert (0.0 - (-a)).place == a.place
    assert isinstance(2.0 * a, Node)
    assert tape.constant(-0.0).place == tape.constant(0.0).place


@pytest.mark.parametrize("longest", range(4, 10))
def test_lanes_are_filled_up_beyond_whole_vectors(longest: int) -> None:
    """Calls of 4, 4 + 5, ... 4 + ... + 9 lanes, below and above a block: none of the lanes that fill up shows."""
    pytest.importorskip("numba")
    found = ready(many_sines, (), longest, 0)
    (launch,) = found.program.plan.launches[0]
    assert len(launch.lanes) == sum(range(4, longest + 1))
    x = np.linspace(-2.0, 2.0, longest)
    assert_near(found.results(x, np.zeros(0), 0), many_sines(x, None, None)[0])


def many_sines(x: Any, _u: Any, _p: Any) -> tuple[Any]:
    return (np.concatenate([np.sin(x[:k] + 0.1 * k) for k in range(1, len(x) + 1)]),)
