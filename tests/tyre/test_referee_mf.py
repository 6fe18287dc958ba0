"""The referee of the Magic Formula against published numbers and against laws of the equations."""

from collections.abc import Callable
from math import atan, cos, isclose, pi, tan

import pytest
from scipy.optimize import minimize_scalar

from tests.tyre.plain_sets import BOOK_DEFAULTS, as_61, filled
from tests.tyre.random_sets import State, random_set_52, random_set_61, random_states
from tests.tyre.referee_mf import Wrench, book_61, tool_61
from tests.tyre.referee_mf52 import relaxation_52, stiffnesses_52, tool_52
from tests.tyre.referee_mf_forces import relaxation_61, stiffnesses_61

Numbers = dict[str, float]
FORMS: dict[str, tuple[Callable[[int], Numbers], Callable[..., Wrench], Callable[..., tuple[float, float, float]]]] = {
    "tool": (random_set_61, tool_61, stiffnesses_61),
    "book": (random_set_61, book_61, stiffnesses_61),
    "5.2": (random_set_52, tool_52, stiffnesses_52),
}
SHIFTS = ("PHX1", "PHX2", "PVX1", "PVX2", "PHY1", "PHY2", "PVY1", "PVY2")
ONE_SIDED = (
    *("PHY1", "PHY2", "PVY1", "PVY2", "PEY3", "RHX1", "RBY3", "RVY1", "RVY2", "QBZ4", "QDZ3", "QDZ6", "QDZ7"),
    *("QEZ4", "QHZ1", "QHZ2", "SSZ1", "QSX1"),
)
"""Coefficients that tell left from right: conicity, ply steer and what of the trail changes with the sign of camber."""
ABSOLUTE_IN_THE_BOOK = ("QDZ3",)
"""4.E43 takes the size of the camber, so QDZ3 does not tell left from right there."""


def without(numbers: Numbers, *names: str) -> Numbers:
    return numbers | {name: 0.0 for name in names if name in numbers}


def mirrored(wrench: Wrench) -> Wrench:
    """Forces and moments seen in a mirror along the wheel plane."""
    Fx, Fy, Mx, My, Mz = wrench
    return Fx, -Fy, -Mx, My, -Mz


def states_of(numbers: Numbers, seed: int) -> list[State]:
    return random_states(seed, numbers["FNOMIN"], 10)


def assert_alike(found: Wrench, expected: Wrench, Fz: float) -> None:
    """To rounding: 1e-13 of the load (times a metre for moments); the values are of some tens of operations."""
    assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) < 1e-13 * Fz


# Published coefficients: what they are defined to mean, worked out by hand.


@pytest.mark.parametrize("forces", [tool_61, book_61])
def test_default_tyre_peaks_at_its_friction_where_the_formula_says(forces: Callable[..., Wrench]) -> None:
    tyre = filled(BOOK_DEFAULTS)
    # E = 0: the peak D = PDX1 Fz lies at B kappa = tan(pi/2/C), B = 64000 N/(1.6 * 4000 N) = 10.
    kappa = tan(pi / 3.2) / 10
    assert forces(tyre, 0.0, kappa, 4000.0, 0.0, 16.7)[0] == pytest.approx(4000.0, rel=1e-12)
    # At one and a half times the nominal load friction is 1 - 0.1/2, B is 16/(1.6 * 0.95).
    kappa = tan(pi / 3.2) / (16 / (1.6 * 0.95))
    assert forces(tyre, 0.0, kappa, 6000.0, 0.0, 16.7)[0] == pytest.approx(5700.0, rel=1e-12)
    # Laterally B = 48000 N/(1.3 * 4000 N); the book's slip is the tangent.
    slip = tan(pi / 2.6) / (48 / 5.2)
    alpha = slip if forces is tool_61 else atan(slip)
    assert forces(tyre, alpha, 0.0, 4000.0, 0.0, 16.7)[1] == pytest.approx(-4000.0, rel=1e-12)


def test_default_tyre_has_the_stiffnesses_its_coefficients_name() -> None:
    tyre = filled(BOOK_DEFAULTS)
    # PKX1 FNOMIN; PKY1 FNOMIN sin(2 atan(1/2)) = -60000 * 4/5; PKY6 FNOMIN.
    assert stiffnesses_61(tyre, 4000.0) == pytest.approx((64000.0, -48000.0, -4000.0), rel=1e-12)
    # PKY1 FNOMIN is the largest cornering stiffness and PKY2 FNOMIN its load (manual of MF-Tyre, reduced input).
    assert stiffnesses_61(tyre, 8000.0)[1] == pytest.approx(-60000.0, rel=1e-12)
    assert all(stiffnesses_61(tyre, load)[1] > -60000.0 for load in (7900.0, 8100.0))
    # 64000 N / (400000 N/m), 48000 N / (100000 N/m).
    assert relaxation_61(tyre, 4000.0, 0.0) == pytest.approx((0.16, 0.48), rel=1e-12)


@pytest.mark.parametrize("forces", [tool_61, book_61])
def test_default_tyre_resists_rolling_and_aligns_itself_by_its_trail(forces: Callable[..., Wrench]) -> None:
    tyre = filled(BOOK_DEFAULTS)
    # 4000 N * 0.3135 m * (0.01 + 0.0004 + 0.00004), against rolling forward.
    assert forces(tyre, 0.0, 0.0, 4000.0, 0.0, 16.7)[3] == pytest.approx(-13.09176, rel=1e-12)
    # Trail 0.12 * 0.3135 m times 48000 N/rad, towards the velocity; the curve bends by (B alpha)^2 = 1e-10.
    assert forces(tyre, 1e-6, 0.0, 4000.0, 0.0, 16.7)[4] == pytest.approx(1805.76e-6, rel=1e-9)


def test_rolling_resistance_of_tool_and_book_differ_by_the_load_over_its_nominal() -> None:
    tyre = filled(BOOK_DEFAULTS)
    tool, book = (forces(tyre, 0.0, 0.0, 2000.0, 0.0, 16.7)[3] for forces in (tool_61, book_61))
    assert tool == pytest.approx(-13.09176 * 0.5**0.85, rel=1e-12)
    assert book == pytest.approx(0.5 * tool, rel=1e-12)


# Laws over random sets.


@pytest.mark.parametrize("form", FORMS)
def test_slopes_at_the_origin_are_the_stiffnesses(form: str) -> None:
    random_set, forces, stiffnesses = FORMS[form]
    step = 1e-6
    for seed in range(20):
        tyre = without(random_set(seed), *SHIFTS)
        for state in states_of(tyre, seed):

            def slope(output: int, *ends: tuple[float, float, float], at: State = state, c: Numbers = tyre) -> float:
                low, high = (forces(c, alpha, kappa, at.Fz, gamma, at.speed)[output] for alpha, kappa, gamma in ends)
                return (high - low) / (2 * step)

            found = (
                slope(0, (0.0, -step, 0.0), (0.0, step, 0.0)),
                slope(1, (-step, 0.0, 0.0), (step, 0.0, 0.0)),
                slope(1, (0.0, 0.0, -step), (0.0, 0.0, step)),
            )
            # The step leaves (B step)^2 < 1e-8 of the curve; where camber enters as its size, PKY3 step < 1e-6 of a
            # camber stiffness of the size of the load.
            assert found == pytest.approx(stiffnesses(tyre, state.Fz), rel=1e-6, abs=1e-6 * state.Fz)


@pytest.mark.parametrize("form", FORMS)
def test_pure_side_force_peaks_at_friction_times_load(form: str) -> None:
    random_set, forces, _ = FORMS[form]
    for seed in range(20):
        tyre = without(random_set(seed), *SHIFTS, "PEY3", "LMUV")
        for state in states_of(tyre, seed):
            low = minimize_scalar(
                lambda alpha, c=tyre, s=state: forces(c, alpha, 0.0, s.Fz, 0.0, s.speed)[1],
                bounds=(0.0, 1.5),
                method="bounded",
                options={"xatol": 1e-9},
            )
            dfz = state.Fz / (tyre["LFZO"] * tyre["FNOMIN"]) - 1
            mu = (tyre["PDY1"] + tyre["PDY2"] * dfz) * tyre["LMUY"]
            if form != "5.2":
                dpi = tyre["INFLPRES"] / tyre["NOMPRES"] - 1
                mu *= 1 + tyre["PPY3"] * dpi + tyre["PPY4"] * dpi**2
            # The peak is flat: a slip 1e-6 beside it costs 1e-10 of the force or less.
            assert -low.fun == pytest.approx(mu * state.Fz, rel=1e-9)


@pytest.mark.parametrize("form", FORMS)
def test_tyre_that_does_not_tell_left_from_right_is_its_own_mirror_image(form: str) -> None:
    random_set, forces, _ = FORMS[form]
    for seed in range(20):
        tyre = without(random_set(seed), *ONE_SIDED)
        for state in states_of(tyre, seed):
            image = state._replace(alpha=-state.alpha, gamma=-state.gamma)
            assert_alike(forces(tyre, *image), mirrored(forces(tyre, *state)), state.Fz)


@pytest.mark.parametrize("form", FORMS)
def test_tyre_with_turned_one_sided_coefficients_is_the_mirrored_tyre(form: str) -> None:
    random_set, forces, _ = FORMS[form]
    turned = [name for name in ONE_SIDED if form != "book" or name not in ABSOLUTE_IN_THE_BOOK]
    for seed in range(20):
        tyre = random_set(seed)
        other = tyre | {name: -tyre[name] for name in turned}
        for state in states_of(tyre, seed):
            image = state._replace(alpha=-state.alpha, gamma=-state.gamma)
            assert_alike(forces(other, *image), mirrored(forces(tyre, *state)), state.Fz)


@pytest.mark.parametrize("form", FORMS)
def test_longitudinal_force_is_odd_in_slip_but_for_shifts_and_driving_curvature(form: str) -> None:
    random_set, forces, _ = FORMS[form]
    for seed in range(20):
        tyre = without(random_set(seed), *SHIFTS, "PEX4")
        for state in states_of(tyre, seed):
            drive, brake = (forces(tyre, *state._replace(kappa=sign * state.kappa))[0] for sign in (1, -1))
            assert isclose(drive, -brake, rel_tol=1e-13, abs_tol=0.0)  # the same operations, but for signs


def test_tool_and_book_are_one_formula_where_their_choices_coincide() -> None:
    """Upright at nominal load, pure side slip whose tangent the book takes, friction scales 1: only cosines differ."""
    for seed in range(20):
        tyre = without(random_set_61(seed), "LMUV", "QSX13", "SSZ1", "SSZ2") | {
            "LFZO": 1.0,
            "LMUX": 1.0,
            "LMUY": 1.0,
        }
        for state in states_of(tyre, seed):
            at = state._replace(Fz=tyre["FNOMIN"], gamma=0.0, kappa=0.0)
            tool = tool_61(tyre, *at)
            book = book_61(tyre, *at._replace(alpha=atan(at.alpha)))
            scaled = (*book[:4], book[4] * cos(at.alpha) / cos(atan(at.alpha)))
            assert_alike(tool, scaled, at.Fz)


def test_camber_scales_of_52_scale_each_camber_coefficient_of_their_group() -> None:
    powers = {
        "LGAX": {"PDX3": 2},
        "LGAY": {"PDY3": 2, "PEY4": 1, "PKY3": 1, "PHY3": 1, "PVY3": 1, "PVY4": 1},
        "LGAZ": {"QBZ4": 1, "QBZ5": 1, "QDZ3": 1, "QDZ4": 2, "QDZ8": 1, "QDZ9": 1, "QEZ5": 1, "QHZ3": 1, "QHZ4": 1},
    }
    for seed in range(20):
        tyre = random_set_52(seed)
        plain = tyre | dict.fromkeys(powers, 1.0)
        plain |= {
            name: tyre[name] * tyre[scale] ** power for scale, group in powers.items() for name, power in group.items()
        }
        for state in states_of(tyre, seed):
            assert_alike(tool_52(plain, *state), tool_52(tyre, *state), state.Fz)
            lengths = relaxation_52(tyre, state.Fz, state.gamma)
            assert relaxation_52(plain, state.Fz, state.gamma) == pytest.approx(lengths, rel=1e-13)


def test_magic_formula_52_is_61_without_its_additions() -> None:
    """At any camber but for Mz, whose trail carries another side force there; PKY3 bends 6.1's camber shift."""
    for seed in range(20):
        old = without(random_set_52(seed), "PKY3") | {"LGAX": 1.0, "LGAY": 1.0, "LGAZ": 1.0}
        for state in states_of(old, seed):
            new = as_61(old, state.Fz)
            assert_alike((*tool_52(old, *state)[:4], 0.0), (*tool_61(new, *state)[:4], 0.0), state.Fz)
            upright = state._replace(gamma=0.0)
            assert_alike(tool_52(old, *upright), tool_61(new, *upright), state.Fz)
