"""Critical values against published ones, closed forms and systems whose crossings are known by construction."""

import json
from collections.abc import Callable
from itertools import pairwise

import control
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

import eom
from eom.analysis.critical import CriticalValue, critical_of, critical_values, unexplained
from eom.analysis.family import nodes_at
from eom.analysis.locus import locus_of
from tests.analysis.families import Array, hidden, model_of, oscillator
from tests.analysis.test_locus import turned
from tests.assembly.test_beck import flutter_load
from tests.vehicles.shipped import text, vehicle
from tests.vehicles.test_car_trailer import snaking
from tests.vehicles.test_motorcycle import sharp
from tests.vehicles.test_spinning_top import CRITICAL


def found_by(family: Callable[[float], eom.LinearModel], low: float, high: float, points: int) -> list[CriticalValue]:
    return list(critical_of(locus_of(family, nodes_at(family, np.linspace(low, high, points).tolist()))))


def told(items: tuple[CriticalValue, ...] | list[CriticalValue]) -> list[tuple[str, str]]:
    return [(item.kind, item.becomes) for item in items]


def test_the_bicycle_is_stable_between_the_published_weave_and_capsize_speeds() -> None:
    """Meijaard et al. 2007; the digits are those of the benchmark's software, the roots' rounding is 1e-13 m/s."""
    weave, capsize = critical_values(vehicle("bicycle"), "U", (0.5, 10.0))
    assert weave.value == pytest.approx(4.29238253634111, abs=5e-11)
    assert capsize.value == pytest.approx(6.02426201538837, abs=5e-11)
    assert told([weave, capsize]) == [("flutter", "stable"), ("divergence", "unstable")]
    assert weave.frequency == pytest.approx(3.43503384866144 / (2.0 * np.pi), abs=1e-11)
    assert capsize.frequency == 0.0


def test_the_caravan_snakes_at_hurwitzs_critical_speed_and_frequency() -> None:
    speed, circular = snaking()
    (item,) = critical_values(vehicle("car_trailer"), "U", (18.0, 216.0), "km/h")
    # as brentq on the rightmost root: tests/vehicles/test_car_trailer.py
    assert item.value / 3.6 == pytest.approx(speed, rel=1e-10)
    assert item.frequency == pytest.approx(circular / (2.0 * np.pi), rel=1e-10)
    assert told([item]) == [("flutter", "unstable")]
    assert item.bodies[0] == "caravan_body"


def test_the_motorcycle_has_the_critical_speeds_of_sharps_equations() -> None:
    """Weave ends, capsize and wobble begin; 1e-7 as in tests/vehicles/test_motorcycle.py, where they cross slowly."""

    def unstable(V: float) -> int:
        return int(np.sum(np.linalg.eigvals(sharp(V)[0]).real > 0.0))

    def edge(low: float, high: float) -> float:
        there = unstable(high)
        return float(brentq(lambda V: (unstable(V) == there) - 0.5, low, high, xtol=1e-9))

    items = critical_values(vehicle("motorcycle"), "U", (2.0, 65.0))
    assert told(items) == [("flutter", "stable"), ("divergence", "unstable"), ("flutter", "unstable")]
    expected = [edge(5.0, 7.0), edge(9.0, 13.0), edge(50.0, 62.0)]
    assert [item.value for item in items] == pytest.approx(expected, rel=1e-7)
    assert "front_wheel" in items[2].bodies
    assert "rear_frame" not in items[2].bodies


def test_the_shimmying_wheel_has_both_speeds_of_its_hurwitz_quadratic() -> None:
    from tests.vehicles.test_shimmy import A3, LEVER, a, d, k

    quadratic = [LEVER * d, LEVER * a * k + a**2 * d**2 - A3 * k, a**3 * k * d]
    items = critical_values(vehicle("shimmy"), "U", (1.0, 20.0))
    assert [item.value for item in items] == pytest.approx(np.sort(np.roots(quadratic).real), rel=1e-10)
    assert told(items) == [("flutter", "unstable"), ("flutter", "stable")]


def test_zieglers_undamped_column_flutters_at_the_published_load() -> None:
    """7/2 - sqrt(2), where both pairs meet on the axis; their common square is -1/sqrt(2) k/(m l^2)."""
    (item,) = critical_values(vehicle("ziegler_column"), "P", (0.0, 400.0))
    # the squared difference of both roots passes zero with a finite slope: rounding moves the load by 1e-13
    assert item.value == pytest.approx(100.0 * (3.5 - np.sqrt(2.0)), rel=1e-10)
    assert item.frequency == pytest.approx(10.0 * 2.0**-0.25 / (2.0 * np.pi), rel=1e-7)
    assert told([item]) == [("flutter", "unstable")]
    assert item.bodies == ("upper", "lower")


def test_a_dead_load_buckles_the_undamped_column_at_the_load_of_two_springs() -> None:
    file = text("ziegler_column").replace("frame: upper}", "frame: ground}")
    items = critical_values(eom.loads(file), "P", (0.0, 100.0))
    # both buckling loads of two rods lie at (3 -+ sqrt(5))/2; the upper one is beyond the range
    assert [item.value for item in items] == pytest.approx([100.0 * (3.0 - np.sqrt(5.0)) / 2.0], rel=1e-9)
    assert told(items) == [("divergence", "unstable")]


def test_the_undamped_disc_becomes_stable_at_the_published_speed() -> None:
    (item,) = critical_values(vehicle("disc"), "U", (0.5, 3.0))
    # the root's square passes zero beside the third zero of a steady turn
    assert item.value == pytest.approx(np.sqrt(9.81 * 0.3 / 3.0), rel=1e-9)
    assert told([item]) == [("divergence", "stable")]


def test_an_oversteering_car_diverges_at_its_critical_speed() -> None:
    from tests.vehicles.test_textbook_cars import CAR, OVER, L, gradient

    (item,) = critical_values(eom.loads(CAR, **OVER), "U", (5.0, 60.0))
    assert item.value == pytest.approx(np.sqrt(-L / gradient(OVER)), rel=1e-10)
    assert told([item]) == [("divergence", "unstable")]


def beck(count: int) -> eom.Vehicle:
    """A cantilever of unit length, mass and bending stiffness, stiffer sideways, pressed by a force p on its tip."""
    x = [k / count for k in range(count + 1)]
    ends = [
        ("ground" if k == 0 else f"node_{k}", f"node_{k + 1}", [[x[k], 0, 0], [x[k + 1], 0, 0]]) for k in range(count)
    ]
    own = {"bending": [1.0, 10.0], "normal": [0, 0, 1], "mass_per_length": 1.0}
    connectors: dict[str, object] = {}
    for k, (one, two, places) in enumerate(ends):
        for kind, more in (("beam", own), ("link", {}), ("torsion_link", {})):
            connectors[f"{kind}_{k}"] = {"type": kind, "between": [one, two], "ends": places, **more}
    tip = f"node_{count}"
    file = {
        "name": "Beck's column",
        "parameters": {"p": {"value": "1 N"}},
        "bodies": {f"node_{k}": {"mass": 0, "at": [x[k], 0, 0]} for k in range(1, count + 1)},
        "connectors": connectors,
        "loads": {"press": {"body": tip, "at": [1.0, 0, 0], "force": ["-p", 0, 0], "frame": tip}},
    }
    return eom.loads(json.dumps(file))


@pytest.mark.parametrize("count", [2, 4])
def test_becks_column_flutters_at_the_load_of_as_many_elements(count: int) -> None:
    """Of which tests/assembly/test_beck.py shows that they converge to 20.05 EI/L^2 (M. Beck, ZAMP 3, 1952).

    1e-7: stretching and twisting joints keep the two models' other frequencies, and so their rounding, apart.
    """
    (item,) = critical_values(beck(count), "p", (1.0, 30.0))
    assert item.value == pytest.approx(flutter_load(count), rel=1e-7)
    assert told([item]) == [("flutter", "unstable")]


def test_a_top_sleeps_from_the_spin_of_the_textbooks() -> None:
    (item,) = critical_values(vehicle("spinning_top"), "spin", (10.0, 300.0))
    # beside the zeros of its spin the roots that meet are good to half the digits
    assert item.value == pytest.approx(CRITICAL, rel=1e-8)
    assert told([item]) == [("flutter", "stable")]


@pytest.mark.parametrize("name", ["b_train_yaw_roll", "bicycle", "motorcycle", "car_trailer", "articulated_bus"])
def test_the_number_of_unstable_poles_of_python_control_changes_at_critical_values_alone(name: str) -> None:
    items = critical_values(vehicle(name), "U", (3.0, 36.0))
    step = {"flutter": 2, "divergence": 1}

    def unstable(U: float) -> int:
        # zeros of free motions are good to the square root of rounding
        return int(np.sum(control.poles(eom.linearise(vehicle(name, U=U)).to_control()).real > 1e-7))

    edges = [3.0, *(item.value for item in items), 36.0]
    counts = [unstable(0.5 * (a + b)) for a, b in pairwise(edges)]
    changes = [step[item.kind] * (1 if item.becomes == "unstable" else -1) for item in items]
    assert np.diff(counts).tolist() == changes
    for a, b in pairwise(edges):
        inner = np.linspace(a, b, 9)[1:-1]
        assert len({unstable(float(U)) for U in inner}) == 1


DIPS = st.tuples(st.floats(0.1, 0.9), st.floats(0.02, 0.4), st.booleans())


@settings(max_examples=40, deadline=None)
@given(st.lists(DIPS, min_size=1, max_size=3, unique_by=lambda dip: round(dip[0], 2)), st.integers(0, 1000))
def test_double_crossings_within_one_step_are_found(dips: list[tuple[float, float, bool]], seed: int) -> None:
    """Each block's real part is a parabola that is positive between two values, less than a step apart or more."""
    widths = [0.1 * width for _, width, _ in dips]

    def blocks(p: float) -> list[Array]:
        result = []
        for (middle, _, real), width in zip(dips, widths, strict=True):
            rise = 10.0 * (width**2 - (p - middle) ** 2)
            result.append(np.array([[rise]]) if real else np.array([[rise, 3.0], [-3.0, rise]]))
        return result

    size = len(np.concatenate([np.diag(block) for block in blocks(0.0)]))
    items = found_by(hidden(blocks, turned(size, seed)), -0.1, 1.1, 25)
    expected = sorted(
        (middle + sign * width, "divergence" if real else "flutter", "unstable" if sign < 0 else "stable")
        for (middle, _, real), width in zip(dips, widths, strict=True)
        for sign in (-1, 1)
    )
    assert told(items) == [(kind, becomes) for _, kind, becomes in expected]
    # slopes are 20 width >= 0.04 1/s, eigenvalues good to 1e-13
    assert [item.value for item in items] == pytest.approx([value for value, *_ in expected], abs=1e-10)


def test_a_touch_from_the_left_changes_no_stability_and_is_not_reported() -> None:
    def family(p: float) -> eom.LinearModel:
        return model_of(np.array([[-((p - 0.37) ** 2), 2.0], [-2.0, -((p - 0.37) ** 2)]]))

    assert found_by(family, 0.0, 1.0, 9) == []


def test_a_value_that_is_itself_critical_is_found_once() -> None:
    def family(p: float) -> eom.LinearModel:
        return model_of(oscillator(2.0, 0.5 - p))

    (item,) = found_by(family, 0.0, 1.0, 11)
    assert item.value == pytest.approx(0.5, abs=1e-12)
    assert item.frequency == pytest.approx(1.0 / np.pi, rel=1e-12)


@pytest.mark.parametrize(("low", "high"), [(0.5, 1.0), (0.0, 0.5)])
def test_an_end_of_the_range_that_is_critical_is_found(low: float, high: float) -> None:
    (item,) = found_by(lambda p: model_of(oscillator(2.0, 0.5 - p)), low, high, 6)
    assert item.value == 0.5
    assert told([item]) == [("flutter", "unstable")]


def test_an_undamped_system_that_begins_where_it_buckles_is_found() -> None:
    """Roots are the square roots of p: a double zero at the first value."""
    (item,) = found_by(lambda p: model_of(np.array([[0.0, 1.0], [p, 0.0]])), 0.0, 1.0, 6)
    assert item.value == 0.0
    assert told([item]) == [("divergence", "unstable")]


def test_an_undamped_system_gains_and_loses_stability_where_its_roots_return_to_the_axis_and_leave_it() -> None:
    """Two oscillators coupled without symmetry: squares s of the roots with s^2 + 5 s + 4 + c(p) = 0, c = 4 - p^2.

    They are complex where 25/4 < 4 + c, between p = -sqrt(7)/2 and sqrt(7)/2; one is positive where 4 + c < 0, beyond
    -sqrt(8) and sqrt(8).
    """

    def family(p: float) -> eom.LinearModel:
        c = 4.0 - p**2
        return model_of(np.array([[0, 0, 1.0, 0], [0, 0, 0, 1.0], [-1.0, -1.0, 0, 0], [c, -4.0, 0, 0]]))

    items = found_by(family, -3.0, 3.0, 12)
    expected = [-np.sqrt(8.0), -np.sqrt(7.0) / 2.0, np.sqrt(7.0) / 2.0, np.sqrt(8.0)]
    # the squared difference of two roots passes zero with a finite slope
    assert [item.value for item in items] == pytest.approx(expected, abs=1e-9)
    assert told(items) == [
        ("divergence", "stable"),
        ("flutter", "unstable"),
        ("flutter", "stable"),
        ("divergence", "unstable"),
    ]
    assert [item.frequency for item in items[1:3]] == pytest.approx([np.sqrt(2.5) / (2.0 * np.pi)] * 2, rel=1e-7)


def test_the_damping_at_which_a_symbolic_hurwitz_determinant_vanishes_is_critical() -> None:
    """s^3 + p s^2 + 2 s + 3: stable from p = 3/2, where it oscillates with sqrt(2) 1/s."""
    s, p = sympy.symbols("s p")
    a, b, c, d = sympy.Poly(s**3 + p * s**2 + 2 * s + 3, s).all_coeffs()
    (exact,) = sympy.solve(b * c - a * d, p)
    (item,) = found_by(lambda value: model_of(np.array([[0.0, 1, 0], [0, 0, 1], [-3, -2, -value]])), 0.2, 4.0, 7)
    assert item.value == pytest.approx(float(exact), rel=1e-12)
    assert item.frequency == pytest.approx(np.sqrt(2.0) / (2.0 * np.pi), rel=1e-12)
    assert told([item]) == [("flutter", "stable")]


def test_falling_values_find_the_same_with_the_same_direction() -> None:
    from eom.analysis.locus import root_locus

    falling = critical_of(root_locus(vehicle("bicycle"), "U", np.linspace(10.0, 0.5, 33).tolist()))
    assert told(falling) == [("flutter", "stable"), ("divergence", "unstable")]


@pytest.mark.parametrize("between", [(3.0, 3.0), (5.0, 3.0), (np.nan, 3.0)])
def test_an_empty_range_is_refused(between: tuple[float, float]) -> None:
    with pytest.raises(eom.AnalysisError, match="expected a lower and a higher value"):
        critical_values(vehicle("bicycle"), "U", between)


@pytest.mark.parametrize(("name", "low", "high"), [("car_trailer", 90, 130), ("shimmy", 1, 20), ("bicycle", 2, 9)])
def test_the_critical_values_explain_how_many_roots_are_unstable_and_fewer_do_not(
    name: str, low: float, high: float
) -> None:
    unit = "km/h" if name == "car_trailer" else "m/s"
    locus = eom.root_locus(vehicle(name), "U", np.linspace(low, high, 14).tolist(), unit)
    found = critical_of(locus)
    assert unexplained(locus, found) == ()
    ((a, b),) = unexplained(locus, found[1:])
    assert a < found[0].value < b
