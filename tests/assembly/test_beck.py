"""Beck's column: a cantilever under a force that stays tangent to its tip flutters at 20.05 EI/L^2.

M. Beck, Zeitschrift fuer angewandte Mathematik und Physik 3 (1952) 225-228. The exact load is solved from the
characteristic equation of the beam. Elements carry the compression in links, whose tangent stiffness is that of a
string: the error falls with the square of their length, so that two meshes extrapolate to some 1e-5; 1e-4 is asked for.
"""

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from eom.vehicle.elements import Connection, Constraint, Load
from tests.assembly.systems import Y, linear
from tests.assembly.test_beam import EI, LENGTH, MU, beams


def characteristic(p: float, w: float) -> float:
    """Determinant of the clamped-free beam with a tangential load p EI/L^2, at the frequency w sqrt(EI / mu L^4)."""
    mean = np.sqrt(p**2 / 4.0 + w**2)
    a, b = np.sqrt(mean - p / 2.0), np.sqrt(mean + p / 2.0)
    return float(p**2 + 2.0 * w**2 * (1.0 + np.cosh(a) * np.cos(b)) + p * w * np.sinh(a) * np.sin(b))


def exact_flutter_load() -> float:
    """Where two frequencies meet: the largest p at which the determinant still changes sign between them."""

    def dip(p: float) -> float:
        return float(minimize_scalar(lambda w: characteristic(p, w), bounds=(6.0, 15.0), options={"xatol": 1e-12}).fun)

    return float(brentq(dip, 18.0, 22.0, xtol=1e-10))


def flutter_load(elements: int) -> float:
    """The load p EI/L^2 at which the model's vibrations start to grow."""
    system = beams(elements, clamped=True)
    tip = len(system.bodies) - 1

    def discriminant(p: float) -> float:
        follower = Load("follower", tip, (LENGTH, 0.0, 0.0), (-p * EI / LENGTH**2, 0.0, 0.0), (0.0, 0.0, 0.0), tip)
        rods = [Constraint(Connection(item.name, item.bodies, item.places, 1, line=True)) for item in system.beams]
        turns = [item for item in system.constraints if item.connection.moments]
        sides = [
            Constraint(item.connection._replace(forces=1, force_axis=Y))
            for item in system.constraints
            if item.connection.forces
        ]
        loaded = system._replace(loads=(follower,), constraints=(*turns, *sides, *rods))
        roots = np.linalg.eigvals(linear(loaded).model.A)
        squares = np.sort_complex(np.unique(np.round(-(roots**2), 9)))
        lowest = squares[np.argsort(np.abs(squares))[:2]] * MU * LENGTH**4 / EI
        return float(((lowest[0] - lowest[1]) ** 2).real)

    return float(brentq(discriminant, 17.0, 23.0, xtol=1e-9))


def test_flutter_load_is_beck_s() -> None:
    exact = exact_flutter_load()
    np.testing.assert_allclose(exact, 20.05, atol=0.005)
    coarse, fine = flutter_load(8), flutter_load(16)
    np.testing.assert_allclose((4.0 * fine - coarse) / 3.0, exact, rtol=1e-4)
    assert abs(fine / exact - 1.0) < 0.01
