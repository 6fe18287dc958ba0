"""Beck's column: a cantilever pressed at its tip by a force that follows it flutters at 20.05 EI/L^2.

M. Beck, Die Knicklast des einseitig eingespannten, tangential gedrueckten Stabes, ZAMP 3 (1952) 225-228. The exact
load follows here from w'''' + p w'' - W^2 w = 0 with w = w' = 0 at the foot and w'' = w''' = 0 at the tip.
"""

import numpy as np
import pytest
from scipy.optimize import brentq, root

from eom.assembly.massless import independent_equations
from eom.vehicle.elements import GROUND, Constraint, Load, System, Vector
from tests.assembly.structures import chain
from tests.assembly.systems import Array, Y, assembled, point

EI, MU, L = 3.0, 0.5, 2.0
ZERO: Vector = (0.0, 0.0, 0.0)


def tip_condition(p: float, W: float) -> float:
    """Determinant of w'' and w''' at the tip for the two shapes that meet the conditions at the foot."""
    middle = np.sqrt(p**2 / 4.0 + W**2)
    a, b = np.sqrt(middle + p / 2.0), np.sqrt(middle - p / 2.0)
    s, c, S, C = np.sin(a), np.cos(a), np.sinh(b), np.cosh(b)
    # shapes cos ax - cosh bx and sin(ax)/a - sinh(bx)/b
    second = np.array([-(a**2) * c - b**2 * C, -a * s - b * S])
    third = np.array([a**3 * s - b**3 * S, -(a**2) * c - b**2 * C])
    return float(second[0] * third[1] - second[1] * third[0])


def exact_load() -> float:
    """The load at which the two lowest frequencies meet: the condition and its slope by W vanish."""
    h = 1e-4

    def both(unknown: Array) -> list[float]:
        p, W = unknown
        slope = (
            8.0 * (tip_condition(p, W + h) - tip_condition(p, W - h))
            - (tip_condition(p, W + 2.0 * h) - tip_condition(p, W - 2.0 * h))
        ) / (12.0 * h)
        return [tip_condition(p, W), slope]

    return float(root(both, [20.0, 11.0], tol=1e-13).x[0])


def column(count: int, P: float, frame: int) -> System:
    """The column of some elements in one plane; *frame* is the body that the force turns with."""
    free = chain(count, (EI, EI), MU, length=L, along=(0.0, 0.0, 1.0), normal=(1.0, 0.0, 0.0))
    plane = [
        Constraint(point((k, GROUND), item.centre, forces=1, moments=2, axis=Y, name=f"plane_{k}"))
        for k, item in enumerate(free.bodies)
    ]
    rods = [item for item in free.constraints if item.connection.line]
    press = Load("press", count - 1, (0.0, 0.0, L), (0.0, 0.0, -P), ZERO, frame)
    return free._replace(constraints=(*rods, *plane), loads=(press,))


def squares(count: int, P: float, frame: int) -> Array:
    """Squared natural frequencies, in units of EI/(mu L^4), sorted by their real part."""
    equations = independent_equations(assembled(column(count, P, frame)))
    found = np.linalg.eigvals(np.linalg.solve(equations.M, equations.K))
    return np.asarray(np.sort_complex(found) * (MU * L**4 / EI))


def flutter_load(count: int) -> float:
    """Load, in units of EI/L^2, at which the two lowest frequencies meet: their squared distance passes zero."""

    def distance(p: float) -> float:
        first, second = squares(count, p * EI / L**2, count - 1)[:2]
        return float(((first - second) ** 2).real)

    return float(brentq(distance, 15.0, 25.0, xtol=1e-10))


def extrapolated(values: list[float]) -> float:
    """Limit of values whose error is a series of even powers of the element's length, halved each time."""
    table = np.array(values)
    power = 4.0
    while len(table) > 1:
        table = (power * table[1:] - table[:-1]) / (power - 1.0)
        power *= 4.0
    return float(table[0])


def test_the_derived_load_is_the_published_one() -> None:
    assert exact_load() == pytest.approx(20.05, abs=5e-3)


def test_the_column_flutters_at_becks_load() -> None:
    """Rods carry the load element by element, with an error of the square of their length.

    Of 4, 8, 16 and 32 elements the extrapolation removes h^2, h^4 and h^6; rounding of 1e-16 times the ratio of the
    highest frequency to the lowest, 1e7, in their squared distance is what remains: 1e-6.
    """
    values = [flutter_load(count) for count in (4, 8, 16, 32)]
    steps = np.diff(values)
    np.testing.assert_allclose(np.log2(np.abs(steps[:-1] / steps[1:])), 2.0, atol=0.1)
    assert extrapolated(values) == pytest.approx(exact_load(), rel=1e-6)


def test_under_a_dead_load_it_buckles_at_eulers() -> None:
    """pi^2/4 EI/L^2: the lowest square passes zero; error h^2 as above."""

    def load(count: int) -> float:
        return float(brentq(lambda p: squares(count, p * EI / L**2, GROUND)[0].real, 1.0, 4.0, xtol=1e-12))

    assert extrapolated([load(count) for count in (2, 4, 8, 16)]) == pytest.approx(np.pi**2 / 4.0, rel=1e-7)


def test_under_the_following_load_it_never_just_gives_way() -> None:
    """No load makes a square pass zero: the column of a tangential force has no other equilibrium."""
    for p in (2.5, 10.0, 19.0):
        assert squares(8, p * EI / L**2, 7)[0].real > 1.0
