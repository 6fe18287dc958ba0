"""The inverted pendulum of the Control Tutorials for MATLAB and Simulink: published poles and transfer functions."""

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import vehicle

CART, ROD, FRICTION, INERTIA, LENGTH, G = 0.5, 0.2, 0.1, 0.006, 0.3, 9.8


def test_the_poles_are_the_published_ones() -> None:
    model = eom.linearise(vehicle("pendulum_cart"))
    own = np.sort(np.linalg.eigvals(model.A).real)
    # four printed decimals
    np.testing.assert_allclose(own, [-5.6041, -0.1428, 0.0, 5.5651], atol=0.5e-4)


@pytest.mark.parametrize("friction", [0.0, FRICTION, 2.0])
def test_push_to_position_and_angle_are_newtons(friction: float) -> None:
    model = eom.linearise(vehicle("pendulum_cart", b=friction))
    frequencies = np.array([0.05, 0.5, 3.0])
    own = model.frequency_response(frequencies)
    for k, frequency in enumerate(frequencies):
        s = 2j * np.pi * frequency
        # (M + m) x" + b x' + m l angle" = F;  m l x" + (I + m l^2) angle" - m g l angle = 0, falling forward
        equations = [
            [(CART + ROD) * s**2 + friction * s, ROD * LENGTH * s**2],
            [ROD * LENGTH * s**2, (INERTIA + ROD * LENGTH**2) * s**2 - ROD * G * LENGTH],
        ]
        expected = np.linalg.solve(np.array(equations), [1.0, 0.0])
        # one small linear solve
        np.testing.assert_allclose(own[k, :, 0], expected, rtol=1e-11)


def test_without_friction_position_and_speed_of_the_cart_are_a_double_zero() -> None:
    roots = np.linalg.eigvals(eom.linearise(vehicle("pendulum_cart", b=0.0)).A)
    mass = (CART + ROD) * (INERTIA + ROD * LENGTH**2) - (ROD * LENGTH) ** 2
    fall = np.sqrt((CART + ROD) * ROD * G * LENGTH / mass)
    np.testing.assert_allclose(np.sort(roots.real), [-fall, 0.0, 0.0, fall], rtol=1e-12, atol=1e-12)
