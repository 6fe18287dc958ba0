"""The symmetric four-bar linkage against its energy, from the exact finite motion of the loop."""

import math

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import vehicle

G = 9.81
W, B, D, LOW = 0.5, 0.3, 0.6, 0.1
BAR, LINK, BAR_INERTIA = 4.0, 1.0, 0.16


def bar_midpoint(tilt: float) -> tuple[float, float]:
    """Place (x, z) of the middle between the lower pins at a finite tilt, from the middle of the upper ones.

    Both links keep their length: the difference of the two conditions gives x, their sum then z.
    """
    e = W - B * math.cos(tilt)
    rise = B * math.sin(tilt)
    length_2 = (W - B) ** 2 + D**2
    z = -math.sqrt((length_2 - e**2 - rise**2) / (1.0 + (rise / e) ** 2))
    return z * rise / e, z


def potential(tilt: float) -> float:
    """Weight of bar and links; the links' centres rise half as much as their lower pins, together as the midpoint."""
    _, z = bar_midpoint(tilt)
    return BAR * G * (z - LOW * math.cos(tilt)) + LINK * G * z


def energies() -> tuple[float, float, float]:
    """Mass, stiffness of weight, and sway per tilt, of the tilt as the one coordinate."""
    sway = LOW - D * B / (W - B)
    link = LINK * ((W - B) ** 2 + D**2) / 3.0
    mass = BAR * sway**2 + BAR_INERTIA + 2.0 * link * (B / (W - B)) ** 2
    stiffness = (BAR + LINK) * G * (B * W + (D * B / (W - B)) ** 2) / D + BAR * G * LOW
    return mass, stiffness, sway


def test_the_closed_forms_are_those_of_the_finite_motion() -> None:
    step = 1e-4
    _, stiffness, sway = energies()
    curvature = (potential(step) - 2.0 * potential(0.0) + potential(-step)) / step**2
    # differences of 1e-4: truncation 1e-8, rounding 1e-16 * 100 J / 1e-8
    assert curvature == pytest.approx(stiffness, rel=1e-5)
    low = [bar_midpoint(tilt)[0] + LOW * math.sin(tilt) for tilt in (-step, step)]
    assert (low[1] - low[0]) / (2.0 * step) == pytest.approx(sway, rel=1e-6)


@pytest.mark.parametrize(("k", "c"), [(0.0, 0.0), (200.0, 0.0), (200.0, 3.0), (2000.0, 50.0)])
def test_the_roots_are_those_of_the_energy(k: float, c: float) -> None:
    mass, stiffness, sway = energies()
    model = eom.linearise(vehicle("four_bar", k=k, c=c))
    expected = np.roots([mass, c * sway**2, stiffness + k * sway**2])
    # one small linear solve
    np.testing.assert_allclose(np.sort_complex(np.linalg.eigvals(model.A)), np.sort_complex(expected), rtol=1e-11)


def test_the_bar_follows_a_push_as_the_loop_says() -> None:
    mass, stiffness, sway = energies()
    model = eom.linearise(vehicle("four_bar"))
    frequencies = np.array([0.2, 1.2, 5.0])
    own = model.frequency_response(frequencies)[:, :, 0]
    s = 2j * np.pi * frequencies
    # the tilt is positive nose down, the reverse of a rotation from x to z
    tilt = -sway / (mass * s**2 + 3.0 * sway**2 * s + stiffness + 200.0 * sway**2)
    for name, ratio in (("tilt", 1.0), ("sway", -sway), ("front_angle", -B / (W - B))):
        np.testing.assert_allclose(own[:, model.outputs.index(name)], ratio * tilt, rtol=1e-11)


def test_a_fourth_hinge_is_redundant_and_changes_nothing() -> None:
    from eom.report.summary import summary
    from tests.vehicles.shipped import text

    pin = "at: [-b, 0, h - d], forces: 2, axis"
    file = text("four_bar")
    assert pin in file
    assembly = eom.assemble(eom.loads(file.replace(pin, pin.replace("forces: 2", "forces: 3, moments: 2"))))
    assert assembly.J.shape[0] - np.linalg.matrix_rank(assembly.J) == 3
    assert "3 redundant" in summary(assembly)
    # the same motion, from other joint rows
    roots = [np.linalg.eigvals(eom.linearise(item).A) for item in (assembly, vehicle("four_bar"))]
    np.testing.assert_allclose(np.sort_complex(roots[0]), np.sort_complex(roots[1]), rtol=1e-11)
