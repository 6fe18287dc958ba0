"""The shipped cantilever against the theory of Euler and Bernoulli."""

import numpy as np
import pytest
from scipy.optimize import brentq

import eom
from tests.vehicles.shipped import vehicle

L, EI_Z, EI_Y, MU = 1.6, 22.4e3, 5.6e3, 6.28


def test_its_lowest_frequencies_are_those_of_the_characteristic_equation() -> None:
    """cos(b) cosh(b) = -1; four elements leave (b/4)^4/1440 of the frequency: 3e-5 and, at b = 4.7, 1.4e-3."""
    found = eom.linearise(vehicle("cantilever")).modes().eigenvalues
    assert np.max(np.abs(found.real)) < 1e-6 * np.max(np.abs(found.imag))
    b = [brentq(lambda b: np.cos(b) + 1.0 / np.cosh(b), *bounds) for bounds in ((1.5, 2.0), (4.5, 5.0))]
    for EI in (EI_Z, EI_Y):
        for root, limit in zip(b, (5e-5, 2e-3), strict=True):
            expected = (root / L) ** 2 * np.sqrt(EI / MU)
            nearest = float(np.min(np.abs(found.imag - expected)))
            assert nearest < limit * expected


def test_forces_and_weight_bend_it_as_in_the_tables() -> None:
    assembly = eom.assemble(vehicle("cantilever"))
    compliance = eom.linearise(assembly).frequency_response(0.0)[0].real
    np.testing.assert_allclose(compliance, np.diag([L**3 / (3 * EI_Z), L**3 / (3 * EI_Y)]), rtol=1e-9, atol=1e-15)
    sag = assembly.matrices.statics.deflection[assembly.coordinates.index("tip.z")]
    assert sag == pytest.approx(-MU * 9.81 * L**4 / (8 * EI_Z), rel=1e-9)


def test_twice_the_length_has_a_quarter_of_each_frequency() -> None:
    short, long = (
        np.sort(eom.linearise(vehicle("cantilever", L=length)).modes().eigenvalues.imag)[-16:] for length in (1.0, 2.0)
    )
    np.testing.assert_allclose(long, short / 4.0, rtol=1e-7)
