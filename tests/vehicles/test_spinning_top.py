"""The sleeping top against the closed forms of Lagrange's top."""

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import vehicle

WEIGHT_LEVER = 0.2 * 9.81 * 0.05
ACROSS, ALONG = 1.5e-4 + 0.2 * 0.05**2, 1.6e-4  # about the tip
CRITICAL = 2.0 * np.sqrt(WEIGHT_LEVER * ACROSS) / ALONG


def roots(spin: float) -> np.ndarray:
    """The four roots of the tilt; spin and its angle have exact zeros."""
    values = eom.linearise(vehicle("spinning_top", spin=spin)).modes().eigenvalues
    tilt = values[np.abs(values) > 0.0]
    assert len(tilt) == len(values) - 2
    return np.asarray(tilt)


@pytest.mark.parametrize("ratio", [1.01, 1.5, 5.0])
def test_a_fast_top_sleeps_with_its_precession_and_nutation(ratio: float) -> None:
    spin = ratio * CRITICAL
    # I1 q^2 - I3 spin q + m g l = 0 for a circular motion of the axis at rate q
    momentum = ALONG * spin
    discriminant = np.sqrt(momentum**2 - 4.0 * ACROSS * WEIGHT_LEVER)
    nutation = (momentum + discriminant) / (2.0 * ACROSS)
    precession = WEIGHT_LEVER / (ACROSS * nutation)
    own = roots(spin)
    np.testing.assert_allclose(np.sort(own.imag), [-nutation, -precession, precession, nutation], rtol=1e-9)
    assert np.max(np.abs(own.real)) < 1e-9 * nutation


@pytest.mark.parametrize("ratio", [0.0, 0.5, 0.99])
def test_a_slow_top_falls(ratio: float) -> None:
    spin = ratio * CRITICAL
    momentum = ALONG * spin
    growth = np.sqrt(4.0 * ACROSS * WEIGHT_LEVER - momentum**2) / (2.0 * ACROSS)
    own = roots(spin)
    # at rest both tilts have the same real roots; a double root of a symmetric matrix stays exact
    np.testing.assert_allclose(np.sort(own.real), [-growth, -growth, growth, growth], rtol=1e-9)
    np.testing.assert_allclose(np.abs(own.imag), momentum / (2.0 * ACROSS), rtol=1e-9, atol=1e-9 * growth)


@pytest.mark.parametrize("ratio", [0.9999999, 1.0000001])
def test_the_top_sleeps_above_the_spin_of_the_textbooks(ratio: float) -> None:
    falls = np.max(roots(ratio * CRITICAL).real) > 1e-3
    assert falls == (ratio < 1.0)


def test_a_moment_tilts_the_gyroscope_across() -> None:
    model = eom.linearise(vehicle("spinning_top", spin=150.0))
    for frequency in (0.2, 2.0, 20.0):
        s = 2j * np.pi * frequency
        direct, gyroscopic = ACROSS * s**2 - WEIGHT_LEVER, ALONG * 150.0 * s
        # Euler: momentum I3 spin along z turns to the left of the roll moment, to the right of the pitch moment
        expected = np.linalg.inv([[direct, gyroscopic], [-gyroscopic, direct]])
        np.testing.assert_allclose(model.frequency_response(np.array([frequency]))[0], expected, rtol=1e-9)
